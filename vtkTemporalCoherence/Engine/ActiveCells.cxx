// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ActiveCells.h"

#include "Parallel.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// True if an isovalue of one of the ascending bands passes between samples of the range.
template <typename T>
bool IsActive(const ValueRangePyramid::Range<T>& range, const std::vector<ValueBand>& bands)
{
  const double min = static_cast<double>(range.Min);
  const double max = static_cast<double>(range.Max);
  for (const ValueBand& band : bands)
  {
    if (band.Low > max)
    {
      return false;
    }
    if (band.High > min)
    {
      return true;
    }
  }
  return false;
}

}

void ActiveCells::Build(
  const Field& field, const ValueRangePyramid& pyramid, const Surfaces& surfaces)
{
  this->Release();
  for (const double isovalue : surfaces.Isovalues)
  {
    this->Sought.push_back({ isovalue, isovalue });
  }
  std::sort(this->Sought.begin(), this->Sought.end(),
    [](const ValueBand& a, const ValueBand& b) { return a.Low < b.Low; });
  this->FindLeaves(field, pyramid);
}

void ActiveCells::Build(const Field& field, const ValueRangePyramid& pyramid, const ValueBand& band)
{
  this->Release();
  this->Sought = { band };
  this->FindLeaves(field, pyramid);
}

void ActiveCells::FindLeaves(const Field& field, const ValueRangePyramid& pyramid)
{
  const std::int64_t nodes = pyramid.NumberOfNodes();
  this->NodeWords.resize(static_cast<std::size_t>(2 * nodes));

  DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      ParallelFor(nodes, 64,
        [&](std::int64_t node)
        {
          const auto* ranges = pyramid.LeavesOf<T>(node);
          std::uint64_t leaves = 0;
          for (int i = 0; i < ValueRangePyramid::LeavesPerNode; ++i)
          {
            leaves |= static_cast<std::uint64_t>(IsActive(ranges[i], this->Sought)) << i;
          }
          this->NodeWords[static_cast<std::size_t>(2 * node)] = leaves;
        });
    });

  std::uint64_t words = 0;
  for (std::size_t node = 0; node < this->NodeWords.size(); node += 2)
  {
    this->NodeWords[node + 1] = words;
    words += this->NodeWords[node] != 0 ? ValueRangePyramid::LeavesPerNode : 0;
  }
  this->LeafWords = std::make_unique<std::atomic<std::uint64_t>[]>(words);
  this->NumberOfLeafWords = words;
  this->Dimensions = pyramid.NodeDimensions();
}

void ActiveCells::Release()
{
  this->Dimensions = glm::ivec3(0);
  this->Sought.clear();
  std::vector<std::uint64_t>().swap(this->NodeWords);
  this->LeafWords.reset();
  this->NumberOfLeafWords = 0;
}

std::size_t ActiveCells::MemoryInBytes() const
{
  return sizeof(std::uint64_t) * (this->NodeWords.capacity() + this->NumberOfLeafWords);
}

}
