// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StructureTimes.h"

#include "Acceleration/ActiveCells.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Input/FieldFromImage.h"
#include "Measuring.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>

namespace StructureTimes
{
namespace
{

using namespace TemporalCoherence;

/// Median of an action.
double TimeOfSome(int frames, const std::function<void()>& action)
{
  std::vector<double> times;
  for (int frame = 0; frame < frames; ++frame)
  {
    times.push_back(Measuring::TimeOf(action));
  }
  return Measuring::Median(times);
}

/// The sum of whole words, so that memory is waited for and not arithmetic, whatever the samples.
std::uint64_t SumOfWords(vtkDataArray* scalars)
{
  constexpr vtkIdType grain = 1 << 15;
  constexpr auto size = static_cast<vtkIdType>(sizeof(std::uint64_t));
  const auto* bytes = static_cast<const unsigned char*>(scalars->GetVoidPointer(0));
  const vtkIdType count = scalars->GetNumberOfValues() * scalars->GetDataTypeSize() / size;
  std::atomic<std::uint64_t> all{ 0 };
  vtkSMPTools::For(0, count, grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::uint64_t sum = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        std::uint64_t word;
        std::memcpy(&word, bytes + i * size, sizeof(word));
        sum += word;
      }
      all += sum;
    });
  return all;
}

Field FieldOf(vtkImageData* image)
{
  Field field;
  std::string error;
  if (!MakeField(image, image->GetPointData()->GetScalars(), false, 0, field, error))
  {
    throw Measuring::Failure(error);
  }
  if (!field.HasCells())
  {
    throw Measuring::Failure("A volume has no cells: name one with two samples along each axis.");
  }
  return field;
}

/// A band around the isovalue, by new mappers.
void MeasureIsomap(Stage& stage, int frames, Times& times)
{
  std::vector<double> builds;
  for (int frame = 0; frame < frames; ++frame)
  {
    Drawer drawer(stage);
    drawer.Draw(stage);
    bool isBuilt = false;
    const double time = Measuring::TimeOf(
      [&] { isBuilt = drawer.Mapper->BuildIsomap(stage.Renderer, stage.Volume); });
    if (!isBuilt)
    {
      times.Isomap = times.IsomapBytes = Measuring::None;
      return;
    }
    builds.push_back(time);
    times.IsomapBytes = static_cast<double>(drawer.Mapper->GetStatistics()->GetIsomapMemory());
  }
  times.Isomap = Measuring::Median(builds);
}

}

Times Measure(Stage& stage, int frames)
{
  const Field field = FieldOf(stage.Image);
  vtkDataArray* scalars = stage.Image->GetPointData()->GetScalars();
  Times times;
  times.VolumeBytes =
    static_cast<double>(scalars->GetNumberOfValues()) * scalars->GetDataTypeSize();
  std::atomic<std::uint64_t> unused{ 0 };
  times.Read = TimeOfSome(frames, [&] { unused += SumOfWords(scalars); });
  times.Pyramid = TimeOfSome(frames,
    [&]
    {
      ValueRangePyramid pyramid;
      pyramid.Build(field);
    });
  ValueRangePyramid pyramid;
  pyramid.Build(field);
  times.PyramidBytes = static_cast<double>(pyramid.MemoryInBytes());
  const Surfaces surfaces = { { stage.Isovalue() }, SurfaceMode::Crossing };
  times.ActiveCells = TimeOfSome(frames,
    [&]
    {
      ActiveCells active;
      active.Build(field, pyramid, surfaces);
      times.ActiveBytes = static_cast<double>(active.MemoryInBytes());
    });
  MeasureIsomap(stage, frames, times);
  return times;
}

}
