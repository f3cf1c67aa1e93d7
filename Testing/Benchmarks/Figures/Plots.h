// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Plots_h
#define Benchmarks_Plots_h

#include <string>
#include <utility>
#include <vector>

/// Charts as files, drawn by VTK's charts in an off-screen window.
namespace Plots
{

constexpr int NumberOfColors = 6;

struct Series
{
  std::string Name;
  std::vector<double> X;
  std::vector<double> Y;
  int Color = 0; ///< less than NumberOfColors
  bool IsDashed = false;
};

/// Names for positions along an axis, in place of numbers.
using Ticks = std::vector<std::pair<double, std::string>>;

struct Chart
{
  std::string Title;
  std::string XTitle;
  std::string YTitle;
  std::vector<::Plots::Series> Series;
  bool IsBars = false; ///< bars side by side instead of lines
  Ticks XTicks;        ///< none: numbers
  Ticks YTicks;
};

/// Heights become their logarithms, with ticks at 1, 2 and 5 times powers of ten.
void SetLogarithmicHeights(Chart& chart);

/// Write the chart as PATH.png and PATH.svg.
/// \throws Measuring::Failure if a file cannot be written
void Write(const Chart& chart, const std::string& path);

}

#endif
