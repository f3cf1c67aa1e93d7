// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VtiVolume_h
#define TemporalCoherence_VtiVolume_h

#include "VolumeFiles/VolumeFile.h"

#include <memory>
#include <string>

namespace TemporalCoherence
{

/// Open VTK's XML format of images. The samples must lie as they are in the appended data: raw, not
/// compressed. vtkXMLImageDataWriter writes such files after SetDataModeToAppended(),
/// EncodeAppendedDataOff() and SetCompressorTypeToNone().
/// \param array name of an array on points; empty: the active scalars, else the first array
/// \param error receives what is wrong and what to do, in one sentence
/// \return null on error
std::unique_ptr<VolumeFile> OpenVti(
  const std::string& path, const std::string& array, std::string& error);

}

#endif
