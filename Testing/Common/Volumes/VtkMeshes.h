// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_VtkMeshes_h
#define Testing_VtkMeshes_h

#include <vtkExplicitStructuredGrid.h>
#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

/// Images as grids of other sorts: the same points, cells or parts of them, and the same data.
namespace VtkMeshes
{

/// The points of an image.
/// \param type VTK_FLOAT or VTK_DOUBLE
vtkSmartPointer<vtkPoints> PointsOf(vtkImageData* image, int type = VTK_DOUBLE);

/// Each cell of an image as VTK_VOXEL or VTK_HEXAHEDRON, or as 6 tetrahedra, 2 wedges, or 6
/// pyramids around a new point in its middle. Arrays of points are shared, except with pyramids,
/// whose new points have the means. Arrays of cells are repeated.
vtkSmartPointer<vtkUnstructuredGrid> Unstructured(vtkImageData* image, int cellType);

/// The types of the cells of a grid, by the call that the version of VTK has for them.
vtkDataArray* TypesOf(vtkUnstructuredGrid* grid);

vtkSmartPointer<vtkStructuredGrid> Curvilinear(vtkImageData* image);
vtkSmartPointer<vtkExplicitStructuredGrid> Explicit(vtkImageData* image);
vtkSmartPointer<vtkRectilinearGrid> Rectilinear(vtkImageData* image);

}

#endif
