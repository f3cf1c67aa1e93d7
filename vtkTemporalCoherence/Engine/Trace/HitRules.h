// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HitRules_h
#define TemporalCoherence_HitRules_h

#include "Scene/HitOrder.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace TemporalCoherence
{

/// Which of the surfaces that are found along a ray is its hit, where it is capped, and what its
/// first entry is: for tracers of all kinds of fields. What is found may be told in any order.
class HitRules
{
public:
  /// \param hasHidden cells of the field may be hidden
  HitRules(const Surfaces& surfaces, bool hasHidden)
    : Isosurfaces(surfaces)
    , HasHidden(hasHidden)
  {
  }

  bool IsSolid() const { return this->Isosurfaces.Mode == SurfaceMode::Threshold; }

  /// True if hidden cells may cut a solid open.
  bool AreCappedBehindHidden() const { return this->HasHidden && this->IsSolid(); }

  /// The ray enters a cell that an isovalue passes through. The first one counts.
  static void KeepFirstEntry(double enter, bool isInside, std::size_t ray, HitBatch& hits)
  {
    if (enter < hits.FirstEntry[ray])
    {
      hits.FirstEntry[ray] = enter;
      hits.FromInside[ray] = isInside;
    }
  }

  /// The ray meets the one isovalue there is: the nearest surface is its hit.
  /// \param distance   infinity: it does not
  /// \param fromInside it leaves what is inside the isovalue
  static void KeepNearest(
    double distance, bool fromInside, std::int16_t surface, std::size_t ray, HitBatch& hits)
  {
    if (distance < hits.Depth[ray])
    {
      hits.Depth[ray] = distance;
      hits.Surface[ray] = surface;
      hits.Kind[ray] = KindOf(fromInside);
    }
  }

  /// The same of several isovalues, some of which may be met at one distance.
  void KeepFirst(
    double distance, bool fromInside, std::int16_t surface, std::size_t ray, HitBatch& hits) const
  {
    if (distance == hits.Depth[ray] && hits.Surface[ray] != Frame::NoSurface)
    {
      const MetSurface met{ distance, KindOf(fromInside), this->IsovalueOf(surface) };
      if (IsInFrontOfHit(met, hits, ray, this->Isosurfaces.Isovalues))
      {
        hits.Surface[ray] = surface;
        hits.Kind[ray] = met.Kind;
      }
      return;
    }
    KeepNearest(distance, fromInside, surface, ray, hits);
  }

  /// The ray begins in a solid, which is capped there. Of several isovalues the highest is seen.
  void CapWhereItBegins(double begin, std::int16_t surface, std::size_t ray, HitBatch& hits) const
  {
    const MetSurface cap{ begin, HitKind::Cap, this->IsovalueOf(surface) };
    if (IsInFrontOfHit(cap, hits, ray, this->Isosurfaces.Isovalues))
    {
      hits.Depth[ray] = begin;
      hits.FirstEntry[ray] = begin;
      hits.FromInside[ray] = 0;
      hits.Surface[ray] = surface;
      hits.Kind[ray] = HitKind::Cap;
    }
  }

  /// The ray is in a solid where it enters a cell. If it comes from a hidden one, the solid is
  /// capped there. Of several isovalues the highest is seen.
  /// \param comesFromHidden asked if the cap would be the hit
  /// \return true if it is
  template <typename ComesFromHidden>
  bool CapBehindHidden(double enter, std::int16_t surface, std::size_t ray,
    const ComesFromHidden& comesFromHidden, HitBatch& hits) const
  {
    const MetSurface cap{ enter, HitKind::Cap, this->IsovalueOf(surface) };
    if (!IsInFrontOfHit(cap, hits, ray, this->Isosurfaces.Isovalues) || !comesFromHidden())
    {
      return false;
    }
    hits.Depth[ray] = enter;
    hits.Surface[ray] = surface;
    hits.Kind[ray] = HitKind::Cap;
    return true;
  }

  static HitKind KindOf(bool fromInside) { return fromInside ? HitKind::Exit : HitKind::Entry; }

  double IsovalueOf(std::int16_t surface) const
  {
    return this->Isosurfaces.Isovalues[static_cast<std::size_t>(surface)];
  }

private:
  Surfaces Isosurfaces;
  bool HasHidden;
};

/// The surface that follows the last one on a ray, found among all that may: the nearest that is
/// behind it.
class NextHit
{
public:
  /// \param last that a ray has met, at place `surface` of the isovalues
  NextHit(const HitRules& rules, const MetSurface& last)
    : Rules(rules)
    , Last(last)
  {
  }

  /// The ray meets a surface, before the last one, at it or behind it.
  void Consider(double distance, HitKind kind, std::int16_t surface)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const MetSurface met{ distance, kind, this->Rules.IsovalueOf(surface) };
    if (distance < infinity && IsInFront(this->Last, met) && IsInFront(met, this->Next))
    {
      this->Next = met;
      this->Surface = surface;
    }
  }

  bool IsFound() const { return this->Surface != Frame::NoSurface; }

  const MetSurface& Before() const { return this->Last; }

  void Store(std::size_t ray, HitBatch& hits) const
  {
    hits.Depth[ray] = this->Next.Distance;
    hits.Kind[ray] = this->Next.Kind;
    hits.Surface[ray] = this->Surface;
  }

private:
  const HitRules& Rules;
  MetSurface Last;
  MetSurface Next{ std::numeric_limits<double>::infinity(), HitKind::None, 0.0 };
  std::int16_t Surface = Frame::NoSurface;
};

/// What a ray has met last, as far as it matters to one that begins at `begin`: what is known of an
/// earlier piece of it does not.
inline MetSurface LastOn(const HitRules& rules, double begin, std::size_t ray, const HitBatch& hits)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (hits.Surface[ray] == Frame::NoSurface || hits.Depth[ray] < begin)
  {
    return { -infinity, HitKind::None, 0.0 };
  }
  return { hits.Depth[ray], hits.Kind[ray], rules.IsovalueOf(hits.Surface[ray]) };
}

}

#endif
