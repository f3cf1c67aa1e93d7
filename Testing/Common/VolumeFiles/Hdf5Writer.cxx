// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/Hdf5Writer.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

using namespace TemporalCoherence;

namespace
{

hid_t MemoryType(ScalarType type)
{
  switch (type)
  {
    case ScalarType::Int8:
      return H5T_NATIVE_INT8;
    case ScalarType::UInt8:
      return H5T_NATIVE_UINT8;
    case ScalarType::Int16:
      return H5T_NATIVE_INT16;
    case ScalarType::UInt16:
      return H5T_NATIVE_UINT16;
    case ScalarType::Int32:
      return H5T_NATIVE_INT32;
    case ScalarType::UInt32:
      return H5T_NATIVE_UINT32;
    case ScalarType::Int64:
      return H5T_NATIVE_INT64;
    case ScalarType::UInt64:
      return H5T_NATIVE_UINT64;
    case ScalarType::Float32:
      return H5T_NATIVE_FLOAT;
    default:
      return H5T_NATIVE_DOUBLE;
  }
}

void ToHdf5(const glm::ivec3& from, hsize_t (&to)[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    to[2 - axis] = static_cast<hsize_t>(from[axis]);
  }
}

/// The sample type of the file.
hid_t MakeFileType(const Hdf5Plan& plan)
{
  const bool isBigDataViewer = plan.Layout == Hdf5Layout::BigDataViewer;
  const ScalarType type =
    isBigDataViewer && plan.Type == ScalarType::UInt16 ? ScalarType::Int16 : plan.Type;
  const hid_t fileType = H5Tcopy(MemoryType(type));
  if (plan.IsSwapped)
  {
    H5Tset_order(
      fileType, H5Tget_order(H5T_NATIVE_INT) == H5T_ORDER_LE ? H5T_ORDER_BE : H5T_ORDER_LE);
  }
  return fileType;
}

hid_t MakeProperties(const Hdf5Plan& plan)
{
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  if (plan.Chunk.x > 0)
  {
    hsize_t chunk[3];
    ToHdf5(plan.Chunk, chunk);
    H5Pset_chunk(properties, 3, chunk);
  }
  if (plan.IsShuffled)
  {
    H5Pset_shuffle(properties);
  }
  if (plan.Deflate >= 0)
  {
    H5Pset_deflate(properties, static_cast<unsigned>(plan.Deflate));
  }
  if (plan.HasChecksums)
  {
    H5Pset_fletcher32(properties);
  }
  H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &plan.Fill);
  return properties;
}

}

Hdf5Writer::Hdf5Writer(const std::string& path, const Hdf5Plan& plan)
  : Plan(plan)
  , File(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT))
{
  this->Good = this->File >= 0;
  for (std::size_t level = 0; this->Good && level < plan.Dimensions.size(); ++level)
  {
    this->AddLevel(level);
  }
  if (this->Good && plan.Layout == Hdf5Layout::Imaris)
  {
    this->AddImarisBox();
  }
  if (this->Good && plan.Layout == Hdf5Layout::BigDataViewer)
  {
    this->AddFactors();
  }
}

Hdf5Writer::~Hdf5Writer()
{
  this->Close();
}

bool Hdf5Writer::Close()
{
  for (const hid_t data : this->Data)
  {
    this->Good = H5Dclose(data) >= 0 && this->Good;
  }
  this->Data.clear();
  if (this->File >= 0)
  {
    this->Good = H5Fclose(this->File) >= 0 && this->Good;
    this->File = -1;
  }
  return this->Good;
}

std::string Hdf5Writer::DataName(const Hdf5Plan& plan, std::size_t level)
{
  char name[128] = "/volume";
  if (plan.Layout == Hdf5Layout::Imaris)
  {
    std::snprintf(name, sizeof(name), "/DataSet/ResolutionLevel %d/TimePoint %d/Channel %d/Data",
      static_cast<int>(level), plan.TimePoint, plan.Channel);
  }
  else if (plan.Layout == Hdf5Layout::BigDataViewer)
  {
    std::snprintf(name, sizeof(name), "/t%05d/s%02d/%d/cells", plan.TimePoint, plan.Channel,
      static_cast<int>(level));
  }
  return name;
}

void Hdf5Writer::AddLevel(std::size_t level)
{
  const glm::ivec3 size = this->Plan.Dimensions[level];
  const bool isPadded = this->Plan.Layout == Hdf5Layout::Imaris && this->Plan.Chunk.x > 0;
  const glm::ivec3 stored =
    isPadded ? ((size - 1) / this->Plan.Chunk + 1) * this->Plan.Chunk : size;
  hsize_t sizes[3];
  ToHdf5(stored, sizes);
  const hid_t space = H5Screate_simple(3, sizes, nullptr);
  const hid_t type = MakeFileType(this->Plan);
  const hid_t properties = MakeProperties(this->Plan);
  const hid_t links = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(links, 1);
  const std::string name = DataName(this->Plan, level);
  this->Data.push_back(
    H5Dcreate2(this->File, name.c_str(), type, space, links, properties, H5P_DEFAULT));
  this->Good = this->Good && this->Data.back() >= 0;
  H5Pclose(links);
  H5Pclose(properties);
  H5Tclose(type);
  H5Sclose(space);
  if (this->Plan.Layout == Hdf5Layout::Imaris)
  {
    this->AddImarisSize(name.substr(0, name.rfind('/')), size);
  }
}

/// As an array of single characters.
void Hdf5Writer::AddText(hid_t group, const std::string& name, const std::string& text)
{
  const hsize_t size = text.size();
  const hid_t space = H5Screate_simple(1, &size, nullptr);
  const hid_t attribute =
    H5Acreate2(group, name.c_str(), H5T_C_S1, space, H5P_DEFAULT, H5P_DEFAULT);
  this->Good = H5Awrite(attribute, H5T_C_S1, text.data()) >= 0 && this->Good;
  H5Aclose(attribute);
  H5Sclose(space);
}

void Hdf5Writer::AddImarisSize(const std::string& group, const glm::ivec3& size)
{
  const hid_t opened = H5Gopen2(this->File, group.c_str(), H5P_DEFAULT);
  this->AddText(opened, "ImageSizeX", std::to_string(size.x));
  this->AddText(opened, "ImageSizeY", std::to_string(size.y));
  this->AddText(opened, "ImageSizeZ", std::to_string(size.z));
  H5Gclose(opened);
}

void Hdf5Writer::AddImarisBox()
{
  const hid_t info = H5Gcreate2(this->File, "/DataSetInfo", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t image = H5Gcreate2(info, "Image", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string number = std::to_string(axis);
    this->AddText(image, "ExtMin" + number, std::to_string(this->Plan.BoxMin[axis]));
    this->AddText(image, "ExtMax" + number, std::to_string(this->Plan.BoxMax[axis]));
  }
  H5Gclose(image);
  H5Gclose(info);
}

void Hdf5Writer::AddFactors()
{
  char setup[32];
  std::snprintf(setup, sizeof(setup), "/s%02d", this->Plan.Channel);
  const hid_t group = H5Gcreate2(this->File, setup, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const std::size_t levels = this->Plan.Dimensions.size();
  std::vector<glm::dvec3> factors(this->Plan.Factors.begin(), this->Plan.Factors.end());
  std::vector<glm::ivec3> chunks(levels, this->Plan.Chunk);
  const hsize_t sizes[2] = { levels, 3 };
  const hid_t space = H5Screate_simple(2, sizes, nullptr);
  const auto add = [&](const char* name, hid_t type, const void* rows)
  {
    const hid_t data = H5Dcreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    this->Good = H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows) >= 0 && this->Good;
    H5Dclose(data);
  };
  add("resolutions", H5T_NATIVE_DOUBLE, factors.data());
  add("subdivisions", H5T_NATIVE_INT, chunks.data());
  H5Sclose(space);
  H5Gclose(group);
}

bool Hdf5Writer::WriteChunk(std::size_t level, const glm::ivec3& chunk, const void* samples)
{
  const glm::ivec3 size = this->Plan.Dimensions[level];
  const glm::ivec3 room = this->Plan.Chunk.x > 0 ? this->Plan.Chunk : size;
  hsize_t start[3], count[3], rooms[3];
  ToHdf5(chunk * room, start);
  ToHdf5(glm::min(room, size - chunk * room), count);
  ToHdf5(room, rooms);
  const hsize_t origin[3] = {};
  const hid_t to = H5Dget_space(this->Data[level]);
  const hid_t from = H5Screate_simple(3, rooms, nullptr);
  H5Sselect_hyperslab(to, H5S_SELECT_SET, start, nullptr, count, nullptr);
  H5Sselect_hyperslab(from, H5S_SELECT_SET, origin, nullptr, count, nullptr);
  // BigDataViewer stores the bits of unsigned samples as if they had a sign.
  const bool isReinterpreted =
    this->Plan.Layout == Hdf5Layout::BigDataViewer && this->Plan.Type == ScalarType::UInt16;
  const hid_t type = isReinterpreted ? H5T_NATIVE_INT16 : MemoryType(this->Plan.Type);
  const bool isWritten = H5Dwrite(this->Data[level], type, from, to, H5P_DEFAULT, samples) >= 0;
  H5Sclose(from);
  H5Sclose(to);
  this->Good = this->Good && isWritten;
  return isWritten;
}

bool Hdf5Writer::WriteStoredChunk(
  std::size_t level, const glm::ivec3& chunk, const void* bytes, std::size_t size)
{
  hsize_t first[3];
  ToHdf5(chunk * this->Plan.Chunk, first);
  constexpr std::uint32_t allFilters = 0; // no filter is left out
  const bool isWritten =
    H5Dwrite_chunk(this->Data[level], H5P_DEFAULT, allFilters, first, size, bytes) >= 0;
  this->Good = this->Good && isWritten;
  return isWritten;
}
