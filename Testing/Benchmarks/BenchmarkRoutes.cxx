// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Times every route on many volumes, and vtkFlyingEdges3D beside them in the same run.
//
//   BenchmarkRoutes [--size PIXELS] [--frames N] [--json FILE] [--window] [VOLUME ISOVALUE]...
//
// Prints a Markdown table. With --window the peer also draws its polygons in a render window.

#include "Volumes.h"
#include "vtkTemporalCoherenceVolumeMapper.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSMPTools.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace
{

struct Settings
{
  int Size = 1024;
  int Frames = 20;
  bool Window = false;
  std::string Json;
  std::vector<Volumes::Sample> Volumes;
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

double Now()
{
  return std::chrono::duration<double, std::milli>(
    std::chrono::steady_clock::now().time_since_epoch())
    .count();
}

template <typename Action>
double TimeOf(const Action& action)
{
  const double begin = Now();
  action();
  return Now() - begin;
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

/// The isovalues of a sweep: small steps around the one of interest.
double SweepIsovalue(const Result& result, const double range[2], int frame)
{
  return result.Isovalue + 0.001 * (range[1] - range[0]) * (1 + frame % 5);
}

void SetUpProperty(vtkVolumeProperty* property, double isovalue)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(isovalue, 0.9, 0.8, 0.7);
  property->SetColor(color);
  property->ShadeOn();
  property->SetInterpolationTypeToLinear();
  property->GetIsoSurfaceValues()->SetValue(0, isovalue);
}

void TimeMapper(vtkImageData* image, const Settings& settings, Result& result)
{
  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  vtkVolumeProperty* property = volume->GetProperty();
  SetUpProperty(property, result.Isovalue);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->GetActiveCamera()->SetPosition(-1.0, -2.0, 0.8);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();
  const double* range = image->GetScalarRange();

  vtkNew<vtkImageData> color, depth;
  const auto frame = [&]
  {
    return TimeOf(
      [&] { mapper->RenderToImage(renderer, volume, settings.Size, settings.Size, color, depth); });
  };

  result.First = frame();
  std::vector<double> cold, trace, shade, threshold, reshade, redisplay, plain;
  for (int i = 0; i < settings.Frames; ++i)
  {
    renderer->GetActiveCamera()->Azimuth(2.0);
    renderer->ResetCameraClippingRange();
    cold.push_back(frame());
    trace.push_back(1e3 * mapper->GetTraceTime());
    shade.push_back(1e3 * mapper->GetShadeTime());
  }
  for (int i = 0; i < settings.Frames; ++i)
  {
    redisplay.push_back(frame());
    property->SetDiffuse(0.6 + 0.01 * i);
    reshade.push_back(frame());
  }
  for (int i = 0; i < settings.Frames; ++i)
  {
    property->GetIsoSurfaceValues()->SetValue(0, SweepIsovalue(result, range, i));
    threshold.push_back(frame());
  }
  const auto pixels = static_cast<double>(mapper->GetNumberOfRays());
  frame();
  result.HitShare = static_cast<double>(mapper->GetNumberOfDefiniteHits()) / pixels;
  mapper->SpaceLeapingOff();
  for (int i = 0; i < 2; ++i)
  {
    mapper->ReleaseReuse();
    plain.push_back(frame());
  }
  result.Cold = Median(cold);
  result.Trace = Median(trace);
  result.Shade = Median(shade);
  result.Threshold = Median(threshold);
  result.Reshade = Median(reshade);
  result.Redisplay = Median(redisplay);
  result.PlainCold = *std::min_element(plain.begin(), plain.end());
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

bool ReadSettings(int argc, char* argv[], Settings& settings)
{
  for (int i = 1; i < argc; ++i)
  {
    const bool hasNext = i + 1 < argc;
    if (!std::strcmp(argv[i], "--window"))
    {
      settings.Window = true;
    }
    else if (!std::strcmp(argv[i], "--size") && hasNext)
    {
      settings.Size = std::atoi(argv[++i]);
    }
    else if (!std::strcmp(argv[i], "--frames") && hasNext)
    {
      settings.Frames = std::atoi(argv[++i]);
    }
    else if (!std::strcmp(argv[i], "--json") && hasNext)
    {
      settings.Json = argv[++i];
    }
    else if (argv[i][0] != '-' && hasNext)
    {
      settings.Volumes.push_back({ argv[i], std::atof(argv[i + 1]) });
      ++i;
    }
    else
    {
      return false;
    }
  }
  if (settings.Volumes.empty())
  {
    settings.Volumes = { { "spheres256", 100 }, { "marschner-lobb256", 128 },
      { "marschner-lobb512", 128 }, { "engine.vti", 70 }, { "engine.vti", 180 },
      { "brain.vti", 40 }, { "brain.vti", 90 }, { "cthead.vti", 600 }, { "bonsai.vti", 40 },
      { "aneurism.vti", 60 }, { "heptane.vti", 60 }, { "isabel.vti", 20 }, { "homo.vti", 0.03 },
      { "ch2better.nii.gz", 40 } };
  }
  return settings.Size > 0 && settings.Frames > 0;
}

void WriteJson(const Settings& settings, const std::vector<Result>& results)
{
  std::FILE* file = std::fopen(settings.Json.c_str(), "w");
  if (!file)
  {
    std::fprintf(
      stderr, "Cannot write %s; name a file in a folder that exists.\n", settings.Json.c_str());
    return;
  }
  std::fprintf(file, "{\n  \"pixels\": %d,\n  \"threads\": %d,\n  \"results\": [\n", settings.Size,
    vtkSMPTools::GetEstimatedNumberOfThreads());
  for (const Result& r : results)
  {
    std::fprintf(file,
      "    {\"volume\": \"%s\", \"isovalue\": %g, \"hitShare\": %.4f, \"firstMs\": %.2f, "
      "\"coldMs\": %.2f, \"traceMs\": %.2f, \"shadeMs\": %.2f, \"thresholdMs\": %.2f, "
      "\"reshadeMs\": %.2f, \"redisplayMs\": %.2f, \"plainColdMs\": %.2f, \"extractionMs\": %.2f, "
      "\"polygonsMs\": %.2f}%s\n",
      r.Name.c_str(), r.Isovalue, r.HitShare, r.First, r.Cold, r.Trace, r.Shade, r.Threshold,
      r.Reshade, r.Redisplay, r.PlainCold, r.Extraction, r.Polygons,
      &r == &results.back() ? "" : ",");
  }
  std::fprintf(file, "  ]\n}\n");
  std::fclose(file);
}

}

int main(int argc, char* argv[])
{
  Settings settings;
  if (!ReadSettings(argc, argv, settings))
  {
    std::fprintf(stderr,
      "Usage: %s [--size PIXELS] [--frames N] [--json FILE] [--window] [VOLUME ISOVALUE]...\n",
      argv[0]);
    return 1;
  }
  std::printf("%d x %d pixels, %d threads; medians in ms; polygons: vtkFlyingEdges3D%s\n\n",
    settings.Size, settings.Size, vtkSMPTools::GetEstimatedNumberOfThreads(),
    settings.Window ? " + vtkPolyDataMapper" : ", extraction alone");
  std::printf(
    "| volume | isovalue | hit | first | cold | (trace + shade) | new isovalue | Reshade | "
    "Redisplay | plain cold | extraction | + drawing | polygons / new isovalue |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  std::vector<Result> results;
  for (const Volumes::Sample& sample : settings.Volumes)
  {
    vtkSmartPointer<vtkImageData> image = Volumes::Load(sample.Name);
    if (!image)
    {
      std::fprintf(stderr, "%s is not there: left out.\n", sample.Name.c_str());
      continue;
    }
    Result r;
    r.Name = sample.Name;
    r.Isovalue = sample.Isovalue;
    TimeMapper(image, settings, r);
    TimePolygons(image, settings, r);
    results.push_back(r);
    const double peer = settings.Window ? r.Polygons : r.Extraction;
    std::printf(
      "| %s | %g | %.0f %% | %.0f | %.1f | %.1f + %.1f | %.1f | %.1f | %.1f | %.0f | %.0f | "
      "%.0f | %.1f |\n",
      r.Name.c_str(), r.Isovalue, 100.0 * r.HitShare, r.First, r.Cold, r.Trace, r.Shade,
      r.Threshold, r.Reshade, r.Redisplay, r.PlainCold, r.Extraction, r.Polygons,
      peer / r.Threshold);
    std::fflush(stdout);
  }
  if (!settings.Json.empty())
  {
    WriteJson(settings, results);
  }
  return results.empty() ? 1 : 0;
}
