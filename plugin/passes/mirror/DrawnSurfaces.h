#ifndef DrawnSurfaces_h
#define DrawnSurfaces_h

#include <map>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include <vtkDataSetSurfaceFilter.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>
#include <vtkWeakPointer.h>

class vtkActor;
class vtkMapper;
class vtkPlaneCollection;
class vtkProp;

namespace shadow
{

/// The props from a renderer's prop down to an actor in it.
using PropPath = std::vector<vtkProp*>;

/// The polygons that VTK draws for an actor: visible blocks of composite data, surfaces of volume meshes, and
/// what the mapper's clipping planes leave. What has to be computed is kept until its input changes.
class DrawnSurfaces
{
public:
  /// True for mappers that draw the surface of their input, and not something in its place.
  static bool areKnown(vtkMapper* mapper);

  /// @pre the actor's mapper is known and has been updated
  /// @return data that live until the next call of dropUnused()
  std::vector<vtkPolyData*> collect(vtkActor* actor, const PropPath& path, const glm::dmat4& modelToWorld);

  void dropUnused();

private:
  struct Surface
  {
    vtkNew<vtkDataSetSurfaceFilter> filter;
    bool used = false;
  };
  struct ClippedMesh
  {
    vtkSmartPointer<vtkPolyData> output;
    vtkWeakPointer<vtkPolyData> input;
    std::vector<glm::dvec4> planesMC; ///< that it was cut by
    vtkMTimeType time = 0;
    bool used = false;
  };

  vtkPolyData* extractSurface(vtkMapper* mapper, vtkDataObject* input);
  vtkPolyData* clip(vtkPolyData* input, vtkPlaneCollection* planes, const PropPath& path,
                    const glm::dmat4& modelToWorld);

  std::map<vtkMapper*, Surface> surfaces;
  std::map<std::pair<PropPath, vtkPolyData*>, ClippedMesh> clipped;
};

} // namespace shadow

#endif
