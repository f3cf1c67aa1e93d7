// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_MaskedTruth_h
#define Testing_MaskedTruth_h

#include "Truth/BruteForceField.h"

#include <functional>

namespace Masks
{

/// Hide the cells of the truth none of whose samples is shown by a mask on points.
void Hide(vtkImageData* mask, const std::function<bool(double)>& isShown, BruteForceField& field);

/// The same for a binary mask.
void Hide(vtkImageData* mask, BruteForceField& field);

}

#endif
