// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Extraction_h
#define Extraction_h

#include <vtkType.h>

#include <string>

struct Volume;

// What VTK needs without the mapper, and without a GPU, for each new isovalue: all triangles of
// the surface again.
struct Extraction
{
  std::string Filter; // the class that extracts; empty: the volume is read as it is needed
  double Ms = 0.0;
  vtkIdType Triangles = 0;
  double Isovalue = 0.0;
};

// Times one run of vtkFlyingEdges3D, or of vtkContourFilter for each part of what is no image, with
// the normals that shading needs.
Extraction TimeExtraction(const Volume& volume, double isovalue);

#endif
