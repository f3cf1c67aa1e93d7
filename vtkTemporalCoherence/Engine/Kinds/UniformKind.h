// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_UniformKind_h
#define TemporalCoherence_UniformKind_h

#include "Kinds/FieldKind.h"

namespace TemporalCoherence
{

/// The kind of images: samples lie at integer coordinates.
const FieldKind& UniformKind();

}

#endif
