// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Layers that no light reaches are kept for later opacities, but not for other surfaces, views or
// data. A frame that is stopped, or for which memory is refused in any thread, leaves the last one
// as it was.

#include "Checks/Sanitized.h"
#include "RefusedMemory.h"
#include "Render/FrameStore.h"
#include "Render/OpacityChanges.h"
#include "Render/TileLoop.h"

#include <vtkSMPTools.h>

#include <new>

namespace
{

using namespace TemporalCoherence;

class KnownLayersOfFrames : public OpacityChanges
{
};

TEST_F(KnownLayersOfFrames, LayersBehindGoWithWhatTheyBelongTo)
{
  const auto expectGone = [this](const std::string& what)
  {
    this->SetOpacity(0.2);
    this->Render("many layers before " + what);
    this->SetOpacity(1.0);
    this->Render("layers behind before " + what, Route::Recomposite);
    EXPECT_GT(this->CountBehind(), 1000u);
  };
  expectGone("isovalues");
  this->Key.EditIsosurfaces().Isovalues = { 10.0, 60.0 };
  this->Render("isovalues");
  EXPECT_EQ(this->CountBehind(), 0u);
  expectGone("the view");
  this->Key.View = LookAt(Dimensions, { 1.0, 1.8, 0.7 }, { 101, 67 });
  this->Render("view");
  EXPECT_EQ(this->CountBehind(), 0u);
  expectGone("data");
  this->Key.Transform.WorldFromIndex[3][0] = 0.5;
  this->Render("data");
  EXPECT_EQ(this->CountBehind(), 0u);
}

/// What does not belong to the new frame is not kept with an older one either.
TEST(FrameStoreTest, AnOldFrameKeepsNoLayersBehind)
{
  FrameStore store;
  FrameKey key;
  key.View.Size = glm::ivec2(16);
  key.EditIsosurfaces().Isovalues = { 1.0 };
  key.EditIsosurfaces().Opacities = { 0.5 };
  const auto behind = [&store](const CachedImage& image)
  { return image.Picture.Behind.at(0).Hits.capacity(); };
  const auto make = [&]
  {
    store.Begin(key, {});
    store.Next().Picture.Behind[0].Hits.resize(100);
    store.Finish({});
  };
  make();
  const CachedImage& first = store.Last();
  key.EditIsosurfaces().Opacities = { 0.6 };
  make();
  EXPECT_GE(behind(first), 100u) << "memory for the next opacity";
  key.EditIsosurfaces().Isovalues = { 2.0 };
  const CachedImage& second = store.Last();
  make();
  EXPECT_EQ(behind(second), 0u);
  EXPECT_GE(behind(store.Last()), 100u);
}

TEST_F(KnownLayersOfFrames, WithoutImageCacheFramesAreCold)
{
  this->Options.Reuse.Frames = false;
  this->Options.Reuse.Isomap = false;
  this->SetOpacity(0.3);
  this->Render("first", Route::Cold);
  this->SetOpacity(0.6);
  this->Render("without image cache", Route::Cold);
  this->Options.Reuse.Frames = true;
  this->SetOpacity(0.5);
  this->Render("with image cache", Route::Recomposite);
}

/// Wherever a frame is stopped, the last one is whole, and so is the next.
TEST_F(KnownLayersOfFrames, AStoppedFrameLeavesNoTrace)
{
  this->Options.ReportsTiles = true;
  this->Key.View = LookAt(Dimensions, { 1.0, 2.0, 0.7 }, { 301, 203 });
  this->SetOpacity(0.9);
  this->Render("first", Route::Cold);
  const FrameKey before = this->Key;
  for (const double stop : { 0.0, 0.4, 0.9 })
  {
    this->SetOpacity(0.3);
    const bool isMade = this->Renderer.Render(
      this->Key, this->Options, [stop](double progress) { return progress < stop; });
    EXPECT_FALSE(isMade);
    EXPECT_TRUE(this->Renderer.LastKey().Isosurfaces() == before.Isosurfaces());
    this->Key = before;
    this->ExpectCold("after a stop");
  }
  this->SetOpacity(0.4);
  this->Render("after stops", Route::Recomposite);
}

/// Layers are kept in memory that may be refused at any tile.
TEST_F(KnownLayersOfFrames, WithoutMemoryTheLastFrameStays)
{
  if (IsMemorySanitized)
  {
    GTEST_SKIP() << "a build with a sanitizer, which throws no std::bad_alloc";
  }
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential"); // all memory is asked for by this thread
  this->SetOpacity(0.9);
  this->Render("first", Route::Cold);
  int refused = 0;
  bool isMade = false;
  for (std::int64_t allowed = 0; !isMade; allowed += 1 + allowed / 2)
  {
    const FrameKey before = this->Key;
    this->SetOpacity(this->Key.Isosurfaces().Opacities[0] == 0.9 ? 0.3 : 0.9);
    try
    {
      const RefusedMemory without(allowed);
      isMade = this->Renderer.Render(this->Key, this->Options);
    }
    catch (const std::bad_alloc&)
    {
      ++refused;
      this->Key = before;
    }
    this->ExpectCold("with " + std::to_string(allowed) + " allocations");
  }
  EXPECT_GT(refused, 3);
  vtkSMPTools::SetBackend(backend.c_str());
}

/// Threads of some kinds end the program where an exception leaves them.
TEST(TileLoop, AThreadWithoutMemoryEndsTheFrameOnly)
{
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(3);
  FrameStatistics statistics;
  const auto work = [](std::size_t group, TraceCounts&)
  {
    if (group % 5 == 2)
    {
      throw std::bad_alloc();
    }
  };
  EXPECT_THROW(CountGroups(glm::ivec2(400), ReportProgress(), statistics, work), std::bad_alloc);
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

}
