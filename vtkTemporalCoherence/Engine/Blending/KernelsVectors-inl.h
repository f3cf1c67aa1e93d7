// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The vectors of the kernels of emission.
// Kernels include this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsVectors_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsVectors_inl_h
#undef TemporalCoherence_KernelsVectors_inl_h
#else
#define TemporalCoherence_KernelsVectors_inl_h
#endif

#include "Scene/RayBatch.h"

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, WidestVector>;
using Integers = hn::Rebind<std::int32_t, Floats>;
using V = hn::Vec<Floats>;
using I = hn::Vec<Integers>;
using M = hn::Mask<Floats>;

}
}
}
HWY_AFTER_NAMESPACE();

#endif
