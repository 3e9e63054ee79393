#ifndef ActorTraits_h
#define ActorTraits_h

#include <vector>

#include "Node.h"

class vtkActor;
class vtkPolyData;
class vtkProp;

namespace shadow
{

/// The faces of an actor that VTK leaves out.
FaceCulling faceCullingOf(vtkActor* actor);

/// Whether VTK blends an actor or an image over the others although it draws it as an opaque one: it was told to,
/// or draws splats.
bool isBlendedAsOpaque(vtkProp* prop);

/// Whether what VTK draws for an actor may show what lies behind: shaders of its own, textures, translucency
/// that is taken for opaque, or edges that are wider than what they belong to.
bool letsThrough(vtkActor* actor);

/// Whether a prop that is no actor may be drawn with the opaque ones, into the depth buffer.
bool mayBeOpaque(vtkProp* prop);

/// Whether lines or points are drawn for an actor that is not mirrored: by its representation, edges or cells.
bool drawsLines(vtkActor* actor);

/// Whether what VTK draws for an actor is not only its polygons.
bool hasLinesOrPoints(vtkActor* actor, const std::vector<vtkPolyData*>& drawn);

/// Whether some of its lines are drawn as tubes, or points as spheres: surfaces of which there are no polygons.
bool hasTubesOrSpheres(vtkActor* actor, const std::vector<vtkPolyData*>& drawn);

} // namespace shadow

#endif
