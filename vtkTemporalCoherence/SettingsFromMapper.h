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

/// The settings of the mapper on which its pictures depend.
PictureSettings SettingsOf(vtkTemporalCoherenceVolumeMapper* mapper);

/// The settings of the mapper on how frames are made. ReportsTiles is off.
FrameRenderer::Options OptionsOf(vtkTemporalCoherenceVolumeMapper* mapper);

}

#endif
