// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ArrayColors_h
#define ArrayColors_h

#include "Files/ColorArrays.h"
#include "Model/Annotations.h"
#include "Model/Settings.h"

class vtkTemporalCoherenceVolumeMapper;

// The colours that another array gives to surfaces.
class ArrayColors
{
public:
  void Show(const ColorArrays& arrays); // of other data; no colours until they are applied
  const ColorArrays& Arrays() const { return this->Choices; }

  // None if the data have it not; the length if they have fewer components.
  ArrayColor Fitted(const ArrayColor& color) const;

  // By the array that a look names, if the data have it.
  void Apply(const Look& look, bool areSurfaces, vtkTemporalCoherenceVolumeMapper* mapper);

  // For the colour bar.
  const Annotations::ColorKey& Key() const { return this->Shown; }

private:
  ColorArrays Choices;
  Annotations::ColorKey Shown;
  // What the table was made from. A table that stays the same costs no frame its shading.
  int Map = -1;
  std::array<double, 2> Range = {};
  vtkSmartPointer<vtkColorTransferFunction> Table;
};

#endif
