// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeReader_h
#define VolumeReader_h

#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

#include <string>

struct Options;

struct Volume
{
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkMatrix4x4> Placement; // from the image's space to the patient's; may be null
  std::string Name;                        // for people: the file's name
  std::string From = "-y";                 // the viewer's place that suits this kind of file
};

// The volume that the options name, read by VTK's readers, or generated. Throws UserError.
Volume ReadVolume(const Options& options);

#endif
