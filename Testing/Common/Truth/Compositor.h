// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Compositor_h
#define Testing_Compositor_h

#include "Scenes/Scene.h"
#include "Truth/BruteForceRegion.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

/// Composites the surfaces of a scene without any code of the engine: all crossings of all
/// isovalues, found by brute force within the region.
class Compositor
{
public:
  using Point = std::array<double, 3>;

  /// \param data a vtkImageData or a vtkRectilinearGrid, whose point scalars are drawn
  template <typename DataSet>
  Compositor(Scene& scene, DataSet* data)
    : Compositor(scene, BruteForceTracer(data, scene.Volume), data->GetDimensions())
  {
  }

  /// \param samples along each axis
  Compositor(Scene& scene, const BruteForceTracer& truth, const int samples[3]);

  /// A surface as it is seen in a pixel.
  struct Sheet
  {
    double Distance;             ///< along the line of sight, which begins at the eye
    std::array<double, 4> Color; ///< red, green, blue, alpha; not premultiplied
  };

  /// The surfaces of a pixel, front to back.
  std::vector<Sheet> SheetsAt(int x, int y, int width, int height);

  /// Premultiplied red, green, blue; and alpha.
  std::array<double, 4> ColorAt(int x, int y, int width, int height);

  /// Opacity by gradient magnitude, if not 1.
  std::function<double(double)> OpacityByGradient = [](double) { return 1.0; };

  /// Changes the look of a surface at a place of the world: its red, green, blue and alpha.
  std::function<void(const Point&, std::array<double, 4>&)> ChangeLook =
    [](const Point&, std::array<double, 4>&) {};

private:
  struct Layer;
  std::vector<Layer> LayersOf(const BruteForceTracer::Line& line);
  bool IsCap(const BruteForceTracer::Hit& hit, const BruteForceTracer::Line& line) const;
  std::array<double, 4> ColorOf(const Layer& layer, const BruteForceTracer::Line& line) const;
  Point GradientAt(const Point& world) const;

  Scene& Of;
  mutable BruteForceTracer Truth;
  BruteForceRegion Region;
  std::vector<double> Isovalues;
  Point Last; ///< sample along each axis
};

/// Render a scene and compare its picture with the compositor.
void ExpectComposite(
  const std::string& name, Scene& scene, Compositor compositor, int width = 100, int height = 80);

/// Give a scene's volume nodes of its transfer functions: value, red, green, blue, opacity.
void SetColors(Scene& scene, const std::vector<std::array<double, 5>>& nodes);

#endif
