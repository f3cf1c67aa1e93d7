// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Picture_h
#define Fuzz_Picture_h

#include "World/World.h"

#include <vtkNew.h>

#include <optional>
#include <string>

namespace Fuzz
{

/// All that a mapper tells of a frame's pixels.
struct Picture
{
  /// MakeImage() of what the world shows.
  bool Render(World& world, Mapper* mapper);

  /// The mapper's last frame.
  bool Fetch(Mapper* mapper);

  void Copy(const Picture& other);
  bool IsEmpty() const { return this->CountPixels() == 0; }
  vtkIdType CountPixels() const { return this->Frame->GetNumberOfPoints(); }
  vtkIdType CountHits() const;

  /// True if anything is seen at a pixel.
  bool IsHit(vtkIdType pixel) const;

  /// Position in the property's list of the isovalue at a pixel; -1 for none.
  int IsovalueAt(int x, int y) const;

  /// What of the pictures differs, in words; empty if nothing does.
  std::string Difference(const Picture& other, bool inColors, bool inNormals) const;

  /// Pixels with a surface in one and none in the other, or farther apart than `apart`.
  vtkIdType CountDifferent(const Picture& other, double apart) const;

  /// What no picture may hold, in words: numbers that are none, parts that contradict each other.
  /// \param isovalues how many there are; none: the places of labels may be any number
  /// \param isTame    no number of the scene was wild
  std::string Nonsense(std::optional<int> isovalues, bool isTame) const;

  vtkNew<vtkImageData> Frame; ///< with all arrays
  bool IsBlended = false;     ///< it was rendered in another blend mode than that of isosurfaces
};

}

#endif
