#include "OutlineEffect.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "FinishStage.h"
#include "GLStateScope.h"
#include "OpenGL.h"
#include "SEDGeode.h"
#include "SceneBoundsVisitor.h"
#include "ShadowPrograms.h"
#include "Stopwatch.h"
#include "SweepUnused.h"

namespace shadow
{

namespace
{

/// The eye as a light: facing it is looking towards the eye.
Light makeEye(const View& view)
{
  // What the clip matrix takes to a point without width, height and w.
  const glm::dvec4 eye = glm::inverse(view.clipFromWC) * glm::dvec4(0.0, 0.0, 1.0, 0.0);
  if (!view.parallel)
  {
    return {0, eye / eye.w};
  }
  const glm::dvec3 direction(eye);
  const bool away = glm::dot(glm::dvec3(view.viewDepth), direction) > 0.0;
  return {0, glm::dvec4(away ? -direction : direction, 0.0)};
}

/// A view that shows @p margin pixels more on each side, at the same scale.
View widen(const View& view, int margin)
{
  const int width = view.width + 2 * margin;
  const int height = view.height + 2 * margin;
  const glm::dvec3 scale(static_cast<double>(view.width) / width, static_cast<double>(view.height) / height,
                         1.0);
  return makeView(glm::scale(glm::dmat4(1.0), scale) * view.clipFromWC, width, height);
}

} // namespace

int chooseDepthScale(int width, int height)
{
  constexpr int finest = 4;
  constexpr double mostPixels = 1 << 24;
  const double pixels = static_cast<double>(width) * height;
  return std::clamp(static_cast<int>(std::sqrt(mostPixels / std::max(pixels, 1.0))), 1, finest);
}

/// Lists the surfaces of the graph, and finds what is kept for them.
class OutlineEffect::SurfaceCollector : public NodeVisitor
{
public:
  SurfaceCollector(OutlineEffect& theEffect, const Light& theEye) : effect(theEffect), eye(theEye) {}

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override
  {
    if (!this->isDrawn())
    {
      return;
    }
    const SEDGeometry& geometry = geode.getGeometry();
    const std::optional<glm::dvec4> eyeMC =
        lightToModel(this->eye, this->getModelToWorld(), geometry.getOrigin());
    Surface surface;
    surface.name = this->getPath().size() > 1 ? this->getPath()[this->getPath().size() - 2]->name : "";
    surface.geometry = geode.getSharedGeometry();
    surface.wcFromMC = worldFromRelative(geometry, this->getModelToWorld());
    surface.culling = this->getFaceCulling();
    if (this->isCasting() && eyeMC)
    {
      PathLines& lines = this->effect.paths[this->getPath()];
      lines.used = true;
      surface.lines = &lines;
      surface.eyeMC = *eyeMC;
    }
    this->effect.surfaces.push_back(std::move(surface));
  }

private:
  OutlineEffect& effect;
  Light eye;
};

bool OutlineEffect::renderLines(vtkOpenGLRenderWindow* window, const View& view, const Settings& settings,
                                std::string& error)
{
  this->statistics = {};
  this->errors.clear();
  if (!this->capabilitiesKnown)
  {
    this->capabilities = queryCapabilities();
    this->capabilitiesKnown = true;
  }
  if (!this->capabilities.usable)
  {
    error = "outlines need OpenGL 3.2, this context has " + this->capabilities.version;
    return false;
  }
  const GLStateScope scope(window->GetState(), this->capabilities.clipControl);
  this->margin = static_cast<int>(std::ceil(0.5 * settings.lineWidth + softness)) + 1;
  const View wideView = widen(view, this->margin);
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const int possible = std::max(1, largest / std::max(wideView.width, wideView.height));
  const int scale = std::min(possible, settings.depthScale > 0 ? settings.depthScale
                                                               : chooseDepthScale(view.width, view.height));
  std::string refusal;
  if (settings.behindWindow && !this->windowDepth.copy(window->GetState(), refusal))
  {
    this->errors.push_back(refusal);
  }
  if (!settings.behindWindow)
  {
    this->windowDepth.release();
  }
  if (!this->target.allocate(window->GetState(), wideView.width, wideView.height, scale, settings.keepsDepth,
                             error))
  {
    return false;
  }
  const bool succeeds = this->drawStages(window, wideView, settings, error);
  this->surfaces.clear();
  this->drawables.sweep();
  sweepUnused(this->paths, [](PathLines& lines) { lines.drawable.release(false); });
  return succeeds;
}

bool OutlineEffect::drawStages(vtkOpenGLRenderWindow* window, const View& wideView, const Settings& settings,
                               std::string& error)
{
  Stopwatch stage;

  SurfaceCollector collector(*this, makeEye(wideView));
  this->accept(collector);
  for (const Surface& surface : this->surfaces)
  {
    this->findLines(surface, settings);
  }
  this->chooseDepthRange(wideView);
  this->keepsDepth = settings.keepsDepth;
  this->depthToWindow = windowFromDepth(wideView, this->depthRange);
  this->statistics.edgeMilliseconds = stage.getMilliseconds();

  stage = {};
  if (this->depthRange.reversed)
  {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  }
  if (!this->drawDepth(window, wideView, error))
  {
    return false;
  }
  finishStage(settings.waitAfterStages);
  this->statistics.depthMilliseconds = stage.getMilliseconds();

  stage = {};
  if (!this->drawLines(window, wideView, settings, error))
  {
    return false;
  }
  finishStage(settings.waitAfterStages);
  this->statistics.lineMilliseconds = stage.getMilliseconds();
  return true;
}

void OutlineEffect::chooseDepthRange(const View& view)
{
  this->depthRange = {};
  this->depthRange.reversed = this->capabilities.clipControl;
  if (view.parallel)
  {
    SceneBoundsVisitor bounds(view);
    this->accept(bounds);
    // A margin, so that no geometry lies on the far end. The near end is the near plane.
    this->depthRange.farthest = 1.001 * std::max(bounds.getBounds().farthest, 1e-300);
  }
}

bool OutlineEffect::drawDepth(vtkOpenGLRenderWindow* window, const View& wideView, std::string& error)
{
  vtkOpenGLState* state = window->GetState();
  this->target.beginDepth(state, this->depthRange.reversed);
  vtkShaderProgram* program = ShadowPrograms(window).use(ShadowPrograms::OutlineDepth, false);
  if (program == nullptr)
  {
    error = noShader;
    return false;
  }
  setDepthBias(program, this->depthRange.reversed, false);
  const glm::dmat4 clipFromWC = shadowClipFromWC(wideView, this->depthRange);
  for (const Surface& surface : this->surfaces)
  {
    setUniform(program, "clipFromMC", clipFromWC * surface.wcFromMC);
    const bool mirrored = wideView.mirrored != (glm::determinant(glm::dmat3(surface.wcFromMC)) < 0.0);
    this->drawables.getGeometry(surface.geometry)
        .drawPrePass(state, program, nullptr, surface.culling, mirrored);
    this->statistics.depthTriangles += surface.geometry->getTriangles().size();
  }
  return true;
}

bool OutlineEffect::blend(vtkOpenGLRenderWindow* window, const Look& look, bool wait, std::string& error)
{
  const Stopwatch stage;
  const GLStateScope scope(window->GetState(), this->capabilities.clipControl);
  vtkShaderProgram* program = ShadowPrograms(window).use(ShadowPrograms::OutlineBlend, false);
  if (program == nullptr)
  {
    error = noShader;
    return false;
  }
  const glm::vec3 color(look.color);
  const glm::vec4 hidden(look.hiddenColor);
  program->SetUniform3f("lineColor", &color.x);
  program->SetUniform4f("hiddenColor", &hidden.x);
  program->SetUniformi("smoothLines", look.smooth ? 1 : 0);
  this->target.blend(window->GetState(), program, this->margin);
  if (this->keepsDepth)
  {
    program = ShadowPrograms(window).use(ShadowPrograms::OutlineBlend, false, keptDepth);
    if (program == nullptr)
    {
      error = noShader;
      return false;
    }
    program->SetUniform2f("windowFromDepth", &this->depthToWindow.x);
    program->SetUniformf("nearSign", this->depthRange.reversed ? 1.0f : -1.0f);
    this->target.blendDepth(window->GetState(), program, this->margin);
  }
  finishStage(wait);
  this->statistics.blendMilliseconds = stage.getMilliseconds();
  return true;
}

std::array<int, 2> OutlineEffect::getSize() const
{
  if (this->target.getWidth() == 0)
  {
    return {0, 0};
  }
  return {this->target.getWidth() - 2 * this->margin, this->target.getHeight() - 2 * this->margin};
}

std::vector<unsigned char> OutlineEffect::readMask(vtkOpenGLRenderWindow* window) const
{
  return this->target.getWidth() == 0 ? std::vector<unsigned char>()
                                      : this->target.readMask(window, this->margin);
}

void OutlineEffect::release(bool contextLost)
{
  this->target.release(contextLost);
  this->windowDepth.release(contextLost);
  this->drawables.release(contextLost);
  for (auto& entry : this->paths)
  {
    entry.second.drawable.release(contextLost);
  }
  this->paths.clear();
  this->capabilitiesKnown = false;
}

std::size_t OutlineEffect::getGraphicsMemorySize() const
{
  std::size_t bytes = this->target.getMemorySize() + this->windowDepth.getMemorySize() +
                      this->drawables.getMemorySize();
  for (const auto& entry : this->paths)
  {
    bytes += entry.second.drawable.getMemorySize();
  }
  return bytes;
}

} // namespace shadow
