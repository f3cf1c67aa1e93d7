// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Triangles_h
#define Triangles_h

#include "Files/Volume.h"
#include "Model/Settings.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

// The surfaces that a look shows as triangles of VTK's contour filter, in the world: without what
// is clipped away and without caps. Throws UserError if there are none.
vtkSmartPointer<vtkPolyData> TrianglesOf(const Volume& volume, int component, const Look& look);

// Writes .stl, .ply or .vtp. Throws UserError.
void WriteTriangles(vtkPolyData* triangles, const std::string& path);

#endif
