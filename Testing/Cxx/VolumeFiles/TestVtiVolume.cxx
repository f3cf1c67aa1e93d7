// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Raw appended XML images (.vti) are read as VTK wrote them; for other encodings the sentence names
// another reader. Mistakes become sentences.

#include "HeaderFiles.h"

#include "VolumeFiles/VtiVolume.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkMatrix3x3.h>

using namespace TemporalCoherence;

namespace
{

class VtiVolume : public testing::Test
{
protected:
  /// Expect an error about a file that VTK wrote, with a part of it replaced.
  void ExpectErrorWith(
    const std::string& part, const std::string& by, const std::string& array = {})
  {
    const std::string path = this->Folder / "image.vti";
    WriteVti(path, MakeImage(ScalarType::UInt16), [](vtkXMLWriter*) {});
    WriteFile(path, Replaced(ReadFile(path), part, by));
    std::string error;
    EXPECT_FALSE(OpenVti(path, array, error)) << by;
    ExpectSentence(error, "image.vti");
  }

  const ScratchFolder Folder;
};

}

TEST_F(VtiVolume, ReadsWhatVtkWrites)
{
  const std::string path = this->Folder / "image.vti";
  for (int number = 0; number < 10; ++number)
  {
    const auto type = static_cast<ScalarType>(number);
    for (const int header : { vtkXMLWriter::UInt32, vtkXMLWriter::UInt64 })
    {
      for (const int order : { vtkXMLWriter::LittleEndian, vtkXMLWriter::BigEndian })
      {
        WriteVti(path, MakeImage(type),
          [&](vtkXMLWriter* writer)
          {
            writer->SetHeaderType(header);
            writer->SetByteOrder(order);
          });
        std::string error;
        const std::unique_ptr<VolumeFile> file = OpenVti(path, "", error);
        ASSERT_TRUE(file) << error;
        EXPECT_EQ(file->Type(), type);
        ExpectPlaces(*file, { 5, 4, 3 }, { 11.0, 19.5, 30.75 }, { 0.5, 0.5, 0.25 });
        DispatchScalarType(type, [&](auto zero) { ExpectSamples<decltype(zero)>(*file); });
      }
    }
  }
}

TEST_F(VtiVolume, ChoosesArray)
{
  const std::string path = this->Folder / "arrays.vti";
  auto image = MakeImage(ScalarType::Float32);
  vtkNew<vtkDoubleArray> before, cells;
  before->SetName("before");
  before->SetNumberOfTuples(60);
  before->FillValue(-400000.0);
  cells->SetName("cells");
  cells->SetNumberOfTuples(4 * 3 * 2);
  cells->FillValue(0.0);
  image->GetPointData()->AddArray(before);
  image->GetCellData()->AddArray(cells);
  WriteVti(path, image, [](vtkXMLWriter*) {});
  std::string error;
  for (const char* name : { "", "density" })
  {
    const auto file = OpenVti(path, name, error);
    ASSERT_TRUE(file) << error;
    ExpectSamples<float>(*file);
  }
  const auto other = OpenVti(path, "before", error);
  ASSERT_TRUE(other) << error;
  EXPECT_EQ(other->Type(), ScalarType::Float64);
  for (const char* name : { "cells", "none" })
  {
    EXPECT_FALSE(OpenVti(path, name, error));
    ExpectSentence(error, name);
  }
}

TEST_F(VtiVolume, NamesAnotherReaderForOtherEncodings)
{
  const std::string path = this->Folder / "image.vti";
  const auto expectError = [&](const auto& change)
  {
    WriteVti(path, MakeImage(ScalarType::UInt16), change);
    std::string error;
    EXPECT_FALSE(OpenVti(path, "", error));
    ExpectSentence(error, "image.vti");
    EXPECT_NE(error.find("use vtkXMLImageDataReader as a reader"), std::string::npos) << error;
  };
  expectError([](vtkXMLWriter* writer) { writer->SetCompressorTypeToZLib(); });
  expectError([](vtkXMLWriter* writer) { writer->SetDataModeToAscii(); });
  expectError([](vtkXMLWriter* writer) { writer->SetDataModeToBinary(); });
  expectError([](vtkXMLWriter* writer) { writer->EncodeAppendedDataOn(); });
  expectError([](vtkXMLWriter* writer)
    { dynamic_cast<vtkXMLImageDataWriter*>(writer)->SetNumberOfPieces(2); });
  expectError(
    [](vtkXMLWriter* writer)
    {
      vtkNew<vtkMatrix3x3> turned;
      turned->SetElement(0, 0, 0.0);
      turned->SetElement(0, 1, 1.0);
      turned->SetElement(1, 0, -1.0);
      turned->SetElement(1, 1, 0.0);
      vtkImageData::SafeDownCast(writer->GetInput())->SetDirectionMatrix(turned);
    });
}

TEST_F(VtiVolume, TellsMistakes)
{
  this->ExpectErrorWith("type=\"ImageData\"", "type=\"PolyData\"");
  this->ExpectErrorWith("<VTKFile", "<!DOCTYPE x []><VTKFile");
  this->ExpectErrorWith("<ImageData", "<<mageData");
  this->ExpectErrorWith("WholeExtent=\"2 6 -1 2 3 5\"", "WholeExtent=\"2 6 -1 2 3\"");
  this->ExpectErrorWith("WholeExtent=\"2 6", "WholeExtent=\"2 7");
  this->ExpectErrorWith("Origin=\"10 ", "Origin=\"inf ");
  this->ExpectErrorWith("Spacing=\"0.5 ", "Spacing=\"0 ");
  this->ExpectErrorWith("UInt16", "String");
  this->ExpectErrorWith("offset=\"0\"", "offset=\"-1\"");
  this->ExpectErrorWith("offset=\"0\"", "offset=\"1\"");
  this->ExpectErrorWith("offset=\"0\"", "offset=\"9223372036854775807\"");
  this->ExpectErrorWith("offset=\"0\"", "offset=\"9223372036854775808\"");
  this->ExpectErrorWith("byte_order=\"LittleEndian\"", "byte_order=\"Middle\"");
  this->ExpectErrorWith("header_type=\"UInt32\"", "header_type=\"UInt16\"");
  this->ExpectErrorWith("format=\"appended\"", "format=\"appended\" NumberOfComponents=\"2\"");
  this->ExpectErrorWith("   _", "   x");
  this->ExpectErrorWith("<AppendedData", std::string(1100000, ' ') + "<AppendedData");
  std::string error;
  EXPECT_FALSE(OpenVti(this->Folder / "missing.vti", "", error));
  ExpectSentence(error, "missing.vti");
}

TEST_F(VtiVolume, TellsHugeAndCutFiles)
{
  const std::string path = this->Folder / "image.vti";
  WriteVti(path, MakeImage(ScalarType::UInt16), [](vtkXMLWriter*) {});
  const std::string text = ReadFile(path);
  const std::size_t data = text.find("   _");
  for (const std::size_t size : { std::size_t(0), data / 2, data + 4, data + 6, data + 50 })
  {
    WriteFile(path, text.substr(0, size));
    std::string error;
    EXPECT_FALSE(OpenVti(path, "", error));
    ExpectSentence(error, "image.vti");
  }
  const std::string extent = "0 2147483646 0 2147483646 0 2147483646";
  std::string huge = Replaced(text, "2 6 -1 2 3 5", extent);
  huge = Replaced(huge, "2 6 -1 2 3 5", extent);
  WriteFile(path, huge);
  std::string error;
  EXPECT_FALSE(OpenVti(path, "", error));
  ExpectSentence(error, "image.vti");
}

TEST_F(VtiVolume, DeepElementsDoNoHarm)
{
  std::string text = "<VTKFile type=\"ImageData\">";
  while (text.size() < 1040000)
  {
    text += "<a>";
  }
  WriteFile(this->Folder / "deep.vti", text);
  std::string error;
  EXPECT_FALSE(OpenVti(this->Folder / "deep.vti", "", error));
  ExpectSentence(error, "deep.vti");
}
