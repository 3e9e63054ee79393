#ifndef PrimitiveKind_h
#define PrimitiveKind_h

class vtkAbstractMapper;

namespace shadow
{

/// True when the shader that a mapper builds at this moment draws the faces of its mesh, false when it draws
/// its lines or points, which VTK gives shaders of their own.
/// @pre called while the mapper builds a shader, as from vtkOpenGLRenderPass::PostReplaceShaderValues
bool drawsFaces(vtkAbstractMapper* mapper);

} // namespace shadow

#endif
