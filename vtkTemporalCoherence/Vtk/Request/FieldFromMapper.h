// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FieldFromMapper_h
#define TemporalCoherence_FieldFromMapper_h

#include "Grids/MeshSource.h"
#include "Input/ImageSource.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolumeMapper;
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The first port other than 0 with an input, or 0.
int OtherInputPort(vtkVolumeMapper* mapper);

/// Makes the field that a mapper draws. It alone decides between the sources for images and for
/// meshes.
class FieldFromMapper
{
public:
  /// Find the data to draw, by isosurfaces or blended (VectorChoice::AreBlended).
  /// \param found receives the components to draw
  /// \param error receives the mistake and its remedy
  /// \return false on error
  bool Find(vtkVolumeMapper* mapper, vtkVolumeProperty* property, const VectorChoice& vectors,
    DrawnComponent& found, std::string& error);

  /// True if the found data show nothing, which is no mistake: the picture is empty.
  bool IsEmpty() const { return this->Source->IsEmpty(); }

  /// Make the field of the found data.
  /// \pre Find has returned true, and IsEmpty is false
  /// \param error as above; empty if the query's report stopped it
  /// \return false on error, or if it was stopped
  bool Make(const FieldQuery& query, PlacedField& field, std::string& error);

  /// Make the values of another array of the found data.
  /// \pre Make has returned true
  bool MakeValues(
    const ArrayChoice& choice, vtkVolume* volume, FoundValues& found, std::string& error);

  /// Drop all computed arrays.
  void Release();

private:
  bool ChooseSource(vtkDataObject* data, bool areBlended, std::string& error);

  ImageSource Images;
  MeshSource Meshes;
  FieldSource* Source = nullptr;            ///< of the found data
  vtkSmartPointer<vtkDataObject> OnlyLevel; ///< of an adaptive grid, as blocks; or null
};

}

#endif
