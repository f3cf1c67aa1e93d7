// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A VTK reader becomes a volume that is read in parts, or as a whole. Mistakes become sentences.

#include "ReaderImages.h"

#include <vtkImageReader2.h>
#include <vtkMetaImageReader.h>
#include <vtkMetaImageWriter.h>
#include <vtkNrrdReader.h>
#include <vtkRTAnalyticSource.h>
#include <vtkSphereSource.h>
#include <vtkStructuredPointsReader.h>
#include <vtkStructuredPointsWriter.h>
#include <vtkTIFFReader.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <thread>

using namespace ReaderImages;

TEST(ReaderVolume, ReadsSamplesWithoutAFormat)
{
  const std::string path = Folder("vtkTemporalCoherenceReaders") + "volume.raw";
  const auto samples = Samples();
  WriteBytes(path, "header", samples.data(), 2 * samples.size());
  vtkNew<vtkImageReader2> reader;
  reader->SetFileName(path.c_str());
  reader->SetFileDimensionality(3);
  reader->SetDataScalarTypeToUnsignedShort();
  reader->SetDataByteOrderToLittleEndian();
  reader->SetHeaderSize(6);
  reader->SetDataExtent(0, Size.x - 1, 0, Size.y - 1, 0, Size.z - 1);
  reader->SetDataSpacing(0.5, 0.75, 2.0);
  reader->SetDataOrigin(10.0, 20.0, 30.0);
  reader->SetFileLowerLeft(1);
  const auto volume = ExpectImage(reader);
  ASSERT_TRUE(volume);
  ExpectPlace(*volume);
  ExpectNoMemory(reader);
  std::filesystem::resize_file(path, 2 * samples.size() + 3);
  ExpectRefusal(reader, "is missing, or shorter");
  std::filesystem::remove(path);
  ExpectRefusal(reader, "is missing, or shorter");
}

TEST(ReaderVolume, ReadsWholeVolumesOfOtherReaders)
{
  const std::string folder = Folder("vtkTemporalCoherenceReaders");
  vtkNew<vtkMetaImageWriter> writer;
  writer->SetInputData(MakeImage());
  writer->SetFileName((folder + "volume.mha").c_str());
  writer->SetCompression(false);
  writer->Write();
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName((folder + "volume.mha").c_str());
  const auto volume = ExpectImage(reader);
  ASSERT_TRUE(volume);
  ExpectPlace(*volume);

  vtkNew<vtkStructuredPointsWriter> legacyWriter;
  legacyWriter->SetInputData(MakeImage());
  legacyWriter->SetFileTypeToBinary();
  legacyWriter->SetFileName((folder + "volume.vtk").c_str());
  legacyWriter->Write();
  vtkNew<vtkStructuredPointsReader> legacy;
  legacy->SetFileName((folder + "volume.vtk").c_str());
  const auto legacyVolume = ExpectImage(legacy);
  ASSERT_TRUE(legacyVolume);
  ExpectPlace(*legacyVolume);

  const auto samples = Samples();
  const std::string nrrd = folder + "volume.nrrd";
  WriteBytes(nrrd,
    "NRRD0004\ntype: uint16\ndimension: 3\nsizes: " + std::to_string(Size.x) + ' ' +
      std::to_string(Size.y) + ' ' + std::to_string(Size.z) +
      "\nspacings: 0.5 0.75 2\nendian: little\nencoding: raw\n\n",
    samples.data(), 2 * samples.size());
  vtkNew<vtkNrrdReader> nrrdReader;
  nrrdReader->SetFileName(nrrd.c_str());
  ASSERT_TRUE(ExpectImage(nrrdReader));
}

TEST(ReaderVolume, RefusesLargeVolumesThatAreReadAtOnce)
{
  const std::string path = Folder("vtkTemporalCoherenceReaders") + "large.mhd";
  std::ofstream(path) << "ObjectType = Image\nNDims = 3\nDimSize = 2000 2000 2000\n"
                         "ElementType = MET_UCHAR\nElementDataFile = large.raw\n";
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName(path.c_str());
  ExpectRefusal(reader, "reads the whole volume at once");
}

TEST(ReaderVolume, ReadsPartsOfAnExtentThatBeginsAnywhere)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-40, 100, 5, 150, -70, 90);
  std::string error;
  const auto volume = OpenReader(source, "", error);
  ASSERT_TRUE(volume) << error;
  const VolumeLevel& level = volume->Levels()[0];
  EXPECT_EQ(level.Dimensions, glm::ivec3(141, 146, 161));
  EXPECT_EQ(level.Origin, glm::dvec3(-40.0, 5.0, -70.0));
  EXPECT_GT(level.NumberOfChunks().z, 2);
  vtkNew<vtkRTAnalyticSource> whole;
  whole->SetWholeExtent(-40, 100, 5, 150, -70, 90);
  whole->Update();
  const auto* truth = static_cast<const float*>(whole->GetOutput()->GetScalarPointer());
  for (const glm::ivec3& chunk : ChunksOf(level))
  {
    std::vector<float> samples(level.SamplesOfChunk());
    ASSERT_TRUE(volume->ReadChunk(0, chunk, samples.data(), error)) << error;
    const std::size_t first = static_cast<std::size_t>(chunk.z) * samples.size();
    const std::vector<float> expected(
      truth + first, truth + std::min(first + samples.size(), std::size_t(141) * 146 * 161));
    samples.resize(expected.size());
    ASSERT_EQ(samples, expected);
  }
}

TEST(ReaderVolume, ReadsFromThreads)
{
  const std::string path = WriteTiff(Folder("vtkTemporalCoherenceReaders"));
  vtkNew<vtkTIFFReader> reader;
  reader->SetFileName(path.c_str());
  std::string error;
  const auto volume = OpenReader(reader, "", error);
  ASSERT_TRUE(volume) << error;
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t)
  {
    threads.emplace_back([&] { ExpectValues<std::uint16_t>(*volume, 0); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

TEST(ReaderVolume, TellsMistakes)
{
  ExpectRefusal(nullptr, "There is no reader");
  vtkNew<vtkSphereSource> sphere;
  ExpectRefusal(sphere, "gives no image");
  vtkNew<vtkTIFFReader> none;
  ExpectRefusal(none, "vtkTIFFReader");
  none->SetFileName("/missing/file.tif");
  ExpectRefusal(none, "'/missing/file.tif'");
  vtkNew<vtkXMLImageDataReader> xml;
  xml->SetFileName("/missing/file.vti");
  ExpectRefusal(xml, "'/missing/file.vti'");
}
