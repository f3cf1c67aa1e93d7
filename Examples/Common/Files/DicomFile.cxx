// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/DicomFile.h"

#include "Files/FileCheck.h"
#include "Program/Quoted.h"

#include <gdcmAttribute.h>
#include <gdcmException.h>
#include <gdcmImageChangePlanarConfiguration.h>
#include <gdcmImageHelper.h>
#include <gdcmImageReader.h>
#include <gdcmMediaStorage.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmTrace.h>

#include <vtkDataArray.h>

#include <cstdint>
#include <istream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace
{

constexpr std::size_t Preamble = 128; // bytes before the word DICM

using gdcm::DataSet;
using gdcm::Tag;

const Tag SliceThickness(0x0018, 0x0050), SliceDistance(0x0018, 0x0088), Series(0x0020, 0x000e),
  Number(0x0020, 0x0013), Interpretation(0x0028, 0x0004), ModalityTable(0x0028, 0x3000),
  DoseScaling(0x3004, 0x000e), SharedGroups(0x5200, 0x9229), FrameGroups(0x5200, 0x9230),
  Pixels(0x7fe0, 0x0010);

// Numbers of a slice, and the functional group that holds them in files of several frames.
struct FrameTag
{
  Tag Element, Group;
};
const FrameTag Position = { Tag(0x0020, 0x0032), Tag(0x0020, 0x9113) },
               Orientation = { Tag(0x0020, 0x0037), Tag(0x0020, 0x9116) },
               Spacing = { Tag(0x0028, 0x0030), Tag(0x0028, 0x9110) },
               Intercept = { Tag(0x0028, 0x1052), Tag(0x0028, 0x9145) },
               Slope = { Tag(0x0028, 0x1053), Tag(0x0028, 0x9145) };

std::string TextOf(const DataSet& elements, const Tag& tag)
{
  const gdcm::ByteValue* value =
    elements.FindDataElement(tag) ? elements.GetDataElement(tag).GetByteValue() : nullptr;
  const std::string text = value ? std::string(value->GetPointer(), value->GetLength()) : "";
  return text.substr(0, text.find_last_not_of(std::string(" \0", 2)) + 1);
}

// Decimal numbers between backslashes; none where there is no such element.
std::vector<double> NumbersOf(const DataSet& elements, const Tag& tag)
{
  std::vector<double> numbers;
  std::istringstream in(TextOf(elements, tag));
  for (std::string word; std::getline(in, word, '\\');)
  {
    std::istringstream number(word);
    if (!(number >> numbers.emplace_back()) || !(number >> std::ws).eof())
    {
      std::ostringstream what;
      what << "its element " << tag << " holds " << Quoted(word) << " instead of a number";
      throw std::runtime_error(what.str());
    }
  }
  return numbers;
}

double NumberOf(const DataSet& elements, const Tag& tag, double otherwise)
{
  const std::vector<double> numbers = NumbersOf(elements, tag);
  return numbers.empty() ? otherwise : numbers.front();
}

DataSet ItemOf(const DataSet& elements, const Tag& sequence, std::size_t number)
{
  if (!elements.FindDataElement(sequence))
  {
    return {};
  }
  const auto items = elements.GetDataElement(sequence).GetValueAsSQ();
  return items && number < items->GetNumberOfItems() ? items->GetItem(number + 1).GetNestedDataSet()
                                                     : DataSet();
}

// The elements of one frame: of its own group, of that of all frames, or of the file.
DataSet FrameOf(const DataSet& file, const FrameTag& tag, unsigned frame)
{
  for (const auto& [groups, number] :
    { std::pair(FrameGroups, frame), std::pair(SharedGroups, 0u) })
  {
    const DataSet group = ItemOf(ItemOf(file, groups, number), tag.Group, 0);
    if (group.FindDataElement(tag.Element))
    {
      return group;
    }
  }
  return file;
}

// Of a file of several frames, what is told of the file is that of the first frame at best.
DicomSlice SliceOf(const DataSet& file, DicomSlice slice)
{
  const auto numbers = [&](const FrameTag& tag, std::size_t count)
  {
    std::vector<double> found = NumbersOf(FrameOf(file, tag, slice.Frame), tag.Element);
    return found.size() == count ? found : std::vector<double>();
  };
  const auto number = [&](const FrameTag& tag, double otherwise)
  { return NumberOf(FrameOf(file, tag, slice.Frame), tag.Element, otherwise); };
  slice.Orientation = numbers(Orientation, 6);
  slice.Spacing = numbers(Spacing, 2);
  if (slice.Frames == 1 || !file.FindDataElement(Position.Element))
  {
    slice.Position = numbers(Position, 3);
  }
  if (!slice.Spacing.empty() && !(slice.Spacing[0] > 0.0 && slice.Spacing[1] > 0.0))
  {
    slice.Spacing.clear();
  }
  slice.Values = { number(Slope, NumberOf(file, DoseScaling, 1.0)), number(Intercept, 0.0) };
  return slice;
}

// What GDCM ends the program for, takes for something else, or leaves out.
std::string FaultOf(const gdcm::File& file)
{
  const std::string kind = TextOf(file.GetDataSet(), Interpretation);
  if (!kind.empty() && kind != "MONOCHROME1" && kind != "MONOCHROME2" && kind != "RGB")
  {
    return "its pixels are of the kind " + Quoted(kind) + ", neither MONOCHROME2 nor RGB";
  }
  const gdcm::PixelFormat format = gdcm::ImageHelper::GetPixelFormatValue(file);
  const int stored = format.GetBitsStored(), allocated = format.GetBitsAllocated();
  gdcm::Attribute<0x0028, 0x0102> highest = { static_cast<std::uint16_t>(stored - 1) };
  highest.SetFromDataSet(file.GetDataSet());
  if (highest.GetValue() != stored - 1 || (stored != allocated && allocated != 16))
  {
    return "its samples are " + std::to_string(stored) + " of " + std::to_string(allocated) +
      " bits, of which bit " + std::to_string(highest.GetValue()) + " is the highest one";
  }
  return file.GetDataSet().FindDataElement(ModalityTable)
    ? "a table tells what its samples stand for, which is not applied here"
    : "";
}

// Whether a file ends before pixels that are not compressed, which GDCM fills up with zeros.
bool IsCut(const gdcm::Reader& reader, const DicomSlice& slice)
{
  const gdcm::TransferSyntax syntax = reader.GetFile().GetHeader().GetDataSetTransferSyntax();
  const double bytes = gdcm::ImageHelper::GetPixelFormatValue(reader.GetFile()).GetPixelSize() *
    static_cast<double>(slice.Columns) * slice.Rows * slice.Frames;
  return !syntax.IsEncapsulated() &&
    syntax != gdcm::TransferSyntax::DeflatedExplicitVRLittleEndian &&
    static_cast<double>(reader.GetStreamCurrentPosition()) + bytes >
    static_cast<double>(SizeOf(slice.Path));
}

std::vector<DicomSlice> SlicesOf(const std::string& path)
{
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  if (!reader.ReadUpToTag(Pixels, { Pixels })) // up to where they begin
  {
    throw std::runtime_error("its elements are not those of DICOM");
  }
  const DataSet& file = reader.GetFile().GetDataSet();
  const std::vector<unsigned> size = gdcm::ImageHelper::GetDimensionsValue(reader.GetFile());
  DicomSlice slice;
  slice.Path = path;
  slice.Series = TextOf(file, Series);
  slice.Columns = size[0];
  slice.Rows = size[1];
  slice.Frames = size[2];
  slice.Components = gdcm::ImageHelper::GetPixelFormatValue(reader.GetFile()).GetSamplesPerPixel();
  if (slice.Columns == 0 || slice.Rows == 0)
  {
    gdcm::MediaStorage kind;
    if (kind.SetFromDataSet(file) && gdcm::MediaStorage::IsImage(kind))
    {
      throw std::runtime_error("it is an image by its SOP class, but has no rows or columns");
    }
    return {};
  }
  if (slice.Frames > SizeOf(path))
  {
    throw std::runtime_error("its " + std::to_string(slice.Frames) + " frames are not there");
  }
  slice.Fault = FaultOf(reader.GetFile());
  if (slice.Fault.empty() && IsCut(reader, slice))
  {
    slice.Fault = "its pixels are not all there";
  }
  slice.Number = NumberOf(file, Number, 0.0);
  slice.Distance = NumberOf(file, SliceDistance, NumberOf(file, SliceThickness, 0.0));
  std::vector<DicomSlice> slices;
  for (; slice.Frame < slice.Frames; ++slice.Frame)
  {
    slices.push_back(SliceOf(file, slice));
  }
  return slices;
}

int TypeOf(const gdcm::PixelFormat& format)
{
  using Format = gdcm::PixelFormat;
  static const std::map<Format::ScalarType, int> types = { { Format::UINT8, VTK_UNSIGNED_CHAR },
    { Format::INT8, VTK_SIGNED_CHAR }, { Format::UINT16, VTK_UNSIGNED_SHORT },
    { Format::INT16, VTK_SHORT }, { Format::UINT32, VTK_UNSIGNED_INT },
    { Format::INT32, VTK_INT } };
  const auto found = types.find(format.GetScalarType());
  if (found == types.end())
  {
    throw std::runtime_error("its samples are not of 8, 16 or 32 bits");
  }
  return found->second;
}

vtkSmartPointer<vtkDataArray> PixelsOf(const std::string& path)
{
  gdcm::ImageReader reader;
  reader.SetFileName(path.c_str());
  if (!reader.Read())
  {
    throw std::runtime_error("it has no pixels that GDCM reads");
  }
  const auto bytes = static_cast<double>(reader.GetImage().GetBufferLength());
  const gdcm::ByteValue* plain = reader.GetImage().GetDataElement().GetByteValue();
  if (plain && plain->GetLength() < bytes)
  {
    throw std::runtime_error("its pixels are not all there");
  }
  RequireBytesFor(path, bytes);
  gdcm::ImageChangePlanarConfiguration colorsTogether;
  colorsTogether.SetInput(reader.GetImage());
  colorsTogether.Change();
  const gdcm::Image& image = colorsTogether.GetOutput();
  auto samples = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(TypeOf(image.GetPixelFormat())));
  samples->SetName("DICOM");
  samples->SetNumberOfComponents(image.GetPixelFormat().GetSamplesPerPixel());
  samples->SetNumberOfValues(
    static_cast<vtkIdType>(image.GetBufferLength()) / samples->GetDataTypeSize());
  if (!image.GetBuffer(static_cast<char*>(samples->GetVoidPointer(0))))
  {
    throw std::runtime_error("GDCM does not read pixels in the transfer syntax " +
      Quoted(image.GetTransferSyntax().GetString()));
  }
  return samples;
}

// What reading throws becomes a sentence on the file.
template <typename Function>
auto ReadAs(const std::string& path, Function read)
{
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  try
  {
    return read(path);
  }
  catch (const UserError&)
  {
    throw;
  }
  catch (const std::runtime_error& error) // of this file
  {
    throw Damaged(path, error.what());
  }
  catch (const gdcm::Exception&)
  {
    throw Damaged(path, "GDCM fails on it");
  }
}

}

std::string DicomSlice::Name() const
{
  return (this->Frames > 1 ? "frame " + std::to_string(this->Frame + 1) + " of " : "") +
    Quoted(this->Path);
}

std::vector<DicomSlice> ReadDicomHeader(const std::string& path)
{
  const std::string start = BytesOf(path, Preamble + 4);
  const bool isDicom = start.size() == Preamble + 4 && start.compare(Preamble, 4, "DICM") == 0;
  return isDicom ? ReadAs(path, SlicesOf) : std::vector<DicomSlice>();
}

vtkSmartPointer<vtkDataArray> ReadDicomPixels(const std::string& path)
{
  return ReadAs(path, PixelsOf);
}
