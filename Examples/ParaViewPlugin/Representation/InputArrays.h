// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef InputArrays_h
#define InputArrays_h

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;

/// A point or cell array, by name; without a name none.
struct ArrayChoice
{
  std::string Name;
  bool IsOnCells = false;

  vtkDataArray* In(vtkDataSet* dataSet) const;
};

/// True if what a list of arrays holds is the name of one, and not its entry "None".
bool IsArrayName(const char* name);

/// The data sets of a data object: itself, or its leaves.
std::vector<vtkDataSet*> DataSetsOf(vtkDataObject* data);

/// The scalars that a data set calls its own, or the first numbers that it has.
ArrayChoice FirstScalars(vtkDataSet* dataSet);

/// A sentence about an array that the input lacks, and which ones it has.
/// \param property of the panel that chooses the array
std::string SayMissing(const ArrayChoice& choice, vtkDataObject* data, const char* property);

#endif
