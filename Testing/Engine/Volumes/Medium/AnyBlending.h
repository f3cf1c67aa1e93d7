// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_AnyBlending_h
#define Testing_AnyBlending_h

#include "BlendCase.h"
#include "Lattice/Coordinates.h"
#include "Scene/HiddenCells.h"
#include "Scene/LabelSets.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// A blended volume of anything that the engine takes, by a seed: any type, kind of cells, number
/// of components, functions, materials, lights, transform, region and camera.
class AnyBlending
{
public:
  /// \param hasLabels parts of a volume of one component have looks of their own
  explicit AnyBlending(unsigned int seed, bool hasLabels = false)
    : Random(seed)
  {
    this->Size = { this->Edge(), this->Edge(), this->Edge() };
    const int components = this->OneOf({ 1, 1, 1, 2, 2, 3, 4, 4 });
    this->MakeSamples(components);
    this->MakeKind();
    this->MakeVolume(components);
    this->MakePlace();
    this->MakeView();
    this->MakeRegion();
    this->MakeLights();
    if (this->Chance(0.2))
    {
      this->Key.Appearance.ColorScale = this->Real(-0.5, 3.0);
      this->Key.Appearance.ColorShift = this->Real(-0.5, 0.5);
    }
    if (hasLabels && components == 1)
    {
      this->MakeLabels();
    }
  }
  AnyBlending(const AnyBlending&) = delete;
  void operator=(const AnyBlending&) = delete;

  /// What is drawn, in words.
  std::string Story() const { return this->Words.str(); }

  TemporalCoherence::FrameKey Key;
  std::shared_ptr<const TemporalCoherence::GridCoordinates> Coordinates; ///< null: integers

private:
  double Real(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  int Whole(int low, int high)
  {
    return std::uniform_int_distribution<int>(low, high)(this->Random);
  }
  bool Chance(double share) { return this->Real(0.0, 1.0) < share; }
  template <typename T>
  T OneOf(std::initializer_list<T> all)
  {
    return *(all.begin() + this->Whole(0, static_cast<int>(all.size()) - 1));
  }
  int Edge() { return this->Chance(0.15) ? 2 : this->Whole(3, 13); }
  glm::dvec3 Direction()
  {
    glm::dvec3 direction(0.0);
    do
    {
      direction = { this->Real(-1.0, 1.0), this->Real(-1.0, 1.0), this->Real(-1.0, 1.0) };
    } while (glm::length(direction) < 0.1);
    return glm::normalize(direction);
  }

  /// Values of a type, smooth or not, some of them equal.
  template <typename T>
  void FillSamples(int components, const glm::dvec2& range)
  {
    const std::size_t count = static_cast<std::size_t>(this->Size.x) *
      static_cast<std::size_t>(this->Size.y) * static_cast<std::size_t>(this->Size.z) *
      static_cast<std::size_t>(components);
    this->Bytes.resize(count * sizeof(T));
    T* const samples = reinterpret_cast<T*>(this->Bytes.data());
    const int shape = this->Whole(0, 3);
    this->HasHoles = std::is_floating_point_v<T> && this->Chance(0.3);
    const double holes = this->HasHoles ? 0.02 : 0.0;
    const glm::dvec3 wave(this->Real(0.1, 1.5), this->Real(0.1, 1.5), this->Real(0.1, 1.5));
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto at = static_cast<int>(i / static_cast<std::size_t>(components));
      const glm::dvec3 place(
        at % this->Size.x, at / this->Size.x % this->Size.y, at / this->Size.x / this->Size.y);
      const auto phase = static_cast<double>(i % static_cast<std::size_t>(components));
      const double smooth = 0.5 + 0.5 * std::sin(glm::dot(wave, place) + 1.7 * phase);
      const double share = shape == 0 ? this->Real(0.0, 1.0)
        : shape == 1                  ? smooth
        : shape == 2                  ? std::floor(4.0 * smooth) / 4.0
                                      : (this->Chance(0.1) ? 1.0 : 0.0);
      samples[i] = static_cast<T>(range.x + (range.y - range.x) * share);
      if (this->Chance(holes))
      {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        samples[i] = static_cast<T>(this->OneOf({ std::nan(""), infinity, -infinity }));
      }
    }
    this->Range = range;
  }

  void MakeSamples(int components)
  {
    using TemporalCoherence::ScalarType;
    const auto type = static_cast<ScalarType>(this->Whole(0, 9));
    TemporalCoherence::DispatchScalarType(type,
      [&](auto sample)
      {
        using T = decltype(sample);
        glm::dvec2 range(std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max());
        if (sizeof(T) > 2)
        {
          const double scale = std::is_floating_point_v<T> ? this->OneOf({ 1e-6, 1.0, 1e5, 1e10 })
                                                           : this->OneOf({ 10.0, 1e4, 1e8 });
          const double low = std::is_signed_v<T> ? this->OneOf({ -0.5, 0.0, 3.0 }) * scale : 0.0;
          range = { low, low + scale };
        }
        this->FillSamples<T>(components, range);
      });
    auto& field = this->Key.Samples;
    field.Samples = this->Bytes.data();
    field.Type = type;
    field.Dimensions = this->Size;
    field.Strides = { components, components * this->Size.x,
      static_cast<std::int64_t>(components) * this->Size.x * this->Size.y };
    field.Stamp = 1;
    this->Words << "type " << static_cast<int>(type) << ", " << this->Size.x << " x "
                << this->Size.y << " x " << this->Size.z << ", " << components << " components";
  }

  void MakeKind()
  {
    auto& field = this->Key.Samples;
    if (this->Chance(0.3))
    {
      field.Between = TemporalCoherence::Interpolation::Nearest;
      this->Words << ", nearest";
    }
    if (this->Chance(0.3))
    {
      this->Coordinates = Stretched(this->Size, this->OneOf({ 1.5, 6.0, 60.0 }), this->Random());
      field.Shape = TemporalCoherence::RectilinearKind(this->Coordinates);
      this->Words << ", rectilinear";
    }
    if (this->Chance(0.15))
    {
      const glm::ivec3 cells = this->Size - 1;
      for (int cell = 0; cell < cells.x * cells.y * cells.z; ++cell)
      {
        this->Flags.push_back(this->Chance(0.2));
      }
      TemporalCoherence::HidingFlags hiding;
      hiding.OfCells = this->Flags.data();
      hiding.CellMask = 1;
      field.Flagged = TemporalCoherence::HiddenCells::Make(this->Size, hiding);
      field.Hidden = field.Flagged;
      this->Words << ", hidden cells";
    }
  }

  TemporalCoherence::TransferFunction MakeFunction()
  {
    std::vector<double> at{ 0.0, 1.0 };
    for (int bend = this->Whole(0, 8); bend > 0; --bend)
    {
      at.push_back(this->Real(0.0, 1.0));
      if (this->Chance(0.2))
      {
        at.push_back(std::min(at.back() + 1e-3, 1.0));
      }
    }
    std::sort(at.begin(), at.end());
    std::vector<LookPoint> points;
    const double thin = this->OneOf({ 1.0, 1.0, 0.05 });
    for (const double each : at)
    {
      const int kind = this->Whole(0, 6);
      const double opacity = kind < 3 ? 0.0 : kind == 6 ? 1.0 : thin * this->Real(0.0, 1.0);
      points.push_back(
        { each, { this->Real(0.0, 1.0), this->Real(0.0, 1.0), this->Real(0.0, 1.0), opacity } });
    }
    const double width = this->Range.y - this->Range.x;
    const glm::dvec2 range = this->Chance(0.3)
      ? this->Range + width * glm::dvec2(this->Real(-0.5, 0.4), this->Real(-0.4, 0.5))
      : this->Range;
    const auto nodes = this->OneOf({ std::size_t(2), std::size_t(3), std::size_t(17),
      std::size_t(256), std::size_t(4097), std::size_t(65537) });
    return MakeTransfer(range, points, nodes);
  }

  TemporalCoherence::ComponentLook MakeLook()
  {
    TemporalCoherence::ComponentLook look;
    look.Transfer = this->MakeFunction();
    look.UnitDistance = this->Scale * std::exp(this->Real(-3.0, 4.0));
    look.Weight = this->Chance(0.2) ? 0.0 : this->Real(0.0, 1.0);
    auto& material = look.Material;
    material.Shade = this->Chance(0.5);
    material.Ambient = this->Real(0.0, 1.0);
    material.Diffuse = this->Real(0.0, 1.0);
    material.Specular = this->Chance(0.3) ? 0.0 : this->Real(0.0, 1.0);
    material.SpecularPower = this->OneOf({ 0.5, 1.0, 7.3, 40.0, 128.0 });
    material.Glow = this->Chance(0.2) ? glm::dvec3(this->Real(0.0, 0.3), this->Real(0.0, 0.3), 0.1)
                                      : glm::dvec3(0.0);
    if (this->Chance(0.25) && !this->HasHoles)
    {
      const double bend = this->Real(0.01, 0.5) * (this->Range.y - this->Range.x);
      look.ByGradient.Nodes = { { 0.0, this->Real(0.0, 1.0) }, { bend, this->Real(0.0, 1.0) },
        { 3.0 * bend, this->Real(0.0, 1.0) } };
      look.ByGradient.PerStep = { this->Real(0.5, 2.0), this->Real(0.5, 2.0), 1.0 };
    }
    return look;
  }

  void MakeVolume(int components)
  {
    using namespace TemporalCoherence;
    Blending& volume = this->Key.Shown.emplace<Blending>();
    // Of several components the projections know each by itself, the truth only all together.
    const bool isComposite = this->HasHoles && components > 1;
    volume.Mode = isComposite
      ? BlendMode::Composite
      : this->OneOf({ BlendMode::Composite, BlendMode::Composite, BlendMode::Composite,
          BlendMode::Maximum, BlendMode::Minimum, BlendMode::Average, BlendMode::Additive });
    // Where an extreme is met twice, either place may give the colour.
    const bool isExtreme = volume.Mode == BlendMode::Maximum || volume.Mode == BlendMode::Minimum;
    const bool depends = (components == 2 || components == 4) && !isExtreme && this->Chance(0.5);
    volume.Use = !depends ? ComponentUse::Independent
      : components == 2   ? ComponentUse::ColorOpacity
                          : ComponentUse::RgbOpacity;
    this->Scale = this->OneOf({ 1.0, 1.0, 1e-4, 1e5 });
    for (int c = 0; c < components; ++c)
    {
      if (c > 0)
      {
        Field other = this->Key.Samples;
        const std::size_t step = this->Bytes.size() /
          (static_cast<std::size_t>(this->Size.x) * static_cast<std::size_t>(this->Size.y) *
            static_cast<std::size_t>(this->Size.z) * static_cast<std::size_t>(components));
        other.Samples = this->Bytes.data() + static_cast<std::size_t>(c) * step;
        volume.Others.push_back(other);
      }
      if (!depends || c == 0)
      {
        volume.Looks.push_back(this->MakeLook());
      }
      volume.ScalarRanges.push_back(this->Range);
    }
    volume.Looks.front().Weight = components == 1 || depends ? 1.0 : volume.Looks.front().Weight;
    volume.AverageRange = glm::mix(glm::dvec2(this->Range.x), glm::dvec2(this->Range.y),
      glm::dvec2(this->Real(-0.1, 0.5), this->Real(0.5, 1.1)));
    constexpr const char* modes[] = { "", "composite", "maximum", "minimum", "average",
      "additive" };
    this->Words << ", " << modes[static_cast<int>(volume.Mode)] << (depends ? ", dependent" : "");
  }

  void MakePlace()
  {
    glm::dmat4 world(1.0);
    if (this->Chance(0.5))
    {
      world = glm::translate(world, 30.0 * this->Direction());
      world = glm::rotate(world, this->Real(0.0, 6.0), this->Direction());
      world = glm::scale(world,
        glm::dvec3(this->Real(0.3, 3.0), this->OneOf({ -1.0, 1.0 }) * this->Real(0.3, 3.0),
          this->Real(0.3, 3.0)));
      this->Words << ", turned";
    }
    world = glm::scale(glm::dmat4(1.0), glm::dvec3(this->Scale)) * world;
    this->Key.Transform = { world, glm::inverse(world) };
  }

  void MakeView()
  {
    const glm::dmat4& world = this->Key.Transform.WorldFromIndex;
    const glm::dvec3 middle = 0.5 * glm::dvec3(this->Size - 1);
    // Not in the middle, where rays run along planes between samples.
    const glm::dvec3 off(0.0123, -0.0171, 0.0219);
    const glm::dvec3 centre(world * glm::dvec4(middle + off, 1.0));
    double radius = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 at(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::dvec3 point(world * glm::dvec4(at * glm::dvec3(this->Size - 1), 1.0));
      radius = std::max(radius, glm::distance(point, centre));
    }
    const glm::dvec3 direction = this->Chance(0.2)
      ? this->OneOf({ glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1) })
      : this->Direction();
    const bool isInside = this->Chance(0.2), isParallel = !isInside && this->Chance(0.3);
    const double away = radius * (isInside ? this->Real(0.0, 0.4) : this->Real(1.5, 20.0));
    const glm::dvec3 eye = centre + away * direction;
    const glm::dvec3 up =
      std::abs(direction.z) > 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    glm::dvec2 range(std::max(away - radius, 1e-3 * radius), away + radius);
    if (this->Chance(0.2))
    {
      range.x += this->Real(0.0, 0.6) * (away - range.x > 0.0 ? away - range.x : 0.0);
      range.y -= this->Real(0.0, 0.6) * radius;
    }
    range.y = std::max(range.y, 1.5 * range.x);
    const glm::dmat4 projection = isParallel
      ? glm::ortho(-radius, radius, -radius, radius, range.x, range.y)
      : glm::perspective(
          isInside ? 1.4 : 2.0 * std::asin(std::min(radius / away, 0.9)), 1.1, range.x, range.y);
    TemporalCoherence::MakeView(glm::lookAt(eye, centre - 0.01 * radius * direction, up),
      projection, range, { 21, 19 }, this->Key.View);
    this->Words << (isInside ? ", from within" : isParallel ? ", parallel" : "");
  }

  void MakeRegion()
  {
    if (this->Chance(0.2))
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        const double last = this->Size[static_cast<int>(a)] - 1;
        const double low = this->Real(0.0, last);
        this->Key.Region.Crops[a] = { low, this->Real(low, last) };
      }
      this->Key.Region.Boxes =
        static_cast<std::uint32_t>(this->Random()) & TemporalCoherence::Region::AllBoxes;
      this->Words << ", cropped";
    }
    if (this->Chance(0.2))
    {
      const glm::dvec3 normal = this->Direction();
      const glm::dvec3 point(this->Key.Transform.WorldFromIndex *
        glm::dvec4(this->Real(0.2, 0.8) * glm::dvec3(this->Size - 1), 1.0));
      this->Key.Region.Clips = { { normal, -glm::dot(normal, point) } };
      this->Words << ", clipped";
    }
  }

  void MakeLights()
  {
    const glm::dvec3 centre(
      this->Key.Transform.WorldFromIndex * glm::dvec4(0.5 * glm::dvec3(this->Size - 1), 1.0));
    const double size = this->Scale * glm::length(glm::dvec3(this->Size));
    for (int light = this->Whole(0, 2); light >= 0; --light)
    {
      TemporalCoherence::Light made;
      made.Direction = this->Direction();
      if (this->Chance(0.5))
      {
        made.Diffuse = { this->Real(0.0, 1.0), this->Real(0.0, 1.0), this->Real(0.0, 1.0) };
      }
      if (this->Chance(0.3))
      {
        made.Positional = true;
        made.Position = centre + size * this->Real(2.0, 5.0) * this->Direction();
        made.Direction = glm::normalize(centre - made.Position);
        made.ConeAngle = this->OneOf({ 180.0, 60.0 });
        made.Attenuation =
          this->Chance(0.5) ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.2, 0.3 / size, 0.0);
        this->Words << ", positional light";
      }
      this->Key.Appearance.Lights.push_back(made);
    }
    this->Key.Appearance.TwoSided = this->Chance(0.5);
  }

  /// Labels in blocks or at random, some of which have looks of their own.
  void MakeLabels()
  {
    using namespace TemporalCoherence;
    const int edge = this->OneOf({ 1, 2, 5 });
    for (int i = 0; i < this->Size.x * this->Size.y * this->Size.z; ++i)
    {
      const glm::ivec3 block(glm::ivec3(i % this->Size.x, i / this->Size.x % this->Size.y,
                               i / this->Size.x / this->Size.y) /
        edge);
      const int label = edge > 1 ? (block.x + 3 * block.y + 5 * block.z) % 7 : this->Whole(0, 6);
      this->Labels.push_back(static_cast<std::int16_t>(100 * label));
    }
    LabelMap map;
    map.Samples.Samples = this->Labels.data();
    map.Samples.Type = ScalarType::Int16;
    map.Samples.Dimensions = this->Size;
    map.Samples.Strides = { 1, this->Size.x,
      static_cast<std::int64_t>(this->Size.x) * this->Size.y };
    map.Samples.Labels = LabelSets::Make(map.Samples);
    for (const int label : { 100, 200, 400, 600, 5000 })
    {
      if (this->Chance(0.6))
      {
        map.Looks.push_back({ label, this->MakeLook() });
        ComponentLook& look = map.Looks.back().Look;
        look.Weight = 1.0;
        look.ByGradient.PerStep = this->Key.Blended().Looks.front().ByGradient.PerStep;
      }
    }
    this->Key.Blended().Mode = BlendMode::Composite;
    this->Key.Blended().Labels = std::make_shared<const LabelMap>(std::move(map));
    this->Words << ", labels in blocks of " << edge;
  }

  std::mt19937 Random;
  glm::ivec3 Size;
  glm::dvec2 Range{ 0.0 };
  double Scale = 1.0;    ///< of the world
  bool HasHoles = false; ///< some samples are not finite
  std::vector<std::byte> Bytes;
  std::vector<std::uint8_t> Flags;
  std::vector<std::int16_t> Labels;
  std::ostringstream Words;
};

#endif
