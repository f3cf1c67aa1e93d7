// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFromFrame.h"

#include "Parallel.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t PixelGrain = 1 << 14;

/// True if an image has room for a picture and nobody else sees its scalars.
bool HasRoom(vtkImageData* image, const glm::ivec2& size, int type, int components)
{
  int extent[6];
  image->GetExtent(extent);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  return extent[0] == 0 && extent[1] == size.x - 1 && extent[2] == 0 && extent[3] == size.y - 1 &&
    extent[4] == 0 && extent[5] == 0 && scalars && scalars->GetReferenceCount() == 1 &&
    scalars->HasStandardMemoryLayout() && scalars->GetDataType() == type &&
    scalars->GetNumberOfComponents() == components &&
    scalars->GetNumberOfTuples() == image->GetNumberOfPoints();
}

/// The image itself if it has room, or a new one.
vtkSmartPointer<vtkImageData> Room(
  vtkImageData* image, const glm::ivec2& size, int type, int components)
{
  if (!image || HasRoom(image, size, type, components))
  {
    return image;
  }
  auto room = vtkSmartPointer<vtkImageData>::New();
  room->SetDimensions(size.x, size.y, 1);
  room->AllocateScalars(type, components);
  return room;
}

void Return(vtkImageData* written, vtkImageData* image)
{
  if (written == image)
  {
    image->SetOrigin(0.0, 0.0, 0.0);
    image->SetSpacing(1.0, 1.0, 1.0);
    image->GetPointData()->GetScalars()->Modified();
    image->Modified();
  }
  else
  {
    image->ShallowCopy(written);
  }
}

}

void WritePicture(const Frame& frame, vtkImageData* color, vtkImageData* depth)
{
  // All memory first: the caller's images are touched only when nothing can fail any more.
  const vtkSmartPointer<vtkImageData> colors = Room(color, frame.Size, VTK_UNSIGNED_CHAR, 4);
  const vtkSmartPointer<vtkImageData> depths = Room(depth, frame.Size, VTK_FLOAT, 1);
  auto* bytes = colors ? static_cast<unsigned char*>(colors->GetScalarPointer()) : nullptr;
  auto* distances = depths ? static_cast<float*>(depths->GetScalarPointer()) : nullptr;

  const auto pixels = static_cast<std::int64_t>(frame.Depth.size());
  ParallelFor((pixels + PixelGrain - 1) / PixelGrain, 1,
    [&](std::int64_t part)
    {
      const std::int64_t begin = part * PixelGrain;
      const std::int64_t end = std::min(begin + PixelGrain, pixels);
      if (bytes)
      {
        std::copy_n(frame.Colors[static_cast<std::size_t>(begin)].data(), 4 * (end - begin),
          bytes + 4 * begin);
      }
      if (distances)
      {
        std::transform(frame.Depth.begin() + begin, frame.Depth.begin() + end, distances + begin,
          [](double t) { return static_cast<float>(t); });
      }
    });
  if (color)
  {
    Return(colors, color);
  }
  if (depth)
  {
    Return(depths, depth);
  }
}

}
