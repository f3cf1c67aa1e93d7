// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceVolumeMapper
 * @brief   ray casts volumes on the CPU and re-uses earlier frames
 *
 * This mapper draws the isosurfaces of images and of rectilinear, curvilinear (vtkStructuredGrid),
 * explicit structured, unstructured and adaptive grids, and of blocks of these. As a
 * vtkGPUVolumeRayCastMapper, it fits any vtkVolume, but needs no GPU. The isovalues are those of
 * vtkVolumeProperty::GetIsoSurfaceValues(). The property's transfer functions give each surface its
 * colour and opacity. It keeps the last frames of each viewer and does only what a change requires.
 *
 * Images, rectilinear grids and blocks of images can also be blended: SetBlendModeToComposite(),
 * ToMaximumIntensity(), ToMinimumIntensity(), ToAverageIntensity() and ToAdditive(). Then no
 * isovalue is needed. Pictures are converged: the limit of infinitely small sample distances. Rays
 * end at opaque props.
 *
 * A setting that names a choice, such as SurfaceMode, takes no other value: that is one error, and
 * the setting stays. Numbers are clamped to the range of their setting, as VTK does.
 *
 * Documentation/Mapper.md has the details and limits of all settings. It defines the terms that
 * are used here (such as voxel). The image cache and the isomap are those of "Accelerating Volume
 * Visualization by Exploiting Temporal Coherence".
 *
 * @sa vtkTemporalCoherenceVolume vtkTemporalCoherencePicker vtkTemporalCoherenceRefiner
 * vtkTemporalCoherenceStatistics
 * vtkTemporalCoherencePaperMapper vtkTemporalCoherenceDropInMapper
 */

#ifndef vtkTemporalCoherenceVolumeMapper_h
#define vtkTemporalCoherenceVolumeMapper_h

#include "vtkCommand.h"                 // For vtkCommand::UserEvent
#include "vtkSmartPointer.h"            // For tables of colours
#include "vtkTemporalCoherenceModule.h" // For export macro
#include "vtkTemporalCoherencePaperMapper.h"
#include "vtkTemporalCoherenceStatistics.h" // For the deprecated getters

#include <memory> // For std::unique_ptr
#include <string> // For the name of an array

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
class vtkPolyData;
class vtkRenderer;
class vtkScalarsToColors;
class vtkTemporalCoherenceBrickSource;
class vtkVolume;
class vtkWindow;

class VTKTEMPORALCOHERENCE_EXPORT VTK_MARSHALAUTO vtkTemporalCoherenceVolumeMapper
  : public vtkTemporalCoherencePaperMapper
{
public:
  static vtkTemporalCoherenceVolumeMapper* New();
  vtkTypeMacro(vtkTemporalCoherenceVolumeMapper, vtkTemporalCoherencePaperMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Values of SurfaceMode. */
  enum SurfaceModes
  {
    CROSSING = 0,
    THRESHOLD = 1,
    LABELS = 2
  };

  //@{
  /**
   * Set/Get which crossings of an isovalue are drawn. CROSSING (default): the first crossing on a
   * ray, in either direction. THRESHOLD, as in the paper: the first point where the field is at
   * least the isovalue. The solid is capped wherever it is cut. LABELS: samples of an image are
   * labels, whole numbers that name parts of it; isovalues have no effect. A label is drawn as a
   * solid, which is capped, too.
   */
  virtual void SetSurfaceMode(int mode);
  vtkGetMacro(SurfaceMode, int);
  void SetSurfaceModeToCrossing() { this->SetSurfaceMode(CROSSING); }
  void SetSurfaceModeToThreshold() { this->SetSurfaceMode(THRESHOLD); }
  void SetSurfaceModeToLabels() { this->SetSurfaceMode(LABELS); }
  //@}

  //@{
  /**
   * Set/Get how LABELS look. A label has the colour and the opacity of the LabelTable: a
   * vtkLookupTable with a value for each label, or another vtkScalarsToColors. Without a table
   * (null, default), they are those of the property's functions at the label's value. Labels with
   * an opacity of 0 and the OutsideLabel (default: 0) are not drawn. A label that the table lacks
   * is an error. Labels lie from -2147483647 to 2147483647; any number of them is drawn at once.
   *
   * LabelRadius: how far around a point surfaces between labels are smoothed, in samples, up to 8.
   * 0 (default): none, faces of voxels are seen. Labels that touch have one surface in common. It
   * lies within 0.75 samples of these faces, and no part of a label vanishes. Normals are those of
   * the labels smoothed by a Gaussian with this standard deviation; 2.5 removes most steps. Other
   * radii are clamped, and NaN is an error.
   */
  virtual void SetLabelTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetLabelTable();
  virtual void SetLabelRadius(double samples);
  vtkGetMacro(LabelRadius, double);
  vtkSetMacro(OutsideLabel, int);
  vtkGetMacro(OutsideLabel, int);
  //@}

  //@{
  /**
   * Set/Get which array gives surfaces their colours, of isosurfaces and labels alike. A new array,
   * table or range traces no rays, unless it makes surfaces visible for the first time.
   *
   * - ColorArrayName: an array of numbers on the points of the input or, with ColorArrayOnCells
   *   (default: off), on its cells. Null or "" (default): none, colours are those of isovalues. A
   *   missing array is an error, also in one block. Between points, its values are interpolated as
   *   the drawn ones; a cell has one value. Adaptive grids with several levels interpolate values
   *   of cells.
   * - ColorArrayComponent: of arrays with several components. Default: 0; -1: the length of the
   *   interpolated vector. A component that the array lacks is an error.
   * - ColorArrayOpacity: if on (default: off), the array gives opacities, too: that of a surface's
   *   isovalue or label is multiplied by the table's at the value. On without an array is an error.
   * - ColorTable: a vtkLookupTable or another vtkScalarsToColors, whose GetOpacity() counts with
   *   ColorArrayOpacity only. Null (default): the functions of the volume's property, for colour
   *   and scalar opacity.
   */
  vtkSetStdStringFromCharMacro(ColorArrayName);
  vtkGetCharFromStdStringMacro(ColorArrayName);
  vtkSetMacro(ColorArrayOnCells, vtkTypeBool);
  vtkGetMacro(ColorArrayOnCells, vtkTypeBool);
  vtkBooleanMacro(ColorArrayOnCells, vtkTypeBool);
  vtkSetClampMacro(ColorArrayComponent, int, -1, VTK_INT_MAX);
  vtkGetMacro(ColorArrayComponent, int);
  vtkSetMacro(ColorArrayOpacity, vtkTypeBool);
  vtkGetMacro(ColorArrayOpacity, vtkTypeBool);
  vtkBooleanMacro(ColorArrayOpacity, vtkTypeBool);
  virtual void SetColorTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetColorTable();
  //@}

  /**
   * Tell that samples of an image have changed in place, as by the stroke of a brush, and only
   * within an extent of points (or of cells, if the array is one of cells). Calls Modified() of the
   * array. May be called several times between two frames, and counts for all mappers of the image.
   * The next frame of LABELS then reads no other samples to find what changed, unless something
   * else was modified, too, or the image is a block of several. All other frames treat this as any
   * Modified().
   * @param image which mappers draw
   * @param extent of samples; what lies beyond the image does not count
   * @param array of the image; null (default): its active scalars, of points or else of cells
   * @return false, with a warning, if there is no such array
   */
  static bool ModifiedWithin(
    vtkImageData* image, const int extent[6], vtkDataArray* array = nullptr);

  /** Values of VectorMode. */
  enum VectorModes
  {
    DISABLED = -1,
    MAGNITUDE = 0,
    COMPONENT = 1
  };

  //@{
  /**
   * Set/Get which scalar is drawn if the array has several components. DISABLED (default): the
   * component that the volume's property selects. MAGNITUDE: the Euclidean length of each tuple.
   * COMPONENT: the component VectorComponent (default: 0). A missing component is an error.
   */
  virtual void SetVectorMode(int mode);
  vtkGetMacro(VectorMode, int);
  void SetVectorModeToDisabled() { this->SetVectorMode(DISABLED); }
  void SetVectorModeToMagnitude() { this->SetVectorMode(MAGNITUDE); }
  void SetVectorModeToComponent() { this->SetVectorMode(COMPONENT); }
  vtkSetMacro(VectorComponent, int);
  vtkGetMacro(VectorComponent, int);
  //@}

  //@{
  /**
   * Set/Get two settings of meshes. SmoothMeshNormals: off (default), normals are the gradients in
   * the cell that is hit, which shows facets; on, they are gradients averaged at the points.
   * MeshMemoryLimit: the most memory to set up a mesh, in MiB. Curved cells are divided less to
   * fit; larger meshes are an error. Default: 0, no limit; less is clamped to 0.
   */
  vtkSetMacro(SmoothMeshNormals, vtkTypeBool);
  vtkGetMacro(SmoothMeshNormals, vtkTypeBool);
  vtkBooleanMacro(SmoothMeshNormals, vtkTypeBool);
  vtkSetClampMacro(MeshMemoryLimit, int, 0, VTK_INT_MAX);
  vtkGetMacro(MeshMemoryLimit, int);
  //@}

  //@{
  /**
   * Set/Get ambient occlusion (default: off) of isosurfaces that the property shades. It darkens
   * hollows, so that a picture shows depth. Ambient and diffuse light are multiplied by
   * 1 - AmbientOcclusionStrength * (1 - open). "Open" is the share of the directions around the
   * normal, weighted by their cosines, in which no drawn surface lies within the radius; a
   * translucent surface counts by its opacity.
   *
   * - AmbientOcclusionRadius: in world units. 0 (default): an eighth of the data's longest edge.
   * - AmbientOcclusionStrength: 0 (no effect) to 1 (default).
   * - AmbientOcclusionRays: 1 (default) to 64 rays, sent from one of each four pixels in turn. A
   *   frame that differs in nothing from the last one sends 32 times as many from each pixel.
   *
   * Numbers beyond these ranges are clamped, and NaN is an error.
   *
   * The light of a surface is kept while the camera moves, and gets better from frame to frame.
   * GetFrameIsFinal() is true once each pixel has enough rays: 1024, or as few as 256 on evenly lit
   * surfaces. MakeImage() sends all of them at once.
   */
  vtkSetMacro(AmbientOcclusion, vtkTypeBool);
  vtkGetMacro(AmbientOcclusion, vtkTypeBool);
  vtkBooleanMacro(AmbientOcclusion, vtkTypeBool);
  virtual void SetAmbientOcclusionRadius(double radius);
  vtkGetMacro(AmbientOcclusionRadius, double);
  virtual void SetAmbientOcclusionStrength(double strength);
  vtkGetMacro(AmbientOcclusionStrength, double);
  vtkSetClampMacro(AmbientOcclusionRays, int, 1, 64);
  vtkGetMacro(AmbientOcclusionRays, int);
  //@}

  //@{
  /**
   * Set/Get whether lights cast shadows on isosurfaces that the property shades (default: off).
   * Drawn surfaces of this mapper keep the diffuse and specular light of a light away from one
   * another; a translucent surface stops the share that is its opacity. Other props cast no
   * shadows, and receive none. Headlights cast none, as none would be seen.
   *
   * LightRadius: the radius of all lights that cast shadows, in world units. 0 (default): shadows
   * have hard edges, and are exact for each pixel. A light with a radius casts soft shadows; a
   * light that is not positional looks as large as a ball of this radius at its position, seen from
   * its focal point. Soft shadows take as many rays as ambient occlusion (AmbientOcclusionRays).
   * They are kept, and get better, in the same way; a light that moves loses its own shadow only.
   * A radius below 0 is clamped to 0.
   */
  vtkSetMacro(Shadows, vtkTypeBool);
  vtkGetMacro(Shadows, vtkTypeBool);
  vtkBooleanMacro(Shadows, vtkTypeBool);
  virtual void SetLightRadius(double radius);
  vtkGetMacro(LightRadius, double);
  //@}

  /** Values of Antialiasing. */
  enum AntialiasingModes
  {
    ANTIALIASING_OFF,        ///< one ray a pixel
    ANTIALIASING_WHEN_STILL, ///< in a window, the second frame of a picture that does not change
    ANTIALIASING_ALWAYS      ///< every frame
  };

  //@{
  /**
   * Set/Get when pictures are antialiased: pixels whose neighbours differ get 4 to 16 rays, and
   * show their mean. Its alpha is the share that is covered, so edges blend over other props.
   * Depths, normals and picks stay those of the centres of pixels. By default this is done when a
   * picture is still, so nothing gets slower while the camera turns. MakeImage and RenderToImage
   * antialias at once unless ProgressiveImages is on.
   */
  virtual void SetAntialiasing(int mode);
  vtkGetMacro(Antialiasing, int);
  void SetAntialiasingToOff() { this->SetAntialiasing(ANTIALIASING_OFF); }
  void SetAntialiasingToWhenStill() { this->SetAntialiasing(ANTIALIASING_WHEN_STILL); }
  void SetAntialiasingToAlways() { this->SetAntialiasing(ANTIALIASING_ALWAYS); }
  //@}

  //@{
  /**
   * Get whether the last frame is final: false if rendering it again would make it better: its
   * light, its edges, or interpolated pixels. GetFrameProgress() is the share of its rays that is
   * known, 1 if the frame is final. vtkTemporalCoherenceRefiner renders a window until its frames
   * are final.
   */
  bool GetFrameIsFinal();
  double GetFrameProgress();
  //@}

  /** Events besides those of vtkCommand. */
  enum Events
  {
    /// The mapper and its window send this event after each frame that was made. The data is
    /// GetFrameProgress(), a double.
    FrameProgressEvent = vtkCommand::UserEvent + 4301
  };

  //@{
  /**
   * Set/Get whether MakeImage() makes what the next frame of a window would be (on), or a final
   * picture (off, default).
   */
  vtkSetMacro(ProgressiveImages, vtkTypeBool);
  vtkGetMacro(ProgressiveImages, vtkTypeBool);
  vtkBooleanMacro(ProgressiveImages, vtkTypeBool);
  //@}

  //@{
  /**
   * Set/Get whether frames re-use earlier pictures (default: on), and how many pictures each viewer
   * keeps for PAPER, 1 (default) to 64. On: new opacities, new colours of a projection and another
   * time step cost only the affected work. With PAPER, a moved camera starts from an earlier
   * picture. Off: these frames are cold. Isomap is a switch of its own. Other numbers of pictures
   * are clamped.
   */
  vtkSetMacro(ReuseFrames, vtkTypeBool);
  vtkGetMacro(ReuseFrames, vtkTypeBool);
  vtkBooleanMacro(ReuseFrames, vtkTypeBool);
  vtkSetClampMacro(NumberOfCachedImages, int, 1, 64);
  vtkGetMacro(NumberOfCachedImages, int);
  //@}

  /** Values of ReuseAccuracy. */
  enum ReuseAccuracies
  {
    BOUNDED = 0, ///< deprecated: means EXACT
    EXACT = 1,
    PAPER = 2 ///< for comparison with the paper; applications do not need it
  };

  //@{
  /**
   * Set/Get how exact a frame is after the view has changed. EXACT (default): the cold picture,
   * byte for byte. PAPER: the published method; silhouettes erode a little in every frame.
   * RefineWhenStill (default: on) makes the next frame of an unchanged view exact.
   */
  virtual void SetReuseAccuracy(int accuracy);
  vtkGetMacro(ReuseAccuracy, int);
  void SetReuseAccuracyToExact() { this->SetReuseAccuracy(EXACT); }
  void SetReuseAccuracyToPaper() { this->SetReuseAccuracy(PAPER); }
  vtkSetMacro(RefineWhenStill, vtkTypeBool);
  vtkGetMacro(RefineWhenStill, vtkTypeBool);
  vtkBooleanMacro(RefineWhenStill, vtkTypeBool);
  //@}

  /** Deprecated, like BOUNDED: sets EXACT. Version 0.4 will remove both. */
  void SetReuseAccuracyToBounded() { this->SetReuseAccuracy(BOUNDED); }

  //@{
  /**
   * Set/Get whether a new isovalue in the same view is looked up in the isomap, tile by tile (on,
   * default), or makes a cold frame (off). With IsomapTolerance 0, both pictures are equal.
   *
   * - IsomapTolerance: the largest distance between a surface from the isomap and the exact one, in
   *   voxels (finite). Default: 0, the cold picture byte for byte. Values below 0.001 count as 0,
   *   and so does any value for translucent surfaces.
   * - IsomapRange: the isovalues for which the isomap is built at once. Default: none (lo > hi).
   * - IsomapMemoryLimit: the most memory of each viewer's isomap, in MiB. Default: 256; 0 switches
   *   it off. The least recently used bands are dropped. Bands outside of IsomapRange take at most
   *   32 bytes a pixel.
   *
   * Tolerances and limits below 0 are clamped to 0.
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
   * Set the distance between rays in windows, in pixels along each axis: 0.1 to 100, default 1.
   * Other distances are clamped, and NaN is an error.
   *
   * AutoAdjustSampleDistances (default: on) keeps interaction smooth. A frame that takes longer
   * than vtkVolume::GetAllocatedRenderTime() traces fewer rays: a grid, whose rays have a distance
   * of up to MaximumImageSampleDistance rays (default: 10). Pixels between them are interpolated.
   * Tiles with large errors are traced completely, until time is up. The next frame of the same
   * view traces the missing tiles, and the picture is exact. Off: every frame traces all rays.
   * MinimumImageSampleDistance has no effect.
   */
  void SetImageSampleDistance(float pixels) override;
  void SetMinimumImageSampleDistance(float pixels) override;
  void SetMaximumImageSampleDistance(float pixels) override;
  //@}

  //@{
  /**
   * Set/Get whether blended volumes are sampled in steps of SampleDistance (in the data's
   * coordinates), as by VTK's mappers. Off (default): pictures are converged (see above), which is
   * also faster, and SampleDistance has no effect. On: pictures can be compared with VTK's.
   */
  vtkSetMacro(FixedStepSampling, vtkTypeBool);
  vtkGetMacro(FixedStepSampling, vtkTypeBool);
  vtkBooleanMacro(FixedStepSampling, vtkTypeBool);
  //@}

  //@{
  /**
   * Set/Get whether to warn once of a picture that shows nothing because all samples lie on one
   * side of each isovalue, or because no cell is visible. Default: on.
   */
  vtkSetClampMacro(WarnOfIsovalues, vtkTypeBool, 0, 1);
  vtkGetMacro(WarnOfIsovalues, vtkTypeBool);
  vtkBooleanMacro(WarnOfIsovalues, vtkTypeBool);
  //@}

  /**
   * Build the isomap of the present view before a new isovalue needs it. The picture has the size
   * of the renderer's window or, without one, of the last frame. The last frame is kept.
   * Documentation/Mapper.md tells how to observe and stop the building.
   * @return true if the isomap now holds the present isovalues
   */
  bool BuildIsomap(vtkRenderer* renderer, vtkVolume* volume);

  /** Free all kept pictures and structures. The next frame is cold. */
  void ClearCache();

  /** Bits that select point arrays of a frame. In parentheses: the value without a surface. */
  enum FrameArrays
  {
    FRAME_COLOR = 1,          ///< Color: unsigned char RGBA, multiplied by alpha (0)
    FRAME_DEPTH = 2,          ///< Depth: float, world distance along the ray (infinity)
    FRAME_NORMALS = 4,        ///< Normals: three floats, unit normal in the world (0)
    FRAME_ISOVALUE_INDEX = 8, ///< IsovalueIndex: int, index in GetIsoSurfaceValues(); label (-1)
    FRAME_ANSWER = 16,        ///< Answer: unsigned char, how the ray was answered (any)
    FRAME_ALL = 31            ///< all of these
  };

  /**
   * Render without a window or an OpenGL context. The picture becomes the last frame.
   * @param renderer     has the camera and the lights; the volume need not be in it
   * @param volume       has the transform and the property; its mapper is not used
   * @param width,height pixels in a row, and rows, at least 1; row 0 is the bottom row
   * @param color,depth  receive the arrays Color and Depth of FrameArrays; each may be null
   * @return false after an error, or if the frame was stopped. The images are then unchanged.
   */
  bool MakeImage(vtkRenderer* renderer, vtkVolume* volume, int width, int height,
    vtkImageData* color, vtkImageData* depth);
  /** Render without a window, as above, an image of all FrameArrays. */
  bool MakeImage(
    vtkRenderer* renderer, vtkVolume* volume, int width, int height, vtkImageData* frame);

  /**
   * Get the last frame, whether it was made for a window or for an image.
   * @param frame  receives these point arrays and nothing else
   * @param arrays a sum of FrameArrays, FRAME_ALL (default), or 0, which sets the size only
   * @return false if there is no frame, or after an error. The image is then unchanged.
   */
  bool GetLastFrame(vtkImageData* frame, int arrays = FRAME_ALL);

  //@{
  /**
   * Get the last frame as vtkGPUVolumeRayCastMapper gives it: RGBA bytes with colours multiplied by
   * alpha, or depth-buffer values. Without a frame, and after an error, the image is unchanged.
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
   * Get the surface point that the last frame shows at a pixel; (0, 0) is at the lower left.
   * Position and normal are in world coordinates; the normal is a unit vector and faces the viewer.
   * Each result may be null. In a blended volume, the position is the first visible place on the
   * ray (of maxima and minima, the value's place), and the index is -1. The normal is the
   * gradient's direction in COMPOSITE_BLEND without several independent components, else 0. With
   * LABELS, the index is the label.
   * @return false if there is no surface, no such pixel or no frame. Nothing is written then.
   */
  bool PickPixel(int x, int y, double position[3], double normal[3], int* isovalueIndex);

  /**
   * Get the cell of a mesh whose surface the last frame shows at a pixel. block receives the flat
   * index of the cell's block (0 without blocks), and may be null. Python passes a list, [0], or
   * None.
   * @return the cell's id; -1 without a surface, without a mesh, and in adaptive grids. Nothing is
   * written then.
   */
  vtkIdType PickCell(int x, int y, unsigned int* block);

  /**
   * Find the first surface on the line from p1 to p2 in world coordinates. No frame is needed, and
   * the last frame is kept. The line begins at p1 like a ray at the near plane.
   * @param t receives the place of the hit on the line, from 0 at p1 to 1 at p2. The other results
   *          are as in PickPixel(); the normal faces p1.
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
    ROUTE_ISOMAP_BUILD,    ///< the isomap lacks some tiles: they are built or traced
    ROUTE_IMAGE_CACHE = 6, ///< the view changed (PAPER): rays start from a cached image
    ROUTE_TIME_STEP,       ///< samples changed: pixels that no changed sample affects are copied
    ROUTE_RECOMPOSITE,     ///< only opacities changed: known layers are composited again
    ROUTE_KEEP_VALUES = 10, ///< only colours of a projection changed: known values are coloured
    ROUTE_ANTIALIAS,        ///< nothing changed: pixels at edges get more rays
    ROUTE_FEWER_RAYS,       ///< some rays are traced, and pixels between them are interpolated
    ROUTE_REFINE,           ///< nothing changed: tiles between rays are traced
    ROUTE_KEEP_LABELS       ///< other labels are drawn: rays keep what they met unless that changes
  };

  /** The work of the last frame to set up its mesh. */
  enum MeshSetUps
  {
    MESH_NONE,       ///< the input is no mesh
    MESH_KEPT,       ///< none
    MESH_NEW_VALUES, ///< new values were read
    MESH_REFITTED,   ///< points moved: boxes were fitted to the same cells
    MESH_BUILT       ///< new cells were ordered
  };

  /**
   * Get the statistics of the last frame: route, rays, times, memory. The object belongs to the
   * mapper, and each call updates it.
   */
  vtkTemporalCoherenceStatistics* GetStatistics();

  /** Set the data to draw without a pipeline: an image or a grid. */
  void SetInputData(vtkDataSet* data) override;

  /**
   * Set a source of a volume that may be larger than memory as the input. It is the same as
   * SetInputConnection(source->GetOutputPort()). Null leaves the mapper without input.
   *
   * In a window whose frames are followed by others (see vtkTemporalCoherenceRefiner), a frame does
   * not wait for samples longer than a moment. It shows what is finished over a coarse picture, and
   * later frames bring the rest (see GetFrameIsFinal). All others wait, and so does MakeImage.
   */
  void SetBrickSource(vtkTemporalCoherenceBrickSource* source);

  //@{
  /** Get the bounds of the input in its own coordinates; for blocks, the bounds of all of them. */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  //@}

  /**
   * Return true if everything that this mapper draws of the volume is opaque: no isovalue has a
   * scalar opacity between 0 and 1, and there is no gradient opacity. False for blended volumes,
   * and for labels before their first frame.
   */
  bool IsOpaque(vtkVolume* volume);

  //@{
  /**
   * Names of version 0.2. Version 0.4 will remove them.
   * \deprecated Call ReuseFrames, SmoothMeshNormals, ClearCache, MakeImage and GetStatistics.
   */
  void SetImageCache(vtkTypeBool on) { this->SetReuseFrames(on); }
  vtkTypeBool GetImageCache() { return this->ReuseFrames; }
  void ImageCacheOn() { this->SetReuseFrames(1); }
  void ImageCacheOff() { this->SetReuseFrames(0); }
  void SetAveragedGradients(vtkTypeBool on) { this->SetSmoothMeshNormals(on); }
  vtkTypeBool GetAveragedGradients() { return this->SmoothMeshNormals; }
  void AveragedGradientsOn() { this->SetSmoothMeshNormals(1); }
  void AveragedGradientsOff() { this->SetSmoothMeshNormals(0); }
  void ReleaseReuse() { this->ClearCache(); }
  bool RenderToImage(vtkRenderer* renderer, vtkVolume* volume, int width, int height,
    vtkImageData* color, vtkImageData* depth)
  {
    return this->MakeImage(renderer, volume, width, height, color, depth);
  }
  bool RenderToImage(
    vtkRenderer* renderer, vtkVolume* volume, int width, int height, vtkImageData* frame)
  {
    return this->MakeImage(renderer, volume, width, height, frame);
  }
  int GetRoute() { return this->GetStatistics()->GetRoute(); }
  const char* GetRouteAsString() { return this->GetStatistics()->GetRouteAsString(); }
  vtkIdType GetNumberOfRays() { return this->GetStatistics()->GetNumberOfRays(); }
  vtkIdType GetNumberOfDefiniteHits() { return this->GetStatistics()->GetNumberOfDefiniteHits(); }
  vtkIdType GetNumberOfDefiniteMisses()
  {
    return this->GetStatistics()->GetNumberOfDefiniteMisses();
  }
  vtkIdType GetNumberOfPossibleHits() { return this->GetStatistics()->GetNumberOfPossibleHits(); }
  vtkIdType GetNumberOfTracedRays() { return this->GetStatistics()->GetNumberOfTracedRays(); }
  vtkIdType GetNumberOfFieldSamples() { return this->GetStatistics()->GetNumberOfFieldSamples(); }
  vtkIdType GetNumberOfLayers() { return this->GetStatistics()->GetNumberOfLayers(); }
  vtkIdType GetNumberOfMergedLayers() { return this->GetStatistics()->GetNumberOfMergedLayers(); }
  vtkIdType GetIsomapMemory() { return this->GetStatistics()->GetIsomapMemory(); }
  vtkIdType GetNumberOfIsomapKnots() { return this->GetStatistics()->GetNumberOfIsomapKnots(); }
  double GetFrameTime() { return this->GetStatistics()->GetFrameTime(); }
  double GetTraceTime() { return this->GetStatistics()->GetTraceTime(); }
  double GetQueryTime() { return this->GetStatistics()->GetQueryTime(); }
  double GetIsomapBuildTime() { return this->GetStatistics()->GetIsomapBuildTime(); }
  double GetShadeTime() { return this->GetStatistics()->GetShadeTime(); }
  double GetPresentTime() { return this->GetStatistics()->GetPresentTime(); }
  int GetMeshSetUp() { return this->GetStatistics()->GetMeshSetUp(); }
  double GetMeshSetUpTime() { return this->GetStatistics()->GetMeshSetUpTime(); }
  vtkIdType GetMeshMemory() { return this->GetStatistics()->GetMeshMemory(); }
  bool GetScalarsWereAveraged() { return this->GetStatistics()->GetScalarsWereAveraged(); }
  double GetMeshPointError() { return this->GetStatistics()->GetMeshPointError(); }
  double GetMeshValueError() { return this->GetStatistics()->GetMeshValueError(); }
  //@}

  //@{
  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Draw into the renderer's window. Free the textures of a window, or of all windows (null).
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  //@}

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Draw what the last Render() of a vtkTemporalCoherenceVolume left out in the opaque pass: pixels
   * at edges, which are blended over opaque props.
   */
  void RenderEdges(vtkRenderer* renderer, vtkVolume* volume);

protected:
  vtkTemporalCoherenceVolumeMapper();
  ~vtkTemporalCoherenceVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkTemporalCoherenceVolumeMapper(const vtkTemporalCoherenceVolumeMapper&) = delete;
  void operator=(const vtkTemporalCoherenceVolumeMapper&) = delete;

  int SurfaceMode = CROSSING;
  vtkSmartPointer<vtkScalarsToColors> LabelTable;
  int OutsideLabel = 0;
  double LabelRadius = 0.0;
  std::string ColorArrayName;
  vtkTypeBool ColorArrayOnCells = 0;
  int ColorArrayComponent = 0;
  vtkTypeBool ColorArrayOpacity = 0;
  vtkSmartPointer<vtkScalarsToColors> ColorTable;
  int VectorMode = DISABLED;
  int VectorComponent = 0;
  vtkTypeBool SmoothMeshNormals = 0;
  int MeshMemoryLimit = 0;
  vtkTypeBool AmbientOcclusion = 0;
  double AmbientOcclusionRadius = 0.0;
  double AmbientOcclusionStrength = 1.0;
  int AmbientOcclusionRays = 1;
  vtkTypeBool Shadows = 0;
  double LightRadius = 0.0;
  int Antialiasing = ANTIALIASING_WHEN_STILL;
  vtkTypeBool ProgressiveImages = 0;
  vtkTypeBool ReuseFrames = 1;
  int NumberOfCachedImages = 1;
  int ReuseAccuracy = EXACT;
  vtkTypeBool RefineWhenStill = 1;
  vtkTypeBool Isomap = 1;
  double IsomapTolerance = 0.0;
  double IsomapRange[2] = { 1.0, 0.0 };
  int IsomapMemoryLimit = 256;
  vtkTypeBool FixedStepSampling = 0;
  vtkTypeBool WarnOfIsovalues = 1;

  struct Internals;
  std::unique_ptr<Internals> Internal;
  friend class vtkTemporalCoherencePicker;                 // finds cells
  friend class vtkTemporalCoherenceGPUVolumeRayCastMapper; // asks whether a frame would be refused
  friend class vtkTemporalCoherenceViewWriter;             // asks for the input of frames
};
VTK_ABI_NAMESPACE_END

#endif
