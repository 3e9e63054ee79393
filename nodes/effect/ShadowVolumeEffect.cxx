#include "ShadowVolumeEffect.h"

#include <algorithm>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

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

namespace
{

void finishStage(bool wait)
{
  if (wait)
  {
    glFinish();
  }
}

} // namespace

bool ShadowVolumeEffect::renderMask(vtkOpenGLRenderWindow* window, const View& view,
                                    const std::vector<Light>& lights, const Settings& settings,
                                    std::string& error)
{
  this->statistics = {};
  if (!this->capabilitiesKnown)
  {
    this->capabilities = queryCapabilities();
    this->capabilitiesKnown = true;
  }
  if (!this->capabilities.usable)
  {
    error = this->capabilities.missing;
    return false;
  }
  const GLStateScope scope(window->GetState(), this->capabilities.clipControl);
  const int samples = std::min(settings.samples, this->capabilities.maximumSamples);
  if (!this->target.allocate(window->GetState(), view.width, view.height, samples, error))
  {
    return false;
  }

  if (lights.empty())
  {
    this->target.begin(window->GetState(), this->capabilities.clipControl);
    this->drawables.sweep();
    return true;
  }

  Stopwatch stage;
  const std::unique_ptr<SilhouetteFinder> finder =
      makeSilhouetteFinder(settings.silhouetteMethod, makeSmpParallelFor());
  this->face(view, lights, settings, *finder);
  this->statistics.silhouetteMilliseconds = stage.getMilliseconds();

  stage = {};
  bool drawn = this->drawPrePass(window, view);
  finishStage(settings.waitAfterStages);
  this->statistics.prePassMilliseconds = stage.getMilliseconds();

  stage = {};
  // The GL starts on the pre-pass while silhouettes are found.
  glFlush();
  SEDVisitor extruder(SEDVisitor::Stage::Extrude, lights, *finder);
  this->accept(extruder);
  this->statistics.rebuiltVolumes = extruder.getRebuiltVolumes();
  this->statistics.usedMethods = extruder.getUsedMethods();
  this->statistics.silhouetteMilliseconds += stage.getMilliseconds();

  stage = {};
  for (const Light& light : lights)
  {
    drawn = drawn && this->drawVolumes(window, view, light);
  }
  finishStage(settings.waitAfterStages);
  this->statistics.stencilMilliseconds = stage.getMilliseconds();
  this->drawables.sweep();
  if (!drawn)
  {
    error = "a shader of the shadow stages does not compile on this GL";
  }
  return drawn;
}

void ShadowVolumeEffect::face(const View& view, const std::vector<Light>& lights, const Settings& settings,
                              const SilhouetteFinder& finder)
{
  SceneBoundsVisitor boundsVisitor(view);
  this->accept(boundsVisitor);
  const SceneBounds& bounds = boundsVisitor.getBounds();
  this->chooseDepthRange(view, bounds);
  CasterCuller culler(view, lights, bounds, settings.stencilMethod);
  this->accept(culler);
  SEDVisitor facer(SEDVisitor::Stage::Face, lights, finder);
  this->accept(facer);
  this->statistics.casters = culler.getCasters();
  this->statistics.zFailCasters = culler.getZFailCasters();
  this->statistics.skipped = culler.getSkipped();
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

DrawVisitor::Pass ShadowVolumeEffect::makeDrawPass(vtkOpenGLState* state, vtkShaderProgram* program,
                                                   const View& view)
{
  DrawVisitor::Pass pass;
  pass.state = state;
  pass.program = program;
  pass.drawables = &this->drawables;
  pass.view = &view;
  pass.clipFromWC = shadowClipFromWC(view, this->depthRange);
  pass.reversedDepth = this->depthRange.reversed;
  return pass;
}

bool ShadowVolumeEffect::drawPrePass(vtkOpenGLRenderWindow* window, const View& view)
{
  vtkOpenGLState* state = window->GetState();
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
  if (view.parallel)
  {
    glEnable(GL_DEPTH_CLAMP);
  }
  else
  {
    glDisable(GL_DEPTH_CLAMP);
  }

  ShadowPrograms programs(window);
  vtkShaderProgram* program = programs.use(ShadowPrograms::PrePass, view.parallel);
  if (program == nullptr)
  {
    return false;
  }
  const float unbiased[2] = {1.0f, 0.0f};
  program->SetUniform2f("depthBias", unbiased);
  SVStateVisitor geometryMode(RenderMode{RenderMode::What::Geometry});
  this->accept(geometryMode);
  DrawVisitor draw(this->makeDrawPass(state, program, view));
  this->accept(draw);
  this->statistics.prePassTriangles = draw.getCounts().geometry;
  return true;
}

bool ShadowVolumeEffect::drawVolumes(vtkOpenGLRenderWindow* window, const View& view, const Light& light)
{
  vtkOpenGLState* state = window->GetState();
  ShadowPrograms programs(window);
  vtkShaderProgram* program = nullptr;
  std::size_t counted = 0;
  bool open = false;
  bool usable = true;

  const auto openStencil = [&]
  {
    program = programs.use(ShadowPrograms::Volume, view.parallel);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(this->depthRange.reversed ? GL_GREATER : GL_LESS);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    state->vtkglEnable(GL_STENCIL_TEST);
    state->vtkglStencilFuncSeparate(GL_FRONT_AND_BACK, GL_ALWAYS, 0, 0xff);
    open = true;
    return program;
  };
  const auto fold = [&]
  {
    usable = this->target.foldStencil(state, programs, light.index, this->depthRange.reversed) && usable;
    counted = 0;
    open = false;
  };

  for (const StencilCount count : {StencilCount::ZPass, StencilCount::ZFail})
  {
    SVStateVisitor volumeMode(RenderMode{RenderMode::What::Volume, light.index, count});
    this->accept(volumeMode);
    if (!open && openStencil() == nullptr)
    {
      return false;
    }
    DrawVisitor::Pass pass = this->makeDrawPass(state, program, view);
    pass.makeRoom = [&](std::size_t bound)
    {
      // The stencil counts modulo 256. What is drawn between two folds can never come to 256 on any pixel.
      if (counted + bound > mostCountable && counted > 0)
      {
        fold();
        openStencil();
      }
      // What was drawn has to be folded, whatever its bound.
      counted += std::max<std::size_t>(bound, 1);
    };
    DrawVisitor draw(pass);
    this->accept(draw);
    this->statistics.sideTriangles += draw.getCounts().sides;
    this->statistics.capTriangles += draw.getCounts().caps;
    this->statistics.silhouetteEdges += draw.getCounts().silhouetteEdges;
  }
  if (counted > 0)
  {
    fold();
  }
  return usable;
}

void ShadowVolumeEffect::release(bool contextLost)
{
  this->target.release(contextLost);
  this->drawables.release(contextLost);
  this->capabilitiesKnown = false;
}

std::size_t ShadowVolumeEffect::getGraphicsMemorySize() const
{
  return this->target.getMemorySize() + this->drawables.getMemorySize();
}

} // namespace shadow
