#ifndef shadow_examples_TemporaryModel_h
#define shadow_examples_TemporaryModel_h

#include <fstream>
#include <string>

namespace shadow::examples
{

/// A temporary copy of a model for a reader that does not take the model as it is. Removed with this object.
class TemporaryModel
{
public:
  /// @param extension  with its dot
  /// @throws UserError when no file can be written
  explicit TemporaryModel(const std::string& extension);
  ~TemporaryModel();
  TemporaryModel(const TemporaryModel&) = delete;
  TemporaryModel& operator=(const TemporaryModel&) = delete;

  /// To be written to until finish().
  std::ostream& getStream() { return this->stream; }

  /// @throws UserError when not everything could be written
  void finish();

  const std::string& getName() const { return this->name; }

private:
  std::string name;
  std::ofstream stream;
};

} // namespace shadow::examples

#endif
