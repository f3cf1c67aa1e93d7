// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeSource_h
#define VolumeSource_h

#include <array>
#include <optional>
#include <string>

// What a file of bare samples does not tell itself.
struct RawLayout
{
  std::array<int, 3> Dimensions = { 0, 0, 0 };
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 };
  int ScalarType = 0; // VTK_UNSIGNED_CHAR, ...
};

// Where a volume comes from.
struct VolumeSource
{
  std::string Path;  // file or directory; empty: the generated spheres
  int Spheres = 256; // samples along an axis of the generated volume
  std::optional<RawLayout> Raw;
  bool BigEndian = false; // of raw samples
  std::string Array;      // name of what is drawn; empty: chosen
  int TimeStep = 1;       // of the file, from 1

  // Of volumes that are read as they are needed:
  bool IsLarge = false; // to be read so, whatever the size
  int Level = 0;        // of resolution; 0 is the finest
  int Channel = 0;      // from 0
  int MemoryMiB = 0;    // that samples may take; 0: as usual
};

#endif
