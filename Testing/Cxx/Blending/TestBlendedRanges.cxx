// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Colours in the data, and components beside one another, look as VTK's GPU mapper shows them,
// whatever range the data have. Nodes of functions far from the data change no picture.

#include "BlendedScene.h"
#include "Checks/Expect.h"
#include "vtkTemporalCoherenceGPUVolumeRayCastMapper.h"
#include "vtkTemporalCoherenceObjectFactory.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

namespace
{

constexpr int Size = 64, Side = 16;
using Tuple = std::array<double, 4>;

/// An image of several components, of shares of a largest value.
vtkSmartPointer<vtkImageData> ImageOf(
  int type, int components, double largest, const std::function<Tuple(double, double, double)>& at)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  image->AllocateScalars(type, components);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    constexpr double last = Side - 1.0;
    const Tuple tuple = at(point[0] / last, point[1] / last, point[2] / last);
    for (int c = 0; c < components; ++c)
    {
      const double value = largest * tuple[static_cast<std::size_t>(c)];
      image->GetPointData()->GetScalars()->SetComponent(i, c, value);
    }
  }
  return image;
}

/// Shares from 0.2 to 0.8.
Tuple Slopes(double x, double y, double z)
{
  return { 0.2 + 0.6 * x, 0.2 + 0.6 * y, 0.2 + 0.6 * z,
    0.5 + 0.3 * std::sin(5.0 * x) * std::cos(4.0 * y) };
}
Tuple Constant(double, double, double)
{
  return { 0.8, 0.4, 0.2, 0.5 };
}

/// A window in which a mapper draws an image.
struct Stage
{
  Stage(vtkSmartPointer<vtkVolumeMapper> mapper, vtkImageData* image, int mode)
    : Mapper(mapper)
  {
    mapper->SetInputData(image);
    mapper->SetBlendMode(mode);
    this->Volume->SetMapper(mapper);
    this->Volume->GetProperty()->SetInterpolationTypeToLinear();
    this->Renderer->AddVolume(this->Volume);
    OpenWindow(this->Window, this->Renderer, Size, Size);
    this->Renderer->GetActiveCamera()->SetPosition(30.0, 70.0, 40.0);
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->Zoom(2.5); // no silhouettes
  }

  vtkNew<vtkUnsignedCharArray> Draw()
  {
    this->Window->Render();
    return PixelsOf(this->Window);
  }

  vtkSmartPointer<vtkVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

enum class Whose
{
  Ours,
  OursByFactory,
  Vtk
};

vtkSmartPointer<vtkVolumeMapper> MapperOf(Whose whose)
{
  if (whose == Whose::Ours)
  {
    return vtkSmartPointer<vtkTemporalCoherenceVolumeMapper>::New();
  }
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> mapper;
  if (whose == Whose::Vtk)
  {
    mapper = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
  }
  else
  {
    using Door = vtkTemporalCoherenceGPUVolumeRayCastMapper;
    mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::Take(vtkGPUVolumeRayCastMapper::New());
    Door::SafeDownCast(mapper)->SetBlendVolumesToAlways();
  }
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05f);
  return mapper;
}

int Largest(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  int largest = a->GetNumberOfValues() == b->GetNumberOfValues() ? 0 : 255;
  for (vtkIdType i = 0; largest < 255 && i < a->GetNumberOfValues(); ++i)
  {
    largest = std::max(largest, std::abs(a->GetValue(i) - b->GetValue(i)));
  }
  return largest;
}

/// The share of numbers that differ by more than a few 255ths.
double ShareOff(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  constexpr int few = 3;
  vtkIdType off = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    off += std::abs(a->GetValue(i) - b->GetValue(i)) > few ? 1 : 0;
  }
  return static_cast<double>(off) / static_cast<double>(a->GetNumberOfValues());
}

/// Expect the picture of VTK's GPU mapper, but where it takes the last sample before an edge.
void ExpectVtk(const std::string& what, vtkImageData* image, int mode,
  const std::function<void(Stage&)>& setLook, double most = 0.01)
{
  Stage theirs(MapperOf(Whose::Vtk), image, mode);
  setLook(theirs);
  const auto expected = theirs.Draw();
  for (const Whose whose : { Whose::Ours, Whose::OursByFactory })
  {
    Stage ours(MapperOf(whose), image, mode);
    setLook(ours);
    const double off = ShareOff(ours.Draw(), expected);
    Expect(off < most,
      what + ", " + NameOfMode(mode) + (whose == Whose::Ours ? "" : ", by the factory") +
        ": a share of " + std::to_string(off));
  }
}

/// \param largest values of the functions
void SetDependentLook(Stage& stage, double largest)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.05);
  opacity->AddPoint(0.4 * largest, 0.1);
  opacity->AddPoint(0.6 * largest, 0.75);
  opacity->AddPoint(largest, 0.9);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 1.0, 0.0, 0.2);
  color->AddRGBPoint(0.5 * largest, 0.2, 1.0, 0.3);
  color->AddRGBPoint(largest, 0.9, 0.8, 0.7);
  vtkVolumeProperty* property = stage.Volume->GetProperty();
  property->IndependentComponentsOff();
  property->SetScalarOpacity(opacity);
  property->SetColor(color);
  property->SetScalarOpacityUnitDistance(50.0); // of the first component
  const int last = stage.Mapper->GetInput()->GetPointData()->GetScalars()->GetNumberOfComponents();
  property->SetScalarOpacityUnitDistance(last - 1, 12.0);
  stage.Mapper->SetAverageIPScalarRange(0.3 * largest, 0.7 * largest);
}

/// Red, green, blue and opacity in the data.
void TestColorsInData(int mode)
{
  struct Numbers
  {
    int Type;
    double Largest;
  };
  for (const Numbers& numbers : { Numbers{ VTK_UNSIGNED_CHAR, 255.0 },
         Numbers{ VTK_UNSIGNED_SHORT, 65535.0 }, Numbers{ VTK_SHORT, 32767.0 },
         Numbers{ VTK_FLOAT, 1.0 }, Numbers{ VTK_FLOAT, 2.0 }, Numbers{ VTK_INT, 1000.0 } })
  {
    const std::string name = std::string("colours of type ") +
      vtkImageScalarTypeNameMacro(numbers.Type) + " up to " + std::to_string(numbers.Largest);
    const auto setLook = [&](Stage& stage) { SetDependentLook(stage, numbers.Largest); };
    ExpectVtk(name, ImageOf(numbers.Type, 4, numbers.Largest, Slopes), mode, setLook,
      numbers.Type == VTK_INT ? 0.04 : 0.01); // VTK's mapper keeps 8 bits of these
    if (numbers.Type != VTK_INT)              // VTK's mapper divides rounding errors by each other
    {
      ExpectVtk(
        name + ", constant", ImageOf(numbers.Type, 4, numbers.Largest, Constant), mode, setLook);
    }
  }
}

/// A colour's value and an opacity in the data. VTK's mapper takes the first sample on a ray for
/// extremes, and has no constant averages.
void TestColorAndOpacity(int mode)
{
  const auto setLook = [](Stage& stage) { SetDependentLook(stage, 200.0); };
  ExpectVtk("two components", ImageOf(VTK_UNSIGNED_CHAR, 2, 200.0, Slopes), mode, setLook);
  ExpectVtk("two floats", ImageOf(VTK_FLOAT, 2, 200.0, Slopes), mode, setLook);
}

/// Of independent components, emission adds up and extinction does not: colours may be more than
/// alpha, as with VTK's mapper, which clamps them where the picture is written.
void TestColorsAboveAlpha()
{
  for (const double opacity : { 0.1, 0.3, 0.9 })
  {
    ExpectVtk("three components", ImageOf(VTK_FLOAT, 3, 1.0, Slopes),
      vtkVolumeMapper::COMPOSITE_BLEND,
      [&](Stage& stage)
      {
        stage.Renderer->SetBackground(0.1, 0.2, 0.3);
        for (int c = 0; c < 3; ++c)
        {
          vtkNew<vtkPiecewiseFunction> even;
          even->AddPoint(0.0, opacity);
          even->AddPoint(1.0, opacity);
          vtkNew<vtkColorTransferFunction> white;
          white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
          white->AddRGBPoint(1.0, 1.0, 0.9 - 0.3 * c, 1.0);
          vtkVolumeProperty* property = stage.Volume->GetProperty();
          property->SetScalarOpacity(c, even);
          property->SetColor(c, white);
          property->SetComponentWeight(c, 1.0 - 0.2 * c);
          property->SetScalarOpacityUnitDistance(c, 9.0);
        }
      });
  }
}

/// What is added to the functions of a scene.
struct FarNodes
{
  double Distance;
  bool AtOpacity, AtColor, AtGradient;
  double Opacity = 0.7; ///< at the distance; 0.7 continues the function
};

vtkNew<vtkUnsignedCharArray> DrawWith(
  const FarNodes& far, vtkImageData* image, int mode, bool bent, const double scale)
{
  Stage stage(MapperOf(Whose::Ours), image, mode);
  const int components = image->GetPointData()->GetScalars()->GetNumberOfComponents();
  for (int c = 0; c < components; ++c)
  {
    vtkNew<vtkPiecewiseFunction> opacity, byGradient;
    vtkNew<vtkColorTransferFunction> color;
    const std::array<std::array<double, 2>, 6> opacities{ { { 0.253, 0.0 }, { 0.397, 0.0 },
      { 0.4011, 0.8 }, { 0.42, 0.0 }, { 0.61, 0.1 }, { 0.74, 0.7 } } };
    for (const auto& node : opacities)
    {
      opacity->AddPoint(scale * node[0], node[1]);
    }
    color->AddRGBPoint(scale * 0.253, 0.0, 0.0, 1.0);
    color->AddRGBPoint(scale * 0.4011, 1.0, 0.3, 0.0);
    color->AddRGBPoint(scale * 0.74, 0.0, 1.0, 0.0);
    byGradient->AddPoint(scale * 0.01, 0.1);
    byGradient->AddPoint(scale * 0.05, 1.0, 0.5, bent ? 0.4 : 0.0);
    byGradient->AddPoint(scale * 0.07, 0.6);
    if (far.AtOpacity)
    {
      opacity->AddPoint(-far.Distance, 0.0);
      opacity->AddPoint(far.Distance, far.Opacity);
    }
    if (far.AtColor)
    {
      color->AddRGBPoint(-far.Distance, 0.0, 0.0, 1.0);
      color->AddRGBPoint(far.Distance, 0.0, 1.0, 0.0);
    }
    if (far.AtGradient)
    {
      byGradient->AddPoint(far.Distance, 0.6);
    }
    vtkVolumeProperty* property = stage.Volume->GetProperty();
    property->SetScalarOpacity(c, opacity);
    property->SetColor(c, color);
    property->SetScalarOpacityUnitDistance(c, 4.0);
    if (mode == vtkVolumeMapper::COMPOSITE_BLEND && components < 3)
    {
      property->SetGradientOpacity(c, byGradient);
    }
  }
  return stage.Draw();
}

/// Functions that are the same over the data give the same picture.
void TestFarNodes(int mode)
{
  for (const int components : { 1, 2 })
  {
    for (const int type : { VTK_UNSIGNED_SHORT, VTK_FLOAT })
    {
      constexpr double scale = 300.0;
      const auto image = ImageOf(type, components, scale, Slopes);
      const bool isBent = components == 2;
      const auto near = DrawWith({ 0.0, false, false, false }, image, mode, isBent, scale);
      for (const double distance : { 1e3, 65535.0, 1e8, 1e30 })
      {
        for (int kind = 0; kind < 3; ++kind)
        {
          const FarNodes far{ distance, kind == 0, kind == 1, kind == 2 };
          const int largest = Largest(DrawWith(far, image, mode, isBent, scale), near);
          Expect(largest <= 1,
            NameOfMode(mode) + ", " + std::to_string(components) + " components: nodes at " +
              std::to_string(distance) + " (kind " + std::to_string(kind) + ") change it by " +
              std::to_string(largest));
        }
      }
    }
  }
}

/// Values far from the others change the picture only beside them, even if functions reach there.
void TestOutliers(int mode)
{
  constexpr double scale = 300.0;
  for (const double distance : { -1e8, 1e6, 1e30 })
  {
    const auto image = ImageOf(VTK_FLOAT, 1, scale, Slopes);
    for (int kind = 0; kind < 2; ++kind)
    {
      const FarNodes far{ std::abs(distance), kind == 0, kind == 1, false, 0.9 };
      vtkDataArray* samples = image->GetPointData()->GetScalars();
      const double usual = samples->GetComponent(0, 0);
      const auto without = DrawWith(far, image, mode, false, scale);
      samples->SetComponent(0, 0, distance);
      samples->Modified();
      const double off = ShareOff(DrawWith(far, image, mode, false, scale), without);
      samples->SetComponent(0, 0, usual);
      samples->Modified();
      Expect(off < 0.02,
        NameOfMode(mode) + ": a value of " + std::to_string(distance) + " (kind " +
          std::to_string(kind) + ") changes " + std::to_string(100.0 * off) + " %");
    }
  }
}

/// Ranges are those of the samples as they are, even if only the image tells that they changed.
void TestChangedSamples()
{
  const auto image = ImageOf(VTK_FLOAT, 1, 300.0, Slopes);
  Stage stage(MapperOf(Whose::Ours), image, vtkVolumeMapper::ADDITIVE_BLEND);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(-1e6, 0.01);
  opacity->AddPoint(399.0, 0.01);
  opacity->AddPoint(405.0, 0.9);
  opacity->AddPoint(1e6, 0.9);
  stage.Volume->GetProperty()->SetScalarOpacity(opacity);
  stage.Volume->GetProperty()->SetScalarOpacityUnitDistance(60.0);
  stage.Draw();
  auto* values = static_cast<float*>(image->GetScalarPointer());
  std::for_each_n(values, image->GetNumberOfPoints(), [](float& value) { value *= 2.0f; });
  image->Modified();
  const auto changed = stage.Draw();
  const auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(image);
  copy->GetPointData()->GetScalars()->Modified();
  stage.Mapper->SetInputData(copy);
  Expect(Largest(stage.Draw(), changed) == 0, "changed samples");
}

}

int TestBlendedRanges(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  vtkTemporalCoherenceObjectFactory::UseEverywhere();
  for (const int mode : BlendModes)
  {
    TestColorsInData(mode);
    if (mode == vtkVolumeMapper::COMPOSITE_BLEND || IsGrey(mode))
    {
      TestColorAndOpacity(mode);
    }
    TestFarNodes(mode);
    if (mode != vtkVolumeMapper::AVERAGE_INTENSITY_BLEND && mode != vtkVolumeMapper::ADDITIVE_BLEND)
    {
      TestOutliers(mode); // the others show shares of the whole range
    }
  }
  TestColorsAboveAlpha();
  TestChangedSamples();
  vtkTemporalCoherenceObjectFactory::UseNowhere();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
