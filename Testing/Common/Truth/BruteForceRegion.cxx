// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Truth/BruteForceRegion.h"

#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>

#include <algorithm>
#include <limits>

BruteForceRegion::BruteForceRegion(vtkVolumeMapper* mapper, vtkVolume* volume)
  : Mapper(mapper)
{
  volume->ComputeMatrix();
  vtkMatrix4x4::Invert(volume->GetMatrix()->GetData(), this->Back.data());
}

BruteForceRegion::Point BruteForceRegion::DataFromWorld(const Point& world) const
{
  const double point[4] = { world[0], world[1], world[2], 1.0 };
  double data[4];
  vtkMatrix4x4::MultiplyPoint(this->Back.data(), point, data);
  return { data[0], data[1], data[2] };
}

bool BruteForceRegion::Keeps(const Point& world) const
{
  vtkPlaneCollection* planes = this->Mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    double point[3] = { world[0], world[1], world[2] };
    if (planes->GetItem(i)->EvaluateFunction(point) < 0.0)
    {
      return false;
    }
  }
  if (!this->Mapper->GetCropping())
  {
    return true;
  }
  const Point data = this->DataFromWorld(world);
  int region = 0, step = 1;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double* crops = this->Mapper->GetCroppingRegionPlanes() + 2 * a;
    region += step * (data[a] < crops[0] ? 0 : data[a] < crops[1] ? 1 : 2);
    step *= 3;
  }
  return this->Mapper->GetCroppingRegionFlags() >> region & 1;
}

/// How far a point is from each plane, with a sign.
std::vector<double> BruteForceRegion::PlanesAt(const Point& world) const
{
  std::vector<double> distances;
  vtkPlaneCollection* planes = this->Mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    double point[3] = { world[0], world[1], world[2] };
    distances.push_back(planes->GetItem(i)->EvaluateFunction(point));
  }
  const Point data = this->DataFromWorld(world);
  for (std::size_t i = 0; i < 6 && this->Mapper->GetCropping(); ++i)
  {
    distances.push_back(data[i / 2] - this->Mapper->GetCroppingRegionPlanes()[i]);
  }
  return distances;
}

std::vector<BruteForceTracer::Line> BruteForceRegion::Of(const BruteForceTracer::Line& line) const
{
  std::vector<double> stops = { line.Begin, line.End };
  const std::vector<double> atBegin = this->PlanesAt(line.PointAt(line.Begin));
  const std::vector<double> atEnd = this->PlanesAt(line.PointAt(line.End));
  for (std::size_t i = 0; i < atBegin.size(); ++i)
  {
    if ((atBegin[i] < 0.0) != (atEnd[i] < 0.0))
    {
      const double share = atBegin[i] / (atBegin[i] - atEnd[i]);
      stops.push_back(line.Begin + share * (line.End - line.Begin));
    }
  }
  std::sort(stops.begin(), stops.end());
  std::vector<BruteForceTracer::Line> parts;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
  {
    if (!this->Keeps(line.PointAt(0.5 * (stops[i] + stops[i + 1]))))
    {
      continue;
    }
    if (!parts.empty() && parts.back().End == stops[i])
    {
      parts.back().End = stops[i + 1];
    }
    else
    {
      parts.push_back({ line.Origin, line.Direction, stops[i], stops[i + 1] });
    }
  }
  return parts;
}

BruteForceTracer::Hit BruteForceRegion::Trace(
  const BruteForceTracer& truth, const BruteForceTracer::Line& line) const
{
  for (const BruteForceTracer::Line& part : this->Of(line))
  {
    const BruteForceTracer::Hit hit = truth.Trace(part);
    if (hit.Isovalue >= 0)
    {
      return hit;
    }
  }
  return { std::numeric_limits<double>::infinity(), -1, {} };
}
