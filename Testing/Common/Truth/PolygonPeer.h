// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_PolygonPeer_h
#define Testing_PolygonPeer_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkDataSet;
VTK_ABI_NAMESPACE_END

/// What a window shows.
struct WindowPixels
{
  std::vector<std::array<unsigned char, 3>> Colors;
  std::vector<float> Depths; ///< of the z-buffer, in [0, 1]
};

/// How the picture of a volume agrees with that of the same surfaces as polygons.
struct PeerAgreement
{
  long OnlyVolume = 0;   ///< pixels that the volume covers and the polygons do not
  long OnlyPolygons = 0; ///< the other way round
  long Both = 0;         ///< pixels that both cover
  long Astray = 0;       ///< pixels of one only, with no outline of both within a pixel
  /// Median and 90th percentile, over the pixels that both cover, of the largest difference of a
  /// colour channel, in 1/255.
  double MedianColor = 0.0, Color90 = 0.0;
  /// The same of the distance along the view between both surfaces.
  double MedianDepth = 0.0, Depth90 = 0.0;
};

/// A volume and the same surfaces as polygons, with the same camera and lights in one off-screen
/// window, where one or the other is seen. It needs a display; call
/// vtkFloatingPointExceptions::Disable() first.
///
/// The renderer gets a light at the camera that is no headlight: VTK draws the highlights of a lone
/// headlight on polygons as max(0, N.L)^power, those of any other light with the mirrored light,
/// as on volumes since VTK 9.2.
class PolygonPeer
{
public:
  /// \param volume   has its mapper and its property
  /// \param renderer may have other props, which both pictures show
  PolygonPeer(vtkVolume* volume, vtkRenderer* renderer, int width = 300, int height = 300);
  ~PolygonPeer();
  PolygonPeer(const PolygonPeer&) = delete;
  void operator=(const PolygonPeer&) = delete;

  /// Replace the polygons by the contours of the active scalars at those isovalues of the volume's
  /// property that are not transparent (by vtkFlyingEdges3D, or vtkContourFilter if it is no
  /// image).
  void SetContours(vtkDataSet* data);

  /// Add polygons in the volume's coordinates, with point normals or without: they get its
  /// transform, and its property's shading and its colour at the isovalue.
  vtkActor* AddPolygons(vtkPolyData* polygons, double isovalue);
  void RemovePolygons();

  /// Take over what has changed in the volume's transform and property.
  void UpdatePolygons();

  /// A camera that sees all of the volume, looking from a direction.
  void LookFrom(double x, double y, double z);

  WindowPixels DrawVolume();
  WindowPixels DrawPolygons();
  PeerAgreement Compare();

  /// Compare and print a line; outlines that stray, a median of colours above 3/255 and fewer than
  /// `fewest` pixels of both are failures (Expect.h).
  PeerAgreement ExpectAgreement(const std::string& what, long fewest = 2000);

  /// Distance along the view (not along the ray) of a value of the z-buffer.
  double DistanceOf(float depth) const;

  vtkRenderWindow* GetWindow() { return this->Window; }

private:
  struct Surface
  {
    vtkSmartPointer<vtkActor> Actor;
    double Isovalue;
  };

  WindowPixels Draw(bool showsVolume, bool showsPolygons);

  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkVolume> Volume;
  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<Surface> Surfaces;
};

#endif
