// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// When a grid changes, only what depends on the change is made again, nothing is stale, and set-up
// can be watched and stopped.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"
#include "Volumes/VtkMeshes.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Mapper = vtkTemporalCoherenceVolumeMapper;

vtkSmartPointer<vtkImageData> Waves(double phase = 0.0)
{
  return Volumes::FromFormula(14, VTK_DOUBLE,
    [=](double x, double y, double z)
    { return 50.0 * (1.0 + std::sin(3.0 * x + y + phase) * std::cos(2.5 * y) + 0.5 * z); });
}

Grid Hexahedra(vtkImageData* image)
{
  Grid grid = Grid::New();
  grid->DeepCopy(VtkMeshes::Unstructured(image, VTK_HEXAHEDRON));
  return grid;
}

/// Render, and expect what was set up, and the picture of a mapper without a past.
void ExpectSetUp(const std::string& name, Scene& scene, int expected)
{
  Expect(scene.Render(70, 60), name + ": rendered");
  Expect(scene.Mapper->GetStatistics()->GetMeshSetUp() == expected,
    name + ": set up " + std::to_string(scene.Mapper->GetStatistics()->GetMeshSetUp()) + ", not " +
      std::to_string(expected));
  Scene cold(nullptr, { 60.0 });
  cold.Mapper->SetInputDataObject(scene.Mapper->GetDataObjectInput());
  cold.Mapper->SetSmoothMeshNormals(scene.Mapper->GetSmoothMeshNormals());
  cold.Mapper->SetScalarMode(scene.Mapper->GetScalarMode());
  cold.Mapper->SelectScalarArray(scene.Mapper->GetArrayName());
  cold.Renderer->GetActiveCamera()->DeepCopy(scene.Renderer->GetActiveCamera());
  Expect(cold.Render(70, 60) && cold.Mapper->GetStatistics()->GetMeshSetUp() == Mapper::MESH_BUILT,
    name + ": cold");
  Expect(AreIdentical(cold.Color, scene.Color) && AreIdentical(cold.Depth, scene.Depth),
    name + ": not the cold picture");
}

void TestChanges()
{
  Grid grid = Hexahedra(Waves());
  Scene scene(grid, { 60.0 });
  scene.LookFrom(1.0, 2.0, 0.7);
  ExpectSetUp("first", scene, Mapper::MESH_BUILT);
  Expect(scene.Mapper->GetStatistics()->GetMeshMemory() > 0 &&
      scene.Mapper->GetStatistics()->GetMeshSetUpTime() > 0.0,
    "told");
  ExpectSetUp("again", scene, Mapper::MESH_KEPT);
  scene.Renderer->GetActiveCamera()->Azimuth(20.0);
  ExpectSetUp("another view", scene, Mapper::MESH_KEPT);

  vtkDataArray* values = grid->GetPointData()->GetScalars();
  values->SetComponent(1000, 0, 500.0);
  values->Modified();
  ExpectSetUp("a value", scene, Mapper::MESH_NEW_VALUES);
  values->SetComponent(1200, 0, 500.0);
  grid->Modified();
  ExpectSetUp("a value, told by the grid", scene, Mapper::MESH_NEW_VALUES);
  vtkNew<vtkDoubleArray> other;
  other->DeepCopy(Waves(1.0)->GetPointData()->GetScalars());
  other->SetName("other");
  grid->GetPointData()->AddArray(other);
  scene.Mapper->SetScalarModeToUsePointFieldData();
  scene.Mapper->SelectScalarArray("other");
  ExpectSetUp("another array", scene, Mapper::MESH_NEW_VALUES);

  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double at[3];
    grid->GetPoint(i, at);
    grid->GetPoints()->SetPoint(i, at[0] + 0.2 * at[1] * at[2], at[1], 1.5 * at[2]);
  }
  grid->GetPoints()->Modified();
  ExpectSetUp("points", scene, Mapper::MESH_REFITTED);
  vtkNew<vtkPoints> moved;
  moved->DeepCopy(grid->GetPoints());
  moved->SetPoint(0, -1.2, -1.2, -1.7);
  grid->SetPoints(moved);
  ExpectSetUp("new points", scene, Mapper::MESH_REFITTED);

  grid->AllocateCellGhostArray();
  grid->GetCellGhostArray()->SetValue(900, vtkDataSetAttributes::HIDDENCELL);
  grid->GetCellGhostArray()->Modified();
  ExpectSetUp("a hidden cell", scene, Mapper::MESH_BUILT);
  vtkDataArray* ids = grid->GetCells()->GetConnectivityArray();
  for (int corner = 0; corner < 8; ++corner)
  {
    ids->SetComponent(8 * 700 + corner, 0, ids->GetComponent(8 * 701 + corner, 0));
  }
  grid->GetCells()->Modified();
  ExpectSetUp("a cell", scene, Mapper::MESH_BUILT);
  scene.Mapper->SmoothMeshNormalsOn();
  ExpectSetUp("averaged gradients", scene, Mapper::MESH_KEPT);
  scene.Mapper->ClearCache();
  ExpectSetUp("released", scene, Mapper::MESH_BUILT);
}

/// Time steps of a reader are new objects, which may share their cells.
void TestTimeSteps()
{
  Grid first = Hexahedra(Waves());
  Scene scene(first, { 60.0 });
  scene.LookFrom(1.0, 2.0, 0.7);
  ExpectSetUp("first step", scene, Mapper::MESH_BUILT);
  Grid second = Grid::New();
  second->ShallowCopy(first);
  second->GetPointData()->SetScalars(Waves(0.5)->GetPointData()->GetScalars());
  scene.Mapper->SetInputData(second);
  ExpectSetUp("the same cells, other values", scene, Mapper::MESH_NEW_VALUES);
  Grid third = Grid::New();
  third->ShallowCopy(second);
  vtkNew<vtkPoints> moved;
  moved->DeepCopy(first->GetPoints());
  moved->SetPoint(5, -0.3, -1.1, -1.1);
  third->SetPoints(moved);
  scene.Mapper->SetInputData(third);
  ExpectSetUp("the same cells, other points", scene, Mapper::MESH_REFITTED);
  first = second = nullptr;
  scene.Mapper->SetInputData(Hexahedra(Waves(1.0)));
  third = nullptr;
  ExpectSetUp("other cells", scene, Mapper::MESH_BUILT);
  scene.Mapper->SetInputData(Waves());
  Expect(scene.Render(70, 60) && scene.Mapper->GetStatistics()->GetMeshSetUp() == Mapper::MESH_NONE,
    "an image");
}

/// VTK moves the numbers of an array that grows or shrinks, and its time stays the same.
void TestMovedArrays()
{
  Grid grid = Hexahedra(Waves());
  Scene scene(grid, { 60.0 });
  scene.LookFrom(1.0, 2.0, 0.7);
  ExpectSetUp("arrays stay", scene, Mapper::MESH_BUILT);
  // What is freed is written over, so that a picture of it differs.
  const auto move = [](vtkDataArray* array)
  {
    const vtkMTimeType before = array->GetMTime();
    array->Resize(1000 * array->GetNumberOfTuples());
    std::vector<std::vector<double>> others;
    for (int i = 0; i < 8; ++i)
    {
      others.emplace_back(static_cast<std::size_t>(array->GetNumberOfValues()), 1e3);
    }
    Expect(array->GetMTime() == before, "arrays move: VTK tells it");
  };
  const auto turn = [&] { scene.Renderer->GetActiveCamera()->Azimuth(7.0); };
  move(grid->GetPointData()->GetScalars());
  turn();
  ExpectSetUp("moved values", scene, Mapper::MESH_NEW_VALUES);
  move(grid->GetPoints()->GetData());
  turn();
  ExpectSetUp("moved points", scene, Mapper::MESH_REFITTED);
  move(grid->GetCells()->GetConnectivityArray());
  turn();
  ExpectSetUp("moved point ids", scene, Mapper::MESH_BUILT);
  move(grid->GetCells()->GetOffsetsArray());
  turn();
  ExpectSetUp("moved offsets", scene, Mapper::MESH_BUILT);
  move(VtkMeshes::TypesOf(grid));
  turn();
  ExpectSetUp("moved types", scene, Mapper::MESH_BUILT);
  turn();
  ExpectSetUp("nothing moved", scene, Mapper::MESH_KEPT);
}

/// Two renderers of one mapper share what is set up.
void TestTwoRenderers()
{
  Scene scene(Hexahedra(Waves()), { 60.0 });
  scene.LookFrom(1.0, 2.0, 0.7);
  ExpectSetUp("one renderer", scene, Mapper::MESH_BUILT);
  vtkNew<vtkRenderer> other;
  other->AddVolume(scene.Volume);
  other->GetActiveCamera()->SetPosition(-3.0, 1.0, 1.0);
  other->ResetCamera();
  vtkNew<vtkImageData> frame;
  Expect(scene.Mapper->MakeImage(other, scene.Volume, 50, 40, frame) &&
      scene.Mapper->GetStatistics()->GetMeshSetUp() == Mapper::MESH_KEPT,
    "another renderer");
}

/// What observers are told of a frame: it never falls, and ends at 1.
struct Listener
{
  explicit Listener(Mapper* mapper, double stopAt = 2.0)
    : StopAt(stopAt)
    , Of(mapper)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* data)
      {
        auto* const listener = static_cast<Listener*>(self);
        listener->Told.push_back(*static_cast<double*>(data));
        if (listener->Told.back() >= listener->StopAt)
        {
          listener->Of->SetAbortExecute(1);
        }
      });
    mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, this->Command);
  }
  ~Listener() { this->Of->RemoveObserver(this->Command); }

  std::vector<double> Told;
  double StopAt;
  Mapper* Of;
  vtkNew<vtkCallbackCommand> Command;
};

void TestProgress()
{
  Grid grid = Hexahedra(Volumes::Noise(24, VTK_FLOAT, 0.0, 100.0));
  Scene scene(Hexahedra(Waves()), { 60.0 });
  scene.LookFrom(1.0, 2.0, 0.7);
  Expect(scene.Render(40, 40), "a first picture");
  vtkNew<vtkImageData> before;
  before->DeepCopy(scene.Color);
  scene.Mapper->SetInputData(grid);
  EventCounter errors(scene.Mapper, vtkCommand::ErrorEvent);
  {
    Listener listener(scene.Mapper, 0.1);
    Expect(!scene.Render(40, 40) && errors.Count == 0, "stopped while set up");
    Expect(!listener.Told.empty() && listener.Told.back() < 0.6, "stopped soon");
  }
  Expect(AreIdentical(before, scene.Color), "the last picture stays");
  Expect(scene.Mapper->PickCell(20, 20, nullptr) >= 0, "and can be picked");
  Listener listener(scene.Mapper);
  Expect(
    scene.Render(40, 40) && scene.Mapper->GetStatistics()->GetMeshSetUp() == Mapper::MESH_BUILT,
    "set up");
  bool rises = !listener.Told.empty();
  for (std::size_t i = 1; i < listener.Told.size(); ++i)
  {
    rises = rises && listener.Told[i] >= listener.Told[i - 1];
  }
  Expect(
    rises && listener.Told.size() > 4 && listener.Told.front() < 0.5 && listener.Told.back() == 1.0,
    "progress rises from the beginning of the set-up to the end of the frame");
}

/// Observers of the set-up may take the data away, and ask: the frame is that of the data.
void TestObservers()
{
  Scene truth(Hexahedra(Waves()), { 60.0 }), scene(Hexahedra(Waves()), { 60.0 });
  struct Meddler
  {
    explicit Meddler(Scene& scene)
      : Of(scene)
    {
      this->Command->SetClientData(this);
      this->Command->SetCallback(
        [](vtkObject*, unsigned long, void* self, void*)
        {
          Scene& of = static_cast<Meddler*>(self)->Of;
          of.Mapper->SetInputData(static_cast<vtkDataSet*>(nullptr));
          static_cast<Meddler*>(self)->IsOpaque &= of.Mapper->IsOpaque(of.Volume);
          static_cast<Meddler*>(self)->IsTold = true;
        });
      scene.Mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, this->Command);
    }
    ~Meddler() { this->Of.Mapper->RemoveObserver(this->Command); }

    Scene& Of;
    bool IsOpaque = true, IsTold = false;
    vtkNew<vtkCallbackCommand> Command;
  };
  for (Scene* each : { &truth, &scene })
  {
    each->LookFrom(1.0, 2.0, 0.7);
  }
  Expect(truth.Render(60, 60), "meddlers: truth");
  {
    const Meddler meddler(scene);
    Expect(scene.Render(60, 60) && meddler.IsTold && meddler.IsOpaque, "meddlers: rendered");
  }
  Expect(AreIdentical(truth.Color, scene.Color), "meddlers: another picture");
  scene.Mapper->SetInputData(Hexahedra(Waves()));
  Expect(scene.Render(60, 60) && AreIdentical(truth.Color, scene.Color), "meddlers: afterwards");
}

}

int TestGridChanges(int, char*[])
{
  TestChanges();
  TestTimeSteps();
  TestMovedArrays();
  TestTwoRenderers();
  TestProgress();
  TestObservers();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
