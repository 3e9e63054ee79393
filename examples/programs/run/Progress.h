#ifndef shadow_examples_Progress_h
#define shadow_examples_Progress_h

#include <string>

namespace shadow::examples
{

/// One line on stderr that says what goes on and is overwritten by the next; silent when stderr is not a
/// terminal.
class Progress
{
public:
  explicit Progress(std::string program);
  ~Progress(); ///< leaves an empty line behind
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const std::string& text) const;
  void clear() const;

private:
  std::string program;
  bool terminal;
};

} // namespace shadow::examples

#endif
