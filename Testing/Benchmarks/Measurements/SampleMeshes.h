// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_SampleMeshes_h
#define Benchmarks_SampleMeshes_h

#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

/// Irregular grids: some by formula, and real ones if present.
namespace SampleMeshes
{

/// The field of generated meshes on [-1, 1]^3: shells that are not quite round.
double ValueAt(double x, double y, double z);
constexpr double Isovalue = 0.3; ///< some shells, one inside of another

/// Samples of that field: n along each axis, floats.
vtkSmartPointer<vtkImageData> Image(int n);

/// A mesh with its scalars chosen. Its name is a file below the data directory ("disk_out_ref.ex2",
/// "hexa.vtk", "bluntfinxyz.bin"), or "tetrahedra", "hexahedra" or "curvilinear" and a size: so
/// many cubes a side, their inner corners moved at random; in the first each cube is six
/// tetrahedra.
/// \return null if it is a file that is missing or that this VTK does not read
vtkSmartPointer<vtkDataSet> Load(const std::string& name);

/// True if the name is of a mesh that is generated.
bool IsGenerated(const std::string& name);

}

#endif
