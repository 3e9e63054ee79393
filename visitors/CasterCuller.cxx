#include "CasterCuller.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadow
{

namespace
{

// Rounding of a few products of coordinates this large; far above the truth, far below a pixel.
double slack(const glm::dvec4& plane, const glm::dvec3& point)
{
  const glm::dvec3 normal(plane);
  return 1e-9 * (glm::dot(glm::abs(normal), glm::abs(point)) + std::abs(plane.w));
}

bool allOutside(const glm::dvec4& plane, const BoxCorners& corners)
{
  return std::all_of(corners.begin(), corners.end(),
                     [&](const glm::dvec3& corner)
                     { return glm::dot(plane, glm::dvec4(corner, 1.0)) < -slack(plane, corner); });
}

// The caster is outside the plane and its shadow runs along or away from it.
bool shadowOutside(const glm::dvec4& plane, const BoxCorners& corners, const Light& light)
{
  return allOutside(plane, corners) &&
         std::all_of(corners.begin(), corners.end(),
                     [&](const glm::dvec3& corner)
                     {
                       const glm::dvec3 away = corner * light.positionWC.w - glm::dvec3(light.positionWC);
                       const glm::dvec3 normal(plane);
                       return glm::dot(normal, away) <= -1e-9 * glm::length(normal) * glm::length(away);
                     });
}

// Planes (inside positive) of the convex hull of the near rectangle and the light. Empty when the light is so
// close to the near plane that the hull has no volume to speak of: nothing can then be said to lie outside.
std::vector<glm::dvec4> makeNearVolume(const View& view, const Light& light)
{
  const std::array<glm::dvec3, 4>& nearWC = view.nearWC;
  const glm::dvec3 centre = 0.25 * (nearWC[0] + nearWC[1] + nearWC[2] + nearWC[3]);
  const double size = std::max(glm::distance(nearWC[0], nearWC[2]), glm::distance(nearWC[1], nearWC[3]));
  const glm::dvec3 nearNormal = glm::normalize(glm::cross(nearWC[1] - nearWC[0], nearWC[3] - nearWC[0]));
  const glm::dvec3 position(light.positionWC);
  const glm::dvec3 toLight = position - centre * light.positionWC.w;
  const double height = glm::dot(nearNormal, toLight);
  if (std::abs(height) <= 1e-6 * (light.positionWC.w == 0.0 ? glm::length(toLight) : size))
  {
    return {};
  }
  std::vector<glm::dvec4> planes;
  const glm::dvec3 base = height > 0.0 ? nearNormal : -nearNormal;
  planes.emplace_back(base, -glm::dot(base, centre));
  const glm::dvec3 inside =
      light.positionWC.w == 0.0 ? centre + size * glm::normalize(toLight) : centre + 0.5 * toLight;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const glm::dvec3& a = nearWC[i];
    const glm::dvec3 edge = nearWC[(i + 1) % 4] - a;
    glm::dvec3 normal = glm::cross(edge, position - a * light.positionWC.w);
    normal /= std::max(glm::length(normal), 1e-300);
    double offset = -glm::dot(normal, a);
    if (glm::dot(normal, inside) + offset < 0.0)
    {
      normal = -normal;
      offset = -offset;
    }
    planes.emplace_back(normal, offset);
  }
  if (light.positionWC.w != 0.0)
  {
    // Nothing beyond the light stands between it and the near rectangle.
    planes.emplace_back(-base, glm::dot(base, position));
  }
  return planes;
}

bool lightOutsideBoundingSphere(const Light& light, const BoxCorners& corners)
{
  const glm::dvec3 centre = 0.5 * (corners[0] + corners[7]);
  double radius = 0.0;
  for (const glm::dvec3& corner : corners)
  {
    radius = std::max(radius, glm::distance(centre, corner));
  }
  return light.positionWC.w == 0.0 ||
         glm::distance(glm::dvec3(light.positionWC), centre) > radius * (1.0 + 1e-6);
}

} // namespace

CasterCuller::CasterCuller(const View& theView, const std::vector<Light>& theLights,
                           const SceneBounds& bounds, StencilMethod theMethod)
    : view(theView), lights(theLights), method(theMethod), sceneBounds(bounds)
{
  const glm::dvec3& lower = sceneBounds.lowerWC;
  const glm::dvec3& upper = sceneBounds.upperWC;
  const double size = sceneBounds.isEmpty() ? 1.0 : glm::distance(lower, upper);
  const double magnitude = glm::length(glm::max(glm::abs(lower), glm::abs(upper)));
  // Where a caster touches the box a side is as thin as this. As thin as the rasteriser's grid, it would have a wrong
  // depth: in parallel views a pixel of some random scenes was wrong.
  const double margin = std::max((view.parallel ? 1e-2 : 1e-3) * size, 1e-9 * magnitude);
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 normal(0.0);
    normal[axis] = 1.0;
    const auto place = static_cast<std::size_t>(2 * axis);
    this->scenePlanes[place] = glm::dvec4(normal, margin - lower[axis]);
    this->scenePlanes[place + 1] = glm::dvec4(-normal, margin + upper[axis]);
  }
  for (const Light& light : theLights)
  {
    this->nearVolumes.push_back(makeNearVolume(theView, light));
  }
}

void CasterCuller::apply(SEDGeode& geode)
{
  PathState& path = geode.getPathState(this->getPath());
  path.modelToWorld = this->getModelToWorld();
  const BoxCorners corners = worldCorners(geode.getGeometry(), path.modelToWorld);
  const bool inFrustum = std::none_of(this->view.planes.begin(), this->view.planes.end(),
                                      [&](const glm::dvec4& plane) { return allOutside(plane, corners); });
  path.inView = inFrustum && this->isDrawn();
  if (path.inView)
  {
    this->receivers = joined(this->receivers, coverOf(corners, this->view));
  }
  for (std::size_t i = 0; i < this->lights.size(); ++i)
  {
    const Light& light = this->lights[i];
    PathLightState& state = path.lights[light.index];
    state.plan = {};
    if (!this->isCasting())
    {
      continue;
    }
    if (this->nothingBehind(geode.getGeometry(), path.modelToWorld, light))
    {
      state.plan.skipReason = "it is flat, and nothing lies behind it";
    }
    else
    {
      state.plan = this->plan(i, corners, inFrustum);
    }
    if (state.plan.skipReason != nullptr)
    {
      this->skipped.insert({describePath(this->getPath()), state.plan.skipReason});
    }
    this->casters += state.plan.count != StencilCount::Skip ? 1 : 0;
    this->zFailCasters += state.plan.count == StencilCount::ZFail ? 1 : 0;
  }
}

CasterPlan CasterCuller::plan(std::size_t lightPlace, const BoxCorners& corners, bool inFrustum) const
{
  const Light& light = this->lights[lightPlace];
  CasterPlan result;
  if (std::any_of(this->view.planes.begin(), this->view.planes.end(),
                  [&](const glm::dvec4& plane) { return shadowOutside(plane, corners, light); }))
  {
    result.skipReason = "its shadow lies outside the view";
    return result;
  }
  const std::vector<glm::dvec4>& nearVolume = this->nearVolumes[lightPlace];
  const bool nearIsLit = std::any_of(nearVolume.begin(), nearVolume.end(),
                                     [&](const glm::dvec4& plane) { return allOutside(plane, corners); });
  const bool zPass =
      this->method == StencilMethod::ZPass || (this->method == StencilMethod::Auto && nearIsLit);
  result.count = zPass ? StencilCount::ZPass : StencilCount::ZFail;
  const std::optional<glm::dvec4> sceneEnd = this->chooseSceneEnd(light, corners, result.count);
  if (sceneEnd || this->view.parallel)
  {
    result.farPlaneWC = sceneEnd ? *sceneEnd : this->endOfParallelView(light);
  }
  if (zPass)
  {
    // A cap lies on the caster's own surface, so it is in front of what is seen only where that surface is
    // not drawn.
    result.lightCap = this->getFaceCulling() != FaceCulling::None || !this->isDrawn();
    return result;
  }
  const bool explicitZFail = this->method == StencilMethod::ZFail;
  result.lightCap = explicitZFail || inFrustum;
  if (light.positionWC.w != 0.0 || !result.isFarAtInfinity())
  {
    const bool fan = sceneEnd || lightOutsideBoundingSphere(light, corners);
    result.darkCap = !explicitZFail && fan ? DarkCap::Fan : DarkCap::Triangles;
  }
  return result;
}

// A floor, a wall: a flat caster cannot shadow itself, and all of the scene is on the light's side of it or
// in its plane.
bool CasterCuller::nothingBehind(const SEDGeometry& geometry, const glm::dmat4& wcFromModel,
                                 const Light& light) const
{
  if (!geometry.getCommonPlane())
  {
    return false;
  }
  glm::dvec4 plane = *geometry.getCommonPlane() * glm::inverse(worldFromRelative(geometry, wcFromModel));
  plane /= glm::length(glm::dvec3(plane));
  const double height = glm::dot(plane, light.positionWC);
  if (std::abs(height) <= slack(plane, glm::dvec3(light.positionWC)))
  {
    return false; // which side the light is on is up to exact arithmetic
  }
  plane = height < 0.0 ? -plane : plane;
  const glm::dvec3& lower = this->sceneBounds.lowerWC;
  const glm::dvec3& upper = this->sceneBounds.upperWC;
  // The corner that lies deepest behind the plane.
  const glm::dvec3 deepest(plane.x > 0.0 ? lower.x : upper.x, plane.y > 0.0 ? lower.y : upper.y,
                           plane.z > 0.0 ? lower.z : upper.z);
  return glm::dot(plane, glm::dvec4(deepest, 1.0)) >= -1e-6 * glm::distance(lower, upper);
}

// A side of the scene's bounding box that all the caster's shadow runs into: what lies behind it receives
// nothing, so the volume can end there and covers far fewer pixels than one that goes on for ever. Nothing if
// there is none.
std::optional<glm::dvec4> CasterCuller::chooseSceneEnd(const Light& light, const BoxCorners& corners,
                                                       StencilCount count) const
{
  std::optional<glm::dvec4> best;
  double shortest = std::numeric_limits<double>::max();
  for (const glm::dvec4& plane : this->scenePlanes)
  {
    const double lightHeight = glm::dot(plane, light.positionWC);
    // Z-pass draws no cap there, so none of it may be seen: the near rectangle has to be on the inner side.
    const bool nearInside =
        count == StencilCount::ZFail ||
        std::all_of(this->view.nearWC.begin(), this->view.nearWC.end(),
                    [&](const glm::dvec3& corner)
                    { return glm::dot(plane, glm::dvec4(corner, 1.0)) > slack(plane, corner); });
    double longest = 0.0;
    bool reached = nearInside && lightHeight > 0.0;
    for (const glm::dvec3& corner : corners)
    {
      const double height = glm::dot(plane, glm::dvec4(corner, 1.0));
      // How far down its ray a corner is carried. Rays that are nearly along the plane are left to infinity.
      const double descent = lightHeight - height * light.positionWC.w;
      reached = reached && descent > 0.05 * lightHeight;
      const double carried = light.positionWC.w != 0.0
                                 ? glm::distance(corner, glm::dvec3(light.positionWC)) * height / descent
                                 : glm::length(glm::dvec3(light.positionWC)) * height / descent;
      longest = std::max(longest, carried);
    }
    if (reached && longest < shortest)
    {
      shortest = longest;
      best = plane;
    }
  }
  return best;
}

// All rays of a parallel view end at one point at infinity, and no cap that a rasteriser could draw lies there.
// So volumes end behind all that is seen, and behind the light, across the view: a cap there is what of that
// plane lies in the shadow. Rays that never meet it go on to infinity, see endOf() in shaders/extrusion.glsl.
// Without a cap, too: a side nearly along the view would be as deep as it is wide by rounding.
glm::dvec4 CasterCuller::endOfParallelView(const Light& light) const
{
  const double lightDepth =
      light.positionWC.w != 0.0 ? glm::dot(this->view.viewDepth, light.positionWC) : this->sceneBounds.farthest;
  const double depth = std::max(this->sceneBounds.farthest, lightDepth) +
                       1e-2 * std::max(this->sceneBounds.farthest - this->sceneBounds.nearest, 1e-300);
  return glm::dvec4(0.0, 0.0, 0.0, depth) - this->view.viewDepth;
}

} // namespace shadow
