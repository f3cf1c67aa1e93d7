// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_InputFromMapper_h
#define TemporalCoherence_InputFromMapper_h

#include "Input/ImageOfGrid.h"
#include "Input/MergedBlocks.h"
#include "Input/VectorMagnitude.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
class vtkVolumeMapper;
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Which scalar of arrays of several components is drawn.
struct VectorChoice
{
  enum class Modes
  {
    Property, ///< what the volume's property says of components
    Magnitude,
    Component
  };

  Modes Mode = Modes::Property;
  int Component = 0;
};

/// What a mapper is to draw.
struct MapperInput
{
  vtkImageData* Image = nullptr; ///< a rectilinear grid, too, is seen as one
  vtkDataArray* Array = nullptr; ///< null if the image has no points: there is nothing to draw
  bool OnCells = false;          ///< one tuple for each cell, otherwise for each point
  int Component = 0;             ///< of the array
  int PropertyComponent = 0;     ///< component of the property that gives colour and shading
  std::shared_ptr<const FieldKind> Kind = UniformKind(); ///< where samples lie, among others
};

/// The first port but that of the volume that has an input; 0 if there is none.
int OtherInputPort(vtkVolumeMapper* mapper);

/// Finds what a mapper is to draw, and keeps what has to be computed for that.
class InputFromMapper
{
public:
  /// \param error gets what is wrong and what to do about it
  /// \return false on error
  bool Find(vtkVolumeMapper* mapper, vtkVolumeProperty* property, const VectorChoice& vectors,
    MapperInput& input, std::string& error);

  /// Forget what was computed.
  void Release();

private:
  bool FindImage(vtkVolumeMapper* mapper, MapperInput& input, std::string& error);
  bool ChooseComponent(vtkVolumeProperty* property, const VectorChoice& vectors, MapperInput& input,
    std::string& error);

  MergedBlocks Blocks;
  VectorMagnitude Magnitude;
  ImageOfGrid Grid;
};

}

#endif
