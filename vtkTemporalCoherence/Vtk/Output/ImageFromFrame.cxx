// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Output/ImageFromFrame.h"

#include "Scene/Parallel.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t PixelGrain = 1 << 14;

struct ArrayFormat
{
  FrameArray Array;
  const char* Name;
  int Type, Components;
};

constexpr std::array<ArrayFormat, 5> Formats = { {
  { ColorArray, "Color", VTK_UNSIGNED_CHAR, 4 },
  { DepthArray, "Depth", VTK_FLOAT, 1 },
  { NormalsArray, "Normals", VTK_FLOAT, 3 },
  { IsovalueIndexArray, "IsovalueIndex", VTK_INT, 1 },
  { AnswerArray, "Answer", VTK_UNSIGNED_CHAR, 1 },
} };

/// The image's own array if it fits and nothing else refers to it, or a new one.
vtkSmartPointer<vtkDataArray> RoomIn(
  vtkImageData* image, const ArrayFormat& format, vtkIdType pixels)
{
  vtkDataArray* present = image->GetPointData()->GetArray(format.Name);
  if (present && present->GetReferenceCount() == 1 && present->HasStandardMemoryLayout() &&
    present->GetDataType() == format.Type &&
    present->GetNumberOfComponents() == format.Components && present->GetNumberOfTuples() == pixels)
  {
    return present;
  }
  auto made = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(format.Type));
  made->SetName(format.Name);
  made->SetNumberOfComponents(format.Components);
  made->SetNumberOfTuples(pixels);
  return made;
}

/// A new image with arrays to fill. The constructor takes all memory: the caller's image changes
/// only when nothing can fail any more.
class Target
{
public:
  Target(const FrameImage& wanted, const glm::ivec2& size)
    : Image(wanted.Image)
  {
    this->Made->SetDimensions(size.x, size.y, 1);
    vtkPointData* const data = this->Made->GetPointData();
    for (const ArrayFormat& format : Formats)
    {
      if (wanted.Arrays & format.Array)
      {
        const auto array = RoomIn(this->Image, format, this->Made->GetNumberOfPoints());
        data->AddArray(array);
        this->Arrays.push_back({ format.Array, array });
      }
    }
    if (!this->Arrays.empty())
    {
      data->SetActiveScalars(this->Arrays.front().Data->GetName());
    }
    if (wanted.Arrays & NormalsArray)
    {
      data->SetActiveNormals("Normals");
    }
  }

  /// Call write(array, its values) for each array.
  template <typename Writer>
  void ForEachArray(const Writer& write) const
  {
    for (const auto& array : this->Arrays)
    {
      write(array.Kind, array.Data->GetVoidPointer(0));
    }
  }

  void Return() const
  {
    for (const auto& array : this->Arrays)
    {
      array.Data->Modified();
    }
    this->Image->ShallowCopy(this->Made);
  }

private:
  struct ArrayToFill
  {
    FrameArray Kind;
    vtkSmartPointer<vtkDataArray> Data;
  };

  vtkImageData* Image;
  vtkNew<vtkImageData> Made;
  std::vector<ArrayToFill> Arrays;
};

/// Pixels of a frame, to be written into arrays.
struct PixelRange
{
  const Frame& From;
  const std::vector<int>& Places;
  std::int64_t Begin, End;

  void WriteTo(FrameArray array, void* values) const
  {
    switch (array)
    {
      case ColorArray:
        return this->Copy(this->From.ShownColors(), values);
      case DepthArray:
        return this->Convert(
          this->From.Depth, values, [](double t) { return static_cast<float>(t); });
      case NormalsArray:
        return this->Copy(this->From.Normals, values);
      case IsovalueIndexArray:
        return this->Convert(this->From.Isovalues, values,
          [this](SurfaceIndex surface)
          {
            return surface == Frame::NoSurface || this->Places.empty()
              ? -1
              : this->Places[static_cast<std::size_t>(surface)];
          });
      default:
        return this->Convert(this->From.Answers, values,
          [](Answer answer) { return static_cast<unsigned char>(answer); });
    }
  }

private:
  template <typename Value>
  void Copy(const Plane<Value>& plane, void* values) const
  {
    std::copy(plane.begin() + this->Begin, plane.begin() + this->End,
      static_cast<Value*>(values) + this->Begin);
  }

  template <typename Value, typename Conversion>
  void Convert(const Plane<Value>& plane, void* values, const Conversion& convert) const
  {
    using Converted = decltype(convert(plane[0]));
    std::transform(plane.begin() + this->Begin, plane.begin() + this->End,
      static_cast<Converted*>(values) + this->Begin, convert);
  }
};

}

void WriteImages(
  const Frame& frame, const std::vector<int>& places, const std::vector<FrameImage>& images)
{
  std::vector<Target> targets;
  for (const FrameImage& wanted : images)
  {
    if (wanted.Image)
    {
      targets.emplace_back(wanted, frame.Size);
    }
  }
  ParallelForRanges(static_cast<std::int64_t>(frame.Depth.size()), PixelGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      const PixelRange pixels{ frame, places, begin, end };
      for (const Target& target : targets)
      {
        target.ForEachArray([&](FrameArray array, void* values) { pixels.WriteTo(array, values); });
      }
    });
  for (const Target& target : targets)
  {
    target.Return();
  }
}

}
