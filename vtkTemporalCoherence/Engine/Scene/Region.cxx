// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Region.h"

namespace TemporalCoherence
{

BoxRange Region::RangeOfBoxes() const
{
  BoxRange range;
  for (int i = 0; i < 27; ++i)
  {
    if (this->Boxes >> i & 1u)
    {
      const glm::ivec3 box(i % 3, i / 3 % 3, i / 9);
      range.First = glm::min(range.First, box);
      range.Last = glm::max(range.Last, box);
    }
  }
  return range;
}

bool Region::IsConvex() const
{
  const BoxRange range = this->RangeOfBoxes();
  std::uint32_t all = 0;
  for (int z = range.First.z; z <= range.Last.z; ++z)
  {
    for (int y = range.First.y; y <= range.Last.y; ++y)
    {
      for (int x = range.First.x; x <= range.Last.x; ++x)
      {
        all |= 1u << (x + 3 * y + 9 * z);
      }
    }
  }
  return this->Boxes == all;
}

bool operator==(const Region& a, const Region& b)
{
  // Planes that clip nothing do not matter.
  return a.Clips == b.Clips && a.Boxes == b.Boxes &&
    (a.Boxes == Region::AllBoxes || a.Crops == b.Crops);
}

}
