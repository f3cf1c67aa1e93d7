// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Output/BufferImages.h"

#include "Scene/Parallel.h"
#include "Window/WindowPicture.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t RowGrain = 16;

/// Make an image with one value or tuple for each pixel.
/// \param valueOf is called with the position of the pixel in the planes, x and y
template <typename T, std::size_t Components, typename Values>
void WriteImage(const glm::ivec2& size, int scalarType, const char* name, const Values& valueOf,
  vtkImageData* image)
{
  vtkNew<vtkImageData> made;
  made->SetDimensions(size.x, size.y, 1);
  made->AllocateScalars(scalarType, static_cast<int>(Components));
  auto* const first =
    static_cast<std::array<T, Components>*>(made->GetPointData()->GetScalars()->GetVoidPointer(0));
  ParallelFor(size.y, RowGrain,
    [&](std::int64_t row)
    {
      std::int64_t pixel = row * size.x;
      for (int x = 0; x < size.x; ++x, ++pixel)
      {
        first[pixel] = valueOf(static_cast<std::size_t>(pixel), x, static_cast<int>(row));
      }
    });
  made->GetPointData()->GetScalars()->SetName(name);
  image->ShallowCopy(made);
}

/// Distance at which a ray leaves the box of the samples; infinity if it misses the box.
double EndAtBox(const Ray& ray, const FrameKey& key)
{
  const glm::dvec3 origin(key.Transform.IndexFromWorld * glm::dvec4(ray.Origin, 1.0));
  const glm::dvec3 direction(key.Transform.IndexFromWorld * glm::dvec4(ray.Direction, 0.0));
  double begin = 0.0, end = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = key.Samples.Dimensions[axis] - 1.0;
    if (direction[axis] == 0.0)
    {
      // A ray parallel to two faces is between them or misses the box.
      end = origin[axis] < 0.0 || origin[axis] > last ? -1.0 : end;
      continue;
    }
    const double a = (0.0 - origin[axis]) / direction[axis];
    const double b = (last - origin[axis]) / direction[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  const bool isInside =
    begin <= end && glm::all(glm::greaterThan(key.Samples.Dimensions, glm::ivec3(0)));
  return isInside ? end : std::numeric_limits<double>::infinity();
}

/// Convert a depth to a type: to a share of the largest integer, or to the floating-point number
/// itself.
template <typename T>
T NumberOf(float depth)
{
  if constexpr (std::is_integral_v<T>)
  {
    return static_cast<T>(std::lround(depth * static_cast<float>(std::numeric_limits<T>::max())));
  }
  else
  {
    return depth;
  }
}

}

void WriteColors(const Frame& frame, const FrameKey& key, vtkImageData* image)
{
  constexpr PixelColor white = { 255, 255, 255, 0 };
  WriteImage<unsigned char, 4>(
    frame.Size, VTK_UNSIGNED_CHAR, "Color",
    [&](std::size_t pixel, int x, int y)
    {
      const PixelColor& color = frame.ShownColors()[pixel];
      const bool isBeside = frame.Isovalues[pixel] == Frame::NoSurface && color[3] == 0 &&
        !std::isfinite(EndAtBox(key.View.RayThrough(x, y), key));
      return isBeside ? white : color;
    },
    image);
}

void WriteDepths(
  const Frame& frame, const FrameKey& key, int scalarType, bool endsAtBox, vtkImageData* image)
{
  const auto depthOf = [&](std::size_t pixel, int x, int y)
  {
    double t = frame.Depth[pixel];
    if (frame.Isovalues[pixel] == Frame::NoSurface && endsAtBox)
    {
      t = EndAtBox(key.View.RayThrough(x, y), key);
    }
    return std::isfinite(t) ? WindowDepthOf(key.View, { x, y }, t) : 1.0f;
  };
  const auto write = [&](auto zero, int type)
  {
    using T = decltype(zero);
    WriteImage<T, 1>(
      frame.Size, type, "Depth",
      [&](std::size_t pixel, int x, int y)
      { return std::array{ NumberOf<T>(depthOf(pixel, x, y)) }; },
      image);
  };
  switch (scalarType)
  {
    case VTK_UNSIGNED_CHAR:
      return write(static_cast<unsigned char>(0), scalarType);
    case VTK_UNSIGNED_SHORT:
      return write(static_cast<unsigned short>(0), scalarType);
    default:
      return write(0.0f, VTK_FLOAT);
  }
}

}
