// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/VolumeOpener.h"

#include "OutOfCore/SampleHash.h"
#include "VolumeFiles/MetaImageVolume.h"
#include "VolumeFiles/NrrdVolume.h"
#include "VolumeFiles/RawVolume.h"
#include "VolumeFiles/ReaderVolume.h"
#include "VolumeFiles/VtiVolume.h"
#include "VolumeFiles/VtkTypes.h"
#ifdef TEMPORAL_COHERENCE_HAS_ZARR
#include "VolumeFiles/ZarrVolume.h"
#endif
#ifdef TEMPORAL_COHERENCE_HAS_HDF5
#include "VolumeFiles/Hdf5Volume.h"
#endif

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace TemporalCoherence
{
namespace
{

namespace fs = std::filesystem;

std::string ExtensionOf(const fs::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::unique_ptr<VolumeFile> OpenRawSamples(const VolumeRequest& request, std::string& error)
{
  const auto type = TypeOfVtk(request.RawType);
  if (!type || request.RawHeaderSize < 0)
  {
    error = "The scalar type " + std::to_string(request.RawType) + " or the header size " +
      std::to_string(request.RawHeaderSize) +
      " of SetRawLayout is not possible; give VTK_UNSIGNED_CHAR, for example, and 0.";
    return nullptr;
  }
  return OpenRaw(request.Path,
    { *type, request.RawDimensions, request.RawSpacing, request.RawOrigin,
      static_cast<std::uint64_t>(request.RawHeaderSize), request.RawIsBigEndian },
    error);
}

std::unique_ptr<VolumeFile> OpenFolder(const VolumeRequest& request, std::string& error)
{
#ifdef TEMPORAL_COHERENCE_HAS_ZARR
  return OpenZarr(request.Path, request.Choice, error);
#else
  error = request.Path +
    " is a folder, but this build cannot read Zarr; build with nlohmann_json, c-blosc, zstd and "
    "zlib.";
  return nullptr;
#endif
}

std::unique_ptr<VolumeFile> OpenHierarchy(const VolumeRequest& request, std::string& error)
{
#ifdef TEMPORAL_COHERENCE_HAS_HDF5
  return OpenHdf5(request.Path, request.Choice, error);
#else
  error = request.Path + " cannot be read, as this build has no HDF5; build with libhdf5.";
  return nullptr;
#endif
}

/// The user's folder for files that can be made again; empty if there is none.
fs::path CacheFolder()
{
  const char* const named = std::getenv("XDG_CACHE_HOME");
  const char* const home = std::getenv("HOME");
  const fs::path folder = named && *named ? fs::path(named)
    : home && *home                       ? fs::path(home) / ".cache"
                                          : fs::path();
  return folder.empty() ? folder : folder / "vtkTemporalCoherence";
}

}

std::shared_ptr<const VolumeFile> OpenVolume(const VolumeRequest& asked, std::string& error)
{
  if (asked.Reader)
  {
    return OpenReader(asked.Reader, asked.Choice.Array, error);
  }
  // One name for a volume, from wherever it is opened: its value ranges are kept under it.
  std::error_code ignored;
  VolumeRequest request = asked;
  const fs::path path =
    asked.Path.empty() ? fs::path() : fs::absolute(asked.Path, ignored).lexically_normal();
  request.Path = path.string();
  const std::string extension = ExtensionOf(path);
  if (request.Path.empty())
  {
    error = "There is no volume; call SetFileName or SetReader.";
    return nullptr;
  }
  if (!fs::exists(path, ignored))
  {
    error = request.Path + " is not there; check the name.";
    return nullptr;
  }
  if (fs::is_directory(path, ignored))
  {
    return OpenFolder(request, error);
  }
  if (extension == ".mhd" || extension == ".mha")
  {
    return OpenMetaImage(request.Path, error);
  }
  if (extension == ".nrrd" || extension == ".nhdr")
  {
    return OpenNrrd(request.Path, error);
  }
  if (extension == ".vti")
  {
    return OpenVti(request.Path, request.Choice.Array, error);
  }
  if (extension == ".ims" || extension == ".h5" || extension == ".hdf5")
  {
    return OpenHierarchy(request, error);
  }
  if (request.RawDimensions != glm::ivec3(0))
  {
    return OpenRawSamples(request, error);
  }
  error = request.Path +
    " has no name that tells its format; say how raw samples lie in it with SetRawLayout, or give "
    "a "
    "reader with SetReader.";
  return nullptr;
}

std::vector<std::string> RangesPathsOf(const std::string& path, const std::string& folder,
  const VolumeFile& file, const VolumeChoice& choice, int level)
{
  std::error_code ignored;
  std::ostringstream part;
  part << (level > 0 ? ".level" + std::to_string(level) : "")
       << (choice.Channel > 0 ? ".channel" + std::to_string(choice.Channel) : "")
       << (choice.TimePoint > 0 ? ".time" + std::to_string(choice.TimePoint) : "");
  if (!choice.Array.empty())
  {
    part << '.' << std::hex << HashOf(choice.Array.data(), choice.Array.size());
  }
  // Names do not tell the state of the volume, so that the file of a new state replaces the old
  // one.
  const std::string whole =
    path.empty() ? file.Identity() : fs::absolute(path, ignored).lexically_normal().string();
  std::ostringstream hash;
  hash << std::hex << HashOf(whole.data(), whole.size());
  std::vector<std::string> paths;
  const auto add = [&](const fs::path& in)
  {
    fs::create_directories(in, ignored);
    paths.push_back((in / (hash.str() + part.str() + ".ranges")).string());
  };
  if (!folder.empty())
  {
    add(folder);
    return paths;
  }
  if (!path.empty())
  {
    const fs::path normal = fs::path(path).lexically_normal();
    paths.push_back(
      (normal.has_filename() ? normal : normal.parent_path()).string() + part.str() + ".ranges");
  }
  if (const fs::path cache = CacheFolder(); !cache.empty())
  {
    add(cache);
  }
  return paths;
}

}
