#ifndef SceneBuilder_h
#define SceneBuilder_h

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

#include "CasterCuller.h"
#include "DrawnSurfaces.h"
#include "MeshStore.h"
#include "SEDGeode.h"

class vtkActor;
class vtkMapper;
class vtkMatrix4x4;
class vtkPolyData;
class vtkProp;
class vtkRenderer;

namespace shadow
{

/// Mirrors a renderer's props into a scene graph: each way to an opaque surface actor becomes a Transform,
/// each data set a SEDGeode that all ways to it share. Only what changed since the last time is built anew.
class SceneBuilder
{
public:
  struct Settings
  {
    double weldTolerance = 0.0;
    bool weldsRounding = false; ///< points that single precision hardly tells apart at the size of their mesh
                                ///< count as one, too
    bool copiesCountOnce = false; ///< see SEDGeometryOptions::copiesCountOnce
    std::set<vtkProp*> drawn; ///< the renderer's props that VTK draws: its cullers leave out others
    std::function<bool(vtkProp*)>
        isCasting;                  ///< asked for every prop on the way to an actor; see Node::casting
    std::string product = "shadow"; ///< what a prop that cannot be used has none of, for messages
  };

  /// Makes the children of @p root what the renderer shows now.
  /// Cost: O(props) when nothing changed; O(triangles) for a data set that is new or changed.
  /// @return true when other actors are mirrored than the last time
  bool update(vtkRenderer* renderer, const Settings& settings, Group& root);

  /// True for an actor when all that are drawn with its mapper, and so with its shader, have their surfaces
  /// in the graph, so that their pixels have their own place in the mask.
  bool isMirrored(vtkProp* prop) const;

  /// True when VTK may draw opaque things that are not in the graph: props that are not mirrored, and lines,
  /// points and edges of those that are.
  bool isMoreDrawn() const { return this->moreDrawn; }

  /// Pixels of the widest line or point that VTK may draw and pull towards the eye: of wires, edges and other cells
  /// than polygons. 0: there is none.
  double getWidestLine() const { return this->widestLine; }

  /// True when an actor is blended over the others although VTK draws it as opaque.
  bool isAnyBlendedAsOpaque() const { return this->blendedAsOpaque; }

  /// The actor of a transform that stands for it alone: one data set, drawn in one place. Else nullptr.
  vtkProp* findActor(const Node* transform) const;

  /// True when what VTK draws for an actor may show what lies behind, see letsThrough().
  bool mayBeSeenThrough() const { return this->seenThrough; }

  /// Actors that were left out although they are drawn, and why.
  const std::set<CasterCuller::Skipped>& getSkipped() const { return this->skipped; }

  /// Data that cannot be used, one line each.
  const std::vector<std::string>& getErrors() const { return this->errors; }

  /// Mirrored actors that VTK draws without lighting, so that no shadow shows on them: how many, and the
  /// first one's name.
  std::size_t countUnlit() const { return this->unlit; }
  const std::string& getFirstUnlit() const { return this->firstUnlit; }
  std::size_t countMirrored() const { return this->mirrored.size(); }

  /// Triangles of all mirrored actors, once for each path.
  std::size_t getTriangles() const { return this->triangles; }

  /// Bytes of adjacency and volumes.
  std::size_t getMemorySize() const { return this->meshes.getMemorySize(); }

private:
  struct PlacedActor
  {
    std::shared_ptr<Transform> transform = std::make_shared<Transform>();
    std::vector<std::shared_ptr<SEDGeode>> shown; ///< one a surface; none where the data cannot be used
    std::size_t surfaces = 0;                     ///< that VTK draws, those that cannot be used too
    bool used = false;
  };
  /// An actor in one place, until its meshes are built.
  struct Placement
  {
    vtkActor* actor = nullptr;
    PlacedActor* placed = nullptr;                   ///< nullptr when it has no place in the graph
    std::vector<vtkSmartPointer<vtkPolyData>> drawn; ///< what has been asked for
    bool hasLines = false;                           ///< among what is drawn
  };

  /// @name Stages: all actors are found, then meshes built, then the graph is made
  /// @{
  void addProp(vtkProp* prop, const Settings& settings);
  /// @param visible  all props on the path are
  /// @param matrix   of the last one, to world space
  void addPath(const PropPath& path, bool visible, vtkMatrix4x4* matrix, const Settings& settings);
  void addActor(Placement& placement, const PropPath& path, vtkMatrix4x4* matrix, const Settings& settings);
  void show(const Settings& settings, Group& root);
  void showActor(const Placement& placement, const Settings& settings, Group& root);
  /// @}

  void noteLines(vtkActor* actor, bool hasLines);
  void refuse(const std::string& name, const std::string& reason, const Settings& settings);
  std::string describe(vtkProp* prop) const; ///< class and place among the renderer's props
  void skip(vtkProp* prop, const std::string& reason);
  void dropUnused();

  MeshStore meshes;
  DrawnSurfaces surfaces;
  std::map<PropPath, PlacedActor> transforms;
  std::set<vtkProp*> mirrored;
  std::set<vtkMapper*> mappersOfOthers; ///< of actors that are not mirrored
  std::set<vtkMapper*> updated;         ///< in this update()
  std::set<CasterCuller::Skipped> skipped;
  std::vector<std::string> errors;
  std::multimap<std::size_t, std::string> errorsByPlacement; ///< in the order of props, whenever they were met
  std::vector<Placement> placements;
  std::size_t currentPlacement = 0;
  std::size_t triangles = 0;
  bool seenThrough = false;
  bool moreDrawn = false;
  bool blendedAsOpaque = false;
  double widestLine = 0.0;
  std::size_t unlit = 0;
  std::string firstUnlit;
  int propNumber = -1; ///< of the prop that is being mirrored
};

} // namespace shadow

#endif
