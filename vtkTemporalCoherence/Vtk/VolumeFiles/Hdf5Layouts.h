// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Hdf5Layouts_h
#define TemporalCoherence_Hdf5Layouts_h

#include "VolumeFiles/Hdf5DataSet.h"
#include "VolumeFiles/VolumeFile.h"

#include <string>
#include <vector>

namespace TemporalCoherence
{

/// A resolution and the data set with its samples.
struct Hdf5Level
{
  Hdf5DataSet Data;
  VolumeLevel Place;
};

/// A file with more resolutions is read without its coarsest ones.
constexpr int MostHdf5Levels = 32;

/// All functions below need an Hdf5Turn.

/// True if the file has the groups of Imaris.
bool IsImaris(const Hdf5File& file);

/// Find the resolutions of an Imaris file: data sets
/// /DataSet/ResolutionLevel r/TimePoint t/Channel c/Data, whose last chunks are padded. The true
/// size and the box of the volume are in attributes.
/// \param error receives what is wrong, in one sentence
bool FindImaris(const Hdf5File& file, const VolumeChoice& choice, std::vector<Hdf5Level>& levels,
  std::string& error);

/// True if the file has the groups of BigDataViewer.
bool IsBigDataViewer(const Hdf5File& file);

/// Find the resolutions of a BigDataViewer file: data sets /t00000/s00/L/cells of time point t,
/// setup s and level L. The setup is the chosen channel. BigDataViewer stores samples without a
/// sign as if they had one. The unit of places is the finest sample.
/// \param error receives what is wrong, in one sentence
bool FindBigDataViewer(const Hdf5File& file, const VolumeChoice& choice,
  std::vector<Hdf5Level>& levels, std::string& error);

/// Find the chosen data set, or the only one of three dimensions with numbers. The unit of places
/// is a sample.
/// \param error receives what is wrong, in one sentence
bool FindDataSet(const Hdf5File& file, const VolumeChoice& choice, std::vector<Hdf5Level>& levels,
  std::string& error);

}

#endif
