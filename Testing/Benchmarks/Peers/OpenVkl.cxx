// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenVkl.h"

#include "Measuring.h"

#include <openvkl/openvkl.h>

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkVector.h>
#if __has_include(<vtkVectorOperators.h>)
#include <vtkVectorOperators.h> // since VTK 9.6 they are in vtkVector.h
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <memory>
#include <vector>

namespace
{

constexpr int PacketSide = 4, PacketSize = PacketSide * PacketSide, TileSide = 16;
constexpr float Ambient = 0.1f, Diffuse = 0.7f, Specular = 0.2f;
constexpr int SpecularDoublings = 3; ///< a power of 8
constexpr float LeastPassed = 1.0f / 512.0f;

VKLDevice TheDevice()
{
  static const VKLDevice device = []
  {
    vklLoadModule("cpu_device");
    VKLDevice made = vklNewDevice("cpu");
    vklCommitDevice(made);
    return made;
  }();
  return device;
}

/// Open VKL's name of a type of samples; VKL_UNKNOWN if it has none.
VKLDataType TypeOf(int type)
{
  switch (type)
  {
    case VTK_UNSIGNED_CHAR:
      return VKL_UCHAR;
    case VTK_SHORT:
      return VKL_SHORT;
    case VTK_UNSIGNED_SHORT:
      return VKL_USHORT;
    case VTK_FLOAT:
      return VKL_FLOAT;
    case VTK_DOUBLE:
      return VKL_DOUBLE;
    default:
      return VKL_UNKNOWN;
  }
}

/// Rays of a view: from the eye, pixel (x, y) towards Corner + x Right + y Up.
struct PixelRays
{
  PixelRays(const Stage& stage)
  {
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    this->Eye = vtkVector3d(camera->GetPosition());
    const vtkVector3d forward(camera->GetDirectionOfProjection());
    vtkVector3d right = forward.Cross(vtkVector3d(camera->GetViewUp()));
    right.Normalize();
    const vtkVector3d up = right.Cross(forward);
    const double side = 2.0 * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
    this->Right = right * (side / stage.Size);
    this->Up = up * (side / stage.Size);
    this->Corner = forward + (this->Right + this->Up) * (0.5 * (1 - stage.Size));
    std::copy_n(stage.Image->GetBounds(), 6, this->Bounds.begin());
  }

  /// The unit direction through a pixel, and where the ray is within the box.
  vtkVector3d Through(int x, int y, double& enter, double& leave) const
  {
    vtkVector3d direction = this->Corner + this->Right * x + this->Up * y;
    direction.Normalize();
    enter = 0.0;
    leave = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 3; ++a)
    {
      const auto low = static_cast<std::size_t>(2 * a);
      const double t0 = (this->Bounds[low] - this->Eye[a]) / direction[a];
      const double t1 = (this->Bounds[low + 1] - this->Eye[a]) / direction[a];
      enter = std::max(enter, std::min(t0, t1));
      leave = std::min(leave, std::max(t0, t1));
    }
    return direction;
  }

  vtkVector3d Eye, Corner, Right, Up;
  std::array<double, 6> Bounds;
};

class Tracer final : public OpenVkl
{
public:
  Tracer(const Stage& stage, VKLVolume volume)
    : Volume(volume)
    , Sampler(vklNewSampler(volume))
    , Context(nullptr)
    , Color(4 * static_cast<std::size_t>(stage.Size) * static_cast<std::size_t>(stage.Size))
    , Depth(static_cast<std::size_t>(stage.Size) * static_cast<std::size_t>(stage.Size))
  {
    vklSetInt(this->Sampler, "filter", VKL_FILTER_TRILINEAR);
    vklSetInt(this->Sampler, "gradientFilter", VKL_FILTER_TRILINEAR);
    vklCommit(this->Sampler);
    this->Tracer::SetIsovalues({ stage.Isovalue() });
  }

  ~Tracer() override
  {
    vklRelease(this->Context);
    vklRelease(this->Sampler);
    vklRelease(this->Volume);
  }

  void SetIsovalues(const std::vector<double>& isovalues) override
  {
    if (this->Context)
    {
      vklRelease(this->Context);
    }
    this->Context = vklNewHitIteratorContext(this->Sampler);
    const std::vector<float> list(isovalues.begin(), isovalues.end());
    VKLData values =
      vklNewData(TheDevice(), list.size(), VKL_FLOAT, list.data(), VKL_DATA_DEFAULT, 0);
    vklSetData(this->Context, "values", values);
    vklRelease(values);
    vklCommit(this->Context);
  }

  void SetOpacity(double opacity) override { this->Opacity = static_cast<float>(opacity); }

  double Draw(const Stage& stage) override
  {
    return Measuring::TimeOf(
      [&]
      {
        this->Layers = 0;
        const PixelRays rays(stage);
        const int tiles = (stage.Size + TileSide - 1) / TileSide;
        vtkSMPTools::For(0, static_cast<vtkIdType>(tiles) * tiles, 1,
          [&](vtkIdType begin, vtkIdType end)
          {
            std::vector<char> room(vklGetHitIteratorSize16(this->Context) + Alignment);
            std::int64_t layers = 0;
            for (vtkIdType tile = begin; tile < end; ++tile)
            {
              layers += this->DrawTile(static_cast<int>(tile % tiles) * TileSide,
                static_cast<int>(tile / tiles) * TileSide, stage.Size, rays, room);
            }
            this->Layers += layers;
          });
      });
  }

  std::int64_t NumberOfLayers() const override { return this->Layers; }

  double PercentHit() const override
  {
    const auto hits = std::count_if(
      this->Depth.begin(), this->Depth.end(), [](float depth) { return std::isfinite(depth); });
    return 100.0 * static_cast<double>(hits) / static_cast<double>(this->Depth.size());
  }

private:
  static constexpr std::size_t Alignment = 64;

  /// 16 rays, and what they have met so far.
  struct Packet
  {
    vkl_vvec3f16 Origin, Direction;
    vkl_vrange1f16 Range;
    // Not a constant: a compiler of Open VKL's kernels has been seen to drop calls with one.
    alignas(Alignment) std::array<float, PacketSize> Times{};
    /// -1 for rays that go on, 0 for others.
    alignas(Alignment) std::array<int, PacketSize> Valid, Found{};
    std::array<float, PacketSize> Light{};  ///< that surfaces reflect
    std::array<float, PacketSize> Passed{}; ///< share of the light from behind
    std::array<float, PacketSize> Depth{};  ///< of the first surface
  };

  /// \return the number of surfaces shaded
  std::int64_t DrawTile(int x, int y, int size, const PixelRays& rays, std::vector<char>& room)
  {
    std::int64_t layers = 0;
    for (int j = y; j < std::min(y + TileSide, size); j += PacketSide)
    {
      for (int i = x; i < std::min(x + TileSide, size); i += PacketSide)
      {
        Packet packet;
        if (SetUp(i, j, size, rays, packet))
        {
          layers += this->Trace(packet, room);
        }
        this->Write(i, j, size, packet);
      }
    }
    return layers;
  }

  /// \return false if no ray meets the volume
  static bool SetUp(int x, int y, int size, const PixelRays& rays, Packet& packet)
  {
    packet.Passed.fill(1.0f);
    packet.Depth.fill(std::numeric_limits<float>::infinity());
    bool isAny = false;
    for (int k = 0; k < PacketSize; ++k)
    {
      const int i = x + k % PacketSide, j = y + k / PacketSide;
      double enter, leave;
      const vtkVector3d along = rays.Through(i, j, enter, leave);
      const bool isValid = i < size && j < size && enter < leave;
      packet.Valid[static_cast<std::size_t>(k)] = isValid ? -1 : 0;
      isAny = isAny || isValid;
      packet.Origin.x[k] = static_cast<float>(rays.Eye[0]);
      packet.Origin.y[k] = static_cast<float>(rays.Eye[1]);
      packet.Origin.z[k] = static_cast<float>(rays.Eye[2]);
      packet.Direction.x[k] = static_cast<float>(along[0]);
      packet.Direction.y[k] = static_cast<float>(along[1]);
      packet.Direction.z[k] = static_cast<float>(along[2]);
      packet.Range.lower[k] = static_cast<float>(enter);
      packet.Range.upper[k] = static_cast<float>(leave);
    }
    return isAny;
  }

  /// Hit after hit, until no light passes.
  /// \return the number of hits
  std::int64_t Trace(Packet& packet, std::vector<char>& room) const
  {
    void* buffer = room.data();
    std::size_t space = room.size();
    std::align(Alignment, space - Alignment, buffer, space);
    VKLHitIterator16 iterator = vklInitHitIterator16(packet.Valid.data(), this->Context,
      &packet.Origin, &packet.Direction, &packet.Range, packet.Times.data(), buffer);
    VKLHit16 hit{};
    std::int64_t layers = 0;
    for (bool isOpen = true; isOpen;)
    {
      vklIterateHit16(packet.Valid.data(), iterator, &hit, packet.Found.data());
      int hits = 0;
      for (std::size_t k = 0; k < PacketSize; ++k)
      {
        packet.Found[k] = packet.Valid[k] != 0 && packet.Found[k] != 0 ? -1 : 0;
        hits -= packet.Found[k];
      }
      layers += hits;
      isOpen = hits > 0 && this->Shade(packet, hit);
    }
    return layers;
  }

  /// Composite hits.
  /// \return true if rays go on
  bool Shade(Packet& packet, const VKLHit16& hit) const
  {
    vkl_vvec3f16 point{}, gradient{};
    for (int k = 0; k < PacketSize; ++k)
    {
      point.x[k] = packet.Origin.x[k] + hit.t[k] * packet.Direction.x[k];
      point.y[k] = packet.Origin.y[k] + hit.t[k] * packet.Direction.y[k];
      point.z[k] = packet.Origin.z[k] + hit.t[k] * packet.Direction.z[k];
    }
    vklComputeGradient16(
      packet.Found.data(), this->Sampler, &point, &gradient, 0, packet.Times.data());
    bool isOpen = false;
    for (std::size_t k = 0; k < PacketSize; ++k)
    {
      if (packet.Found[k] == 0)
      {
        packet.Valid[k] = 0;
        continue;
      }
      const float along = gradient.x[k] * packet.Direction.x[k] +
        gradient.y[k] * packet.Direction.y[k] + gradient.z[k] * packet.Direction.z[k];
      const float length = std::sqrt(gradient.x[k] * gradient.x[k] + gradient.y[k] * gradient.y[k] +
        gradient.z[k] * gradient.z[k]);
      const float facing = std::abs(along) / std::max(length, 1e-20f);
      float shine = facing;
      for (int doubling = 0; doubling < SpecularDoublings; ++doubling)
      {
        shine *= shine;
      }
      packet.Depth[k] = packet.Passed[k] == 1.0f ? hit.t[k] : packet.Depth[k];
      packet.Light[k] += packet.Passed[k] * this->Opacity *
        std::min(1.0f, Ambient + Diffuse * facing + Specular * shine);
      packet.Passed[k] *= 1.0f - this->Opacity;
      packet.Valid[k] = packet.Passed[k] > LeastPassed ? -1 : 0;
      isOpen = isOpen || packet.Valid[k] != 0;
    }
    return isOpen;
  }

  void Write(int x, int y, int size, const Packet& packet)
  {
    for (int k = 0; k < PacketSize; ++k)
    {
      const int i = x + k % PacketSide, j = y + k / PacketSide;
      if (i >= size || j >= size)
      {
        continue;
      }
      const auto ray = static_cast<std::size_t>(k);
      const std::size_t pixel =
        static_cast<std::size_t>(j) * static_cast<std::size_t>(size) + static_cast<std::size_t>(i);
      this->Depth[pixel] = packet.Depth[ray];
      const float light = 255.0f * packet.Light[ray];
      const float passed = packet.Passed[ray] > LeastPassed ? packet.Passed[ray] : 0.0f;
      std::uint8_t* const color = this->Color.data() + 4 * pixel;
      color[0] = static_cast<std::uint8_t>(0.9f * light);
      color[1] = static_cast<std::uint8_t>(0.8f * light);
      color[2] = static_cast<std::uint8_t>(0.7f * light);
      color[3] = static_cast<std::uint8_t>(255.0f * (1.0f - passed));
    }
  }

  VKLVolume Volume;
  VKLSampler Sampler;
  VKLHitIteratorContext Context;
  float Opacity = 1.0f;
  std::vector<std::uint8_t> Color;
  std::vector<float> Depth;
  std::atomic<std::int64_t> Layers{ 0 };
};

}

std::vector<std::string> OpenVkl::Kinds()
{
  return { "structuredRegular", "structuredRegularGrid" };
}

std::unique_ptr<OpenVkl> OpenVkl::Make(const Stage& stage, const std::string& kind)
{
  vtkDataArray* samples = stage.Image->GetPointData()->GetScalars();
  const VKLDataType type = TypeOf(samples->GetDataType());
  if (type == VKL_UNKNOWN || samples->GetNumberOfComponents() != 1)
  {
    std::cerr << "Open VKL is left out: it has no samples of type "
              << samples->GetDataTypeAsString() << ".\n";
    return nullptr;
  }
  VKLVolume volume = vklNewVolume(TheDevice(), kind.c_str());
  if (!volume)
  {
    return nullptr;
  }
  const int* dimensions = stage.Image->GetDimensions();
  const double *spacing = stage.Image->GetSpacing(), *bounds = stage.Image->GetBounds();
  vklSetVec3i(volume, "dimensions", dimensions[0], dimensions[1], dimensions[2]);
  vklSetVec3f(volume, "gridOrigin", static_cast<float>(bounds[0]), static_cast<float>(bounds[2]),
    static_cast<float>(bounds[4]));
  vklSetVec3f(volume, "gridSpacing", static_cast<float>(spacing[0]), static_cast<float>(spacing[1]),
    static_cast<float>(spacing[2]));
  VKLData data = vklNewData(TheDevice(), static_cast<std::size_t>(samples->GetNumberOfTuples()),
    type, samples->GetVoidPointer(0), VKL_DATA_SHARED_BUFFER, 0);
  vklSetData(volume, "data", data);
  vklRelease(data);
  vklCommit(volume);
  return std::make_unique<Tracer>(stage, volume);
}
