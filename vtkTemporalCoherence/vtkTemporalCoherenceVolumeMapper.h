// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceVolumeMapper
 * @brief   isosurfaces of images, ray cast on the CPU, using again what the last frame knew
 *
 * A drop-in for the volume mapper of a vtkVolume whose input is a vtkImageData, several of them as
 * blocks, or a vtkRectilinearGrid. It draws the isosurfaces of
 * `vtkVolumeProperty::GetIsoSurfaceValues()` (blend mode ISOSURFACE_BLEND, which it is constructed
 * with), each in the colour that the property's colour transfer function has at the isovalue.
 * (After UseDepthPassOn() they are those of GetDepthPassContourValues() where that list has not
 * been touched: it is empty, or the single 0 that it is constructed with.) Other blend modes are
 * refused. It is a vtkGPUVolumeRayCastMapper whose interface it has, but it needs no GPU, and of
 * these settings it heeds only those that are told of here: vtkTemporalCoherenceDropInMapper lists
 * the others. Nothing is extracted: every pixel's ray is intersected with the trilinear (or
 * nearest-neighbour) interpolant of the samples, exactly. The picture has a depth at every pixel,
 * so that other props intersect it correctly, and is the same for any number of threads.
 *
 * Between two calls of Render() the mapper keeps the last picture and does only what the change
 * asks for: the same picture again, new colours on known hits, a moved view that starts from the
 * last one (ReuseAccuracy tells how exactly), a new isovalue that is looked up in an isomap of the
 * view (built when isovalues first change), or a cold frame. GetRoute() tells which.
 *
 * Opacity is that of the scalar opacity function at the isovalue, with no regard to distances,
 * times that of the gradient opacity function at the steepness of the field (per mean distance of
 * samples). 0 leaves the isovalue out. Through translucent surfaces others are seen: with CROSSING
 * all that the ray passes, with THRESHOLD each entry into a solid. They are laid over one another
 * from front to back, whatever their order in the list, until less than 1/512 shines through. Depth
 * and picks are those of the first surface that can be seen. Equal isovalues count once. There may
 * be 32767 isovalues, 1024 where some are translucent.
 *
 * Cropping (all 27 regions; planes along the axes of the image) and the mapper's clipping planes
 * (in the world, any number) cut surfaces off; with THRESHOLD solids are capped there.
 *
 * A sample that is not a number counts as below every isovalue. Images with fewer than two samples
 * along an axis have no cells: the picture is empty. The camera's clipping range clips the
 * surfaces, as it clips any prop.
 *
 * Scalars are those of points or cells, chosen as for any mapper (ScalarMode, SelectScalarArray).
 * One of a cell is a sample at the cell's centre; the field ends at the outermost centres.
 *
 * Blocks (vtkMultiBlockDataSet, vtkPartitionedDataSetCollection or another vtkDataObjectTree of
 * vtkImageData or vtkUniformGrid; SetInputDataObject or SetInputConnection) lie on one lattice:
 * the same spacing and direction, origins whole steps apart. They are copied into one image, once
 * and when one of them changes, so that there are no seams. Nothing is drawn in cells that no
 * block has, owns (vtkGhostType) and shows. Blocks without the chosen array are left out.
 *
 * The input may be a vtkRectilinearGrid, too. Its coordinates ascend or descend, strictly; they are
 * read in every frame, so that changes need not be told. Each cell is trilinear, the faces of
 * nearest-neighbour interpolation lie half way between samples, and normals are those of central
 * differences by the distances between samples. A grid has no isomap: a new isovalue in the same
 * view takes the route ThresholdHint. Where all cells are alike (to 1e-5 of one), the grid is drawn
 * as the image that it is.
 *
 * Ghost arrays ("vtkGhostType", as vtkUniformGrid::BlankPoint and BlankCell write them) hide cells:
 * those with HIDDENCELL, REFINEDCELL or DUPLICATECELL, and those with a corner that is a
 * HIDDENPOINT. No surface is found in a hidden cell. Its samples still serve the cells beside it.
 * There are no isomaps of images that have hidden cells: a new isovalue is bounded by the last hit,
 * or makes a cold frame. After a change of a ghost array call its Modified(), which BlankPoint and
 * BlankCell do not.
 *
 * A mask (SetMaskInput) has one whole number for each sample of the input, in the same order; its
 * origin and spacing do not count. A binary mask (SetMaskTypeToBinary()) shows samples where it is
 * above 0, a label map (VTK's default) all but those of hidden labels: of labels whose own scalar
 * opacity (vtkVolumeProperty::SetLabelScalarOpacity) is 0 at all isovalues, while MaskBlendFactor
 * is 1. Colours and other opacities of labels have no effect on isosurfaces, as in
 * vtkGPUVolumeRayCastMapper. A cell none of whose eight samples is shown is hidden, and all that is
 * said of hidden cells goes for it. So a surface ends up to one cell beyond the samples that are
 * shown, and a mask made by a threshold at the isovalue leaves the surface whole. (VTK's mapper
 * ends it half a cell beyond, and shows the solid's cut as a surface; here THRESHOLD does.) The
 * mask's array is that which is chosen of the input (SelectScalarArray), or else its scalars. After
 * a change of its values call Modified() of the array or the mask. Filters that make the mask have
 * to be updated before Render(): vtkImageData does not know them. Blocks take no mask.
 *
 * Events: VolumeMapperRenderStartEvent, VolumeMapperRenderProgressEvent with the share of the frame
 * that is done (a double from 0 to 1, never less than before) and VolumeMapperRenderEndEvent with
 * whether the frame was made (a bool; false after an error or a stop, the last one then stays), in
 * Render() and RenderToImage(). A frame stops where the render window's CheckAbortStatus() says so,
 * which costs nothing as long as nobody observes AbortCheckEvent or progress; the one of
 * RenderToImage() where an observer of progress calls SetAbortExecute(1). That is no error: the
 * last picture stays, and the next call makes the frame. Observers must not draw, build or release
 * with this mapper while it makes a frame.
 *
 * What is kept is kept for each viewer: a renderer, a volume, a camera and an eye. So one mapper
 * may serve several windows, views or eyes. The four viewers served last are remembered, each with
 * two pictures (36 bytes a pixel each; more where NumberOfCachedImages is), what its window shows
 * (8 bytes a pixel, and as much in a texture) and an isomap; what belongs to data and isovalues
 * alone is there once. Counters, times and PickPixel() are those of the last frame of any viewer.
 *
 * vtkVolume draws after translucent polygons; vtkTemporalCoherenceVolume before them, where
 * surfaces are opaque. Where the renderer peels volumes (UseDepthPeelingForVolumes, or a
 * vtkDualDepthPeelingPass with a volumetric pass) the surfaces of both, opaque or translucent, are
 * seen in their place among translucent polygons and those of other volumes of this mapper.
 * Hardware selectors (vtkHardwareSelector, vtkPropPicker) find a volume where its surfaces are
 * seen, with the point nearest to the hit or the cell around it.
 *
 * Light is that of VTK's Phong model, with the mirrored light, as on volumes since VTK 9.2, for any
 * number of lights of the renderer that are on. If none is, the renderer creates a headlight, and
 * with AutomaticLightCreationOff surfaces are lit evenly, by ambient + diffuse, as polygons are.
 * Lights' ambient colours have no effect, as on polygons. With TwoSidedLightingOff of the renderer
 * a surface is lit only on its outside, the side of lower values, as by vtkGPUVolumeRayCastMapper.
 * Of the colours that light makes, the window of FinalColorWindow around FinalColorLevel is spread
 * over all (default: 1 around 0.5, all of them), as vtkGPUVolumeRayCastMapper does.
 * Transfer functions in two dimensions have no meaning for isosurfaces: SetTransferFunctionMode is
 * ignored, and colour and opacity are those of the functions of the scalar.
 *
 * Numbers of the appearance must be finite and within these bounds; otherwise the frame is refused:
 * ambient, diffuse and specular -1e6 to 1e6, specular power 0 to 1e6, colours -1000 to 1000 (what
 * is shown is clamped to [0, 1]), opacities -1e6 to 1e6 (clamped, too); of nodes of the gradient
 * opacity, a position from -1e100 to 1e100, a value from -1e6 to 1e6, midpoint and sharpness 0 to
 * 1; of FinalColorWindow and FinalColorLevel -1e4 to 1e4, the window no narrower than 1e-4; of
 * lights, an intensity from -1e18 to 1e18, attenuations -1e30 to 1e30, an exponent from 0 to
 * 128, a cone angle from -1e6 to 1e6 degrees, positions and focal points -1e38 to 1e38. Their
 * products stay within the range of floats. Settings without effect, as those of lights that are
 * off, may be anything.
 *
 * A mistake gets one vtkErrorMacro with its value and remedy, repeated only after a frame without
 * it; the last valid picture stays.
 *
 * Method: "Accelerating Volume Visualization by Exploiting Temporal Coherence" (image cache and
 * isomap); intersection: Marmitt et al., "Fast and Accurate Ray-Voxel Intersection Techniques for
 * Iso-Surface Ray Tracing", 2004.
 *
 * @sa vtkTemporalCoherenceDropInMapper vtkTemporalCoherenceVolume vtkVolume vtkVolumeProperty
 * vtkContourValues vtkGPUVolumeRayCastMapper
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
   * Which crossings of an isovalue are its surface.
   *
   * CROSSING (default), as in vtkGPUVolumeRayCastMapper: the first point along the ray where the
   * field passes the isovalue, in either direction. Nothing is drawn where the boundary of the
   * volume cuts through a solid.
   *
   * THRESHOLD, as in the paper: the first point where the field is at least the isovalue. A solid
   * cut by the boundary of the volume, by the near plane, a clipping or cropping plane, or where
   * hidden cells end, is capped, with the normal of what cuts it (at the near plane: facing the
   * viewer); of several isovalues the cap shows the highest.
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
   * Which scalar of an array of several components is drawn. Names and values are those of
   * vtkSmartVolumeMapper.
   *
   * DISABLED (default), what the volume's property says, as vtkGPUVolumeRayCastMapper takes it for
   * isosurfaces: of independent components (vtkVolumeProperty::IndependentComponentsOn, the
   * default) the one of the largest component weight, the first of equal ones, with the transfer
   * functions and the shading that the property has for it; of dependent ones, component 0.
   *
   * MAGNITUDE: the Euclidean length of the tuples, computed anew when the array changes. An array
   * of one component is drawn as it is. COMPONENT: VectorComponent (default 0; an error if the
   * array has no such component). Both take the property's first transfer functions and shading.
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
   * Allow a moved camera to start from a kept picture: rays leap over the space that it shows to be
   * free, and those that stay in it are not traced at all. And allow the picture of another time
   * step to copy that of the last one where no sample that changed can be seen. Default: on. Off, a
   * new view and a new time step make a cold frame (but one with the same numbers changes nothing).
   */
  vtkSetMacro(ImageCache, vtkTypeBool);
  vtkGetMacro(ImageCache, vtkTypeBool);
  vtkBooleanMacro(ImageCache, vtkTypeBool);
  //@}

  //@{
  /**
   * Allow a new isovalue in the same view to be looked up in an isomap, which knows where each
   * pixel's ray first passes each isovalue. Default: on. It is built when isovalues first change in
   * a view, a band of isovalues at a time. Off, the last hit of a ray bounds the search for the
   * next (route ThresholdHint). The picture is the same.
   */
  vtkSetMacro(Isomap, vtkTypeBool);
  vtkGetMacro(Isomap, vtkTypeBool);
  vtkBooleanMacro(Isomap, vtkTypeBool);
  //@}

  //@{
  /**
   * Leap over blocks of cells whose range of values the isovalues are not in. Default: on. Off, a
   * ray reads every cell on its way: the paper's plain ray caster, for comparison. The picture is
   * the same.
   */
  vtkSetMacro(SpaceLeaping, vtkTypeBool);
  vtkGetMacro(SpaceLeaping, vtkTypeBool);
  vtkBooleanMacro(SpaceLeaping, vtkTypeBool);
  //@}

  //@{
  /**
   * Paint yellow the surfaces that the image cache did not serve (figure 8 of the paper): those
   * found by rays that were possible hits. Default: off. It shows in frames of the route ImageCache
   * only, and stays while such a frame gets new colours.
   */
  vtkSetMacro(ColorByAnswer, vtkTypeBool);
  vtkGetMacro(ColorByAnswer, vtkTypeBool);
  vtkBooleanMacro(ColorByAnswer, vtkTypeBool);
  //@}

  enum ReuseAccuracies
  {
    BOUNDED = 0,
    EXACT = 1,
    PAPER = 2
  };

  //@{
  /**
   * What a frame of the route ImageCache promises.
   *
   * BOUNDED (default): at most 0.01 % of the pixels differ from the cold picture (a surface here
   * and none there, or more than a voxel apart) in the median frame and 0.05 % in any, however many
   * frames are made from one another. Rays start where the space that the cached picture shows to
   * be free ends, a voxel before edges, and are always traced from there. A cached picture whose
   * pixels are more than two voxels apart, or that PAPER made, is not used: the frame is cold.
   *
   * EXACT: the cold picture, to the last bit. A picture between whose pixels anything may hide
   * proves nothing, so this costs what a cold frame costs.
   *
   * PAPER: as published. A hit that the cached picture has is looked for within a voxel of it; what
   * the picture shows to be free is believed. Silhouettes erode a little with every frame.
   */
  vtkSetClampMacro(ReuseAccuracy, int, BOUNDED, PAPER);
  vtkGetMacro(ReuseAccuracy, int);
  void SetReuseAccuracyToBounded() { this->SetReuseAccuracy(BOUNDED); }
  void SetReuseAccuracyToExact() { this->SetReuseAccuracy(EXACT); }
  void SetReuseAccuracyToPaper() { this->SetReuseAccuracy(PAPER); }
  //@}

  //@{
  /**
   * Complete a picture that is not exact (from the image cache, or from an isomap with a tolerance
   * or with interpolated normals) to the cold picture, once, when the view repeats. Default: on.
   */
  vtkSetMacro(RefineWhenStill, vtkTypeBool);
  vtkGetMacro(RefineWhenStill, vtkTypeBool);
  vtkBooleanMacro(RefineWhenStill, vtkTypeBool);
  //@}

  enum ImageCachePolicies
  {
    LATEST = 0,
    KEY_IMAGE = 1
  };

  //@{
  /**
   * Which pictures the image cache keeps: LATEST (default) every one, KEY_IMAGE a cold one that is
   * made every KeyImageInterval frames (default 7, as in the paper). The latest
   * NumberOfCachedImages (default 1, at most 64) stay; the one whose view is nearest serves. Each
   * takes 36 bytes a pixel.
   */
  vtkSetClampMacro(ImageCachePolicy, int, LATEST, KEY_IMAGE);
  vtkGetMacro(ImageCachePolicy, int);
  void SetImageCachePolicyToLatest() { this->SetImageCachePolicy(LATEST); }
  void SetImageCachePolicyToKeyImage() { this->SetImageCachePolicy(KEY_IMAGE); }
  vtkSetClampMacro(KeyImageInterval, int, 1, VTK_INT_MAX);
  vtkGetMacro(KeyImageInterval, int);
  vtkSetClampMacro(NumberOfCachedImages, int, 1, 64);
  vtkGetMacro(NumberOfCachedImages, int);
  //@}

  enum ImageCacheShadings
  {
    CACHE_RESHADE = 0,
    CACHE_INTERPOLATE = 1
  };

  //@{
  /**
   * Colours of definite hits with PAPER: RESHADE (default), from the field at the refined hit;
   * INTERPOLATE, between those of the cached picture, whose light and blur then travel with it; so
   * does a light that is moved. New colours or other changes of light, and ColorByAnswer, reshade.
   */
  vtkSetClampMacro(ImageCacheShading, int, CACHE_RESHADE, CACHE_INTERPOLATE);
  vtkGetMacro(ImageCacheShading, int);
  void SetImageCacheShadingToReshade() { this->SetImageCacheShading(CACHE_RESHADE); }
  void SetImageCacheShadingToInterpolate() { this->SetImageCacheShading(CACHE_INTERPOLATE); }
  //@}

  //@{
  /**
   * How the isomap is built.
   *
   * IsomapTolerance: how far a surface looked up may lie from the exact one, in voxels (the
   * smallest spacing). Default: 0, the cold picture to the last bit. A tolerance below 0.001
   * counts as 0. In very long volumes that bound is higher: 6e-7 of the longest diagonal. Distances
   * are kept in single precision and cannot be told more exactly.
   *
   * IsomapRange: isovalues to build it for at once. Default: lo > hi, bands around the present
   * isovalue that take about as long as a cold frame; outside of a given range, too.
   *
   * IsomapMemoryLimit: what it may use for each viewer, in MiB. Default: 256. The bands used least
   * are dropped, with a warning once; 0 is as IsomapOff().
   */
  virtual void SetIsomapTolerance(double voxels);
  vtkGetMacro(IsomapTolerance, double);
  vtkSetVector2Macro(IsomapRange, double);
  vtkGetVector2Macro(IsomapRange, double);
  vtkSetClampMacro(IsomapMemoryLimit, int, 0, VTK_INT_MAX);
  vtkGetMacro(IsomapMemoryLimit, int);
  //@}

  enum IsomapShadings
  {
    RESHADE = 0,
    INTERPOLATE = 1
  };

  //@{
  /**
   * Normals of surfaces looked up in the isomap: RESHADE (default), from the field; INTERPOLATE,
   * between normals that are stored where the isomap has knots, as the paper does with colours.
   * That is cheaper, but knots may lie voxels apart; a repeated view is completed
   * (RefineWhenStill).
   */
  vtkSetClampMacro(IsomapShading, int, RESHADE, INTERPOLATE);
  vtkGetMacro(IsomapShading, int);
  void SetIsomapShadingToReshade() { this->SetIsomapShading(RESHADE); }
  void SetIsomapShadingToInterpolate() { this->SetIsomapShading(INTERPOLATE); }
  //@}

  //@{
  /**
   * Coarser and finer frames in windows, as of vtkGPUVolumeRayCastMapper.
   *
   * ImageSampleDistance: pixels from one ray to the next along each axis, 0.1 to 100. Default: 1, a
   * ray a pixel. Above 1, pixels without a ray show that of their neighbour. Below 1, a pixel shows
   * the mean of the rays in it, weighted by the area that each has of the pixel (colours multiplied
   * by alpha, so that edges are blended with what is behind). Its depth, and what is picked or
   * selected there, is that of the ray at its centre or, where that one meets nothing, of the
   * nearest surface among the others. A frame costs what its rays cost, in time and memory: 100 for
   * each pixel at 0.1. It has at most 33554432, which a warning tells where fewer pixels between
   * rays are asked for. Where volumes are peeled by depth there is one ray a pixel at most. Pixels
   * at the edge of a surface leave no depth, so that opaque props that are drawn later, behind a
   * vtkTemporalCoherenceVolume, cover them.
   *
   * AutoAdjustSampleDistances: choose ImageSampleDistance for each frame between
   * MinimumImageSampleDistance (default 1; below it, still pictures are finer than pixels) and
   * MaximumImageSampleDistance (default 10), so that what the last frames took for each ray fits
   * into vtkVolume::GetAllocatedRenderTime(), which
   * follows from vtkRenderWindow::SetDesiredUpdateRate(): interactors set a high rate while one
   * drags, and a low one for the still picture. Default: off (in VTK's mappers it is on), since
   * frames are seldom too slow, and a frame of another size than the one before cannot use it
   * again.
   *
   * The images of RenderToImage() have a ray a pixel. PickPixel() takes pixels of the window
   * whatever rays it has; GetLastFrame(), GetColorImage(), GetDepthImage() and GetVisibleSurface()
   * give a value for each ray.
   */
  void SetImageSampleDistance(float pixels) override;
  void SetMinimumImageSampleDistance(float pixels) override;
  void SetMaximumImageSampleDistance(float pixels) override;
  //@}

  //@{
  /**
   * Warn, once until it is cured, where there is nothing to see since no isovalue has samples on
   * both sides: all of them lie outside the range of the samples, or at its lower end, as the one
   * isovalue of 0 that a new property has mostly does. There is one, too, where nothing is seen
   * since this untouched 0 has a scalar opacity of 0. There is no warning where the mapper draws a
   * part of a volume, as far as it can know: a piece of what the pipeline has, an image with
   * duplicate cells or points, a block, or one of several volumes with the same property.
   * Default: on.
   */
  vtkSetClampMacro(WarnOfIsovalues, vtkTypeBool, 0, 1);
  vtkGetMacro(WarnOfIsovalues, vtkTypeBool);
  vtkBooleanMacro(WarnOfIsovalues, vtkTypeBool);
  //@}

  /**
   * Build the isomap of the present view ahead of the first new isovalue: IsomapRange if it holds
   * the isovalues, else a band around each. The view is that of the renderer's window; without a
   * window its size is that of the last frame. Sends ProgressEvent with the share of a band that is
   * done; stops when the render window or SetAbortExecute() asks for it. The last frame stays.
   * @return true if there is an isomap for the present isovalues afterwards; there is none of a
   *         rectilinear grid whose cells are not all alike
   */
  bool BuildIsomap(vtkRenderer* renderer, vtkVolume* volume);

  /**
   * Forget pictures and structures kept for the next frame and free their memory. The next frame
   * is cold.
   */
  void ReleaseReuse();

  /**
   * Render without a render window or an OpenGL context, on any machine.
   *
   * The renderer gives camera and lights (a headlight if it has none and creates lights
   * automatically), the volume gives transform and property; neither has to be part of the other,
   * and nothing but the volume is drawn. The picture becomes the last frame, as that of Render().
   * @param renderer camera and lights
   * @param volume   transform and property; its mapper is not looked at
   * @param width    pixels in a row, at least 1
   * @param height   rows, at least 1
   * @param color    gets unsigned char RGBA, multiplied by alpha, as volume mappers blend it: alpha
   *                 is 255 where nothing shines through the surfaces, 0 where there is none
   * @param depth    gets float world distance along the ray, from the eye or, in a parallel
   *                 projection, from the plane through the camera; infinity where nothing is hit.
   *                 Either image may be null. Row 0 is the bottom row.
   * @return false if there was an error or it was stopped; the images are then left alone
   */
  bool RenderToImage(vtkRenderer* renderer, vtkVolume* volume, int width, int height,
    vtkImageData* color, vtkImageData* depth);

  /**
   * The same, and what else is known of each pixel.
   * @param normals       gets three floats: the unit normal in the world, facing the viewer; 0
   * @param isovalueIndex gets int: position of the isovalue in
   *                      vtkVolumeProperty::GetIsoSurfaceValues(); -1
   * @param answer        gets unsigned char: how the ray was answered when the picture was made, by
   *                      a definite miss (0), a definite hit (1) or as a possible hit (2). The
   * values in the end are those where nothing is hit. Any image may be null; the others must
   * differ. Their scalars are named Color, Depth, Normals, IsovalueIndex and Answer.
   */
  bool RenderToImage(vtkRenderer* renderer, vtkVolume* volume, int width, int height,
    vtkImageData* color, vtkImageData* depth, vtkImageData* normals, vtkImageData* isovalueIndex,
    vtkImageData* answer);

  //@{
  /**
   * The last frame as vtkGPUVolumeRayCastMapper gives it. After RenderToImageOn() Render() makes
   * frames only for that, and draws nothing into its window.
   *
   * GetColorImage: RGBA bytes, multiplied by alpha; no hit: 0, or beside the box 255, 255, 255, 0.
   *
   * GetDepthImage: what a depth buffer holds, 0 at the near plane and 1 at the far plane; where
   * nothing is hit, 1, or (ClampDepthToBackfaceOn()) where the ray leaves the volume. It is float,
   * or after SetDepthImageScalarTypeToUnsignedChar() or ...Short() a share of 255 or 65535.
   *
   * An image is left alone if there is no frame, or not enough memory.
   */
  void GetColorImage(vtkImageData* image) override;
  void GetDepthImage(vtkImageData* image) override;
  //@}

  /**
   * The last frame, whether it was made for a window or an image, as images: see RenderToImage.
   * @return false if there is no frame, or not enough memory; the images are then left alone
   */
  bool GetLastFrame(vtkImageData* color, vtkImageData* depth, vtkImageData* normals,
    vtkImageData* isovalueIndex, vtkImageData* answer);

  /**
   * The surface that the last frame shows, as points: one, and a vertex, for each pixel that shows
   * a surface.
   * @param points gets world positions (double) and the point arrays Normals (float, the active
   *               normals: unit, in the world, facing the viewer), Isovalue (double), IsovalueIndex
   *               (int, its position in vtkVolumeProperty::GetIsoSurfaceValues()) and Color
   *               (unsigned char RGBA, the active scalars)
   * @return false if there is no frame, or not enough memory; `points` is then left alone
   */
  bool GetVisibleSurface(vtkPolyData* points);

  /**
   * What the last frame shows at a pixel of the viewport or image; (0, 0) is at the lower left.
   * @param position      world position of the surface
   * @param normal        unit normal in the world, facing the viewer
   * @param isovalueIndex position of the isovalue in vtkVolumeProperty::GetIsoSurfaceValues().
   *                      Each of the three may be null.
   * @return false if there is no surface, no such pixel or no frame; nothing is written then
   */
  bool PickPixel(int x, int y, double position[3], double normal[3], int* isovalueIndex);

  /**
   * The first surface on the line from p1 to p2: what a frame shows whose ray this is. Neither a
   * frame nor a window is needed, and the last frame stays. The first call or frame for new data
   * reads all of it once.
   * @param volume        transform and property; its mapper is not looked at
   * @param p1            world position where the line begins, as a ray does at the near plane
   * @param p2            world position where it ends; any but p1
   * @param t             share of the way from p1 to p2 at which the surface is met
   * @param position      world position of the surface
   * @param normal        unit normal in the world, facing p1
   * @param isovalueIndex position of the isovalue in vtkVolumeProperty::GetIsoSurfaceValues().
   *                      Each of the last three may be null.
   * @return false if there is no surface or there was an error; nothing is written then
   */
  bool IntersectWithLine(vtkVolume* volume, const double p1[3], const double p2[3], double& t,
    double position[3], double normal[3], int* isovalueIndex);

  /**
   * Ways to make a frame:
   * - ROUTE_COLD: every ray is traced, with no help from an earlier frame;
   * - ROUTE_REDISPLAY: nothing changed, the same picture is shown again;
   * - ROUTE_RESHADE: only colours, lights or shading changed, known hits are shaded again;
   * - ROUTE_ISOMAP_LOOKUP: a new isovalue is looked up in the isomap of the view;
   * - ROUTE_ISOMAP_BUILD: the same after a band of the isomap was built;
   * - ROUTE_THRESHOLD_HINT: without an isomap, the last hits bound the search for a new isovalue;
   * - ROUTE_IMAGE_CACHE: in a new view rays start from what a kept picture tells;
   * - ROUTE_TIME_STEP: where samples that changed are not seen, the last picture is copied.
   */
  enum Routes
  {
    ROUTE_COLD,
    ROUTE_REDISPLAY,
    ROUTE_RESHADE,
    ROUTE_ISOMAP_LOOKUP,
    ROUTE_ISOMAP_BUILD,
    ROUTE_THRESHOLD_HINT,
    ROUTE_IMAGE_CACHE,
    ROUTE_TIME_STEP
  };

  //@{
  /**
   * How the last frame was made: one of Routes, and its name: Cold, Redisplay, Reshade,
   * IsomapLookup, IsomapBuild, ThresholdHint, ImageCache or TimeStep.
   */
  int GetRoute();
  const char* GetRouteAsString();
  //@}

  //@{
  /**
   * Counters of the last frame. Rays (one a pixel, or as ImageSampleDistance has it) are the sum of
   * definite misses (known to meet nothing), definite hits (known before, or found where the image
   * cache or the isomap told to look) and possible hits. Traced are those that were followed
   * through the field, but not hits of PAPER that were only refined. Field samples are those read
   * to find surfaces and to build an isomap, eight a cell. Memory (bytes) and knots are those of
   * the isomap that is kept.
   */
  vtkIdType GetNumberOfRays();
  vtkIdType GetNumberOfDefiniteHits();
  vtkIdType GetNumberOfDefiniteMisses();
  vtkIdType GetNumberOfPossibleHits();
  vtkIdType GetNumberOfTracedRays();
  vtkIdType GetNumberOfFieldSamples();
  vtkIdType GetIsomapMemory();
  vtkIdType GetNumberOfIsomapKnots();
  //@}

  //@{
  /**
   * Seconds that the last frame took: all told (showing it included), and of these: structures and
   * tracing or looking up, asking the image cache, building an isomap, shading, showing. A call of
   * BuildIsomap() after the frame sets the time of building to its own, and no other.
   */
  double GetFrameTime();
  double GetTraceTime();
  double GetQueryTime();
  double GetIsomapBuildTime();
  double GetShadeTime();
  double GetPresentTime();
  //@}

  //@{
  /**
   * Bounds of the input in its own coordinates; those of all blocks together.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  //@}

  /**
   * True if all that is shown of a volume with this mapper is opaque: no isovalue has a scalar
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
   * Free textures and shaders of a window (of all, if it is null). What is kept for the next frame
   * stays.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

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
