// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_GlassScene_h
#define Testing_GlassScene_h

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Truth/BruteForceTracer.h"
#include "Truth/Compositor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

/// Translucent isosurfaces of volumes and translucent or opaque polygons, peeled by depth in a
/// window; and what is seen in a pixel by a compositor that finds all surfaces and all triangles on
/// its line of sight by brute force, in double.
class GlassScene
{
public:
  using Color = std::array<double, 3>;
  using Sheet = Compositor::Sheet;

  static constexpr int Width = 100, Height = 80;
  /// Depths this near may come in either order: those of polygons are interpolated in float.
  static constexpr double DepthStep = 2e-6;
  /// Triangles cover pixels whose centres are this near to their outline, or do not.
  static constexpr int PartsOfPixel = 63, OutlineParts = 2;

  /// How many pixels are how far from the truth.
  struct Result
  {
    int Compared = 0, Wrong = 0;
    int Undecided = 0;    ///< more than the bound off, at an outline or where two depths are equal
    int Mixed = 0;        ///< of those compared, with polygons and isosurfaces
    double Largest = 0.0; ///< difference, of 255
    double Mean = 0.0;    ///< of the differences of mixed pixels
  };

  explicit GlassScene(const Color& background = { 0.2, 0.4, 0.6 })
    : Ground(background)
  {
    this->Renderer->SetBackground(background.data());
    this->Renderer->SetUseDepthPeeling(1);
    this->Renderer->SetUseDepthPeelingForVolumes(1);
    this->Renderer->SetMaximumNumberOfPeels(40);
    this->Renderer->SetOcclusionRatio(0.0);
    this->Window->SetAlphaBitPlanes(1);
    OpenWindow(this->Window, this->Renderer, Width, Height);
  }

  /// \param nodes value, red, green, blue, opacity of each isovalue
  Scene& AddVolume(vtkImageData* image, const std::vector<std::array<double, 5>>& nodes)
  {
    std::vector<double> isovalues;
    for (const std::array<double, 5>& node : nodes)
    {
      isovalues.push_back(node[0]);
    }
    this->Volumes.push_back(std::make_unique<Scene>(image, isovalues));
    Scene& scene = *this->Volumes.back();
    SetColors(scene, nodes);
    scene.Volume->GetProperty()->ShadeOff();
    scene.Renderer->SetActiveCamera(this->Renderer->GetActiveCamera());
    this->Renderer->AddVolume(scene.Volume);
    this->Errors.push_back(
      std::make_unique<EventCounter>(scene.Mapper.Get(), vtkCommand::ErrorEvent));
    return scene;
  }

  /// Triangles, or polygons that are convex; without light.
  vtkActor* AddPolygons(vtkPolyData* mesh, const Color& color, double opacity)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    actor->GetProperty()->SetOpacity(opacity);
    this->Renderer->AddActor(actor);
    this->Meshes.emplace_back(actor);
    return actor;
  }

  /// Draw, and compare each pixel.
  Result Compare(double bound)
  {
    this->Window->Render();
    Result result;
    const auto pixels = PixelsOf(this->Window);
    std::vector<Compositor> truths;
    for (std::size_t i = 0; i < this->Volumes.size(); ++i)
    {
      Scene& scene = *this->Volumes[i];
      truths.emplace_back(scene, vtkImageData::SafeDownCast(scene.Mapper->GetDataObjectInput()));
    }
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const Sights sights = this->SightsAt(truths, x, y);
        const unsigned char* shown = pixels->GetPointer(4 * (y * Width + x));
        double difference = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
        {
          difference = std::max(difference, std::abs(255.0 * sights.Seen[c] - shown[c]));
        }
        if (difference > bound && !this->IsDecided(truths, x, y, sights))
        {
          ++result.Undecided;
          continue;
        }
        ++result.Compared;
        result.Wrong += difference > bound;
        result.Largest = std::max(result.Largest, difference);
        if (sights.OfVolumes > 0 && sights.OfPolygons > 0)
        {
          ++result.Mixed;
          result.Mean += difference;
        }
      }
    }
    for (const auto& errors : this->Errors)
    {
      Expect(errors->Count == 0, "an error");
    }
    result.Mean /= std::max(result.Mixed, 1);
    return result;
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  std::vector<std::unique_ptr<Scene>> Volumes;

private:
  struct Sights
  {
    Color Seen{};
    std::vector<double> Depths; ///< of the depth buffer, front to back
    int OfVolumes = 0, OfPolygons = 0;
  };

  /// All triangles of an actor on a line.
  void AddTriangles(
    vtkActor* actor, const BruteForceTracer::Line& line, std::vector<Sheet>& to) const
  {
    vtkPolyData* mesh = vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput();
    vtkProperty* property = actor->GetProperty();
    const double* paint = property->GetColor();
    vtkCellArray* cells = mesh->GetPolys();
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      vtkIdType count;
      const vtkIdType* ids;
      cells->GetCellAtId(cell, count, ids);
      for (vtkIdType i = 2; i < count; ++i)
      {
        std::array<Color, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
        {
          const std::array<vtkIdType, 3> which = { 0, i - 1, i };
          std::array<double, 4> point{ 0.0, 0.0, 0.0, 1.0 };
          mesh->GetPoint(ids[which[k]], point.data());
          actor->GetMatrix()->MultiplyPoint(point.data(), point.data());
          std::copy_n(point.begin(), 3, corners[k].begin());
        }
        double t = 0.0;
        if (Meets(corners, line, t))
        {
          const double light = property->GetLighting() ? this->LightOf(corners) : 1.0;
          to.push_back({ t,
            { light * paint[0], light * paint[1], light * paint[2], property->GetOpacity() } });
        }
      }
    }
  }

  static Color Minus(const Color& a, const Color& b)
  {
    return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
  }

  /// Where a line meets a triangle.
  static bool Meets(
    const std::array<Color, 3>& corners, const BruteForceTracer::Line& line, double& t)
  {
    const Color u = Minus(corners[1], corners[0]), v = Minus(corners[2], corners[0]);
    const Color from = Minus(line.Origin, corners[0]);
    Color p, q;
    vtkMath::Cross(line.Direction.data(), v.data(), p.data());
    vtkMath::Cross(from.data(), u.data(), q.data());
    const double volume = vtkMath::Dot(u.data(), p.data());
    const double shareOfU = vtkMath::Dot(from.data(), p.data()) / volume;
    const double shareOfV = vtkMath::Dot(line.Direction.data(), q.data()) / volume;
    t = vtkMath::Dot(v.data(), q.data()) / volume;
    return volume != 0.0 && shareOfU >= 0.0 && shareOfV >= 0.0 && shareOfU + shareOfV <= 1.0 &&
      t > line.Begin && t < line.End;
  }

  /// How much light of a headlight a triangle reflects.
  double LightOf(const std::array<Color, 3>& corners) const
  {
    Color normal, forward;
    vtkMath::Cross(
      Minus(corners[1], corners[0]).data(), Minus(corners[2], corners[0]).data(), normal.data());
    vtkMath::Normalize(normal.data());
    this->Renderer->GetActiveCamera()->GetDirectionOfProjection(forward.data());
    return std::abs(vtkMath::Dot(normal.data(), forward.data()));
  }

  /// \param partX, partY of a pixel, from its middle
  Sights SightsAt(std::vector<Compositor>& truths, int x, int y, int partX = 0, int partY = 0) const
  {
    constexpr int parts = PartsOfPixel;
    const int width = parts * Width, height = parts * Height;
    const int column = parts * x + parts / 2 + partX, row = parts * y + parts / 2 + partY;
    std::vector<Sheet> sheets;
    for (Compositor& truth : truths)
    {
      const std::vector<Sheet> more = truth.SheetsAt(column, row, width, height);
      sheets.insert(sheets.end(), more.begin(), more.end());
    }
    Sights sights;
    sights.OfVolumes = static_cast<int>(sheets.size());
    const BruteForceTracer::Line line =
      BruteForceTracer::LineThrough(this->Renderer, column, row, width, height);
    for (vtkActor* actor : this->Meshes)
    {
      this->AddTriangles(actor, line, sheets);
    }
    sights.OfPolygons = static_cast<int>(sheets.size()) - sights.OfVolumes;
    std::stable_sort(sheets.begin(), sheets.end(),
      [](const Sheet& a, const Sheet& b) { return a.Distance < b.Distance; });
    double passed = 1.0;
    for (const Sheet& sheet : sheets)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        sights.Seen[c] += passed * sheet.Color[3] * sheet.Color[c];
      }
      passed *= 1.0 - sheet.Color[3];
      sights.Depths.push_back(this->DepthAt(line, sheet.Distance));
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      sights.Seen[c] += passed * this->Ground[c];
    }
    return sights;
  }

  double DepthAt(const BruteForceTracer::Line& line, double t) const
  {
    const std::array<double, 3> at = line.PointAt(t);
    std::array<double, 4> point{ at[0], at[1], at[2], 1.0 };
    this->Renderer->GetActiveCamera()
      ->GetCompositeProjectionTransformMatrix(static_cast<double>(Width) / Height, 0.0, 1.0)
      ->MultiplyPoint(point.data(), point.data());
    return point[2] / point[3];
  }

  /// False where surfaces are equally deep, and at outlines.
  bool IsDecided(std::vector<Compositor>& truths, int x, int y, const Sights& sights) const
  {
    for (std::size_t i = 1; i < sights.Depths.size(); ++i)
    {
      if (sights.Depths[i] - sights.Depths[i - 1] < DepthStep)
      {
        return false;
      }
    }
    for (const auto& [dx, dy] : { std::pair(-1, -1), { -1, 1 }, { 1, -1 }, { 1, 1 } })
    {
      const Sights beside = this->SightsAt(truths, x, y, dx * OutlineParts, dy * OutlineParts);
      if (beside.OfVolumes != sights.OfVolumes || beside.OfPolygons != sights.OfPolygons)
      {
        return false;
      }
    }
    return true;
  }

  Color Ground;
  std::vector<vtkSmartPointer<vtkActor>> Meshes;
  std::vector<std::unique_ptr<EventCounter>> Errors;
};

#endif
