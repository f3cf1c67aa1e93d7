// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VolumeOpener_h
#define TemporalCoherence_VolumeOpener_h

#include "VolumeFiles/VolumeFile.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkType.h>

#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// What volume to open.
struct VolumeRequest
{
  std::string Path;               ///< of a file or a folder
  vtkAlgorithm* Reader = nullptr; ///< instead of a file; null for none
  VolumeChoice Choice;
  /// How samples lie in a file whose name tells no format. Dimensions of 0: that is not known.
  glm::ivec3 RawDimensions{ 0 };
  int RawType = 0; ///< VTK's number
  std::int64_t RawHeaderSize = 0;
  bool RawIsBigEndian = false;
  glm::dvec3 RawSpacing{ 1.0 }, RawOrigin{ 0.0 };
};

/// Open a volume of any format that is known, told by its name.
/// \param error receives what is wrong, in one sentence
/// \return null on error
/// \throws std::bad_alloc
std::shared_ptr<const VolumeFile> OpenVolume(const VolumeRequest& asked, std::string& error);

/// Where the value ranges of a volume may be kept: the best place first.
/// \param path   of the volume; empty if a reader gives it
/// \param folder that the user chose; empty for none
std::vector<std::string> RangesPathsOf(const std::string& path, const std::string& folder,
  const VolumeFile& file, const VolumeChoice& choice, int level);

}

#endif
