// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MedicalReader.h"

#include "Files/FileCheck.h"
#include "Files/WholeCheck.h"
#include "Program/Quoted.h"
#include "Program/Silence.h"

#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageHeader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace
{

constexpr std::size_t MostHeader = 1 << 16; // bytes of a header of MetaImage

// The smallest type that holds numbers as they are: whole ones if they can be.
int TypeFor(vtkDataArray* samples, double slope, double offset)
{
  const int type = samples->GetDataType();
  const bool isWhole = type != VTK_FLOAT && type != VTK_DOUBLE && std::floor(slope) == slope &&
    std::floor(offset) == offset;
  double least = slope * samples->GetDataTypeMin() + offset;
  double most = slope * samples->GetDataTypeMax() + offset;
  if (least > most)
  {
    std::swap(least, most);
  }
  const auto fits = [&](int other)
  {
    return isWhole && least >= vtkDataArray::GetDataTypeMin(other) &&
      most <= vtkDataArray::GetDataTypeMax(other);
  };
  return fits(VTK_SHORT)                                                         ? VTK_SHORT
    : fits(VTK_INT)                                                              ? VTK_INT
    : type == VTK_DOUBLE || samples->GetDataTypeSize() > 3 + (type == VTK_FLOAT) ? VTK_DOUBLE
                                                                                 : VTK_FLOAT;
}

// Samples become the values that they stand for.
void Rescale(vtkImageData* image, double slope, double offset)
{
  vtkDataArray* samples = image->GetPointData()->GetScalars();
  const bool isNone = slope == 0.0 || (slope == 1.0 && offset == 0.0);
  if (!samples || isNone || !std::isfinite(slope) || !std::isfinite(offset))
  {
    return;
  }
  const auto values = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(TypeFor(samples, slope, offset)));
  values->SetName(samples->GetName());
  values->SetNumberOfComponents(samples->GetNumberOfComponents());
  values->SetNumberOfTuples(samples->GetNumberOfTuples());
  const auto from = vtk::DataArrayValueRange(samples);
  auto to = vtk::DataArrayValueRange(values);
  std::transform(
    from.begin(), from.end(), to.begin(), [=](double sample) { return slope * sample + offset; });
  image->GetPointData()->SetScalars(values);
}

// The fields of a header, up to the one that names the samples.
std::map<std::string, std::string> FieldsOf(const std::string& path)
{
  std::map<std::string, std::string> fields;
  std::istringstream in(BytesOf(path, MostHeader));
  const auto trimmed = [](const std::string& text)
  {
    const std::size_t begin = text.find_first_not_of(" \t\r=:");
    const std::size_t end = text.find_last_not_of(" \t\r");
    return begin == std::string::npos ? "" : text.substr(begin, end + 1 - begin);
  };
  for (std::string line; fields.count("ElementDataFile") == 0 && std::getline(in, line);)
  {
    // MetaIO takes a colon, too.
    const std::size_t equals = std::min(line.find_first_of("=:"), line.size());
    fields[trimmed(line.substr(0, equals))] = trimmed(line.substr(equals));
  }
  return fields;
}

// VTK's reader takes one of 4 bytes for one of 8, and others for none.
void RequireKnownType(const std::string& path, std::string type)
{
  static const std::set<std::string> known = { "MET_CHAR", "MET_UCHAR", "MET_SHORT", "MET_USHORT",
    "MET_INT", "MET_UINT", "MET_FLOAT", "MET_DOUBLE", "MET_CHAR_ARRAY", "MET_UCHAR_ARRAY",
    "MET_SHORT_ARRAY", "MET_USHORT_ARRAY", "MET_INT_ARRAY", "MET_UINT_ARRAY" };
  if (!type.empty() && known.count(type) == 0) // a file without a type is no MetaImage
  {
    throw UserError(Quoted(path) + " has samples of the type " + Quoted(type) +
      ", which VTK does not read; save them as MET_INT, MET_FLOAT or MET_DOUBLE.");
  }
}

// A row of TransformMatrix tells where an axis of the image points to.
void SetDirection(const std::string& path, const std::string& text, vtkImageData* image)
{
  std::istringstream in(text);
  vtkNew<vtkMatrix3x3> direction;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < 3; ++i)
    {
      double cosine = 0.0;
      if (!(in >> cosine))
      {
        throw Damaged(path, "its TransformMatrix has not 9 numbers");
      }
      direction->SetElement(i, axis, cosine);
    }
  }
  image->SetDirectionMatrix(direction);
}

// MetaIO tells of short files on the terminal.
vtkSmartPointer<vtkImageData> ReadSamples(
  vtkMetaImageReader* reader, const std::string& path, const ReadingProgress& progress)
{
  const Silence silence;
  const vtkSmartPointer<vtkImageData> image = ReadImage(reader, path, progress);
  const std::string said = silence.SaidByLibraries();
  if (silence.HeardErrors() || said.find("not read completely") != std::string::npos ||
    said.find("Uncompress failed") != std::string::npos)
  {
    throw Damaged(path, "its samples, or a file of them, end too early");
  }
  return image;
}

}

void ReadMetaImage(const std::string& path, const ReadingProgress& progress, Volume& volume)
{
  std::map<std::string, std::string> fields = FieldsOf(path);
  RequireKnownType(path, fields["ElementType"]);
  vtkNew<vtkMetaImageReader> reader;
  if (reader->CanReadFile(path.c_str()))
  {
    volume.Remark = RequireWholeMetaImage(path, fields);
  }
  const vtkSmartPointer<vtkImageData> image = ReadSamples(reader, path, progress);
  Rescale(image, reader->GetRescaleSlope(), reader->GetRescaleOffset());
  for (const char* key : { "Orientation", "Rotation", "TransformMatrix" })
  {
    if (fields.count(key) == 1 && reader->GetFileDimensionality() == 3)
    {
      SetDirection(path, fields[key], image);
    }
  }
  volume.Data = image;
}

// A header may place the samples among the patient's axes: the scanner's (q) or a template's (s).
void ReadNifti(const std::string& path, const ReadingProgress& progress, Volume& volume)
{
  vtkNew<vtkNIFTIImageReader> reader;
  const vtkSmartPointer<vtkImageData> image = ReadImage(reader.Get(), path, progress);
  constexpr int Rgb = 128, Rgba = 2304;
  const int type = reader->GetNIFTIHeader() ? reader->GetNIFTIHeader()->GetDataType() : 0;
  if (type != Rgb && type != Rgba)
  {
    Rescale(image, reader->GetRescaleSlope(), reader->GetRescaleIntercept());
  }
  vtkMatrix4x4* placement =
    reader->GetSFormMatrix() ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
  if (placement && std::abs(placement->Determinant()) > 0.0)
  {
    volume.Placement = placement;
  }
  volume.From = "+y";
  volume.Data = image;
}
