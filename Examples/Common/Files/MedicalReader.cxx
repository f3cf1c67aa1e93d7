// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MedicalReader.h"

#include "Files/FileCheck.h"
#include "Files/Rescale.h"
#include "Files/WholeCheck.h"
#include "Program/Quoted.h"
#include "Program/Silence.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageHeader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

namespace
{

constexpr std::size_t MostHeader = 1 << 16; // bytes of a header of MetaImage

// Samples become the values that they stand for.
void ApplyRescaling(vtkImageData* image, const Rescaling& rescaling)
{
  vtkDataArray* samples = image->GetPointData()->GetScalars();
  const bool isNone = rescaling.Slope == 0.0 || (rescaling.Slope == 1.0 && rescaling.Offset == 0.0);
  if (!samples || isNone || !std::isfinite(rescaling.Slope) || !std::isfinite(rescaling.Offset))
  {
    return;
  }
  ValueType type;
  type.Add(samples, rescaling);
  const auto values = MakeArrayLike(samples, type.Get(), samples->GetNumberOfTuples());
  Rescale(samples, 0, samples->GetNumberOfValues(), rescaling, values, 0);
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

// Reads one of the volumes that a file of four dimensions holds, where VTK's reader reads the
// first.
class NiftiReader : public vtkNIFTIImageReader
{
public:
  static NiftiReader* New() { VTK_STANDARD_NEW_BODY(NiftiReader); }
  int TimeStep = 1;

protected:
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const int isKnown = vtkNIFTIImageReader::RequestInformation(request, inputs, outputs);
    if (isKnown && this->TimeStep <= this->GetTimeDimension())
    {
      unsigned long bytes = static_cast<unsigned long>(
        vtkDataArray::GetDataTypeSize(this->DataScalarType) * this->NumberOfScalarComponents);
      for (const int axis : { 1, 2, 3 })
      {
        bytes *= static_cast<unsigned long>(this->Dim[axis]);
      }
      const auto vectors = static_cast<unsigned long>(std::max(1, this->Dim[5]));
      this->HeaderSize += static_cast<unsigned long>(this->TimeStep - 1) * (bytes / vectors);
    }
    return isKnown;
  }
};

}

bool IsRescaledMetaImage(const std::string& path)
{
  const std::map<std::string, std::string> fields = FieldsOf(path);
  const auto differs = [&fields](const char* key, double usual)
  {
    const auto field = fields.find(key);
    return field != fields.end() && std::strtod(field->second.c_str(), nullptr) != usual;
  };
  return differs("ElementToIntensityFunctionSlope", 1.0) ||
    differs("ElementToIntensityFunctionOffset", 0.0);
}

void ReadMetaImage(const std::string& path, const ReadingProgress& progress, Volume& volume)
{
  std::map<std::string, std::string> fields = FieldsOf(path);
  RequireKnownType(path, fields["ElementType"]);
  vtkNew<vtkMetaImageReader> reader;
  if (reader->CanReadFile(path.c_str()))
  {
    reader->SetFileName(path.c_str());
    reader->UpdateInformation();
    volume.Remark = RequireWholeMetaImage(reader, fields);
  }
  const vtkSmartPointer<vtkImageData> image = ReadSamples(reader, path, progress);
  ApplyRescaling(image, { reader->GetRescaleSlope(), reader->GetRescaleOffset() });
  for (const char* key : { "Orientation", "Rotation", "TransformMatrix" })
  {
    if (fields.count(key) == 1 && reader->GetFileDimensionality() == 3)
    {
      SetDirection(path, fields[key], image);
    }
  }
  volume.Data = image;
}

// A header may place the samples among the patient's axes: the scanner's (q) or, first, those of
// another image (s).
void ReadNifti(
  const std::string& path, int timeStep, const ReadingProgress& progress, Volume& volume)
{
  vtkNew<NiftiReader> reader;
  reader->TimeStep = timeStep;
  const vtkSmartPointer<vtkImageData> image = ReadImage(reader.Get(), path, progress);
  volume.TimeSteps = std::max(1, reader->GetTimeDimension());
  constexpr int Rgb = 128, Rgba = 2304;
  const int type = reader->GetNIFTIHeader() ? reader->GetNIFTIHeader()->GetDataType() : 0;
  if (type != Rgb && type != Rgba)
  {
    ApplyRescaling(image, { reader->GetRescaleSlope(), reader->GetRescaleIntercept() });
  }
  for (vtkMatrix4x4* placement : { reader->GetSFormMatrix(), reader->GetQFormMatrix() })
  {
    if (!volume.Placement && placement && std::abs(placement->Determinant()) > 0.0)
    {
      volume.Placement = placement;
    }
  }
  volume.From = "+y";
  volume.Data = image;
}

#ifndef EXAMPLES_HAVE_GDCM
void ReadDicom(const std::string& path, const ReadingProgress&, Volume&)
{
  throw UserError(Quoted(path) +
    " is a directory, as of DICOM files, which this program was built without: install GDCM "
    "(Debian's libgdcm-dev) and build it again, or convert the files to NIfTI.");
}
#endif
