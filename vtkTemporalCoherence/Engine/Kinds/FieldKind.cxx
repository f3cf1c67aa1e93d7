// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kinds/FieldKind.h"

#include "Kinds/UniformKind.h"

namespace TemporalCoherence
{

std::shared_ptr<const BandTracer> FieldKind::MakeBandTracer(const BandScene&) const
{
  return nullptr;
}

std::shared_ptr<const BlendTracer> FieldKind::MakeBlendTracer(const BlendScene&, KeptTables*) const
{
  return nullptr;
}

const FieldKind& KindOf(const Field& field)
{
  const auto* const kind = dynamic_cast<const FieldKind*>(field.Shape.get());
  return kind ? *kind : UniformKind();
}

std::shared_ptr<const SurfaceTracer> MakeSurfaceTracer(const TraceScene& scene)
{
  return KindOf(scene.Samples).MakeTracer(scene);
}

std::shared_ptr<const BandTracer> MakeBandTracer(const BandScene& scene)
{
  const FieldKind& kind = KindOf(scene.Samples);
  BandScene whole = scene;
  whole.Normals = &kind;
  return kind.MakeBandTracer(whole);
}

std::shared_ptr<const BlendTracer> MakeBlendTracer(const BlendScene& scene, KeptTables* kept)
{
  return KindOf(scene.Key.Samples).MakeBlendTracer(scene, kept);
}

}
