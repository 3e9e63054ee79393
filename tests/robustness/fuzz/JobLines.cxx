#include "JobLines.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace shadow::fuzz
{

namespace
{

void writeAll(int pipe, const std::string& text)
{
  for (std::size_t done = 0; done < text.size();)
  {
    const ssize_t count = write(pipe, text.data() + done, text.size() - done);
    if (count <= 0)
    {
      throw std::runtime_error("the process that reports is gone");
    }
    done += static_cast<std::size_t>(count);
  }
}

[[noreturn]] void runJob(int number, int pipe, const std::function<void(int, const JobLines::Write&)>& work)
{
  int status = EXIT_SUCCESS;
  try
  {
    work(number, [pipe](const std::string& line) { writeAll(pipe, line + "\n"); });
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "fuzz_shadows: %s\n", error.what());
    status = EXIT_FAILURE;
  }
  // Nothing that was there before the fork is to be torn down twice.
  std::_Exit(status);
}

} // namespace

JobLines::JobLines(int count, const std::function<void(int, const Write&)>& work)
{
  for (int number = 0; number < count; ++number)
  {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0)
    {
      throw std::runtime_error("cannot make a pipe");
    }
    std::fflush(nullptr);
    const pid_t process = fork();
    if (process < 0)
    {
      throw std::runtime_error("cannot start a process");
    }
    if (process == 0)
    {
      ::close(ends[0]);
      runJob(number, ends[1], work);
    }
    ::close(ends[1]);
    this->jobs.push_back({process, ends[0], {}});
  }
}

JobLines::~JobLines()
{
  for (Job& job : this->jobs)
  {
    this->close(job);
  }
}

bool JobLines::takeLine(std::string& line)
{
  for (Job& job : this->jobs)
  {
    const std::size_t end = job.text.find('\n');
    if (end != std::string::npos)
    {
      line = job.text.substr(0, end);
      job.text.erase(0, end + 1);
      return true;
    }
  }
  return false;
}

std::optional<std::string> JobLines::read()
{
  std::string line;
  while (!this->takeLine(line))
  {
    std::vector<pollfd> pipes;
    for (const Job& job : this->jobs)
    {
      pipes.push_back({job.pipe, POLLIN, 0}); // a pipe of -1 is passed over
    }
    bool isOpen = false;
    for (const Job& job : this->jobs)
    {
      isOpen = isOpen || job.pipe >= 0;
    }
    if (!isOpen)
    {
      return std::nullopt;
    }
    poll(pipes.data(), pipes.size(), -1);
    for (std::size_t i = 0; i < pipes.size(); ++i)
    {
      if (pipes[i].revents != 0)
      {
        this->readSome(this->jobs[i]);
      }
    }
  }
  return line;
}

void JobLines::readSome(Job& job)
{
  std::array<char, 4096> buffer{};
  const ssize_t count = ::read(job.pipe, buffer.data(), buffer.size());
  if (count > 0)
  {
    job.text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  else
  {
    this->close(job);
  }
}

void JobLines::close(Job& job)
{
  if (job.pipe < 0)
  {
    return;
  }
  ::close(job.pipe);
  job.pipe = -1;
  int status = 0;
  waitpid(job.process, &status, 0);
  const auto number = static_cast<int>(&job - this->jobs.data());
  if (WIFSIGNALED(status))
  {
    this->failures.push_back({number, "ended by signal " + std::to_string(WTERMSIG(status))});
  }
  else if (WEXITSTATUS(status) != EXIT_SUCCESS)
  {
    this->failures.push_back({number, "failed"});
  }
}

} // namespace shadow::fuzz
