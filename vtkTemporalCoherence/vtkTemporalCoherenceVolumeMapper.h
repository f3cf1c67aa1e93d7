// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceVolumeMapper
 * @brief   ray casts volumes on the CPU and re-uses earlier frames
 *
 * This mapper draws the isosurfaces of images and of rectilinear, curvilinear (vtkStructuredGrid),
 * explicit structured, unstructured and adaptive grids, and of blocks of these. It is a
 * vtkGPUVolumeRayCastMapper and can replace one in a vtkVolume, but it needs no GPU. The isovalues
 * are those of vtkVolumeProperty::GetIsoSurfaceValues(). The property's transfer functions give
 * each surface its colour and opacity. It keeps the last frames of each viewer and does only what a
 * change requires.
 *
 * Images, rectilinear grids and blocks of images can also be blended: SetBlendModeToComposite(),
 * ToMaximumIntensity(), ToMinimumIntensity(), ToAverageIntensity() and ToAdditive(). Then no
 * isovalue is needed. A picture is what ever denser samples lead to (SetSampleDistance(0), the
 * default), and rays end at opaque props.
 *
 * Documentation/Mapper.md has the details and limits of all settings. It defines the terms that
 * are used here (such as voxel). The image cache and the isomap are those of "Accelerating Volume
 * Visualization by Exploiting Temporal Coherence".
 *
 * @sa vtkTemporalCoherenceVolume vtkTemporalCoherencePicker vtkTemporalCoherencePaperMapper
 * vtkTemporalCoherenceDropInMapper
 */

#ifndef vtkTemporalCoherenceVolumeMapper_h
#define vtkTemporalCoherenceVolumeMapper_h

#include "vtkTemporalCoherenceModule.h" // For export macro
#include "vtkTemporalCoherencePaperMapper.h"

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkPolyData;
class vtkRenderer;
class vtkVolume;
class vtkWindow;

class VTKTEMPORALCOHERENCE_EXPORT VTK_MARSHALAUTO vtkTemporalCoherenceVolumeMapper
  : public vtkTemporalCoherencePaperMapper
{
public:
  static vtkTemporalCoherenceVolumeMapper* New();
  vtkTypeMacro(vtkTemporalCoherenceVolumeMapper, vtkTemporalCoherencePaperMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SurfaceModes
  {
    CROSSING = 0,
    THRESHOLD = 1
  };

  //@{
  /**
   * Set/Get which crossings of an isovalue are drawn. CROSSING (default): the first one on a ray,
   * in either direction. THRESHOLD, as in the paper: the first point where the field is at least
   * the isovalue. The solid is capped wherever it is cut.
   */
  vtkSetClampMacro(SurfaceMode, int, CROSSING, THRESHOLD);
  vtkGetMacro(SurfaceMode, int);
  void SetSurfaceModeToCrossing() { this->SetSurfaceMode(CROSSING); }
  void SetSurfaceModeToThreshold() { this->SetSurfaceMode(THRESHOLD); }
  //@}

  enum VectorModes
  {
    DISABLED = -1,
    MAGNITUDE = 0,
    COMPONENT = 1
  };

  //@{
  /**
   * Set/Get which scalar is drawn if the array has several components. DISABLED (default): the one
   * that the volume's property selects. MAGNITUDE: the Euclidean length of each tuple. COMPONENT:
   * the component VectorComponent (default: 0). It is an error if there is no such component.
   */
  vtkSetClampMacro(VectorMode, int, DISABLED, COMPONENT);
  vtkGetMacro(VectorMode, int);
  void SetVectorModeToDisabled() { this->SetVectorMode(DISABLED); }
  void SetVectorModeToMagnitude() { this->SetVectorMode(MAGNITUDE); }
  void SetVectorModeToComponent() { this->SetVectorMode(COMPONENT); }
  vtkSetMacro(VectorComponent, int);
  vtkGetMacro(VectorComponent, int);
  //@}

  //@{
  /**
   * Set/Get where normals of meshes come from: the gradient in the cell that is hit (off, default),
   * which has facets, or gradients that are averaged at the points (on), which is smooth. And the
   * most memory to set up a mesh with, in MiB. Default: 0, no limit.
   */
  vtkSetMacro(AveragedGradients, vtkTypeBool);
  vtkGetMacro(AveragedGradients, vtkTypeBool);
  vtkBooleanMacro(AveragedGradients, vtkTypeBool);
  vtkSetClampMacro(MeshMemoryLimit, int, 0, VTK_INT_MAX);
  vtkGetMacro(MeshMemoryLimit, int);
  //@}

  //@{
  /**
   * Switch the image cache on or off (default: on), and set how many images it keeps for each
   * viewer, 1 (default) to 64. With it, frames of another time step and, unless ReuseAccuracy is
   * EXACT, of a moved camera may start from an earlier picture. Without it, they are cold.
   */
  vtkSetMacro(ImageCache, vtkTypeBool);
  vtkGetMacro(ImageCache, vtkTypeBool);
  vtkBooleanMacro(ImageCache, vtkTypeBool);
  vtkSetClampMacro(NumberOfCachedImages, int, 1, 64);
  vtkGetMacro(NumberOfCachedImages, int);
  //@}

  enum ReuseAccuracies
  {
    BOUNDED = 0,
    EXACT = 1,
    PAPER = 2 ///< for comparison with the paper; applications do not need it
  };

  //@{
  /**
   * Set/Get how exact a frame is after the view has changed. EXACT (default): the cold picture,
   * byte for byte. BOUNDED: at most 0.01 % of the pixels differ from the cold picture in the median
   * frame, and at most 0.05 % in any frame. A pixel differs if only one picture shows a surface
   * there, or if the surfaces are more than a voxel (the shortest edge of a cell) apart. It starts
   * from a cached image only where that is faster, which is not where cold frames go by tile beams.
   * PAPER: the published method; silhouettes erode a little in every frame. RefineWhenStill
   * (default: on) makes the next frame of the view exact if this one is not.
   */
  vtkSetClampMacro(ReuseAccuracy, int, BOUNDED, PAPER);
  vtkGetMacro(ReuseAccuracy, int);
  void SetReuseAccuracyToBounded() { this->SetReuseAccuracy(BOUNDED); }
  void SetReuseAccuracyToExact() { this->SetReuseAccuracy(EXACT); }
  void SetReuseAccuracyToPaper() { this->SetReuseAccuracy(PAPER); }
  vtkSetMacro(RefineWhenStill, vtkTypeBool);
  vtkGetMacro(RefineWhenStill, vtkTypeBool);
  vtkBooleanMacro(RefineWhenStill, vtkTypeBool);
  //@}

  //@{
  /**
   * Switch the isomap on or off (default: on). With it, a new isovalue in the same view is looked
   * up, tile by tile. Without it, it makes a cold frame. The picture is the same.
   *
   * - IsomapTolerance: the largest distance between a surface that is looked up and the exact one,
   *   in voxels (finite). Default: 0, the cold picture byte for byte. Below 0.001 it counts as 0,
   *   and so it does for translucent surfaces.
   * - IsomapRange: the isovalues for which it is built at once. Default: none (lo > hi).
   * - IsomapMemoryLimit: its memory for each viewer, in MiB. Default: 256; 0 switches it off. The
   *   least recently used bands are dropped. Outside of the range, 32 bytes a pixel are the limit.
   */
  vtkSetMacro(Isomap, vtkTypeBool);
  vtkGetMacro(Isomap, vtkTypeBool);
  vtkBooleanMacro(Isomap, vtkTypeBool);
  virtual void SetIsomapTolerance(double voxels);
  vtkGetMacro(IsomapTolerance, double);
  vtkSetVector2Macro(IsomapRange, double);
  vtkGetVector2Macro(IsomapRange, double);
  vtkSetClampMacro(IsomapMemoryLimit, int, 0, VTK_INT_MAX);
  vtkGetMacro(IsomapMemoryLimit, int);
  //@}

  //@{
  /**
   * Set the distance between rays in windows, in pixels along each axis: 0.1 to 100, default 1. NaN
   * is an error. AutoAdjustSampleDistances (default: off) chooses it, between the minimum (default
   * 1) and the maximum (default 10), to fit a frame into vtkVolume::GetAllocatedRenderTime().
   */
  void SetImageSampleDistance(float pixels) override;
  void SetMinimumImageSampleDistance(float pixels) override;
  void SetMaximumImageSampleDistance(float pixels) override;
  //@}

  //@{
  /** Warn once if all samples lie on one side of each isovalue: nothing is seen. Default: on. */
  vtkSetClampMacro(WarnOfIsovalues, vtkTypeBool, 0, 1);
  vtkGetMacro(WarnOfIsovalues, vtkTypeBool);
  vtkBooleanMacro(WarnOfIsovalues, vtkTypeBool);
  //@}

  /**
   * Build the isomap of the present view before a new isovalue needs it. The size of the picture is
   * that of the renderer's window or, without a window, that of the last frame. The last frame is
   * kept. Documentation/Mapper.md tells how to observe and to stop it.
   * @return true if there is an isomap for the present isovalues afterwards
   */
  bool BuildIsomap(vtkRenderer* renderer, vtkVolume* volume);

  /** Free all pictures and structures that are kept. The next frame is cold. */
  void ReleaseReuse();

  /** Bits that select point arrays of a frame. In parentheses: where there is no surface. */
  enum FrameArrays
  {
    FRAME_COLOR = 1,          ///< Color: unsigned char RGBA, multiplied by alpha (0)
    FRAME_DEPTH = 2,          ///< Depth: float, world distance along the ray (infinity)
    FRAME_NORMALS = 4,        ///< Normals: three floats, unit normal in the world (0)
    FRAME_ISOVALUE_INDEX = 8, ///< IsovalueIndex: int, index in GetIsoSurfaceValues() (-1)
    FRAME_ANSWER = 16,        ///< Answer: unsigned char, how the ray was answered (any)
    FRAME_ALL = 31            ///< all of these
  };

  //@{
  /**
   * Render without a window or an OpenGL context. The picture becomes the last frame.
   * @param renderer     has the camera and the lights; the volume need not be in it
   * @param volume       has the transform and the property; its mapper is not used
   * @param width,height pixels in a row, and rows, at least 1; row 0 is the bottom row
   * @param color,depth  get the arrays Color and Depth of FrameArrays, or may be null
   * @param frame        gets all FrameArrays
   * @return false after an error, or if the frame was stopped. The images are then unchanged.
   */
  bool RenderToImage(vtkRenderer* renderer, vtkVolume* volume, int width, int height,
    vtkImageData* color, vtkImageData* depth);
  bool RenderToImage(
    vtkRenderer* renderer, vtkVolume* volume, int width, int height, vtkImageData* frame);
  //@}

  /**
   * Get the last frame, whether it was made for a window or for an image.
   * @param frame  gets these point arrays and nothing else
   * @param arrays a sum of FrameArrays, FRAME_ALL (default), or 0, which sets the size only
   * @return false if there is no frame, or after an error. The image is then unchanged.
   */
  bool GetLastFrame(vtkImageData* frame, int arrays = FRAME_ALL);

  //@{
  /**
   * Get the last frame as vtkGPUVolumeRayCastMapper gives it: RGBA bytes with colours multiplied by
   * alpha, or depth-buffer values. The image is unchanged if there is no frame, or after an error.
   */
  void GetColorImage(vtkImageData* image) override;
  void GetDepthImage(vtkImageData* image) override;
  //@}

  /**
   * Get the surface that the last frame shows: a point and a vertex for each pixel with a surface.
   * Its point arrays are Normals, IsovalueIndex, Color and Isovalue (double). A blended volume has
   * no surface, which is an error.
   * @return false if there is no frame, or after an error. The points are then unchanged.
   */
  bool GetVisibleSurface(vtkPolyData* points);

  /**
   * Get what the last frame shows at a pixel; (0, 0) is at the lower left. Position and normal are
   * in world coordinates; the normal is a unit vector and faces the viewer. Each may be null. Of a
   * blended volume, the position is where the ray first sees anything. The normal is that of the
   * gradient there in COMPOSITE_BLEND, else 0, as with several independent components. The index is
   * -1.
   * @return false if there is no surface, no such pixel or no frame. Nothing is written then.
   */
  bool PickPixel(int x, int y, double position[3], double normal[3], int* isovalueIndex);

  /**
   * Get the cell of a mesh in which the last frame shows a surface at a pixel, and the flat index
   * of its block, which is 0 without blocks, and may be null. Python passes a list, [0], or None.
   * @return -1 if there is no surface or no mesh. Nothing is written then.
   */
  vtkIdType PickCell(int x, int y, unsigned int* block);

  /**
   * Find the first surface on the line from p1 to p2 in world coordinates. No frame is needed, and
   * the last frame is kept. The line begins at p1 as a ray does at the near plane.
   * @param t gets the share of the way from p1 to p2 at which the surface is met, 0 to 1. The other
   *          results are as in PickPixel(); the normal faces p1.
   * @return false if there is no surface, or after an error. Nothing is written then.
   */
  bool IntersectWithLine(vtkVolume* volume, const double p1[3], const double p2[3], double& t,
    double position[3], double normal[3], int* isovalueIndex);

  /** The ways to make a frame. */
  enum Routes
  {
    ROUTE_COLD,            ///< every ray is traced without help from an earlier frame
    ROUTE_REDISPLAY,       ///< nothing changed: the last picture is shown again
    ROUTE_RESHADE,         ///< only colours, lights or shading changed: known hits are shaded again
    ROUTE_ISOMAP_LOOKUP,   ///< a new isovalue is looked up in the isomap of the view
    ROUTE_ISOMAP_BUILD,    ///< the same, where some tiles are built or traced
    ROUTE_IMAGE_CACHE = 6, ///< the view changed: rays start from what a cached image shows
    ROUTE_TIME_STEP,       ///< samples changed: pixels that no changed sample affects are copied
    ROUTE_RECOMPOSITE,     ///< only opacities changed: known layers are composited again
    ROUTE_KEEP_VALUES = 10 ///< colours of a projection changed: what rays have met is known
  };

  //@{
  /**
   * Get the route of the last frame: one of Routes, or its name: Cold, Redisplay, Reshade,
   * IsomapLookup, IsomapBuild, ImageCache, TimeStep, Recomposite or KeepValues.
   */
  int GetRoute();
  const char* GetRouteAsString();
  //@}

  //@{
  /**
   * Get counters and times (in seconds) of the last frame, and the memory (in bytes) and the knots
   * of its isomap. FrameTime includes the other times. After BuildIsomap(), IsomapBuildTime is its
   * own time. Documentation/Mapper.md explains them all.
   */
  vtkIdType GetNumberOfRays();
  vtkIdType GetNumberOfDefiniteHits();
  vtkIdType GetNumberOfDefiniteMisses();
  vtkIdType GetNumberOfPossibleHits();
  vtkIdType GetNumberOfTracedRays();
  vtkIdType GetNumberOfFieldSamples();
  vtkIdType GetNumberOfLayers();
  vtkIdType GetNumberOfMergedLayers();
  vtkIdType GetIsomapMemory();
  vtkIdType GetNumberOfIsomapKnots();
  double GetFrameTime();
  double GetTraceTime();
  double GetQueryTime();
  double GetIsomapBuildTime();
  double GetShadeTime();
  double GetPresentTime();
  //@}

  /** What the last frame had to do to set up its mesh. */
  enum MeshSetUps
  {
    MESH_NONE,       ///< the input is no mesh
    MESH_KEPT,       ///< nothing
    MESH_NEW_VALUES, ///< only read new values
    MESH_REFITTED,   ///< bound the same cells with new points
    MESH_BUILT       ///< order new cells
  };

  //@{
  /**
   * Get what the last frame had to do to set up its mesh: one of MeshSetUps, the time in seconds,
   * and the memory of what is kept, in bytes; and whether scalars of cells were averaged to points.
   * Curved cells (quadratic, Lagrange, Bezier) are divided into linear ones: MeshPointError bounds
   * how far these are from the curved ones, in parts of the cell's diagonal, and MeshValueError how
   * much values differ, in parts of their range in the cell; NaN where samples between corners are
   * not finite. Both are 0 without curved cells: the
   * surface in polyhedra, prisms and convex sets of points is defined as that of their parts.
   */
  int GetMeshSetUp();
  double GetMeshSetUpTime();
  vtkIdType GetMeshMemory();
  bool GetScalarsWereAveraged();
  double GetMeshPointError();
  double GetMeshValueError();
  //@}

  /** Set the data to draw without a pipeline: an image or a grid. */
  void SetInputData(vtkDataSet* data) override;

  //@{
  /** Get the bounds of the input in its own coordinates; for blocks, the bounds of all of them. */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  //@}

  /**
   * Return true if everything that this mapper draws of the volume is opaque: no isovalue has a
   * scalar opacity between 0 and 1, and there is no gradient opacity. Blended volumes are not.
   */
  bool IsOpaque(vtkVolume* volume);

  //@{
  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Draw into the renderer's window. Free the textures of a window, or of all windows (null).
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  //@}

protected:
  vtkTemporalCoherenceVolumeMapper();
  ~vtkTemporalCoherenceVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkTemporalCoherenceVolumeMapper(const vtkTemporalCoherenceVolumeMapper&) = delete;
  void operator=(const vtkTemporalCoherenceVolumeMapper&) = delete;

  int SurfaceMode = CROSSING;
  int VectorMode = DISABLED;
  int VectorComponent = 0;
  vtkTypeBool AveragedGradients = 0;
  int MeshMemoryLimit = 0;
  vtkTypeBool ImageCache = 1;
  int NumberOfCachedImages = 1;
  int ReuseAccuracy = EXACT;
  vtkTypeBool RefineWhenStill = 1;
  vtkTypeBool Isomap = 1;
  double IsomapTolerance = 0.0;
  double IsomapRange[2] = { 1.0, 0.0 };
  int IsomapMemoryLimit = 256;
  vtkTypeBool WarnOfIsovalues = 1;

  struct Internals;
  std::unique_ptr<Internals> Internal;
  friend class vtkTemporalCoherencePicker;                 // finds cells
  friend class vtkTemporalCoherenceGPUVolumeRayCastMapper; // asks why a frame would be refused
};
VTK_ABI_NAMESPACE_END

#endif
