// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameRenderer_h
#define TemporalCoherence_FrameRenderer_h

#include "Acceleration/FieldStructures.h"
#include "Acceleration/SampleComparer.h"
#include "Acceleration/TileBounds.h"
#include "ImageCache/ImageCache.h"
#include "Isomap/Isomap.h"
#include "Isomap/IsomapBuilder.h"
#include "Render/FrameStatistics.h"
#include "Render/ReusePlan.h"
#include "Render/TileTracer.h"
#include "Shade/TileShader.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace TemporalCoherence
{

/// Makes frames: asks the plan for a route, takes it, keeps what the next frame can use.
class FrameRenderer
{
public:
  struct Options
  {
    bool SpaceLeaping = true; ///< off: every cell on the way is read (the paper's plain ray caster)
    ReuseSwitches Reuse;
    ReuseAccuracy Accuracy = ReuseAccuracy::Bounded;
    bool InterpolateColors = false; ///< PAPER's definite hits: from the cached image, not shaded
    ImageCache::Options Images;
    Isomap::Options Map;
    bool ReportsTiles = false; ///< tiles are worked on in parts, too, with a report before each
  };

  /// \param shared where to get structures that other renderers of the same data may have
  explicit FrameRenderer(
    std::shared_ptr<FieldStructures> shared = std::make_shared<FieldStructures>())
    : Shared(std::move(shared))
  {
  }

  /// Make the frame of `key`.
  /// \pre the view has pixels; isovalues are finite; there is one colour for each isovalue
  /// \param report told how far the frame is, in this thread; it may stop it. From 0 to 1, but the
  ///               building of an isomap may fall back.
  /// \return false if it was stopped, the last frame and its key then being as they were
  /// \throws std::bad_alloc, likewise
  bool Render(
    const FrameKey& key, const Options& options, const Isomap::ReportProgress& report = {});

  /// Build the bands of an isomap that `key` needs, ahead of its frame. The last frame stays.
  /// \throws std::bad_alloc
  Isomap::Outcome BuildIsomap(
    const FrameKey& key, const Options& options, const Isomap::ReportProgress& report = {});

  /// The last frame, and the key it was made for. The frame is empty before the first one.
  const Frame& LastFrame() const { return this->Front->Picture; }
  const FrameKey& LastKey() const { return this->Front->Key; }
  const FrameStatistics& Statistics() const { return this->Counters; }

  /// Smallest and largest finite sample of the data of `key`, from the structure that its next
  /// frame needs as well. Not defined where there are no cells or no isovalues. \throws
  /// std::bad_alloc
  glm::dvec2 FiniteRangeOf(const FrameKey& key);

  /// The value ranges that the last frame was made with; not defined where it has no cells or no
  /// isovalues.
  const ValueRangePyramid& LastRanges() const { return this->Pyramid(); }

  /// The isomap of the view in which isovalues last changed.
  const Isomap& IsomapOfLastView() const { return this->Map.Built(); }

  /// True if the isomap that was needed last does not fit the limit of memory.
  bool IsIsomapTooLarge() const { return this->Map.IsTooLarge(); }

  /// Forget the last frame and free all memory that is not shared.
  void Release();

private:
  Route ChooseRoute(const FrameKey& key, const Options& options, const CachedImage* nearest) const;
  bool TakeRoute(const FrameKey& key, const Options& options, CachedImage* nearest,
    const Isomap::ReportProgress& report);
  bool TraceFrame(const FrameKey& key, const Options& options, CachedImage* cached,
    const Isomap::ReportProgress& report);
  Isomap::Outcome BuildBands(
    const FrameKey& key, const Options& options, const Isomap::ReportProgress& report);
  bool LookUpFrame(
    const FrameKey& key, const Options& options, const Isomap::ReportProgress& report);
  void BeginFrame(const FrameKey& key);
  void FinishFrame(const Options& options);
  void CompareSamples(const FrameKey& key);
  void MoveTo(const Field& field);
  void PreparePyramid(const FrameKey& key);
  void PrepareActiveCells(const FrameKey& key);
  bool TraceOpenRays(const FrameKey& key, const Options& options, const TileShader& shader,
    Frame& frame, const Isomap::ReportProgress& report);
  void ShadeAgain();
  void CountKnownHits();
  const ValueRangePyramid& Pyramid() const { return *this->Ranges->Pyramid; }

  std::shared_ptr<CachedImage> Front = std::make_shared<CachedImage>(); ///< the last frame
  std::shared_ptr<CachedImage> Back;   ///< memory for the frame being made; or null
  ImageCache Images;                   ///< what later frames may start from, Front among them
  KnotForm FrontForm;                  ///< asked for when it was made
  IsomapBuilder Map;                   ///< of the view in which isovalues last changed
  IsomapBuilder::ColdFrame Cold;       ///< what the last one took
  std::vector<std::uint64_t> OpenRays; ///< of each tile, those that the isomap leaves to be traced
  FrameStatistics Counters;

  std::shared_ptr<FieldStructures> Shared;
  std::shared_ptr<const FieldRanges> Ranges = std::make_shared<const FieldRanges>();
  std::shared_ptr<const SurfaceCells> Cells = std::make_shared<const SurfaceCells>();
  TileBounds Bounds;
  SampleComparer Steps; ///< from the samples of the last frame to those of the next
};

}

#endif
