// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RequestFromMapper_h
#define TemporalCoherence_RequestFromMapper_h

#include "Input/HiddenCellsFromImage.h"
#include "Input/InputFromMapper.h"
#include "Scene/FrameKey.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// What a picture depends on of a mapper's settings, beyond those that every volume mapper has.
struct PictureSettings
{
  VectorChoice Vectors;
  SurfaceMode Mode = SurfaceMode::Crossing;
  bool ColorByAnswer = false;
  double ColorWindow = 1.0, ColorLevel = 0.5; ///< shown are colours level +- window / 2
  vtkContourValues* DepthPass = nullptr;      ///< isovalues where the property has none; or null
  MaskSettings Mask;
};

/// Who sees a frame, and how large it is.
struct FrameSight
{
  vtkRenderer* Renderer = nullptr; ///< null: nobody; view and appearance are left out
  glm::ivec2 Size{ 1 };            ///< rays along each axis
  double Aspect = 1.0;             ///< width by height of what the camera sees
};

/// A frame that is asked for.
struct FrameRequest
{
  FrameKey Key;
  std::vector<int> IsovaluePlaces;                ///< position in their list of the key's isovalues
  vtkSmartPointer<vtkContourValues> IsovalueList; ///< with those that are transparent, too

  /// The samples, so that they stay where observers give the mapper another input meanwhile.
  vtkSmartPointer<vtkDataArray> Read;
};

/// Reads from a mapper, a volume and a renderer everything that a frame depends on, and keeps what
/// has to be computed of the input for that.
class RequestFromMapper
{
public:
  /// \param error gets what is wrong and what to do about it
  /// \return false on error. An input without points is none: its frame is empty.
  bool Make(vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume,
    const FrameSight& sight, FrameRequest& request, std::string& error);

  /// True if nothing can be seen through the surfaces that a mapper shows.
  bool IsOpaque(vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume);

  /// Forget what was computed.
  void Release();

private:
  bool MakeScene(vtkVolumeMapper* mapper, const MaskSettings& mask, vtkVolume* volume,
    const MapperInput& input, FrameKey& key, std::string& error);

  InputFromMapper Input;
  HiddenCellsOfImage Hidden;
};

}

#endif
