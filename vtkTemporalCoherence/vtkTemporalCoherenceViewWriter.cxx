// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceViewWriter.h"

#include "ViewFile/CinemaWriter.h"
#include "ViewFile/DescriptionFromVolume.h"
#include "ViewFile/ViewFile.h"
#include "ViewFile/ViewMaker.h"
#include "ViewFile/ViewPage.h"
#include "ViewFile/ViewPoster.h"
#include "ViewFile/WholeFile.h"
#include "vtkTemporalCoherenceVolumeMapper.h"
#include "vtkTemporalCoherenceVolumeMapperInternals.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <new>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTemporalCoherenceViewWriter);

namespace
{

constexpr int MostViews = 64;

/// Where a view is seen from.
struct NamedCamera
{
  std::string Name;
  vtkSmartPointer<vtkCamera> Camera; ///< null: that of the renderer
};

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Gives a renderer another camera, and its own one back.
class OtherCamera
{
public:
  OtherCamera(vtkRenderer* renderer, vtkVolume* volume, vtkCamera* camera)
    : Renderer(renderer)
    , Own(renderer->GetActiveCamera())
  {
    if (camera)
    {
      renderer->SetActiveCamera(camera);
      renderer->ResetCameraClippingRange(volume->GetBounds());
    }
  }
  ~OtherCamera() { this->Renderer->SetActiveCamera(this->Own); }
  OtherCamera(const OtherCamera&) = delete;
  OtherCamera& operator=(const OtherCamera&) = delete;

private:
  vtkRenderer* Renderer;
  vtkSmartPointer<vtkCamera> Own;
};

}

/// The views to write.
struct vtkTemporalCoherenceViewWriter::Internals
{
  std::vector<NamedCamera> Cameras;

  /// Those, or the view of the renderer's camera.
  std::vector<NamedCamera> Wanted() const
  {
    return this->Cameras.empty() ? std::vector<NamedCamera>{ { "View 1", nullptr } }
                                 : this->Cameras;
  }

  /// Collects the views of a volume.
  class Collection;
};

class vtkTemporalCoherenceViewWriter::Internals::Collection
{
public:
  Collection(vtkTemporalCoherenceViewWriter* writer, vtkRenderer* renderer, vtkVolume* volume)
    : Writer(writer)
    , Renderer(renderer)
    , Volume(volume)
    , Mapper(vtkTemporalCoherenceVolumeMapper::SafeDownCast(volume->GetMapper()))
    , Maker(writer->Tolerance)
  {
  }

  /// \return false on error, or after a stop (without an error)
  bool AddAll(
    const std::vector<NamedCamera>& wanted, const TemporalCoherence::ReportProgress& report)
  {
    const double each = 1.0 / static_cast<double>(wanted.size());
    for (std::size_t view = 0; view < wanted.size(); ++view)
    {
      const double begin = each * static_cast<double>(view);
      if (!this->Add(wanted[view], TemporalCoherence::PartOf(report, begin, begin + each)))
      {
        return false;
      }
    }
    return !this->Writer->AbortExecute;
  }

  TemporalCoherence::ViewFileMaker File;
  TemporalCoherence::ViewDescription Description;
  std::vector<std::uint8_t> Poster;               ///< of the first view
  TemporalCoherence::ValueBand Range{ 1.0, 0.0 }; ///< of the first view
  std::size_t Knots = 0;
  std::string Error;

private:
  bool Add(const NamedCamera& wanted, const TemporalCoherence::ReportProgress& report)
  {
    const OtherCamera camera(this->Renderer, this->Volume, wanted.Camera);
    TemporalCoherence::FrameRequest request;
    if (!this->MakeRequest(request))
    {
      return false;
    }
    const TemporalCoherence::FrameKey& key = request.Key;
    this->Error = TemporalCoherence::ViewFileMaker::WhyNot();
    this->Error = this->Error.empty() ? TemporalCoherence::ViewMaker::WhyNot(key) : this->Error;
    if (!this->Error.empty())
    {
      return false;
    }
    auto& mapper = *this->Mapper->Internal;
    const vtkTemporalCoherenceVolumeMapper::Internals::Reading reading(request);
    const vtkTemporalCoherenceVolumeMapper::Internals::Busy busy(mapper);
    TemporalCoherence::KnotImage knots;
    const bool isMade = this->Maker.Make(key, this->RangeOf(key), report, knots, this->Error);
    if (isMade && this->Views == 0)
    {
      this->Describe(key, knots.Values);
    }
    this->Error = this->Error.empty() ? reading.Mistake() : this->Error;
    if (!isMade || !this->Error.empty())
    {
      return false;
    }
    TemporalCoherence::ViewGeometry geometry =
      TemporalCoherence::GeometryOf(key, this->Renderer, this->Writer->Tolerance);
    geometry.Name = wanted.Name;
    this->Knots += knots.Knots[0].Progress.size() + knots.Knots[1].Progress.size();
    this->File.Add(geometry, knots);
    ++this->Views;
    return true;
  }

  bool MakeRequest(TemporalCoherence::FrameRequest& request)
  {
    if (!this->Mapper)
    {
      this->Error = "WriteView needs a volume whose mapper is a vtkTemporalCoherenceVolumeMapper.";
      return false;
    }
    auto& internal = *this->Mapper->Internal;
    if (internal.IsBusy("WriteView"))
    {
      this->Error = "The mapper is making a frame.";
      return false;
    }
    if (this->Mapper->GetNumberOfInputConnections(0) > 0)
    {
      this->Mapper->Update();
    }
    const glm::ivec2 size(this->Writer->Size[0], this->Writer->Size[1]);
    vtkTemporalCoherenceVolumeMapper::Internals::SharedProgress progress(
      [](double /*done*/) { return true; });
    return internal.MakeRequest(this->Volume,
      { this->Renderer, size, static_cast<double>(size.x) / size.y }, progress, request,
      this->Error);
  }

  TemporalCoherence::ValueBand RangeOf(const TemporalCoherence::FrameKey& key)
  {
    constexpr double leftOut = 0.05;
    if (this->Surfaces.Counts.empty())
    {
      this->Surfaces = this->Maker.CountSurfaces(key);
    }
    const double* const asked = this->Writer->Range;
    if (asked[0] <= asked[1] || this->Surfaces.Counts.empty())
    {
      return { asked[0], asked[1] };
    }
    return { this->Surfaces.IsovalueAt(leftOut), this->Surfaces.IsovalueAt(1.0 - leftOut) };
  }

  void Describe(const TemporalCoherence::FrameKey& key, const TemporalCoherence::ValueBand& range)
  {
    this->Description.Texts = { this->Writer->Title, this->Writer->Caption, this->Writer->Citation,
      {}, this->Writer->Units };
    this->Description.Look =
      TemporalCoherence::LookOf(key, this->Surfaces, this->Renderer, this->Volume);
    this->Description.Histogram = { this->Surfaces.Range, this->Surfaces.Counts };
    this->Range = range;
    this->Poster = TemporalCoherence::PosterOf(
      this->Maker.Draw(key, this->Description.Look.Surfaces, range), this->Description.Look);
  }

  vtkTemporalCoherenceViewWriter* Writer;
  vtkRenderer* Renderer;
  vtkVolume* Volume;
  vtkTemporalCoherenceVolumeMapper* Mapper;
  TemporalCoherence::ViewMaker Maker;
  TemporalCoherence::SurfaceHistogram Surfaces;
  int Views = 0;
};

//------------------------------------------------------------------------------
vtkTemporalCoherenceViewWriter::vtkTemporalCoherenceViewWriter()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkTemporalCoherenceViewWriter::~vtkTemporalCoherenceViewWriter() = default;

//------------------------------------------------------------------------------
void vtkTemporalCoherenceViewWriter::SetSize(int width, int height)
{
  constexpr int most = 16384;
  const int size[2] = { std::min(std::max(width, 1), most), std::min(std::max(height, 1), most) };
  if (size[0] != this->Size[0] || size[1] != this->Size[1])
  {
    std::copy(size, size + 2, this->Size);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceViewWriter::SetText(const char* text, std::string& setting)
{
  if (setting != (text ? text : ""))
  {
    setting = text ? text : "";
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceViewWriter::AddView(const char* name, vtkCamera* camera)
{
  if (!camera || this->GetNumberOfViews() >= MostViews)
  {
    vtkErrorMacro("AddView needs a camera, and takes at most " << MostViews << " views.");
    return;
  }
  vtkNew<vtkCamera> copy;
  copy->DeepCopy(camera);
  const std::string number = std::to_string(this->GetNumberOfViews() + 1);
  this->Internal->Cameras.push_back({ name ? name : "View " + number, copy });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceViewWriter::AddOrbit(int count, vtkRenderer* renderer)
{
  if (count < 1 || count > MostViews || !renderer)
  {
    vtkErrorMacro("AddOrbit needs a renderer, and 1 to " << MostViews << " views.");
    return;
  }
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(renderer->GetActiveCamera());
  constexpr double whole = 360.0;
  for (int view = 0; view < count; ++view)
  {
    this->AddView(nullptr, camera);
    camera->Azimuth(whole / count);
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceViewWriter::RemoveAllViews()
{
  this->Internal->Cameras.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkTemporalCoherenceViewWriter::GetNumberOfViews() const
{
  return static_cast<int>(this->Internal->Cameras.size());
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceViewWriter::WriteView(
  const char* path, vtkRenderer* renderer, vtkVolume* volume)
{
  const std::string file = path ? path : "";
  const bool isPage = EndsWith(file, ".html"), isDatabase = EndsWith(file, ".cdb");
  if (!renderer || !volume || !(isPage || isDatabase || EndsWith(file, ".tcview")))
  {
    vtkErrorMacro("WriteView needs a renderer, a volume, and a path that ends in .html, .tcview or "
                  ".cdb; it was given \""
      << file << "\".");
    return false;
  }
  this->AbortExecute = 0;
  const auto report = [this](double done)
  {
    this->InvokeEvent(vtkCommand::ProgressEvent, &done);
    return !this->AbortExecute;
  };
  std::string error;
  try
  {
    Internals::Collection views(this, renderer, volume);
    constexpr double shareOfKnots = 0.9, shareOfImages = 0.99; // 1 tells that all is written
    if (!views.AddAll(
          this->Internal->Wanted(), TemporalCoherence::PartOf(report, 0.0, shareOfKnots)))
    {
      if (!views.Error.empty())
      {
        vtkErrorMacro(<< views.Error);
      }
      return false;
    }
    std::vector<std::uint8_t> bytes = views.File.Finish(views.Description);
    if (isPage)
    {
      bytes = TemporalCoherence::PageOf(bytes, views.Poster, views.Description.Texts);
    }
    error = isDatabase ? TemporalCoherence::WriteCinema(file, bytes, this->NumberOfIsovalues,
                           TemporalCoherence::PartOf(report, shareOfKnots, shareOfImages))
                       : TemporalCoherence::ReplaceFile(file, bytes);
    if (error.empty() && this->AbortExecute)
    {
      return false;
    }
    if (error.empty())
    {
      this->BytesWritten = static_cast<vtkIdType>(bytes.size());
      this->NumberOfKnots = static_cast<vtkIdType>(views.Knots);
      this->WrittenRange[0] = views.Range.Low;
      this->WrittenRange[1] = views.Range.High;
    }
  }
  catch (const std::bad_alloc&)
  {
    error = "There is not enough memory for the views; ask for a smaller size or range.";
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return false;
  }
  report(1.0);
  return true;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceViewWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Range: " << this->Range[0] << ", " << this->Range[1] << '\n';
  os << indent << "Tolerance: " << this->Tolerance << '\n';
  os << indent << "Size: " << this->Size[0] << ", " << this->Size[1] << '\n';
  os << indent << "NumberOfIsovalues: " << this->NumberOfIsovalues << '\n';
  os << indent << "Title: " << this->Title << '\n';
  os << indent << "Caption: " << this->Caption << '\n';
  os << indent << "Citation: " << this->Citation << '\n';
  os << indent << "Units: " << this->Units << '\n';
  os << indent << "NumberOfViews: " << this->GetNumberOfViews() << '\n';
  os << indent << "AbortExecute: " << this->AbortExecute << '\n';
}
VTK_ABI_NAMESPACE_END
