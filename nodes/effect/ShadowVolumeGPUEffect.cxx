#include "ShadowVolumeGPUEffect.h"

#include <stdexcept>

#include <vtkOpenGLRenderWindow.h>

#include "ComputeSilhouette.h"
#include "EdgeQuadSilhouette.h"
#include "ExactVolumeVisitor.h"
#include "FacingTexture.h"
#include "GPUSilhouetteVisitor.h"
#include "GeometryShaderSilhouette.h"
#include "OpenGL.h"
#include "ReadFacingVisitor.h"
#include "SVStateVisitor.h"
#include "VertexTexture.h"

namespace shadow
{

namespace
{

std::unique_ptr<GPUSilhouette> makeGPUSilhouette(SilhouetteMethod method)
{
  switch (method)
  {
  case SilhouetteMethod::FacingTexture:
  case SilhouetteMethod::FacingTextureResident:
    return std::make_unique<FacingTexture>();
  case SilhouetteMethod::VertexTexture:
    return std::make_unique<VertexTexture>();
  case SilhouetteMethod::GeometryShader:
    return std::make_unique<GeometryShaderSilhouette>();
  case SilhouetteMethod::Compute:
    return std::make_unique<ComputeSilhouette>();
  default:
    return std::make_unique<EdgeQuadSilhouette>();
  }
}

} // namespace

ShadowVolumeGPUEffect::ShadowVolumeGPUEffect(SilhouetteMethod gpuMethod)
    : name(gpuMethod), method(makeGPUSilhouette(gpuMethod))
{
  if (gpuMethod == SilhouetteMethod::FacingTexture)
  {
    this->readBack = static_cast<FacingTexture*>(this->method.get());
  }
}

CountBuffer ShadowVolumeGPUEffect::chooseCountBuffer(CountBuffer wanted, int samples) const
{
  return this->readBack != nullptr ? this->ShadowVolumeEffect::chooseCountBuffer(wanted, samples)
                                   : CountBuffer::Color;
}

bool ShadowVolumeGPUEffect::findFacing(const Frame& frame, std::string& error)
{
  GPUSilhouette::Frame gpuFrame;
  gpuFrame.window = frame.window;
  gpuFrame.lights = &frame.lights;
  gpuFrame.view = &frame.view;
  gpuFrame.drawables = &this->getDrawables();
  gpuFrame.clipFromWC = this->getClipFromWC(frame.view);
  gpuFrame.reversedDepth = this->getDepthRange().reversed;
  gpuFrame.software = this->getCapabilities().software;
  if (this->method->needsCollection())
  {
    try
    {
      const VETCollector::Change change = this->collector.collect(*this);
      gpuFrame.unchanged = change == VETCollector::Change::Nothing && frame.lights == this->lightsBefore;
    }
    catch (const std::length_error& tooLarge)
    {
      error = tooLarge.what();
      return false;
    }
    gpuFrame.collection = &this->collector.getCollection();
    this->lightsBefore = frame.lights;
  }
  if (!this->method->begin(gpuFrame, error))
  {
    return false;
  }
  GPUSilhouetteVisitor prepare(GPUSilhouetteVisitor::Stage::Prepare, *this->method, frame.lights);
  this->accept(prepare);
  error = prepare.getError();
  if (error.empty())
  {
    this->method->finishPreparing(error);
  }
  this->method->unbind();
  this->method->sweep();
  if (frame.settings.waitAfterStages)
  {
    glFinish();
  }
  this->reading =
      error.empty() && this->readBack != nullptr && (this->readBack->isNew() || prepare.hasFacedAnew());
  if (this->reading)
  {
    this->readBack->startReadBack();
  }
  return error.empty();
}

bool ShadowVolumeGPUEffect::drawSurfaces(const Frame& frame, std::string& error)
{
  GPUSilhouetteVisitor draw(GPUSilhouetteVisitor::Stage::Draw, *this->method, frame.lights);
  this->accept(draw);
  this->method->unbind();
  this->changeStatistics().prePassTriangles = draw.getCounts().geometry;
  error = draw.getError();
  return error.empty();
}

bool ShadowVolumeGPUEffect::findSilhouettes(const Frame& frame, std::string& error)
{
  Statistics& filled = this->changeStatistics();
  if (this->reading)
  {
    if (!this->readBack->fetch())
    {
      error = "the GL lost the facing texture while it was read back";
      return false;
    }
    filled.readBackMilliseconds = this->readBack->getReadBackTimes().getSum();
    ReadFacingVisitor read(*this->readBack, this->collector.getCollection().frame, frame.lights);
    this->accept(read);
  }
  if (this->readBack != nullptr)
  {
    this->extrude(frame, this->edgeClassifier);
  }
  else
  {
    const SceneFrame* space =
        this->method->needsCollection() ? &this->collector.getCollection().frame : nullptr;
    ExactVolumeVisitor exact(frame.lights, space, this->edgeClassifier, mostCountableIn(CountBuffer::Color));
    this->accept(exact);
    this->hasExactVolumes = exact.hasVolumes();
  }
  filled.usedMethods = {{this->name, filled.casters}};
  return true;
}

bool ShadowVolumeGPUEffect::drawVolumes(const Frame& frame, const Light& light, std::string& error)
{
  if (this->readBack != nullptr)
  {
    return this->ShadowVolumeEffect::drawVolumes(frame, light, error);
  }
  this->getTarget().beginCount(frame.window->GetState(), this->getCounted());
  bool hasCounted = false;
  for (const StencilCount count : {StencilCount::ZPass, StencilCount::ZFail})
  {
    SVStateVisitor volumeMode(RenderMode{RenderMode::What::Volume, light.index, count});
    this->accept(volumeMode);
    GPUSilhouetteVisitor draw(GPUSilhouetteVisitor::Stage::Draw, *this->method, frame.lights);
    this->accept(draw);
    this->method->unbind();
    this->changeStatistics().sideTriangles += draw.getCounts().sides;
    this->changeStatistics().capTriangles += draw.getCounts().caps;
    hasCounted = hasCounted || draw.hasDrawn();
    error = draw.getError();
    if (!error.empty() || !this->drawExactVolumes(frame, count, error))
    {
      return false;
    }
  }
  hasCounted = hasCounted || this->hasExactVolumes;
  ShadowPrograms programs(frame.window);
  if (hasCounted && !this->getTarget().foldCount(frame.window->GetState(), programs, light.index,
                                              this->getDepthRange().reversed))
  {
    error = "the shader that folds counts into the mask does not compile on this GL";
    return false;
  }
  return true;
}

bool ShadowVolumeGPUEffect::drawExactVolumes(const Frame& frame, StencilCount count, std::string& error)
{
  if (!this->hasExactVolumes)
  {
    return true;
  }
  vtkShaderProgram* program =
      ShadowPrograms(frame.window).use(this->method->getVolumeStage(), startsAtNear(frame.view, count));
  if (program == nullptr)
  {
    error = unusableShader;
    return false;
  }
  DrawVisitor::Pass pass = this->makeDrawPass(program, frame);
  pass.makeRoom = [](std::size_t /*bound*/) {}; // colour counts further than there are triangles
  DrawVisitor draw(pass);
  this->accept(draw);
  this->changeStatistics().sideTriangles += draw.getCounts().sides;
  this->changeStatistics().capTriangles += draw.getCounts().caps;
  return true;
}

void ShadowVolumeGPUEffect::release(bool contextLost)
{
  this->lightsBefore.clear();
  this->method->release(contextLost);
  this->ShadowVolumeEffect::release(contextLost);
}

std::size_t ShadowVolumeGPUEffect::getGraphicsMemorySize() const
{
  return this->method->getMemorySize() + this->ShadowVolumeEffect::getGraphicsMemorySize();
}

} // namespace shadow
