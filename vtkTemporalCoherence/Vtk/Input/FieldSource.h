// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldSource_h
#define TemporalCoherence_FieldSource_h

#include "Input/DivisionError.h"
#include "Input/FieldFromImage.h"
#include "Input/SampleMask.h"
#include "Input/ScalarChoice.h"
#include "Scene/Field.h"
#include "Scene/Progress.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkObjectBase.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <memory>
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

/// What is asked of the data that a mapper draws.
struct FieldQuery
{
  vtkVolumeMapper* Mapper = nullptr;
  vtkVolume* Volume = nullptr;
  const std::vector<double>* Isovalues = nullptr; ///< to draw; null if the volume is blended
  MaskSettings Mask;
  bool NeedsScalarRanges = false;  ///< PlacedField::ScalarRanges
  bool AveragedGradients = false;  ///< of meshes
  std::size_t MeshMemoryLimit = 0; ///< bytes for what is made of a mesh; 0: no limit
  ReportProgress Report;           ///< of what takes long; it may stop it
};

class CellOrigins;

/// What had to be done to set up a field.
enum class SetUpWork
{
  None,      ///< nothing that is told: the field is no mesh
  Kept,      ///< everything was there
  NewValues, ///< only values are new: the tree over the cells was kept
  Refitted,  ///< points are new: the boxes of the tree were made again
  Built      ///< cells are new: the tree was built
};

/// How a field was set up.
struct FieldSetUp
{
  SetUpWork Work = SetUpWork::None;
  double Seconds = 0.0;
  std::size_t Memory = 0;     ///< bytes of what is kept
  bool AveragesCells = false; ///< values of cells were averaged to points
  DivisionError Error;        ///< of cells that were divided
};

/// A field, and where it lies.
struct PlacedField
{
  Field Samples;
  std::vector<Field> Others;            ///< of the components drawn, all but the first
  std::vector<glm::dvec2> ScalarRanges; ///< of the finite samples, by component drawn
  IndexTransform Transform;
  ImageAxes Axes;            ///< index space in the coordinates of cropping planes
  glm::dvec3 PerStep{ 1.0 }; ///< of GradientOpacity

  FieldSetUp SetUp;
  std::shared_ptr<const CellOrigins> Cells; ///< of a mesh: which cells of the data are its cells

  /// Keeps what is read alive if an observer gives the mapper another input meanwhile.
  std::vector<vtkSmartPointer<vtkObjectBase>> Read;
};

/// Makes fields of one sort of data, and keeps what it had to compute for that until the data
/// change.
class FieldSource
{
public:
  virtual ~FieldSource() = default;

  /// Find what there is to draw. Nothing is made that takes long.
  /// \param found gets which components are drawn
  /// \param error gets what is wrong and what to do about it
  /// \return false on error
  virtual bool Find(vtkDataObject* data, const ScalarChoice& choice, vtkVolumeProperty* property,
    const VectorChoice& vectors, DrawnComponent& found, std::string& error) = 0;

  /// True if there is nothing to draw of what was found: the picture is empty.
  virtual bool IsEmpty() const = 0;

  /// Make the field of what was found.
  /// \pre Find has returned true, and IsEmpty is false
  /// \param error as above; empty if the query's report stopped it
  /// \return false on error, or if it was stopped
  /// \throws std::bad_alloc
  virtual bool Make(const FieldQuery& query, PlacedField& field, std::string& error) = 0;

  /// Drop what was computed.
  virtual void Release() = 0;
};

}

#endif
