// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlendCase_h
#define Testing_BlendCase_h

#include "Grid.h"
#include "Scene/FrameKey.h"

#include <cmath>
#include <cstddef>
#include <vector>

/// A point of a transfer function: where between the least and the largest value, and RGBA.
struct LookPoint
{
  double At;
  glm::dvec4 Color;
};

/// A function that is linear between points.
inline TemporalCoherence::TransferFunction MakeTransfer(
  const glm::dvec2& range, const std::vector<LookPoint>& points, std::size_t nodes = 4097)
{
  TemporalCoherence::TransferFunction transfer;
  transfer.Range = range;
  std::size_t next = 1;
  for (std::size_t node = 0; node < nodes; ++node)
  {
    const double at = static_cast<double>(node) / static_cast<double>(nodes - 1);
    while (next + 1 < points.size() && points[next].At <= at)
    {
      ++next;
    }
    const LookPoint& before = points[next - 1];
    const LookPoint& behind = points[next];
    const double share = glm::clamp((at - before.At) / (behind.At - before.At), 0.0, 1.0);
    transfer.Nodes.push_back(glm::mix(before.Color, behind.Color, share));
  }
  return transfer;
}

namespace BlendLooks
{

/// A ramp to bone, nearly opaque.
inline const std::vector<LookPoint> Bone{ { 0.0, { 0.1, 0.0, 0.0, 0.0 } },
  { 0.45, { 0.5, 0.2, 0.1, 0.0 } }, { 0.55, { 0.8, 0.6, 0.4, 0.3 } },
  { 0.75, { 0.9, 0.85, 0.7, 0.9 } }, { 1.0, { 1.0, 1.0, 1.0, 0.95 } } };
/// Skin through which bone is seen.
inline const std::vector<LookPoint> Skin{ { 0.0, { 0.2, 0.1, 0.1, 0.0 } },
  { 0.2, { 0.8, 0.5, 0.4, 0.0 } }, { 0.28, { 0.9, 0.6, 0.5, 0.08 } },
  { 0.5, { 0.7, 0.3, 0.2, 0.03 } }, { 0.7, { 1.0, 0.9, 0.8, 0.5 } },
  { 1.0, { 1.0, 1.0, 0.9, 0.8 } } };
/// Two peaks that are thinner than what a field changes within a cell.
inline const std::vector<LookPoint> Peaks{ { 0.0, { 0.2, 0.4, 0.9, 0.0 } },
  { 0.34, { 0.2, 0.4, 0.9, 0.0 } }, { 0.345, { 0.2, 0.4, 0.9, 0.9 } },
  { 0.35, { 0.2, 0.4, 0.9, 0.0 } }, { 0.66, { 0.9, 0.8, 0.2, 0.0 } },
  { 0.67, { 0.9, 0.8, 0.2, 0.99 } }, { 0.68, { 0.9, 0.8, 0.2, 0.0 } },
  { 1.0, { 0.9, 0.8, 0.2, 0.0 } } };
/// Two ranges that are opaque at once, narrower than what a field changes within a cell.
inline const std::vector<LookPoint> OpaqueRanges{ { 0.0, { 0.9, 0.2, 0.1, 0.0 } },
  { 0.3, { 0.9, 0.2, 0.1, 0.0 } }, { 0.301, { 0.2, 0.3, 1.0, 1.0 } },
  { 0.303, { 0.2, 0.3, 1.0, 1.0 } }, { 0.304, { 0.9, 0.2, 0.1, 0.0 } },
  { 0.6, { 0.1, 0.8, 0.9, 0.1 } }, { 0.601, { 0.1, 0.8, 0.9, 1.0 } },
  { 0.602, { 0.1, 0.8, 0.9, 1.0 } }, { 0.603, { 0.1, 0.8, 0.9, 0.0 } },
  { 1.0, { 0.1, 0.8, 0.9, 0.2 } } };
/// Opaque at both ends alone.
inline const std::vector<LookPoint> OpaqueEnds{ { 0.0, { 0.2, 0.9, 0.3, 1.0 } },
  { 0.3, { 0.5, 0.6, 0.3, 0.02 } }, { 0.7, { 0.9, 0.5, 0.3, 0.02 } },
  { 1.0, { 0.9, 0.3, 0.6, 1.0 } } };
/// Opaque from one value on.
inline const std::vector<LookPoint> Step{ { 0.0, { 0.9, 0.3, 0.2, 0.0 } },
  { 0.5, { 0.9, 0.3, 0.2, 0.0 } }, { 0.5 + 1e-9, { 0.9, 0.7, 0.6, 1.0 } },
  { 1.0, { 0.4, 0.7, 1.0, 1.0 } } };
/// Fog everywhere, and a translucent jump.
inline const std::vector<LookPoint> Fog{ { 0.0, { 0.5, 0.5, 0.6, 0.01 } },
  { 0.6, { 0.6, 0.7, 0.9, 0.03 } }, { 0.6 + 1e-9, { 1.0, 0.4, 0.1, 0.4 } },
  { 1.0, { 1.0, 0.8, 0.1, 0.2 } } };
/// Fully transparent but for the lowest values.
inline const std::vector<LookPoint> Valley{ { 0.0, { 0.1, 0.8, 0.3, 0.7 } },
  { 0.15, { 0.9, 0.8, 0.3, 0.0 } }, { 1.0, { 1.0, 1.0, 1.0, 0.0 } } };

}

/// Samples of a smooth field with shells, scaled to a type's values.
template <typename T>
struct BlendVolume : Grid<T>
{
  explicit BlendVolume(const glm::ivec3& dimensions, const glm::dvec2& range = { 0.0, 255.0 })
    : Grid<T>(dimensions)
    , Range(range)
  {
    this->Fill(
      [&](int i, int j, int k)
      {
        const glm::dvec3 p = glm::dvec3(i, j, k) / glm::dvec3(dimensions - 1) * 2.0 - 1.0;
        const double radius = glm::length(p - glm::dvec3(0.1, -0.1, 0.05));
        const double waves = std::sin(7.0 * p.x + 1.0) * std::cos(6.0 * p.y) * std::sin(8.0 * p.z);
        const double share = 0.5 + 0.35 * std::cos(5.0 * radius) + 0.15 * waves;
        return range.x + (range.y - range.x) * glm::clamp(share, 0.0, 1.0);
      });
  }

  glm::dvec2 Range;
};

/// A key of a volume of one component, with a light and a view.
template <typename T>
TemporalCoherence::FrameKey MakeBlendKey(const BlendVolume<T>& volume,
  TemporalCoherence::BlendMode mode, const std::vector<LookPoint>& points)
{
  TemporalCoherence::FrameKey key;
  key.Samples = volume.Field;
  key.View = LookAt(volume.Field.Dimensions, { 1.0, 2.0, 0.7 }, { 96, 80 });
  key.Shown.emplace<TemporalCoherence::Blending>().Mode = mode;
  TemporalCoherence::ComponentLook look;
  look.Transfer = MakeTransfer(volume.Range, points);
  key.Blended().Looks = { look };
  key.Blended().ScalarRanges = { volume.Range };
  key.Blended().AverageRange =
    glm::mix(glm::dvec2(volume.Range.x), glm::dvec2(volume.Range.y), glm::dvec2(0.3, 0.9));
  TemporalCoherence::Light light;
  light.Direction = -glm::normalize(glm::dvec3(1.0, 1.4, 1.2));
  key.Appearance.Lights = { light };
  return key;
}

/// Sizes that differ along all axes and are no multiples of blocks.
inline const glm::ivec3 BlendSize{ 41, 37, 45 };

#endif
