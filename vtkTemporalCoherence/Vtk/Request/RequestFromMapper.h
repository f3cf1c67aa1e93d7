// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RequestFromMapper_h
#define TemporalCoherence_RequestFromMapper_h

#include "OutOfCore/OutOfCoreVolume.h"
#include "Request/ArrayLooksFromVolume.h"
#include "Request/BlendingFromVolume.h"
#include "Request/FieldFromMapper.h"
#include "Request/LabelLooksFromVolume.h"
#include "Request/LabelsFromVolume.h"
#include "Scene/FrameKey.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkContourValues.h>
#include <vtkObjectBase.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The mapper's own settings that affect pictures, besides the settings of vtkVolumeMapper.
struct PictureSettings
{
  VectorChoice Vectors;
  SurfaceMode Mode = SurfaceMode::Crossing;
  LabelSettings Labels;
  ArrayLookSettings ByArray; ///< of surfaces
  bool ColorByAnswer = false;
  double ColorWindow = 1.0, ColorLevel = 0.5; ///< maps colours level +- window / 2 to [0, 1]
  vtkContourValues* DepthPass = nullptr;      ///< isovalues if the property has none; or null
  MaskSettings Mask;
  double SampleDistance = 0.0;     ///< of blended volumes, in the data's coordinates; 0: converged
  bool AveragedGradients = false;  ///< the setting SmoothMeshNormals
  AmbientOcclusion Occlusion;      ///< a radius of 0 is an eighth of the longest edge
  bool IsOccluded = false;         ///< Occlusion has an effect
  bool HasShadows = false;         ///< lights cast shadows
  double LightRadius = 0.0;        ///< of lights that cast shadows, in the world
  std::size_t MeshMemoryLimit = 0; ///< bytes for the set-up of a mesh; 0: no limit
};

/// The viewer and the size of a frame.
struct FrameSight
{
  vtkRenderer* Renderer = nullptr; ///< null: no viewer; view and appearance are not made
  glm::ivec2 Size{ 1 };            ///< rays along each axis
  double Aspect = 1.0;             ///< width / height of the camera's view
};

/// A request for a frame.
struct FrameRequest
{
  FrameKey Key;
  /// For each isovalue of the key its position in the list; for a label, the label.
  std::vector<int> IsovaluePlaces;
  vtkSmartPointer<vtkContourValues> IsovalueList; ///< including transparent ones; null for labels

  bool ComparesDepths = true; ///< with the window's depths, when it is shown there

  FieldSetUp SetUp;
  std::shared_ptr<const CellOrigins> Cells; ///< of a mesh: the original cells of its cells

  std::vector<SampleChange> Told; ///< changes of the samples in place (ToldChanges)

  /// Keeps the arrays alive if an observer changes the mapper's input meanwhile.
  std::vector<vtkSmartPointer<vtkObjectBase>> Read;
  /// Volumes that these arrays are read from when samples are needed.
  std::vector<std::shared_ptr<const OutOfCoreVolume>> Volumes;
};

/// Reads the complete input of a frame from a mapper, a volume and a renderer, and keeps arrays
/// that it computes from the data.
class RequestFromMapper
{
public:
  /// \param error receives the mistake and its remedy
  /// \param report called with the progress if a mesh is set up; may stop that
  /// \return false on error and, with an empty error, after a stop. An input without points is no
  /// error: its frame is empty.
  bool Make(vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume,
    const FrameSight& sight, FrameRequest& request, std::string& error,
    const ReportProgress& report = {});

  /// True if a mapper draws isosurfaces, and all are opaque.
  bool IsOpaque(vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume);

  /// Drop all computed arrays.
  void Release();

private:
  bool FindDrawn(vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume,
    DrawnComponent& drawn, std::string& error);
  static bool MakeSurfaces(const PictureSettings& settings, vtkVolume* volume,
    vtkRenderer* renderer, const DrawnComponent& drawn, FrameRequest& request, std::string& error);
  bool MakeBlending(vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume,
    vtkRenderer* renderer, const DrawnComponent& drawn, FrameRequest& request, std::string& error);
  bool MakeScene(const FieldQuery& query, int component, FrameRequest& request, std::string& error);
  bool FinishBlending(const PictureSettings& settings, vtkVolume* volume,
    const DrawnComponent& drawn, FrameKey& key, std::string& error);
  bool MakeLabels(const PictureSettings& settings, vtkVolume* volume, vtkRenderer* renderer,
    int component, FrameRequest& request, std::string& error);
  bool MakeArrayLooks(const PictureSettings& settings, vtkVolume* volume, bool hasViewer,
    int component, FrameRequest& request, std::string& error);

  FieldFromMapper Fields;
  BlendingFromVolume Blendings;
  LabelsFromVolume Labels;
  LabelLooksFromVolume LabelLooks;
  ArrayLooksFromVolume ArrayLooks;
  DrawnComponent Drawn;       ///< from the last search
  bool IsMakingField = false; ///< meanwhile observers may ask anything
};

}

#endif
