// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/Changes.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>

#include <cmath>

namespace Fuzz
{
namespace Changes
{
namespace
{

/// A place in or near the volume, along an axis.
double Somewhere(World& world, int axis)
{
  double bounds[6];
  world.Subject->GetBounds(bounds);
  const double low = bounds[2 * axis], high = bounds[2 * axis + 1];
  if (!std::isfinite(low) || !std::isfinite(high) || low > high || world.From.IsWild())
  {
    return world.From.Number(-2.0, 8.0);
  }
  return low + world.From.Between(-0.1, 1.1) * (high - low);
}

void Crop(World& world)
{
  double planes[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    planes[2 * axis] = Somewhere(world, axis);
    planes[2 * axis + 1] = Somewhere(world, axis);
    if (planes[2 * axis] > planes[2 * axis + 1] && !world.From.OneIn(8))
    {
      std::swap(planes[2 * axis], planes[2 * axis + 1]);
    }
  }
  world.Subject->CroppingOn();
  world.Subject->SetCroppingRegionPlanes(planes);
  Story::Tell("  cropped: ", planes[0], " to ", planes[1], ", ", planes[2], " to ", planes[3], ", ",
    planes[4], " to ", planes[5]);
}

void CropFlags(World& world)
{
  Bytes& from = world.From;
  const int named[] = { VTK_CROP_SUBVOLUME, VTK_CROP_FENCE, VTK_CROP_INVERTED_FENCE, VTK_CROP_CROSS,
    VTK_CROP_INVERTED_CROSS, 0x7ffffff, 0x7ffffff ^ VTK_CROP_SUBVOLUME, 0 };
  const int flags = from.OneIn(3) ? from.Pick(0x8000000)
    : from.IsWild()               ? from.WildInt()
                                  : from.OneOf(named);
  world.Subject->SetCroppingRegionFlags(flags);
  Story::Tell("  cropping flags ", flags);
}

void NoCrop(World& world)
{
  world.Subject->CroppingOff();
  Story::Tell("  cropping off");
}

void Clip(World& world)
{
  Bytes& from = world.From;
  vtkNew<vtkPlane> plane;
  double origin[3], normal[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] = Somewhere(world, axis);
    normal[axis] = from.Number(-1.0, 1.0);
  }
  if (from.OneIn(6))
  {
    normal[from.Pick(3)] = 0.0;
    normal[from.Pick(3)] = 0.0;
  }
  plane->SetOrigin(origin);
  plane->SetNormal(normal);
  const int times = from.OneIn(50) ? 60 : 1;
  for (int i = 0; i < times; ++i)
  {
    world.Subject->AddClippingPlane(plane);
    if (times > 1)
    {
      vtkNew<vtkPlane> other;
      other->SetOrigin(origin[0] + 0.01 * i, origin[1], origin[2]);
      other->SetNormal(normal[0], normal[1] + 0.05 * i, normal[2]);
      world.Subject->AddClippingPlane(other);
    }
  }
  Story::Tell("  clipped at ", origin[0], ", ", origin[1], ", ", origin[2], " by ", normal[0], ", ",
    normal[1], ", ", normal[2], ", planes ", times);
}

/// A plane moves, without the mapper being told.
void MoveClip(World& world)
{
  vtkPlaneCollection* planes = world.Subject->GetClippingPlanes();
  const int many = planes ? planes->GetNumberOfItems() : 0;
  if (many > 0)
  {
    vtkPlane* plane = planes->GetItem(world.From.Pick(many));
    if (world.From.OneIn(2))
    {
      plane->SetOrigin(Somewhere(world, 0), Somewhere(world, 1), Somewhere(world, 2));
    }
    else
    {
      plane->SetNormal(world.From.Number(-1.0, 1.0), world.From.Number(-1.0, 1.0), 0.3);
    }
    Story::Tell("  a clipping plane moved");
  }
}

void NoClips(World& world)
{
  if (world.From.OneIn(2))
  {
    world.Subject->RemoveAllClippingPlanes();
  }
  else
  {
    world.Subject->SetClippingPlanes(static_cast<vtkPlaneCollection*>(nullptr));
  }
  Story::Tell("  no clipping planes");
}

void TurnVolume(World& world)
{
  vtkVolume* volume = world.Volume();
  const double x = world.From.Number(-40.0, 40.0), z = world.From.Number(-40.0, 40.0);
  volume->RotateX(x);
  volume->RotateZ(z);
  Story::Tell("  the volume turned by ", x, ", ", z);
}

void PlaceVolume(World& world)
{
  Bytes& from = world.From;
  vtkVolume* volume = world.Volume();
  volume->SetPosition(from.Number(-2.0, 2.0), from.Number(-2.0, 2.0), 0.0);
  volume->SetOrigin(0.0, from.Number(-2.0, 2.0), 0.0);
  Story::Tell("  the volume at ", volume->GetPosition()[0], ", ", volume->GetPosition()[1]);
}

/// Mirrored, flattened ...
void ScaleVolume(World& world)
{
  Bytes& from = world.From;
  double scale[3];
  for (double& along : scale)
  {
    along = from.OneIn(3) ? from.Number(0.5, 1.5) * (from.OneIn(3) ? -1.0 : 1.0) : 1.0;
  }
  world.Volume()->SetScale(scale);
  Story::Tell("  the volume's scale ", scale[0], ", ", scale[1], ", ", scale[2]);
}

/// ... sheared, projected.
void UserMatrix(World& world)
{
  Bytes& from = world.From;
  vtkNew<vtkMatrix4x4> matrix;
  const int kind = from.Pick(5);
  if (kind == 0)
  {
    world.Volume()->SetUserMatrix(nullptr);
    Story::Tell("  no user matrix");
    return;
  }
  const int last = from.IsWild() ? 4 : 3;
  for (int i = 0; i < kind; ++i)
  {
    const int row = from.Pick(last), column = from.Pick(4);
    matrix->SetElement(row, column, from.Number(-1.5, 1.5));
  }
  world.Volume()->SetUserMatrix(matrix);
  for (int row = 0; row < 4; ++row)
  {
    const double* m = matrix->GetData() + 4 * row;
    Story::Tell("    ", m[0], ' ', m[1], ' ', m[2], ' ', m[3]);
  }
}

void StraightVolume(World& world)
{
  vtkVolume* volume = world.Volume();
  volume->SetUserMatrix(nullptr);
  volume->SetScale(1.0);
  volume->SetPosition(0.0, 0.0, 0.0);
  volume->SetOrigin(0.0, 0.0, 0.0);
  volume->SetOrientation(0.0, 0.0, 0.0);
  Story::Tell("  the volume without a transform");
}

void OtherVolume(World& world)
{
  world.AtVolume = 1 - world.AtVolume;
  Story::Tell("  volume ", world.AtVolume);
}

}

const std::vector<ChangeKind>& OfRegion()
{
  // Anything, Sweep, Orbit, TimeSteps, Looks, Wrecks, Layers
  static const std::vector<ChangeKind> kinds = {
    { "cropping", { 4, 1, 1, 1, 1, 4, 1 }, Crop },
    { "cropping flags", { 3, 1, 1, 1, 1, 4, 1 }, CropFlags },
    { "no cropping", { 4, 2, 2, 2, 1, 3, 2 }, NoCrop },
    { "a clipping plane", { 4, 1, 1, 1, 1, 4, 1 }, Clip },
    { "a clipping plane moved", { 2, 1, 1, 1, 1, 4, 1 }, MoveClip },
    { "no clipping planes", { 3, 2, 2, 2, 1, 3, 2 }, NoClips },
  };
  return kinds;
}

const std::vector<ChangeKind>& OfTransform()
{
  static const std::vector<ChangeKind> kinds = {
    { "a turn of the volume", { 3, 1, 1, 1, 1, 2, 1 }, TurnVolume },
    { "a place of the volume", { 2, 0, 1, 0, 0, 3, 0 }, PlaceVolume },
    { "a scale of the volume", { 3, 1, 1, 1, 0, 4, 1 }, ScaleVolume },
    { "a user matrix", { 2, 1, 1, 1, 0, 6, 1 }, UserMatrix },
    { "no transform of the volume", { 2, 1, 1, 1, 1, 6, 1 }, StraightVolume },
    { "the other volume", { 2, 2, 2, 1, 2, 1, 2 }, OtherVolume },
  };
  return kinds;
}

}
}
