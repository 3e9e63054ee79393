// The getters of vtkShadowVolumePass that tell what the last rendering did.
#include "ShadowPassInternals.h"
#include "vtkShadowVolumePass.h"

#include <iterator>

//------------------------------------------------------------------------------
int vtkShadowVolumePass::GetStatus() const
{
  return this->Internals->Status;
}

std::string vtkShadowVolumePass::GetStatusMessage() const
{
  const std::string& message = this->Internals->Message;
  const std::string& remark = this->Internals->Remark;
  return message + (message.empty() || remark.empty() ? "" : "\n") + remark;
}

//------------------------------------------------------------------------------
int vtkShadowVolumePass::GetUsedSilhouetteMethod() const
{
  return this->Internals->UsedMethod >= 0 ? this->Internals->UsedMethod : this->SilhouetteMethod;
}

//------------------------------------------------------------------------------
int vtkShadowVolumePass::GetNumberOfHiddenBacks() const
{
  return static_cast<int>(this->Internals->HiddenBacks.size());
}

//------------------------------------------------------------------------------
vtkIdType vtkShadowVolumePass::GetPrePassTriangles() const
{
  return static_cast<vtkIdType>(this->Internals->GetStatistics().prePassTriangles);
}

vtkIdType vtkShadowVolumePass::GetCountedPixels() const
{
  return static_cast<vtkIdType>(this->Internals->GetStatistics().countedPixels);
}

vtkIdType vtkShadowVolumePass::GetAmbientTriangles() const
{
  return this->Internals->Current != nullptr
             ? static_cast<vtkIdType>(this->Internals->Current->Builder.getTriangles())
             : 0;
}

vtkIdType vtkShadowVolumePass::GetSideTriangles() const
{
  return static_cast<vtkIdType>(this->Internals->GetStatistics().sideTriangles);
}

vtkIdType vtkShadowVolumePass::GetCapTriangles() const
{
  return static_cast<vtkIdType>(this->Internals->GetStatistics().capTriangles);
}

vtkIdType vtkShadowVolumePass::GetLightingTriangles() const
{
  return this->Internals->LightingPasses * this->GetAmbientTriangles();
}

vtkIdType vtkShadowVolumePass::GetTotalTriangles() const
{
  return this->GetAmbientTriangles() + this->GetSideTriangles() + this->GetCapTriangles() +
         this->GetLightingTriangles();
}

vtkIdType vtkShadowVolumePass::GetSilhouetteEdges() const
{
  return static_cast<vtkIdType>(this->Internals->GetStatistics().silhouetteEdges);
}

//------------------------------------------------------------------------------
int vtkShadowVolumePass::GetNumberOfShadowLights() const
{
  return this->Internals->ShadowLights;
}

int vtkShadowVolumePass::GetNumberOfKeptLights() const
{
  return this->Internals->GetStatistics().keptLights;
}

int vtkShadowVolumePass::GetNumberOfBatchedMeshes() const
{
  return static_cast<int>(this->Internals->GetStatistics().batchedSurfaces);
}

int vtkShadowVolumePass::GetNumberOfCasters() const
{
  return this->Internals->GetStatistics().casters;
}

int vtkShadowVolumePass::GetNumberOfZFailCasters() const
{
  return this->Internals->GetStatistics().zFailCasters;
}

int vtkShadowVolumePass::GetNumberOfRebuiltVolumes() const
{
  return this->Internals->GetStatistics().rebuiltVolumes;
}

int vtkShadowVolumePass::GetNumberOfCastersFoundBy(int silhouetteMethod) const
{
  const auto& used = this->Internals->GetStatistics().usedMethods;
  const auto entry = used.find(static_cast<shadow::SilhouetteMethod>(silhouetteMethod));
  return entry == used.end() ? 0 : entry->second;
}

int vtkShadowVolumePass::GetNumberOfSkippedCasters() const
{
  return static_cast<int>(this->Internals->Skipped.size());
}

std::string vtkShadowVolumePass::GetSkippedCaster(int index) const
{
  if (index < 0 || index >= this->GetNumberOfSkippedCasters())
  {
    return "";
  }
  const auto skipped = std::next(this->Internals->Skipped.begin(), index);
  return skipped->name + ": " + skipped->reason;
}

//------------------------------------------------------------------------------
double vtkShadowVolumePass::GetSceneMilliseconds() const
{
  return this->Internals->SceneMilliseconds;
}

double vtkShadowVolumePass::GetCheckMilliseconds() const
{
  return this->Internals->Current != nullptr ? this->Internals->Current->CheckMilliseconds : 0.0;
}

double vtkShadowVolumePass::GetSilhouetteMilliseconds() const
{
  return this->Internals->GetStatistics().silhouetteMilliseconds;
}

double vtkShadowVolumePass::GetReadBackMilliseconds() const
{
  return this->Internals->GetStatistics().readBackMilliseconds;
}

double vtkShadowVolumePass::GetPrePassMilliseconds() const
{
  return this->Internals->GetStatistics().prePassMilliseconds;
}

double vtkShadowVolumePass::GetStencilMilliseconds() const
{
  return this->Internals->GetStatistics().stencilMilliseconds;
}

double vtkShadowVolumePass::GetLightingMilliseconds() const
{
  return this->Internals->LightingMilliseconds;
}

//------------------------------------------------------------------------------
vtkIdType vtkShadowVolumePass::GetMemorySize() const
{
  return static_cast<vtkIdType>(this->Internals->Renderers.getMemorySize());
}
