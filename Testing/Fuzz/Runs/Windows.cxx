// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Runs/Windows.h"

#include "Changes/Changes.h"
#include "Oracle/Ear.h"
#include "Oracle/Oracle.h"
#include "Runs/Watchdog.h"

#include <vtkHardwareSelector.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPropPicker.h>
#include <vtkRenderWindow.h>
#include <vtkSelection.h>
#include <vtkVolumeCollection.h>

#include <algorithm>
#include <cstdlib>

namespace Fuzz
{
namespace Windows
{
namespace
{

/// Windows that show the renderers of a world.
class Desk
{
public:
  explicit Desk(World& world)
    : Of(world)
  {
    this->Open();
  }

  void Open()
  {
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(this->Of.From.OneIn(6) ? 4 : 0);
    // Images may have any size; an X server ends a program that asks for a window of none.
    constexpr int largest = 200;
    this->Window->SetSize(
      std::clamp(this->Of.Width, 1, largest), std::clamp(this->Of.Height, 1, largest));
    this->Window->AddRenderer(this->Of.Renderer());
  }

  /// Something that happens to windows.
  void Change()
  {
    Bytes& from = this->Of.From;
    const int kind = from.Pick(15);
    Story::Tell("  in way ", kind);
    switch (kind)
    {
      case 13:
        this->Window->SetTileScale(1 + from.Pick(3), 1 + from.Pick(2));
        this->Window->SetTileViewport(0.0, 0.0, from.Between(0.3, 1.0), 1.0);
        break;
      case 0:
        this->Window->SetSize(1 + from.Pick(60), 1 + from.Pick(60));
        break;
      case 1:
        this->Of.Renderer()->SetViewport(0.0, 0.0, from.Between(0.2, 1.0), from.Between(0.2, 1.0));
        break;
      case 2:
        this->Window->RemoveRenderer(this->Of.Renderer());
        this->Open();
        break;
      case 3:
        this->Of.Subject->ReleaseGraphicsResources(from.OneIn(2) ? this->Window.Get() : nullptr);
        break;
      case 4:
        this->Window->Finalize();
        break;
      case 5:
        this->Of.Renderer()->RemoveVolume(this->Of.Volume());
        break;
      case 6:
        this->Of.Renderer()->AddVolume(this->Of.Volume());
        break;
      case 7:
        this->Select();
        break;
      case 8:
        this->Pick();
        break;
      case 9:
        this->Window->SetStereoRender(from.Pick(2));
        this->Window->SetStereoType(from.OneIn(2) ? VTK_STEREO_ANAGLYPH : VTK_STEREO_LEFT);
        break;
      case 10:
        this->Window->SetDesiredUpdateRate(from.Number(0.001, 1e4));
        break;
      case 11:
        this->Of.Renderer()->SetUseDepthPeeling(from.Pick(2));
        break;
      case 12:
        this->Of.Subject->BuildIsomap(this->Of.Renderer(), this->Of.Volume());
        break;
      default:
        this->Of.Renderer()->SetLayer(0);
        this->Of.Renderer()->SetBackground(from.Between(0.0, 1.0), 0.2, 0.3);
        break;
    }
  }

  vtkSmartPointer<vtkRenderWindow> Window;

private:
  void Select()
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Of.Renderer());
    const int* size = this->Window->GetSize();
    selector->SetArea(0, 0, static_cast<unsigned>(size[0] - 1), static_cast<unsigned>(size[1] - 1));
    selector->SetFieldAssociation(this->Of.From.OneIn(2) ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                                                         : vtkDataObject::FIELD_ASSOCIATION_POINTS);
    vtkSmartPointer<vtkSelection>::Take(selector->Select());
  }

  void Pick()
  {
    vtkNew<vtkPropPicker> picker;
    picker->PickProp(this->Of.From.Pick(40), this->Of.From.Pick(40), this->Of.Renderer());
  }

  World& Of;
};

/// True if a window shows one picture, and all of it: what an eye or a tile sees is known only
/// while it is drawn.
bool IsWhole(vtkRenderWindow* window)
{
  const int* tiles = window ? window->GetTileScale() : nullptr;
  return window && !window->GetStereoRender() && tiles[0] == 1 && tiles[1] == 1;
}

/// True if a renderer shows a volume and no other.
bool IsAlone(vtkRenderer* renderer, vtkVolume* volume)
{
  return renderer->HasViewProp(volume) && renderer->GetVolumes()->GetNumberOfItems() == 1;
}

/// True if every pixel of the last frame has a ray that was traced for it, now or just before.
bool IsTracedWhole(vtkTemporalCoherenceVolumeMapper* mapper)
{
  const std::string route = mapper->GetStatistics()->GetRouteAsString();
  const bool hadFewer = route == "FewerRays" || route == "Refine";
  return route == "Cold" || (hadFewer && mapper->GetFrameIsFinal());
}

/// What the mapper shows in a window is what it draws into an image.
void CompareWithImage(World& world, const Oracle& oracle, Tally& tally)
{
  Picture shown, cold;
  if (world.HasSilentChange || !shown.Fetch(world.Subject) || !IsTracedWhole(world.Subject) ||
    world.Subject->GetImageSampleDistance() != 1.0f ||
    !IsWhole(world.Renderer()->GetRenderWindow()) || !IsAlone(world.Renderer(), world.Volume()))
  {
    return;
  }
  int size[3];
  shown.Frame->GetDimensions(size);
  world.Width = size[0];
  world.Height = size[1];
  const auto fresh = oracle.MakeFresh();
  const Ear ear(fresh);
  // The aspect of a viewport may be rounded otherwise than that of an image.
  if (!cold.Render(world, fresh) ||
    world.Renderer()->GetTiledAspectRatio() !=
      static_cast<double>(size[0]) / static_cast<double>(size[1]))
  {
    return;
  }
  ++tally.Acts["compared in a window"];
  const std::string difference = shown.Difference(cold, true, true);
  Require(difference.empty(), "not the cold picture in a window: " + difference);
}

/// Counts the frames that are made.
struct Made
{
  void Hear(vtkObject*, unsigned long, void* isMade)
  {
    ++this->Ends;
    this->IsMade = *static_cast<bool*>(isMade);
  }
  int Ends = 0;
  bool IsMade = false;
};

}

bool AreThere()
{
  return std::getenv("DISPLAY") != nullptr;
}

void Run(const std::vector<std::uint8_t>& bytes, Tally& tally)
{
  constexpr int MostSteps = 60;
  Silence::Fall();
  Story::Begin();
  ++tally.Runs;
  Watchdog::Feed();
  World world(bytes);
  const Oracle oracle(world, tally);
  Desk desk(world);
  for (int step = 0; step < MostSteps && !world.From.IsUsedUp(); ++step)
  {
    ++tally.Steps;
    Watchdog::Feed();
    Story::Tell("step ", step, ":");
    if (world.From.OneIn(2))
    {
      Story::Tell("the window changes");
      desk.Change();
    }
    else
    {
      const std::size_t renderer = world.AtRenderer;
      Changes::MakeOne(world);
      if (world.AtRenderer != renderer)
      {
        desk.Window->AddRenderer(world.Renderer());
      }
    }
    const Ear ear(world.Subject);
    Made made;
    const unsigned long tag =
      world.Subject->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, &made, &Made::Hear);
    desk.Window->Render();
    world.Subject->RemoveObserver(tag);
    // One for each volume and eye at most.
    Require(ear.Errors <= 4,
      "a window: " + std::to_string(ear.Errors) + " errors, the last: " + ear.Text);
    if (made.Ends == 1 && made.IsMade && ear.Errors == 0)
    {
      ++tally
          .Routes[std::string("in a window ") + world.Subject->GetStatistics()->GetRouteAsString()];
      CompareWithImage(world, oracle, tally);
    }
  }
}

}
}
