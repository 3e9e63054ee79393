#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace shadow::fuzz
{

/// Processes that work beside each other, and the lines of text that they hand back. A process that crashes
/// takes no other with it.
class JobLines
{
public:
  using Write = std::function<void(const std::string&)>;

  /// @param work  called in each process with its number, from 0 on, and with what hands back a line; the
  ///              line has no line break
  /// @pre   no GL context has been made
  /// @throws std::runtime_error  when no process can be started
  JobLines(int jobs, const std::function<void(int, const Write&)>& work);
  ~JobLines();
  JobLines(const JobLines&) = delete;
  JobLines& operator=(const JobLines&) = delete;

  /// The next line of any process; nothing when all have ended.
  std::optional<std::string> read();

  struct Failure
  {
    int job = 0;
    std::string reason;
  };

  /// Processes that did not end well. @pre read() has given nothing
  const std::vector<Failure>& getFailures() const { return this->failures; }

private:
  struct Job
  {
    pid_t process = 0;
    int pipe = -1;
    std::string text;
  };

  bool takeLine(std::string& line);
  void readSome(Job& job);
  void close(Job& job);

  std::vector<Job> jobs;
  std::vector<Failure> failures;
};

} // namespace shadow::fuzz
