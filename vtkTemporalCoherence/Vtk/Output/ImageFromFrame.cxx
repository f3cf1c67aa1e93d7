// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Output/ImageFromFrame.h"

#include "Scene/Parallel.h"

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

/// An image on its way to be filled.
struct Target
{
  /// All memory is taken here: the caller's image is touched only when nothing can fail any more.
  Target(vtkImageData* image, const glm::ivec2& size, int type, int components, const char* name)
    : Image(image)
    , Written(Room(image, size, type, components))
    , Name(name)
  {
  }

  /// First value of a pixel's; null if there is no image.
  template <typename T>
  T* At(std::int64_t pixel) const
  {
    vtkDataArray* scalars = this->Written ? this->Written->GetPointData()->GetScalars() : nullptr;
    return scalars
      ? static_cast<T*>(scalars->GetVoidPointer(0)) + pixel * scalars->GetNumberOfComponents()
      : nullptr;
  }

  void Return() const
  {
    if (!this->Image)
    {
      return;
    }
    this->Written->GetPointData()->GetScalars()->SetName(this->Name);
    if (this->Written == this->Image)
    {
      this->Image->SetOrigin(0.0, 0.0, 0.0);
      this->Image->SetSpacing(1.0, 1.0, 1.0);
      this->Image->GetPointData()->GetScalars()->Modified();
      this->Image->Modified();
    }
    else
    {
      this->Image->ShallowCopy(this->Written);
    }
  }

  vtkImageData* Image;
  vtkSmartPointer<vtkImageData> Written;
  const char* Name;
};

}

void WritePicture(const Frame& frame, const std::vector<int>& places, const PictureImages& images)
{
  const glm::ivec2 size = frame.Size;
  const Target colors(images.Color, size, VTK_UNSIGNED_CHAR, 4, "Color");
  const Target depths(images.Depth, size, VTK_FLOAT, 1, "Depth");
  const Target normals(images.Normals, size, VTK_FLOAT, 3, "Normals");
  const Target isovalues(images.Isovalues, size, VTK_INT, 1, "IsovalueIndex");
  const Target answers(images.Answers, size, VTK_UNSIGNED_CHAR, 1, "Answer");
  const auto placeOf = [&](std::int16_t surface)
  { return surface == Frame::NoSurface ? -1 : places[static_cast<std::size_t>(surface)]; };

  const auto pixels = static_cast<std::int64_t>(frame.Depth.size());
  ParallelForRanges(pixels, PixelGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      if (auto* bytes = colors.At<unsigned char>(begin))
      {
        std::copy_n(frame.Colors[static_cast<std::size_t>(begin)].data(), 4 * (end - begin), bytes);
      }
      if (auto* distances = depths.At<float>(begin))
      {
        std::transform(frame.Depth.begin() + begin, frame.Depth.begin() + end, distances,
          [](double t) { return static_cast<float>(t); });
      }
      if (auto* vectors = normals.At<float>(begin))
      {
        for (std::int64_t pixel = begin; pixel < end; ++pixel, vectors += 3)
        {
          const glm::vec3& normal = frame.Normals[static_cast<std::size_t>(pixel)];
          std::copy_n(&normal.x, 3, vectors);
        }
      }
      if (auto* indices = isovalues.At<int>(begin))
      {
        std::transform(
          frame.Isovalues.begin() + begin, frame.Isovalues.begin() + end, indices, placeOf);
      }
      if (auto* numbers = answers.At<unsigned char>(begin))
      {
        std::transform(frame.Answers.begin() + begin, frame.Answers.begin() + end, numbers,
          [](Answer answer) { return static_cast<unsigned char>(answer); });
      }
    });
  for (const Target* target : { &colors, &depths, &normals, &isovalues, &answers })
  {
    target->Return();
  }
}

}
