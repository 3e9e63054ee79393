#include "VtkMessages.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <cctype>
#include <cstring>

namespace shadow::examples
{
namespace
{

// Longer ones quote whole lines of a damaged file.
constexpr std::size_t LONGEST = 200;

// Drops what a user has no use for: "ERROR: In file.cxx, line 3\n" and "vtkOBJReader (0x55d0): ".
std::string plainText(const char* text)
{
  std::string message = text == nullptr ? "" : text;
  const std::size_t firstLine = message.find('\n');
  if (message.find(": In ") < firstLine && firstLine != std::string::npos)
  {
    message.erase(0, firstLine + 1);
  }
  const std::size_t address = message.find(" (0x");
  const std::size_t addressEnd = message.find("): ", address);
  if (message.rfind("vtk", 0) == 0 && addressEnd != std::string::npos)
  {
    message.erase(0, addressEnd + 3);
  }
  return message;
}

// One line of printable ASCII: a damaged file's bytes must not reach the terminal.
std::string oneLine(const std::string& text)
{
  std::string line;
  for (const char character : text)
  {
    const auto byte = static_cast<unsigned char>(character);
    if (std::isspace(byte) != 0)
    {
      line += line.empty() || line.back() == ' ' ? "" : " ";
    }
    else
    {
      line += byte < 0x20 || byte > 0x7e ? '?' : character;
    }
  }
  while (!line.empty() && line.back() == ' ')
  {
    line.pop_back();
  }
  return line.size() > LONGEST ? line.substr(0, LONGEST) + "..." : line;
}

} // namespace

class VtkMessages::Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);

  void DisplayErrorText(const char* text) override { this->add(this->errors, text); }
  void DisplayWarningText(const char* text) override { this->add(this->warnings, text); }
  void DisplayGenericWarningText(const char* text) override { this->add(this->warnings, text); }
  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}

  std::vector<std::string> errors;
  std::vector<std::string> warnings;

private:
  void add(std::vector<std::string>& list, const char* text)
  {
    const std::string line = oneLine(plainText(text));
    if (!line.empty() && std::find(list.begin(), list.end(), line) == list.end())
    {
      list.push_back(line);
    }
  }
};

vtkStandardNewMacro(VtkMessages::Collector);

VtkMessages::VtkMessages()
    : collector(vtkSmartPointer<Collector>::New()), previous(vtkOutputWindow::GetInstance()),
      previousVerbosity(vtkLogger::GetCurrentVerbosityCutoff())
{
  vtkOutputWindow::SetInstance(this->collector);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkMessages::~VtkMessages()
{
  vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(this->previousVerbosity));
  vtkOutputWindow::SetInstance(this->previous);
}

const std::vector<std::string>& VtkMessages::errors() const
{
  return this->collector->errors;
}

const std::vector<std::string>& VtkMessages::warnings() const
{
  return this->collector->warnings;
}

void VtkMessages::clear()
{
  this->collector->errors.clear();
  this->collector->warnings.clear();
}

} // namespace shadow::examples
