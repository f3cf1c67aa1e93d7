// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/ViewFile.h"

#include "Scene/Parallel.h"
#include "ViewFile/ZlibBytes.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>

namespace TemporalCoherence
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

constexpr std::array<std::uint8_t, 8> Magic = { 'T', 'C', 'V', 'I', 'E', 'W', '\r', '\n' };
constexpr std::size_t BytesBeforeHeader = 24;
constexpr int RowsOfChunk = 32;

void AppendNumber(std::uint32_t number, Bytes& bytes)
{
  for (int shift = 0; shift < 32; shift += 8)
  {
    bytes.push_back(static_cast<std::uint8_t>(number >> shift));
  }
}

std::uint32_t NumberAt(const Bytes& bytes, std::size_t at)
{
  std::uint32_t number = 0;
  for (std::size_t byte = 0; byte < 4; ++byte)
  {
    number |= static_cast<std::uint32_t>(bytes[at + byte]) << (8 * byte);
  }
  return number;
}

/// Entries as differences from the pixel to the left: low bytes of all, then high bytes.
Bytes EncodeEntries(const std::vector<std::uint16_t>& entries, std::size_t width)
{
  Bytes bytes(2 * entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const int left = i % width == 0 ? 0 : entries[i - 1];
    const auto difference = static_cast<std::uint16_t>(entries[i] - left);
    bytes[i] = static_cast<std::uint8_t>(difference);
    bytes[i + entries.size()] = static_cast<std::uint8_t>(difference >> 8);
  }
  return bytes;
}

std::vector<std::uint16_t> DecodeEntries(const Bytes& bytes, std::size_t width)
{
  std::vector<std::uint16_t> entries(bytes.size() / 2);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const int left = i % width == 0 ? 0 : entries[i - 1];
    entries[i] = static_cast<std::uint16_t>(left + bytes[i] + (bytes[i + entries.size()] << 8));
  }
  return entries;
}

/// One bit for each pixel.
Bytes EncodeFlags(const std::vector<std::uint8_t>& flags)
{
  Bytes bytes((flags.size() + 7) / 8);
  for (std::size_t i = 0; i < flags.size(); ++i)
  {
    bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] | (flags[i] != 0 ? 1u << (i % 8) : 0u));
  }
  return bytes;
}

std::vector<std::uint8_t> DecodeFlags(const Bytes& bytes, std::size_t pixels)
{
  std::vector<std::uint8_t> flags(pixels);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    flags[i] = static_cast<std::uint8_t>(bytes[i / 8] >> (i % 8) & 1u);
  }
  return flags;
}

/// Reads the sections of a file.
class SectionReader
{
public:
  SectionReader(const Bytes& file, std::size_t begin)
    : File(file)
    , Begin(begin)
  {
  }

  bool Unpack(const FileSection& section, Bytes& unpacked) const
  {
    return Inflate(this->File.data() + this->Begin + section.Offset,
      static_cast<std::size_t>(section.Bytes), static_cast<std::size_t>(section.Unpacked),
      unpacked);
  }

  /// \return what is wrong
  std::string ReadChunk(const ViewEntry& view, const ChunkSection& chunk, PixelKnots& knots) const
  {
    Bytes unpacked;
    if (!this->Unpack(chunk, unpacked))
    {
      return "its checksum is wrong";
    }
    return DecodeKnots(unpacked, view.Geometry.Rays.Size.x, chunk.Rows.Count,
      static_cast<std::size_t>(chunk.Knots), view.Grid.LargestProgress, knots);
  }

private:
  const Bytes& File;
  std::size_t Begin;
};

/// Puts the chunks of one direction together, in the order of rows.
void Join(const ViewEntry& view, ValueDirection direction, std::vector<PixelKnots>& chunks,
  PixelKnots& knots)
{
  const auto width = static_cast<std::size_t>(view.Geometry.Rays.Size.x);
  const auto pixels = width * static_cast<std::size_t>(view.Geometry.Rays.Size.y);
  const auto count = static_cast<std::size_t>(view.Knots[static_cast<std::size_t>(direction)]);
  knots.Begin.reserve(pixels + 1);
  knots.Begin.assign(1, 0);
  knots.Progress.reserve(count);
  knots.Distance.reserve(count);
  knots.Normals.reserve(count);
  knots.Middles.reserve(count);
  for (std::size_t i = 0; i < chunks.size(); ++i)
  {
    const ChunkSection& section = view.Chunks[i];
    if (section.Direction != direction)
    {
      continue;
    }
    PixelKnots& chunk = chunks[i];
    knots.Begin.resize(
      static_cast<std::size_t>(section.Rows.First) * width + 1, knots.Begin.back());
    const std::uint32_t before = knots.Begin.back();
    std::transform(chunk.Begin.begin() + 1, chunk.Begin.end(), std::back_inserter(knots.Begin),
      [before](std::uint32_t begin) { return before + begin; });
    knots.Progress.insert(knots.Progress.end(), chunk.Progress.begin(), chunk.Progress.end());
    knots.Distance.insert(knots.Distance.end(), chunk.Distance.begin(), chunk.Distance.end());
    knots.Normals.insert(knots.Normals.end(), chunk.Normals.begin(), chunk.Normals.end());
    knots.Middles.insert(knots.Middles.end(), chunk.Middles.begin(), chunk.Middles.end());
    chunk = PixelKnots();
  }
  knots.Begin.resize(pixels + 1, knots.Begin.back());
}

std::string ReadView(const SectionReader& sections, const ViewEntry& view, KnotImage& image)
{
  image.Size = view.Geometry.Rays.Size;
  image.Values = view.Range;
  image.Grid = view.Grid;
  image.NormalSteps = view.NormalSteps;
  std::vector<PixelKnots> chunks(view.Chunks.size());
  std::string wrong;
  std::mutex guard;
  std::atomic<bool> hasNoMemory{ false };
  ParallelFor(static_cast<std::int64_t>(chunks.size()), 1,
    [&](std::int64_t i)
    {
      try
      {
        const auto chunk = static_cast<std::size_t>(i);
        const std::string found = sections.ReadChunk(view, view.Chunks[chunk], chunks[chunk]);
        if (!found.empty())
        {
          const std::lock_guard<std::mutex> lock(guard);
          wrong = "Chunk " + std::to_string(i) + " is damaged: " + found + ".";
        }
      }
      catch (const std::bad_alloc&)
      {
        hasNoMemory = true;
      }
    });
  if (hasNoMemory)
  {
    throw std::bad_alloc();
  }
  if (!wrong.empty())
  {
    return wrong;
  }
  for (const ValueDirection direction : { ValueDirection::Rising, ValueDirection::Falling })
  {
    Join(view, direction, chunks, image.Knots[static_cast<std::size_t>(direction)]);
  }
  const auto width = static_cast<std::size_t>(image.Size.x);
  const std::size_t pixels = width * static_cast<std::size_t>(image.Size.y);
  Bytes unpacked;
  if (view.Entries)
  {
    if (!sections.Unpack(*view.Entries, unpacked))
    {
      return "The values where rays begin are damaged: the checksum is wrong.";
    }
    image.Entries = DecodeEntries(unpacked, width);
  }
  if (view.Unknown)
  {
    if (!sections.Unpack(*view.Unknown, unpacked))
    {
      return "The list of unknown pixels is damaged: the checksum is wrong.";
    }
    image.Unknown = DecodeFlags(unpacked, pixels);
  }
  return {};
}

}

FileSection ViewFileMaker::Append(const Bytes& packed, std::size_t unpacked)
{
  const FileSection section{ this->Sections.size(), packed.size(), unpacked };
  this->Sections.insert(this->Sections.end(), packed.begin(), packed.end());
  return section;
}

std::string ViewFileMaker::WhyNot()
{
  return {};
}

void ViewFileMaker::CutIntoChunks(const KnotImage& knots, ViewEntry& view)
{
  const auto width = static_cast<std::size_t>(knots.Size.x);
  for (const ValueDirection direction : { ValueDirection::Rising, ValueDirection::Falling })
  {
    const PixelKnots& all = knots.Knots[static_cast<std::size_t>(direction)];
    view.Knots[static_cast<std::size_t>(direction)] = all.Begin.back();
    for (int first = 0; first < knots.Size.y; first += RowsOfChunk)
    {
      const int count = std::min(RowsOfChunk, knots.Size.y - first);
      const std::size_t pixel = static_cast<std::size_t>(first) * width;
      ChunkSection chunk;
      chunk.Direction = direction;
      chunk.Rows = { first, count };
      chunk.Knots = all.Begin[pixel + static_cast<std::size_t>(count) * width] - all.Begin[pixel];
      if (chunk.Knots > 0)
      {
        view.Chunks.push_back(chunk);
      }
    }
  }
}

void ViewFileMaker::Add(const ViewGeometry& geometry, const KnotImage& knots)
{
  ViewEntry view;
  view.Geometry = geometry;
  view.Range = knots.Values;
  view.Grid = knots.Grid;
  view.NormalSteps = knots.NormalSteps;
  this->CutIntoChunks(knots, view);
  std::vector<Bytes> packed(view.Chunks.size());
  std::atomic<bool> hasNoMemory{ false };
  ParallelFor(static_cast<std::int64_t>(packed.size()), 1,
    [&](std::int64_t i)
    {
      ChunkSection& chunk = view.Chunks[static_cast<std::size_t>(i)];
      try
      {
        const Bytes bytes = EncodeKnots(
          knots.Knots[static_cast<std::size_t>(chunk.Direction)], knots.Size.x, chunk.Rows);
        chunk.Unpacked = bytes.size();
        packed[static_cast<std::size_t>(i)] = Deflate(bytes);
      }
      catch (const std::bad_alloc&)
      {
        hasNoMemory = true;
      }
    });
  if (hasNoMemory)
  {
    throw std::bad_alloc();
  }
  for (std::size_t i = 0; i < packed.size(); ++i)
  {
    static_cast<FileSection&>(view.Chunks[i]) =
      this->Append(packed[i], static_cast<std::size_t>(view.Chunks[i].Unpacked));
  }
  const auto addSection = [&](const Bytes& bytes)
  { return this->Append(Deflate(bytes), bytes.size()); };
  if (!knots.Entries.empty())
  {
    view.Entries = addSection(EncodeEntries(knots.Entries, static_cast<std::size_t>(knots.Size.x)));
  }
  if (!knots.Unknown.empty())
  {
    view.Unknown = addSection(EncodeFlags(knots.Unknown));
  }
  this->Header.Views.push_back(std::move(view));
}

Bytes ViewFileMaker::Finish(const ViewDescription& description)
{
  this->Header.Description = description;
  const std::string text = TextOf(this->Header);
  Bytes file(Magic.begin(), Magic.end());
  file.reserve(BytesBeforeHeader + text.size() + this->Sections.size());
  AppendNumber(ViewFileVersion, file);
  AppendNumber(static_cast<std::uint32_t>(text.size()), file);
  AppendNumber(Checksum(text), file);
  AppendNumber(0, file);
  file.insert(file.end(), text.begin(), text.end());
  file.insert(file.end(), this->Sections.begin(), this->Sections.end());
  return file;
}

std::string ReadViews(const Bytes& file, LoadedViews& views)
{
  if (file.size() < BytesBeforeHeader || !std::equal(Magic.begin(), Magic.end(), file.begin()))
  {
    return "This is no view file: it does not begin with TCVIEW.";
  }
  const std::uint32_t version = NumberAt(file, 8);
  if (version != ViewFileVersion)
  {
    return "This view file has version " + std::to_string(version) + "; only version " +
      std::to_string(ViewFileVersion) + " can be read.";
  }
  const std::size_t length = NumberAt(file, 12), begin = BytesBeforeHeader + length;
  if (length > file.size() - BytesBeforeHeader)
  {
    return "The view file is cut off in its header.";
  }
  views.HeaderText.assign(
    file.begin() + BytesBeforeHeader, file.begin() + static_cast<std::ptrdiff_t>(begin));
  if (Checksum(views.HeaderText) != NumberAt(file, 16))
  {
    return "The header of the view file is damaged: its checksum is wrong.";
  }
  const std::string wrong = ReadHeader(views.HeaderText, file.size() - begin, views.Header);
  if (!wrong.empty())
  {
    return "The header of the view file is wrong: " + wrong + ".";
  }
  const SectionReader sections(file, begin);
  views.Knots.resize(views.Header.Views.size());
  for (std::size_t view = 0; view < views.Knots.size(); ++view)
  {
    const std::string found = ReadView(sections, views.Header.Views[view], views.Knots[view]);
    if (!found.empty())
    {
      return found;
    }
  }
  return {};
}

}
