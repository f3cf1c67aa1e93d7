// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Times every route on many volumes, and vtkFlyingEdges3D beside them in the same run. With
// --window the peer also draws its polygons in a render window.

#include "CommandLine.h"
#include "Measuring.h"
#include "Report.h"
#include "Stage.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkContourValues.h>
#include <vtkFlyingEdges3D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using Measuring::Median;
using Measuring::TimeOf;

struct Settings
{
  int Size = 1024;
  int Frames = 20;
  bool Window = false;
  std::string Json;
  std::vector<Volumes::Sample> Volumes = { { "spheres256", 100 }, { "marschner-lobb256", 128 },
    { "marschner-lobb512", 128 }, { "engine.vti", 70 }, { "engine.vti", 180 }, { "brain.vti", 40 },
    { "brain.vti", 90 }, { "cthead.vti", 600 }, { "bonsai.vti", 40 }, { "aneurism.vti", 60 },
    { "heptane.vti", 60 }, { "isabel.vti", 20 }, { "homo.vti", 0.03 }, { "ch2better.nii.gz", 40 } };
};

/// One line of the table; times are medians in milliseconds.
struct Result
{
  std::string Name;
  double Isovalue = 0.0;
  double First = 0.0;     ///< first frame, structures and all
  double Cold = 0.0;      ///< orbit
  double Trace = 0.0;     ///< of the cold frame
  double Shade = 0.0;     ///< of the cold frame
  double Threshold = 0.0; ///< a new isovalue in a still view
  double Reshade = 0.0;
  double Redisplay = 0.0;
  double PlainCold = 0.0;  ///< without space leaping
  double Extraction = 0.0; ///< vtkFlyingEdges3D, a new isovalue, with normals
  double Polygons = 0.0;   ///< the same with rendering; 0 if there is no window
  double HitShare = 0.0;
};

/// The isovalues of a sweep: small steps around the one of interest.
double SweepIsovalue(const Result& result, const double range[2], int frame)
{
  return result.Isovalue + 0.001 * (range[1] - range[0]) * (1 + frame % 5);
}

/// Every view is a new one, made with no help from the last.
void TimeColdFrames(Stage& stage, Drawer& drawer, int frames, Result& result)
{
  result.First = drawer.Draw(stage);
  drawer.Mapper->ImageCacheOff();
  std::vector<double> cold, trace, shade;
  for (int i = 0; i < frames; ++i)
  {
    stage.Orbit(2.0);
    cold.push_back(drawer.Draw(stage));
    trace.push_back(1e3 * drawer.Mapper->GetTraceTime());
    shade.push_back(1e3 * drawer.Mapper->GetShadeTime());
  }
  drawer.Mapper->ImageCacheOn();
  result.Cold = Median(cold);
  result.Trace = Median(trace);
  result.Shade = Median(shade);
}

/// The view stays; first only the light changes, then the isovalue.
void TimeStillFrames(Stage& stage, Drawer& drawer, int frames, Result& result)
{
  vtkVolumeProperty* property = stage.Volume->GetProperty();
  std::vector<double> threshold, reshade, redisplay;
  for (int i = 0; i < frames; ++i)
  {
    redisplay.push_back(drawer.Draw(stage));
    property->SetDiffuse(0.6 + 0.01 * i);
    reshade.push_back(drawer.Draw(stage));
  }
  const double* range = stage.Image->GetScalarRange();
  for (int i = 0; i < frames; ++i)
  {
    property->GetIsoSurfaceValues()->SetValue(0, SweepIsovalue(result, range, i));
    threshold.push_back(drawer.Draw(stage));
  }
  result.Threshold = Median(threshold);
  result.Reshade = Median(reshade);
  result.Redisplay = Median(redisplay);
}

void TimePlainFrames(Stage& stage, Drawer& drawer, Result& result)
{
  drawer.Mapper->SpaceLeapingOff();
  std::vector<double> plain;
  for (int i = 0; i < 2; ++i)
  {
    drawer.Mapper->ReleaseReuse();
    plain.push_back(drawer.Draw(stage));
  }
  result.PlainCold = *std::min_element(plain.begin(), plain.end());
}

void TimeMapper(vtkImageData* image, const Settings& settings, Result& result)
{
  Stage stage(image, result.Isovalue, settings.Size);
  Drawer drawer(stage);
  TimeColdFrames(stage, drawer, settings.Frames, result);
  TimeStillFrames(stage, drawer, settings.Frames, result);
  TimePlainFrames(stage, drawer, result);
  result.HitShare = 0.01 * PercentHit(drawer);
}

void TimePolygons(vtkImageData* image, const Settings& settings, Result& result)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->ComputeNormalsOn();
  contour->ComputeScalarsOff();
  const double* range = image->GetScalarRange();
  const int frames = std::max(3, settings.Frames / 4);

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  if (settings.Window)
  {
    mapper->SetInputConnection(contour->GetOutputPort());
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
    window->SetOffScreenRendering(1);
    window->SetSize(settings.Size, settings.Size);
    window->AddRenderer(renderer);
    contour->SetValue(0, result.Isovalue);
    renderer->GetActiveCamera()->SetPosition(-1.0, -2.0, 0.8);
    renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    renderer->ResetCamera();
    window->Render();
  }

  std::vector<double> extraction, polygons;
  for (int i = 0; i < frames; ++i)
  {
    contour->SetValue(0, SweepIsovalue(result, range, i));
    extraction.push_back(TimeOf([&] { contour->Update(); }));
    if (settings.Window)
    {
      const double drawing = TimeOf(
        [&]
        {
          window->Render();
          window->WaitForCompletion();
        });
      polygons.push_back(extraction.back() + drawing);
    }
  }
  result.Extraction = Median(extraction);
  result.Polygons = Median(polygons);
}

void AddTo(JsonWriter& json, const Result& r)
{
  json.OpenObject();
  json.Add("volume", r.Name);
  json.Add("isovalue", r.Isovalue);
  json.Add("hitShare", r.HitShare);
  json.Add("firstMs", r.First);
  json.Add("coldMs", r.Cold);
  json.Add("traceMs", r.Trace);
  json.Add("shadeMs", r.Shade);
  json.Add("thresholdMs", r.Threshold);
  json.Add("reshadeMs", r.Reshade);
  json.Add("redisplayMs", r.Redisplay);
  json.Add("plainColdMs", r.PlainCold);
  json.Add("extractionMs", r.Extraction);
  json.Add("polygonsMs", r.Polygons);
  json.Close();
}

void PrintRow(const MarkdownTable& table, const Settings& settings, const Result& r)
{
  const double peer = settings.Window ? r.Polygons : r.Extraction;
  table.Row({ r.Name, Plain(r.Isovalue), Fixed(100.0 * r.HitShare, 0) + " %", Fixed(r.First, 0),
    Fixed(r.Cold, 1), Fixed(r.Trace, 1) + " + " + Fixed(r.Shade, 1), Fixed(r.Threshold, 1),
    Fixed(r.Reshade, 1), Fixed(r.Redisplay, 1), Fixed(r.PlainCold, 0), Fixed(r.Extraction, 0),
    Fixed(r.Polygons, 0), Fixed(Measuring::Ratio(peer, r.Threshold), 1) });
}

/// False if there was no volume to measure.
bool Report(const Settings& settings, JsonWriter& json)
{
  std::cout << "Medians in ms; polygons: vtkFlyingEdges3D"
            << (settings.Window ? " + vtkPolyDataMapper" : ", extraction alone") << "\n\n";
  const MarkdownTable table(
    { "volume", "isovalue", "hit", "first", "cold", "(trace + shade)", "new isovalue", "Reshade",
      "Redisplay", "plain cold", "extraction", "+ drawing", "polygons / new isovalue" });
  json.OpenList("results");
  bool isMeasured = false;
  for (const Volumes::Sample& sample : settings.Volumes)
  {
    const vtkSmartPointer<vtkImageData> image = LoadOrTell(sample.Name);
    if (!image)
    {
      continue;
    }
    Result result;
    result.Name = sample.Name;
    result.Isovalue = sample.Isovalue;
    TimeMapper(image, settings, result);
    TimePolygons(image, settings, result);
    PrintRow(table, settings, result);
    AddTo(json, result);
    isMeasured = true;
  }
  json.Close();
  return isMeasured;
}

}

int main(int argc, char* argv[])
{
  Settings settings;
  CommandLine options(
    "BenchmarkRoutes", "Time every route, and vtkFlyingEdges3D beside them, as a Markdown table.");
  options.Number("--size", "pixels of the picture in each direction", settings.Size);
  options.Number("--frames", "frames of each route", settings.Frames);
  options.Text("--json", "write all figures to this file too", settings.Json);
  options.Flag("--window", "draw the peer's polygons too, in a render window", settings.Window);
  options.Volumes(settings.Volumes);
  return options.Run(argc, argv,
    [&]
    {
      return MakeReport(
        settings.Size, settings.Json, [&](JsonWriter& json) { return Report(settings, json); });
    });
}
