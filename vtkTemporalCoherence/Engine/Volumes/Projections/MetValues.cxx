// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Projections/MetValues.h"

#include "Scene/RayBatch.h"
#include "Volumes/Medium/VisibleBands.h"
#include "Volumes/Samples/ComponentLooks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t Rays = RayBatch::Capacity;

bool IsExtreme(BlendMode mode)
{
  return mode == BlendMode::Maximum || mode == BlendMode::Minimum;
}

bool IsIntegral(BlendMode mode)
{
  return mode == BlendMode::Average || mode == BlendMode::Additive;
}

/// Call visit(array) for each stored array.
template <typename Seen, typename Visit>
void ForEachArray(const Blending& volume, Seen& seen, const Visit& visit)
{
  const std::size_t others = ComponentLooks(volume).Parts() - 1;
  visit(seen.First);
  visit(seen.Value);
  std::for_each_n(seen.OtherValues.begin(), others, visit);
  if (IsIntegral(volume.Mode))
  {
    visit(seen.Length);
    std::for_each_n(seen.OtherLengths.begin(), others, visit);
  }
}

/// True if two functions give the same opacities.
bool AreAsOpaque(const ComponentLook& a, const ComponentLook& b)
{
  return a.Transfer.Range == b.Transfer.Range && a.UnitDistance == b.UnitDistance &&
    std::equal(a.Transfer.Nodes.begin(), a.Transfer.Nodes.end(), b.Transfer.Nodes.begin(),
      b.Transfer.Nodes.end(), [](const glm::dvec4& x, const glm::dvec4& y) { return x.w == y.w; });
}

}

std::size_t NumbersMet(const Blending& volume)
{
  const std::size_t parts = ComponentLooks(volume).Parts();
  return IsExtreme(volume.Mode) ? parts + 1 : (IsIntegral(volume.Mode) ? 2 * parts + 1 : 0);
}

bool MeetSameValues(const Blending& a, const Blending& b)
{
  if (!HaveSameRays(a, b) || a.Looks.size() != b.Looks.size())
  {
    return false;
  }
  const bool haveSameIntegrals = a.AverageRange == b.AverageRange &&
    a.ScalarRanges == b.ScalarRanges &&
    std::equal(a.Looks.begin(), a.Looks.end(), b.Looks.begin(), AreAsOpaque);
  return IsExtreme(a.Mode) || (IsIntegral(a.Mode) && haveSameIntegrals);
}

glm::dvec2 ExtremesMet(const Blending& volume)
{
  const ValueBand seen =
    IsExtreme(volume.Mode) ? VisibleExtremes(volume) : ValueBand{ -Infinity, Infinity };
  return { seen.Low, seen.High };
}

bool KnowsAllExtremes(const glm::dvec2& within, const Blending& volume)
{
  const glm::dvec2 seen = ExtremesMet(volume);
  return seen.x > seen.y || (within.x <= seen.x && seen.y <= within.y);
}

void KeepMet(const Blending& volume, std::int64_t tile, const BlendedRays& seen, Frame& frame)
{
  const std::size_t size = NumbersMet(volume) * Rays;
  double* const first = &frame.Met[static_cast<std::size_t>(tile) * size];
  double* to = first;
  ForEachArray(volume, seen,
    [&](const BlendedRays::Array<double>& values)
    { to = std::copy(values.begin(), values.end(), to); });
  const glm::dvec2& within = frame.MetWithin;
  const bool areAll = within.x == -Infinity && within.y == Infinity;
  for (std::size_t i = 0; IsExtreme(volume.Mode) && !areAll && i < Rays; ++i)
  {
    double& extreme = first[Rays + i];
    extreme = within.x <= extreme && extreme <= within.y ? extreme
                                                         : std::numeric_limits<double>::quiet_NaN();
  }
}

std::uint64_t TakeMet(
  const Blending& volume, std::int64_t tile, const Frame& frame, BlendedRays& seen)
{
  if (frame.ClearTiles[static_cast<std::size_t>(tile)])
  {
    return 0;
  }
  const double* from = &frame.Met[static_cast<std::size_t>(tile) * NumbersMet(volume) * Rays];
  ForEachArray(volume, seen,
    [&](BlendedRays::Array<double>& values)
    {
      std::copy_n(from, Rays, values.begin());
      from += Rays;
    });
  std::uint64_t known = 0;
  for (std::size_t i = 0; i < Rays; ++i)
  {
    const bool isUnknown = std::isnan(seen.Value[i]);
    seen.First[i] = isUnknown ? Infinity : seen.First[i];
    known |= static_cast<std::uint64_t>(!isUnknown) << i;
  }
  return known;
}

}
