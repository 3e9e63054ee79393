#ifndef shadow_examples_Program_h
#define shadow_examples_Program_h

#include <functional>
#include <string>

namespace shadow::examples
{

/// What main() returns: 0, or 2 for a command line that cannot be understood and 1 for any other exception,
/// which is said on stderr in one line.
///
/// @param program  its name, for the message
int runProgram(const std::string& program, const std::function<void()>& work);

} // namespace shadow::examples

#endif
