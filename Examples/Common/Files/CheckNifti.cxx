// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FileCheck.h"

#include <vtk_zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <memory>

namespace
{

// Bytes of a value, of all components together: "datatype" of the header.
const std::map<int, double> BytesOfType = { { 2, 1.0 }, { 4, 2.0 }, { 8, 4.0 }, { 16, 4.0 },
  { 32, 8.0 }, { 64, 8.0 }, { 128, 3.0 }, { 256, 1.0 }, { 512, 2.0 }, { 768, 4.0 }, { 1024, 8.0 },
  { 1280, 8.0 }, { 1792, 16.0 }, { 2304, 4.0 } };

// Where the second version of the format has what.
struct Layout
{
  int Size;          // of the header
  std::size_t Type;  // 16 bits
  std::size_t Dims;  // eight numbers
  std::size_t Bits;  // of each of them
  std::size_t Begin; // of the samples: a float, or 64 bits
};
constexpr Layout First = { 348, 70, 40, 16, 108 };
constexpr Layout Second = { 540, 12, 16, 64, 168 };

class Header
{
public:
  // Of a compressed file, too.
  explicit Header(const std::string& path)
  {
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
    this->Size =
      file ? gzread(file.get(), this->Bytes.data(), static_cast<unsigned>(Second.Size)) : 0;
    this->IsDirect = !file || gzdirect(file.get()) != 0;
  }

  template <typename T>
  T At(std::size_t place) const
  {
    std::array<unsigned char, sizeof(T)> bytes;
    for (std::size_t i = 0; i < sizeof(T); ++i)
    {
      bytes[this->IsSwapped ? sizeof(T) - 1 - i : i] = this->Bytes[place + i];
    }
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  int Size = 0;
  bool IsDirect = true; // nothing is compressed
  bool IsSwapped = false;

private:
  std::array<unsigned char, 540> Bytes{};
};

}

void CheckNifti(const std::string& path)
{
  const auto size = static_cast<double>(SizeOf(path));
  Header header(path);
  const Layout* layout = nullptr;
  for (const bool isSwapped : { false, true })
  {
    header.IsSwapped = isSwapped;
    const int said = header.At<std::int32_t>(0);
    layout = said == First.Size ? &First : said == Second.Size ? &Second : nullptr;
    if (layout)
    {
      break;
    }
  }
  if (!layout || header.Size < layout->Size)
  {
    throw Damaged(path, "it does not begin with a header of NIfTI");
  }
  const int said = header.At<std::int16_t>(layout->Type);
  const auto type = BytesOfType.find(said);
  if (type == BytesOfType.end())
  {
    throw Damaged(
      path, "its samples are of type " + std::to_string(said) + ", which is not read here");
  }
  const auto dim = [&](std::size_t i)
  {
    const std::size_t place = layout->Dims + i * layout->Bits / 8;
    return layout->Bits == 16 ? static_cast<double>(header.At<std::int16_t>(place))
                              : static_cast<double>(header.At<std::int64_t>(place));
  };
  // VTK tells the order of bytes by the number of axes.
  const double axes = dim(0);
  double samples = axes >= 1.0 && axes <= 7.0 ? 1.0 : -1.0;
  for (std::size_t i = 1; i <= 7 && static_cast<double>(i) <= axes; ++i)
  {
    // Of several times the first is read.
    samples = dim(i) >= 1.0 && dim(i) <= 2147483647.0 ? samples * (i == 4 ? 1.0 : dim(i)) : -1.0;
    if (samples < 0.0)
    {
      break;
    }
  }
  if (samples < 0.0)
  {
    throw Damaged(path, "its header tells of axes without samples");
  }
  const double begin = layout->Bits == 16
    ? static_cast<double>(header.At<float>(layout->Begin))
    : static_cast<double>(header.At<std::int64_t>(layout->Begin));
  const double inflation = header.IsDirect ? 1.0 : MostByDeflation;
  if (!(begin >= 0.0 && begin <= size * inflation))
  {
    throw Damaged(path, "its header tells that the samples begin where the file has ended");
  }
  RequireSamples(path, samples, type->second,
    header.IsDirect ? std::max(size - std::max(begin, 0.0), 0.0) : size, inflation);
}
