// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RawVolume_h
#define TemporalCoherence_RawVolume_h

#include "VolumeFiles/RawLayout.h"
#include "VolumeFiles/VolumeFile.h"

#include <memory>
#include <string>

namespace TemporalCoherence
{

/// Open a file of plain samples. It is mapped into memory if samples can be used as they lie in the
/// file: in this machine's byte order, and aligned. All files can be read chunk by chunk.
/// \param error receives what is wrong and what to do, in one sentence
/// \return null on error
std::unique_ptr<VolumeFile> OpenRaw(
  const std::string& path, const RawLayout& layout, std::string& error);

}

#endif
