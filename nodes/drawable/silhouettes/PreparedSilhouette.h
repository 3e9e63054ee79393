#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "EdgeQuadSilhouette.h"
#include "TexelArray.h"

namespace shadow
{

/// The facing of all triangles and the silhouette of all lights are found before anything is drawn, once for
/// each geode and path, and kept until one of its lights moves, as seen from it.
///
/// Every triangle is evaluated once; the pre-pass, caps and edges read it from a texture.
class PreparedSilhouette : public EdgeQuadSilhouette
{
public:
  bool prepare(const Surface& surface, std::string& error) override;
  bool finishPreparing(std::string& error) override;
  void sweep() override;
  void release(bool contextLost) override;
  std::size_t getMemorySize() const override;

protected:
  /// What is kept for a path.
  struct Prepared
  {
    Prepared(TexelFormat edgeFormat, int maximumSide)
        : facing(TexelFormat::UInt2, maximumSide), edges(edgeFormat, maximumSide)
    {
    }
    virtual ~Prepared() = default;
    Prepared(const Prepared&) = delete;
    Prepared& operator=(const Prepared&) = delete;
    virtual void release(bool contextLost);
    virtual std::size_t getMemorySize() const;

    std::weak_ptr<const SEDGeometry> geometry;      ///< of these, what was found
    std::vector<std::pair<int, glm::dvec4>> lights; ///< Light::index, in model space
    TexelArray facing;                              ///< a triangle: see facingBitsOf() in facingSource.glsl
    TexelArray edges;                               ///< the method's
  };

  /// A surface that has to be found anew. What it points to stays where it is while the frame is drawn.
  struct Change
  {
    Surface surface;
    Prepared* prepared;
  };

  /// What the method keeps for a path, with nothing in it.
  virtual std::unique_ptr<Prepared> makePrepared() const = 0;

  /// Has the GL find the facing and the silhouette of surfaces. @return false with a line in @p error when it
  /// cannot
  virtual bool find(const std::vector<Change>& surfaces, std::string& error) = 0;

  const Prepared& getPrepared(const NodePath& path) const { return *this->paths.at(path).prepared; }

  enum class Which
  {
    All,
    LightFacingOnly ///< those for which averted triangles do not cast: see Casting
  };

  /// Bits, by Light::index, of the lights that a surface is found anew for.
  static unsigned int lightBits(const Change& change, Which which);

  std::string getFacingSwitches() const override { return "#define SHADOW_FACING_TEXTURE\n"; }
  void bindFacing(vtkShaderProgram* program, const Surface& surface,
                  const std::vector<Light>& lights) override;

  /// The same for a program of either kind.
  void bindFacingTexture(unsigned int program, const NodePath& path) const;

private:
  struct Entry
  {
    std::unique_ptr<Prepared> prepared;
    bool used = false;
  };
  std::map<NodePath, Entry> paths;
  std::vector<Change> changes; ///< of the frame
};

} // namespace shadow
