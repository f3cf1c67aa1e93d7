// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ReaderImages_h
#define Testing_ReaderImages_h

#include "ReadBack.h"
#include "VolumeFiles/ReaderVolume.h"

#include <vtkAlgorithm.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTIFFWriter.h>

#include <fstream>

/// An image that tests write to files, and what a volume of such a file should be.
namespace ReaderImages
{

using namespace ReadBack;

using Image = vtkSmartPointer<vtkImageData>;

/// An image with the values of ReadBack::ValueAt.
template <typename T>
Image MakeImage(int type, const glm::ivec3& size)
{
  auto image = Image::New();
  image->SetDimensions(size.x, size.y, size.z);
  image->SetSpacing(0.5, 0.75, 2.0);
  image->SetOrigin(10.0, 20.0, 30.0);
  image->AllocateScalars(type, 1);
  const auto samples = MakeChunk<T>(0, glm::ivec3(0), size, size);
  std::memcpy(image->GetScalarPointer(), samples.data(), sizeof(T) * samples.size());
  return image;
}

/// More than one chunk.
const glm::ivec3 Size(211, 175, 130);
constexpr ScalarType Type = ScalarType::UInt16;

inline Image MakeImage()
{
  return MakeImage<std::uint16_t>(VTK_UNSIGNED_SHORT, Size);
}

/// Expect the samples of MakeImage.
inline std::unique_ptr<VolumeFile> ExpectImage(
  vtkAlgorithm* reader, const std::string& array = "", ScalarType type = Type)
{
  std::string error;
  auto volume = OpenReader(reader, array, error);
  EXPECT_TRUE(volume) << error;
  if (volume)
  {
    EXPECT_EQ(error, "");
    EXPECT_EQ(volume->Type(), type);
    EXPECT_EQ(volume->Levels().size(), 1u);
    EXPECT_EQ(volume->Levels()[0].Dimensions, Size);
    EXPECT_GT(volume->Levels()[0].NumberOfChunks().z, 1);
    ExpectValues<std::uint16_t>(*volume, 0);
  }
  return volume;
}

/// Expect that no more than a chunk is kept in a reader.
inline void ExpectNoMemory(vtkAlgorithm* reader)
{
  EXPECT_EQ(vtkImageData::SafeDownCast(reader->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
}

inline void ExpectPlace(const VolumeFile& volume)
{
  EXPECT_LT(glm::distance(volume.Levels()[0].Spacing, glm::dvec3(0.5, 0.75, 2.0)), 1e-6);
  EXPECT_LT(glm::distance(volume.Levels()[0].Origin, glm::dvec3(10.0, 20.0, 30.0)), 1e-6);
}

inline void ExpectRefusal(
  vtkAlgorithm* reader, const std::string& part, const std::string& array = "")
{
  std::string error;
  EXPECT_FALSE(OpenReader(reader, array, error)) << part;
  EXPECT_NE(error.find(part), std::string::npos) << error;
}

inline std::string WriteTiff(const std::string& folder)
{
  vtkNew<vtkTIFFWriter> writer;
  writer->SetInputData(MakeImage());
  writer->SetFileName((folder + "volume.tif").c_str());
  writer->Write();
  return folder + "volume.tif";
}

inline void WriteBytes(
  const std::string& path, const std::string& head, const void* data, std::size_t bytes)
{
  std::ofstream file(path, std::ios::binary);
  file << head;
  file.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
}

inline std::vector<std::uint16_t> Samples()
{
  return MakeChunk<std::uint16_t>(0, glm::ivec3(0), Size, Size);
}

inline void Truncate(const std::string& path, double part)
{
  const auto size = static_cast<double>(std::filesystem::file_size(path));
  std::filesystem::resize_file(path, static_cast<std::uintmax_t>(size * part));
}

/// Expect that reading all chunks fails with a sentence that names the reader, at least once.
inline void ExpectFailure(vtkAlgorithm* reader, const std::string& array = "")
{
  std::string error;
  const auto volume = OpenReader(reader, array, error);
  if (volume)
  {
    const VolumeLevel& level = volume->Levels()[0];
    std::vector<double> samples(level.SamplesOfChunk());
    for (const glm::ivec3& chunk : ChunksOf(level))
    {
      std::string own;
      const bool isRead = volume->ReadChunk(0, chunk, samples.data(), own);
      EXPECT_EQ(isRead, own.empty()) << own;
      error = own.empty() ? error : own;
    }
  }
  EXPECT_NE(error.find(reader->GetClassName()), std::string::npos) << error;
  testing::Test::RecordProperty("error", error);
}

}

#endif
