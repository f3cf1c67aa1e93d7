// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldSource_h
#define TemporalCoherence_FieldSource_h

#include "Input/CellOrigins.h"
#include "Input/DivisionError.h"
#include "Input/FieldFromImage.h"
#include "Input/SampleMask.h"
#include "Input/ScalarChoice.h"
#include "Scene/ArrayLooks.h"
#include "Scene/Field.h"
#include "Scene/Progress.h"
#include "Scene/SampleChanges.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkObjectBase.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkVolume;
class vtkVolumeMapper;
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The parameters for making a field from a mapper's input.
struct FieldQuery
{
  vtkVolumeMapper* Mapper = nullptr;
  vtkVolume* Volume = nullptr;
  const std::vector<double>* Isovalues = nullptr; ///< to draw; null if the volume is blended
  MaskSettings Mask;
  bool NeedsScalarRanges = false;  ///< PlacedField::ScalarRanges
  bool AveragedGradients = false;  ///< the setting SmoothMeshNormals
  std::size_t MeshMemoryLimit = 0; ///< bytes for the set-up of a mesh; 0: no limit
  ReportProgress Report;           ///< progress of long work, which it may stop
};

/// The work that setting up a field took.
enum class SetUpWork
{
  None,      ///< the field is no mesh
  Kept,      ///< everything was kept
  NewValues, ///< only values are new: the tree over the cells was kept
  Refitted,  ///< points are new: the boxes of the tree were made again
  Built      ///< cells are new: the tree was built
};

/// How a field was set up.
struct FieldSetUp
{
  SetUpWork Work = SetUpWork::None;
  double Seconds = 0.0;
  std::size_t Memory = 0;     ///< bytes of all kept structures
  bool AveragesCells = false; ///< values of cells were averaged to points
  DivisionError Error;        ///< of divided cells
};

/// A field, and where it lies.
struct PlacedField
{
  Field Samples;
  std::vector<Field> Others;            ///< the other drawn components
  std::vector<glm::dvec2> ScalarRanges; ///< of the finite samples, by drawn component
  std::optional<Field> Labels;          ///< of the samples, if a mask gives them looks (SampleMask)
  IndexTransform Transform;
  ImageAxes Axes;            ///< index space in the coordinates of cropping planes
  glm::dvec3 PerStep{ 1.0 }; ///< of GradientOpacity

  FieldSetUp SetUp;
  std::shared_ptr<const CellOrigins> Cells; ///< of a mesh: the original cells of its cells

  std::vector<SampleChange> Told; ///< changes of the samples in place (ToldChanges)

  /// Keeps the arrays alive if an observer changes the mapper's input meanwhile.
  std::vector<vtkSmartPointer<vtkObjectBase>> Read;
};

/// The values of an array that gives surfaces their colours.
struct FoundValues
{
  std::shared_ptr<const ArrayValues> Values;
  std::vector<vtkSmartPointer<vtkObjectBase>> Read; ///< as PlacedField::Read
};

/// Makes fields of one sort of data, and keeps computed arrays until the data change.
class FieldSource
{
public:
  virtual ~FieldSource() = default;

  /// Find the data to draw. Quick: nothing large is computed.
  /// \param found receives the components to draw
  /// \param error receives the mistake and its remedy
  /// \return false on error
  virtual bool Find(vtkDataObject* data, const ScalarChoice& choice, vtkVolumeProperty* property,
    const VectorChoice& vectors, DrawnComponent& found, std::string& error) = 0;

  /// True if the found data show nothing: the picture is empty.
  virtual bool IsEmpty() const = 0;

  /// Make the field of the found data.
  /// \pre Find has returned true, and IsEmpty is false
  /// \param error as above; empty if the query's report stopped it
  /// \return false on error, or if it was stopped
  /// \throws std::bad_alloc
  virtual bool Make(const FieldQuery& query, PlacedField& field, std::string& error) = 0;

  /// Make the values of another array of the found data.
  /// \pre Make has returned true for the volume
  /// \return false on error
  /// \throws std::bad_alloc
  virtual bool MakeValues(
    const ArrayChoice& choice, vtkVolume* volume, FoundValues& found, std::string& error) = 0;

  /// Drop all computed arrays.
  virtual void Release() = 0;
};

}

#endif
