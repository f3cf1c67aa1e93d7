// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The fuzzer of view files that is guided by coverage: libFuzzer makes the bytes. They are read as
// a file; as one whose checksum of the header is right; and as a chunk.

#include "FileParts.h"
#include "ViewFile/ViewFile.h"
#include "ViewFile/ViewLookUp.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <limits>

namespace
{

using namespace TemporalCoherence;

void Read(const std::vector<std::uint8_t>& file)
{
  constexpr int mostPixels = 1 << 14;
  LoadedViews views;
  if (!ReadViews(file, views).empty())
  {
    return;
  }
  Frame frame;
  for (std::size_t view = 0; view < views.Knots.size(); ++view)
  {
    const KnotImage& knots = views.Knots[view];
    for (const double isovalue :
      { knots.Values.Low, knots.Values.High, std::numeric_limits<double>::quiet_NaN() })
    {
      if (knots.Size.x * knots.Size.y <= mostPixels)
      {
        LookUpView(views.Header.Views[view].Geometry, knots, isovalue, frame);
      }
    }
  }
}

}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  vtkSMPTools::SetBackend("Sequential");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::vector<std::uint8_t> bytes(data, data + size);
  Read(bytes);
  constexpr std::size_t placeOfLength = FileParts::PlaceOfLength;
  if (size > FileParts::BytesBeforeHeader)
  {
    // Headers of fuzzed files are short: two bytes tell their length.
    const std::size_t asked = bytes[placeOfLength] + 256u * bytes[placeOfLength + 1];
    std::vector<std::uint8_t> file = bytes;
    const std::size_t length = std::min(asked, size - FileParts::BytesBeforeHeader);
    file[placeOfLength] = static_cast<std::uint8_t>(length);
    file[placeOfLength + 1] = static_cast<std::uint8_t>(length >> 8);
    file[placeOfLength + 2] = file[placeOfLength + 3] = 0;
    Read(FileParts(file).Join());
  }
  if (size > 2)
  {
    constexpr int width = 6, rows = 4;
    PixelKnots knots;
    DecodeKnots({ bytes.begin() + 2, bytes.end() }, width, rows, bytes[0],
      static_cast<std::uint16_t>(16 * bytes[1] + 1), knots);
  }
  return 0;
}
