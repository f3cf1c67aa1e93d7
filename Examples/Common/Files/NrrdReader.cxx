// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/NrrdReader.h"

#include "Files/FileCheck.h"
#include "Files/NrrdHeader.h"
#include "Program/Quoted.h"

#include <vtkByteSwap.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtk_zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <vector>

namespace
{

constexpr std::size_t Chunk = 1 << 22; // bytes between two looks at the progress

// Bytes of a file as they are.
class RawBytes
{
public:
  explicit RawBytes(const std::string& path, std::uintmax_t begin)
    : File(path, std::ios::binary)
  {
    this->File.seekg(static_cast<std::streamoff>(begin));
  }
  virtual ~RawBytes() = default;

  // How many bytes there were, up to so many.
  virtual std::size_t Read(char* to, std::size_t count)
  {
    this->File.read(to, static_cast<std::streamsize>(count));
    return static_cast<std::size_t>(this->File.gcount());
  }

protected:
  std::ifstream File;
};

// Bytes that a gzip stream in a file stands for.
class InflatedBytes : public RawBytes
{
public:
  InflatedBytes(const std::string& path, std::uintmax_t begin)
    : RawBytes(path, begin)
  {
    constexpr int OfGzip = 16 + MAX_WBITS;
    this->IsGood = inflateInit2(&this->Stream, OfGzip) == Z_OK;
  }
  ~InflatedBytes() override { inflateEnd(&this->Stream); }
  InflatedBytes(const InflatedBytes&) = delete;
  InflatedBytes& operator=(const InflatedBytes&) = delete;

  std::size_t Read(char* to, std::size_t count) override
  {
    this->Stream.next_out = reinterpret_cast<Bytef*>(to);
    this->Stream.avail_out = static_cast<uInt>(count);
    while (this->IsGood && this->Stream.avail_out > 0)
    {
      if (this->Stream.avail_in == 0)
      {
        this->Stream.next_in = this->Input.data();
        this->Stream.avail_in = static_cast<uInt>(
          RawBytes::Read(reinterpret_cast<char*>(this->Input.data()), this->Input.size()));
      }
      const int status = inflate(&this->Stream, Z_NO_FLUSH);
      // Streams may follow each other.
      this->IsGood = status == Z_OK ||
        (status == Z_STREAM_END && inflateReset(&this->Stream) == Z_OK &&
          (this->Stream.avail_in > 0 || this->File.peek() != EOF));
      this->IsWhole = status == Z_STREAM_END;
    }
    return count - this->Stream.avail_out;
  }

  // Whether what is left of the stream is well. Its end tells a sum of what was before.
  bool Finish()
  {
    char more[512];
    while (this->IsGood && this->Read(more, sizeof(more)) > 0)
    {
    }
    return this->IsWhole;
  }

private:
  z_stream Stream = {};
  std::vector<Bytef> Input = std::vector<Bytef>(1 << 16);
  bool IsGood = false, IsWhole = false;
};

UserError TooFew(const std::string& path, const std::string& file)
{
  return Damaged(path, Quoted(file) + " has fewer samples than the header tells of");
}

// Reads the samples of a file, of which the header tells, or of several.
class Samples
{
public:
  Samples(const std::string& path, const NrrdHeader& header, const ReadingProgress& progress)
    : Path(path)
    , Header(header)
    , Progress(progress)
    , Files(header.Files.empty() ? std::vector<std::string>{ path } : header.Files)
  {
    const double inAll = header.Samples(), share = static_cast<double>(this->Files.size());
    if (!(inAll < 1e15) || std::fmod(inAll, share) != 0.0)
    {
      throw Damaged(path, "its samples do not fit into the files that it names");
    }
    this->InFile = static_cast<std::uint64_t>(inAll / share);
    std::error_code error;
    for (const std::string& file : this->Files)
    {
      if (!std::filesystem::is_regular_file(file, error))
      {
        throw Damaged(path, "it names " + Quoted(file) + ", which is not there, or no file");
      }
    }
  }

  std::string Remark;

  // Samples from a place on, as many as the array has.
  void Read(std::uint64_t from, vtkDataArray* to)
  {
    const auto count = static_cast<std::uint64_t>(to->GetNumberOfValues());
    for (std::uint64_t done = 0; done < count;)
    {
      const std::uint64_t file = (from + done) / this->InFile, at = (from + done) % this->InFile;
      const std::uint64_t size = std::min(count - done, this->InFile - at);
      const std::string& name = this->Files[static_cast<std::size_t>(file)];
      this->Done = static_cast<double>(done) / static_cast<double>(count);
      this->Share = static_cast<double>(size) / static_cast<double>(count);
      if (this->Header.Encoding == NrrdHeader::Text)
      {
        this->ReadText(name, at, to, static_cast<vtkIdType>(done), static_cast<vtkIdType>(size));
      }
      else
      {
        const auto ofSample = static_cast<std::uint64_t>(to->GetDataTypeSize());
        char* bytes = static_cast<char*>(to->GetVoidPointer(static_cast<vtkIdType>(done)));
        this->ReadBytes(name, at * ofSample, bytes, size * ofSample, this->InFile * ofSample);
      }
      done += size;
    }
  }

private:
  void Tell(double share)
  {
    if (this->Progress && !this->Progress(this->Done + share * this->Share))
    {
      throw Stopped(this->Path);
    }
  }

  // Where samples begin in a file.
  std::uintmax_t BeginIn(const std::string& name, std::uint64_t inFile) const
  {
    const std::uintmax_t size = SizeOf(name);
    const std::uintmax_t head = this->Header.Files.empty() ? this->Header.Size : 0;
    const bool isAtEnd = this->Header.Skip < 0;
    if (isAtEnd && size < head + inFile)
    {
      throw TooFew(this->Path, name);
    }
    return isAtEnd ? size - inFile : head + static_cast<std::uintmax_t>(this->Header.Skip);
  }

  void ReadBytes(
    const std::string& name, std::uint64_t at, char* to, std::uint64_t count, std::uint64_t inFile)
  {
    const bool isRaw = this->Header.Encoding == NrrdHeader::Raw;
    std::unique_ptr<RawBytes> bytes;
    if (isRaw)
    {
      const std::uintmax_t begin = this->BeginIn(name, inFile), size = SizeOf(name);
      if (size < begin + inFile)
      {
        throw TooFew(this->Path, name);
      }
      if (size > begin + inFile)
      {
        this->Remark = Quoted(name) + " has " + std::to_string(size - begin - inFile) +
          " bytes more than its header tells of, which are not drawn; check sizes and type.";
      }
      bytes = std::make_unique<RawBytes>(name, begin + at);
    }
    else
    {
      const std::uintmax_t begin = this->Header.Files.empty() ? this->Header.Size : 0;
      bytes = std::make_unique<InflatedBytes>(name, begin);
      std::vector<char> before(Chunk); // what is not wanted
      std::uint64_t skipped = at + static_cast<std::uint64_t>(this->Header.Skip);
      for (std::uint64_t read = 1; skipped > 0 && read > 0; skipped -= read)
      {
        read = bytes->Read(before.data(), std::min<std::size_t>(Chunk, skipped));
      }
    }
    for (std::uint64_t done = 0; done < count;)
    {
      this->Tell(static_cast<double>(done) / static_cast<double>(count));
      const std::size_t size = std::min<std::size_t>(Chunk, count - done);
      if (bytes->Read(to + done, size) < size)
      {
        throw TooFew(this->Path, name);
      }
      done += size;
    }
    if (!isRaw && !static_cast<InflatedBytes*>(bytes.get())->Finish())
    {
      throw Damaged(this->Path, "the compressed samples of " + Quoted(name) + " have no good end");
    }
  }

  void ReadText(
    const std::string& name, std::uint64_t at, vtkDataArray* to, vtkIdType first, vtkIdType count)
  {
    std::ifstream file(name, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(this->BeginIn(name, 0)));
    const double least = to->GetDataTypeMin(), most = to->GetDataTypeMax();
    const int components = to->GetNumberOfComponents();
    const bool isFloat = to->GetDataType() == VTK_FLOAT || to->GetDataType() == VTK_DOUBLE;
    std::string word;
    std::istringstream in;
    for (std::uint64_t i = 0; i < at && file >> word; ++i)
    {
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (i % static_cast<vtkIdType>(Chunk) == 0)
      {
        this->Tell(static_cast<double>(i) / static_cast<double>(count));
      }
      if (!(file >> word))
      {
        throw TooFew(this->Path, name);
      }
      word.erase(word.find_last_not_of(',') + 1); // which some put between numbers
      in.clear();
      in.str(word);
      double number = NAN;
      const bool isNan = isFloat && LowerCase(word) == "nan";
      if (!isNan && (!(in >> number) || !in.eof() || number < least || number > most))
      {
        throw Damaged(this->Path, "it has " + Quoted(word) + " as a sample");
      }
      to->SetComponent(
        (first + i) / components, static_cast<int>((first + i) % components), number);
    }
  }

  const std::string Path;
  const NrrdHeader& Header;
  const ReadingProgress& Progress;
  const std::vector<std::string> Files;
  std::uint64_t InFile = 0; // samples
  double Done = 0.0, Share = 1.0;
};

vtkSmartPointer<vtkDataArray> NewArray(const NrrdHeader& header, int components)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(header.Type));
  array->SetName("NRRD");
  array->SetNumberOfComponents(components);
  vtkIdType count = 1;
  for (const int n : header.Dimensions)
  {
    count *= n;
  }
  array->SetNumberOfTuples(count);
  return array;
}

void SwapBytes(vtkDataArray* array)
{
  const auto size = static_cast<std::size_t>(array->GetDataTypeSize());
  const auto count = static_cast<std::size_t>(array->GetNumberOfValues());
  vtkByteSwap::SwapVoidRange(array->GetVoidPointer(0), count, size);
}

bool IsMachineBigEndian()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

void Place(const NrrdHeader& header, vtkImageData* image)
{
  vtkNew<vtkMatrix3x3> direction;
  double spacing[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const vtkVector3d& step = header.Axes[static_cast<std::size_t>(axis)];
    spacing[axis] = step.Norm();
    for (int i = 0; i < 3; ++i)
    {
      direction->SetElement(i, axis, spacing[axis] > 0.0 ? step[i] / spacing[axis] : 0.0);
    }
  }
  image->SetDirectionMatrix(direction);
  image->SetSpacing(spacing);
  image->SetOrigin(header.Origin.GetData());
}

}

void ReadNrrd(
  const std::string& path, int timeStep, const ReadingProgress& progress, Volume& volume)
{
  const NrrdHeader header = ReadNrrdHeader(path);
  volume.TimeSteps = header.TimeSteps;
  volume.From = header.From;
  const int step = std::min(timeStep, header.TimeSteps) - 1; // others are refused afterwards
  const int together = header.AreInterleaved ? header.TimeSteps : header.Components;
  const double ofSample = vtkDataArray::GetDataTypeSize(header.Type);
  RequireBytesFor(path, header.Samples() * ofSample);
  vtkSmartPointer<vtkDataArray> samples = NewArray(header, together);
  Samples reader(path, header, progress);
  const auto ofStep = static_cast<std::uint64_t>(samples->GetNumberOfValues());
  reader.Read(header.AreInterleaved ? 0 : ofStep * static_cast<std::uint64_t>(step), samples);
  volume.Remark = reader.Remark;
  if (header.IsBigEndian != IsMachineBigEndian() && header.Encoding != NrrdHeader::Text)
  {
    SwapBytes(samples);
  }
  if (header.AreInterleaved)
  {
    const vtkSmartPointer<vtkDataArray> one = NewArray(header, 1);
    one->CopyComponent(0, samples, step);
    samples = one;
  }
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(header.Dimensions.data());
  image->GetPointData()->SetScalars(samples);
  Place(header, image);
  volume.Data = image;
}
