// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ZarrImage_h
#define TemporalCoherence_ZarrImage_h

#include "VolumeFiles/JsonFiles.h"

#include <string>
#include <vector>

namespace TemporalCoherence
{

/// What positions along an axis mean.
enum class ZarrAxis : std::uint8_t
{
  Time,
  Channel,
  Space,
  Other
};

/// One resolution of an image, as the image's metadata describe it.
struct ZarrImageLevel
{
  std::string Path;                ///< of the array's folder, relative to the image's
  std::vector<double> Scale;       ///< distance of samples along each axis
  std::vector<double> Translation; ///< place of the first sample along each axis
  bool HasScale = false;           ///< the scale is given
};

/// An image of OME-Zarr: arrays of the same volume, the finest first.
struct ZarrImage
{
  std::vector<ZarrAxis> Axes; ///< the slowest first; empty if they follow from their number
  std::vector<ZarrImageLevel> Levels;
};

/// Read the metadata of an image.
/// \param multiscale one of the list "multiscales"
/// \param defect     receives what is wrong; the file's name is the sentence's subject
bool ParseZarrImage(const Json& multiscale, ZarrImage& image, std::string& defect);

/// Axes of an array without names: the last of time, channel, z, y and x.
/// \param count from 2 to 5
std::vector<ZarrAxis> UnnamedZarrAxes(std::size_t count);

/// An image, or one array, in a folder.
struct ZarrSource
{
  std::filesystem::path Folder; ///< the levels' paths are relative to it
  ZarrImage Image;
};

/// Find the image or the array to read.
/// \param root   the folder that the user names
/// \param name   of an image or of a folder in it; empty: the first
/// \param source receives what was found
/// \param error  receives what is wrong, in one sentence
bool FindZarrImage(const ContainedFolder& root, JsonFiles& files, const std::string& name,
  ZarrSource& source, std::string& error);

}

#endif
