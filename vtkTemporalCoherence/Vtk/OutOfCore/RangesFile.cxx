// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/RangesFile.h"

#include "Acceleration/NodeRanges.h"
#include "Acceleration/RangeScan.h"
#include "OutOfCore/FileRoom.h"
#include "OutOfCore/SampleHash.h"
#include "Scene/CellBlocks.h"
#include "VolumeFiles/RandomAccessFile.h"

#include <cstring>
#include <sstream>
#include <utility>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Bytes of text at the beginning of the file.
constexpr std::size_t HeadSize = 4096;

constexpr const char* Begin = "vtkTemporalCoherence value ranges 2 ";

constexpr std::uint32_t Order = 0x01020304u; ///< tells the byte order of the machine

std::size_t NodesOf(const glm::ivec3& dimensions)
{
  return static_cast<std::size_t>(CountOf(CellBlocks::NodesFor(dimensions)));
}

/// What the text at the beginning says.
struct FileHead
{
  std::uint64_t Volume = 0; ///< hash
  std::uint32_t ByteOrder = 0;
  int Type = -1;
  glm::ivec3 Dimensions{ 0 };
  glm::dvec2 Finite{ 0.0 }, Whole{ 0.0 };
  bool HasFinite = false, HasNaN = false;
  std::uint64_t Rest = 0; ///< hash of the ranges of nodes and of what follows them

  std::uint64_t OwnHash() const
  {
    std::ostringstream text;
    this->Write(text);
    const std::string all = text.str();
    return HashOf(all.data(), all.size());
  }

  void Write(std::ostream& text) const
  {
    const auto bits = [](double value)
    {
      std::uint64_t word = 0;
      std::memcpy(&word, &value, sizeof(word));
      return word;
    };
    text << this->Volume << ' ' << this->ByteOrder << ' ' << this->Type << ' ' << this->Dimensions.x
         << ' ' << this->Dimensions.y << ' ' << this->Dimensions.z << ' ' << bits(this->Finite.x)
         << ' ' << bits(this->Finite.y) << ' ' << bits(this->Whole.x) << ' ' << bits(this->Whole.y)
         << ' ' << this->HasFinite << ' ' << this->HasNaN << ' ' << this->Rest << ' ';
  }

  bool Read(std::istream& text)
  {
    std::uint64_t bits[4] = {}, hash = 0;
    text >> this->Volume >> this->ByteOrder >> this->Type >> this->Dimensions.x >>
      this->Dimensions.y >> this->Dimensions.z >> bits[0] >> bits[1] >> bits[2] >> bits[3] >>
      this->HasFinite >> this->HasNaN >> this->Rest >> hash;
    std::memcpy(&this->Finite, bits, sizeof(this->Finite));
    std::memcpy(&this->Whole, bits + 2, sizeof(this->Whole));
    return !text.fail() && hash == this->OwnHash();
  }
};

}

RangesFile::RangesFile(
  std::vector<std::string> paths, std::uint64_t hash, ScalarType type, const glm::ivec3& dimensions)
  : Paths(std::move(paths))
  , Hash(hash)
  , Type(type)
  , Dimensions(dimensions)
{
}

std::size_t RangesFile::Bytes() const
{
  return RangeScan::BytesFor(this->Type, this->Dimensions);
}

/// Hash of the ranges of nodes, and of the words that follow them.
std::uint64_t RangesFile::HashOfRest(
  const std::byte* ranges, const std::vector<std::uint64_t>& withNaN) const
{
  const std::size_t ofNodes = 2 * SizeOf(this->Type) * NodesOf(this->Dimensions);
  const std::uint64_t hash = HashOf(ranges + this->Bytes() - ofNodes, ofNodes);
  return HashOf(withNaN.data(), withNaN.size() * sizeof(std::uint64_t), hash);
}

std::shared_ptr<const KnownRanges> RangesFile::Load(std::shared_ptr<const MappedFile>& mapped) const
{
  for (const std::string& path : this->Paths)
  {
    if (auto known = this->LoadFrom(path, mapped))
    {
      return known;
    }
  }
  return nullptr;
}

std::shared_ptr<const KnownRanges> RangesFile::LoadFrom(
  const std::string& path, std::shared_ptr<const MappedFile>& mapped) const
{
  std::string ignored;
  const auto opened = RandomAccessFile::Open(path, ignored);
  if (!opened || opened->Size() < HeadSize + this->Bytes())
  {
    return nullptr;
  }
  const std::uint64_t size = opened->Size();
  const std::shared_ptr<const MappedFile> file = MappedFile::Map(*opened, size);
  if (!file)
  {
    return nullptr;
  }
  const auto* const text = reinterpret_cast<const char*>(file->Data());
  const std::size_t length = std::strlen(Begin);
  if (std::strncmp(text, Begin, length) != 0)
  {
    return nullptr;
  }
  std::istringstream stream(std::string(text + length, HeadSize - length));
  FileHead head;
  if (!head.Read(stream) || head.Volume != this->Hash || head.ByteOrder != Order ||
    head.Type != static_cast<int>(this->Type) || head.Dimensions != this->Dimensions)
  {
    return nullptr;
  }
  const std::size_t words = head.HasNaN ? NodesOf(this->Dimensions) : 0;
  if (size != HeadSize + this->Bytes() + words * sizeof(std::uint64_t))
  {
    return nullptr;
  }
  KnownRanges known;
  known.Bytes = { file, file->Data() + HeadSize };
  known.Finite = head.Finite;
  known.Whole = head.Whole;
  known.HasFinite = head.HasFinite;
  known.LeavesWithNaN.resize(words);
  if (words != 0)
  {
    std::memcpy(known.LeavesWithNaN.data(), file->Data() + HeadSize + this->Bytes(),
      words * sizeof(std::uint64_t));
  }
  if (this->HashOfRest(known.Bytes.get(), known.LeavesWithNaN) != head.Rest)
  {
    return nullptr;
  }
  mapped = file;
  return std::make_shared<const KnownRanges>(std::move(known));
}

std::shared_ptr<std::byte> RangesFile::MakeRoom()
{
  for (auto path = this->Paths.begin(); path != this->Paths.end() && !this->Made; ++path)
  {
    this->Made = FileRoom::Create(*path, HeadSize + this->Bytes());
  }
  if (this->Made)
  {
    return { this->Made, this->Made->Data() + HeadSize };
  }
  return { new std::byte[this->Bytes()], std::default_delete<std::byte[]>() };
}

bool RangesFile::Finish(const KnownRanges& ranges)
{
  if (!this->Made)
  {
    return false;
  }
  FileHead head;
  head.Volume = this->Hash;
  head.ByteOrder = Order;
  head.Type = static_cast<int>(this->Type);
  head.Dimensions = this->Dimensions;
  head.Finite = ranges.Finite;
  head.Whole = ranges.Whole;
  head.HasFinite = ranges.HasFinite;
  head.HasNaN = !ranges.LeavesWithNaN.empty();
  head.Rest = this->HashOfRest(ranges.Bytes.get(), ranges.LeavesWithNaN);
  std::ostringstream text;
  text << Begin;
  head.Write(text);
  text << head.OwnHash() << '\n';
  const std::string all = text.str();
  std::memset(this->Made->Data(), ' ', HeadSize);
  std::memcpy(this->Made->Data(), all.data(), all.size());
  return this->Made->Append(
           ranges.LeavesWithNaN.data(), ranges.LeavesWithNaN.size() * sizeof(std::uint64_t)) &&
    this->Made->Keep();
}

}
