// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MapperFrames_h
#define TemporalCoherence_MapperFrames_h

#include "Frames/ViewerStates.h"
#include "Output/ImageFromFrame.h"
#include "Render/LineTracer.h"
#include "Request/RequestFromMapper.h"
#include "Window/PixelHit.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkPolyData;
class vtkRenderer;
class vtkVolume;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Makes, keeps, shows and reads the frames of a mapper for all of its viewers. Lack of memory is
/// an error message, never an exception.
class MapperFrames
{
public:
  /// Make a frame. It becomes the last frame.
  /// \param report called with the progress, which never falls; may stop the frame
  /// \param error  receives the mistake and its remedy; empty if the report stopped it
  /// \return false if no frame is made; the last frame is then unchanged
  bool Render(const Viewer& viewer, const FrameRequest& request,
    const FrameRenderer::Options& options, const ReportProgress& report, std::string& error);

  /// The rays that a viewer's next frame for a window may trace.
  /// \param pixels, allowed, most, kind as in RayBudget::Choose
  RayBudget::Choice ChooseRays(
    const Viewer& viewer, std::int64_t pixels, double allowed, double most, int kind) const;

  /// Learn how long rays took in the last frame.
  /// \param allowed, kind as in RayBudget::Learn
  void LearnTimes(double allowed, int kind) { this->Last->LearnTimes(allowed, kind); }

  /// Set the number of window pixels that the last frame fills along each axis.
  void SetPictureSize(const glm::ivec2& size) { this->Last->PictureSize = size; }

  /// Build the isomap that a frame needs. The last frame stays.
  /// \param report, error as in Render
  Isomap::Outcome BuildIsomap(const Viewer& viewer, const FrameRequest& request,
    const FrameRenderer::Options& options, const ReportProgress& report, std::string& error);

  /// Show the last frame of a renderer's viewer, if it has this size, in its window or to its
  /// selector.
  /// \param size in pixels of the window
  /// \param data the points and cells for the selector; or null
  /// \param error receives the mistake and its remedy
  /// \param part of the picture to draw in its window
  void Present(vtkRenderer* renderer, vtkVolume* volume, const glm::ivec2& size, vtkDataSet* data,
    std::string& error, PicturePart part = PicturePart::All);

  /// Write arrays of the last frame into images; see ImageFromFrame.h.
  /// \return false if there is none, or on error
  bool WriteImages(const std::vector<FrameImage>& images, std::string& error) const;

  /// Copy the last frame into an image as the buffers of a window hold it; see BufferImages.h.
  /// \return false if there is none, or on error
  bool WriteBufferColors(vtkImageData* image, std::string& error) const;
  bool WriteBufferDepths(
    vtkImageData* image, int scalarType, bool endsAtBox, std::string& error) const;

  /// Make points of the hits of the last frame.
  /// \return false if there is none, or on error
  bool WriteSurface(vtkPolyData* points, std::string& error) const;

  /// The hit that the last frame shows at a pixel of the window.
  std::optional<PixelHit> FindHit(int x, int y) const;

  /// The cell whose surface the last frame shows at a pixel; none unless the data are a mesh.
  CellOrigin FindCell(int x, int y) const;

  /// The first surface on a line in the world; see LineTracer.h.
  std::optional<LineHit> FindHit(const FrameRequest& request, const glm::dvec3& begin,
    const glm::dvec3& end, std::string& error);

  /// Position in the property's list of an isovalue of the last frame; -1 if that is blended.
  int PlaceOf(int surface) const
  {
    const std::vector<int>& places = this->Last->IsovaluePlaces;
    return places.empty() ? -1 : places[static_cast<std::size_t>(surface)];
  }

  /// Rays of the last frame along each axis; 0 if there is none.
  const glm::ivec2& LastSize() const { return this->Last->Engine.LastFrame().Size; }

  /// The samples of the last frame, with their hidden cells.
  const Field& LastSamples() const { return this->Last->Engine.LastKey().Samples; }

  /// Value ranges of the last frame; undefined without cells or isovalues.
  const ValueRangePyramid& LastRanges() const { return this->Last->Engine.LastRanges(); }

  /// Statistics of the last frame.
  const FrameStatistics& Statistics() const { return this->Last->Engine.Statistics(); }

  /// The isomap of the viewer that last requested a frame or an isomap.
  const Isomap& LastIsomap() const { return this->Mapped->Engine.IsomapOfLastView(); }
  bool IsIsomapTooLarge() const { return this->Mapped->Engine.IsIsomapTooLarge(); }
  double IsomapBuildTime() const { return this->Mapped->Engine.IsomapBuildTime(); }

  /// Seconds for showing the last frame.
  double PresentTime() const { return this->SecondsToPresent; }

  /// Reset PresentTime() when a frame begins.
  void ResetPresentTime() { this->SecondsToPresent = 0.0; }

  /// Forget all frames and free their memory.
  void Release()
  {
    this->Viewers = ViewerStates();
    this->Last = this->Mapped = this->Viewers.MakeState();
  }

  /// Free resources in the context of a window; in any context if it is null.
  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Viewers.ReleaseGraphicsResources(window);
  }

private:
  ViewerStates Viewers;
  std::shared_ptr<ViewerState> Last = Viewers.MakeState(); ///< of the last frame
  std::shared_ptr<ViewerState> Mapped = Last; ///< of the last request for an isomap or a frame
  double SecondsToPresent = 0.0;
};

}

#endif
