// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshRuns_h
#define TemporalCoherence_MeshRuns_h

#include "Mesh/Tree/MeshKeys.h"
#include "Mesh/Tree/MeshReader.h"
#include "Mesh/Tree/RadixSort.h"

#include <cstdint>

namespace TemporalCoherence
{

/// Sorts runs of cells with equal places along a curve again, along curves through the runs' own
/// boxes.
class RunSorter
{
public:
  RunSorter(const MeshReader& reader, const KeyLayout& layout)
    : Reader(reader)
    , Layout(layout)
  {
  }

  /// Sort the runs among the sorted keys begin .. end - 1, in parallel.
  /// \param curve how many curves they are sorted along
  void SortRuns(
    SortKeys& keys, SortKeys& spare, std::int64_t begin, std::int64_t end, int curve = 1) const;

private:
  template <typename Work>
  void ForEachRun(
    const std::uint64_t* keys, std::int64_t begin, std::int64_t end, const Work& work) const;
  glm::dvec3 CentreOf(std::uint64_t key) const;
  bool Renew(std::uint64_t* keys, std::int64_t begin, std::int64_t end) const;
  void SortAlone(std::uint64_t* keys, std::int64_t begin, std::int64_t end, int curve) const;

  const MeshReader& Reader;
  KeyLayout Layout;
};

}

#endif
