#include "Shrinker.h"

#include <algorithm>
#include <chrono>

#include "ActorPoints.h"

namespace shadow::fuzz
{

namespace
{

class Shrinker
{
public:
  Shrinker(FuzzScene theScene, const StillWrong& theQuestion, const ShrinkLimits& theLimits)
      : scene(std::move(theScene)), stillWrong(theQuestion), limits(theLimits)
  {
  }

  FuzzScene run()
  {
    this->dropConfigs();
    this->dropMeshes();
    this->dropTriangles();
    this->simplify();
    this->dropTriangles();
    return this->scene;
  }

private:
  /// Takes the smaller scene when it is as wrong.
  bool offer(const FuzzScene& smaller)
  {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - this->start;
    if (smaller.getTriangleCount() == 0 || this->trials >= this->limits.trials ||
        passed.count() > this->limits.seconds)
    {
      return false;
    }
    ++this->trials;
    const bool isTaken = this->stillWrong(smaller);
    if (isTaken)
    {
      this->scene = smaller;
    }
    return isTaken;
  }

  void dropConfigs()
  {
    for (std::size_t i = this->scene.configs.size(); i-- > 0;)
    {
      FuzzScene smaller = this->scene;
      smaller.configs.erase(smaller.configs.begin() + static_cast<std::ptrdiff_t>(i));
      this->offer(smaller);
    }
  }

  void dropMeshes()
  {
    for (std::size_t i = this->scene.meshes.size(); i-- > 0;)
    {
      FuzzScene smaller = this->scene;
      smaller.meshes.erase(smaller.meshes.begin() + static_cast<std::ptrdiff_t>(i));
      this->offer(smaller);
    }
  }

  /// Without the triangles from @p first on, counted over all actors; actors left empty go, too.
  FuzzScene without(std::size_t first, std::size_t count) const
  {
    FuzzScene smaller = this->scene;
    std::size_t passed = 0;
    for (FuzzMesh& mesh : smaller.meshes)
    {
      const std::size_t size = mesh.triangles.size();
      const std::size_t begin = std::clamp(first, passed, passed + size) - passed;
      const std::size_t end = std::clamp(first + count, passed, passed + size) - passed;
      mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(begin),
                           mesh.triangles.begin() + static_cast<std::ptrdiff_t>(end));
      passed += size;
    }
    smaller.meshes.erase(std::remove_if(smaller.meshes.begin(), smaller.meshes.end(),
                                        [](const FuzzMesh& mesh) { return mesh.triangles.empty(); }),
                         smaller.meshes.end());
    return smaller;
  }

  void dropTriangles()
  {
    std::size_t part = std::max<std::size_t>(this->scene.getTriangleCount() / 2, 1);
    for (;;)
    {
      bool isSmaller = false;
      for (std::size_t first = 0; first < this->scene.getTriangleCount();)
      {
        const bool isTaken = this->offer(this->without(first, part));
        isSmaller = isSmaller || isTaken;
        first += isTaken ? 0 : part;
      }
      if (part == 1 && !isSmaller)
      {
        return;
      }
      part = std::max<std::size_t>(part / 2, 1);
    }
  }

  void simplify()
  {
    for (std::size_t i = 0; i < this->scene.meshes.size(); ++i)
    {
      FuzzScene simpler = this->scene;
      simpler.meshes[i].worldFromMC = glm::dmat4(1.0);
      this->offerChanged(simpler);
    }
    FuzzScene simpler = this->scene;
    simpler.doublePoints = false;
    this->offerChanged(simpler);
    simpler = this->scene;
    simpler.light.coneAngle = 180.0;
    this->offerChanged(simpler);
  }

  void offerChanged(FuzzScene simpler)
  {
    roundAsActorsDo(simpler);
    this->offer(simpler);
  }

  FuzzScene scene;
  const StillWrong& stillWrong;
  ShrinkLimits limits;
  std::size_t trials = 0;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

} // namespace

FuzzScene shrink(const FuzzScene& scene, const StillWrong& stillWrong, const ShrinkLimits& limits)
{
  return Shrinker(scene, stillWrong, limits).run();
}

} // namespace shadow::fuzz
