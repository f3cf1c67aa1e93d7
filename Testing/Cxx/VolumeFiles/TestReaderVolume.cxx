// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's readers give volumes chunk by chunk. Their mistakes become sentences.

#include "ReadBack.h"
#include "VolumeFiles/ReaderVolume.h"

#include <hdf5.h>
#include <vtkHDFReader.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkMRCReader.h>
#include <vtkMetaImageReader.h>
#include <vtkMetaImageWriter.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNIFTIImageWriter.h>
#include <vtkNew.h>
#include <vtkNrrdReader.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkStructuredPointsReader.h>
#include <vtkStructuredPointsWriter.h>
#include <vtkTIFFReader.h>
#include <vtkTIFFWriter.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

#include <fstream>
#include <thread>

using namespace ReadBack;

namespace
{

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

Image MakeImage()
{
  return MakeImage<std::uint16_t>(VTK_UNSIGNED_SHORT, Size);
}

/// Expect the samples of MakeImage.
std::unique_ptr<VolumeFile> ExpectImage(
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
void ExpectNoMemory(vtkAlgorithm* reader)
{
  EXPECT_EQ(vtkImageData::SafeDownCast(reader->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
}

void ExpectPlace(const VolumeFile& volume)
{
  EXPECT_LT(glm::distance(volume.Levels()[0].Spacing, glm::dvec3(0.5, 0.75, 2.0)), 1e-6);
  EXPECT_LT(glm::distance(volume.Levels()[0].Origin, glm::dvec3(10.0, 20.0, 30.0)), 1e-6);
}

void ExpectRefusal(vtkAlgorithm* reader, const std::string& part, const std::string& array = "")
{
  std::string error;
  EXPECT_FALSE(OpenReader(reader, array, error)) << part;
  EXPECT_NE(error.find(part), std::string::npos) << error;
}

/// Write files of one slice each.
template <typename Writer>
vtkSmartPointer<vtkStringArray> WriteSlices(const std::string& folder, const std::string& ending)
{
  const Image image = MakeImage();
  auto names = vtkSmartPointer<vtkStringArray>::New();
  for (int z = 0; z < Size.z; ++z)
  {
    vtkNew<vtkImageData> slice;
    slice->SetDimensions(Size.x, Size.y, 1);
    slice->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
    std::memcpy(slice->GetScalarPointer(), image->GetScalarPointer(0, 0, z),
      sizeof(std::uint16_t) * static_cast<std::size_t>(Size.x * Size.y));
    names->InsertNextValue(folder + "slice" + std::to_string(1000 + z) + ending);
    vtkNew<Writer> writer;
    writer->SetInputData(slice);
    writer->SetFileName(names->GetValue(z).c_str());
    writer->Write();
  }
  return names;
}

std::string WriteTiff(const std::string& folder)
{
  vtkNew<vtkTIFFWriter> writer;
  writer->SetInputData(MakeImage());
  writer->SetFileName((folder + "volume.tif").c_str());
  writer->Write();
  return folder + "volume.tif";
}

void WriteBytes(
  const std::string& path, const std::string& head, const void* data, std::size_t bytes)
{
  std::ofstream file(path, std::ios::binary);
  file << head;
  file.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
}

std::vector<std::uint16_t> Samples()
{
  return MakeChunk<std::uint16_t>(0, glm::ivec3(0), Size, Size);
}

void Truncate(const std::string& path, double part)
{
  const auto size = static_cast<double>(std::filesystem::file_size(path));
  std::filesystem::resize_file(path, static_cast<std::uintmax_t>(size * part));
}

/// Expect that reading all chunks fails with a sentence that names the reader, at least once.
void ExpectFailure(vtkAlgorithm* reader, const std::string& array = "")
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

TEST(ReaderVolume, ReadsSeriesOfTiffFiles)
{
  const std::string folder = Folder("vtkTemporalCoherenceReaders");
  const auto names = WriteSlices<vtkTIFFWriter>(folder, ".tif");
  vtkNew<vtkTIFFReader> reader;
  reader->SetFileNames(names);
  reader->SetOrientationType(4); // rows as in VTK, the lowest one first
  reader->SetDataSpacing(0.5, 0.75, 2.0);
  reader->SetDataOrigin(10.0, 20.0, 30.0);
  const auto volume = ExpectImage(reader);
  ASSERT_TRUE(volume);
  ExpectNoMemory(reader);
  EXPECT_NE(volume->Identity().find("slice1129.tif"), std::string::npos);
  Truncate(folder + "slice1077.tif", 0.5);
  std::string error;
  EXPECT_NE(OpenReader(reader, "", error)->Identity(), volume->Identity());
  ExpectFailure(reader);
  std::filesystem::remove(folder + "slice1077.tif");
  ExpectRefusal(reader, "slice1077.tif' is missing");
}

TEST(ReaderVolume, ReadsTiffFilesOfSeveralPages)
{
  const std::string path = WriteTiff(Folder("vtkTemporalCoherenceReaders"));
  vtkNew<vtkTIFFReader> reader;
  reader->SetFileName(path.c_str());
  ASSERT_TRUE(ExpectImage(reader));
  ExpectNoMemory(reader);
  Truncate(path, 0.5);
  ExpectFailure(reader);
}

TEST(ReaderVolume, ReadsSeriesOfOtherFiles)
{
  const std::string folder = Folder("vtkTemporalCoherenceReaders");
  vtkNew<vtkPNGReader> reader;
  reader->SetFileNames(WriteSlices<vtkPNGWriter>(folder, ".png"));
  reader->SetDataSpacing(0.5, 0.75, 2.0);
  reader->SetDataOrigin(10.0, 20.0, 30.0);
  const auto volume = ExpectImage(reader);
  ASSERT_TRUE(volume);
  ExpectPlace(*volume);
  ExpectNoMemory(reader);
  vtkNew<vtkPNGReader> byPattern;
  byPattern->SetFilePrefix(folder.c_str());
  byPattern->SetFilePattern("%sslice1%03d.png");
  byPattern->SetDataExtent(0, 0, 0, 0, 0, Size.z - 1);
  const auto same = ExpectImage(byPattern);
  ASSERT_TRUE(same);
  EXPECT_NE(same->Identity().find("slice1129.png"), std::string::npos);
}

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

TEST(ReaderVolume, ReadsXmlImages)
{
  const std::string folder = Folder("vtkTemporalCoherenceReaders");
  const Image image = MakeImage();
  vtkNew<vtkImageData> other;
  other->CopyStructure(image);
  other->AllocateScalars(VTK_FLOAT, 3);
  other->GetPointData()->GetScalars()->SetName("vectors");
  other->GetPointData()->AddArray(image->GetPointData()->GetScalars());
  for (const int compressor : { 0, 1 }) // none, zlib
  {
    const std::string path = folder + "volume" + std::to_string(compressor) + ".vti";
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(compressor ? other.Get() : image.Get());
    writer->SetDataModeToAppended();
    writer->SetEncodeAppendedData(compressor != 0);
    writer->SetCompressorType(compressor);
    writer->SetFileName(path.c_str());
    writer->Write();
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(path.c_str());
    const std::string name = compressor ? image->GetPointData()->GetScalars()->GetName() : "";
    const auto volume = ExpectImage(reader, name);
    ASSERT_TRUE(volume);
    ExpectPlace(*volume);
    ExpectNoMemory(reader);
    EXPECT_NE(volume->Identity().find(path), std::string::npos);
    ExpectRefusal(reader, "gives no array 'absent'", "absent");
    if (compressor)
    {
      ExpectRefusal(reader, "3 components", "vectors");
    }
    Truncate(path, 0.7);
    ExpectFailure(reader, name);
  }
}

TEST(ReaderVolume, ReadsMrc)
{
  const std::string path = Folder("vtkTemporalCoherenceReaders") + "volume.mrc";
  std::string header(1024, '\0');
  const std::int32_t first[10] = { Size.x, Size.y, Size.z, 1, 0, 0, 0, Size.x, Size.y, Size.z };
  std::memcpy(&header[0], first, sizeof(first));
  const auto samples = Samples();
  WriteBytes(path, header, samples.data(), 2 * samples.size());
  vtkNew<vtkMRCReader> reader;
  reader->SetFileName(path.c_str());
  ASSERT_TRUE(ExpectImage(reader, "", ScalarType::Int16));
  ExpectNoMemory(reader);
  Truncate(path, 0.9);
  ExpectRefusal(reader, "is missing, or shorter");
}

TEST(ReaderVolume, ReadsNifti)
{
  const std::string folder = Folder("vtkTemporalCoherenceReaders");
  for (const char* name : { "volume.nii", "volume.nii.gz" })
  {
    const std::string path = folder + name;
    vtkNew<vtkNIFTIImageWriter> writer;
    writer->SetInputData(MakeImage());
    writer->SetFileName(path.c_str());
    writer->Write();
    vtkNew<vtkNIFTIImageReader> reader;
    reader->SetFileName(path.c_str());
    ASSERT_TRUE(ExpectImage(reader));
    ExpectNoMemory(reader);
    Truncate(path, 0.5);
    ExpectFailure(reader);
  }
}

/// Write an attribute of numbers.
void AddNumbers(hid_t group, const char* name, hid_t type, hsize_t count, const void* numbers)
{
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t attribute = H5Acreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(H5Awrite(attribute, type, numbers), 0);
  H5Aclose(attribute);
  H5Sclose(space);
}

TEST(ReaderVolume, ReadsVtkHdf)
{
  const std::string path = Folder("vtkTemporalCoherenceReaders") + "volume.vtkhdf";
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t root = H5Gcreate2(file, "VTKHDF", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const int version[2] = { 1, 0 };
  const int extent[6] = { 0, Size.x - 1, 0, Size.y - 1, 0, Size.z - 1 };
  const double spacing[3] = { 0.5, 0.75, 2.0 }, origin[3] = { 10.0, 20.0, 30.0 };
  const double direction[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  AddNumbers(root, "Version", H5T_NATIVE_INT, 2, version);
  AddNumbers(root, "WholeExtent", H5T_NATIVE_INT, 6, extent);
  AddNumbers(root, "Spacing", H5T_NATIVE_DOUBLE, 3, spacing);
  AddNumbers(root, "Origin", H5T_NATIVE_DOUBLE, 3, origin);
  AddNumbers(root, "Direction", H5T_NATIVE_DOUBLE, 9, direction);
  const hid_t text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, 9);
  const hid_t one = H5Screate(H5S_SCALAR);
  const hid_t type = H5Acreate2(root, "Type", text, one, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(type, text, "ImageData");
  H5Aclose(type);
  H5Sclose(one);
  H5Tclose(text);
  const hid_t points = H5Gcreate2(root, "PointData", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t sizes[3] = { hsize_t(Size.z), hsize_t(Size.y), hsize_t(Size.x) };
  const hid_t space = H5Screate_simple(3, sizes, nullptr);
  const hid_t data =
    H5Dcreate2(points, "values", H5T_NATIVE_UINT16, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(data, H5T_NATIVE_UINT16, H5S_ALL, H5S_ALL, H5P_DEFAULT, Samples().data());
  H5Dclose(data);
  H5Sclose(space);
  H5Gclose(points);
  H5Gclose(root);
  H5Fclose(file);
  vtkNew<vtkHDFReader> reader;
  reader->SetFileName(path.c_str());
  const auto volume = ExpectImage(reader);
  ASSERT_TRUE(volume);
  ExpectPlace(*volume);
  ExpectNoMemory(reader);
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
