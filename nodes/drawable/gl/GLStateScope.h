#pragma once

#include <array>

#include <vtkOpenGLState.h>

namespace shadow
{

/// Keeps the GL state that the shadow stages change and puts it back at the end: VTK's part through
/// vtkOpenGLState, the rest by asking the GL. Also the textures of the units that our stages take: VTK binds
/// those of image-based lighting once for all that a frame draws.
class GLStateScope
{
public:
  /// @param hasClipControl  see Capabilities
  GLStateScope(vtkOpenGLState* vtkState, bool hasClipControl);
  ~GLStateScope();
  GLStateScope(const GLStateScope&) = delete;
  GLStateScope& operator=(const GLStateScope&) = delete;

private:
  struct StencilFace
  {
    int func = 0;
    int reference = 0;
    int valueMask = 0;
    int writeMask = 0;
    int fail = 0;
    int depthFail = 0;
    int depthPass = 0;
  };
  /// What is bound to a texture unit, by kind of texture.
  using Bindings = std::array<int, 4>;
  static constexpr unsigned int unitsTaken = 8;
  static StencilFace readStencil(bool front);
  void readTextures();
  void restoreTextures();
  void restoreStencil(unsigned int face, const StencilFace& values);

  vtkOpenGLState* state;
  vtkOpenGLState::ScopedglViewport viewport;
  vtkOpenGLState::ScopedglScissor scissor;
  vtkOpenGLState::ScopedglColorMask colorMask;
  vtkOpenGLState::ScopedglDepthMask depthMask;
  vtkOpenGLState::ScopedglDepthFunc depthFunc;
  vtkOpenGLState::ScopedglActiveTexture activeTexture;
  vtkOpenGLState::ScopedglEnableDisable scissorTest;
  vtkOpenGLState::ScopedglEnableDisable depthTest;
  vtkOpenGLState::ScopedglEnableDisable stencilTest;
  vtkOpenGLState::ScopedglEnableDisable blend;
  vtkOpenGLState::ScopedglEnableDisable cullFace;
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction;
  StencilFace front;
  StencilFace back;
  int blendEquation[2] = {0, 0}; ///< colour, alpha
  int cullFaceMode = 0;
  int frontFace = 0;
  int provokingVertex = 0;
  int logicOpMode = 0;
  int stencilClear = 0;
  int polygonMode[2] = {0, 0};
  bool logicOp = false;
  bool depthClamp = false;
  bool clipDistance = false; ///< the first one
  bool polygonOffset = false;
  bool clipControl = false;
  int clipOrigin = 0;
  int clipDepth = 0;
  std::array<Bindings, unitsTaken> textures{};
};

} // namespace shadow
