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

/// The first port other than 0 with an input; 0 if there is none.
int OtherInputPort(vtkVolumeMapper* mapper);

/// Makes the field that a mapper draws. This is where the input is told to be an image or a mesh:
/// each has a source of its own, and nothing else asks.
class FieldFromMapper
{
public:
  /// Find what there is to draw, by isosurfaces or, if components are to be blended, otherwise.
  /// \param found gets which components are drawn
  /// \param error gets what is wrong and what to do about it
  /// \return false on error
  bool Find(vtkVolumeMapper* mapper, vtkVolumeProperty* property, const VectorChoice& vectors,
    DrawnComponent& found, std::string& error);

  /// True if there is nothing to draw of what was found, which is no mistake: the picture is empty.
  bool IsEmpty() const { return this->Source->IsEmpty(); }

  /// Make the field of what was found.
  /// \pre Find has returned true, and IsEmpty is false
  /// \param error as above; empty if the query's report stopped it
  /// \return false on error, or if it was stopped
  bool Make(const FieldQuery& query, PlacedField& field, std::string& error);

  /// Drop what was computed.
  void Release();

private:
  bool ChooseSource(vtkDataObject* data, bool areBlended, std::string& error);

  ImageSource Images;
  MeshSource Meshes;
  FieldSource* Source = nullptr;            ///< of the data that were found
  vtkSmartPointer<vtkDataObject> OnlyLevel; ///< of an adaptive grid, as blocks; or null
};

}

#endif
