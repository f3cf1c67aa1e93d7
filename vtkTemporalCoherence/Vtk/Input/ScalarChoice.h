// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ScalarChoice_h
#define TemporalCoherence_ScalarChoice_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSet;
class vtkVolumeMapper;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The array chosen by the user of a mapper: scalar mode and, for field data, name or number.
struct ScalarChoice
{
  int Mode = 0; ///< VTK_SCALAR_MODE_...
  bool IsByName = false;
  int Number = -1;
  std::string Name;
};

ScalarChoice ChoiceOf(vtkVolumeMapper* mapper);

/// The array of a data set for a choice.
struct ChosenScalars
{
  vtkDataArray* Array = nullptr; ///< null if there is none
  bool OnCells = false;
};

ChosenScalars FindScalars(vtkDataSet* dataSet, const ScalarChoice& choice);

/// The error message if there are no scalars for a choice.
std::string WhyThereAreNoScalars(const ScalarChoice& choice);

}

#endif
