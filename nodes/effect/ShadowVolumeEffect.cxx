#include "ShadowVolumeEffect.h"

#include <algorithm>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "FinishStage.h"
#include "GLStateScope.h"
#include "OpenGL.h"
#include "SEDVisitor.h"
#include "SVStateVisitor.h"
#include "SceneBoundsVisitor.h"
#include "ShadowPrograms.h"
#include "SmpParallelFor.h"
#include "Stopwatch.h"

namespace shadow
{

const Capabilities& ShadowVolumeEffect::getCapabilities()
{
  if (!this->capabilitiesKnown)
  {
    this->capabilities = queryCapabilities();
    this->capabilitiesKnown = true;
  }
  return this->capabilities;
}

bool ShadowVolumeEffect::renderMask(vtkOpenGLRenderWindow* window, const View& view,
                                    const std::vector<Light>& lights, const Settings& settings,
                                    std::string& error)
{
  const Frame frame{window, view, lights, settings};
  const bool usable = this->getCapabilities().usable;
  const int samples = std::min(settings.samples, this->capabilities.maximumSamples);
  this->countBuffer = this->chooseCountBuffer(settings.countBuffer, samples);
  glGetIntegerv(GL_SAMPLES, &this->viewSamples);
  if (usable && this->keepMask(frame, samples))
  {
    return true;
  }
  this->statistics = {};
  this->hiddenBacks.begin();
  if (!usable)
  {
    error = this->capabilities.missing;
    return false;
  }
  const GLStateScope scope(window->GetState(), this->capabilities.clipControl);
  bool succeeds =
      this->target.allocate(window->GetState(), view.width, view.height, samples, this->countBuffer, error);
  if (succeeds && lights.empty())
  {
    this->target.begin(window->GetState(), this->capabilities.clipControl);
  }
  succeeds = succeeds && (lights.empty() || this->drawStages(frame, error));
  if (!succeeds)
  {
    this->madeFrom.reset();
  }
  this->drawables.sweep();
  this->dropUnusedBatches(lights);
  return succeeds;
}

bool ShadowVolumeEffect::drawStages(const Frame& frame, std::string& error)
{
  Stopwatch stage;
  this->putMaskAside(frame.window->GetState());
  this->cull(frame);
  bool succeeds = this->findFacing(frame, error);
  this->statistics.silhouetteMilliseconds = stage.getMilliseconds();

  stage = {};
  succeeds = succeeds && this->drawPrePass(frame, error);
  finishStage(frame.settings.waitAfterStages);
  this->statistics.prePassMilliseconds = stage.getMilliseconds();

  stage = {};
  // The GL starts on the pre-pass while silhouettes are found.
  glFlush();
  succeeds = succeeds && this->findSilhouettes(frame, error);
  this->statistics.silhouetteMilliseconds += stage.getMilliseconds();

  stage = {};
  succeeds = succeeds && this->countVolumes(frame, error);
  this->hiddenBacks.fetch();
  finishStage(frame.settings.waitAfterStages);
  this->statistics.stencilMilliseconds = stage.getMilliseconds();
  return succeeds;
}

void ShadowVolumeEffect::chooseFinder(const Settings& settings)
{
  if (this->finder == nullptr || this->finderMethod != settings.silhouetteMethod ||
      this->finderTolerance != settings.coplanarTolerance)
  {
    this->finder =
        makeSilhouetteFinder(settings.silhouetteMethod, settings.coplanarTolerance, makeSmpParallelFor());
    this->finderMethod = settings.silhouetteMethod;
    this->finderTolerance = settings.coplanarTolerance;
  }
}

void ShadowVolumeEffect::cull(const Frame& frame)
{
  SceneBoundsVisitor boundsVisitor(frame.view);
  this->accept(boundsVisitor);
  const SceneBounds& bounds = boundsVisitor.getBounds();
  this->chooseDepthRange(frame.view, bounds);
  CasterCuller culler(frame.view, frame.lights, bounds, frame.settings.stencilMethod);
  this->accept(culler);
  this->statistics.casters = culler.getCasters();
  this->statistics.zFailCasters = culler.getZFailCasters();
  this->statistics.skipped = culler.getSkipped();
  this->counted = (frame.settings.savings & Scissor) != 0 ? culler.getReceivers() : wholeView(frame.view);
  const glm::ivec2 size = this->counted.upper - this->counted.lower;
  this->statistics.countedPixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

bool ShadowVolumeEffect::findFacing(const Frame& frame, std::string& /*error*/)
{
  this->chooseFinder(frame.settings);
  this->markBacks(frame);
  SEDVisitor facer(SEDVisitor::Stage::Face, frame.lights, *this->finder);
  this->accept(facer);
  return true;
}

bool ShadowVolumeEffect::findSilhouettes(const Frame& frame, std::string& /*error*/)
{
  this->extrude(frame, *this->finder);
  return true;
}

void ShadowVolumeEffect::extrude(const Frame& frame, const SilhouetteFinder& silhouetteFinder)
{
  SEDVisitor extruder(SEDVisitor::Stage::Extrude, frame.lights, silhouetteFinder,
                      mostCountableIn(this->countBuffer));
  this->accept(extruder);
  this->statistics.rebuiltVolumes = extruder.getRebuiltVolumes();
  this->statistics.usedMethods = extruder.getUsedMethods();
}

// Blending is the faster on a software GL, where it needs no stencil beside the depth and draws what counts
// twice only once; a GPU is made for stencils.
CountBuffer ShadowVolumeEffect::chooseCountBuffer(CountBuffer wanted, int samples) const
{
  if (samples > 1 && !this->capabilities.sampleShading)
  {
    return CountBuffer::Stencil;
  }
  if (wanted == CountBuffer::Auto)
  {
    return this->capabilities.software ? CountBuffer::Color : CountBuffer::Stencil;
  }
  return wanted;
}

void ShadowVolumeEffect::chooseDepthRange(const View& view, const SceneBounds& bounds)
{
  this->depthRange = {};
  this->depthRange.reversed = this->capabilities.clipControl;
  if (view.parallel)
  {
    // A margin, so that no geometry lies on either end.
    const double margin = 1e-3 * std::max(bounds.farthest - bounds.nearest, 1e-300);
    this->depthRange.nearest = bounds.nearest - margin;
    this->depthRange.farthest = bounds.farthest + margin;
  }
}

DrawVisitor::Pass ShadowVolumeEffect::makeDrawPass(vtkShaderProgram* program, const Frame& frame)
{
  DrawVisitor::Pass pass;
  pass.state = frame.window->GetState();
  pass.program = program;
  pass.drawables = &this->drawables;
  pass.view = &frame.view;
  pass.clipFromWC = this->getClipFromWC(frame.view);
  pass.reversedDepth = this->depthRange.reversed;
  pass.countBuffer = this->countBuffer;
  return pass;
}

bool ShadowVolumeEffect::drawPrePass(const Frame& frame, std::string& error)
{
  vtkOpenGLState* state = frame.window->GetState();
  if (this->depthRange.reversed)
  {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  }
  this->target.begin(state, this->depthRange.reversed);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(this->depthRange.reversed ? GL_GREATER : GL_LESS);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
  if (frame.view.parallel)
  {
    glEnable(GL_DEPTH_CLAMP);
  }
  else
  {
    glDisable(GL_DEPTH_CLAMP);
  }
  SVStateVisitor geometryMode(RenderMode{RenderMode::What::Geometry});
  this->accept(geometryMode);
  if (!this->drawSurfaces(frame, error))
  {
    return false;
  }
  ShadowPrograms programs(frame.window);
  const bool usable =
      this->kept.isEmpty() || this->target.takeOver(state, programs, this->kept, this->depthRange.reversed);
  error = usable ? error : unusableShader;
  return usable;
}

bool ShadowVolumeEffect::drawSurfaces(const Frame& frame, std::string& error)
{
  vtkShaderProgram* program = ShadowPrograms(frame.window).use(ShadowPrograms::PrePass, frame.view.parallel);
  if (program == nullptr)
  {
    error = unusableShader;
    return false;
  }
  setDepthBias(program, this->depthRange.reversed, false);
  this->gatherBatch(frame);
  DrawVisitor draw(this->makeDrawPass(program, frame));
  if (this->batchCollector.hasSurfacesAlone())
  {
    this->accept(draw);
  }
  this->statistics.prePassTriangles = draw.getCounts().geometry;
  if (!this->drawBatchedSurfaces(frame))
  {
    error = unusableShader;
    return false;
  }
  ShadowPrograms programs(frame.window);
  this->hiddenBacks.ask(frame.window->GetState(), programs, this->target);
  return true;
}

void ShadowVolumeEffect::markBacks(const Frame& frame)
{
  const bool worthwhile = frame.settings.findHiddenBacks && this->capabilities.software &&
                          this->target.getSamples() == 1 && this->viewSamples <= 1 &&
                          this->countBuffer == CountBuffer::Color;
  std::uint32_t taken = worthwhile ? 0 : ~0u;
  for (const Light& light : frame.lights)
  {
    taken |= 1u << light.index;
  }
  this->hiddenBacks.choose(*this, frame.view, this->getClipFromWC(frame.view), taken);
}

void ShadowVolumeEffect::release(bool contextLost)
{
  this->target.release(contextLost);
  this->drawables.release(contextLost);
  this->releaseBatches(contextLost);
  this->hiddenBacks.release(contextLost);
  this->madeFrom.reset();
  this->capabilitiesKnown = false;
}

std::size_t ShadowVolumeEffect::getGraphicsMemorySize() const
{
  return this->target.getMemorySize() + this->drawables.getMemorySize() + this->getBatchMemorySize();
}

} // namespace shadow
