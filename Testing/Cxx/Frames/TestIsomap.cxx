// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What is looked up in an isomap of tolerance 0 is the cold picture to the last bit, whatever the
// samples, the isovalues and the view.

#include "Checks/Expect.h"
#include "Volumes/Volumes.h"
#include "Walks/Sweep.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace
{

constexpr int Width = 61, Height = 47; ///< with tiles that are not full

/// Ask for an isomap of all samples. Without one, it depends on the speed of the machine how soon a
/// drag is looked up.
void AskForAll(Scene& scene, const Subject& subject)
{
  const std::vector<double> samples = Sweep::FiniteSamplesOf(subject);
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  scene.Mapper->SetIsomapRange(*low - 1.0, *high + 1.0);
}

/// Up through all isovalues, built as time allows; then anywhere, looked up.
/// \param opacity of the surfaces
void SweepField(const Subject& subject, const Sweep::Placing& placing, int steps, int jumps,
  unsigned seed, double opacity = 1.0)
{
  const std::string what = subject.Describe() + ", " + placing.Name +
    (opacity < 1.0 ? ", opacity " + std::to_string(opacity) : "");
  Scene scene(subject.Image, { 0.0 });
  subject.Prepare(scene);
  if (opacity < 1.0)
  {
    vtkNew<vtkPiecewiseFunction> function;
    function->AddPoint(0.0, opacity);
    scene.Volume->GetProperty()->SetScalarOpacity(function);
  }
  placing.SetCamera(scene);
  Sweep::Routes routes =
    Sweep::ExpectCold(scene, Sweep::Up(subject, steps), Width, Height, what + ", up");
  AskForAll(scene, subject);
  std::vector<double> isovalues = Sweep::Jumps(subject, jumps, seed);
  const std::vector<double> again = Sweep::Up(subject, 10);
  isovalues.insert(isovalues.end(), again.begin(), again.end());
  for (const auto& [route, count] :
    Sweep::ExpectCold(scene, isovalues, Width, Height, what + ", anywhere"))
  {
    routes[route] += count;
  }
  Sweep::ExpectOnly({ "IsomapBuild", "IsomapLookup" }, routes, what);
}

/// Each field in some of the placings, so that together they have been in all.
void TestAllFields()
{
  const std::vector<Sweep::Placing> placings = Sweep::AllPlacings();
  std::size_t turn = 0;
  for (Subject subject : Sweep::AllFields())
  {
    for (subject.Mode = 0; subject.Mode < 2; ++subject.Mode)
    {
      const auto next = [&]() -> const Sweep::Placing& { return placings[++turn % 5]; };
      const auto seed = static_cast<unsigned>(turn);
      subject.IsNearest = false;
      SweepField(subject, next(), 200, 60, seed);
      SweepField(subject, next(), 50, 60, seed + 1000);
      subject.IsNearest = true;
      SweepField(subject, next(), 50, 60, seed + 2000);
    }
    // So that modes and fields meet other placings the next time.
    ++turn;
  }
}

/// See-through surfaces: the first one of a ray is looked up, those behind it are traced.
void TestTranslucentSurfaces()
{
  const std::vector<Sweep::Placing> placings = Sweep::AllPlacings();
  std::size_t turn = 0;
  for (Subject subject : Sweep::AllFields())
  {
    subject.Mode = static_cast<int>(++turn % 2);
    subject.IsNearest = turn % 5 == 0;
    SweepField(subject, placings[turn % 5], 40, 20, static_cast<unsigned>(turn), 0.3);
  }
}

/// One of several isovalues moves, then another, then all; their order changes; some come and go.
std::vector<std::vector<double>> ListsOf(const Subject& subject)
{
  const std::vector<double> low = Sweep::Up(subject, 60);
  std::vector<std::vector<double>> lists;
  for (std::size_t i = 0; i < 20; ++i)
  {
    lists.push_back({ low[15 + i], low[40], low[25] });
  }
  for (std::size_t i = 0; i < 20; ++i)
  {
    lists.push_back({ low[35], low[40 - i], low[25] });
  }
  for (std::size_t i = 0; i < 20; ++i)
  {
    lists.push_back({ low[35 - i], low[20 + i], low[25 + i] });
  }
  std::vector<double> permuted = lists.back();
  std::sort(permuted.begin(), permuted.end());
  do
  {
    lists.push_back(permuted);
  } while (std::next_permutation(permuted.begin(), permuted.end()));
  for (const std::size_t added : std::array<std::size_t, 5>{ 3, 50, 31, 59, 0 })
  {
    permuted.push_back(low[added]);
    lists.push_back(permuted);
  }
  // The same one twice.
  permuted.push_back(permuted.front());
  lists.push_back(permuted);
  while (permuted.size() > 1)
  {
    permuted.erase(permuted.begin() + static_cast<std::ptrdiff_t>(permuted.size() / 2));
    lists.push_back(permuted);
  }
  return lists;
}

void TestSeveralIsovalues()
{
  const std::vector<Sweep::Placing> placings = Sweep::AllPlacings();
  std::size_t turn = 0;
  for (Subject subject : Sweep::AllFields())
  {
    const std::vector<std::vector<double>> lists = ListsOf(subject);
    for (subject.Mode = 0; subject.Mode < 2; ++subject.Mode)
    {
      const Sweep::Placing& placing = placings[++turn % 5];
      subject.IsNearest = turn % 3 == 0;
      Scene scene(subject.Image, { 0.0 });
      subject.Prepare(scene);
      placing.SetCamera(scene);
      const std::string what = subject.Describe() + ", " + placing.Name + ", several isovalues";
      Sweep::Routes routes = Sweep::ExpectCold(scene, lists, Width, Height, what);
      AskForAll(scene, subject);
      for (const auto& [route, count] :
        Sweep::ExpectCold(scene, lists, Width, Height, what + ", a range"))
      {
        routes[route] += count;
      }
      Sweep::ExpectOnly({ "IsomapBuild", "IsomapLookup" }, routes, what);
    }
  }
}

void TestThreads()
{
  // The backend of plain threads starts as many as it is told, whatever the machine has.
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  const Subject subject{ "waves", Volumes::Waves(), {} };
  for (const int threads : { 1, 2, 7 })
  {
    vtkSMPTools::Initialize(threads);
    SweepField(subject, Sweep::AllPlacings()[0], 50, 20, 5);
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
}

/// Real volumes, where they are present.
void TestRealVolumes()
{
  for (const char* name : { "engine.vti", "headsq.vti", "aneurism.vti", "hydrogen.vti" })
  {
    Subject subject{ name, Volumes::Load(name), {} };
    for (subject.Mode = 0; subject.Image && subject.Mode < 2; ++subject.Mode)
    {
      SweepField(subject, Sweep::AllPlacings()[static_cast<std::size_t>(subject.Mode)], 40, 10, 2);
    }
  }
}

}

int TestIsomap(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which are among the samples.
  vtkFloatingPointExceptions::Disable();
  TestAllFields();
  TestTranslucentSurfaces();
  TestSeveralIsovalues();
  TestThreads();
  TestRealVolumes();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
