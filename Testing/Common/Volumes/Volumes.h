// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Volumes_h
#define Testing_Volumes_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>

/// Volumes for tests and benchmarks: some by formula, and real ones if present.
namespace Volumes
{

/// An image of n^3 samples of a VTK scalar type on [-1, 1]^3, spacing 2 / (n - 1).
vtkSmartPointer<vtkImageData> FromFormula(
  int n, int scalarType, const std::function<double(double, double, double)>& value);

/// The paper's four spheres: 255 times the largest of 1 - d / 0.6 over four centres, as uchar with
/// spacing 1; isovalue 100.
vtkSmartPointer<vtkImageData> FourSpheres(int n);

/// The signal of Marschner and Lobb 1994, times 255, as uchar with spacing 1; isovalue 128.
vtkSmartPointer<vtkImageData> MarschnerLobb(int n);

/// 32^3 shorts between -1700 and 1700: waves that reach the boundary of the volume.
vtkSmartPointer<vtkImageData> Waves();

/// n^3 independent random samples between `low` and `high`.
vtkSmartPointer<vtkImageData> Noise(int n, int scalarType, double low, double high);

/// A volume and a good isovalue.
struct Sample
{
  std::string
    Name; ///< a file below the data directory; "spheres", "marschner-lobb", "noise" and a size
  double Isovalue;
};

/// The most samples a side of a volume that is loaded by the name of its formula.
constexpr int LargestSize = 2048;

/// Folder of the real volumes: the environment's TEMPORAL_COHERENCE_DATA; empty if that is not set.
std::string DataDirectory();

/// The volume of that name; null if it is a file that is missing or not readable.
vtkSmartPointer<vtkImageData> Load(const std::string& name);

}

#endif
