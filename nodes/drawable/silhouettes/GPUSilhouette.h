#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "DrawableCache.h"
#include "FaceCounter.h"
#include "GeometryTexels.h"
#include "KeptByMesh.h"
#include "Light.h"
#include "Node.h"
#include "SEDGeode.h"
#include "ShadowPrograms.h"
#include "VETCollection.h"
#include "View.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace shadow
{

/// A method that finds silhouettes on the GPU and draws volumes from there; nothing comes back to the CPU.
/// One subclass for each published method.
///
/// In each frame: begin(); prepare() for every geode and path; finishPreparing(); drawSurface() for each,
/// which is the pre-pass; drawVolume() for each caster and light. All that is known here of a triangle is its
/// facing, the same in every stage, so that silhouettes are closed whatever the rounding.
class GPUSilhouette
{
public:
  /// What one frame is drawn with.
  struct Frame
  {
    vtkOpenGLRenderWindow* window = nullptr;
    const std::vector<Light>* lights = nullptr;
    const View* view = nullptr;
    const VETCollection* collection = nullptr; ///< for a method that needsCollection()
    bool unchanged = false;                    ///< collection and lights are those of the frame before
    DrawableCache* drawables = nullptr;
    glm::dmat4 clipFromWC{1.0}; ///< with the depth row of the shadow stages
    bool reversedDepth = true;  ///< see DepthRange
    bool software = false;      ///< see Capabilities
  };

  /// A geode on one path.
  struct Surface
  {
    const SEDGeode* geode = nullptr;
    const PathState* state = nullptr;
    const NodePath* path = nullptr;
    glm::dmat4 modelToWorld{1.0};
    FaceCulling faceCulling = FaceCulling::None;
  };

  GPUSilhouette() = default;
  GPUSilhouette(const GPUSilhouette&) = delete;
  GPUSilhouette& operator=(const GPUSilhouette&) = delete;
  virtual ~GPUSilhouette() = default;

  /// Whether the method looks at all triangles of the scene at once.
  virtual bool needsCollection() const { return false; }

  /// Starts a frame. @return false with a line in @p error when the GL cannot
  virtual bool begin(const Frame& frame, std::string& error);

  /// Has the GPU find what it needs to know of a surface for all lights, before anything is drawn of it.
  /// @pre  PathLightState::lightMC and plan are those of the frame
  /// @return false with a line in @p error when the GL cannot
  virtual bool prepare(const Surface& surface, std::string& error);

  /// Ends the preparation of all surfaces of a frame: for work that is better done for all of them together.
  /// @return false with a line in @p error when the GL cannot
  virtual bool finishPreparing(std::string& error);

  /// Draws a surface into the pre-pass. @return false when a shader does not compile
  bool drawSurface(const Surface& surface);

  /// Counts the volume of a surface for one light. @pre the count buffer is CountBuffer::Color
  /// @return false when a shader does not compile
  virtual bool drawVolume(const Surface& surface, const Light& light, StencilCount count);

  /// The program that draws a volume made on the CPU among those of the method: the way of its pre-pass.
  virtual ShadowPrograms::Stage getVolumeStage() const { return ShadowPrograms::VolumeInColor; }

  /// Takes what the stages read off the texture units.
  void unbind();

  /// Frees what was not used since the last call.
  virtual void sweep();

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  virtual void release(bool contextLost);

  virtual std::size_t getMemorySize() const;

protected:
  /// First of the texture units that the stages may use; see useTables().
  static constexpr int tableUnit = 0;
  static constexpr int facingUnit = 3;
  static constexpr int edgeUnit = 4;
  static constexpr int unitCount = 5;

  /// Lines of the preprocessor that choose where shaders/facingSource.glsl takes the facing from.
  virtual std::string getFacingSwitches() const { return ""; }

  /// The pre-pass: SurfacePrePass or SurfacePrePassHandedOn.
  virtual ShadowPrograms::Stage getSurfaceStage() const { return ShadowPrograms::SurfacePrePass; }

  /// Gives the program what facingSource.glsl asks for: here the lights that it will ask about, to evaluate
  /// the facing from the corners. @pre the program is current
  virtual void bindFacing(vtkShaderProgram* program, const Surface& surface,
                          const std::vector<Light>& lights);

  /// What bindFacing() does here, for the name of a GL program that is current.
  void bindCorners(unsigned int program, const Surface& surface, const std::vector<Light>& lights);

  /// Draws the sides, and with @p fan a fan that closes the far end, for a method that leaves the rest of
  /// drawVolume() as it is. @return false when a shader does not compile
  virtual bool drawSides(const Surface& /*surface*/, const Light& /*light*/, StencilCount /*count*/,
                         bool /*fan*/)
  {
    return false;
  }

  /// How the far end of a planned volume is closed: not at all where its far copies are one point.
  static DarkCap chooseDarkCap(const Light& light, const CasterPlan& plan);

  const Frame& getFrame() const { return this->frame; }
  GeometryTexels& getTables(const Surface& surface);

  /// Makes a stage's program current, with the tables of a surface. @return nullptr when it does not compile
  /// @param fromNear  see ShadowPrograms::use()
  vtkShaderProgram* useTables(ShadowPrograms::Stage stage, const Surface& surface,
                              const std::string& switches = "", bool fromNear = false);

  /// Makes a stage's program current, with the tables, the facing and the matrices that belong to a surface.
  /// @return nullptr when it does not compile
  vtkShaderProgram* use(ShadowPrograms::Stage stage, const Surface& surface, const std::vector<Light>& lights,
                        const std::string& switches, bool fromNear);

  /// The same for the volume of one light: sets also what extrusion.glsl and castingSign() ask for.
  vtkShaderProgram* useForVolume(ShadowPrograms::Stage stage, const Surface& surface, const Light& light,
                                 const std::string& switches = "");

  /// A vertex whose far copy can be the apex of a fan: not at the light.
  static glm::vec3 chooseApex(const SEDGeometry& geometry, const glm::dvec4& lightMC);

  /// Lets a program count faces. @pre the program is current
  FaceCounter countWith(vtkShaderProgram* program, const Surface& surface, StencilCount count) const;

private:
  bool drawCap(const Surface& surface, const Light& light, StencilCount count, bool far);
  bool isMirrored(const Surface& surface) const;

  Frame frame;
  KeptByMesh<GeometryTexels> tables;
  /// Of the frame, by stage and switches: to ask VTK's cache costs a hash of the whole text, for each surface
  /// and light.
  std::map<std::tuple<ShadowPrograms::Stage, bool, std::string>, vtkShaderProgram*> programs;
};

} // namespace shadow
