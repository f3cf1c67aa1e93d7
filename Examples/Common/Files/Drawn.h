// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Drawn_h
#define Drawn_h

#include "Files/Volume.h"

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

class vtkDataSet;

// Whether a data set has cells of three dimensions. The mapper draws no others.
bool HasVolume(vtkDataSet* set);

// An array, and which of its values the mapper draws. What meshes have of cells is averaged to
// points, as the mapper does.
struct DrawnArray
{
  vtkSmartPointer<vtkDataArray> Values;
  const std::vector<unsigned char>* IsDrawn = nullptr; // for each tuple; null: all are
};

// What the mapper draws of a data object: cells with volume that are not hidden, and their points.
// Faces, lines and what nobody uses have values, too.
class Drawn
{
public:
  // areAveraged: values of cells of meshes are those at points that they give
  explicit Drawn(vtkDataObject* data, bool areAveraged = true);

  // The arrays that are drawn by a choice, of each data set that has it.
  std::vector<DrawnArray> Arrays(const ArrayChoice& choice);

  // The least and the greatest finite value; the first larger than the second if there is none.
  // \param component -1: the length of vectors
  std::array<double, 2> Range(const ArrayChoice& choice, int component = 0);

private:
  struct Part
  {
    vtkDataSet* Set = nullptr;
    bool IsKnown = false, AreAll = true;
    std::vector<unsigned char> Points, Cells; // whether they are drawn
  };
  static void LookAt(Part& part);

  std::vector<Part> Parts;
  bool AreAveraged = false; // values of cells
};

#endif
