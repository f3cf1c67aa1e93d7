// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/Hdf5Volume.h"

#include "VolumeFiles/FileFacts.h"
#include "VolumeFiles/Hdf5Layouts.h"

namespace TemporalCoherence
{

namespace
{

bool FindLevels(const Hdf5File& file, const VolumeChoice& choice, std::vector<Hdf5Level>& levels,
  std::string& error)
{
  if (choice.Array.empty() && IsImaris(file))
  {
    return FindImaris(file, choice, levels, error);
  }
  if (choice.Array.empty() && IsBigDataViewer(file))
  {
    return FindBigDataViewer(file, choice, levels, error);
  }
  return FindDataSet(file, choice, levels, error);
}

class Hdf5Volume : public VolumeFile
{
public:
  Hdf5Volume() = default;
  Hdf5Volume(const Hdf5Volume&) = delete;
  Hdf5Volume& operator=(const Hdf5Volume&) = delete;

  ~Hdf5Volume() override
  {
    const Hdf5Turn turn;
    this->Data.clear();
    this->File = Hdf5File();
  }

  bool Open(const std::string& path, const VolumeChoice& choice, std::string& error)
  {
    this->Facts = FileFacts(path) + "channel " + std::to_string(choice.Channel) + ", time point " +
      std::to_string(choice.TimePoint) + ", array '" + choice.Array + '\'';
    const Hdf5Turn turn;
    std::vector<Hdf5Level> levels;
    return this->File.Open(path, error) && FindLevels(this->File, choice, levels, error) &&
      this->Take(levels, error);
  }

  bool ReadChunk(
    std::size_t level, const glm::ivec3& chunk, void* samples, std::string& error) const override
  {
    return this->Data[level].Read(chunk * this->Resolutions[level].Chunk, samples, error);
  }

  std::string Identity() const override { return this->Facts; }

private:
  /// Needs an Hdf5Turn.
  bool Take(std::vector<Hdf5Level>& levels, std::string& error)
  {
    this->SampleType = levels.front().Data.Type();
    for (Hdf5Level& level : levels)
    {
      if (level.Data.Type() != this->SampleType)
      {
        error = "File '" + this->File.Path() +
          "' has resolutions with samples of different types; write it again.";
        return false;
      }
      this->Resolutions.push_back(level.Place);
      this->Data.push_back(std::move(level.Data));
    }
    return true;
  }

  Hdf5File File;
  std::vector<Hdf5DataSet> Data; ///< of each resolution
  std::string Facts;
};

}

std::unique_ptr<VolumeFile> OpenHdf5(
  const std::string& path, const VolumeChoice& choice, std::string& error)
{
  auto volume = std::make_unique<Hdf5Volume>();
  if (!volume->Open(path, choice, error))
  {
    return nullptr;
  }
  return volume;
}

}
