// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LabelKind_h
#define TemporalCoherence_LabelKind_h

#include "Kinds/FieldKind.h"
#include "Lattice/SmoothLabels.h"

namespace TemporalCoherence
{

/// The kind of images whose samples are labels.
/// \param smooth surfaces between labels; null: labels are made of the voxels around their samples
/// \throws std::bad_alloc
std::shared_ptr<const FieldKind> LabelKind(std::shared_ptr<const SmoothLabels> smooth = nullptr);

}

#endif
