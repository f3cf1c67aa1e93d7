// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HitRules_h
#define TemporalCoherence_HitRules_h

#include "Scene/HitOrder.h"
#include "Scene/LayerBatch.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace TemporalCoherence
{

/// The rules of hits, for tracers of all kinds of fields: which surface on a ray is its hit, and
/// where solids are capped. Surfaces may be reported in any order.
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

  /// True if solids are capped behind hidden cells.
  bool AreCappedBehindHidden() const { return this->HasHidden && this->IsSolid(); }

  /// Report a surface of the only isovalue: the nearest one is the hit.
  /// \param distance   infinity: there is none
  /// \param fromInside the ray leaves the inside of the isovalue
  static void KeepNearest(
    double distance, bool fromInside, SurfaceIndex surface, std::size_t ray, HitBatch& hits)
  {
    if (distance < hits.Depth[ray])
    {
      hits.Depth[ray] = distance;
      hits.Surface[ray] = surface;
      hits.Kind[ray] = KindOf(fromInside);
    }
  }

  /// Keep the first of several isovalues, some of which may be met at one distance.
  void KeepFirst(
    double distance, bool fromInside, SurfaceIndex surface, std::size_t ray, HitBatch& hits) const
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

  /// Report that the ray begins in a solid, which is capped there. Of several isovalues the highest
  /// is visible.
  void CapWhereItBegins(double begin, SurfaceIndex surface, std::size_t ray, HitBatch& hits) const
  {
    const MetSurface cap{ begin, HitKind::Cap, this->IsovalueOf(surface) };
    if (IsInFrontOfHit(cap, hits, ray, this->Isosurfaces.Isovalues))
    {
      hits.Depth[ray] = begin;
      hits.Surface[ray] = surface;
      hits.Kind[ray] = HitKind::Cap;
    }
  }

  /// Report that the ray is in a solid where it enters a cell. If it comes from a hidden cell, the
  /// solid is capped there. Of several isovalues the highest is visible.
  /// \param comesFromHidden only called if the cap would be the hit
  /// \return true if the cap is the hit
  template <typename ComesFromHidden>
  bool CapBehindHidden(double enter, SurfaceIndex surface, std::size_t ray,
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

  double IsovalueOf(SurfaceIndex surface) const
  {
    return this->Isosurfaces.Isovalues[static_cast<std::size_t>(surface)];
  }

private:
  Surfaces Isosurfaces;
  bool HasHidden;
};

/// Finds the next surface on a ray among candidates: the nearest one behind the last surface.
class NextHit
{
public:
  /// \param last surface that the ray has met
  NextHit(const HitRules& rules, const MetSurface& last)
    : Rules(rules)
    , Last(last)
  {
  }

  /// Report a candidate at any place on the ray. It counts only behind the last surface.
  void Consider(double distance, HitKind kind, SurfaceIndex surface)
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
  SurfaceIndex Surface = Frame::NoSurface;
};

/// The last surface on a ray that begins at `begin`. A hit on an earlier piece of the ray does not
/// count.
inline MetSurface LastOn(
  const HitRules& rules, double begin, double distance, HitKind kind, SurfaceIndex surface)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (surface == Frame::NoSurface || distance < begin)
  {
    return { -infinity, HitKind::None, 0.0 };
  }
  return { distance, kind, rules.IsovalueOf(surface) };
}
inline MetSurface LastOn(const HitRules& rules, double begin, std::size_t ray, const HitBatch& hits)
{
  return LastOn(rules, begin, hits.Depth[ray], hits.Kind[ray], hits.Surface[ray]);
}
inline MetSurface LastOn(
  const HitRules& rules, double begin, std::size_t ray, const LayerBatch& layers)
{
  return LastOn(
    rules, begin, layers.LastDistance[ray], layers.LastKind[ray], layers.LastSurface[ray]);
}

}

#endif
