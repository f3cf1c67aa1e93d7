// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Oracle/Oracle.h"

#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <sstream>

namespace Fuzz
{
namespace
{

/// Counts the events of a frame, and watches the progress rise.
class Events
{
public:
  explicit Events(Mapper* mapper)
    : Of(mapper)
    , Tags{ mapper->AddObserver(vtkCommand::VolumeMapperRenderStartEvent, this, &Events::HearStart),
      mapper->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, this, &Events::HearEnd) }
  {
  }
  ~Events()
  {
    for (const unsigned long tag : this->Tags)
    {
      this->Of->RemoveObserver(tag);
    }
  }
  Events(const Events&) = delete;
  Events& operator=(const Events&) = delete;

  int Starts = 0, Ends = 0;
  bool IsMade = false;

private:
  void HearStart() { ++this->Starts; }
  void HearEnd(vtkObject*, unsigned long, void* isMade)
  {
    ++this->Ends;
    this->IsMade = *static_cast<bool*>(isMade);
  }

  vtkSmartPointer<Mapper> Of;
  std::array<unsigned long, 2> Tags;
};

/// What messages that differ in names and numbers have in common: how they begin.
std::string KindOf(const std::string& message)
{
  constexpr std::size_t longest = 48;
  return message.substr(0, std::min(message.find_first_of("0123456789(:;,"), longest));
}

}

void Require(bool isHeld, const std::string& what)
{
  if (!isHeld)
  {
    throw Failure(what);
  }
}

Oracle::Oracle(World& world, Tally& tally)
  : Of(world)
  , Sum(tally)
{
  this->BeginAnew();
}

void Oracle::BeginAnew()
{
  this->Subject = std::make_unique<Ear>(this->Of.Subject);
  this->Heard = 0;
  this->LastError.clear();
  this->HasFrame = false;
  this->AreExact = {};
}

vtkSmartPointer<Mapper> Oracle::MakeFresh() const
{
  Mapper* subject = this->Of.Subject;
  auto fresh = vtkSmartPointer<Mapper>::New();
  fresh->SetInputDataObject(subject->GetInputDataObject(0, 0));
  fresh->SetBlendMode(subject->GetBlendMode());
  fresh->SetAverageIPScalarRange(subject->GetAverageIPScalarRange());
  fresh->SetSurfaceMode(subject->GetSurfaceMode());
  fresh->SetLabelTable(subject->GetLabelTable());
  fresh->SetLabelRadius(subject->GetLabelRadius());
  fresh->SetOutsideLabel(subject->GetOutsideLabel());
  fresh->SetColorArrayName(subject->GetColorArrayName());
  fresh->SetColorArrayOnCells(subject->GetColorArrayOnCells());
  fresh->SetColorArrayComponent(subject->GetColorArrayComponent());
  fresh->SetColorArrayOpacity(subject->GetColorArrayOpacity());
  fresh->SetColorTable(subject->GetColorTable());
  fresh->SetShadows(subject->GetShadows());
  fresh->SetVectorMode(subject->GetVectorMode());
  fresh->SetVectorComponent(subject->GetVectorComponent());
  fresh->SetSmoothMeshNormals(subject->GetSmoothMeshNormals());
  fresh->SetMeshMemoryLimit(subject->GetMeshMemoryLimit());
  fresh->SetCropping(subject->GetCropping());
  fresh->SetCroppingRegionPlanes(subject->GetCroppingRegionPlanes());
  fresh->SetCroppingRegionFlags(subject->GetCroppingRegionFlags());
  fresh->SetClippingPlanes(subject->GetClippingPlanes());
  fresh->SetMaskInput(subject->GetMaskInput());
  fresh->SetMaskType(subject->GetMaskType());
  fresh->SetMaskBlendFactor(subject->GetMaskBlendFactor());
  fresh->SetScalarMode(subject->GetScalarMode());
  fresh->SelectScalarArray(subject->GetArrayId());
  fresh->SelectScalarArray(subject->GetArrayName());
  fresh->SetArrayAccessMode(subject->GetArrayAccessMode());
  fresh->SetFinalColorWindow(subject->GetFinalColorWindow());
  fresh->SetFinalColorLevel(subject->GetFinalColorLevel());
  fresh->SetColorByAnswer(subject->GetColorByAnswer());
  fresh->SetAntialiasing(subject->GetAntialiasing());
  fresh->ReuseFramesOff();
  fresh->IsomapOff();
  // The picture is the same with leaping and without.
  fresh->SetSpaceLeaping(1 - subject->GetSpaceLeaping());
  return fresh;
}

void Oracle::ForgetFrames()
{
  // The last picture is forgotten with the others.
  Picture now;
  this->HasFrame = now.Fetch(this->Of.Subject);
  this->AreExact = {};
}

void Oracle::TakeFrame(const Picture& made)
{
  this->Shown.Copy(made);
  this->HasFrame = true;
  this->LastError.clear();
  this->AreExact = {};
}

void Oracle::ExpectErrorsAtMost(int most, const std::string& call)
{
  const int errors = this->Subject->Errors - this->Heard;
  Require(errors <= most,
    call + ": " + std::to_string(errors) + " errors, the last: " + this->Subject->Text);
  if (errors > 0)
  {
    Require(this->Subject->Text != this->LastError, call + " says again: " + this->LastError);
    this->LastError = this->Subject->Text;
  }
  this->Heard = this->Subject->Errors;
}

void Oracle::ExpectNoError(const std::string& call)
{
  Require(this->Subject->Errors == this->Heard, call + ": an error: " + this->Subject->Text);
}

void Oracle::ExpectLastPicture(const std::string& after)
{
  Picture now;
  const bool isThere = now.Fetch(this->Of.Subject);
  Require(
    isThere == this->HasFrame, after + ": the last picture is " + (isThere ? "there" : "gone"));
  if (isThere)
  {
    const std::string difference = now.Difference(this->Shown, true, true);
    Require(difference.empty(), after + ": another last picture: " + difference);
  }
}

void Oracle::CheckFrame()
{
  World& world = this->Of;
  Mapper* subject = world.Subject;
  Picture next, cold;
  next.Frame->SetDimensions(1, 1, 1);
  bool isMade = false;
  const int foreign = Silence::Fall().Errors;
  {
    Events events(subject);
    isMade = next.Render(world, subject);
    const bool isTold = world.Width > 0 && world.Height > 0;
    Require(events.Starts == (isTold ? 1 : 0) && events.Ends == events.Starts &&
        (!isTold || events.IsMade == isMade),
      "events: " + std::to_string(events.Starts) + " starts, " + std::to_string(events.Ends) +
        " ends, the last " + (events.IsMade ? "made" : "not made"));
  }
  Require(Silence::Fall().Errors == foreign, "an error of another object: " + Silence::Fall().Text);

  const auto fresh = this->MakeFresh();
  const Ear witness(fresh);
  const bool isColdMade = cold.Render(world, fresh);
  Require(isMade == isColdMade,
    std::string("a frame is ") + (isMade ? "made" : "refused") +
      ", but not by a mapper without a past, which says: " + witness.Text +
      "; the mapper with one says: " + this->Subject->Text);
  this->IsRefused = !isMade;
  const int errors = this->Subject->Errors - this->Heard;
  this->Heard = this->Subject->Errors;
  if (!isMade)
  {
    ++this->Sum.Refused;
    ++this->Sum.Errors[KindOf(witness.Text)];
    Require(witness.Errors == 1, "a refusal with " + std::to_string(witness.Errors) + " errors");
    const bool isSaid = errors == 1 && this->Subject->Text == witness.Text;
    const bool isSaidBefore = errors == 0 && this->LastError == witness.Text;
    Require((isSaid && this->LastError != witness.Text) || isSaidBefore,
      std::to_string(errors) + " errors: " + this->Subject->Text +
        "; without a past: " + witness.Text + "; before: " + this->LastError);
    this->LastError = witness.Text;
    Require(
      next.Frame->GetPointData()->GetNumberOfArrays() == 0, "a refused frame writes an image");
    this->ExpectLastPicture("after a refusal");
    return;
  }
  Require(errors == 0, "a frame with an error: " + this->Subject->Text);
  this->LastError.clear();
  this->Shown.Copy(next);
  this->HasFrame = true;
  this->CompareCounters();
  this->Compare(cold, fresh);
}

void Oracle::CompareCounters()
{
  Mapper* subject = this->Of.Subject;
  const vtkIdType rays = subject->GetStatistics()->GetNumberOfRays();
  const vtkIdType sum = subject->GetStatistics()->GetNumberOfDefiniteHits() +
    subject->GetStatistics()->GetNumberOfDefiniteMisses() +
    subject->GetStatistics()->GetNumberOfPossibleHits();
  Require(rays == this->Shown.CountPixels(), "the number of rays is " + std::to_string(rays));
  Require(
    rays == sum, "of " + std::to_string(rays) + " rays " + std::to_string(sum) + " are counted");
}

/// Positions and cells of hits, of which pictures tell nothing.
/// \return the first that differs, in words; empty if none does
std::string Oracle::DifferenceOfPicks(Mapper* fresh) const
{
  struct Pick
  {
    double Position[3]{}, Normal[3]{};
    int Isovalue = -1;
    unsigned Block = 0;
    vtkIdType Cell = -1;
  };
  const bool hasCells = this->Of.IsMesh() && !this->Shown.IsBlended;
  int size[3];
  this->Shown.Frame->GetDimensions(size);
  for (int pixel = 0; pixel < size[0] * size[1]; ++pixel)
  {
    const int x = pixel % size[0], y = pixel / size[0];
    Pick picks[2];
    for (Pick& pick : picks)
    {
      Mapper* mapper = &pick == picks ? this->Of.Subject.Get() : fresh;
      mapper->PickPixel(x, y, pick.Position, pick.Normal, &pick.Isovalue);
      pick.Cell = mapper->PickCell(x, y, &pick.Block);
    }
    const auto& [here, there] = picks;
    const char* what = std::memcmp(here.Position, there.Position, sizeof(here.Position)) != 0
      ? "position"
      : here.Isovalue != there.Isovalue                                  ? "isovalue"
      : std::memcmp(here.Normal, there.Normal, sizeof(here.Normal)) != 0 ? "normal"
      : here.Cell != there.Cell || here.Block != there.Block             ? "cell"
      : hasCells && here.Isovalue >= 0 && here.Cell < 0                  ? "hit without a cell"
                                                                         : nullptr;
    if (what)
    {
      std::ostringstream text;
      text.precision(17);
      text << what << " at (" << x << ", " << y << "): isovalue " << here.Isovalue << " for "
           << there.Isovalue << ", cell " << here.Cell << " for " << there.Cell << ", x "
           << here.Position[0] << " for " << there.Position[0] << ", normal " << here.Normal[0]
           << " for " << there.Normal[0];
      return text.str();
    }
  }
  return {};
}

/// By the route, and what settings promise of it.
bool Oracle::IsPromisedExact() const
{
  Mapper* subject = this->Of.Subject;
  const std::string route = subject->GetStatistics()->GetRouteAsString();
  const bool isLookedUp = route == "IsomapLookup" || route == "IsomapBuild";
  if (isLookedUp)
  {
    return subject->GetIsomapTolerance() == 0.0 && subject->GetIsomapShading() == Mapper::RESHADE;
  }
  if (route == "ImageCache")
  {
    return false;
  }
  const bool isAgain = route == "Redisplay" || route == "Reshade";
  return !isAgain || subject->GetRefineWhenStill() ||
    this->AreExact[this->Of.AtVolume][this->Of.AtRenderer];
}

void Oracle::Compare(const Picture& cold, Mapper* fresh)
{
  World& world = this->Of;
  Mapper* subject = world.Subject;
  const std::string route = subject->GetStatistics()->GetRouteAsString();
  std::optional<int> isovalues;
  if (subject->GetSurfaceMode() != Mapper::LABELS || this->Shown.IsBlended)
  {
    isovalues = world.Property()->GetIsoSurfaceValues()->GetNumberOfContours();
  }
  for (const Picture* picture : { &cold, static_cast<const Picture*>(&this->Shown) })
  {
    const std::string nonsense =
      picture->Nonsense(isovalues, world.From.Wildness == 0 && world.IsTame);
    Require(nonsense.empty(), (picture == &cold ? "cold" : route) + ": " + nonsense);
  }
  if (cold.CountHits() > 0)
  {
    ++this->Sum.WithSurface;
    ++this->Sum.Routes[route];
    this->Sum.Merged[route] += subject->GetStatistics()->GetNumberOfMergedLayers() > 0;
  }
  if (world.HasSilentChange)
  {
    return;
  }
  this->IsExact = this->IsPromisedExact();
  this->AreExact[world.AtVolume][world.AtRenderer] = this->IsExact;
  if (!this->IsExact)
  {
    this->ComparePromise(cold);
    return;
  }
  const bool isPainted = subject->GetColorByAnswer() &&
    (route == "ImageCache" || route == "Redisplay" || route == "Reshade");
  const std::string difference = this->Shown.Difference(cold, !isPainted, true);
  const std::string ofPicks = this->DifferenceOfPicks(fresh);
  if (!difference.empty())
  {
    throw Failure(
      "not the cold picture by " + route + this->CauseOf(difference, !isPainted) + ofPicks);
  }
  Require(ofPicks.empty(), "not the cold picks by " + route + ": " + ofPicks);
}

/// Tells whether a picture differs by its past, or by leaping through space.
std::string Oracle::CauseOf(const std::string& difference, bool inColors) const
{
  Picture alike;
  const auto fresh = this->MakeFresh();
  fresh->SetSpaceLeaping(this->Of.Subject->GetSpaceLeaping());
  const bool isByLeaping =
    alike.Render(this->Of, fresh) && this->Shown.Difference(alike, inColors, true).empty();
  return (isByLeaping ? ", as space is leaped: " : ": ") + difference;
}

/// What frames promise that need not be exact; shares are judged for all runs together.
void Oracle::ComparePromise(const Picture& cold)
{
  World& world = this->Of;
  Mapper* subject = world.Subject;
  const std::string route = subject->GetStatistics()->GetRouteAsString();
  const double edge = this->ShortestEdge();
  const auto pixels = static_cast<double>(this->Shown.CountPixels());
  if (route == "IsomapLookup" || route == "IsomapBuild")
  {
    const double tolerance = subject->GetIsomapTolerance();
    if (tolerance == 0.0)
    {
      const std::string difference = this->Shown.Difference(cold, false, false);
      Require(difference.empty(), "other depths of interpolated normals: " + difference);
    }
    else if (world.IsTame && world.From.Wildness == 0 && edge > 0.0)
    {
      this->Sum.TolerantPixels += pixels;
      this->Sum.TolerantOthers +=
        static_cast<double>(this->Shown.CountDifferent(cold, 1.001 * tolerance * edge));
    }
  }
}

/// Shortest distance of two samples in the world; 0 where it is not asked for.
double Oracle::ShortestEdge() const
{
  vtkImageData* image = this->Of.Image();
  if (!image)
  {
    return 0.0;
  }
  vtkMatrix4x4* matrix = this->Of.Volume()->GetMatrix();
  double shortest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    double edge = 0.0;
    for (int row = 0; row < 3; ++row)
    {
      double along = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        along += matrix->GetElement(row, i) * image->GetDirectionMatrix()->GetElement(i, axis);
      }
      edge += along * along;
    }
    shortest = std::min(shortest, std::sqrt(edge) * std::abs(image->GetSpacing()[axis]));
  }
  return shortest;
}

void Oracle::CheckRefined()
{
  if (this->IsRefused || this->IsExact || this->Of.HasSilentChange ||
    !this->Of.Subject->GetRefineWhenStill())
  {
    return;
  }
  Story::Tell("the same view again");
  ++this->Sum.Acts["refined"];
  this->CheckFrame();
  Require(!this->IsRefused && this->IsExact,
    std::string("a repeated view ends in a frame that need not be exact, by ") +
      this->Of.Subject->GetStatistics()->GetRouteAsString());
}

}
