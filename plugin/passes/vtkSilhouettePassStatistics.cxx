// The getters of vtkSilhouettePass that tell what the last rendering did.
#include "SilhouettePassInternals.h"
#include "vtkSilhouettePass.h"

#include <iterator>

//------------------------------------------------------------------------------
int vtkSilhouettePass::GetStatus() const
{
  return this->Internals->Status;
}

std::string vtkSilhouettePass::GetStatusMessage() const
{
  return this->Internals->Message;
}

vtkIdType vtkSilhouettePass::GetDepthTriangles() const
{
  return static_cast<vtkIdType>(this->Internals->GetStatistics().depthTriangles);
}

vtkIdType vtkSilhouettePass::GetLineTriangles() const
{
  return static_cast<vtkIdType>(this->Internals->GetStatistics().lineTriangles);
}

vtkIdType vtkSilhouettePass::GetLineEdges() const
{
  return static_cast<vtkIdType>(this->Internals->GetStatistics().lineEdges);
}

int vtkSilhouettePass::GetNumberOfSkippedProps() const
{
  return static_cast<int>(this->Internals->Skipped.size());
}

std::string vtkSilhouettePass::GetSkippedProp(int index) const
{
  if (index < 0 || index >= this->GetNumberOfSkippedProps())
  {
    return "";
  }
  const auto skipped = std::next(this->Internals->Skipped.begin(), index);
  return skipped->name + ": " + skipped->reason;
}

double vtkSilhouettePass::GetSceneMilliseconds() const
{
  return this->Internals->SceneMilliseconds;
}

double vtkSilhouettePass::GetEdgeMilliseconds() const
{
  return this->Internals->GetStatistics().edgeMilliseconds;
}

double vtkSilhouettePass::GetDepthMilliseconds() const
{
  return this->Internals->GetStatistics().depthMilliseconds;
}

double vtkSilhouettePass::GetLineMilliseconds() const
{
  return this->Internals->GetStatistics().lineMilliseconds;
}

double vtkSilhouettePass::GetBlendMilliseconds() const
{
  return this->Internals->GetStatistics().blendMilliseconds;
}

vtkIdType vtkSilhouettePass::GetMemorySize() const
{
  return static_cast<vtkIdType>(this->Internals->Renderers.getMemorySize());
}
