// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/SmoothLabels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include <hwy/base.h>

namespace TemporalCoherence
{
namespace
{

constexpr int Edge = SmoothLabels::Edge;

/// The standard deviation for shares, as a part of that for normals. More makes surfaces of small
/// balls uneven, as samples keep their labels.
constexpr double ShareOfRadius = 0.3;

/// Half the width of a Gaussian, in standard deviations.
constexpr double HalfWidth = 2.8;

/// A share of a sample's own label is at least 1/2 plus this, of others at most 1/2 minus this.
constexpr float Margin = 1.0f / 64.0f;

/// The margin of samples whose own label has a share of less than 1/2, as in thin parts. It keeps
/// these about half as thick as voxels.
constexpr float MarginOfThin = 3.0f / 16.0f;

/// A Gaussian at whole numbers, as whole numbers whose sum is Unit. So sums over a cube of samples
/// are exact, in any order.
constexpr int Unit = 256;
constexpr float CubeOfUnit = static_cast<float>(Unit) * Unit * Unit;
std::vector<float> GaussianOf(double deviation)
{
  const int half = std::max(1, static_cast<int>(std::ceil(HalfWidth * deviation)));
  std::vector<double> weights;
  double sum = 0.0;
  for (int i = -half; i <= half; ++i)
  {
    weights.push_back(std::exp(-0.5 * i * i / (deviation * deviation)));
    sum += weights.back();
  }
  std::vector<float> whole;
  float rest = static_cast<float>(Unit);
  for (const double weight : weights)
  {
    whole.push_back(static_cast<float>(std::round(Unit * weight / sum)));
    rest -= whole.back();
  }
  whole[static_cast<std::size_t>(half)] += rest;
  return whole;
}

/// Where samples of a cube have a label: a bit for each sample, rows along x.
class LabelCube
{
public:
  static constexpr std::size_t MostSamples = 64; ///< along an edge

  template <typename T>
  LabelCube(const TypedField<T>& field, std::int64_t label, const glm::ivec3& first, int edge)
    : Size(edge)
    , Rows(static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge))
  {
    const glm::ivec3 last = field.Dimensions - 1;
    RowReader<T> reader(field, first.x, edge);
    const std::uint64_t all = ~std::uint64_t(0) >> (MostSamples - static_cast<std::size_t>(edge));
    std::optional<T> other;
    for (int k = 0; k < edge; ++k)
    {
      for (int j = 0; j < edge; ++j)
      {
        // Beyond the field, the outermost samples go on.
        reader.Row =
          field.At(0, std::clamp(first.y + j, 0, last.y), std::clamp(first.z + k, 0, last.z));
        const std::uint64_t bits = reader.Find(static_cast<T>(label));
        this->Rows[static_cast<std::size_t>(j + edge * k)] = bits;
        if (this->HasOneOther && bits != all)
        {
          other = other ? other : reader.At(hwy::Num0BitsBelowLS1Bit_Nonzero64(~bits));
          this->HasOneOther = (bits | reader.Find(*other)) == all;
        }
      }
    }
    this->HasOneOther = this->HasOneOther && other;
    this->Other = other ? static_cast<std::int64_t>(*other) : 0;
  }

  std::uint64_t Row(int j, int k) const
  {
    return this->Rows[static_cast<std::size_t>(j + this->Size * k)];
  }

  int Size;
  bool HasOneOther = true; ///< all samples without the label have one other label
  std::int64_t Other = 0;  ///< that label

private:
  /// Reads samples of a row of the cube.
  template <typename T>
  struct RowReader
  {
    RowReader(const TypedField<T>& field, int first, int edge)
      : Edge(static_cast<std::size_t>(edge))
      , IsInner(field.Strides.x == 1 && first >= 0 && first + edge <= field.Dimensions.x)
    {
      for (int i = 0; i < edge; ++i)
      {
        this->Places[static_cast<std::size_t>(i)] =
          std::clamp(first + i, 0, field.Dimensions.x - 1) * field.Strides.x;
      }
    }

    T At(std::size_t sample) const { return this->Row[this->Places[sample]]; }

    std::uint64_t Find(T label) const
    {
      alignas(64) std::array<std::uint8_t, MostSamples> has{};
      const T* const inner = this->Row + this->Places[0];
      for (std::size_t i = 0; i < this->Edge && this->IsInner; ++i)
      {
        has[i] = inner[i] == label;
      }
      for (std::size_t i = 0; i < this->Edge && !this->IsInner; ++i)
      {
        has[i] = this->At(i) == label;
      }
      std::uint64_t bits = 0;
      for (std::size_t i = 0; i < this->Edge; i += 8)
      {
        // The product moves the lowest bit of each byte into the highest byte.
        std::uint64_t bytes;
        std::memcpy(&bytes, &has[i], sizeof(bytes));
        bits |= (bytes * 0x0102040810204080u >> 56) << i;
      }
      return bits;
    }

    std::size_t Edge;
    bool IsInner; ///< samples are adjacent in memory
    std::array<std::int64_t, MostSamples> Places;
    const T* Row = nullptr;
  };

  std::vector<std::uint64_t> Rows;
};

/// A Gaussian, and the sums of its weights where bits are set.
class Gaussian
{
public:
  explicit Gaussian(double deviation)
    : Weights(GaussianOf(deviation))
    , Sums((Weights.size() + 7) / 8 * 256)
  {
    for (std::size_t at = 0; at < this->Sums.size(); ++at)
    {
      for (std::size_t bit = 0; bit < 8 && at / 256 * 8 + bit < this->Weights.size(); ++bit)
      {
        this->Sums[at] += at >> bit & 1u ? this->Weights[at / 256 * 8 + bit] : 0.0f;
      }
    }
  }

  float SumOf(std::uint64_t bits) const
  {
    float sum = 0.0f;
    for (std::size_t at = 0; at < this->Sums.size(); at += 256, bits >>= 8)
    {
      sum += this->Sums[at + (bits & 255u)];
    }
    return sum;
  }

  std::vector<float> Weights;

private:
  std::vector<float> Sums; ///< of each eight weights, by their bits
};

/// Weighted means over a cube of samples around each of count^3 samples in its middle.
class SmoothCube
{
public:
  static constexpr std::size_t Width = 8; ///< of rows in memory

  SmoothCube(const LabelCube& cube, const Gaussian& gaussian, int count)
    : Count(count)
  {
    const std::vector<float>& weights = gaussian.Weights;
    const auto taps = static_cast<int>(weights.size());
    const int span = count + taps - 1, skip = (cube.Size - span) / 2;
    const auto rows = static_cast<std::size_t>(span), lines = static_cast<std::size_t>(count);
    const std::uint64_t all = (std::uint64_t(1) << taps) - 1;
    std::vector<float> alongX(rows * rows * Width), alongXY(rows * lines * Width);
    for (int k = 0; k < span; ++k)
    {
      for (int j = 0; j < span; ++j)
      {
        float* const to =
          &alongX[Width * (static_cast<std::size_t>(j) + rows * static_cast<std::size_t>(k))];
        const std::uint64_t bits = cube.Row(skip + j, skip + k) >> skip;
        for (int i = 0; i < count; ++i)
        {
          to[i] = gaussian.SumOf(bits >> i & all);
        }
      }
    }
    // Along y and z, whole rows are added.
    for (std::size_t k = 0; k < rows; ++k)
    {
      for (std::size_t j = 0; j < lines; ++j)
      {
        Sum(&alongX[Width * (j + rows * k)], Width, weights, &alongXY[Width * (j + lines * k)]);
      }
    }
    this->Means.resize(lines * lines * Width);
    for (std::size_t k = 0; k < lines; ++k)
    {
      for (std::size_t j = 0; j < lines; ++j)
      {
        Sum(&alongXY[Width * (j + lines * k)], Width * lines, weights,
          &this->Means[Width * (j + lines * k)]);
      }
    }
  }

  float At(int i, int j, int k) const
  {
    return this
      ->Means[static_cast<std::size_t>(i) + Width * static_cast<std::size_t>(j + this->Count * k)];
  }

private:
  static void Sum(
    const float* from, std::size_t toNext, const std::vector<float>& weights, float* to)
  {
    std::array<float, Width> sum{};
    for (const float weight : weights)
    {
      for (std::size_t i = 0; i < Width; ++i)
      {
        sum[i] += weight * from[i];
      }
      from += toNext;
    }
    std::copy(sum.begin(), sum.end(), to);
  }

  int Count;
  std::vector<float> Means;
};

}

struct SmoothLabels::Smoothing : Gaussian
{
  using Gaussian::Gaussian;
};

SmoothLabels::SmoothLabels(const Field& field, double radius)
  : Samples(field)
  , Deviation(radius)
  , OfShares(std::make_unique<const Smoothing>(ShareOfRadius * radius))
  , OfNormals(std::make_unique<const Smoothing>(radius))
  , Leaves((field.Dimensions - 1 + (CellBlocks::LeafSize - 1)) / CellBlocks::LeafSize)
  , Heads(std::make_unique<Head[]>(
      static_cast<std::size_t>(this->Leaves.x * this->Leaves.y * this->Leaves.z)))
{
}

SmoothLabels::~SmoothLabels()
{
  this->Clear();
}

void SmoothLabels::Clear() const
{
  const std::int64_t count = this->Leaves.x * this->Leaves.y * this->Leaves.z;
  for (std::int64_t leaf = 0; leaf < count; ++leaf)
  {
    this->Clear(this->Heads[static_cast<std::size_t>(leaf)]);
  }
}

void SmoothLabels::Clear(Head& head) const
{
  const Entry* entry = head.exchange(nullptr);
  while (entry)
  {
    delete std::exchange(entry, entry->Next);
    --this->Count;
  }
}

int SmoothLabels::Reach() const
{
  // Gradients are differences between neighbours.
  return static_cast<int>(this->OfNormals->Weights.size()) / 2 + 1;
}

void SmoothLabels::Forget(const CellBox& changed) const
{
  constexpr int size = CellBlocks::LeafSize;
  const glm::ivec3 first = changed.First - this->Reach();
  const glm::ivec3 last = changed.First + changed.Size + this->Reach();
  const glm::i64vec3 begin(glm::max(first / size - 1, 0));
  const glm::i64vec3 end(glm::min(last / size + 1, glm::ivec3(this->Leaves)));
  for (std::int64_t k = begin.z; k < end.z; ++k)
  {
    for (std::int64_t j = begin.y; j < end.y; ++j)
    {
      for (std::int64_t i = begin.x; i < end.x; ++i)
      {
        this->Clear(
          this->Heads[static_cast<std::size_t>(i + this->Leaves.x * (j + this->Leaves.y * k))]);
      }
    }
  }
}

const SmoothLabels::Block& SmoothLabels::Of(const glm::ivec3& cell, std::int64_t label) const
{
  const glm::i64vec3 leaf(cell >> CellBlocks::LeafBits);
  Head& head = this->Heads[static_cast<std::size_t>(
    leaf.x + this->Leaves.x * (leaf.y + this->Leaves.y * leaf.z))];
  for (const Entry* entry = head.load(std::memory_order_acquire); entry; entry = entry->Next)
  {
    if (entry->Label == label)
    {
      return entry->Of;
    }
  }
  auto made = std::make_unique<Entry>(), other = std::make_unique<Entry>();
  made->Label = label;
  if (this->Make(cell & -CellBlocks::LeafSize, *made, *other))
  {
    this->Add(head, std::move(other));
  }
  return this->Add(head, std::move(made));
}

/// Add a block to the list of a leaf, unless another thread has added one of its label.
/// \return the block that is in the list
const SmoothLabels::Block& SmoothLabels::Add(Head& head, std::unique_ptr<Entry> made) const
{
  const Entry* checked = nullptr;
  made->Next = head.load(std::memory_order_acquire);
  do
  {
    for (const Entry* entry = made->Next; entry != checked; entry = entry->Next)
    {
      if (entry->Label == made->Label)
      {
        return entry->Of;
      }
    }
    checked = made->Next;
  } while (!head.compare_exchange_weak(
    made->Next, made.get(), std::memory_order_acq_rel, std::memory_order_acquire));
  ++this->Count;
  return made.release()->Of;
}

/// Make the block of a label. In a window of two labels, make the other block as well.
/// \return true if that is so
bool SmoothLabels::Make(const glm::ivec3& firstSample, Entry& made, Entry& other) const
{
  const int beside = this->Reach();
  const LabelCube cube = DispatchScalarType(this->Samples.Type,
    [&](auto type)
    {
      return LabelCube(TypedField<decltype(type)>(this->Samples), made.Label, firstSample - beside,
        Edge + 2 * beside);
    });
  const SmoothCube shares(cube, *this->OfShares, Edge);
  const SmoothCube wide(cube, *this->OfNormals, Edge + 2);
  other.Label = cube.Other;
  for (int k = 0; k < Edge; ++k)
  {
    for (int j = 0; j < Edge; ++j)
    {
      const std::uint64_t own = cube.Row(j + beside, k + beside) >> beside;
      for (int i = 0; i < Edge; ++i)
      {
        const std::size_t at = PlaceOf({ i, j, k });
        const float share = shares.At(i, j, k) / CubeOfUnit;
        const glm::vec3 gradient =
          glm::vec3(wide.At(i + 2, j + 1, k + 1) - wide.At(i, j + 1, k + 1),
            wide.At(i + 1, j + 2, k + 1) - wide.At(i + 1, j, k + 1),
            wide.At(i + 1, j + 1, k + 2) - wide.At(i + 1, j + 1, k)) /
          CubeOfUnit;
        made.Of.Set(at, (own >> i & 1u) != 0, share, gradient);
        other.Of.Set(at, (own >> i & 1u) == 0, 1.0f - share, -gradient);
      }
    }
  }
  return cube.HasOneOther;
}

/// Set a sample.
/// \param isOwn it has the label
void SmoothLabels::Block::Set(std::size_t at, bool isOwn, float share, const glm::vec3& gradient)
{
  if (isOwn)
  {
    this->Share[at] = share < 0.5f ? 0.5f + MarginOfThin : std::max(share, 0.5f + Margin);
  }
  else
  {
    this->Share[at] = share > 0.5f ? 0.5f - MarginOfThin : std::min(share, 0.5f - Margin);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Gradient[static_cast<std::size_t>(axis)][at] = gradient[axis];
  }
}

}
