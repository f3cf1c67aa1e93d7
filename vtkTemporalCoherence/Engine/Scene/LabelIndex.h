// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LabelIndex_h
#define TemporalCoherence_LabelIndex_h

#include "Scene/Frame.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace TemporalCoherence
{

/// Finds the positions of labels in a list of labels. A label is a whole number that names a part
/// of the data.
class LabelIndex
{
public:
  /// \param labels in any order, each once
  /// \throws std::bad_alloc
  explicit LabelIndex(const std::vector<double>& labels);

  /// The position of a label in the list; Frame::NoSurface if it is not there.
  SurfaceIndex Of(std::int64_t label) const
  {
    const std::uint64_t place =
      static_cast<std::uint64_t>(label) - static_cast<std::uint64_t>(this->Lowest);
    return place < this->Places.size() ? this->Places[static_cast<std::size_t>(place)]
                                       : this->Search(label);
  }

  bool Has(std::int64_t label) const { return this->Of(label) != Frame::NoSurface; }

private:
  SurfaceIndex Search(std::int64_t label) const;

  std::int64_t Lowest = 0;
  std::vector<SurfaceIndex> Places; ///< of the labels from Lowest on, unless they lie far apart
  std::vector<std::pair<std::int64_t, SurfaceIndex>> Sorted; ///< all labels, if they lie far apart
};

}

#endif
