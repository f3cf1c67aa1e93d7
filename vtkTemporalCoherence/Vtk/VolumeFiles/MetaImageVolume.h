// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MetaImageVolume_h
#define TemporalCoherence_MetaImageVolume_h

#include "VolumeFiles/VolumeFile.h"

#include <memory>
#include <string>

namespace TemporalCoherence
{

/// Open a .mhd or .mha file: a header in text, and samples in one other file or after the header.
/// The samples must be raw: not compressed, of one component, in three dimensions. Rotated images
/// are an error, as a volume file has no directions. \param error receives what is wrong and what
/// to do, in one sentence \return null on error
std::unique_ptr<VolumeFile> OpenMetaImage(const std::string& path, std::string& error);

}

#endif
