// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/Hdf5Attributes.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace TemporalCoherence
{

namespace
{

constexpr std::size_t MostCharacters = 256;

/// The characters of an attribute; empty if it is no short text of fixed length.
std::string ReadText(hid_t attribute)
{
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space.Get());
  const std::size_t size = H5Tget_size(type.Get());
  if (H5Tget_class(type.Get()) != H5T_STRING || H5Tis_variable_str(type.Get()) != 0 || count < 1 ||
    count > static_cast<hssize_t>(MostCharacters) || size < 1 || size > MostCharacters)
  {
    return {};
  }
  std::string characters(static_cast<std::size_t>(count) * size, '\0');
  if (H5Aread(attribute, type.Get(), &characters[0]) < 0)
  {
    return {};
  }
  std::string text;
  for (const char character : characters)
  {
    if (character != '\0')
    {
      text += character;
    }
  }
  return text;
}

}

bool ReadNumber(
  const Hdf5File& file, const std::string& object, const std::string& attribute, double& number)
{
  const Hdf5Handle owner = file.OpenObject(object);
  if (!owner.IsValid() || H5Aexists(owner.Get(), attribute.c_str()) <= 0)
  {
    return false;
  }
  const Hdf5Handle opened(H5Aopen(owner.Get(), attribute.c_str(), H5P_DEFAULT), H5Aclose);
  if (!opened.IsValid())
  {
    return false;
  }
  std::istringstream digits(ReadText(opened.Get()));
  digits.imbue(std::locale::classic());
  return (digits >> number) && std::isfinite(number);
}

bool ReadTriples(
  const Hdf5File& file, const std::string& name, std::size_t most, std::vector<glm::dvec3>& rows)
{
  const Hdf5Handle data(H5Dopen2(file.Id(), name.c_str(), file.Access()), H5Dclose);
  if (!data.IsValid())
  {
    return false;
  }
  const Hdf5Handle space(H5Dget_space(data.Get()), H5Sclose);
  const Hdf5Handle properties(H5Dget_create_plist(data.Get()), H5Pclose);
  hsize_t sizes[2] = {};
  if (H5Pget_layout(properties.Get()) == H5D_VIRTUAL ||
    H5Pget_external_count(properties.Get()) != 0 || H5Sget_simple_extent_ndims(space.Get()) != 2 ||
    H5Sget_simple_extent_dims(space.Get(), sizes, nullptr) != 2 || sizes[0] < 1 ||
    sizes[0] > most || sizes[1] != 3)
  {
    return false;
  }
  const Hdf5Handle type(H5Dget_type(data.Get()), H5Tclose);
  if (H5Dget_storage_size(data.Get()) < sizes[0] * 3 * H5Tget_size(type.Get()))
  {
    return false;
  }
  rows.resize(static_cast<std::size_t>(sizes[0]));
  return H5Dread(data.Get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &rows[0].x) >= 0;
}

}
