#ifndef shadow_examples_VtkMessages_h
#define shadow_examples_VtkMessages_h

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkOutputWindow;

namespace shadow::examples
{

/// Catches what VTK would print, from construction to destruction, so that a program can say it in its own
/// words.
class VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// The messages since the last clear(), oldest first, each as one line without source file and object
  /// address.
  const std::vector<std::string>& errors() const;
  const std::vector<std::string>& warnings() const;

  void clear();

private:
  class Collector;
  vtkSmartPointer<Collector> collector;
  vtkSmartPointer<vtkOutputWindow> previous;
  int previousVerbosity;
};

} // namespace shadow::examples

#endif
