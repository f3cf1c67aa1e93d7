// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FeaturePictures.h"

#include "BlendedPictures.h"
#include "FeatureScene.h"
#include "LabelPictures.h"
#include "LayerPictures.h"
#include "MeshPictures.h"
#include "Volumes/Volumes.h"
#include "vtkTemporalCoherencePicker.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkDoubleArray.h>
#include <vtkExtractVOI.h>
#include <vtkGlyph3D.h>
#include <vtkLight.h>
#include <vtkMaskPoints.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRectilinearGrid.h>
#include <vtkRectilinearGridGeometryFilter.h>
#include <vtkThresholdPoints.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <iostream>

namespace FeaturePictures
{
namespace
{

Shot Capped(GallerySettings& settings)
{
  const Subject subject =
    FirstOf({ MrHead({ 45.0, 65.0, 85.0 }, { { -1.0, 0.5, 0.12 }, { 0.0, 0.0, 1.0 }, 1.4 }),
              SpheresInstead({ 100.0, 150.0, 200.0 }) },
      settings);
  FeatureScene scene(settings, subject);
  scene.Show({ { subject.Isovalues[0], Style::Skin }, { subject.Isovalues[1], Style::Coral },
    { subject.Isovalues[2], Style::Bone } });
  scene.Mapper->SetSurfaceModeToThreshold();
  scene.Clip({ 1.0, 0.0, 0.0 }, 0.5);
  return scene.Take("caps", "Solids with caps",
    "`SetSurfaceModeToThreshold()` and a clipping plane: the cut is closed, and coloured by the "
    "highest isovalue that is reached there");
}

Shot Cropped(GallerySettings& settings)
{
  const Subject subject = FirstOf({ { "engine.vti", "CT engine 256x256x110", { 70.0, 180.0 },
                                      { { 1.0, -1.4, 0.9 }, { 0.0, 0.0, 1.0 }, 1.55 } },
                                    MrHead({ 45.0, 105.0 }), SpheresInstead({ 100.0, 180.0 }) },
    settings);
  FeatureScene scene(settings, subject);
  scene.Show({ { subject.Isovalues[0], Style::Steel }, { subject.Isovalues[1], Style::Gold } });
  scene.Mapper->SetSurfaceModeToThreshold();
  scene.CropCorner();
  return scene.Take("cropping", "Cropping",
    "`CroppingOn()`, 26 of the 27 regions; the metal inside (isovalue " +
      Plain(subject.Isovalues[1]) + ") shows in the caps");
}

Shot Clipped(GallerySettings& settings)
{
  const Subject subject = FirstOf({ { "heptane.vti", "simulated fire 302^3", { 20.0, 60.0, 120.0 },
                                      { { 0.4, -1.6, 0.7 }, { -1.0, 0.0, 0.0 }, 1.7 } },
                                    SpheresInstead({ 60.0, 120.0, 180.0 }) },
    settings);
  FeatureScene scene(settings, subject);
  scene.Show({ { subject.Isovalues[0], Style::Steel, 0.25 },
    { subject.Isovalues[1], Style::Gold, 0.6 }, { subject.Isovalues[2], Style::Coral } });
  scene.Clip({ 0.2, 1.0, 0.0 }, 0.5);
  return scene.Take("clipping", "Clipping planes",
    "three isovalues, two of them translucent, cut open by `AddClippingPlane()`");
}

/// The folds of a brain, without and with ambient occlusion.
Shot Folds(GallerySettings& settings, bool areOccluded)
{
  const Subject subject = FirstOf({ { "ch2bet.nii.gz", "MR brain 181x217x181", { 80.0 },
                                      { { -1.0, 0.7, 0.7 }, { 0.0, 0.0, 1.0 }, 1.5 } },
                                    SpheresInstead({ 100.0 }) },
    settings);
  FeatureScene scene(settings, subject);
  scene.Show({ { subject.Isovalues[0], Style::Coral } });
  scene.Mapper->SetAmbientOcclusion(areOccluded);
  return areOccluded ? scene.Take("occlusion", "Ambient occlusion",
                         "`AmbientOcclusionOn()`: folds are dark, as rays through the data tell")
                     : scene.Take("no-occlusion", "Without ambient occlusion",
                         "the same picture without it, for comparison");
}

Shot PlainFolds(GallerySettings& settings)
{
  return Folds(settings, false);
}

Shot DarkFolds(GallerySettings& settings)
{
  return Folds(settings, true);
}

/// An engine under a lamp that casts soft shadows, with ambient occlusion where no lamp shines.
Shot Shadows(GallerySettings& settings)
{
  const Subject subject = FirstOf({ { "engine.vti", "CT engine 256x256x110", { 70.0 },
                                      { { 1.0, -1.4, 0.9 }, { 0.0, 0.0, 1.0 }, 1.5 } },
                                    SpheresInstead({ 100.0 }) },
    settings);
  FeatureScene scene(settings, subject);
  scene.Show({ { subject.Isovalues[0], Style::Steel } });
  scene.Room.Renderer->RemoveAllLights();
  const double size = scene.Volume->GetLength();
  const double* middle = scene.Volume->GetCenter();
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  lamp->SetFocalPoint(middle[0], middle[1], middle[2]);
  lamp->SetPosition(middle[0] + 1.6 * size, middle[1] - 1.0 * size, middle[2] + 1.1 * size);
  scene.Room.Renderer->AddLight(lamp);
  scene.Volume->GetProperty()->SetAmbient(0.3);
  scene.Mapper->ShadowsOn();
  scene.Mapper->SetLightRadius(0.03 * size);
  scene.Mapper->AmbientOcclusionOn();
  return scene.Take("shadows", "Shadows",
    "`ShadowsOn()` and `SetLightRadius()`: a lamp casts soft shadows; `AmbientOcclusionOn()` "
    "where it does not shine");
}

/// The samples of an image, the farther apart the farther they are from the middle.
vtkSmartPointer<vtkRectilinearGrid> Stretched(vtkImageData* image)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(image->GetDimensions());
  for (int axis = 0; axis < 3; ++axis)
  {
    const int size = image->GetDimensions()[axis];
    vtkNew<vtkDoubleArray> coordinates;
    for (int i = 0; i < size; ++i)
    {
      const double place = 2.0 * i / (size - 1) - 1.0;
      coordinates->InsertNextValue(size * (0.6 * place + 0.4 * place * place * place));
    }
    axis == 0     ? grid->SetXCoordinates(coordinates)
      : axis == 1 ? grid->SetYCoordinates(coordinates)
                  : grid->SetZCoordinates(coordinates);
  }
  grid->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  return grid;
}

/// Every so many of the coordinates, and the last.
vtkSmartPointer<vtkDoubleArray> Some(vtkDataArray* coordinates)
{
  constexpr vtkIdType step = 4;
  auto some = vtkSmartPointer<vtkDoubleArray>::New();
  const vtkIdType last = coordinates->GetNumberOfTuples() - 1;
  for (vtkIdType i = 0; i < last; i += step)
  {
    some->InsertNextValue(coordinates->GetTuple1(i));
  }
  some->InsertNextValue(coordinates->GetTuple1(last));
  return some;
}

/// Lines at some of the coordinates, on the sides of the box that are behind all else.
void AddGridLines(Studio& room, vtkRectilinearGrid* grid)
{
  vtkNew<vtkRectilinearGrid> coarse;
  coarse->SetXCoordinates(Some(grid->GetXCoordinates()));
  coarse->SetYCoordinates(Some(grid->GetYCoordinates()));
  coarse->SetZCoordinates(Some(grid->GetZCoordinates()));
  coarse->SetDimensions(static_cast<int>(coarse->GetXCoordinates()->GetNumberOfTuples()),
    static_cast<int>(coarse->GetYCoordinates()->GetNumberOfTuples()),
    static_cast<int>(coarse->GetZCoordinates()->GetNumberOfTuples()));
  double forward[3];
  room.Renderer->GetActiveCamera()->GetDirectionOfProjection(forward);
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkRectilinearGridGeometryFilter> side;
    side->SetInputData(coarse);
    int extent[6];
    coarse->GetExtent(extent);
    const int from = forward[axis] > 0.0 ? 1 : 0;
    extent[2 * axis + 1 - from] = extent[2 * axis + from];
    side->SetExtent(extent);
    constexpr Style::Color lines = { 0.30, 0.36, 0.44 };
    vtkProperty* property = room.AddPolygons(side, lines)->GetProperty();
    property->SetRepresentationToWireframe();
    property->LightingOff();
  }
}

/// A plate and what has hit it: parts of the same grid's cells.
void ShowImpact(FeatureScene& scene, const std::string& file, const std::string& name)
{
  vtkNew<vtkXMLRectilinearGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  const auto show = [](vtkTemporalCoherenceVolumeMapper* mapper, vtkVolume* volume,
                      const char* array, const Style::Color& color)
  {
    mapper->SetScalarModeToUseCellFieldData();
    mapper->SelectScalarArray(array);
    Style::Show(volume->GetProperty(), { { 0.5, color } });
  };
  show(scene.Mapper, scene.Volume, "Volume Fraction for Armor Plate", Style::Steel);
  scene.SetInput(reader->GetOutput(), name, { { -1.0, -1.3, 0.6 }, { 0.0, 0.0, 1.0 }, 1.35 });
  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  vtkNew<vtkTemporalCoherenceVolume> volume;
  mapper->SetInputDataObject(reader->GetOutput());
  volume->SetMapper(mapper);
  show(mapper, volume, "Volume Fraction for Body, Nose", Style::Gold);
  scene.Room.Renderer->AddVolume(volume);
}

Shot Rectilinear(GallerySettings& settings)
{
  const std::string file = Volumes::DataDirectory() + "/cth.vtr";
  const std::string impact = "simulated impact 129x65x65";
  const Subject spheres = FirstOf({ SpheresInstead({ 100.0 }) }, settings);
  FeatureScene scene(settings, spheres);
  scene.Show({ { spheres.Isovalues[0], Style::Teal } });
  scene.SetInput(Stretched(spheres.Image), spheres.Name + ", stretched", spheres.View);
  if (!settings.IsQuick && vtksys::SystemTools::FileExists(file, true))
  {
    ShowImpact(scene, file, impact);
  }
  else
  {
    settings.Replaced.insert(spheres.Name + " in place of " + impact);
  }
  AddGridLines(scene.Room, vtkRectilinearGrid::SafeDownCast(scene.Mapper->GetDataObjectInput()));
  return scene.Take("rectilinear", "Rectilinear grids",
    "a `vtkRectilinearGrid` as input, exact in every cell; the impact is two volumes of its cells' "
    "scalars");
}

/// Eight blocks of an image, without one, whose box is red.
vtkSmartPointer<vtkMultiBlockDataSet> Split(vtkImageData* image, Studio& room)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  constexpr unsigned int missing = 6;
  const int* extent = image->GetExtent();
  for (unsigned int i = 0; i < 8; ++i)
  {
    int part[6];
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const int low = extent[2 * axis], high = extent[2 * axis + 1], middle = (low + high) / 2;
      part[2 * axis] = (i >> axis & 1U) != 0 ? middle : low;
      part[2 * axis + 1] = (i >> axis & 1U) != 0 ? high : middle;
    }
    vtkNew<vtkExtractVOI> extract;
    extract->SetInputData(image);
    extract->SetVOI(part);
    extract->Update();
    room.AddBox(extract->GetOutput()->GetBounds(), i == missing ? Style::Coral : Style::Lines);
    if (i != missing)
    {
      blocks->SetBlock(i, extract->GetOutput());
    }
  }
  return blocks;
}

Shot Blocks(GallerySettings& settings)
{
  const Subject subject = FirstOf({ { "bonsai.vti", "CT bonsai 256^3", { 40.0 },
                                      { { -1.0, 0.35, 1.6 }, { 0.0, 1.0, 0.0 }, 1.1 } },
                                    MrHead({ 45.0 }), SpheresInstead({ 100.0 }) },
    settings);
  FeatureScene scene(settings, subject);
  scene.SetInput(Split(subject.Image, scene.Room), subject.Name, subject.View);
  scene.Show({ { subject.Isovalues[0], Style::Leaf } });
  return scene.Take("blocks", "Blocks",
    "a `vtkMultiBlockDataSet` of images: no seams; a missing block (red) is a hole");
}

/// Arrows along the vectors, in places where they are long.
void AddArrows(Studio& room, vtkImageData* image, double speed)
{
  vtkNew<vtkThresholdPoints> fast;
  fast->SetInputData(image);
  fast->ThresholdByUpper(speed);
  vtkNew<vtkMaskPoints> few;
  few->SetInputConnection(fast->GetOutputPort());
  few->SetOnRatio(4);
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(16);
  arrow->SetShaftResolution(16);
  vtkNew<vtkGlyph3D> arrows;
  arrows->SetInputConnection(few->GetOutputPort());
  arrows->SetSourceConnection(arrow->GetOutputPort());
  arrows->SetVectorModeToUseVector();
  arrows->SetScaleModeToScaleByVector();
  arrows->SetScaleFactor(0.5);
  room.AddPolygons(arrows, Style::Gold);
}

Shot AmongPolygons(GallerySettings& settings)
{
  const Subject subject = FirstOf({ { "carotid.vtk", "blood flow 76x49x45", { 200.0, 240.0 },
                                      { { 0.1, -1.0, 0.35 }, { 0.0, 0.0, 1.0 }, 1.1 } },
                                    SpheresInstead({ 100.0, 150.0 }) },
    settings);
  FeatureScene scene(settings, subject);
  scene.Show({ { subject.Isovalues[0], Style::Coral, 0.3 } });
  if (subject.Image->GetPointData()->GetVectors())
  {
    AddArrows(scene.Room, subject.Image, subject.Isovalues[1]);
  }
  scene.Room.AddBox(subject.Image->GetBounds(), Style::Lines);
  return scene.Take("depth", "Among polygons",
    "arrows are `vtkPolyDataMapper`'s: they hide and are hidden layer by layer");
}

/// A pin on the surface wherever a pick of a grid of pixels hits it.
void AddPins(FeatureScene& scene, int size)
{
  vtkNew<vtkTemporalCoherencePicker> picker;
  vtkNew<vtkPoints> places;
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  constexpr int picksInRow = 14;
  for (int i = 0; i < picksInRow * picksInRow; ++i)
  {
    const double x = (i % picksInRow + 0.5) * size / picksInRow;
    const double y = (i / picksInRow + 0.5) * size / picksInRow;
    if (picker->Pick(x, y, 0.0, scene.Room.Renderer) && picker->GetIsovalueIndex() >= 0)
    {
      places->InsertNextPoint(picker->GetPickPosition());
      normals->InsertNextTuple(picker->GetPickNormal());
    }
  }
  vtkNew<vtkPolyData> picks;
  picks->SetPoints(places);
  picks->GetPointData()->SetVectors(normals);
  vtkNew<vtkArrowSource> pin;
  pin->SetTipResolution(16);
  pin->SetShaftResolution(16);
  vtkNew<vtkGlyph3D> pins;
  pins->SetInputData(picks);
  pins->SetSourceConnection(pin->GetOutputPort());
  pins->SetScaleFactor(0.08 * scene.Volume->GetLength());
  scene.Room.AddPolygons(pins, Style::Teal);
}

Shot Picked(GallerySettings& settings)
{
  const Subject subject = FirstOf({ MrHead({ 45.0 }), SpheresInstead({ 100.0 }) }, settings);
  FeatureScene scene(settings, subject);
  scene.Show({ { subject.Isovalues[0], Style::Skin } });
  scene.Room.Photograph();
  AddPins(scene, settings.Size);
  return scene.Take("picking", "Picking",
    "`vtkTemporalCoherencePicker` at a grid of pixels: an arrow along the normal of each pick");
}

struct Feature
{
  std::string Name;
  Shot (*Take)(GallerySettings&);
};

const std::vector<Feature>& All()
{
  static const std::vector<Feature> features = { { "translucent", LayerPictures::Skull },
    { "flames", LayerPictures::Flames }, { "vessels", LayerPictures::Vessels }, { "caps", Capped },
    { "cropping", Cropped }, { "clipping", Clipped }, { "rectilinear", Rectilinear },
    { "blocks", Blocks }, { "unstructured", MeshPictures::Unstructured },
    { "curvilinear", MeshPictures::Curvilinear }, { "depth", AmongPolygons }, { "picking", Picked },
    { "no-occlusion", PlainFolds }, { "occlusion", DarkFolds }, { "shadows", Shadows },
    { "blended", BlendedPictures::Tree }, { "glow", BlendedPictures::Fire },
    { "labels", LabelPictures::Organs }, { "colors", LabelPictures::Methane } };
  return features;
}

}

std::vector<std::string> Names()
{
  std::vector<std::string> names;
  for (const Feature& feature : All())
  {
    names.push_back(feature.Name);
  }
  return names;
}

void Make(GallerySettings& settings, JsonWriter& json)
{
  const PagePart part("features");
  std::cout << "Windows of " << settings.Size << " x " << settings.Size
            << " pixels (pictures are half of that); *ms*: the mapper's part of a frame after the "
               "camera has turned by "
            << Plain(FeatureScene::Degrees) << " degrees, median of " << settings.Frames << ".\n\n";
  std::vector<Shot> shots;
  json.OpenList("features");
  for (const Feature& feature : All())
  {
    if (IsWanted(feature.Name, settings))
    {
      shots.push_back(feature.Take(settings));
      json.OpenObject();
      json.Add("feature", feature.Name);
      json.Add("volume", shots.back().Volume);
      json.Add("frameMs", shots.back().Ms);
      json.Close();
    }
  }
  json.Close();
  // Two in a row, what is said of them below.
  const MarkdownTable table({ " ", " " });
  for (std::size_t i = 0; i < shots.size(); i += 2)
  {
    std::vector<std::string> pictures, words;
    for (std::size_t j = i; j < std::min(i + 2, shots.size()); ++j)
    {
      const Shot& shot = shots[j];
      pictures.push_back(Hang(shot.Picture, shot.Name, shot.Title, settings));
      words.push_back("**" + shot.Title + ".** " + shot.Volume + ": " + shot.How + ". " +
        Fixed(shot.Ms, 1) + " ms");
    }
    table.Row(pictures);
    table.Row(words);
  }
}

}
