#ifndef shadow_examples_UserError_h
#define shadow_examples_UserError_h

#include <stdexcept>

namespace shadow::examples
{

/// Something that the user can put right. A program prints it as one line and exits non-zero.
class UserError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A command line that cannot be understood.
class UsageError : public UserError
{
public:
  using UserError::UserError;
};

} // namespace shadow::examples

#endif
