// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTemporalCoherenceVolumeMapperInternals_h
#define vtkTemporalCoherenceVolumeMapperInternals_h

#include "Frames/MapperFrames.h"
#include "Input/DivisionError.h"
#include "Request/EmptyPicture.h"
#include "Request/IsovalueCheck.h"
#include "Request/RequestFromMapper.h"
#include "Window/WindowRays.h"
#include "vtkTemporalCoherenceVolumeMapper.h"

#include <vtkNew.h>

#include <optional>
#include <string>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
/// The state of a mapper besides its settings, and how it makes a frame with them.
struct vtkTemporalCoherenceVolumeMapper::Internals
{
  explicit Internals(vtkTemporalCoherenceVolumeMapper* self)
    : Self(self)
  {
  }

  vtkTemporalCoherenceVolumeMapper* const Self;
  TemporalCoherence::RequestFromMapper Requests;
  TemporalCoherence::MapperFrames Frames;
  TemporalCoherence::WindowRays Rays;
  TemporalCoherence::EmptyPicture Empties;
  TemporalCoherence::IsovalueCheck Isovalues;
  std::string LastError;               ///< reported already; empty after a frame without error
  std::string LastMistake;             ///< in reading samples
  std::string LastSettingError;        ///< of SetWithin; empty after a valid number
  bool HasWarned = false;              ///< of the memory limit
  bool HasWarnedOfDivision = false;    ///< and the error is still large
  bool HasWarnedOfOverlap = false;     ///< and cells still overlap
  bool HasWarnedOfBounded = false;     ///< the removed accuracy BOUNDED
  TemporalCoherence::FieldSetUp SetUp; ///< of the last frame
  vtkNew<vtkTemporalCoherenceStatistics> Statistics;
  bool IsMaking = false; ///< a frame or an isomap, while observers may call anything

  /// Sets IsMaking for as long as it lives.
  class Busy
  {
  public:
    explicit Busy(Internals& internal)
      : Of(internal)
    {
      this->Of.IsMaking = true;
    }
    ~Busy() { this->Of.IsMaking = false; }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;

  private:
    Internals& Of;
  };

  /// Tells volumes that are read as they are needed that a frame begins, and then that it ended.
  class Reading
  {
  public:
    explicit Reading(const TemporalCoherence::FrameRequest& request);
    ~Reading();
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

    /// What could not be read; empty: all could.
    std::string Mistake() const;

  private:
    const TemporalCoherence::FrameRequest& Request;
  };

  /// Progress of the whole work. If a mesh is set up first, that takes the first half.
  class SharedProgress
  {
  public:
    explicit SharedProgress(TemporalCoherence::ReportProgress whole)
      : Whole(std::move(whole))
    {
    }

    TemporalCoherence::ReportProgress OfSetUp()
    {
      return [this](double progress)
      {
        this->IsShared = true;
        return this->Whole(0.5 * progress);
      };
    }
    TemporalCoherence::ReportProgress OfRest() const
    {
      return this->IsShared ? TemporalCoherence::PartOf(this->Whole, 0.5, 1.0) : this->Whole;
    }

  private:
    TemporalCoherence::ReportProgress Whole;
    bool IsShared = false;
  };

  /// Make a request for a frame; see RequestFromMapper::Make.
  bool MakeRequest(vtkVolume* volume, const TemporalCoherence::FrameSight& sight,
    SharedProgress& progress, TemporalCoherence::FrameRequest& request, std::string& error);

  /// End the rays of a blended volume at the opaque props in the window.
  /// \return false if there is not enough memory
  static bool EndAtOpaqueProps(vtkRenderer* renderer, vtkVolume* volume,
    TemporalCoherence::FrameRequest& request, std::string& error);

  /// Make a frame for a window, at the mapper's distance between rays.
  /// \return false if it is not made
  bool RenderForWindow(vtkRenderer* renderer, vtkVolume* volume, int width, int height);

  /// Make a frame and write it into images, any of which may be null.
  /// \param frame receives all arrays
  bool MakeImages(vtkRenderer* renderer, vtkVolume* volume, int width, int height,
    vtkImageData* color, vtkImageData* depth, vtkImageData* frame);

  /// Make a frame.
  /// \param window may stop it; or null
  /// \param fewer  the rays that it may trace
  bool RenderFrame(vtkRenderer* renderer, vtkVolume* volume, int width, int height, double aspect,
    vtkRenderWindow* window, const TemporalCoherence::FewerRays& fewer = {});

  /// Choose how many rays a window's frame traces to finish in time.
  /// \param allowed seconds for it
  TemporalCoherence::Impatience ChooseReading(
    const TemporalCoherence::FrameRequest& request, vtkRenderWindow* window) const;
  TemporalCoherence::FewerRays ChooseRays(
    vtkRenderer* renderer, vtkVolume* volume, const glm::ivec2& rays, double allowed) const;

  /// The first surface on a line, and the input's cell that contains it.
  struct FoundOnLine
  {
    TemporalCoherence::LineHit Hit;
    int IsovaluePlace; ///< in the property's list
    TemporalCoherence::CellOrigin Cell;
  };

  /// Find the first surface on a line in the world, for IntersectWithLine. Mistakes are reported.
  std::optional<FoundOnLine> FindOnLine(vtkVolume* volume, const double p1[3], const double p2[3]);

  /// True if input, settings and property have no mistakes. Mistakes are reported.
  bool CanDraw(vtkVolume* volume);

  /// The error that a frame for a window would report; empty if it can be made.
  std::string WhyRefused(vtkRenderer* renderer, vtkVolume* volume);

  /// True while a frame or an isomap is made: its inputs must not change. Then reports an error.
  bool IsBusy(const char* method);

  /// False if the window, which may be null, asks to stop.
  static bool MayGoOn(vtkRenderWindow* window);

  /// Announce a frame. Observers may change settings, but not begin another frame.
  void TellStart();

  /// Tell how far a frame is, which was made for a window or for an image (null).
  void TellProgress(double progress, vtkRenderWindow* window);

  /// Report an error unless it is empty or was reported last.
  void ReportOnce(const std::string& error);

  /// Warn once if curved cells are divided too coarsely, or if concave ones are drawn too large.
  void WarnOfDivision();

  /// The reason why curved cells are not divided further, and its remedy.
  std::string ReasonOf(TemporalCoherence::DivisionLimit limit) const;

  /// Show a warning unless it is empty.
  void Warn(const std::string& warning);
  void WarnOfIsomapLimit(bool isTooLarge);

  /// Set a setting to a value, clamped to [low, high]. NaN is an error.
  template <typename T>
  void SetWithin(const char* name, T value, double low, double high, T& setting);

  /// The warning about a last frame that shows nothing, with the reason; an empty string for none.
  std::string CheckPicture(
    const TemporalCoherence::DrawnVolume& drawn, const TemporalCoherence::FrameRequest& request)
  {
    const bool isAnythingAsked =
      request.Key.IsBlended() || !request.Key.Isosurfaces().Isovalues.empty();
    const std::string reason = isAnythingAsked
      ? this->Empties.Check(drawn, this->Frames.LastSamples(), this->Frames.LastRanges())
      : std::string();
    return !reason.empty() ? reason
      : request.Key.Samples.HasCells() && !request.Key.IsBlended() &&
        !this->Empties.IsTold(drawn.Volume)
      ? this->Isovalues.Check(drawn, request, this->Frames.LastRanges())
      : std::string();
  }
};
VTK_ABI_NAMESPACE_END

#endif
