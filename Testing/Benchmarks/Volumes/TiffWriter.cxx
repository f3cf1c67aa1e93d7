// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Slabs.h"
#include "VolumeWriters.h"

#include <vtk_tiff.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

using TemporalCoherence::ScalarType;

namespace
{

struct CloseTiff
{
  void operator()(TIFF* file) const { TIFFClose(file); }
};

/// The library's number of a codec; -1 if it is unknown, or if the library was built without it.
int CodecOf(const std::string& name)
{
  const int codec = name.empty() || name == "none" ? COMPRESSION_NONE
    : name == "lzw"                                ? COMPRESSION_LZW
    : name == "deflate"                            ? COMPRESSION_ADOBE_DEFLATE
    : name == "zstd"                               ? COMPRESSION_ZSTD
                                                   : -1;
  return codec >= 0 && TIFFIsCODECConfigured(static_cast<std::uint16_t>(codec)) ? codec : -1;
}

/// Write a file of one slice.
bool WriteSlice(
  const std::string& path, const VolumeOrder& order, int codec, const unsigned char* samples)
{
  const std::unique_ptr<TIFF, CloseTiff> file(TIFFOpen(path.c_str(), "w"));
  if (!file)
  {
    return false;
  }
  const auto width = static_cast<std::uint32_t>(order.Dimensions.x);
  const auto height = static_cast<std::uint32_t>(order.Dimensions.y);
  const std::size_t size = TemporalCoherence::SizeOf(order.Type);
  const std::size_t row = size * width;
  const auto rows =
    static_cast<std::uint32_t>(std::clamp<std::size_t>((std::size_t(256) << 10) / row, 1, height));
  TIFFSetField(file.get(), TIFFTAG_IMAGEWIDTH, width);
  TIFFSetField(file.get(), TIFFTAG_IMAGELENGTH, height);
  TIFFSetField(file.get(), TIFFTAG_BITSPERSAMPLE, static_cast<int>(8 * size));
  TIFFSetField(file.get(), TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(file.get(), TIFFTAG_SAMPLEFORMAT,
    order.Type == ScalarType::Float32 ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
  TIFFSetField(file.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(file.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(file.get(), TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  TIFFSetField(file.get(), TIFFTAG_COMPRESSION, codec);
  TIFFSetField(file.get(), TIFFTAG_ROWSPERSTRIP, rows);
  for (std::uint32_t first = 0, strip = 0; first < height; first += rows, ++strip)
  {
    const auto bytes = static_cast<tmsize_t>(row * std::min(rows, height - first));
    // The library may change the samples, as it compresses them in place.
    void* const part = const_cast<unsigned char*>(samples + row * first);
    if (TIFFWriteEncodedStrip(file.get(), strip, part, bytes) != bytes)
    {
      return false;
    }
  }
  return TIFFFlush(file.get()) == 1;
}

}

bool WriteTiff(const VolumeOrder& order, std::string& error)
{
  const int codec = CodecOf(order.Codec);
  if (codec < 0)
  {
    error = "The codec '" + order.Codec +
      "' of TIFF is unknown or not installed; use none, lzw, deflate or zstd.";
    return false;
  }
  const std::filesystem::path folder = std::filesystem::u8path(order.Path);
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  const MixingLayer layer(order.Dimensions);
  const std::size_t slice = static_cast<std::size_t>(order.Dimensions.x) *
    static_cast<std::size_t>(order.Dimensions.y) * TemporalCoherence::SizeOf(order.Type);
  const auto write = [&](int first, int count, const void* samples)
  {
    for (int i = 0; i < count; ++i)
    {
      char name[32];
      std::snprintf(name, sizeof(name), "slice%05d.tif", first + i);
      const std::string path = (folder / name).u8string();
      if (!WriteSlice(path, order, codec,
            static_cast<const unsigned char*>(samples) + static_cast<std::size_t>(i) * slice))
      {
        error = "Cannot write '" + path + "'; check the folder and the room on its disk.";
        return false;
      }
    }
    return true;
  };
  return ForEachSlab(layer, order.Type, SlicesOfSlab(order.Dimensions, order.Type), write);
}
