// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SettingsFromMapper_h
#define TemporalCoherence_SettingsFromMapper_h

#include "Render/FrameRenderer.h"
#include "Request/RequestFromMapper.h"
#include "vtkTemporalCoherenceCompatibility.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkTemporalCoherenceVolumeMapper;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Read the mapper's own settings that affect its pictures.
PictureSettings SettingsOf(vtkTemporalCoherenceVolumeMapper* mapper);

/// Read the mapper's options for making frames. ReportsTiles stays false.
/// \param isForImage the frame is for an image, not for a window
FrameRenderer::Options OptionsOf(vtkTemporalCoherenceVolumeMapper* mapper, bool isForImage);

}

#endif
