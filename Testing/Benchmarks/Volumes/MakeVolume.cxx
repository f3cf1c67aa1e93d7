// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes a test volume of any size, in several formats: a turbulent layer by formula (MixingLayer).

#include "VolumeWriters.h"

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using TemporalCoherence::ScalarType;

constexpr int LongestSide = 65536;

/// A format that can be written.
struct Format
{
  const char* Name;
  const char* Meaning;
  bool (*Write)(const VolumeOrder& order, std::string& error);
};

constexpr Format Formats[] = {
  { "raw", "a file of plain samples", WriteRaw },
  { "mhd", "a MetaImage: FILE.mhd, and FILE.raw beside it", WriteMetaImage },
  { "tiff", "a folder of one file for each slice; codecs none, lzw, deflate, zstd", WriteTiff },
#ifdef TEMPORAL_COHERENCE_HAS_ZARR
  { "zarr", "a folder of OME-Zarr; codecs blosc-lz4, blosc-zstd, zstd, gzip, none", WriteZarr },
#endif
#ifdef TEMPORAL_COHERENCE_HAS_HDF5
  { "imaris", "an HDF5 file as of Imaris; codecs gzip, none", WriteImaris },
#endif
};

void PrintHelp()
{
  std::cout << "MakeVolume FORMAT FILE NX NY NZ [TYPE] [CODEC]\n\n"
               "Writes a volume by formula: a turbulent layer between two gases, which looks the "
               "same in every size.\n\n";
  for (const Format& format : Formats)
  {
    std::cout << "  " << format.Name << ": " << format.Meaning << '\n';
  }
  std::cout << "\nTYPE: uint8 (values 0 to 255), uint16 (0 to 65535), float32 (0 to 255)\n"
               "CODEC: the first one of a format is its default\n";
}

bool ReadType(const std::string& name, ScalarType& type)
{
  type = name == "uint16" ? ScalarType::UInt16
    : name == "float32"   ? ScalarType::Float32
                          : ScalarType::UInt8;
  return name == "uint8" || type != ScalarType::UInt8;
}

/// \return the format; null on a mistake, which `error` tells
const Format* ReadOrder(
  const std::vector<std::string>& arguments, VolumeOrder& order, std::string& error)
{
  if (arguments.size() < 5 || arguments.size() > 7)
  {
    error = "This needs FORMAT FILE NX NY NZ [TYPE] [CODEC]; --help tells what these are.";
    return nullptr;
  }
  order.Path = arguments[1];
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string& text = arguments[2 + static_cast<std::size_t>(axis)];
    char* end = nullptr;
    const long number = std::strtol(text.c_str(), &end, 10);
    if (*end != '\0' || number < 1 || number > LongestSide)
    {
      error = "'" + text + "' is no size; give a whole number from 1 to " +
        std::to_string(LongestSide) + ".";
      return nullptr;
    }
    order.Dimensions[axis] = static_cast<int>(number);
  }
  if (arguments.size() > 5 && !ReadType(arguments[5], order.Type))
  {
    error = "The type '" + arguments[5] + "' is unknown; use uint8, uint16 or float32.";
    return nullptr;
  }
  order.Codec = arguments.size() > 6 ? arguments[6] : std::string();
  for (const Format& format : Formats)
  {
    if (arguments[0] == format.Name)
    {
      return &format;
    }
  }
  error = "The format '" + arguments[0] + "' is unknown; --help lists formats.";
  return nullptr;
}

}

int main(int argc, char* argv[])
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty() && (arguments[0] == "--help" || arguments[0] == "-h"))
  {
    PrintHelp();
    return EXIT_SUCCESS;
  }
  VolumeOrder order;
  std::string error;
  const auto start = std::chrono::steady_clock::now();
  const Format* const format = ReadOrder(arguments, order, error);
  if (!format || !format->Write(order, error))
  {
    std::cerr << error << '\n';
    return EXIT_FAILURE;
  }
  const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
  std::cout << "Wrote '" << order.Path << "' in " << duration.count() << " s.\n";
  return EXIT_SUCCESS;
}
