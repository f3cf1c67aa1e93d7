// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeReader_h
#define VolumeReader_h

#include "Files/Reading.h"
#include "Files/Volume.h"
#include "Program/VolumeSource.h"

#include <string>

// The volume, read by VTK's readers after a trial, or generated. Throws UserError.
Volume ReadVolume(const VolumeSource& source, const ReadingProgress& progress = {});

// Without a trial: a reader may end the program.
Volume ReadUntried(const VolumeSource& source, const ReadingProgress& progress);

// Whether the name ends as that of a volume that is read; says nothing of what is in the file.
bool HasVolumeSuffix(const std::string& path);

#endif
