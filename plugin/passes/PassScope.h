#ifndef PassScope_h
#define PassScope_h

class vtkRenderPass;
class vtkRenderer;

namespace shadow
{

/// Whether other passes of the renderer draw what is not opaque, so that @p pass need not: it is the opaque
/// pass of a vtkRenderStepsPass, or stands in a vtkSequencePass beside translucent, volumetric or overlay
/// passes.
bool othersDrawTheRest(vtkRenderer* renderer, vtkRenderPass* pass);

/// What a pass that draws a complete scene has to do about viewport and background itself.
enum class CameraNeed
{
  None,     ///< a pass above does it, or it is not known
  Viewport, ///< it stands below others of VTK's of which none does, but beside one that has drawn before
  All       ///< the same, and it is the first to draw
};
CameraNeed findCameraNeed(vtkRenderer* renderer, vtkRenderPass* pass);

/// True for a viewport without width or height, of which VTK draws nothing.
bool hasNoPixels(vtkRenderer* renderer);

} // namespace shadow

#endif
