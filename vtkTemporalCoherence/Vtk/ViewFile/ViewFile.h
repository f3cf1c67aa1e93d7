// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewFile_h
#define TemporalCoherence_ViewFile_h

#include "Scene/Progress.h"
#include "ViewFile/ViewHeader.h"

#include <cstdint>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Collects views, and makes the bytes of a file of them (Documentation/ViewFile.md).
class ViewFileMaker
{
public:
  /// \return why this build cannot make files, as a sentence; empty if it can
  static std::string WhyNot();

  /// Add a view. Its knots are compressed at once, in all threads.
  /// \throws std::bad_alloc
  void Add(const ViewGeometry& geometry, const KnotImage& knots);

  /// The file.
  /// \throws std::bad_alloc
  std::vector<std::uint8_t> Finish(const ViewDescription& description);

private:
  static void CutIntoChunks(const KnotImage& knots, ViewEntry& view);
  FileSection Append(const std::vector<std::uint8_t>& packed, std::size_t unpacked);

  ViewHeader Header;
  std::vector<std::uint8_t> Sections;
};

/// The views of a file, in memory.
struct LoadedViews
{
  ViewHeader Header;
  std::string HeaderText;
  std::vector<KnotImage> Knots; ///< of each view
};

/// Read a file. All of it is checked. Memory is bounded by some thousand times the file's size, and
/// 32 bytes for each of its pixels, of which there are at most 2^26.
/// \return what is wrong, as a sentence; empty if nothing is
/// \throws std::bad_alloc
std::string ReadViews(const std::vector<std::uint8_t>& file, LoadedViews& views);

}

#endif
