// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BufferImages_h
#define TemporalCoherence_BufferImages_h

#include "Scene/Frame.h"
#include "Scene/FrameKey.h"
#include "vtkTemporalCoherenceCompatibility.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The colours of a frame as vtkGPUVolumeRayCastMapper returns them. The colour of a miss is 0, or
/// white with an alpha of 0 if the ray misses the box of the samples.
/// \param key of the frame
/// \throws std::bad_alloc; the image is then unchanged
void WriteColors(const Frame& frame, const FrameKey& key, vtkImageData* image);

/// The depths of a frame as in a depth buffer: 0 at the near plane, 1 at the far plane.
/// \param scalarType of the image: VTK_UNSIGNED_CHAR or VTK_UNSIGNED_SHORT, whose largest number is
///                   the depth 1; any other type means VTK_FLOAT
/// \param endsAtBox  the depth of a miss is where the ray leaves the box of the samples, or 1 if it
///                   misses the box; otherwise it is always 1
/// \throws std::bad_alloc; the image is then unchanged
void WriteDepths(
  const Frame& frame, const FrameKey& key, int scalarType, bool endsAtBox, vtkImageData* image);

}

#endif
