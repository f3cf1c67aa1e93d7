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

bool MapperLoad::DoOnce()
{
  Scene scene(this->Image, { 200.0 });
  scene.LookFrom(0.7, -1.0, 0.5);
  bool isRendered = true;
  const auto render = [&]
  {
    isRendered = scene.Render(64, 48) && isRendered;
    ++this->Routes[scene.Mapper->GetRouteAsString()];
  };
  render();
  render();
  scene.Volume->GetProperty()->SetAmbient(0.3);
  render();
  scene.Renderer->GetActiveCamera()->Azimuth(1.0);
  render();
  scene.Mapper->SetIsomapRange(100.0, 600.0);
  isRendered = scene.Mapper->BuildIsomap(scene.Renderer, scene.Volume) && isRendered;
  for (const double isovalue : { 201.0, 500.0, 202.0 })
  {
    scene.SetIsovalues({ isovalue });
    render();
  }
  return isRendered;
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
