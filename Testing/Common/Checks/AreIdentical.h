// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_AreIdentical_h
#define Testing_AreIdentical_h

#include <vtkImageData.h>

#include <cstddef>
#include <cstring>

/// True if both have the same size, type and bytes.
inline bool AreIdentical(vtkImageData* a, vtkImageData* b)
{
  const auto bytes = static_cast<std::size_t>(a->GetNumberOfPoints()) *
    static_cast<std::size_t>(a->GetNumberOfScalarComponents() * a->GetScalarSize());
  return a->GetNumberOfPoints() == b->GetNumberOfPoints() &&
    a->GetScalarType() == b->GetScalarType() &&
    a->GetNumberOfScalarComponents() == b->GetNumberOfScalarComponents() &&
    std::memcmp(a->GetScalarPointer(), b->GetScalarPointer(), bytes) == 0;
}

#endif
