// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_PaperNumbers_h
#define Benchmarks_PaperNumbers_h

#include <array>

/// What the paper's text says of its own measurements, on an SGI Onyx. Its plots have no numbers
/// beside these.
namespace PaperNumbers
{

/// Seconds of a picture in section 5, without image cache and with it.
struct CachedPicture
{
  const char* Volume; ///< as Figures::LoadSubjects calls it, before the size
  double WithoutCache, WithCache;
};
constexpr std::array<CachedPicture, 2> CachedPictures = { { { "brain 128", 50.0, 15.0 },
  { "brain doubled", 75.0, 20.0 } } };

/// "in one half to one third the time", of all volumes.
constexpr const char* UsualSpeedUp = "2-3";

/// Seconds of section 5's account of figure 7, for all volumes: from, to.
struct Seconds
{
  double From, To;
};
constexpr Seconds WithoutIsomap = { 35.0, 40.0 };
constexpr Seconds BuildingIsomap = { 40.0, 75.0 };
constexpr Seconds Threshold = { 1.0, 1.5 };

}

#endif
