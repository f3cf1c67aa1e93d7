// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/Changes.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPerspectiveTransform.h>
#include <vtkTransform.h>

#include <algorithm>

namespace Fuzz
{
namespace Changes
{
namespace
{

void PlaceCamera(World& world)
{
  Bytes& from = world.From;
  const double x = from.Between(-1.0, 1.0), y = from.Between(-1.0, 1.0);
  world.LookFrom(x, y, from.OneIn(6) ? 0.0 : from.Between(-1.0, 1.0));
}

void LookAlongAxis(World& world)
{
  const int axis = world.From.Pick(6);
  const double sign = axis < 3 ? 1.0 : -1.0;
  world.LookFrom(
    axis % 3 == 0 ? sign : 0.0, axis % 3 == 1 ? sign : 0.0, axis % 3 == 2 ? sign : 0.0);
}

/// As people turn volumes.
void Turn(World& world)
{
  vtkCamera* camera = world.Camera();
  const double steps[] = { 1.0, 3.0, 0.1, 10.0, 45.0 };
  const double azimuth = world.From.OneOf(steps) * world.From.Between(-1.0, 1.0);
  const double elevation = world.From.OneOf(steps) * world.From.Between(-1.0, 1.0);
  camera->Azimuth(azimuth);
  camera->Elevation(elevation);
  camera->OrthogonalizeViewUp();
  world.Renderer()->ResetCameraClippingRange();
  Story::Tell("  turned by ", azimuth, ", ", elevation);
}

void Approach(World& world)
{
  const double factors[] = { 1.05, 0.95, 1.5, 0.7, 3.0, 0.2, 20.0 };
  const double factor = world.From.IsWild() ? world.From.Wild() : world.From.OneOf(factors);
  vtkCamera* camera = world.Camera();
  if (world.From.OneIn(2))
  {
    camera->Zoom(factor);
  }
  else
  {
    camera->Dolly(factor);
  }
  if (!world.From.OneIn(5))
  {
    world.Renderer()->ResetCameraClippingRange();
  }
  Story::Tell("  nearer by ", factor);
}

void Shift(World& world)
{
  Bytes& from = world.From;
  vtkCamera* camera = world.Camera();
  double p[3], f[3];
  camera->GetPosition(p);
  camera->GetFocalPoint(f);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double shift = from.Number(-1.0, 1.0);
    p[axis] += shift;
    f[axis] += shift;
  }
  camera->SetPosition(p);
  camera->SetFocalPoint(f);
  Story::Tell("  shifted to ", p[0], ", ", p[1], ", ", p[2]);
}

void Place(World& world)
{
  Bytes& from = world.From;
  vtkCamera* camera = world.Camera();
  const double sizes[] = { 10.0, 1.0, 100.0, 1e4, 1e7 };
  const double size = from.OneOf(sizes);
  double p[3], f[3], up[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = from.Number(-size, size);
    f[axis] = from.Number(-5.0, 5.0);
    up[axis] = from.Number(-1.0, 1.0);
  }
  if (from.IsWild())
  {
    std::copy_n(p, 3, f);
  }
  camera->SetPosition(p);
  camera->SetFocalPoint(f);
  if (from.OneIn(3))
  {
    camera->SetViewUp(up);
  }
  if (!from.OneIn(4))
  {
    world.Renderer()->ResetCameraClippingRange();
  }
  Story::Tell(
    "  camera at ", p[0], ", ", p[1], ", ", p[2], " looks to ", f[0], ", ", f[1], ", ", f[2]);
}

/// Into the volume, through a wide lens.
void GoInside(World& world)
{
  vtkCamera* camera = world.Camera();
  double f[3];
  camera->GetFocalPoint(f);
  camera->SetPosition(
    f[0] + world.From.Between(-1.0, 1.0), f[1] + world.From.Between(0.1, 1.0), f[2]);
  camera->SetClippingRange(0.01, 100.0);
  Story::Tell("  inside");
}

void ChangeLens(World& world)
{
  Bytes& from = world.From;
  vtkCamera* camera = world.Camera();
  switch (from.Pick(from.Wildness > 0 ? 9 : 3))
  {
    case 0:
      camera->SetParallelProjection(1 - camera->GetParallelProjection());
      break;
    case 1:
      camera->SetViewAngle(from.Number(5.0, 120.0));
      break;
    case 2:
      camera->SetParallelScale(from.Number(1.0, 12.0));
      break;
    case 3:
      camera->SetWindowCenter(from.Number(-1.0, 1.0), from.Number(-1.0, 1.0));
      break;
    case 4:
      camera->SetViewShear(from.Number(-1.0, 1.0), from.Number(-1.0, 1.0), from.Number(0.0, 1.0));
      break;
    case 5:
      camera->SetUseHorizontalViewAngle(from.Pick(2));
      break;
    case 6:
      camera->SetEyeAngle(from.Number(0.0, 10.0));
      camera->SetLeftEye(from.Pick(2));
      break;
    case 7:
      camera->SetUseOffAxisProjection(from.Pick(2));
      camera->SetScreenBottomLeft(-1.0, -1.0, -from.Number(0.5, 2.0));
      break;
    default:
      camera->SetViewShear(0.0, 0.0, 1.0);
      camera->SetWindowCenter(0.0, 0.0);
      break;
  }
  Story::Tell("  lens: parallel ", camera->GetParallelProjection(), ", angle ",
    camera->GetViewAngle(), ", scale ", camera->GetParallelScale());
}

void ChangeRange(World& world)
{
  Bytes& from = world.From;
  vtkCamera* camera = world.Camera();
  double range[2];
  camera->GetClippingRange(range);
  const double length = range[1] - range[0];
  switch (from.Pick(5))
  {
    case 0:
      world.Renderer()->ResetCameraClippingRange();
      break;
    case 1:
      camera->SetClippingRange(range[0] + from.Between(0.0, 0.7) * length, range[1]);
      break;
    case 2:
      camera->SetClippingRange(range[0], range[1] - from.Between(0.0, 0.7) * length);
      break;
    default:
    {
      const double low = from.Number(0.01, 20.0);
      camera->SetClippingRange(low, from.Number(0.0, 60.0));
      break;
    }
  }
  camera->GetClippingRange(range);
  Story::Tell("  clipping range ", range[0], " to ", range[1]);
}

/// What few users know that cameras have.
void Transform(World& world)
{
  Bytes& from = world.From;
  vtkCamera* camera = world.Camera();
  if (!from.IsWild())
  {
    camera->SetUserViewTransform(nullptr);
    camera->SetUserTransform(nullptr);
    camera->SetUseExplicitProjectionTransformMatrix(false);
    camera->SetModelTransformMatrix(vtkNew<vtkMatrix4x4>());
    Story::Tell("  no transforms of the camera");
    return;
  }
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 3; ++i)
  {
    matrix->SetElement(from.Pick(4), from.Pick(4), from.Number(-1.5, 1.5));
  }
  const int kind = from.Pick(4);
  if (kind == 0)
  {
    vtkNew<vtkTransform> transform;
    transform->SetMatrix(matrix);
    camera->SetUserViewTransform(transform);
  }
  else if (kind == 1)
  {
    vtkNew<vtkPerspectiveTransform> transform;
    transform->SetMatrix(matrix);
    camera->SetUserTransform(transform);
  }
  else if (kind == 2)
  {
    camera->SetExplicitProjectionTransformMatrix(matrix);
    camera->UseExplicitProjectionTransformMatrixOn();
  }
  else
  {
    camera->SetModelTransformMatrix(matrix);
  }
  Story::Tell("  a transform of the camera, kind ", kind);
  for (int row = 0; row < 4; ++row)
  {
    const double* m = matrix->GetData() + 4 * row;
    Story::Tell("    ", m[0], ' ', m[1], ' ', m[2], ' ', m[3]);
  }
}

void Resize(World& world)
{
  Bytes& from = world.From;
  world.Width = 8 + from.Pick(33);
  world.Height = 8 + from.Pick(33);
  if (from.OneIn(60))
  {
    const int widths[] = { 4096, 1, 200, 1, 65, 1023 }, heights[] = { 1, 4096, 150, 1, 2, 7 };
    const int which = from.Pick(6);
    world.Width = widths[which];
    world.Height = heights[which];
  }
  if (from.IsWild())
  {
    // Too few pixels, or too many.
    const int widths[] = { 0, -1, 1 << 30, 65536 }, heights[] = { 1, 0, 7, 65536 };
    world.Width = from.OneOf(widths);
    world.Height = from.OneOf(heights);
    world.Height = world.Width > 4096 ? 65536 : world.Height == 65536 ? 3 : world.Height;
  }
  Story::Tell("  ", world.Width, " x ", world.Height, " pixels");
}

void NewCamera(World& world)
{
  if (world.From.OneIn(3))
  {
    world.Renderer()->SetActiveCamera(nullptr); // the renderer makes one when it is asked for it
    return;
  }
  world.Renderer()->SetActiveCamera(vtkSmartPointer<vtkCamera>::New());
  world.LookFrom(1.0, -0.7, 0.4);
}

void OtherRenderer(World& world)
{
  world.AtRenderer = 1 - world.AtRenderer;
  Story::Tell("  renderer ", world.AtRenderer);
}

}

const std::vector<ChangeKind>& OfCamera()
{
  // Anything, Sweep, Orbit, TimeSteps, Looks, Wrecks, Layers
  static const std::vector<ChangeKind> kinds = {
    { "a look", { 4, 2, 4, 1, 1, 6, 3 }, PlaceCamera },
    { "a look along an axis", { 2, 1, 2, 1, 0, 2, 1 }, LookAlongAxis },
    { "a turn", { 10, 1, 60, 2, 2, 2, 8 }, Turn },
    { "nearer", { 5, 0, 12, 1, 0, 4, 0 }, Approach },
    { "a shift", { 5, 0, 12, 1, 0, 4, 0 }, Shift },
    { "another place", { 2, 0, 2, 0, 0, 12, 0 }, Place },
    { "inside", { 1, 1, 2, 0, 0, 2, 1 }, GoInside },
    { "the lens", { 3, 1, 4, 1, 1, 10, 1 }, ChangeLens },
    { "the clipping range", { 3, 1, 4, 1, 0, 8, 1 }, ChangeRange },
    { "transforms of the camera", { 1, 0, 1, 0, 0, 4, 0 }, Transform },
    { "the size of the picture", { 3, 1, 2, 1, 1, 6, 1 }, Resize },
    { "a new camera", { 1, 0, 1, 0, 0, 1, 0 }, NewCamera },
    { "the other renderer", { 2, 2, 2, 1, 2, 1, 2 }, OtherRenderer },
  };
  return kinds;
}

}
}
