// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ImageSource_h
#define TemporalCoherence_ImageSource_h

#include "Input/FieldSource.h"
#include "Input/HiddenCellsFromImage.h"
#include "Input/ImageOfGrid.h"
#include "Input/ImageValues.h"
#include "Input/MergedBlocks.h"
#include "Input/SamplesOfArray.h"
#include "Input/VectorMagnitude.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Makes the fields of images, of rectilinear grids, and of blocks that are images on one lattice.
class ImageSource : public FieldSource
{
public:
  bool Find(vtkDataObject* data, const ScalarChoice& choice, vtkVolumeProperty* property,
    const VectorChoice& vectors, DrawnComponent& found, std::string& error) override;
  bool IsEmpty() const override { return !this->Found.Array; }
  bool Make(const FieldQuery& query, PlacedField& field, std::string& error) override;
  bool MakeValues(
    const ArrayChoice& choice, vtkVolume* volume, FoundValues& found, std::string& error) override
  {
    return this->Values.Make(this->Data, choice, volume, found, error);
  }
  void Release() override;

private:
  bool FindImage(vtkDataObject* data, const ScalarChoice& choice, std::string& error);
  bool MakeLabels(
    const MaskSettings& settings, const SampleMask& mask, PlacedField& field, std::string& error);
  bool MakeOthers(PlacedField& field, std::string& error) const;
  void FindRanges(PlacedField& field);
  void FindScalar(vtkVolumeProperty* property, const VectorChoice& vectors);

  /// The found image and array. The pointers are not owned.
  struct FoundImage
  {
    vtkImageData* Image = nullptr; ///< also stands for a rectilinear grid
    vtkDataArray* Array = nullptr; ///< null if the image has no points
    bool OnCells = false;          ///< one tuple for each cell, otherwise for each point
    DrawnComponent Component;
    std::shared_ptr<const FieldShape> Shape = UniformShape(); ///< the places of samples
  };

  vtkDataObject* Data = nullptr; ///< in which the image was found; not owned
  FoundImage Found;
  ArraysInPlace Arrays;
  MergedBlocks Blocks;
  VectorMagnitude Magnitude;
  ImageOfGrid Grid;
  HiddenCellsOfImage Hidden;
  ImageValues Values; ///< of another array

  /// The range of a component's finite samples.
  struct KnownRange
  {
    Field Of;
    glm::dvec2 Range;
  };
  std::vector<KnownRange> Ranges; ///< of the components that were drawn last
};

}

#endif
