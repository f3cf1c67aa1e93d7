// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Volumes of Imaris, BigDataViewer and plain HDF5 files are read as they were written. What cannot
// be read is refused with a sentence.

#include "ReadBack.h"
#include "VolumeFiles/Hdf5Volume.h"
#include "VolumeFiles/Hdf5Writer.h"

#include <thread>

using namespace ReadBack;

namespace
{

template <typename T>
void WriteLevels(Hdf5Writer& writer, const Hdf5Plan& plan)
{
  for (std::size_t l = 0; l < plan.Dimensions.size(); ++l)
  {
    VolumeLevel level;
    level.Dimensions = plan.Dimensions[l];
    level.Chunk = plan.Chunk.x > 0 ? plan.Chunk : level.Dimensions;
    for (const glm::ivec3& chunk : ChunksOf(level))
    {
      const auto samples = MakeChunk<T>(l, chunk * level.Chunk, level.Chunk, level.Dimensions);
      writer.WriteChunk(l, chunk, samples.data());
    }
  }
}

void Write(const std::string& path, const Hdf5Plan& plan)
{
  Hdf5Writer writer(path, plan);
  DispatchScalarType(plan.Type, [&](auto sample) { WriteLevels<decltype(sample)>(writer, plan); });
  ASSERT_TRUE(writer.IsGood());
}

VolumeChoice ChoiceOf(const Hdf5Plan& plan)
{
  VolumeChoice choice;
  choice.Channel = plan.Channel;
  choice.TimePoint = plan.TimePoint;
  return choice;
}

/// Expect that a file is read as it was written.
std::unique_ptr<VolumeFile> ExpectReadBack(const std::string& path, const Hdf5Plan& plan)
{
  std::string error;
  auto volume = OpenHdf5(path, ChoiceOf(plan), error);
  EXPECT_TRUE(volume) << error;
  if (!volume)
  {
    return nullptr;
  }
  EXPECT_EQ(error, "");
  EXPECT_EQ(volume->Type(), plan.Type);
  EXPECT_EQ(volume->Levels().size(), plan.Dimensions.size());
  for (std::size_t l = 0; l < volume->Levels().size(); ++l)
  {
    EXPECT_EQ(volume->Levels()[l].Dimensions, plan.Dimensions[l]);
    if (plan.Chunk.x > 0)
    {
      EXPECT_EQ(volume->Levels()[l].Chunk, plan.Chunk);
    }
    DispatchScalarType(plan.Type, [&](auto sample) { ExpectValues<decltype(sample)>(*volume, l); });
  }
  return volume;
}

const std::vector<ScalarType> AllTypes = { ScalarType::Int8, ScalarType::UInt8, ScalarType::Int16,
  ScalarType::UInt16, ScalarType::Int32, ScalarType::UInt32, ScalarType::Int64, ScalarType::UInt64,
  ScalarType::Float32, ScalarType::Float64 };

Hdf5Plan TwoLevels(Hdf5Layout layout)
{
  Hdf5Plan plan;
  plan.Layout = layout;
  plan.Type = ScalarType::UInt16;
  plan.Dimensions = { { 37, 29, 23 }, { 18, 14, 23 } };
  plan.Factors = { { 1, 1, 1 }, { 2, 2, 1 } };
  plan.Chunk = { 16, 8, 5 };
  return plan;
}

/// Expect that a file is refused with a sentence that has a part.
void ExpectRefusal(
  const std::string& path, const std::string& part, const VolumeChoice& choice = VolumeChoice())
{
  std::string error;
  EXPECT_FALSE(OpenHdf5(path, choice, error)) << part;
  EXPECT_NE(error.find(part), std::string::npos) << error;
  EXPECT_NE(error.find(path), std::string::npos) << error;
}

}

TEST(Hdf5, ReadsAllTypesInBothByteOrders)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5") + "types.h5";
  for (const ScalarType type : AllTypes)
  {
    for (const bool isSwapped : { false, true })
    {
      for (const int deflate : { -1, 4 })
      {
        Hdf5Plan plan = TwoLevels(Hdf5Layout::DataSet);
        plan.Dimensions.resize(1);
        plan.Type = type;
        plan.IsSwapped = isSwapped;
        plan.Deflate = deflate;
        Write(path, plan);
        ExpectReadBack(path, plan);
      }
    }
  }
}

TEST(Hdf5, ReadsAllLayoutsFiltersAndChunks)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5") + "layouts.h5";
  for (const Hdf5Layout layout :
    { Hdf5Layout::Imaris, Hdf5Layout::BigDataViewer, Hdf5Layout::DataSet })
  {
    for (const glm::ivec3 chunk :
      { glm::ivec3(0), glm::ivec3(1, 3, 7), glm::ivec3(16), glm::ivec3(37, 29, 23) })
    {
      for (int filters = 0; filters < 8; ++filters)
      {
        Hdf5Plan plan = TwoLevels(layout);
        plan.Chunk = glm::min(chunk, plan.Dimensions[1]); // HDF5 wants chunks within data sets
        plan.Dimensions.resize(layout == Hdf5Layout::DataSet ? 1 : 2);
        if (chunk.x == 0 && filters != 0)
        {
          continue;
        }
        plan.IsShuffled = (filters & 1) != 0;
        plan.Deflate = (filters & 2) != 0 ? 6 : -1;
        plan.HasChecksums = (filters & 4) != 0;
        Write(path, plan);
        ExpectReadBack(path, plan);
      }
    }
  }
}

TEST(Hdf5, PlacesSamplesOfImarisInTheMiddleOfTheirBoxes)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5") + "place.ims";
  Hdf5Plan plan = TwoLevels(Hdf5Layout::Imaris);
  plan.Channel = 2;
  plan.TimePoint = 11;
  plan.BoxMin = { 10.0, 20.0, -4.0 };
  plan.BoxMax = { 47.0, 78.0, 42.0 };
  Write(path, plan);
  const auto volume = ExpectReadBack(path, plan);
  ASSERT_TRUE(volume);
  for (const VolumeLevel& level : volume->Levels())
  {
    const glm::dvec3 spacing = (plan.BoxMax - plan.BoxMin) / glm::dvec3(level.Dimensions);
    EXPECT_LT(glm::distance(level.Spacing, spacing), 1e-12);
    EXPECT_LT(glm::distance(level.Origin, plan.BoxMin + 0.5 * spacing), 1e-12);
  }
  ExpectRefusal(path, "no channel 3", { 3, 11, "" });
  ExpectRefusal(path, "time point 10", { 2, 10, "" });
  ExpectRefusal(path, "time point -1", { 2, -1, "" });
}

TEST(Hdf5, PlacesSamplesOfBigDataViewerInTheMiddleOfFineOnes)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5") + "place.h5";
  const Hdf5Plan plan = TwoLevels(Hdf5Layout::BigDataViewer);
  Write(path, plan);
  const auto volume = ExpectReadBack(path, plan);
  ASSERT_TRUE(volume);
  EXPECT_EQ(volume->Levels()[0].Spacing, glm::dvec3(1.0));
  EXPECT_EQ(volume->Levels()[0].Origin, glm::dvec3(0.0));
  EXPECT_EQ(volume->Levels()[1].Spacing, glm::dvec3(2.0, 2.0, 1.0));
  EXPECT_EQ(volume->Levels()[1].Origin, glm::dvec3(0.5, 0.5, 0.0));
  ExpectRefusal(path, "no channel (setup) 1", { 1, 0, "" });
  ExpectRefusal(path, "time point 3", { 0, 3, "" });
  ExpectRefusal(path, "no channel (setup) -1", { -1, 0, "" });
}

TEST(Hdf5, GivesTheFillValueForMissingChunks)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5") + "missing.h5";
  for (const int deflate : { -1, 1 })
  {
    Hdf5Plan plan = TwoLevels(Hdf5Layout::BigDataViewer);
    plan.Fill = 1234.0;
    plan.Deflate = deflate;
    const std::vector<std::uint16_t> some(
      static_cast<std::size_t>(plan.Chunk.x * plan.Chunk.y * plan.Chunk.z), 7);
    {
      Hdf5Writer writer(path, plan);
      ASSERT_TRUE(writer.WriteChunk(0, { 1, 2, 3 }, some.data()));
    }
    std::string error;
    const auto volume = OpenHdf5(path, {}, error);
    ASSERT_TRUE(volume) << error;
    const std::vector<std::uint16_t> fill(some.size(), 1234);
    const VolumeLevel& level = volume->Levels()[0];
    for (const glm::ivec3& chunk : ChunksOf(level))
    {
      std::vector<std::uint16_t> samples(some.size(), 9);
      ASSERT_TRUE(volume->ReadChunk(0, chunk, samples.data(), error)) << error;
      EXPECT_TRUE(AreEqual(level, chunk, samples, chunk == glm::ivec3(1, 2, 3) ? some : fill));
    }
  }
}

TEST(Hdf5, ReadsHalfPrecisionAsSinglePrecision)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5") + "half.h5";
  const hid_t half = H5Tcopy(H5T_IEEE_F32BE);
  H5Tset_fields(half, 15, 10, 5, 0, 10);
  H5Tset_size(half, 2);
  H5Tset_ebias(half, 15);
  std::vector<float> values;
  for (int i = 0; i < 8 * 8 * 8; ++i)
  {
    values.push_back(0.25f * static_cast<float>(i) - 17.0f);
  }
  for (const bool isCompressed : { false, true })
  {
    const hsize_t sizes[3] = { 8, 8, 8 };
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(3, sizes, nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(properties, 3, sizes);
    if (isCompressed)
    {
      H5Pset_shuffle(properties);
      H5Pset_deflate(properties, 3);
    }
    const hid_t data = H5Dcreate2(file, "half", half, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    H5Dwrite(data, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(data);
    H5Pclose(properties);
    H5Sclose(space);
    H5Fclose(file);
    std::string error;
    const auto volume = OpenHdf5(path, {}, error);
    ASSERT_TRUE(volume) << error;
    EXPECT_EQ(volume->Type(), ScalarType::Float32);
    std::vector<float> samples(values.size());
    ASSERT_TRUE(volume->ReadChunk(0, glm::ivec3(0), samples.data(), error)) << error;
    EXPECT_EQ(samples, values);
  }
  H5Tclose(half);
}

TEST(Hdf5, ReadsFromThreads)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5") + "threads.ims";
  Hdf5Plan plan = TwoLevels(Hdf5Layout::Imaris);
  plan.Deflate = 2;
  plan.IsShuffled = true;
  Write(path, plan);
  std::string error;
  const auto volume = OpenHdf5(path, {}, error);
  ASSERT_TRUE(volume) << error;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
  {
    threads.emplace_back(
      [&]
      {
        for (int round = 0; round < 5; ++round)
        {
          ExpectValues<std::uint16_t>(*volume, 0);
          std::string own;
          EXPECT_TRUE(OpenHdf5(path, {}, own)) << own;
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

TEST(Hdf5, ChangesItsIdentityWithTheFileAndTheChoice)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5") + "identity.ims";
  Hdf5Plan plan = TwoLevels(Hdf5Layout::Imaris);
  Write(path, plan);
  std::string error;
  const std::string before = OpenHdf5(path, {}, error)->Identity();
  EXPECT_EQ(OpenHdf5(path, {}, error)->Identity(), before);
  EXPECT_NE(OpenHdf5(path, { 0, 0, Hdf5Writer::DataName(plan, 1) }, error)->Identity(), before);
  plan.Dimensions[0].x += 8;
  std::filesystem::remove(path);
  Write(path, plan);
  EXPECT_NE(OpenHdf5(path, {}, error)->Identity(), before);
}
