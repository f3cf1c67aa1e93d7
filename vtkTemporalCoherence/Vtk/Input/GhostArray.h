// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GhostArray_h
#define TemporalCoherence_GhostArray_h

#include "Input/SamplesOfArray.h"

#include <vtkDataSetAttributes.h>
#include <vtkUnsignedCharArray.h>

#include <cstdint>
#include <string>

namespace TemporalCoherence
{

/// The ghost array of points or cells, or null.
inline vtkUnsignedCharArray* GhostsOf(vtkDataSetAttributes* attributes)
{
  // The data set may answer with an array that has been replaced.
  return vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
}

/// Find the flags of points or cells.
/// \param flags null if there is no ghost array
/// \param error receives the mistake and its remedy
/// \return false if the number of flags is wrong
inline bool FindFlags(vtkDataSetAttributes* attributes, const ArrayPlaces& places,
  const std::uint8_t*& flags, std::string& error)
{
  vtkUnsignedCharArray* const ghosts = GhostsOf(attributes);
  flags = ghosts ? ghosts->GetPointer(0) : nullptr;
  if (!ghosts || (HasOneForEach(ghosts, places) && ghosts->GetNumberOfComponents() == 1))
  {
    return true;
  }
  error = places.Owner + " has a ghost array " + NameOf(ghosts) + " of " +
    std::to_string(ghosts->GetNumberOfTuples()) + " tuples of " +
    std::to_string(ghosts->GetNumberOfComponents()) + " component(s), but " +
    std::to_string(places.Count) + (places.AreCells ? " cells" : " points") +
    "; give it one value for each, or remove it.";
  return false;
}

}

#endif
