// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SavedColors_h
#define TemporalCoherence_SavedColors_h

#include "Scene/Frame.h"

#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// The colours of a picture, while new ones are written in their place. Unless Drop() is called,
/// the destructor writes them back.
class SavedColors
{
public:
  /// \throws std::bad_alloc
  explicit SavedColors(Frame& picture);
  ~SavedColors();
  SavedColors(const SavedColors&) = delete;
  SavedColors& operator=(const SavedColors&) = delete;

  /// Save the colours of `part`, which is tile number `tile`, and of its layers. Thread-safe.
  /// \throws std::bad_alloc
  void Save(std::int64_t tile, const PixelRect& part);

  /// The new colours stay.
  void Drop() { this->IsSaved.clear(); }

private:
  Frame& Picture;
  decltype(Frame::Colors) Colors;
  std::vector<std::vector<LayerColor>> OfLayers; ///< of each tile; empty if surfaces are opaque
  std::vector<std::uint8_t> IsSaved;             ///< 1 for each tile that is saved
};

}

#endif
