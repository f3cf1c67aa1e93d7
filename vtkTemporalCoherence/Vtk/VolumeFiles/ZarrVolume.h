// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ZarrVolume_h
#define TemporalCoherence_ZarrVolume_h

#include "VolumeFiles/VolumeFile.h"

namespace TemporalCoherence
{

/// Open a volume of OME-Zarr or of plain Zarr, in version 2 or 3 of Zarr.
///
/// The folder is an image with several resolutions, or an array with 2 to 5 axes (time, channel, z,
/// y and x), or a group that holds such. A chunk without a file has the array's fill value.
/// \param path   the folder, or a file with metadata in it
/// \param choice channel, time point, and the image's name or its folder relative to `path`
/// \param error  receives what is wrong and what to do, in one sentence
/// \return null on error
std::unique_ptr<VolumeFile> OpenZarr(
  const std::string& path, const VolumeChoice& choice, std::string& error);

}

#endif
