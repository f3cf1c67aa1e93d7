// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalIsosurfaceRepresentation
 * @brief   ParaView's representation "Temporal Isosurface" of images and grids
 *
 * It draws with a vtkTemporalCoherenceVolumeMapper: a vtkImageData, a vtkRectilinearGrid, all
 * images of a composite data set together, as blocks of one lattice, unstructured, curvilinear and
 * adaptive grids, and composites of these. The scalars are the array that
 * is chosen for surfaces; where none is, that for colouring; where none is, the active scalars.
 *
 * In a distributed run each process draws its own part, cut where that of another begins, with
 * ghost cells beyond the cut so that gradients go on. Of grids other than images and rectilinear
 * ones each draws its own cells. If surfaces are opaque, processes'
 * pictures are put together by depth; else in the order of the parts.
 */

#ifndef vtkTemporalIsosurfaceRepresentation_h
#define vtkTemporalIsosurfaceRepresentation_h

#include "vtkImageVolumeRepresentation.h"
#include "vtkNew.h"          // For vtkNew
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <array>  // For std::array
#include <limits> // For NaN
#include <map>    // For std::map
#include <string> // For std::string
#include <vector> // For std::vector

class vtkColorTransferFunction;
class vtkDoubleArray;
class vtkIdTypeArray;
class vtkPiecewiseFunction;
class vtkTemporalCoherenceRefiner;
class vtkTemporalCoherenceVolumeMapper;
class vtkTemporalIsosurfaceLabelTable;
class vtkTextActor;
struct ArrayChoice;
struct DistributedPart;

class vtkTemporalIsosurfaceRepresentation : public vtkImageVolumeRepresentation
{
public:
  static vtkTemporalIsosurfaceRepresentation* New();
  vtkTypeMacro(vtkTemporalIsosurfaceRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  /**
   * Choose the array to colour by (index 0) and the one whose surfaces are drawn (index 1; "None"
   * or
   * "": that to colour by).
   */
  using Superclass::SetInputArrayToProcess;
  void SetInputArrayToProcess(
    int index, int port, int connection, int association, const char* name) override;

  /**
   * The component that is drawn of the array of index 1. One that it lacks: the length.
   */
  void SetSurfaceArrayComponent(int component);

  ///@{
  /**
   * What is drawn: these isovalues. If there are none: the single isovalue, if it lies in the range
   * of the values and is not a middle that ParaView gave it; else the isovalues that the volume
   * representation has for its own isosurfaces, if at least one lies in the range; else the middle
   * of the range. Isovalues that are not finite numbers are left out, with a message.
   */
  void SetNumberOfIsovalues(int number);
  void SetIsovalue(int i, double value);
  void SetSingleIsovalue(double value);
  void SetNumberOfIsosurfaces(int number);
  void SetIsosurfaceValue(int i, double value);
  ///@}

  ///@{
  /**
   * Colour is that of the lookup table at the isovalue or label or, if another array gives colours,
   * at this array's value; without an array to colour by, the solid one. Opacity is one number, or
   * (UseOpacityFunction) that of the opacity function at the isovalue or label, unless another
   * array gives colours.
   */
  void SetColor(vtkColorTransferFunction* table);
  void SetSolidColor(double red, double green, double blue);
  void SetScalarOpacity(vtkPiecewiseFunction* function);
  void SetOpacity(double opacity);
  void SetUseOpacityFunction(bool uses);
  ///@}

  ///@{
  /**
   * Red, green, blue and opacity (0 to 1) of the i-th isovalue that is drawn, in place of the
   * above. Isovalues without such a look keep colour and opacity of the above. Numbers beyond 0 and
   * 1 are clamped.
   */
  void SetNumberOfSurfaceLooks(int number);
  void SetSurfaceLook(int i, double red, double green, double blue, double opacity);
  ///@}

  ///@{
  /**
   * Labels (SurfaceMode) with an opacity of their own. 0: the label is not drawn. A categorical
   * lookup table with EnableOpacityMapping gives those of other labels.
   */
  void SetNumberOfLabelOpacities(int number);
  void SetLabelOpacity(int i, double label, double opacity);
  ///@}

  /**
   * Cut off what is outside of a box: that of CroppingOrigin and CroppingScale, which are meant for
   * the bounds of the whole volume.
   */
  void SetCropping(int crops);

  ///@{
  /**
   * See vtkTemporalCoherenceVolumeMapper.
   */
  void SetSurfaceMode(int mode);
  void SetLabelRadius(double samples);
  void SetOutsideLabel(int label);
  void SetAmbientOcclusion(bool on);
  void SetAmbientOcclusionRadius(double radius);
  void SetAmbientOcclusionStrength(double strength);
  void SetReuseAccuracy(int accuracy);
  void SetReuseFrames(bool on);
  void SetIsomap(bool on);
  void SetIsomapTolerance(double voxels);
  void SetIsomapRange(double lowest, double highest);
  void SetIsomapMemoryLimit(int mebibytes);
  void SetRefineWhenStill(bool on);
  void SetColorByAnswer(bool on);
  ///@}

  /**
   * Write a line about the last frame into the view.
   */
  void SetShowStatistics(bool shows);

  /**
   * Write the view of the last frame for every isovalue, as vtkTemporalCoherenceViewWriter does: a
   * page (.html), a view file (.tcview) or a Cinema database (.cdb). Errors are reported. In one
   * process only; an empty path is ignored.
   */
  void WriteView(const char* path);

  /**
   * Hides the line of statistics, too.
   */
  void SetVisibility(bool visible) override;

  ///@{
  /**
   * The last frame of this process: its route, the milliseconds it took, how far its light is, its
   * counters, and the bytes of the isomap that is kept.
   */
  const char* GetRoute();
  double GetFrameMilliseconds();
  double GetFrameProgress();
  vtkIdType GetNumberOfRays();
  vtkIdType GetNumberOfTracedRays();
  vtkIdType GetNumberOfDefiniteHits();
  vtkIdType GetNumberOfPossibleHits();
  vtkIdType GetIsomapMemory();
  ///@}

  /**
   * How many frames took each route, since this was made: Cold, Redisplay, Reshade, IsomapLookup,
   * IsomapBuild, a number without a route, ImageCache, TimeStep, Recomposite, a number without a
   * route, KeepValues, Antialias, FewerRays, Refine, KeepLabels.
   * Frames that failed are not counted.
   */
  vtkIdTypeArray* GetRouteCounts();

  ///@{
  /**
   * The isovalues that the last frame was made for, and the least and the largest value of the
   * scalars in all processes.
   */
  vtkDoubleArray* GetShownIsovalues();
  vtkDoubleArray* GetScalarRange();
  ///@}

protected:
  vtkTemporalIsosurfaceRepresentation();
  ~vtkTemporalIsosurfaceRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void UpdateMapperParameters() override;

private:
  vtkTemporalIsosurfaceRepresentation(const vtkTemporalIsosurfaceRepresentation&) = delete;
  void operator=(const vtkTemporalIsosurfaceRepresentation&) = delete;

  vtkTemporalCoherenceVolumeMapper* GetMapper();
  bool AreLabelsDrawn();
  bool IsTranslucent();
  void PrepareAgainUnless(bool wasTranslucent);
  int CountGhostLayers();
  void AskForGhostLayersUnless(int layersBefore);
  ArrayChoice ArrayChosenFor(int index);
  bool IsColoredByArray();
  bool IsColoredBySecondArray();
  int ColorComponent();
  int SurfaceComponent();
  ArrayChoice ChooseArray(vtkDataObject* data);
  std::array<double, 2> RangeOfScalars(const DistributedPart& part);
  std::string FindMistakeInLabels(const DistributedPart& part, const std::string& name);
  std::string FindMistakeInCuts(const DistributedPart& part);
  void ShowScalars(const ArrayChoice& choice);
  std::vector<double> ChooseIsovalues(const std::array<double, 2>& range);
  std::string ShowIsovalues(const std::array<double, 2>& range, const std::string& name);
  std::string ShowLooks(vtkDataObject* data, const ArrayChoice& drawn);
  void ShowSurfaceLooks(vtkColorTransferFunction* colors, vtkPiecewiseFunction* opacities);
  std::string ShowSecondArray(vtkDataObject* data, const ArrayChoice& drawn);
  vtkColorTransferFunction* ColorsOfSurfaceArray();
  vtkPiecewiseFunction* OpacitiesOfSurfaceArray();
  void UpdateLabelTable();
  void ShowRegion(const DistributedPart& part);
  void ReportOnce(const std::string& message);
  void TakeStatistics(vtkObject* mapper, unsigned long event, void* isMade);

  /// Indices of SetInputArrayToProcess.
  enum ArrayIndices
  {
    ColorArray = 0,
    SurfaceArray = 1
  };
  using Look = std::array<double, 4>; ///< red, green, blue, opacity

  std::vector<double> Isovalues;
  std::vector<double> VolumeIsovalues;
  double SingleIsovalue = std::numeric_limits<double>::quiet_NaN(); ///< NaN: not set yet
  double Untouched = SingleIsovalue; ///< the value that ParaView gave it
  std::vector<Look> SurfaceLooks;
  std::map<double, Look> LooksInFunctions; ///< by isovalue
  vtkSmartPointer<vtkColorTransferFunction> Table;
  vtkSmartPointer<vtkPiecewiseFunction> OpacityFunction;
  vtkNew<vtkColorTransferFunction> SolidColor;
  vtkNew<vtkPiecewiseFunction> ConstantOpacity;
  std::vector<std::array<double, 2>> LabelOpacities; ///< label, opacity
  vtkNew<vtkTemporalIsosurfaceLabelTable> LabelTable;
  int SurfaceArrayComponent = 0;
  int NumberOfComponents = 1; ///< of the array that is drawn
  vtkNew<vtkColorTransferFunction> ColorsOfSurfaces;
  vtkNew<vtkPiecewiseFunction> OpacitiesOfSurfaces;
  double Opacity = 1.0;
  bool UseOpacityFunction = false;
  bool Crops = false;
  bool HasMeshes = false;  ///< of any process, in the cache
  std::string LastMessage; ///< reported already
  bool ShowStatistics = false;
  vtkNew<vtkTextActor> StatisticsText;
  vtkNew<vtkTemporalCoherenceRefiner> Refiner; ///< of the view's window
  vtkNew<vtkIdTypeArray> RouteCounts;
  vtkNew<vtkDoubleArray> ShownIsovalues;
  vtkNew<vtkDoubleArray> ScalarRange;
};

#endif
