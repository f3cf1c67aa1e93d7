// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/KnotChunk.h"

#include "ViewFile/KnotNeighbors.h"

#include <array>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// The streams of a chunk, in their order.
enum StreamOfChunk : std::size_t
{
  Counts,
  Tokens,
  Progresses,
  Distances,
  Normals,
  NumberOfStreams
};
using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t HeaderBytes = 4 * NumberOfStreams;

/// Append a signed number: zigzag, then groups of seven bits.
void Append(std::int64_t number, Bytes& bytes)
{
  auto rest = (static_cast<std::uint64_t>(number) << 1) ^ static_cast<std::uint64_t>(number >> 63);
  constexpr std::uint64_t more = 0x80;
  for (; rest >= more; rest >>= 7)
  {
    bytes.push_back(static_cast<std::uint8_t>(rest | more));
  }
  bytes.push_back(static_cast<std::uint8_t>(rest));
}

/// Reads a stream. Behind its end, and of numbers that are too long, it reads 0 and notes it.
class StreamReader
{
public:
  StreamReader() = default;
  StreamReader(const std::uint8_t* begin, const std::uint8_t* end)
    : At(begin)
    , End(end)
  {
  }

  std::uint8_t Byte()
  {
    this->IsDamaged |= this->At == this->End;
    return this->IsDamaged ? std::uint8_t(0) : *this->At++;
  }

  std::int64_t Number()
  {
    std::uint64_t value = 0;
    constexpr int mostBits = 42;
    for (int bits = 0; bits < mostBits; bits += 7)
    {
      const std::uint8_t byte = this->Byte();
      value |= static_cast<std::uint64_t>(byte & 0x7fu) << bits;
      if (byte < 0x80u)
      {
        return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1u);
      }
    }
    this->IsDamaged = true;
    return 0;
  }

  bool IsGood() const { return !this->IsDamaged; }
  bool IsAtEnd() const { return this->At == this->End; }

private:
  const std::uint8_t *At = nullptr, *End = nullptr;
  bool IsDamaged = false;
};

std::uint8_t Difference(int value, int expected)
{
  return static_cast<std::uint8_t>(value - expected);
}

/// Encodes knots, pixel by pixel.
class Encoder
{
public:
  Encoder(const PixelKnots& knots, std::size_t width, std::size_t first, std::size_t end)
    : Knots(knots)
    , Width(width)
    , First(first)
  {
    const std::size_t count = knots.Begin[end] - knots.Begin[first];
    this->Streams[Tokens].reserve(count);
    this->Streams[Distances].reserve(count + count / 2);
    this->Streams[Normals].resize(4 * count);
  }

  void Add(std::size_t pixel)
  {
    const std::size_t begin = this->Knots.Begin[pixel], end = this->Knots.Begin[pixel + 1];
    const auto count = static_cast<std::int64_t>(end - begin);
    const bool isFirst = (pixel - this->First) % this->Width == 0;
    Append(count - (isFirst ? 0 : this->LastCount), this->Streams[Counts]);
    this->LastCount = count;
    if (count == 0)
    {
      return;
    }
    KnotNeighbors neighbors = this->NeighborsOf(pixel);
    for (std::size_t knot = begin; knot < end; ++knot)
    {
      this->AddKnot(knot, neighbors);
    }
  }

  Bytes Finish() const
  {
    Bytes bytes;
    for (const Bytes& stream : this->Streams)
    {
      for (int shift = 0; shift < 32; shift += 8)
      {
        bytes.push_back(static_cast<std::uint8_t>(stream.size() >> shift));
      }
    }
    for (const Bytes& stream : this->Streams)
    {
      bytes.insert(bytes.end(), stream.begin(), stream.end());
    }
    return bytes;
  }

private:
  /// Rows before the first one of the chunk have no say.
  KnotNeighbors NeighborsOf(std::size_t pixel) const
  {
    return { this->Knots, pixel, this->Width, this->First };
  }

  void AddKnot(std::size_t knot, KnotNeighbors& neighbors)
  {
    const int progress = this->Knots.Progress[knot];
    const KnotNeighbors::Token token = progress == neighbors.LastProgress() ? KnotNeighbors::Jump
      : progress == neighbors.NextOfLeft()                                  ? KnotNeighbors::AsLeft
      : progress == neighbors.NextOfBelow()                                 ? KnotNeighbors::AsBelow
                                                                            : KnotNeighbors::Told;
    this->Streams[Tokens].push_back(token);
    if (token == KnotNeighbors::Told)
    {
      Append(progress - neighbors.ProgressExpected(), this->Streams[Progresses]);
    }
    neighbors.GoTo(progress);
    const std::int64_t distance = this->Knots.Distance[knot];
    Append(distance - neighbors.DistanceExpected(), this->Streams[Distances]);
    const OctahedralNormal& normal = this->Knots.Normals[knot];
    const std::array<int, 2> expected = neighbors.NormalExpected(distance);
    const OctahedralNormal& middle = this->Knots.Middles[knot];
    const std::array<int, 2> between = neighbors.MiddleExpected(progress, normal);
    Bytes& normals = this->Streams[Normals];
    const std::size_t count = normals.size() / 4;
    for (std::size_t c = 0; c < 2; ++c)
    {
      normals[this->Done + c * count] = Difference(normal[c], expected[c]);
      normals[this->Done + (c + 2) * count] = Difference(middle[c], between[c]);
    }
    ++this->Done;
    neighbors.Take(progress, distance, normal);
  }

  const PixelKnots& Knots;
  std::size_t Width, First;
  std::array<Bytes, NumberOfStreams> Streams;
  std::int64_t LastCount = 0;
  std::size_t Done = 0;
};

/// Decodes what an Encoder made, or finds that it did not.
class Decoder
{
public:
  Decoder(const Bytes& bytes, std::size_t width, std::uint16_t largest, PixelKnots& knots)
    : Width(width)
    , Largest(largest)
    , Knots(knots)
  {
    std::size_t begin = HeaderBytes;
    for (std::size_t stream = 0; stream < NumberOfStreams && bytes.size() >= begin; ++stream)
    {
      std::size_t length = 0;
      for (std::size_t byte = 0; byte < 4; ++byte)
      {
        length |= static_cast<std::size_t>(bytes[4 * stream + byte]) << (8 * byte);
      }
      if (length > bytes.size() - begin)
      {
        return;
      }
      this->Streams[stream] = { bytes.data() + begin, bytes.data() + begin + length };
      this->Lengths[stream] = length;
      begin += length;
    }
    this->IsWhole = begin == bytes.size() && bytes.size() >= HeaderBytes;
  }

  std::string Decode(std::size_t pixels, std::size_t count)
  {
    if (!this->IsWhole || this->Lengths[Tokens] != count || this->Lengths[Normals] != 4 * count)
    {
      return "the lengths of its parts are wrong";
    }
    if (!this->ReadCounts(pixels, count))
    {
      return "it does not say how many knots pixels have";
    }
    this->Knots.Progress.resize(count);
    this->Knots.Distance.resize(count);
    this->Knots.Normals.resize(count);
    this->Knots.Middles.resize(count);
    for (std::vector<OctahedralNormal>* normals : { &this->Knots.Normals, &this->Knots.Middles })
    {
      for (std::size_t c = 0; c < 2; ++c)
      {
        for (OctahedralNormal& normal : *normals)
        {
          normal[c] = static_cast<std::int8_t>(this->Streams[Normals].Byte());
        }
      }
    }
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
    {
      if (!this->Knots.IsEmpty(pixel) && !this->ReadPixel(pixel))
      {
        return "a knot is impossible";
      }
    }
    const bool isUsed = this->Streams[Progresses].IsAtEnd() && this->Streams[Distances].IsAtEnd();
    return isUsed ? std::string() : "it holds more than its knots";
  }

private:
  bool ReadCounts(std::size_t pixels, std::size_t count)
  {
    this->Knots.Begin.assign(pixels + 1, 0);
    std::int64_t last = 0, sum = 0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
    {
      last = this->Streams[Counts].Number() + (pixel % this->Width == 0 ? 0 : last);
      sum += last;
      if (last < 0 || sum > static_cast<std::int64_t>(count))
      {
        return false;
      }
      this->Knots.Begin[pixel + 1] = static_cast<std::uint32_t>(sum);
    }
    return this->Streams[Counts].IsGood() && this->Streams[Counts].IsAtEnd() &&
      sum == static_cast<std::int64_t>(count);
  }

  bool ReadPixel(std::size_t pixel)
  {
    KnotNeighbors neighbors(this->Knots, pixel, this->Width, 0);
    bool isJump = false;
    for (std::size_t knot = this->Knots.Begin[pixel]; knot < this->Knots.Begin[pixel + 1]; ++knot)
    {
      const bool wasJump = isJump;
      const std::int64_t progress = this->ReadProgress(neighbors, isJump);
      if (progress < neighbors.LastProgress() + (isJump ? 0 : 1) || progress < 0 ||
        progress > this->Largest || (isJump && wasJump))
      {
        return false;
      }
      neighbors.GoTo(static_cast<int>(progress));
      const std::int64_t distance =
        neighbors.DistanceExpected() + this->Streams[Distances].Number();
      if (distance < 0 || distance > std::numeric_limits<std::int32_t>::max() ||
        !this->Streams[Distances].IsGood())
      {
        return false;
      }
      this->Keep(knot, static_cast<int>(progress), distance, neighbors);
    }
    return true;
  }

  std::int64_t ReadProgress(KnotNeighbors& neighbors, bool& isJump)
  {
    const std::uint8_t token = this->Streams[Tokens].Byte();
    isJump = token == KnotNeighbors::Jump;
    switch (token)
    {
      case KnotNeighbors::AsLeft:
        return neighbors.NextOfLeft();
      case KnotNeighbors::AsBelow:
        return neighbors.NextOfBelow();
      case KnotNeighbors::Jump:
        return neighbors.LastProgress();
      case KnotNeighbors::Told:
      {
        const std::int64_t progress =
          neighbors.ProgressExpected() + this->Streams[Progresses].Number();
        return this->Streams[Progresses].IsGood() ? progress : -1;
      }
      default:
        return -1;
    }
  }

  /// Its normals hold the differences from what is expected.
  void Keep(std::size_t knot, int progress, std::int64_t distance, KnotNeighbors& neighbors)
  {
    OctahedralNormal& normal = this->Knots.Normals[knot];
    AddTo(normal, neighbors.NormalExpected(distance));
    AddTo(this->Knots.Middles[knot], neighbors.MiddleExpected(progress, normal));
    this->Knots.Progress[knot] = static_cast<std::uint16_t>(progress);
    this->Knots.Distance[knot] = static_cast<std::uint32_t>(distance);
    neighbors.Take(progress, distance, normal);
  }

  static void AddTo(OctahedralNormal& difference, const std::array<int, 2>& expected)
  {
    for (std::size_t c = 0; c < difference.size(); ++c)
    {
      difference[c] =
        static_cast<std::int8_t>(static_cast<std::uint8_t>(expected[c] + difference[c]));
    }
  }

  std::size_t Width;
  std::uint16_t Largest;
  PixelKnots& Knots;
  std::array<StreamReader, NumberOfStreams> Streams;
  std::array<std::size_t, NumberOfStreams> Lengths{};
  bool IsWhole = false;
};

}

Bytes EncodeKnots(const PixelKnots& knots, int width, const RowRange& rows)
{
  const auto columns = static_cast<std::size_t>(width);
  const std::size_t first = static_cast<std::size_t>(rows.First) * columns;
  const std::size_t end = first + static_cast<std::size_t>(rows.Count) * columns;
  Encoder encoder(knots, columns, first, end);
  for (std::size_t pixel = first; pixel < end; ++pixel)
  {
    encoder.Add(pixel);
  }
  return encoder.Finish();
}

std::string DecodeKnots(const Bytes& bytes, int width, int rows, std::size_t count,
  std::uint16_t largest, PixelKnots& knots)
{
  const auto columns = static_cast<std::size_t>(width);
  Decoder decoder(bytes, columns, largest, knots);
  return decoder.Decode(columns * static_cast<std::size_t>(rows), count);
}

}
