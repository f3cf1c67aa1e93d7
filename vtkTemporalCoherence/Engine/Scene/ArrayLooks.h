// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ArrayLooks_h
#define TemporalCoherence_ArrayLooks_h

#include "Scene/HitRays.h"

#include <glm/glm.hpp>

#include <memory>

namespace TemporalCoherence
{

template <typename Look>
class ValueTable;

using ValueColors = ValueTable<glm::vec3>; ///< RGB in [0, 1]
using ValueOpacities = ValueTable<float>;  ///< in [0, 1]

/// True if two tables are equal.
template <typename Look>
bool AreSame(const ValueTable<Look>& a, const ValueTable<Look>& b);

/// An array on the data whose surfaces are drawn.
class ArrayValues
{
public:
  virtual ~ArrayValues() = default;

  /// True if two arrays are equal.
  virtual bool IsSame(const ArrayValues& other) const = 0;

  /// Find the values at hits, as the data are interpolated. NaN: there is no value. Thread-safe.
  /// \param cells of a mesh that are hit, or NoCell
  virtual void Find(const HitRays& rays, const RayBatch::Array<CellNumber>& cells,
    RayBatch::Array<double>& values) const = 0;
};

/// How surfaces look at the values of an array.
template <typename Look>
struct ArrayLooks
{
  std::shared_ptr<const ArrayValues> Values;
  std::shared_ptr<const ValueTable<Look>> Looks;
};

using ArrayColors = ArrayLooks<glm::vec3>;
using ArrayOpacities = ArrayLooks<float>;

/// True if two pointers, which may be null, point to equal looks.
template <typename Look>
bool AreSame(const std::shared_ptr<const ArrayLooks<Look>>& a,
  const std::shared_ptr<const ArrayLooks<Look>>& b)
{
  return a == b ||
    (a && b && a->Values->IsSame(*b->Values) &&
      (a->Looks == b->Looks || AreSame(*a->Looks, *b->Looks)));
}

}

#endif
