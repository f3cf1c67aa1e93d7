// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameRenderer_h
#define TemporalCoherence_FrameRenderer_h

#include "Acceleration/FieldStructures.h"
#include "Acceleration/SampleComparer.h"
#include "Isomap/IsomapBuilder.h"
#include "Render/FrameOptions.h"
#include "Render/FrameStatistics.h"
#include "Render/FrameStore.h"
#include "Render/FrameStructures.h"
#include "Render/ReusePlan.h"
#include "Shade/KeptHitValues.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

struct FrameTask;

/// Structures that no view changes: the renderers of all viewers share them.
struct SharedByViewers
{
  std::shared_ptr<FieldStructures> Structures = std::make_shared<FieldStructures>();
};

/// Makes frames: asks the plan for a route, takes it, and keeps data that the next frame can use.
class FrameRenderer
{
public:
  using Options = FrameOptions;

  explicit FrameRenderer(const SharedByViewers& shared = {})
    : Structures(shared.Structures)
  {
  }

  /// Make the frame of `key`.
  /// \pre the view has pixels; isovalues are finite; there is one colour for each isovalue
  /// \param report is called in this thread with the progress from 0 to 1, and may stop the frame.
  ///               While an isomap is built, progress may go back.
  /// \return false if it was stopped; the last frame and its key are then unchanged
  /// \throws std::bad_alloc; the last frame and its key are then unchanged
  bool Render(const FrameKey& key, const Options& options, const ReportProgress& report = {});

  /// Build the bands of an isomap that `key` needs, ahead of its frame. The last frame is
  /// unchanged.
  /// \throws std::bad_alloc
  Isomap::Outcome BuildIsomap(
    const FrameKey& key, const Options& options, const ReportProgress& report = {});

  /// The last frame, and the key it was made for. The frame is empty before the first one.
  const Frame& LastFrame() const { return this->Store.Last().Picture; }
  const FrameKey& LastKey() const { return this->Store.Last().Key; }
  /// True if the last frame has pixels between rays.
  bool IsLastBetweenRays() const { return !this->Store.Last().Doubts.empty(); }
  const FrameStatistics& Statistics() const { return this->OfLastFrame; }

  /// The value ranges and hidden cells of the data of `key`. Does not change any state that frames
  /// depend on. Undefined without cells or isovalues.
  /// \throws std::bad_alloc
  const FieldRanges& RangesOf(const FrameKey& key);

  /// The value ranges of the last frame. Undefined for a frame without cells or isovalues.
  const ValueRangePyramid& LastRanges() const { return this->Structures.Pyramid(); }

  /// The isomap of the view in which isovalues last changed.
  const Isomap& IsomapOfLastView() const { return this->Map.Built(); }

  /// Seconds of building that isomap, in the last frame or in a call of BuildIsomap() after it.
  double IsomapBuildTime() const { return this->TimeToBuild; }

  /// True if the memory limit does not suffice for the isomap that was needed last.
  bool IsIsomapTooLarge() const { return this->Map.IsTooLarge() || this->Map.HasDropped(); }

  /// Drop the last frame and free all memory that is not shared.
  void Release();

private:
  FrameKey Prepare(const FrameKey& key);
  void FollowSamples(const FrameKey& key);
  void PrepareRanges(const FrameKey& key);
  Route ChooseRoute(const FrameKey& key, const Options& options, bool hasImage) const;
  KeptHitValues* BeginValues(const FrameKey& key, Route route);
  std::unique_ptr<SurfaceLight> BeginLight(const FrameTask& task, Route route);
  std::unique_ptr<SurfaceLight> MakeLight(const FrameTask& task, std::uint32_t raysOfFrame,
    std::uint32_t rays, bool isStill, KeptShadows* shadows);
  bool SmoothEdges(Route route, FrameTask& task, const ReportProgress& report,
    std::unique_ptr<SurfaceLight>& light);
  bool PrefersGrid(const FrameTask& task) const;
  bool MakeInTime(Route& route, FrameTask& task);
  bool Make(Route& route, FrameTask& task, CachedImage* nearest);
  bool BuildAndLookUp(Route& route, FrameTask& task);
  bool LookUpIsomap(Route& route, FrameTask& task);
  Isomap::Outcome PrepareIsomap(FrameTask& task);
  void Finish(Route route, const FrameTask& task);
  void KeepLight(SurfaceLight* ofPixels, SurfaceLight* ofEdges, FrameTask& task);

  FrameStore Store;
  FrameStore Grid; ///< memory for the rays of a frame from fewer rays
  FrameStructures Structures;
  SampleComparer Changes; ///< from the samples of the last frame to those of the next
  IsomapBuilder Map;      ///< of the view in which isovalues last changed
  LightCache Light;       ///< of the surfaces that frames showed
  KeptShadows Shadows;    ///< of the last frame
  KeptHitValues Values;   ///< of the last frame
  KnotForm LastForm;      ///< as requested for the last frame
  std::vector<std::uint64_t> UnresolvedRays; ///< memory of LookUp
  FrameStatistics OfLastFrame;
  /// Bricks that the last frame read; many before the first one.
  std::int64_t ReadsOfLastFrame = std::numeric_limits<std::int64_t>::max();
  bool IsLightFinal = true; ///< of the last frame
  double TimeToBuild = 0.0;
  std::shared_ptr<const FieldRanges> ForPicks; ///< of data without a frame so far; or null
};

}

#endif
