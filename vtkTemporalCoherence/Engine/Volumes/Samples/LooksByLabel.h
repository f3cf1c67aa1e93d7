// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LooksByLabel_h
#define TemporalCoherence_LooksByLabel_h

#include "Scene/Blending.h"
#include "Volumes/Samples/ComponentLooks.h"

#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// The looks of a volume: first the components', then the looks of LabelMap.
class LooksByLabel
{
public:
  /// \param volume outlives this
  /// \throws std::bad_alloc
  explicit LooksByLabel(const Blending& volume);

  std::size_t Count() const { return this->Looks.size(); }
  const ComponentLooks& operator[](std::size_t look) const { return this->Looks[look]; }

private:
  std::vector<ComponentLooks> Looks;
};

}

#endif
