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

/// The colours of a frame as vtkGPUVolumeRayCastMapper hands them out: where nothing is hit all are
/// 0, or white with an alpha of 0 where the ray passes by the box of the samples. \param key what
/// the frame was made for \throws std::bad_alloc, the image then being as it was
void WriteColors(const Frame& frame, const FrameKey& key, vtkImageData* image);

/// And its depths as a depth buffer holds them, 0 at the near plane and 1 at the far plane.
/// \param scalarType of the image: VTK_UNSIGNED_CHAR or VTK_UNSIGNED_SHORT, whose largest number is
///                   the depth 1; any other is taken for VTK_FLOAT
/// \param endsAtBox  where nothing is hit, the depth is that at which the ray leaves the box of the
///                   samples; otherwise, and where it passes by that, 1
/// \throws std::bad_alloc, the image then being as it was
void WriteDepths(
  const Frame& frame, const FrameKey& key, int scalarType, bool endsAtBox, vtkImageData* image);

}

#endif
