/**
 * @class   vtkSilhouettePass
 * @brief   hidden-line-correct outlines of any scene, as a drop-in render pass
 *
 * Draws a scene, and over it thick lines along the edges that make up its outline for the camera: silhouette
 * edges, between a triangle that looks towards the camera and one that does not; border edges, which have one
 * triangle; and, if wanted, creases. What of an edge lies behind other surfaces is left out, or drawn
 * faintly.
 *
 * Opaque surface actors have lines and hide those of others. Translucent ones have none; where one is in
 * front of a line, it tints it. All else that VTK has drawn into the window's depth, such as glyphs, images
 * and the layers below one that preserves it, hides lines, pixel by pixel; what lies closer on a surface
 * than lines and points that VTK brings nearer does not. With a delegate other than a vtkShadowVolumePass,
 * lines lie over all that it draws later than opaque things.
 *
 * @par Use
 * - complete pass: `renderer->SetPass(outlines)`
 * - with shadows: `outlines->SetDelegatePass(shadows); renderer->SetPass(outlines)`
 * - below a camera pass: `cameraPass->SetDelegatePass(outlines); renderer->SetPass(cameraPass)`
 * - opaque pass: `renderStepsPass->SetOpaquePass(outlines); renderer->SetPass(renderStepsPass)`
 *
 * @par Stages
 * 1. the delegate, or VTK's own passes, draw the scene;
 * 2. the scene builder mirrors the renderer's props into a scene graph (only what changed), and the edges
 * that are lines are found from an exact facing, decided once a triangle;
 * 3. pass 1: depth of all opaque triangles, and its slope, into a target of our own, which is wider than the
 * view by half a line on each side;
 * 4. pass 2: a rectangle around each line, or, by TECHNIQUE_FACES, the triangles that own one, enlarged on
 * the screen until they cover it; the fragment stage keeps a capsule around each edge, of what is not behind
 * the depth of pass 1, and the nearest edge wins;
 * 5. the lines are blended over the opaque scene; where translucent things follow, they take their depth.
 *
 * @par Source
 * Valient, "Hardware Generated Object Silhouettes".
 *
 * @sa vtkShadowVolumePass vtkPolyDataSilhouette vtkOutlineGlowPass
 */
#ifndef vtkSilhouettePass_h
#define vtkSilhouettePass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkShadowPassesModule.h" // for the export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkOpenGLRenderer;
class vtkProp;

class VTKSHADOWPASSES_EXPORT vtkSilhouettePass : public vtkOpenGLRenderPass
{
public:
  static vtkSilhouettePass* New();
  vtkTypeMacro(vtkSilhouettePass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The pass that draws the scene below the lines, such as a vtkShadowVolumePass. nullptr (default): VTK's
   * own lights, opaque, translucent, volumetric and overlay passes, with the lines after opaque; opaque
   * alone where the pass is used as opaque pass.
   */
  virtual void SetDelegatePass(vtkRenderPass* delegatePass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  ///@{
  /**
   * Draw no scene, only the lines over what is there: the background, for a complete pass. Surfaces hide
   * lines all the same. Translucent things that have been drawn are below the lines, wherever they are.
   * Default: off.
   */
  vtkSetMacro(LinesOnly, bool);
  vtkGetMacro(LinesOnly, bool);
  vtkBooleanMacro(LinesOnly, bool);
  ///@}

  ///@{
  /**
   * Width of the lines in pixels, half of it on each side of the edge; 0.5 to 64. Default: 2. In a picture
   * that a vtkWindowToImageFilter with a scale or a vtkRenderLargeImage puts together from tiles, as many
   * times that.
   */
  virtual void SetLineWidth(double width);
  virtual double GetLineWidthMinValue() { return 0.5; }
  virtual double GetLineWidthMaxValue() { return 64.0; }
  vtkGetMacro(LineWidth, double);
  ///@}

  ///@{
  /**
   * Colour of the lines, red, green and blue from 0 to 1. Default: black.
   */
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  ///@}

  ///@{
  /**
   * Also draw what of the lines is hidden, below those that are visible, in a colour and opacity of its own.
   * Default: off; grey (0.5), 0.4.
   */
  vtkSetMacro(HiddenEdges, bool);
  vtkGetMacro(HiddenEdges, bool);
  vtkBooleanMacro(HiddenEdges, bool);
  vtkSetVector3Macro(HiddenColor, double);
  vtkGetVector3Macro(HiddenColor, double);
  vtkSetClampMacro(HiddenOpacity, double, 0.0, 1.0);
  vtkGetMacro(HiddenOpacity, double);
  ///@}

  ///@{
  /**
   * Which edges are lines: those between a triangle that looks towards the camera and one that does not
   * (default: on), those with one triangle (default: on), and those whose triangles' normals differ by more
   * than FeatureAngle degrees (default: off; 60). Where more than two triangles meet in an edge, those that
   * are left once all that can be have been paired have a border there.
   */
  vtkSetMacro(SilhouetteEdges, bool);
  vtkGetMacro(SilhouetteEdges, bool);
  vtkBooleanMacro(SilhouetteEdges, bool);
  vtkSetMacro(BorderEdges, bool);
  vtkGetMacro(BorderEdges, bool);
  vtkBooleanMacro(BorderEdges, bool);
  vtkSetMacro(CreaseEdges, bool);
  vtkGetMacro(CreaseEdges, bool);
  vtkBooleanMacro(CreaseEdges, bool);
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Soften the lines' edges over one pixel, by the distance from the edge. Off: a pixel has the line's colour
   * or not. Default: on.
   */
  vtkSetMacro(Smooth, bool);
  vtkGetMacro(Smooth, bool);
  vtkBooleanMacro(Smooth, bool);
  ///@}

  /// How lines are found and drawn.
  enum Techniques
  {
    TECHNIQUE_RECTANGLES = 0, ///< edges found from an exact facing on the CPU, each drawn as a rectangle
    TECHNIQUE_FACES ///< Valient's: on the GPU, every triangle tells its own edges by the normals of its
                    ///< neighbours, and is enlarged on the screen until it covers their lines
  };

  ///@{
  /**
   * Both give the same picture, but for Faces near where a triangle is seen from its edge: it knows its
   * neighbours' normals in 16 bits a coordinate, which do not tell an eye closer than 1e-4 to their plane
   * from one on its other side. Lines may then have gaps. Of Faces the CPU makes the mesh once, finds the
   * triangles that can have lines, and lists those that may be large on the screen; which edges are lines is
   * left to the GPU. It is the slower one. Default: Rectangles.
   */
  vtkSetClampMacro(Technique, int, TECHNIQUE_RECTANGLES, TECHNIQUE_FACES);
  vtkGetMacro(Technique, int);
  void SetTechniqueToRectangles() { this->SetTechnique(TECHNIQUE_RECTANGLES); }
  void SetTechniqueToFaces() { this->SetTechnique(TECHNIQUE_FACES); }
  ///@}

  ///@{
  /**
   * Of TECHNIQUE_FACES: draw no triangle that can have no line from anywhere, within flat parts; and draw one
   * that is large on the screen as three thin ones along its edges, where that covers fewer pixels. The
   * picture is the same. Default: on, on.
   */
  vtkSetMacro(LeaveOutFlatFaces, bool);
  vtkGetMacro(LeaveOutFlatFaces, bool);
  vtkBooleanMacro(LeaveOutFlatFaces, bool);
  vtkSetMacro(SplitLargeFaces, bool);
  vtkGetMacro(SplitLargeFaces, bool);
  vtkBooleanMacro(SplitLargeFaces, bool);
  ///@}

  ///@{
  /**
   * Pixels of pass 1 for one of the view, in each direction: how exactly a line ends where it is hidden. 0
   * (default): 4, less for views of more than a million pixels.
   */
  vtkSetClampMacro(DepthScale, int, 0, 8);
  vtkGetMacro(DepthScale, int);
  ///@}

  ///@{
  /**
   * Points of a mesh that are closer than this (in its model units) count as one, and so do, in any case,
   * points closer than a four-millionth of the mesh's size, which differ by rounding. Default: 0.
   */
  vtkSetClampMacro(WeldTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(WeldTolerance, double);
  ///@}

  ///@{
  /**
   * Whether a prop has lines (it hides those of others in any case). Default: every opaque prop has. For an
   * assembly this holds for all its parts; a part can be switched off alone. The prop is not kept alive.
   */
  void SetOutlined(vtkProp* prop, bool outlined);
  bool GetOutlined(vtkProp* prop);
  ///@}

  /// Whether the last rendering had its lines.
  enum StatusCodes
  {
    STATUS_OK = 0,        ///< all lines are there
    STATUS_PARTIAL,       ///< drawn, but something was left out: see GetStatusMessage()
    STATUS_NOT_SUPPORTED, ///< the GL lacks what the lines need: drawn without
    STATUS_NOT_RENDERED   ///< nothing has been rendered yet
  };
  int GetStatus() const;

  /**
   * One line for each cause of a status other than OK; empty otherwise. A new message is also a
   * vtkWarningMacro, once.
   */
  std::string GetStatusMessage() const;

  ///@{
  /**
   * Wait for the GL after each stage, so that the milliseconds below tell what the stage cost and not only
   * how long it took to hand it over. Default: off.
   */
  vtkSetMacro(MeasureStages, bool);
  vtkGetMacro(MeasureStages, bool);
  vtkBooleanMacro(MeasureStages, bool);
  ///@}

  ///@{
  /**
   * Statistics of the last rendering.
   */
  vtkIdType GetDepthTriangles() const; ///< of pass 1
  vtkIdType GetLineTriangles() const;  ///< of pass 2
  vtkIdType
  GetLineEdges() const; ///< visible or not, once for each path to their actor; 0 for TECHNIQUE_FACES
  int GetNumberOfSkippedProps() const;         ///< lines of GetSkippedProp()
  std::string GetSkippedProp(int index) const; ///< "name: reason", or "" when there is no such index
  double GetSceneMilliseconds() const;         ///< mirroring props, adjacency
  double GetEdgeMilliseconds() const;          ///< facing, and finding the edges that are lines
  double GetDepthMilliseconds() const;         ///< pass 1
  double GetLineMilliseconds() const;          ///< pass 2
  double GetBlendMilliseconds() const;         ///< lines over the scene
  ///@}

  /**
   * Bytes that the adjacency, the topology-aware meshes and the GL buffers and targets of this pass hold now.
   */
  vtkIdType GetMemorySize() const;

  /**
   * Copies the line mask of the last rendering into an image: one 8-bit component, as large as the renderer,
   * 255 where the pixel's centre is not farther than half the width from a visible part of an edge, 0
   * elsewhere.
   *
   * @return false, with an error, when nothing has been rendered
   */
  bool GetLineMask(vtkImageData* image);

  ///@{
  /**
   * Called by VTK.
   */
  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkSilhouettePass();
  ~vtkSilhouettePass() override;

private:
  vtkSilhouettePass(const vtkSilhouettePass&) = delete;
  void operator=(const vtkSilhouettePass&) = delete;

  void RenderPart(vtkRenderPass* pass, const vtkRenderState* s);
  void RenderScene(const vtkRenderState* s, vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window);
  void RenderDelegate(const vtkRenderState* s, vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window);

  bool LinesOnly = false;
  double LineWidth = 2.0;
  double Color[3] = {0.0, 0.0, 0.0};
  bool HiddenEdges = false;
  double HiddenColor[3] = {0.5, 0.5, 0.5};
  double HiddenOpacity = 0.4;
  bool SilhouetteEdges = true;
  bool BorderEdges = true;
  bool CreaseEdges = false;
  double FeatureAngle = 60.0;
  bool Smooth = true;
  int Technique = TECHNIQUE_RECTANGLES;
  bool LeaveOutFlatFaces = true;
  bool SplitLargeFaces = true;
  int DepthScale = 0;
  double WeldTolerance = 0.0;
  bool MeasureStages = false;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
