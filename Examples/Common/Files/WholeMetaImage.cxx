// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/WholeCheck.h"

#include "Files/FileCheck.h"
#include "Files/Reading.h"
#include "Program/Quoted.h"

#include <vtkDataArray.h>
#include <vtkMetaImageReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace
{

namespace fs = std::filesystem;
using Fields = std::map<std::string, std::string>;

// As MetaIO reads it; false where there is none.
bool IsTrue(Fields& fields, const char* key)
{
  return fields[key].find_first_of("Tt1") == 0;
}

double EndOfHeader(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file >> std::ws, line) && line.compare(0, 15, "ElementDataFile") != 0)
  {
  }
  const std::streamoff end = file.tellg(); // -1 where no line follows
  return end < 0 ? static_cast<double>(SizeOf(path)) : static_cast<double>(end);
}

// How many files of slices a header lists, or tells of by a pattern; infinite where it tells no
// end, or where a file has several slices.
double SlicesOf(const std::string& path, const std::string& words)
{
  std::istringstream in(words);
  std::string pattern;
  double first = 0.0, last = 0.0, step = 1.0;
  const bool hasLast = static_cast<bool>(in >> pattern >> first >> last);
  in >> step;
  if (pattern != "LIST" || first > 2.0)
  {
    return hasLast ? std::floor((last - first) / std::max(std::floor(step), 1.0)) + 1.0 : HUGE_VAL;
  }
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(EndOfHeader(path)));
  double count = 0.0;
  for (std::string line; std::getline(file, line) && !file.eof();) // as MetaIO counts them
  {
    count += line.empty() ? 0.0 : 1.0;
  }
  return count;
}

// Where MetaIO finds the samples.
std::string FileOfSamples(const std::string& path, const std::string& name)
{
  const std::string file = (fs::path(path).parent_path() / name).string();
  std::error_code error;
  for (const char* suffix : { "", ".gz", ".Z" })
  {
    if (fs::is_regular_file(file + suffix, error))
    {
      return file + suffix;
    }
  }
  throw Damaged(path, "it names " + Quoted(file) + ", which is not there");
}

// How many numbers a text has.
double NumbersIn(const std::string& text, double begin)
{
  using Number = std::istream_iterator<double>;
  std::ifstream file(text, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(begin));
  return static_cast<double>(std::distance(Number(file), Number()));
}

}

std::string RequireWholeMetaImage(vtkMetaImageReader* reader, Fields fields)
{
  const std::string path = reader->GetFileName(), name = fields["ElementDataFile"];
  const int* extent = reader->GetDataExtent();
  const double slices = extent[5] - extent[4] + 1.0,
               channels = reader->GetNumberOfScalarComponents();
  if (name.compare(0, 4, "LIST") == 0 || name.find('%') != std::string::npos)
  {
    if (SlicesOf(path, name) < slices)
    {
      throw Damaged(path, "it names fewer slices than its DimSize tells of");
    }
    return ""; // MetaIO tells of those that are missing or short
  }
  const bool isLocal = LowerCase(name) == "local";
  const std::string file = isLocal ? path : FileOfSamples(path, name);
  const bool isZipped = !isLocal && !EndsWith(file, name);
  const bool isText = !isZipped && !fields["BinaryData"].empty() && !IsTrue(fields, "BinaryData");
  const bool isCompressed = isZipped || (!isText && IsTrue(fields, "CompressedData"));
  const double ofNumber = vtkDataArray::GetDataTypeSize(reader->GetDataScalarType());
  const double bytes =
    (extent[1] - extent[0] + 1.0) * (extent[3] - extent[2] + 1.0) * slices * channels * ofNumber;
  RequireBytesFor(path, bytes);
  const auto headerSize = static_cast<int>(reader->GetHeaderSize()); // -1: samples are the last
  const double first = isLocal ? EndOfHeader(path) : 0.0; // of the places where samples may begin
  const double begin = headerSize > 0 ? headerSize : first;
  const double more =
    (isText ? NumbersIn(file, begin) * ofNumber : static_cast<double>(SizeOf(file)) - begin) -
    bytes;
  if (bytes <= 0.0 || begin < first || (!isCompressed && more < 0.0))
  {
    throw Damaged(path, Quoted(file) + " has fewer samples than the header tells of");
  }
  if (isText && channels > 1.0)
  {
    throw Damaged(path, "VTK does not read several channels as text");
  }
  std::ostringstream remark;
  if (isCompressed && std::atof(fields["CompressedDataSize"].c_str()) == 0.0)
  {
    remark << Quoted(path)
           << " has no CompressedDataSize, by which one would see whether it is whole; add that.";
  }
  else if (!isCompressed && !isText && headerSize >= 0 && more > 0.0)
  {
    remark << Quoted(file) << " has " << more
           << " bytes more than its header tells of, which are not drawn; check DimSize and "
              "ElementType.";
  }
  return remark.str();
}
