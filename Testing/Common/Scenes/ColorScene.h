// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ColorScene_h
#define Testing_ColorScene_h

#include "Scenes/Scene.h"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

/// Data with arrays that give surfaces their looks.
namespace ColorArrays
{

/// Add an array, whose tuples are functions of the places.
void Add(vtkDataSet* data, bool onCells, const char* name, int type, int components);

/// Add "heat" and the vectors "flow" on points, and "cell heat".
void AddAll(vtkDataSet* data);

/// Distances from a point near the middle, with all arrays.
vtkSmartPointer<vtkImageData> Ball();

}

/// A ball whose surface has the colours of an array.
struct ColorScene : Scene
{
  static constexpr double Isovalue = 5.0;

  explicit ColorScene(vtkDataObject* data);

  void ColorBy(bool onCells, const char* name, int component = 0);

  /// The table, or the colour function that takes its place.
  vtkScalarsToColors* Table();
};

#endif
