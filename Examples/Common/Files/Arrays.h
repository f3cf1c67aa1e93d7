// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Arrays_h
#define Arrays_h

#include "Files/Volume.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

class vtkAbstractVolumeMapper;
class vtkDataArray;
class vtkDataSet;

// The data sets of a data object: itself, or its leaves.
std::vector<vtkDataSet*> DataSetsOf(vtkDataObject* data);

// Whether a data set is more than an image or a rectilinear grid, or the data is adaptive.
bool HasMeshes(vtkDataObject* data);

// The arrays of numbers that a data set or any leaf has, those at points first.
std::vector<ArrayChoice> AllArrays(vtkDataObject* data);

// The array of a data set that a choice names; null if it has none.
vtkDataArray* ArrayOf(vtkDataSet* set, const ArrayChoice& choice);

// The array that is drawn, of each data set that has it.
std::vector<vtkDataArray*> ShownArrays(const Volume& volume);

// Choose what is drawn by its name; without one, the first array that holds the isovalue, or else
// the first one whose values differ; of an image first its own scalars. Throws UserError if there
// is no such array.
void ChooseArray(
  Volume& volume, const std::string& name, const std::optional<double>& isovalue = std::nullopt);

// The array after the one that is drawn; the first follows the last. Empty if there is no other.
std::string NextArray(const Volume& volume);

// Let a mapper draw the volume's array.
void ShowArray(const Volume& volume, vtkAbstractVolumeMapper* mapper);

// What else could be drawn: "choose another array by --array: p, v; or ...". Empty if there is
// nothing.
std::string OthersThan(const Volume& volume);

// Whether samples may be labels: those of an image, which are whole numbers of one component.
bool AreWholeNumbers(const Volume& volume);

// The different values of such samples, ascending. At most so many are looked for. Values beyond
// the range of int are left out.
std::vector<int> WholeNumbersOf(vtkDataArray* array, std::size_t most);

// "256 x 256 x 110  uchar", or "7472 cells  double Temp"
std::string DescriptionOf(const Volume& volume);

#endif
