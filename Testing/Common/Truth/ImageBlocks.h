// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ImageBlocks_h
#define Testing_ImageBlocks_h

#include "Truth/ExpectSame.h"
#include "Volumes/Volumes.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>

#include <array>
#include <cmath>
#include <functional>

/// An image, its parts, and the picture that both have.
namespace ImageBlocks
{

using Image = vtkSmartPointer<vtkImageData>;
using Extent = std::array<int, 6>;

constexpr int Size = 120; ///< of pictures
constexpr int N = 33;     ///< points along each axis

inline double Waves(double x, double y, double z)
{
  return 50.0 + 45.0 * std::sin(3.0 * x + y) * std::cos(2.0 * z - y);
}

/// 33^3 points, whose sums of spacings are exact.
inline Image Whole(int type = VTK_FLOAT)
{
  Image image = Volumes::FromFormula(N, type, Waves);
  image->GetPointData()->GetScalars()->SetName("waves");
  vtkNew<vtkFloatArray> ofCells;
  ofCells->SetName("of cells");
  ofCells->SetNumberOfTuples(image->GetNumberOfCells());
  for (vtkIdType i = 0; i < ofCells->GetNumberOfTuples(); ++i)
  {
    double p[3];
    const vtkIdType x = i % (N - 1), y = i / (N - 1) % (N - 1), z = i / (N - 1) / (N - 1);
    image->GetPoint((z * N + y) * N + x, p);
    ofCells->SetTuple1(i, Waves(p[0], p[1], p[2]));
  }
  image->GetCellData()->AddArray(ofCells);
  return image;
}

/// A part of an image, in its coordinates.
/// \param isAtZero the part's extent begins with 0, its origin is its first point
template <typename Kind = vtkImageData>
vtkSmartPointer<Kind> Part(vtkImageData* whole, const Extent& extent, bool isAtZero = false)
{
  // Not by vtkExtractVOI, which moves the origin of oblique images in VTK 9.7.
  auto part = vtkSmartPointer<Kind>::New();
  part->ShallowCopy(whole);
  part->Crop(extent.data());
  if (isAtZero)
  {
    double first[3];
    part->GetPoint(0, first);
    part->SetOrigin(first);
    part->SetExtent(0, extent[1] - extent[0], 0, extent[3] - extent[2], 0, extent[5] - extent[4]);
  }
  return part;
}

/// Eight parts that share their points, cut at `cut` along each axis.
inline std::vector<Extent> Eight(int cut = N / 2)
{
  std::vector<Extent> parts;
  for (int part = 0; part < 8; ++part)
  {
    Extent extent;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const bool isHigh = (part >> axis & 1) != 0;
      extent[2 * axis] = isHigh ? cut : 0;
      extent[2 * axis + 1] = isHigh ? N - 1 : cut;
    }
    parts.push_back(extent);
  }
  return parts;
}

inline vtkSmartPointer<vtkMultiBlockDataSet> Blocks(
  vtkImageData* whole, const std::vector<Extent>& extents = Eight(), bool isAtZero = false)
{
  auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const Extent& extent : extents)
  {
    tree->SetBlock(tree->GetNumberOfBlocks(), Part(whole, extent, isAtZero));
  }
  return tree;
}

inline void ExpectSame(const std::string& what, vtkDataObject* blocks, vtkImageData* whole,
  const std::function<void(Scene&)>& arrange = {})
{
  Scene one(whole, { 60.0 }), several(nullptr, { 60.0 });
  several.Mapper->SetInputDataObject(blocks);
  for (Scene* scene : { &one, &several })
  {
    scene->Mapper->SetReuseAccuracyToPaper();
    if (arrange)
    {
      arrange(*scene);
    }
  }
  one.LookFrom(1.0, -2.0, 0.6);
  several.LookFrom(1.0, -2.0, 0.6);
  for (int i = 0; i < 6; ++i)
  {
    Expect(std::abs(one.Volume->GetBounds()[i] - several.Volume->GetBounds()[i]) < 1e-12,
      what + ": the bounds of all blocks");
  }
  for (const int mode :
    { vtkTemporalCoherenceVolumeMapper::CROSSING, vtkTemporalCoherenceVolumeMapper::THRESHOLD })
  {
    one.Mapper->SetSurfaceMode(mode);
    several.Mapper->SetSurfaceMode(mode);
    ::ExpectSame(what, several, one, Size);
    several.Renderer->GetActiveCamera()->Azimuth(2.0);
    ::ExpectSame(what + ", moved", several, one, Size);
    Expect(std::string(several.Mapper->GetStatistics()->GetRouteAsString()) == "ImageCache",
      what + ": what is not changed is used again");
    several.SetIsovalues({ 55.0 });
    one.SetIsovalues({ 55.0 });
    ::ExpectSame(what + ", another isovalue", several, one, Size);
  }
}

}

#endif
