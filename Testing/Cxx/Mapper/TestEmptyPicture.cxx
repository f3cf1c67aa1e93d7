// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// If the reason for an empty picture is known, one warning gives it.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Volumes.h"
#include "Volumes/VtkMeshes.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkPointData.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using Image = vtkSmartPointer<vtkImageData>;

Image Slope()
{
  return Volumes::FromFormula(9, VTK_DOUBLE, [](double x, double y, double) { return x + y; });
}

/// Hears the messages of a mapper.
struct Listener
{
  explicit Listener(Scene& scene)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&this->Messages);
    command->SetCallback([](vtkObject*, unsigned long, void* to, void* text)
      { static_cast<std::vector<std::string>*>(to)->emplace_back(static_cast<char*>(text)); });
    scene.Mapper->AddObserver(vtkCommand::WarningEvent, command);
    scene.Mapper->AddObserver(vtkCommand::ErrorEvent, command);
  }

  std::vector<std::string> Messages;
};

/// Expect one message, which has these words, however often the data is drawn.
void ExpectOne(const std::string& what, vtkDataSet* data, const std::string& words)
{
  Scene scene(data, { 0.2 });
  const Listener listener(scene);
  scene.LookFrom(1.0, 2.0, 0.5);
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.SetIsovalues({ 0.2 + 0.1 * frame });
    scene.Render(40, 30);
  }
  Expect(listener.Messages.size() == 1,
    what + ": " + std::to_string(listener.Messages.size()) + " messages");
  Expect(!listener.Messages.empty() && listener.Messages[0].find(words) != std::string::npos,
    what + ": " + (listener.Messages.empty() ? "nothing" : listener.Messages[0]));
}

void ExpectNone(const std::string& what, vtkDataSet* data)
{
  Scene scene(data, { 0.2 });
  const Listener listener(scene);
  scene.LookFrom(1.0, 2.0, 0.5);
  Expect(scene.Render(40, 30) && listener.Messages.empty(), what + ": a message");
}

using MakeData = std::function<vtkSmartPointer<vtkDataSet>(vtkImageData*)>;

std::vector<MakeData> AllSorts()
{
  return { [](vtkImageData* image) { return image; }, VtkMeshes::Rectilinear,
    VtkMeshes::Curvilinear,
    [](vtkImageData* image) { return VtkMeshes::Unstructured(image, VTK_TETRA); } };
}

/// Cells at one place, on a line, and in planes.
void TestFlatCells()
{
  using Point = std::array<double, 3>;
  const std::array<std::function<Point(const Point&)>, 4> places = {
    [](const Point&) {
      return Point{ 1.0, 2.0, 3.0 };
    },
    [](const Point& p) {
      return Point{ p[0] + p[1], 2.0 * (p[0] + p[1]), 0.5 };
    },
    [](const Point& p) {
      return Point{ p[0], p[1], 0.25 };
    },
    [](const Point& p) {
      return Point{ p[0] + p[2], p[1], 0.3 * (p[0] + p[2]) - 1.7 * p[1] };
    },
  };
  for (std::size_t shape = 0; shape < places.size(); ++shape)
  {
    const auto grid = VtkMeshes::Curvilinear(Slope());
    const auto mesh = VtkMeshes::Unstructured(Slope(), VTK_TETRA);
    for (vtkPointSet* data : { static_cast<vtkPointSet*>(grid), static_cast<vtkPointSet*>(mesh) })
    {
      for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
      {
        Point point;
        data->GetPoint(i, point.data());
        data->GetPoints()->SetPoint(i, places[shape](point).data());
      }
      ExpectOne(std::string("flat cells ") + data->GetClassName() + std::to_string(shape), data,
        "lie in a plane");
    }
  }
}

/// Blended volumes leave out cells with an infinite sample.
void TestInfiniteSamples()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double other : { infinity, -infinity })
  {
    const Image image = Slope();
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      image->GetPointData()->GetScalars()->SetComponent(i, 0, i % 2 == 0 ? infinity : other);
    }
    for (const int mode : { vtkVolumeMapper::COMPOSITE_BLEND,
           vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::AVERAGE_INTENSITY_BLEND })
    {
      Scene scene(image, {});
      scene.Mapper->SetBlendMode(mode);
      const Listener listener(scene);
      scene.LookFrom(1.0, 2.0, 0.5);
      Expect(scene.Render(40, 30) && scene.Render(40, 30), "infinite samples: rendered");
      Expect(listener.Messages.size() == 1 &&
          listener.Messages[0].find("is infinite") != std::string::npos,
        "infinite samples: " + std::to_string(listener.Messages.size()) + " messages");
    }
  }
}

void TestReasons()
{
  for (const MakeData& make : AllSorts())
  {
    const Image whole = Slope();
    ExpectNone("whole data", make(whole));
    const Image missing = Slope();
    missing->GetPointData()->GetScalars()->Fill(std::nan(""));
    ExpectOne("NaN everywhere", make(missing), "a sample that is NaN");
    const Image scattered = Slope();
    for (int i = 0; i < 9 * 9 * 9; ++i)
    {
      if (i % 9 % 2 == 1)
      {
        scattered->GetPointData()->GetScalars()->SetComponent(i, 0, std::nan(""));
      }
    }
    ExpectOne("NaN in every cell", make(scattered), "NaN");
    const Image hidden = Slope();
    Ghosts::FlagCells(hidden, [](int, int, int) { return vtkDataSetAttributes::HIDDENCELL; });
    ExpectOne("hidden cells", make(hidden), "are hidden by its ghost array");
  }
  TestFlatCells();
  vtkNew<vtkImageData> nothing;
  ExpectOne("no samples", nothing, "has no samples");
  vtkNew<vtkExplicitStructuredGrid> without;
  ExpectOne("no cells", without, "has no cells");
  const Image thin = Slope();
  thin->SetDimensions(9, 9, 1);
  ExpectNone("thin data", thin);
}

/// The reason is told again after it was gone.
void TestTimeSteps()
{
  const Image image = Slope();
  Scene scene(image, { 0.2 });
  const Listener listener(scene);
  scene.LookFrom(1.0, 2.0, 0.5);
  std::vector<std::size_t> told;
  for (const bool isMissing : { false, true, true, false, true, false })
  {
    image->GetPointData()->GetScalars()->DeepCopy(Slope()->GetPointData()->GetScalars());
    if (isMissing)
    {
      image->GetPointData()->GetScalars()->Fill(std::nan(""));
    }
    image->GetPointData()->GetScalars()->Modified();
    Expect(scene.Render(40, 30), "a step: rendered");
    told.push_back(listener.Messages.size());
  }
  Expect(told == std::vector<std::size_t>{ 0, 1, 1, 1, 2, 2 }, "steps: told at the wrong ones");
}

/// Lengths beyond double precision are told as such, and not as a singular transform.
void TestLengths()
{
  const Image image = Slope();
  image->SetSpacing(1e-112, 1e-112, 1e-112);
  ExpectOne("tiny cells", image, "beyond double precision");
  image->SetSpacing(1e-20, 1.0, 1e20);
  image->SetOrigin(0.0, 0.0, 0.0);
  ExpectNone("uneven cells", image);
}

}

int TestEmptyPicture(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestReasons();
  TestInfiniteSamples();
  TestTimeSteps();
  TestLengths();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
