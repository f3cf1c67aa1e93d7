// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/Hdf5Layouts.h"
#include "VolumeFiles/Hdf5Types.h"

#include <cstddef>
#include <set>

namespace TemporalCoherence
{

namespace
{

/// Looks for data sets in a file. Each is found once.
class DataSetSearch
{
public:
  explicit DataSetSearch(const Hdf5File& file)
    : File(file)
  {
  }

  /// \param depth groups around the group
  void SearchIn(const std::string& group, int depth)
  {
    const Hdf5Handle opened = this->File.OpenObject(group.empty() ? "/" : group);
    H5G_info_t info{};
    if (!opened.IsValid() || H5Gget_info(opened.Get(), &info) < 0)
    {
      return;
    }
    for (hsize_t i = 0; i < info.nlinks && this->Links < MostLinks; ++i)
    {
      ++this->Links;
      const std::string name = NameOfLink(opened.Get(), i);
      if (!name.empty() && this->IsNew(opened.Get(), name))
      {
        this->See(group + '/' + name, depth);
      }
    }
  }

  std::vector<std::string> Names; ///< of data sets with three dimensions and numbers

private:
  static constexpr int MostDepth = 16;
  static constexpr int MostLinks = 10000;
  static constexpr std::size_t MostCharacters = 1024;

  static std::string NameOfLink(hid_t group, hsize_t index)
  {
    char name[MostCharacters] = {};
    const ssize_t length = H5Lget_name_by_idx(
      group, ".", H5_INDEX_NAME, H5_ITER_NATIVE, index, name, MostCharacters, H5P_DEFAULT);
    return length > 0 && static_cast<std::size_t>(length) < MostCharacters ? name : "";
  }

  /// True for the first hard link to an object.
  bool IsNew(hid_t group, const std::string& name)
  {
    H5L_info_t info{};
    if (H5Lget_info(group, name.c_str(), &info, H5P_DEFAULT) < 0 || info.type != H5L_TYPE_HARD)
    {
      return false;
    }
    // An address, or a token since HDF5 1.12.
    const std::string object(reinterpret_cast<const char*>(&info.u), sizeof(info.u));
    return this->Seen.insert(object).second;
  }

  void See(const std::string& name, int depth)
  {
    const Hdf5Handle object = this->File.OpenObject(name);
    const H5I_type_t type = H5Iget_type(object.Get());
    if (type == H5I_GROUP && depth < MostDepth)
    {
      this->SearchIn(name, depth + 1);
    }
    else if (type == H5I_DATASET && IsVolume(object.Get()))
    {
      this->Names.push_back(name);
    }
  }

  static bool IsVolume(hid_t data)
  {
    const Hdf5Handle space(H5Dget_space(data), H5Sclose);
    const Hdf5Handle type(H5Dget_type(data), H5Tclose);
    ScalarType scalarType;
    return H5Sget_simple_extent_ndims(space.Get()) == 3 && FindScalarType(type.Get(), scalarType);
  }

  const Hdf5File& File;
  int Links = 0;
  std::set<std::string> Seen; ///< places of objects in the file
};

/// Find the only data set that can be meant.
bool FindName(const Hdf5File& file, std::string& name, std::string& error)
{
  DataSetSearch search(file);
  search.SearchIn("", 0);
  if (search.Names.size() == 1)
  {
    name = search.Names.front();
    return true;
  }
  error = "File '" + file.Path() + "' has ";
  if (search.Names.empty())
  {
    error += "no data set of three dimensions with numbers; choose another file.";
    return false;
  }
  constexpr std::size_t most = 8;
  error += std::to_string(search.Names.size()) + " data sets of three dimensions; choose one: ";
  for (std::size_t i = 0; i < search.Names.size() && i < most; ++i)
  {
    error += (i == 0 ? "'" : ", '") + search.Names[i] + '\'';
  }
  error += search.Names.size() > most ? ", ..." : ".";
  return false;
}

}

bool FindDataSet(const Hdf5File& file, const VolumeChoice& choice, std::vector<Hdf5Level>& levels,
  std::string& error)
{
  std::string name = choice.Array;
  Hdf5Level found;
  if ((name.empty() && !FindName(file, name, error)) || !found.Data.Open(file, name, error))
  {
    return false;
  }
  found.Place.Dimensions = found.Data.Dimensions();
  found.Place.Chunk = found.Data.Chunk();
  levels.push_back(std::move(found));
  return true;
}

}
