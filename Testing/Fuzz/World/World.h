// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_World_h
#define Fuzz_World_h

#include "World/Bytes.h"
#include "World/Story.h"
#include "vtkTemporalCoherenceVolumeMapper.h"

#include <vtkCamera.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <array>
#include <vector>

namespace Fuzz
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

/// What a run of bytes is about, so that each route is met often.
enum class Theme
{
  Anything,
  Sweep,     ///< isovalues in a view that stays
  Orbit,     ///< views of isovalues that stay
  TimeSteps, ///< samples
  Looks,     ///< colours, lights, opacities
  Wrecks,    ///< what is mistaken
  Layers     ///< translucent isovalues and their opacities
};

/// How many there are.
constexpr std::size_t NumberOfThemes = 7;

/// The usual limit for meshes in MiB: without one, a few curved cells of noise become a million.
constexpr int MeshMemory = 16;

/// A mapper, all that it draws, and those who look at it.
struct World
{
  explicit World(std::vector<std::uint8_t> bytes);

  vtkVolume* Volume() const { return this->Volumes[this->AtVolume]; }
  vtkRenderer* Renderer() const { return this->Renderers[this->AtRenderer]; }
  vtkCamera* Camera() const { return this->Renderer()->GetActiveCamera(); }
  vtkVolumeProperty* Property() const { return this->Volume()->GetProperty(); }

  /// The image that is drawn or the first of the blocks that are; null if there is none.
  vtkImageData* Image() const;

  /// All data sets of the input.
  std::vector<vtkDataSet*> DataSets() const;

  /// True if hits are in cells that have numbers.
  bool IsMesh() const;

  /// A scene that is drawn without an error. The mapper keeps its past.
  void MakeSane();

  /// The whole volume is seen from a direction.
  void LookFrom(double x, double y, double z);

  void SetIsovalues(const std::vector<double>& isovalues);

  Bytes From;
  Theme About = Theme::Anything;
  bool IsOfMeshes = false; ///< the input is a mesh, mostly
  bool IsOfLabels = false; ///< the samples are labels, mostly
  bool IsLarge = false;    ///< more cells, pixels and layers than usual
  vtkSmartPointer<Mapper> Subject;
  std::array<vtkSmartPointer<vtkVolume>, 2> Volumes;
  std::array<vtkSmartPointer<vtkRenderer>, 2> Renderers;
  std::size_t AtVolume = 0, AtRenderer = 0;
  std::vector<vtkSmartPointer<vtkDataObject>> Shelf; ///< data drawn before, to come back to
  int Width = 16, Height = 12;

  double Low = 0.0, High = 100.0; ///< where isovalues are worth asking for
  bool IsTame = true;             ///< no number of the scene is wild

  /// Samples were written and nobody was told: what frames show means nothing until the mapper has
  /// forgotten them.
  bool HasSilentChange = false;
};

/// A kind of change, and how often it is made in runs of each theme.
struct ChangeKind
{
  const char* Name;
  std::array<int, NumberOfThemes> Weights;
  void (*Make)(World&);
};

}

#endif
