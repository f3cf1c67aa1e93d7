// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RequestFromMapper_h
#define TemporalCoherence_RequestFromMapper_h

#include "Request/BlendingFromVolume.h"
#include "Request/FieldFromMapper.h"
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

/// The mapper's own settings that a picture depends on, besides those of every volume mapper.
struct PictureSettings
{
  VectorChoice Vectors;
  SurfaceMode Mode = SurfaceMode::Crossing;
  bool ColorByAnswer = false;
  double ColorWindow = 1.0, ColorLevel = 0.5; ///< maps colours level +- window / 2 to [0, 1]
  vtkContourValues* DepthPass = nullptr;      ///< isovalues if the property has none; or null
  MaskSettings Mask;
  double SampleDistance = 0.0;     ///< of blended volumes; 0: as dense as the picture needs
  bool AveragedGradients = false;  ///< of meshes
  std::size_t MeshMemoryLimit = 0; ///< bytes for what is made of a mesh; 0: no limit
};

/// The viewer and the size of a frame.
struct FrameSight
{
  vtkRenderer* Renderer = nullptr; ///< null: no viewer; view and appearance are not made
  glm::ivec2 Size{ 1 };            ///< rays along each axis
  double Aspect = 1.0;             ///< width by height of what the camera sees
};

/// A request for a frame.
struct FrameRequest
{
  FrameKey Key;
  std::vector<int> IsovaluePlaces; ///< position in the list, for each isovalue of the key
  vtkSmartPointer<vtkContourValues> IsovalueList; ///< including transparent ones

  bool ComparesDepths = true; ///< with those of a window, when it is shown there

  FieldSetUp SetUp;
  std::shared_ptr<const CellOrigins> Cells; ///< of a mesh: which cells of the data are its cells

  /// Keeps what is read alive if an observer gives the mapper another input meanwhile.
  std::vector<vtkSmartPointer<vtkObjectBase>> Read;
};

/// Reads everything that a frame depends on from a mapper, a volume and a renderer, and keeps what
/// had to be computed from the input.
class RequestFromMapper
{
public:
  /// \param error gets what is wrong and what to do about it
  /// \param report told how far a mesh is set up, if it has to be; it may stop it
  /// \return false on error, or, without one, if it was stopped. An input without points is no
  ///         error: its frame is empty.
  bool Make(vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume,
    const FrameSight& sight, FrameRequest& request, std::string& error,
    const ReportProgress& report = {});

  /// True if a mapper draws surfaces, and all are opaque.
  bool IsOpaque(vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume);

  /// Drop what was computed.
  void Release();

private:
  bool FindDrawn(vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume,
    DrawnComponent& drawn, std::string& error);
  static bool MakeSurfaces(const PictureSettings& settings, vtkVolume* volume,
    vtkRenderer* renderer, const DrawnComponent& drawn, FrameRequest& request, std::string& error);
  bool MakeBlending(vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume,
    vtkRenderer* renderer, const DrawnComponent& drawn, FrameRequest& request, std::string& error);
  bool MakeScene(const FieldQuery& query, int component, FrameRequest& request, std::string& error);

  FieldFromMapper Fields;
  BlendingFromVolume Blendings;
  DrawnComponent Drawn;       ///< that was found last
  bool IsMakingField = false; ///< meanwhile observers may ask anything
};

}

#endif
