// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Slabs.h"
#include "VolumeWriters.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

using TemporalCoherence::ScalarType;

namespace
{

bool IsMachineBigEndian()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

const char* MetaTypeOf(ScalarType type)
{
  return type == ScalarType::UInt8 ? "MET_UCHAR"
    : type == ScalarType::UInt16   ? "MET_USHORT"
                                   : "MET_FLOAT";
}

std::string CannotWrite(const std::string& path)
{
  return "Cannot write '" + path + "'; check the folder and the room on its disk.";
}

}

bool WriteRaw(const VolumeOrder& order, std::string& error)
{
  if (!order.Codec.empty() && order.Codec != "none")
  {
    error = "Raw files have no codec '" + order.Codec + "'; leave it out.";
    return false;
  }
  const MixingLayer layer(order.Dimensions);
  const std::size_t slice = static_cast<std::size_t>(order.Dimensions.x) *
    static_cast<std::size_t>(order.Dimensions.y) * TemporalCoherence::SizeOf(order.Type);
  std::ofstream stream(std::filesystem::u8path(order.Path), std::ios::binary);
  const auto write = [&](int, int count, const void* samples)
  {
    stream.write(static_cast<const char*>(samples),
      static_cast<std::streamsize>(static_cast<std::size_t>(count) * slice));
    return stream.good();
  };
  const bool isWritten = stream.good() &&
    ForEachSlab(layer, order.Type, SlicesOfSlab(order.Dimensions, order.Type), write);
  stream.close();
  error = isWritten && stream ? std::string() : CannotWrite(order.Path);
  return error.empty();
}

bool WriteMetaImage(const VolumeOrder& order, std::string& error)
{
  const std::filesystem::path header = std::filesystem::u8path(order.Path);
  std::filesystem::path data = header;
  data.replace_extension(".raw");
  if (data == header)
  {
    error = "The header '" + order.Path + "' cannot end with .raw; give it the end .mhd.";
    return false;
  }
  VolumeOrder samples = order;
  samples.Path = data.u8string();
  if (!WriteRaw(samples, error))
  {
    return false;
  }
  std::ofstream stream(header);
  stream << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = "
         << (IsMachineBigEndian() ? "True" : "False")
         << "\nCompressedData = False\nOffset = 0 0 0\nElementSpacing = 1 1 1\nDimSize = "
         << order.Dimensions.x << ' ' << order.Dimensions.y << ' ' << order.Dimensions.z
         << "\nElementType = " << MetaTypeOf(order.Type)
         << "\nElementDataFile = " << data.filename().u8string() << '\n';
  stream.close();
  error = stream ? std::string() : CannotWrite(order.Path);
  return error.empty();
}
