// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceVolumeMapper
 * @brief   ray casts isosurfaces on the CPU and re-uses earlier frames
 *
 * This mapper draws the isosurfaces of a vtkImageData, of a vtkRectilinearGrid, or of composite
 * data whose blocks are images on one lattice. It is a vtkGPUVolumeRayCastMapper and can replace
 * one in a vtkVolume, but it needs no GPU:
 *
 * @code
 * mapper->SetInputConnection(reader->GetOutputPort());
 * volume->SetMapper(mapper);
 * volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 60.0);
 * volume->GetProperty()->SetInterpolationTypeToLinear();
 * volume->GetProperty()->ShadeOn();
 * renderer->AddVolume(volume);
 * @endcode
 *
 * The isovalues are those of vtkVolumeProperty::GetIsoSurfaceValues(). Each surface has the colour
 * and the opacity that the property's transfer functions have at its isovalue. No triangles are
 * extracted: every ray is intersected exactly with the trilinear (or nearest-neighbour) interpolant
 * of the samples. Every pixel has a depth, so that other props intersect the surface correctly. The
 * picture does not depend on the number of threads.
 *
 * The mapper keeps the last frames of each viewer and does only what a change requires. If only
 * colours changed, it shades the known hits again. If the view changed, rays start from the last
 * picture. If an isovalue changed, it is looked up in an isomap of the view. If nothing can be
 * re-used, the frame is cold: every ray is traced. GetRoute() tells which of these happened.
 *
 * Documentation/Mapper.md has the details: input, opacity, cropping, masks, light, events, memory,
 * bounds of settings, errors. The image cache and the isomap are those of "Accelerating Volume
 * Visualization by Exploiting Temporal Coherence". The intersection is that of Marmitt et al.,
 * "Fast and Accurate Ray-Voxel Intersection Techniques for Iso-Surface Ray Tracing", 2004.
 *
 * @sa vtkTemporalCoherenceDropInMapper vtkTemporalCoherenceVolume vtkTemporalCoherencePicker
 */

#ifndef vtkTemporalCoherenceVolumeMapper_h
#define vtkTemporalCoherenceVolumeMapper_h

#include "vtkTemporalCoherenceDropInMapper.h"
#include "vtkTemporalCoherenceModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;
class vtkVolume;
class vtkWindow;

class VTKTEMPORALCOHERENCE_EXPORT VTK_MARSHALAUTO vtkTemporalCoherenceVolumeMapper
  : public vtkTemporalCoherenceDropInMapper
{
public:
  static vtkTemporalCoherenceVolumeMapper* New();
  vtkTypeMacro(vtkTemporalCoherenceVolumeMapper, vtkTemporalCoherenceDropInMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SurfaceModes
  {
    CROSSING = 0,
    THRESHOLD = 1
  };

  //@{
  /**
   * Set/Get which crossings of an isovalue are drawn.
   *
   * CROSSING (default): the first point along the ray where the field crosses the isovalue, in
   * either direction, as in vtkGPUVolumeRayCastMapper. Surfaces are open where the volume ends.
   *
   * THRESHOLD, as in the paper: the first point where the field is at least the isovalue. The solid
   * is capped wherever it is cut: by the boundary, a plane, or hidden cells.
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
   * Set/Get which scalar is drawn if the array has several components, as in vtkSmartVolumeMapper.
   *
   * DISABLED (default): the volume's property decides. Of independent components, the one with the
   * largest weight is drawn; of dependent components, component 0. MAGNITUDE: the Euclidean length
   * of each tuple. COMPONENT: the component VectorComponent (default 0); an error if there is none.
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
   * Switch the image cache on or off (default: on), and set how many images it keeps for each
   * viewer, 1 (default) to 64. With it, the frame of a moved camera starts from the cached image
   * with the nearest view, and the frame of another time step copies what shows no changed sample.
   * Without it, both frames are cold. Each image takes 36 bytes per pixel.
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
    PAPER = 2
  };

  //@{
  /**
   * Set/Get how exact a frame is after the view has changed. Documentation/Mapper.md has more.
   *
   * BOUNDED (default): at most 0.01 % of the pixels differ from the cold picture in the median
   * frame, and at most 0.05 % in any frame. The error does not grow from frame to frame.
   *
   * EXACT: the cold picture, byte for byte. It costs as much as a cold frame.
   *
   * PAPER: the published method, for comparison. Silhouettes erode a little with every frame.
   *
   * RefineWhenStill (default: on): if the last picture is not exact, the next frame of the same
   * view is cold, once. Pictures from the image cache are not exact, nor are pictures from an
   * isomap with a tolerance or with interpolated normals.
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
   * Switch the isomap on or off (default: on), and set how it is built. An isomap knows where each
   * pixel's ray first passes each isovalue, so that a new isovalue in the same view is looked up.
   * It is built when isovalues first change in a view. Without it, the last hits bound the search
   * for the new isovalue. The picture is the same. Documentation/Mapper.md has more.
   *
   * IsomapTolerance: the largest distance in voxels between a surface that is looked up and the
   * exact one. Default: 0, the cold picture byte for byte. Values below 0.001 count as 0. NaN is an
   * error.
   *
   * IsomapRange: the isovalues for which it is built at once. Default: none (lo > hi); it is then
   * built in bands around the present isovalues.
   *
   * IsomapMemoryLimit: the memory that it may use for each viewer, in MiB. Default: 256. Bands that
   * were used least are dropped, with one warning. 0 switches the isomap off.
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
   * Set the distance between rays in windows, in pixels along each axis, 0.1 to 100. Default: 1,
   * one ray per pixel. Above 1, frames are coarser; below 1, a pixel shows the mean of its rays.
   *
   * AutoAdjustSampleDistances (default: off) chooses it between MinimumImageSampleDistance
   * (default: 1) and MaximumImageSampleDistance (default: 10), so that a frame fits into
   * vtkVolume::GetAllocatedRenderTime(). Values are clamped; NaN is an error. See
   * Documentation/Mapper.md.
   */
  void SetImageSampleDistance(float pixels) override;
  void SetMinimumImageSampleDistance(float pixels) override;
  void SetMaximumImageSampleDistance(float pixels) override;
  //@}

  //@{
  /**
   * Warn once if the isovalues are such that no surface can be seen: all of them lie outside of the
   * range of the samples or at its lower end. Default: on. Documentation/Mapper.md has more.
   */
  vtkSetClampMacro(WarnOfIsovalues, vtkTypeBool, 0, 1);
  vtkGetMacro(WarnOfIsovalues, vtkTypeBool);
  vtkBooleanMacro(WarnOfIsovalues, vtkTypeBool);
  //@}

  /**
   * Build the isomap of the present view before a new isovalue needs it: for IsomapRange if that
   * holds the isovalues, else for a band around each of them. The size of the picture is that of
   * the renderer's window or, without a window, that of the last frame. The last frame stays.
   *
   * ProgressEvent tells the share of a band that is done. The render window's CheckAbortStatus()
   * and SetAbortExecute() stop the call.
   * @return true if there is an isomap for the present isovalues afterwards
   */
  bool BuildIsomap(vtkRenderer* renderer, vtkVolume* volume);

  /** Free all pictures and structures that are kept. The next frame is cold. */
  void ReleaseReuse();

  /** The point arrays of a frame, as bits. In brackets: what they hold where nothing is hit. */
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
   * Render without a render window or an OpenGL context, on any machine. Only the volume is drawn.
   * The picture becomes the last frame, as after Render(). Row 0 of the images is the bottom row.
   * @param renderer has the camera and the lights. If no light is on, a headlight is used, unless
   *                 AutomaticLightCreation is off. The volume need not be in the renderer.
   * @param volume   has the transform and the property; its mapper is not used
   * @param width    pixels in a row, at least 1
   * @param height   rows, at least 1
   * @param color    gets the array Color of FrameArrays, or may be null
   * @param depth    gets the array Depth, or may be null
   * @param frame    gets all arrays of FrameArrays
   * @return false after an error, or if the frame was stopped. The images are then unchanged.
   */
  bool RenderToImage(vtkRenderer* renderer, vtkVolume* volume, int width, int height,
    vtkImageData* color, vtkImageData* depth);
  bool RenderToImage(
    vtkRenderer* renderer, vtkVolume* volume, int width, int height, vtkImageData* frame);
  //@}

  /**
   * Get the last frame, which was made for a window or an image. Documentation/Mapper.md describes
   * the arrays Color, Depth, Normals, IsovalueIndex and Answer.
   * @param frame  gets these point arrays and nothing else. The first one is the active scalars.
   * @param arrays a sum of FrameArrays, or FRAME_ALL (default)
   * @return false if there is no frame, or after an error. The image is then unchanged.
   */
  bool GetLastFrame(vtkImageData* frame, int arrays = FRAME_ALL);

  //@{
  /**
   * Get the last frame as vtkGPUVolumeRayCastMapper gives it: RGBA bytes with colours multiplied by
   * alpha, or depth-buffer values from 0 (near plane) to 1 (far plane). The image is unchanged if
   * there is no frame or not enough memory. Documentation/Mapper.md has more.
   */
  void GetColorImage(vtkImageData* image) override;
  void GetDepthImage(vtkImageData* image) override;
  //@}

  /**
   * Get the surface that the last frame shows: a point and a vertex for each pixel with a surface.
   * @param points gets world positions (double) and the point arrays Normals (float, active
   *               normals: unit, in world coordinates, facing the viewer), Isovalue (double),
   *               IsovalueIndex (int, index in vtkVolumeProperty::GetIsoSurfaceValues()) and Color
   *               (unsigned char RGBA, active scalars)
   * @return false if there is no frame or not enough memory. The points are then unchanged.
   */
  bool GetVisibleSurface(vtkPolyData* points);

  /**
   * Get what the last frame shows at a pixel of the viewport or image; (0, 0) is at the lower left.
   * @param position      world position of the surface
   * @param normal        unit normal in world coordinates, facing the viewer
   * @param isovalueIndex index in vtkVolumeProperty::GetIsoSurfaceValues(). Any of these three may
   *                      be null.
   * @return false if there is no surface, no such pixel or no frame. Nothing is written then.
   */
  bool PickPixel(int x, int y, double position[3], double normal[3], int* isovalueIndex);

  /**
   * Find the first surface on the line from p1 to p2, as a frame does for a ray. No frame or window
   * is needed, and the last frame stays. The first call for new data may read all samples once.
   * @param volume        has the transform and the property; its mapper is not used
   * @param p1            world position where the line begins, as a ray does at the near plane
   * @param p2            world position where the line ends; must differ from p1
   * @param t             share of the way from p1 to p2 at which the surface is met, 0 to 1
   * @param position      world position of the surface
   * @param normal        unit normal in world coordinates, facing p1
   * @param isovalueIndex index in vtkVolumeProperty::GetIsoSurfaceValues(). Any of these last three
   *                      may be null.
   * @return false if there is no surface, or after an error. Nothing is written then.
   */
  bool IntersectWithLine(vtkVolume* volume, const double p1[3], const double p2[3], double& t,
    double position[3], double normal[3], int* isovalueIndex);

  /** The ways to make a frame. */
  enum Routes
  {
    ROUTE_COLD,           ///< every ray is traced without help from an earlier frame
    ROUTE_REDISPLAY,      ///< nothing changed: the last picture is shown again
    ROUTE_RESHADE,        ///< only colours, lights or shading changed: known hits are shaded again
    ROUTE_ISOMAP_LOOKUP,  ///< a new isovalue is looked up in the isomap of the view
    ROUTE_ISOMAP_BUILD,   ///< the same, after a band of the isomap was built
    ROUTE_THRESHOLD_HINT, ///< without an isomap: last hits bound the search for a new isovalue
    ROUTE_IMAGE_CACHE,    ///< the view changed: rays start from what a cached image shows
    ROUTE_TIME_STEP       ///< samples changed: what shows no changed sample is copied
  };

  //@{
  /**
   * Get the route of the last frame: one of Routes, or its name: Cold, Redisplay, Reshade,
   * IsomapLookup, IsomapBuild, ThresholdHint, ImageCache or TimeStep.
   */
  int GetRoute();
  const char* GetRouteAsString();
  //@}

  //@{
  /**
   * Get counters and times of the last frame, and the memory (in bytes) and the knots of its
   * isomap. Rays are the sum of definite hits, definite misses and possible hits. Times are in
   * seconds; the frame's time includes the others. Documentation/Mapper.md has more.
   */
  vtkIdType GetNumberOfRays();
  vtkIdType GetNumberOfDefiniteHits();
  vtkIdType GetNumberOfDefiniteMisses();
  vtkIdType GetNumberOfPossibleHits();
  vtkIdType GetNumberOfTracedRays();
  vtkIdType GetNumberOfFieldSamples();
  vtkIdType GetIsomapMemory();
  vtkIdType GetNumberOfIsomapKnots();
  double GetFrameTime();
  double GetTraceTime();
  double GetQueryTime();
  double GetIsomapBuildTime();
  double GetShadeTime();
  double GetPresentTime();
  //@}

  //@{
  /** Get the bounds of the input in its own coordinates; for blocks, the bounds of all of them. */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  //@}

  /**
   * Return true if all that this mapper shows of the volume is opaque: no isovalue has a scalar
   * opacity between 0 and 1, and there is no gradient opacity.
   */
  bool IsOpaque(vtkVolume* volume);

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Draw the volume into the renderer's window.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Free the textures and shaders of a window, or of all windows if it is null. What later frames
   * can re-use stays.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  // For comparison with the paper (applications need none of these) -----------------------------

  enum ImageCachePolicies
  {
    LATEST = 0,
    KEY_IMAGE = 1
  };

  enum ImageCacheShadings
  {
    CACHE_RESHADE = 0,
    CACHE_INTERPOLATE = 1
  };

  enum IsomapShadings
  {
    RESHADE = 0,
    INTERPOLATE = 1
  };

  //@{
  /**
   * Set/Get which frames the image cache keeps. LATEST (default): every frame. KEY_IMAGE: cold
   * frames only, one of which is made every KeyImageInterval frames (default: 7, as in the paper).
   */
  vtkSetClampMacro(ImageCachePolicy, int, LATEST, KEY_IMAGE);
  vtkGetMacro(ImageCachePolicy, int);
  void SetImageCachePolicyToLatest() { this->SetImageCachePolicy(LATEST); }
  void SetImageCachePolicyToKeyImage() { this->SetImageCachePolicy(KEY_IMAGE); }
  vtkSetClampMacro(KeyImageInterval, int, 1, VTK_INT_MAX);
  vtkGetMacro(KeyImageInterval, int);
  //@}

  //@{
  /**
   * Set/Get how known hits are shaded. RESHADE (default) computes their normals and colours from
   * the field. INTERPOLATE interpolates stored values, which is faster, but not exact.
   *
   * ImageCacheShading is for definite hits with PAPER. INTERPOLATE takes their colours from the
   * cached image, so that blur and old lighting move with the surface.
   *
   * IsomapShading is for hits that are looked up in the isomap. INTERPOLATE takes their normals
   * from the isomap's knots, which may lie voxels apart.
   */
  vtkSetClampMacro(ImageCacheShading, int, CACHE_RESHADE, CACHE_INTERPOLATE);
  vtkGetMacro(ImageCacheShading, int);
  void SetImageCacheShadingToReshade() { this->SetImageCacheShading(CACHE_RESHADE); }
  void SetImageCacheShadingToInterpolate() { this->SetImageCacheShading(CACHE_INTERPOLATE); }
  vtkSetClampMacro(IsomapShading, int, RESHADE, INTERPOLATE);
  vtkGetMacro(IsomapShading, int);
  void SetIsomapShadingToReshade() { this->SetIsomapShading(RESHADE); }
  void SetIsomapShadingToInterpolate() { this->SetIsomapShading(INTERPOLATE); }
  //@}

  //@{
  /**
   * ColorByAnswer paints surfaces yellow that the image cache did not help to find, as in figure 8
   * of the paper. Default: off. It affects frames of the route ImageCache only.
   *
   * SpaceLeaping skips blocks of cells that hold none of the isovalues. Default: on. Without it, a
   * ray reads every cell on its way, as in the paper's plain ray caster. The picture is the same.
   */
  vtkSetMacro(ColorByAnswer, vtkTypeBool);
  vtkGetMacro(ColorByAnswer, vtkTypeBool);
  vtkBooleanMacro(ColorByAnswer, vtkTypeBool);
  vtkSetMacro(SpaceLeaping, vtkTypeBool);
  vtkGetMacro(SpaceLeaping, vtkTypeBool);
  vtkBooleanMacro(SpaceLeaping, vtkTypeBool);
  //@}

protected:
  vtkTemporalCoherenceVolumeMapper();
  ~vtkTemporalCoherenceVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkTemporalCoherenceVolumeMapper(const vtkTemporalCoherenceVolumeMapper&) = delete;
  void operator=(const vtkTemporalCoherenceVolumeMapper&) = delete;

  // Asks before it draws whether a frame would be refused.
  friend class vtkTemporalCoherenceGPUVolumeRayCastMapper;
  std::string WhyRefused(vtkRenderer* renderer, vtkVolume* volume);

  bool RenderFrame(vtkRenderer* renderer, vtkVolume* volume, int width, int height, double aspect,
    vtkRenderWindow* window);
  bool RenderToImages(vtkRenderer* renderer, vtkVolume* volume, int width, int height,
    vtkImageData* color, vtkImageData* depth, vtkImageData* frame);
  bool IsBusy(const char* method);
  void TellStart();
  bool RenderForWindow(vtkRenderer* renderer, vtkVolume* volume, int width, int height);
  void ReportOnce(const std::string& error);
  void WarnOfIsomapLimit(bool isTooLarge);
  void Warn(const std::string& warning);
  template <typename T>
  void SetWithin(const char* name, T value, double low, double high, T& setting);

  int SurfaceMode = CROSSING;
  int VectorMode = DISABLED;
  int VectorComponent = 0;
  vtkTypeBool ImageCache = 1;
  vtkTypeBool Isomap = 1;
  vtkTypeBool SpaceLeaping = 1;
  vtkTypeBool ColorByAnswer = 0;
  int ReuseAccuracy = BOUNDED;
  vtkTypeBool RefineWhenStill = 1;
  int ImageCachePolicy = LATEST;
  int KeyImageInterval = 7;
  int NumberOfCachedImages = 1;
  int ImageCacheShading = CACHE_RESHADE;
  double IsomapTolerance = 0.0;
  double IsomapRange[2] = { 1.0, 0.0 };
  int IsomapMemoryLimit = 256;
  int IsomapShading = RESHADE;
  vtkTypeBool WarnOfIsovalues = 1;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
