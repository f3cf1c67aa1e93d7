// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_GrowthSteps_h
#define Benchmarks_GrowthSteps_h

#include "Report.h"
#include "Stage.h"
#include "TypicalFrames.h"

#include <string>
#include <vector>

/// How times and memory grow with the data and with the picture.
namespace GrowthSteps
{

/// What a mapper adds to the memory of the process, in bytes; None where that cannot be told.
struct Memory
{
  double Volume = 0.0;     ///< the samples themselves
  double FirstFrame = 0.0; ///< held after a first frame
  double Reuse = 0.0;      ///< held after a moved camera and a new isovalue, too
  double Isomap = 0.0;     ///< of that, the isomap
  double Peak = 0.0;       ///< the most while these frames were made
};

/// One size of one object.
struct Step
{
  std::string Object;
  int SamplesASide = 0;
  int Pixels = 0; ///< in each direction
  TypicalFrames::Times Frames;
  GrowthSteps::Memory Memory;
};

/// Where growth begins, samples a side.
constexpr int Smallest = 128;

/// The four spheres and Marschner and Lobb's signal with the fewest samples, and then twice as many
/// in each direction until the largest.
std::vector<Step> MeasureVoxels(int pixels, const Framing& framing, int largest, int frames);

/// The four spheres of 256^3 samples in pictures of half, once and twice as many pixels in each
/// direction.
std::vector<Step> MeasurePixels(int pixels, const Framing& framing, int frames);

/// Times, and by what each step multiplies those of the one before.
void PrintTimes(const std::vector<Step>& steps);
void PrintMemory(const std::vector<Step>& steps);

void AddTo(JsonWriter& json, const std::string& name, const std::vector<Step>& steps);

}

#endif
