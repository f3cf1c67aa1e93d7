// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeReader_h
#define VolumeReader_h

#include "Program/VolumeSource.h"

#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>

struct Volume
{
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkMatrix4x4> Placement; // from the image's space to the patient's; may be null
  std::string Name;                        // for people: the file's name, printable
  std::string From = "-y";                 // the viewer's place that suits this kind of file
};

// Is told the share that is read, from 0 to 1; false stops the reading.
using ReadingProgress = std::function<bool(double share)>;

// The volume, read by VTK's readers, or generated. Throws UserError.
Volume ReadVolume(const VolumeSource& source, const ReadingProgress& progress = {});

// Whether the name ends as that of a volume that is read; says nothing of what is in the file.
bool HasVolumeSuffix(const std::string& path);

#endif
