#ifndef shadow_examples_ReaderGuard_h
#define shadow_examples_ReaderGuard_h

#include <array>
#include <csignal>
#include <string>

namespace shadow::examples
{

/// Keeps a damaged file from ending the program without a word.
///
/// Readers of VTK 9.1 crash on some damaged files: an OBJ with a wrong normal index reads beyond
/// its array, a glTF node that is its own child never returns. While a
/// guard lives, a crash prints `lastWords` to stderr as one line and ends the process with status 1. What a
/// reader itself prints to stderr is dropped.
///
/// @pre one guard at a time, and no other thread prints
class ReaderGuard
{
public:
  explicit ReaderGuard(const std::string& lastWords);
  ~ReaderGuard();
  ReaderGuard(const ReaderGuard&) = delete;
  ReaderGuard& operator=(const ReaderGuard&) = delete;

private:
  static constexpr std::array<int, 5> SIGNALS = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};

  std::array<struct sigaction, SIGNALS.size()> previousActions;
  stack_t previousStack;
  std::string stack; ///< for the handler: an endless recursion has used up the ordinary one
};

} // namespace shadow::examples

#endif
