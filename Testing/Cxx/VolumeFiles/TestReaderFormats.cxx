// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// VTK's readers of several formats give volumes chunk by chunk. Damaged files give sentences.

#include "ReaderImages.h"

#include <hdf5.h>
#include <vtkDataArray.h>
#include <vtkHDFReader.h>
#include <vtkMRCReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNIFTIImageWriter.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTIFFReader.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

using namespace ReaderImages;

namespace
{

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

/// Write an attribute of numbers.
void AddNumbers(hid_t group, const char* name, hid_t type, hsize_t count, const void* numbers)
{
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t attribute = H5Acreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(H5Awrite(attribute, type, numbers), 0);
  H5Aclose(attribute);
  H5Sclose(space);
}

}

TEST(ReaderFormats, ReadsSeriesOfTiffFiles)
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

TEST(ReaderFormats, ReadsTiffFilesOfSeveralPages)
{
  const std::string path = WriteTiff(Folder("vtkTemporalCoherenceReaders"));
  vtkNew<vtkTIFFReader> reader;
  reader->SetFileName(path.c_str());
  ASSERT_TRUE(ExpectImage(reader));
  ExpectNoMemory(reader);
  Truncate(path, 0.5);
  ExpectFailure(reader);
}

TEST(ReaderFormats, ReadsSeriesOfOtherFiles)
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

TEST(ReaderFormats, ReadsXmlImages)
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

TEST(ReaderFormats, ReadsMrc)
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

TEST(ReaderFormats, ReadsNifti)
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

TEST(ReaderFormats, ReadsVtkHdf)
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
