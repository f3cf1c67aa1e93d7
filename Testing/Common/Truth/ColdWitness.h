// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ColdWitness_h
#define Testing_ColdWitness_h

#include "Scenes/Scene.h"

#include <string>

/// A fresh mapper that draws the same scene. Frames made with the help of earlier ones are compared
/// with its picture.
class ColdWitness
{
public:
  ColdWitness() { this->Mapper->SetAntialiasingToOff(); }

  /// Draw the scene in the size of its last picture.
  /// \return true if it was drawn, by a cold frame
  bool Draw(Scene& scene);

  /// True if the scene's last picture is the one drawn, to the last bit.
  bool IsColorIdentical(const Scene& scene) const { return AreIdentical(this->Color, scene.Color); }
  bool IsDepthIdentical(const Scene& scene) const { return AreIdentical(this->Depth, scene.Depth); }
  bool IsIdentical(const Scene& scene) const
  {
    return this->IsColorIdentical(scene) && this->IsDepthIdentical(scene);
  }

  /// Pixels where only one of this picture and the scene's last one has a surface.
  vtkIdType CountOtherSilhouettes(const Scene& scene) const { return this->Count(scene, -1.0); }

  /// The same, plus pixels where the surfaces are more than some voxels apart (shortest edges in
  /// the world).
  vtkIdType CountDifferent(const Scene& scene, double voxels = 1.0) const;

  vtkNew<vtkTemporalCoherenceVolumeMapper> Mapper;
  vtkNew<vtkImageData> Color, Depth;

private:
  /// \param apart the distance that counts; none if it is negative
  vtkIdType Count(const Scene& scene, double apart) const;
};

/// The route that made the scene's last picture.
bool IsRoute(Scene& scene, const std::string& route);

#endif
