// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Oracle/Picture.h"

#include "Checks/AreIdentical.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace Fuzz
{
namespace
{

template <typename T>
const T* DataOf(const Picture& picture, const char* array)
{
  vtkDataArray* data = picture.Frame->GetPointData()->GetArray(array);
  return data ? static_cast<const T*>(data->GetVoidPointer(0)) : nullptr;
}

/// Where an array of two pictures of a size first differs, and in how many pixels.
template <typename T>
std::string FirstOf(const char* array, const Picture& a, const Picture& b)
{
  const int components = a.Frame->GetPointData()->GetArray(array)->GetNumberOfComponents();
  const T* here = DataOf<T>(a, array);
  const T* there = DataOf<T>(b, array);
  std::ostringstream text;
  text.precision(17);
  int count = 0;
  for (vtkIdType pixel = 0; pixel < a.CountPixels(); ++pixel)
  {
    const vtkIdType first = pixel * components;
    if (std::memcmp(
          here + first, there + first, sizeof(T) * static_cast<std::size_t>(components)) != 0 &&
      ++count == 1)
    {
      const int width = a.Frame->GetDimensions()[0];
      text << array << " differs at (" << pixel % width << ", " << pixel / width << "):";
      for (int c = 0; c < components; ++c)
      {
        text << ' ' << +here[first + c] << " for " << +there[first + c];
      }
    }
  }
  if (count > 0)
  {
    text << ", and " << count - 1 << " more; ";
  }
  return text.str();
}

}

bool Picture::Render(World& world, Mapper* mapper)
{
  this->IsBlended = mapper->GetBlendMode() != Mapper::ISOSURFACE_BLEND;
  return mapper->MakeImage(
    world.Renderer(), world.Volume(), world.Width, world.Height, this->Frame);
}

bool Picture::Fetch(Mapper* mapper)
{
  return mapper->GetLastFrame(this->Frame);
}

void Picture::Copy(const Picture& other)
{
  this->Frame->DeepCopy(other.Frame);
  this->IsBlended = other.IsBlended;
}

int Picture::IsovalueAt(int x, int y) const
{
  return DataOf<int>(*this, "IsovalueIndex")[y * this->Frame->GetDimensions()[0] + x];
}

vtkIdType Picture::CountHits() const
{
  vtkIdType hits = 0;
  for (vtkIdType i = 0; i < this->CountPixels(); ++i)
  {
    hits += this->IsHit(i);
  }
  return hits;
}

bool Picture::IsHit(vtkIdType pixel) const
{
  const unsigned char* color = DataOf<unsigned char>(*this, "Color") + 4 * pixel;
  // Labels may be below 0, and a distance may be too large for a float.
  return this->IsBlended ? std::any_of(color, color + 4, [](unsigned char c) { return c > 0; })
                         : DataOf<int>(*this, "IsovalueIndex")[pixel] != -1 ||
      std::isfinite(DataOf<float>(*this, "Depth")[pixel]);
}

std::string Picture::Difference(const Picture& other, bool inColors, bool inNormals) const
{
  int here[3], there[3];
  this->Frame->GetDimensions(here);
  other.Frame->GetDimensions(there);
  if (here[0] != there[0] || here[1] != there[1])
  {
    return "the sizes differ; ";
  }
  std::string text =
    FirstOf<float>("Depth", *this, other) + FirstOf<int>("IsovalueIndex", *this, other);
  if (inColors)
  {
    text += FirstOf<unsigned char>("Color", *this, other);
  }
  if (inNormals)
  {
    text += FirstOf<float>("Normals", *this, other);
  }
  return text;
}

vtkIdType Picture::CountDifferent(const Picture& other, double apart) const
{
  const float* here = DataOf<float>(*this, "Depth");
  const float* there = DataOf<float>(other, "Depth");
  vtkIdType different = 0;
  for (vtkIdType i = 0; i < this->CountPixels(); ++i)
  {
    const bool isHit = std::isfinite(here[i]);
    const bool isFar = isHit && static_cast<double>(std::abs(here[i] - there[i])) > apart;
    different += isHit != std::isfinite(there[i]) || isFar;
  }
  return different;
}

std::string Picture::Nonsense(std::optional<int> isovalues, bool isTame) const
{
  const float* depths = DataOf<float>(*this, "Depth");
  const float* normals = DataOf<float>(*this, "Normals");
  const int* indices = DataOf<int>(*this, "IsovalueIndex");
  const unsigned char* colors = DataOf<unsigned char>(*this, "Color");
  const unsigned char* answers = DataOf<unsigned char>(*this, "Answer");
  for (vtkIdType i = 0; i < this->CountPixels(); ++i)
  {
    const float* n = normals + 3 * i;
    const unsigned char* c = colors + 4 * i;
    const bool isHit = this->IsHit(i);
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const bool isIndex = !isovalues ||
      (indices[i] >= -1 && indices[i] < (this->IsBlended ? 0 : *isovalues) &&
        (this->IsBlended || isHit == (indices[i] >= 0)));
    const bool isDepth = !std::isnan(depths[i]) && (!std::isfinite(depths[i]) || isHit) &&
      (std::isfinite(depths[i]) || !isHit || !isTame);
    // Blended volumes have a normal where their gradient tells one.
    const bool mayBeNone = !isHit || this->IsBlended;
    const bool isNormal =
      (isHit && std::abs(length - 1.0f) < 1e-3f) || (mayBeNone && length == 0.0f);
    const bool isColor = isHit ? std::max({ c[0], c[1], c[2] }) <= c[3] || !isTame
                               : c[0] == 0 && c[1] == 0 && c[2] == 0 && c[3] == 0;
    if (!isIndex || !isDepth || !isNormal || !isColor || answers[i] > 2)
    {
      std::ostringstream text;
      text << "pixel " << i << " has isovalue " << indices[i] << ", depth " << depths[i]
           << ", normal " << n[0] << ' ' << n[1] << ' ' << n[2] << ", colour " << +c[0] << ' '
           << +c[1] << ' ' << +c[2] << ' ' << +c[3] << ", answer " << +answers[i];
      return text.str();
    }
  }
  return {};
}

}
