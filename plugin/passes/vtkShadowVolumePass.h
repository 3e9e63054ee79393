/**
 * @class   vtkShadowVolumePass
 * @brief   exact hard shadows by stencil shadow volumes, as a drop-in render pass
 *
 * Draws the scene of a renderer with hard shadows that are right to the pixel, for point lights, spot lights
 * of any cone and directional lights. Actors, mappers, lights and cameras stay as they are.
 *
 * @par Use
 * - complete pass: `renderer->SetPass(shadows)`
 * - below a camera pass: `cameraPass->SetDelegatePass(shadows); renderer->SetPass(cameraPass)`
 * - opaque pass: `renderStepsPass->SetOpaquePass(shadows); renderer->SetPass(renderStepsPass)`
 *
 * @par Stages
 * 1. the scene builder mirrors the renderer's props and lights into a scene graph (only what changed);
 * 2. pre-pass: all opaque triangles into a depth target of our own (reversed depth, far plane at infinity);
 * 3. for every light: caster culling, silhouette, shadow volume, count of its faces in a stencil or colour
 * buffer; a non-zero count clears the light's bit in the shadow mask;
 * 4. VTK draws its opaque pass, with the diffuse and specular part of each light multiplied by the mask.
 *
 * Translucent actors and volumes are drawn after that as the renderer does without a pass; they neither cast
 * nor receive.
 *
 * @par Source
 * Shi 2006 (master's thesis, Umea University), chapter 4.2; Everitt & Kilgard 2002; Lengyel 2002; Roettger,
 * Irion & Ertl 2002.
 *
 * @sa vtkShadowMapPass vtkRenderStepsPass
 */
#ifndef vtkShadowVolumePass_h
#define vtkShadowVolumePass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkShadowPassesModule.h" // for the export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkImageData;
class vtkProp;

class VTKSHADOWPASSES_EXPORT vtkShadowVolumePass : public vtkOpenGLRenderPass
{
public:
  static vtkShadowVolumePass* New();
  vtkTypeMacro(vtkShadowVolumePass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How shadow volumes are counted.
  enum StencilMethods
  {
    STENCIL_AUTO =
        0, ///< z-pass where the eye cannot be in the caster's shadow, else z-fail; per caster and light
    STENCIL_ZPASS, ///< z-pass always: wrong when the near plane is inside a shadow volume
    STENCIL_ZFAIL  ///< z-fail always: right everywhere, slower
  };

  ///@{
  /**
   * Count in front of the surface (z-pass), behind it (z-fail), or what each caster and light need (Auto, the
   * default).
   */
  vtkSetClampMacro(StencilMethod, int, STENCIL_AUTO, STENCIL_ZFAIL);
  vtkGetMacro(StencilMethod, int);
  void SetStencilMethodToAuto() { this->SetStencilMethod(STENCIL_AUTO); }
  void SetStencilMethodToZPass() { this->SetStencilMethod(STENCIL_ZPASS); }
  void SetStencilMethodToZFail() { this->SetStencilMethod(STENCIL_ZFAIL); }
  ///@}

  /// Where shadow volumes are counted.
  enum CountBuffers
  {
    COUNT_AUTO = 0, ///< colour on a software GL, where that is faster, else stencil
    COUNT_STENCIL,  ///< an 8-bit stencil buffer
    COUNT_COLOR     ///< a 32-bit float colour buffer, with additive blending
  };

  ///@{
  /**
   * The buffer that shadow volumes are counted in. Methods that keep silhouettes on the GPU always count in
   * colour. Both give the same picture, and where the GL counts wrongly in one the other is used, which
   * GetStatusMessage() then tells. Samples > 1 need GL 4.0 for the colour buffer; without it the stencil
   * is used. Default: Auto.
   */
  vtkSetClampMacro(CountBuffer, int, COUNT_AUTO, COUNT_COLOR);
  vtkGetMacro(CountBuffer, int);
  void SetCountBufferToAuto() { this->SetCountBuffer(COUNT_AUTO); }
  void SetCountBufferToStencil() { this->SetCountBuffer(COUNT_STENCIL); }
  void SetCountBufferToColor() { this->SetCountBuffer(COUNT_COLOR); }
  ///@}

  /// How silhouettes are found.
  enum SilhouetteMethods
  {
    SILHOUETTE_AUTO = 0,    ///< brute force for small meshes, hierarchical for large ones
    SILHOUETTE_BRUTE_FORCE, ///< facing of every triangle, then every edge, on the CPU (Shi 2006, chapter 3.2)
    SILHOUETTE_EDGE_BUFFER, ///< triangles flip bits at their edges (Buchanan & Sousa 2000)
    SILHOUETTE_TRIANGULAR,  ///< TA: a set of directed edges that cancel (Kolivand & Sunar 2011)
    SILHOUETTE_VISIBLE_NONVISIBLE, ///< VnV: edges with one neighbour facing the light (Kolivand & Sunar 2011)
    SILHOUETTE_HYBRID,       ///< HSD: TA on polygons merged from coplanar triangles (Kolivand & Sunar 2011)
    SILHOUETTE_HIERARCHICAL, ///< on the CPU, skipping clusters of triangles that face the light as one
    SILHOUETTE_TOPOLOGY_AWARE_MESH,     ///< TAM: triangles compare themselves with their neighbours (Valient)
    SILHOUETTE_FACING_TEXTURE,          ///< facing drawn by the GPU into a texture and read back (Shi 2006,
                                        ///< chapter 3.3)
    SILHOUETTE_FACING_TEXTURE_RESIDENT, ///< the same without reading it back
    SILHOUETTE_VERTEX_TEXTURE,          ///< state of every edge drawn by the GPU into a texture (Brabec &
                                        ///< Seidel 2003)
    SILHOUETTE_VERTEX_EXTRUSION,        ///< every edge a quad on the GPU (McGuire & Hughes 2004)
    SILHOUETTE_GEOMETRY_SHADER, ///< triangles with adjacency in the geometry shader (Zerari & Babahenini
                                ///< 2011)
    SILHOUETTE_COMPUTE          ///< silhouette edges listed by compute shaders; needs GL 4.3
  };

  ///@{
  /**
   * The silhouette method. All methods give the same picture. Auto (default) takes the one that is faster on
   * the CPU for the size of each caster.
   *
   * A method that the GL cannot do gives way to the next best: SILHOUETTE_FACING_TEXTURE_RESIDENT, then
   * SILHOUETTE_FACING_TEXTURE, then SILHOUETTE_BRUTE_FORCE. So does one that the GL draws wrongly: when it is
   * first used in a GL context, it has to draw a tiny scene of which the shadows are known. GetStatusMessage()
   * tells why; the status stays OK, since the picture is the same.
   */
  vtkSetClampMacro(SilhouetteMethod, int, SILHOUETTE_AUTO, SILHOUETTE_COMPUTE);
  vtkGetMacro(SilhouetteMethod, int);
  void SetSilhouetteMethodToAuto() { this->SetSilhouetteMethod(SILHOUETTE_AUTO); }
  void SetSilhouetteMethodToBruteForce() { this->SetSilhouetteMethod(SILHOUETTE_BRUTE_FORCE); }
  void SetSilhouetteMethodToEdgeBuffer() { this->SetSilhouetteMethod(SILHOUETTE_EDGE_BUFFER); }
  void SetSilhouetteMethodToTriangular() { this->SetSilhouetteMethod(SILHOUETTE_TRIANGULAR); }
  void SetSilhouetteMethodToVisibleNonVisible() { this->SetSilhouetteMethod(SILHOUETTE_VISIBLE_NONVISIBLE); }
  void SetSilhouetteMethodToHybrid() { this->SetSilhouetteMethod(SILHOUETTE_HYBRID); }
  void SetSilhouetteMethodToHierarchical() { this->SetSilhouetteMethod(SILHOUETTE_HIERARCHICAL); }
  void SetSilhouetteMethodToTopologyAwareMesh() { this->SetSilhouetteMethod(SILHOUETTE_TOPOLOGY_AWARE_MESH); }
  ///@}

  ///@{
  /**
   * For SILHOUETTE_HYBRID: neighbouring triangles whose normals are within this angle, in degrees, of that of
   * a region's first triangle count as one flat polygon. 0 (default): only those that lie exactly in one
   * plane, and the picture is that of every other method. Above, it has wrong pixels: see the README.
   */
  vtkSetClampMacro(CoplanarTolerance, double, 0.0, 89.0);
  vtkGetMacro(CoplanarTolerance, double);
  ///@}

  /**
   * The method that the last rendering used; SilhouetteMethod before the first.
   */
  int GetUsedSilhouetteMethod() const;

  /// How light and shadow are put together.
  enum CompositingMethods
  {
    COMPOSITING_MASK = 0, ///< one opaque pass that reads the shadow mask of all lights
    COMPOSITING_ADDITIVE  ///< the thesis's: an ambient pass, then one lighting pass for each light, added up
  };

  ///@{
  /**
   * Mask (default) or Additive. Additive adds in display space, so physically based actors, whose shader ends
   * in a gamma curve, are drawn as in Mask also there. It gives way to Mask, which GetStatusMessage() then
   * tells, with UseSSAO and UseHiddenLineRemoval, over what is blended although it is drawn as opaque, without
   * a depth test, with lights of negative intensity, and in a framebuffer whose depth cannot be shared or that
   * has several colour buffers, as below a vtkSSAOPass.
   */
  vtkSetClampMacro(Compositing, int, COMPOSITING_MASK, COMPOSITING_ADDITIVE);
  vtkGetMacro(Compositing, int);
  void SetCompositingToMask() { this->SetCompositing(COMPOSITING_MASK); }
  void SetCompositingToAdditive() { this->SetCompositing(COMPOSITING_ADDITIVE); }
  ///@}

  ///@{
  /**
   * How much of a light's diffuse and specular part its shadow takes away: 0 none, 1 (default) all. It is
   * multiplied with the light's own vtkLight::ShadowAttenuation.
   */
  vtkSetClampMacro(ShadowIntensity, double, 0.0, 1.0);
  vtkGetMacro(ShadowIntensity, double);
  ///@}

  ///@{
  /**
   * Samples a pixel of the shadow mask, for smooth shadow edges: 1, 2, 4, 8, ..., or 0 (default): as many as
   * what is drawn into has, so that shadows are as smooth as the window's edges. A number that the GL cannot
   * do is lowered to one it can. With fewer samples than the window has, a pixel that shows two surfaces
   * takes the shadow of one for both.
   */
  vtkSetClampMacro(Samples, int, 0, 32);
  vtkGetMacro(Samples, int);
  ///@}

  ///@{
  /**
   * Points of a caster that are closer than this (in its model units) count as one. Default 0: points with
   * equal coordinates.
   */
  vtkSetClampMacro(WeldTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(WeldTolerance, double);
  ///@}

  /// What the pass draws.
  enum Scopes
  {
    SCOPE_AUTO =
        0, ///< found out from the renderer's pass: opaque where another pass draws the rest, else complete
    SCOPE_OPAQUE,  ///< opaque geometry only
    SCOPE_COMPLETE ///< lights, opaque, translucent, volumetric and overlay
  };

  ///@{
  /**
   * What the pass draws. Auto (default) is right in the three uses above; set it when the pass sits in a tree
   * of passes that Auto cannot look into.
   */
  vtkSetClampMacro(Scope, int, SCOPE_AUTO, SCOPE_COMPLETE);
  vtkGetMacro(Scope, int);
  ///@}

  /// Work that a rendering may leave out; flags, to be added up.
  enum SavingsFlags
  {
    SAVINGS_NONE = 0,
    SAVINGS_KEPT_MASKS = 1, ///< the shadow mask is kept while nothing changes that it depends on; while only
                            ///< lights do, that of the other lights
    SAVINGS_BATCHES = 2,    ///< meshes of up to 512 triangles are drawn together, by methods that find silhouettes
                            ///< on the CPU
    SAVINGS_SCISSOR = 4,    ///< volumes are counted only in the rectangle of the view that surfaces lie in
    SAVINGS_ALL = SAVINGS_KEPT_MASKS | SAVINGS_BATCHES | SAVINGS_SCISSOR
  };

  ///@{
  /**
   * Work that is left out where the picture stays the same to the bit: SavingsFlags. All by default; 0 has every
   * rendering do everything, as for measuring. The last mask is all that is kept: where one renderer has two
   * views in turn, as in stereo, nothing is saved.
   */
  vtkSetClampMacro(Savings, int, SAVINGS_NONE, SAVINGS_ALL);
  vtkGetMacro(Savings, int);
  ///@}

  ///@{
  /**
   * Whether a prop casts shadows (it receives them in any case). Default: every opaque prop does. For an
   * assembly this holds for all its parts; a part can be switched off alone. The prop is not kept alive.
   */
  void SetCasting(vtkProp* prop, bool casting);
  bool GetCasting(vtkProp* prop);
  ///@}

  ///@{
  /**
   * Wait for the GL after each stage, so that the milliseconds below tell what the stage cost and not only
   * how long it took to hand it over. Default: off.
   */
  vtkSetMacro(MeasureStages, bool);
  vtkGetMacro(MeasureStages, bool);
  vtkBooleanMacro(MeasureStages, bool);
  ///@}

  /// Whether the last rendering had its shadows.
  enum StatusCodes
  {
    STATUS_OK = 0,        ///< all shadows are there
    STATUS_PARTIAL,       ///< drawn, but something was left out: see GetStatusMessage()
    STATUS_NOT_SUPPORTED, ///< the GL lacks what shadow volumes need, or draws them wrongly by every method:
                          ///< drawn without shadows
    STATUS_NOT_RENDERED   ///< nothing has been rendered yet
  };
  int GetStatus() const;

  /**
   * One line for each cause of a status other than OK, and one for a setting that had to give way to another (method,
   * count buffer, compositing, samples, batches), which is no failure; else empty. A new message is also a
   * vtkWarningMacro, once. One line more tells that surfaces are drawn without lighting, on which no shadow shows.
   */
  std::string GetStatusMessage() const;

  ///@{
  /**
   * Statistics of the last rendering: triangles of the scene, and those of volumes as often as they count. Of a
   * mask that was kept, see Savings, those that it was made with.
   * For a closed mesh, a point light and
   * Additive, GetTotalTriangles() is the thesis's t + (t + k) lights for z-pass and t + (2t + k) lights for
   * z-fail, with t the scene's and k the volume sides' triangles. The pre-pass that fills our own depth
   * buffer is counted apart.
   */
  vtkIdType GetPrePassTriangles() const;
  vtkIdType GetCountedPixels() const;     ///< of the view, in which each light's volumes are counted, see Savings
  vtkIdType GetAmbientTriangles() const;  ///< Mask: the one opaque pass
  vtkIdType GetSideTriangles() const;     ///< all lights
  vtkIdType GetCapTriangles() const;      ///< all lights
  vtkIdType GetLightingTriangles() const; ///< all lights; 0 for Mask
  vtkIdType GetTotalTriangles() const;    ///< ambient + sides + caps + lighting
  vtkIdType GetSilhouetteEdges() const;   ///< all casters and lights, with multiplicity; 0 where only the GPU
                                          ///< knows them, and sides are those of all edges
  ///@}

  ///@{
  /**
   * Statistics of the last rendering: casters are counted once for each path and light.
   */
  int GetNumberOfShadowLights() const;
  int GetNumberOfKeptLights() const;     ///< of these, whose part of the mask was kept, see Savings
  int GetNumberOfBatchedMeshes() const;  ///< drawn together with others, each path counted; see Savings
  int GetNumberOfCasters() const;        ///< whose volume was drawn
  int GetNumberOfZFailCasters() const;   ///< of these, by z-fail
  int GetNumberOfRebuiltVolumes() const; ///< of these, not taken over from the rendering before; 0 for
                                         ///< methods that keep volumes on the GPU
  int GetNumberOfCastersFoundBy(int silhouetteMethod) const; ///< of these, what Auto has chosen
  int GetNumberOfSkippedCasters() const; ///< lines of GetSkippedCaster(): one for each caster and reason
  std::string GetSkippedCaster(int index) const; ///< "name: reason", or "" when there is no such index
  ///@}

  /**
   * Statistics of the last rendering: actors of 10,000 triangles and more that no pixel shows the back of, so
   * that half of their triangles could be left out. Only looked for where it pays, with Mesa's software
   * rasterisers in windows without multisampling; a texture, a shader of its own or ForceOpaque on any actor
   * turns it off.
   */
  int GetNumberOfHiddenBacks() const;

  ///@{
  /**
   * Milliseconds of the last rendering's stages, see MeasureStages.
   */
  double GetSceneMilliseconds() const;      ///< mirroring props, adjacency
  double GetCheckMilliseconds() const;      ///< trying out what is used for the first time in a GL context,
                                            ///< shaders that are compiled for it too; else 0
  double GetSilhouetteMilliseconds() const; ///< facing, silhouette, volume, all lights
  double GetReadBackMilliseconds() const;   ///< of these, copying back what a GPU found; 0 where nothing is
  double GetPrePassMilliseconds() const;
  double GetStencilMilliseconds() const;
  double GetLightingMilliseconds() const;
  ///@}

  /**
   * Bytes that the adjacency, the volumes and the GL buffers and targets of this pass hold now.
   */
  vtkIdType GetMemorySize() const;

  /**
   * Copies the shadow mask of the last rendering into an image: one 8-bit component, as large as the
   * renderer, 255 where the light reaches the surface (and where there is none), 0 in shadow. With Samples >
   * 1 the share of reached samples.
   *
   * @param light  index among the renderer's lights that are switched on; a headlight has no shadow, its mask
   * is 255
   * @return false, with an error, when there is no such light or nothing has been rendered
   */
  bool GetShadowMask(int light, vtkImageData* image);

  ///@{
  /**
   * Called by VTK.
   */
  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
                               std::string& fragmentShader, vtkAbstractMapper* mapper,
                               vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
                           vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

protected:
  vtkShadowVolumePass();
  ~vtkShadowVolumePass() override;

private:
  vtkShadowVolumePass(const vtkShadowVolumePass&) = delete;
  void operator=(const vtkShadowVolumePass&) = delete;

  void RenderPart(vtkRenderPass* pass, const vtkRenderState* s);
  void RenderShadowed(const vtkRenderState* s, vtkRenderPass* opaque);

  int StencilMethod = STENCIL_AUTO;
  int CountBuffer = COUNT_AUTO;
  int SilhouetteMethod = SILHOUETTE_AUTO;
  double CoplanarTolerance = 0.0;
  int Compositing = COMPOSITING_MASK;
  int Scope = SCOPE_AUTO;
  int Samples = 0;
  double ShadowIntensity = 1.0;
  double WeldTolerance = 0.0;
  bool MeasureStages = false;
  int Savings = SAVINGS_ALL;

  friend class vtkSilhouettePass; // its lines come between what is opaque and what is translucent
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
