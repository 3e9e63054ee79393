#ifndef MovedVertices_h
#define MovedVertices_h

class vtkActor;

namespace shadow
{

/// True when shaders that the user gave an actor may draw its vertices elsewhere than where its mesh has
/// them: a vertex or geometry shader of its own, or a replacement that writes a position or redefines what
/// one is made from. A replacement that only reads positions, to hand them on, is none.
/// Cost: O(characters of the replacements)
bool movesVertices(vtkActor* actor);

} // namespace shadow

#endif
