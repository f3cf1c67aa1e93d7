// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/ViewHeaderParts.h"

#include <cmath>

namespace TemporalCoherence
{
namespace
{

constexpr std::size_t MostSurfaces = 8, MostLights = 64, MostColors = 4096, MostBins = 256,
                      MostPlanes = 64;
constexpr double LargestCorner = 1e9; // fits into an int

template <typename Vector>
Json AsJson(const Vector& vector)
{
  Json json = Json::array();
  for (glm::length_t i = 0; i < Vector::length(); ++i)
  {
    json.push_back(vector[i]);
  }
  return json;
}

template <typename Vector>
Vector VectorOf(const Json& json)
{
  Require(json.is_array() && json.size() == static_cast<std::size_t>(Vector::length()),
    "a vector has another number of components");
  Vector vector;
  for (glm::length_t i = 0; i < Vector::length(); ++i)
  {
    vector[i] = Finite(json.at(static_cast<std::size_t>(i)));
  }
  return vector;
}

const Json& ListOf(const Json& json, const char* name, std::size_t most)
{
  const Json& list = json.at(name);
  Require(list.is_array() && list.size() <= most, "a list is too long");
  return list;
}

Json MatrixAsJson(const glm::dmat4& matrix)
{
  Json json = Json::array();
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      json.push_back(matrix[column][row]);
    }
  }
  return json;
}

glm::dmat4 MatrixOf(const Json& json)
{
  Require(json.is_array() && json.size() == 16, "a matrix has not 16 numbers");
  glm::dmat4 matrix;
  for (int i = 0; i < 16; ++i)
  {
    matrix[i % 4][i / 4] = Finite(json.at(static_cast<std::size_t>(i)));
  }
  Require(std::abs(glm::determinant(matrix)) > 0.0, "a matrix has no inverse");
  return matrix;
}

Json LightAsJson(const Light& light)
{
  return { { "positional", light.Positional }, { "position", AsJson(light.Position) },
    { "direction", AsJson(light.Direction) }, { "diffuse", AsJson(light.Diffuse) },
    { "specular", AsJson(light.Specular) } };
}

Json LightsAsJson(const std::vector<Light>& lights)
{
  Json json = Json::array();
  for (const Light& light : lights)
  {
    json.push_back(LightAsJson(light));
  }
  return json;
}

Light LightOf(const Json& json)
{
  Light light;
  light.Positional = json.at("positional").get<bool>();
  light.Position = VectorOf<glm::dvec3>(json.at("position"));
  light.Direction = VectorOf<glm::dvec3>(json.at("direction"));
  light.Diffuse = VectorOf<glm::dvec3>(json.at("diffuse"));
  light.Specular = VectorOf<glm::dvec3>(json.at("specular"));
  return light;
}

void ReadLights(const Json& json, std::vector<Light>& lights)
{
  for (const Json& light : ListOf(json, "lights", MostLights))
  {
    lights.push_back(LightOf(light));
  }
}

Json LookAsJson(const ViewLook& look)
{
  Json json;
  json["surfaces"] = Json::array();
  for (const ViewSurface& surface : look.Surfaces)
  {
    json["surfaces"].push_back({ { "isovalue", surface.Isovalue },
      { "color", AsJson(surface.Color) }, { "opacity", surface.Opacity } });
  }
  for (const glm::dvec4& color : look.Colors)
  {
    json["colors"].push_back(AsJson(color));
  }
  const Appearance& light = look.Light;
  json["material"] = { { "shade", light.Shade }, { "ambient", light.Ambient },
    { "diffuse", light.Diffuse }, { "specular", light.Specular },
    { "specularPower", light.SpecularPower }, { "twoSided", light.TwoSided } };
  json["lights"] = LightsAsJson(light.Lights);
  json["background"] = AsJson(look.Background);
  if (look.Background2)
  {
    json["background2"] = AsJson(*look.Background2);
  }
  return json;
}

void ReadLook(const Json& json, ViewLook& look)
{
  for (const Json& surface : ListOf(json, "surfaces", MostSurfaces))
  {
    look.Surfaces.push_back({ Finite(surface.at("isovalue")),
      VectorOf<glm::dvec3>(surface.at("color")), Finite(surface.at("opacity")) });
  }
  Require(!look.Surfaces.empty(), "it shows no surface");
  if (json.contains("colors"))
  {
    for (const Json& color : ListOf(json, "colors", MostColors))
    {
      look.Colors.push_back(VectorOf<glm::dvec4>(color));
    }
  }
  const Json& material = json.at("material");
  Appearance& light = look.Light;
  light.Shade = material.at("shade").get<bool>();
  light.Ambient = Finite(material.at("ambient"));
  light.Diffuse = Finite(material.at("diffuse"));
  light.Specular = Finite(material.at("specular"));
  light.SpecularPower = Finite(material.at("specularPower"));
  light.TwoSided = material.at("twoSided").get<bool>();
  ReadLights(json, light.Lights);
  look.Background = VectorOf<glm::dvec3>(json.at("background"));
  if (json.contains("background2"))
  {
    look.Background2 = VectorOf<glm::dvec3>(json.at("background2"));
  }
}

Json RaysAsJson(const View& rays)
{
  return { { "origin", AsJson(rays.Origin) }, { "originX", AsJson(rays.OriginX) },
    { "originY", AsJson(rays.OriginY) }, { "direction", AsJson(rays.Direction) },
    { "directionX", AsJson(rays.DirectionX) }, { "directionY", AsJson(rays.DirectionY) },
    { "forward", AsJson(rays.Forward) }, { "near", rays.Near }, { "far", rays.Far } };
}

void ReadRays(const Json& json, View& rays)
{
  rays.Origin = VectorOf<glm::dvec3>(json.at("origin"));
  rays.OriginX = VectorOf<glm::dvec3>(json.at("originX"));
  rays.OriginY = VectorOf<glm::dvec3>(json.at("originY"));
  rays.Direction = VectorOf<glm::dvec3>(json.at("direction"));
  rays.DirectionX = VectorOf<glm::dvec3>(json.at("directionX"));
  rays.DirectionY = VectorOf<glm::dvec3>(json.at("directionY"));
  rays.Forward = VectorOf<glm::dvec3>(json.at("forward"));
  rays.Near = Finite(json.at("near"));
  rays.Far = Finite(json.at("far"));
}

Json CameraAsJson(const ViewCamera& camera)
{
  return { { "parallel", camera.Parallel }, { "position", AsJson(camera.Position) },
    { "focalPoint", AsJson(camera.FocalPoint) }, { "viewUp", AsJson(camera.ViewUp) },
    { "viewAngle", camera.ViewAngle }, { "parallelScale", camera.ParallelScale },
    { "clippingRange", AsJson(camera.ClippingRange) } };
}

void ReadCamera(const Json& json, ViewCamera& camera)
{
  camera.Parallel = json.at("parallel").get<bool>();
  camera.Position = VectorOf<glm::dvec3>(json.at("position"));
  camera.FocalPoint = VectorOf<glm::dvec3>(json.at("focalPoint"));
  camera.ViewUp = VectorOf<glm::dvec3>(json.at("viewUp"));
  camera.ViewAngle = Finite(json.at("viewAngle"));
  camera.ParallelScale = Finite(json.at("parallelScale"));
  camera.ClippingRange = VectorOf<glm::dvec2>(json.at("clippingRange"));
}

}

void Require(bool isTrue, const char* wrong)
{
  if (!isTrue)
  {
    throw WrongHeader(wrong);
  }
}

double Finite(const Json& json)
{
  const double number = json.get<double>();
  Require(json.is_number() && std::isfinite(number), "a number is not finite");
  return number;
}

int WholeNumber(const Json& json, int low, int high)
{
  const double number = Finite(json);
  Require(number >= low && number <= high && number == std::floor(number),
    "a whole number is out of range");
  return static_cast<int>(number);
}

std::uint64_t LargeNumber(const Json& json)
{
  constexpr double most = 9007199254740992.0; // 2^53: up to it doubles hold all whole numbers
  const double number = Finite(json);
  Require(number >= 0.0 && number <= most && number == std::floor(number),
    "a whole number is out of range");
  return static_cast<std::uint64_t>(number);
}

Json DescriptionAsJson(const ViewDescription& description)
{
  Json json = LookAsJson(description.Look);
  const ViewTexts& texts = description.Texts;
  json["title"] = texts.Title;
  json["caption"] = texts.Caption;
  json["citation"] = texts.Citation;
  json["array"] = texts.Array;
  json["units"] = texts.Units;
  if (!description.Histogram.Counts.empty())
  {
    json["histogram"] = { { "range", AsJson(description.Histogram.Range) },
      { "counts", description.Histogram.Counts } };
  }
  return json;
}

void ReadDescription(const Json& json, ViewDescription& description)
{
  description = ViewDescription();
  ReadLook(json, description.Look);
  ViewTexts& texts = description.Texts;
  texts.Title = json.at("title").get<std::string>();
  texts.Caption = json.at("caption").get<std::string>();
  texts.Citation = json.at("citation").get<std::string>();
  texts.Array = json.at("array").get<std::string>();
  texts.Units = json.at("units").get<std::string>();
  if (json.contains("histogram"))
  {
    const Json& histogram = json.at("histogram");
    description.Histogram.Range = VectorOf<glm::dvec2>(histogram.at("range"));
    for (const Json& count : ListOf(histogram, "counts", MostBins))
    {
      description.Histogram.Counts.push_back(static_cast<std::int64_t>(LargeNumber(count)));
    }
  }
}

Json GeometryAsJson(const ViewGeometry& geometry)
{
  Json json;
  json["name"] = geometry.Name;
  json["size"] = { geometry.Rays.Size.x, geometry.Rays.Size.y };
  json["tolerance"] = geometry.Tolerance;
  json["voxel"] = geometry.Voxel;
  json["camera"] = CameraAsJson(geometry.Camera);
  json["rays"] = RaysAsJson(geometry.Rays);
  json["rays"]["parallel"] = geometry.Rays.Parallel;
  json["box"] = { { "matrix", MatrixAsJson(geometry.WorldFromIndex) },
    { "low", AsJson(geometry.Box.Low) }, { "high", AsJson(geometry.Box.High) } };
  for (const glm::dvec4& plane : geometry.Planes)
  {
    json["planes"].push_back(AsJson(plane));
  }
  if (!geometry.Lights.empty())
  {
    json["lights"] = LightsAsJson(geometry.Lights);
  }
  return json;
}

void ReadGeometry(const Json& json, int largest, ViewGeometry& geometry)
{
  geometry.Name = json.at("name").get<std::string>();
  ReadRays(json.at("rays"), geometry.Rays);
  geometry.Rays.Parallel = json.at("rays").at("parallel").get<bool>();
  geometry.Rays.Size = { WholeNumber(json.at("size").at(0), 1, largest),
    WholeNumber(json.at("size").at(1), 1, largest) };
  geometry.Tolerance = Finite(json.at("tolerance"));
  geometry.Voxel = Finite(json.at("voxel"));
  ReadCamera(json.at("camera"), geometry.Camera);
  const Json& box = json.at("box");
  geometry.WorldFromIndex = MatrixOf(box.at("matrix"));
  geometry.Box = { VectorOf<glm::dvec3>(box.at("low")), VectorOf<glm::dvec3>(box.at("high")) };
  const glm::dvec3& high = geometry.Box.High;
  Require(geometry.Box.Low == glm::dvec3(0.0) && high == glm::floor(high) &&
      glm::all(glm::greaterThan(high, glm::dvec3(0.0))) &&
      glm::all(glm::lessThan(high, glm::dvec3(LargestCorner))),
    "a box does not hold cells from the first sample on");
  if (json.contains("planes"))
  {
    for (const Json& plane : ListOf(json, "planes", MostPlanes))
    {
      geometry.Planes.push_back(VectorOf<glm::dvec4>(plane));
    }
  }
  if (json.contains("lights"))
  {
    ReadLights(json, geometry.Lights);
  }
}

}
