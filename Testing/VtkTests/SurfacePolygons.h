// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VtkTests_SurfacePolygons_h
#define VtkTests_SurfacePolygons_h

#include <vtkActor.h>
#include <vtkDataSet.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>

#include <vector>

/// The parts of the input of a volume's mapper: one, or the blocks of a composite.
std::vector<vtkDataSet*> PartsOf(vtkVolume* volume);

/// What isosurfaces of a volume are those of.
struct ScalarField
{
  vtkSmartPointer<vtkDataSet> Samples; ///< the active scalars of points; null if not known here
  int Component = 0;                   ///< which one of the volume's they are
};

ScalarField FieldOf(vtkVolume* volume, vtkDataSet* part);

/// The isosurfaces of a volume as polygons: those at the isovalues of its property, cropped and
/// clipped as its mapper is told, and without hidden cells.
std::vector<vtkSmartPointer<vtkActor>> MakePolygons(vtkVolume* volume);

#endif
