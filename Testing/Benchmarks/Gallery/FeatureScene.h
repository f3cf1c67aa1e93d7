// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_FeatureScene_h
#define Gallery_FeatureScene_h

#include "GallerySettings.h"
#include "Studio.h"
#include "vtkTemporalCoherenceVolume.h"
#include "vtkTemporalCoherenceVolumeMapper.h"

#include <array>
#include <string>
#include <vector>

class vtkDataObject;

/// A picture of a feature, and what is to be said of it.
struct Shot
{
  std::string Name; ///< of the file
  std::string Title;
  std::string How;
  std::string Volume;
  vtkSmartPointer<vtkImageData> Picture;
  double Ms = 0.0; ///< of a frame from a moved camera, median
};

/// A volume in a studio.
struct FeatureScene
{
  static constexpr double Degrees = 2.0; ///< of the orbit that is timed, a frame

  FeatureScene(const GallerySettings& settings, const Subject& subject);
  FeatureScene(const GallerySettings& settings, vtkDataObject* data, const std::string& name,
    const Style::View& view);

  void Show(const std::vector<Style::Surface>& surfaces);

  /// Leave what lies in the direction of the normal, of a plane at a share of the box's width
  /// along that direction.
  void Clip(const std::array<double, 3>& normal, double share);

  /// Crop the corner that is nearest to the viewer.
  void CropCorner();

  /// Show other data than the subject's image.
  void SetInput(vtkDataObject* data, const std::string& name, const Style::View& view);

  /// \param name  of the file
  /// \param title what is shown
  /// \param how   how it is asked for
  Shot Take(const std::string& name, const std::string& title, const std::string& how);

  Studio Room;
  vtkNew<vtkTemporalCoherenceVolumeMapper> Mapper;
  vtkNew<vtkTemporalCoherenceVolume> Volume;

private:
  const GallerySettings& Settings;
  std::string Shown; ///< name of the volume
};

#endif
