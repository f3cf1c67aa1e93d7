// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Irregular grids: the mapper beside triangles and beside resampling, in the same run and views.

#include "Display.h"
#include "Measuring.h"
#include "MeshFrames.h"
#include "SampleMeshes.h"
#include "Scenario.h"

#include <iostream>
#include <string>
#include <vector>

namespace
{

using Measuring::Ratio;

constexpr int UsualRounds = 3;
constexpr double MiB = 1024.0 * 1024.0;

/// 10 million tetrahedra, 3 million hexahedra in two kinds of grids, and small meshes of
/// simulations.
const std::vector<Volumes::Sample>& UsualMeshes()
{
  static const std::vector<Volumes::Sample> meshes = { { "tetrahedra119", SampleMeshes::Isovalue },
    { "hexahedra144", SampleMeshes::Isovalue }, { "curvilinear144", SampleMeshes::Isovalue },
    { "disk_out_ref.ex2", 600 }, { "bluntfinxyz.bin", 2 }, { "hexa.vtk", 8 } };
  return meshes;
}

const std::vector<Volumes::Sample>& SmallMeshes()
{
  static const std::vector<Volumes::Sample> meshes = { { "tetrahedra12", SampleMeshes::Isovalue },
    { "hexahedra12", SampleMeshes::Isovalue }, { "curvilinear12", SampleMeshes::Isovalue },
    { "disk_out_ref.ex2", 600 } };
  return meshes;
}

void AddTo(JsonWriter& json, const MeshFrames::Times& t)
{
  json.OpenObject();
  json.Add("who", t.Who);
  json.Add("drawnPercent", t.PercentDrawn);
  json.Add("setUpMs", t.SetUp);
  json.Add("bytes", t.Memory);
  json.Add("coldMs", t.Cold);
  json.Add("newViewMs", t.NewView);
  json.Add("firstIsovalueMs", t.FirstIsovalue);
  json.Add("laterIsovalueMs", t.LaterIsovalue);
  json.Add("laterLookedUpPercent", t.LaterLookedUp);
  json.Add("inRangeMs", t.InRange);
  json.Add("wrongPercent", t.PercentWrong);
  json.Add("depthOffEdges", t.DepthOff);
  json.Add("depthFarOffEdges", t.DepthFarOff);
  json.Close();
}

void Print(const MarkdownTable& table, const std::string& name, double meshBytes,
  const MeshFrames::Times& t, const MeshFrames::Times& ours)
{
  table.Row({ name, t.Who, Fixed(t.PercentDrawn, 0),
    Fixed(1e-3 * t.SetUp, 2) + (t.Remark.empty() ? "" : " (" + t.Remark + ")"),
    Fixed(t.Memory / MiB, 0), Fixed(Ratio(t.Memory, meshBytes), 2), Fixed(t.Cold, 1),
    Fixed(t.NewView, 1), Fixed(t.FirstIsovalue, 1), Fixed(t.LaterIsovalue, 1),
    Fixed(Ratio(t.LaterIsovalue, ours.LaterIsovalue), 1), Fixed(t.LaterLookedUp, 0),
    Fixed(t.InRange, 1), Fixed(t.PercentWrong, 2),
    Fixed(t.DepthOff, 3) + " / " + Fixed(t.DepthFarOff, 2) });
}

bool Run(const Settings& settings, JsonWriter& json)
{
  const bool hasWindow = HasDisplayOrTell("Drawing of polygons is");
  const int rounds = settings.FramesOr(UsualRounds);
  std::cout
    << "Medians in ms; set-up in s: the first frame less a new view; memory: MiB beside "
       "the mesh, and by the mesh's; cold: what depends on the isovalue is made anew; "
       "first, later: new isovalues in a view, and how many of the later ones were looked up; "
       "in range: new isovalues of a range that the isomap was built for; "
       "wrong: % of the pixels hit in one picture "
       "only; depth off: from that of the mesh, in mean edges of cells, median and 99 %\n\n";
  const MarkdownTable table({ "mesh", "who", "drawn %", "set-up", "memory", "/ mesh", "cold",
    "new view", "first", "later", "/ ours", "looked up %", "in range", "wrong", "depth off" });
  json.OpenList("meshes");
  bool isMeasured = false;
  for (const Volumes::Sample& sample : settings.IsQuick ? SmallMeshes() : UsualMeshes())
  {
    const vtkSmartPointer<vtkDataSet> mesh = SampleMeshes::Load(sample.Name);
    if (!mesh)
    {
      std::cerr << sample.Name << " is left out: it cannot be read\n";
      continue;
    }
    std::cerr << "  " << sample.Name << ' ' << sample.Isovalue << std::endl;
    const double bytes = 1024.0 * static_cast<double>(mesh->GetActualMemorySize());
    json.OpenObject();
    json.Add("mesh", sample.Name);
    json.Add("isovalue", sample.Isovalue);
    json.Add("cells", static_cast<double>(mesh->GetNumberOfCells()));
    json.Add("meshBytes", bytes);
    json.OpenList("ways");
    const std::vector<MeshFrames::Times> all = MeshFrames::Measure(
      { sample.Name, sample.Isovalue, settings.Size, settings.From, mesh }, rounds, hasWindow);
    for (const MeshFrames::Times& times : all)
    {
      Print(table, sample.Name, bytes, times, all.front());
      AddTo(json, times);
    }
    json.Close();
    json.Close();
    isMeasured = true;
  }
  json.Close();
  return isMeasured;
}

}

Scenario Scenarios::Meshes()
{
  return { "meshes", "irregular grids: this mapper beside triangles and resampling", Run };
}
