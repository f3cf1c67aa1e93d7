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

/// Which scalar to draw if arrays have several components.
struct VectorChoice
{
  enum class Modes
  {
    Property, ///< as the volume's property treats components
    Magnitude,
    Component
  };

  Modes Mode = Modes::Property;
  int Component = 0;
};

/// What a mapper has to draw.
struct MapperInput
{
  vtkImageData* Image = nullptr; ///< also stands for a rectilinear grid
  vtkDataArray* Array = nullptr; ///< null if the image has no points: there is nothing to draw
  bool OnCells = false;          ///< one tuple for each cell, otherwise for each point
  int Component = 0;             ///< of the array
  int PropertyComponent = 0;     ///< component of the property that gives colour and shading
  std::shared_ptr<const FieldKind> Kind = UniformKind(); ///< for example where samples lie
};

/// The first port other than 0 with an input; 0 if there is none.
int OtherInputPort(vtkVolumeMapper* mapper);

/// Finds what a mapper has to draw, and keeps what had to be computed for it.
class InputFromMapper
{
public:
  /// \param error gets what is wrong and what to do about it
  /// \return false on error
  bool Find(vtkVolumeMapper* mapper, vtkVolumeProperty* property, const VectorChoice& vectors,
    MapperInput& input, std::string& error);

  /// Drop what was computed.
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
