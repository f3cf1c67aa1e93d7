// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperLoad.h"

#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <sstream>

MapperLoad::MapperLoad()
  : Image(Volumes::Waves())
{
}

void MapperLoad::DoOnce()
{
  Scene scene(this->Image, { 200.0 });
  scene.LookFrom(0.7, -1.0, 0.5);
  scene.Mapper->SetReuseAccuracyToPaper();
  const auto render = [&]
  {
    Expect(scene.Render(64, 48), "rendered");
    ++this->Routes[scene.Mapper->GetStatistics()->GetRouteAsString()];
  };
  render();
  render();
  scene.Volume->GetProperty()->SetAmbient(0.3);
  render();
  scene.Renderer->GetActiveCamera()->Azimuth(1.0);
  render();
  scene.Mapper->SetIsomapRange(100.0, 600.0);
  Expect(scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume), "an isomap is built");
  for (const double isovalue : { 201.0, 500.0, 202.0 })
  {
    scene.SetIsovalues({ isovalue });
    render();
  }
}

std::string MapperLoad::Describe() const
{
  std::ostringstream text;
  for (const auto& [route, count] : this->Routes)
  {
    text << (text.tellp() > 0 ? " " : "") << route << ' ' << count;
  }
  return text.str();
}

bool MapperLoad::HasReachedAll() const
{
  for (const char* route : { "Cold", "Redisplay", "Reshade", "ImageCache", "IsomapLookup" })
  {
    if (this->Routes.count(route) == 0)
    {
      return false;
    }
  }
  return true;
}
