// Pass 2 of OutlineEffect: which edges are lines, and drawing them.
#include "OutlineEffect.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_access.hpp>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "ShadowPrograms.h"
#include "SmpParallelFor.h"

namespace shadow
{

void OutlineEffect::findMesh(const Surface& surface)
{
  PathLines& kept = *surface.lines;
  if (kept.geometry.lock() != surface.geometry)
  {
    const SEDGeometry& geometry = *surface.geometry;
    kept.geometry = surface.geometry;
    kept.mesh = geometry.getPreparedData().get<TopologyAwareMesh>(0.0, [&geometry]
                                                                  { return TopologyAwareMesh(geometry); });
    kept.found = false;
    kept.largeFaces.clear();
  }
}

void OutlineEffect::findLines(const Surface& surface, const Settings& settings)
{
  if (surface.lines == nullptr)
  {
    return;
  }
  this->findMesh(surface);
  PathLines& kept = *surface.lines;
  const bool sameCreases = kept.found && kept.settings.crease == settings.crease &&
                           kept.settings.featureAngle == settings.featureAngle;
  const bool same = sameCreases && kept.eyeMC == surface.eyeMC &&
                    kept.settings.silhouette == settings.silhouette &&
                    kept.settings.border == settings.border;
  if (settings.technique == LineTechnique::Faces)
  {
    return;
  }
  if (!same)
  {
    this->findLinesAnew(kept, *surface.geometry, surface.eyeMC, settings, sameCreases);
  }
  if (!kept.uploaded)
  {
    this->errors.push_back(surface.name + " has no outline: it has more lines than the GL can look up");
  }
}

void OutlineEffect::findLinesAnew(PathLines& kept, const SEDGeometry& geometry, const glm::dvec4& eyeMC,
                                  const Settings& settings, bool sameCreases)
{
  if (!sameCreases)
  {
    kept.creases =
        settings.crease ? kept.mesh->findCreases(geometry, settings.featureAngle) : std::vector<FaceEdges>();
  }
  if (this->finder == nullptr)
  {
    this->finder = makeSilhouetteFinder(SilhouetteMethod::Auto, 0.0, makeSmpParallelFor());
  }
  kept.found = true;
  kept.eyeMC = eyeMC;
  kept.settings = settings;
  this->finder->face(geometry, kept.eyeMC, kept.facing);
  kept.mesh->completeFacing(kept.facing);
  kept.mesh->findLines(geometry, kept.facing, {settings.silhouette, settings.border, &kept.creases},
                       kept.lines);
  kept.uploaded = kept.drawable.upload(kept.lines);
}

bool OutlineEffect::drawLines(vtkOpenGLRenderWindow* window, const View& wideView, const Settings& settings,
                              std::string& error)
{
  vtkOpenGLState* state = window->GetState();
  const unsigned int windowTexture = this->windowDepth.getTexture();
  const std::string switches = std::string(settings.keepsDepth ? keptDepth : "") +
                               (windowTexture != 0 ? "#define SHADOW_WINDOW_DEPTH\n" : "");
  vtkShaderProgram* program =
      ShadowPrograms(window).use(settings.technique == LineTechnique::Faces ? ShadowPrograms::OutlineFaces
                                                                            : ShadowPrograms::OutlineEdges,
                                 false, switches);
  if (program == nullptr)
  {
    error = noShader;
    return false;
  }
  this->target.beginLines(state, program, windowTexture);
  const bool reversed = this->depthRange.reversed;
  const float screenSize[2] = {static_cast<float>(wideView.width), static_cast<float>(wideView.height)};
  const float depthFromClip[2] = {reversed ? 1.0f : 0.5f, reversed ? 0.0f : 0.5f};
  const double reach = 0.5 * settings.lineWidth + softness;
  const double outside = 1.0 + 2.0 * (reach + 2.0) / std::min(wideView.width, wideView.height);
  program->SetUniform2f("screenSize", screenSize);
  program->SetUniform2f("depthFromClip", depthFromClip);
  program->SetUniformf("nearSign", reversed ? 1.0f : -1.0f);
  program->SetUniformf("outside", static_cast<float>(outside));
  program->SetUniformf("lineReach", static_cast<float>(reach));
  program->SetUniformf("halfWidth", static_cast<float>(0.5 * settings.lineWidth));
  if (windowTexture != 0)
  {
    program->SetUniformi("windowMargin", this->margin);
    program->SetUniformf("windowTolerance", static_cast<float>(settings.windowTolerance));
    program->SetUniformf("windowReach", static_cast<float>(settings.windowReach));
    program->SetUniform2f("windowFromDepth", &this->depthToWindow.x);
  }
  const glm::dmat4 clipFromWC = shadowClipFromWC(wideView, this->depthRange);
  const glm::dvec4 farWC = glm::row(wideView.clipFromWC, 3) - glm::row(wideView.clipFromWC, 2);
  for (const Surface& surface : this->surfaces)
  {
    if (surface.lines != nullptr)
    {
      setUniform(program, "clipFromMC", clipFromWC * surface.wcFromMC);
      setUniform(program, "farFromMC", farWC * surface.wcFromMC);
      const bool isDrawn = settings.technique == LineTechnique::Faces
                               ? this->drawFacesOf(surface, state, program, wideView, settings)
                               : this->drawLinesOf(surface, state, program);
      if (!isDrawn)
      {
        this->errors.push_back(surface.name + " has no outline: the GL cannot look up a mesh of its size");
      }
    }
  }
  return true;
}

bool OutlineEffect::drawLinesOf(const Surface& surface, vtkOpenGLState* state, vtkShaderProgram* program)
{
  const LineDrawable& lines = surface.lines->drawable;
  this->statistics.lineEdges += lines.countLines();
  this->statistics.lineTriangles += 2 * lines.countLines();
  return lines.draw(state, program, this->drawables.getGeometry(surface.geometry));
}

bool OutlineEffect::drawFacesOf(const Surface& surface, vtkOpenGLState* state, vtkShaderProgram* program,
                                const View& wideView, const Settings& settings)
{
  const SEDGeometry& geometry = *surface.geometry;
  const std::shared_ptr<const TopologyAwareMesh>& mesh = surface.lines->mesh;
  std::shared_ptr<const ContributingFaces> contributing;
  if (settings.leavesOutFlatFaces || settings.splitsLargeFaces)
  {
    contributing = geometry.getPreparedData().get<ContributingFaces>(
        0.0, [&] { return ContributingFaces(geometry, *mesh); });
  }
  const std::vector<FaceRun> all = {{0, static_cast<std::uint32_t>(mesh->countFaces())}};
  const std::vector<FaceRun>& whole = settings.leavesOutFlatFaces ? contributing->getRuns() : all;
  LargeFaces& large = surface.lines->largeFaces;
  if (settings.splitsLargeFaces)
  {
    const double pixels =
        measurePixels(geometry, wideView.clipFromWC * surface.wcFromMC, wideView.width, wideView.height);
    large.find(geometry, *contributing, pixels, 0.5 * settings.lineWidth + softness);
  }
  else
  {
    large.clear();
  }
  setUniform(program, "eyeMC", surface.eyeMC);
  program->SetUniformf("splitFrom", large.getLength());
  program->SetUniformi("drawsSilhouette", settings.silhouette ? 1 : 0);
  program->SetUniformi("drawsBorder", settings.border ? 1 : 0);
  const double degree = 3.14159265358979323846 / 180.0;
  program->SetUniformf(
      "creaseCosine", settings.crease ? static_cast<float>(std::cos(degree * settings.featureAngle)) : -2.0f);
  this->statistics.lineTriangles += countFaces(whole) + 3 * countFaces(large.getRuns());
  return this->drawables.getGeometry(surface.geometry)
      .drawFaces(state, program, *mesh, whole, large.getRuns());
}

} // namespace shadow
