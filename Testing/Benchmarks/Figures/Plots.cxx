// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plots.h"

#include "FigurePictures.h"
#include "Measuring.h"
#include "PngFile.h"
#include "Report.h"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSVGExporter.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace Plots
{
namespace
{

constexpr int Width = 1200;
constexpr int Height = 700;
constexpr int TitleSize = 22;
constexpr int AxisTitleSize = 18;
constexpr int LabelSize = 16;
constexpr float LineWidth = 2.5F;
/// Beside the first and the last bars, in distances of bars.
constexpr double RoomForBars = 0.6;
/// By what the highest value is surpassed, so that a legend in the chart hides no bar.
constexpr double RoomForLegend = 1.25;
constexpr int MostTicks = 10;
/// Of a chart that shows nothing but zeros.
constexpr double SmallestTop = 1e-3;
/// Shape of the part of the picture that the lines are in.
constexpr double HeightByWidth = 0.65;

/// Okabe and Ito's colours, told apart by all eyes.
constexpr std::array<std::array<unsigned char, 3>, NumberOfColors> Colors = { { { 0, 114, 178 },
  { 213, 94, 0 }, { 0, 158, 115 }, { 204, 121, 167 }, { 86, 180, 233 }, { 230, 159, 0 } } };

vtkSmartPointer<vtkTable> TableOf(const Series& series)
{
  vtkNew<vtkDoubleArray> x, y;
  x->SetName("x");
  y->SetName(series.Name.c_str());
  for (std::size_t i = 0; i < series.X.size(); ++i)
  {
    x->InsertNextValue(series.X[i]);
    y->InsertNextValue(series.Y[i]);
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(x);
  table->AddColumn(y);
  return table;
}

void AddPlot(vtkChartXY* view, const Series& series, bool isBars)
{
  vtkPlot* plot = view->AddPlot(isBars ? vtkChart::BAR : vtkChart::LINE);
  plot->SetInputData(TableOf(series), 0, 1);
  const std::array<unsigned char, 3>& color = Colors[static_cast<std::size_t>(series.Color)];
  plot->SetColor(color[0], color[1], color[2], 255);
  plot->SetWidth(isBars ? 0.0F : LineWidth);
  plot->GetPen()->SetLineType(series.IsDashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
}

void SetUpAxis(vtkAxis* axis, const std::string& title, const Ticks& ticks)
{
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(AxisTitleSize);
  axis->GetTitleProperties()->BoldOff();
  axis->GetLabelProperties()->SetFontSize(LabelSize);
  axis->GetGridPen()->SetColor(225, 225, 225, 255);
  if (ticks.empty())
  {
    return;
  }
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const auto& [position, label] : ticks)
  {
    positions->InsertNextValue(position);
    labels->InsertNextValue(label);
  }
  axis->SetCustomTickPositions(positions, labels);
}

double Largest(const Chart& chart, std::vector<double> Series::*axis)
{
  double largest = 0.0;
  for (const Series& series : chart.Series)
  {
    largest = std::max(largest, Measuring::Worst(series.*axis));
  }
  return largest;
}

/// Numbers from 0 to at least the largest, in steps of 1, 2 or 5 times a power of ten.
Ticks NumberTicks(double largest)
{
  double step = std::pow(10.0, std::floor(std::log10(largest / MostTicks)));
  for (const double factor : { 2.0, 2.5, 2.0 })
  {
    step *= largest > MostTicks * step ? factor : 1.0;
  }
  Ticks ticks;
  for (int i = 0; ticks.empty() || ticks.back().first < largest; ++i)
  {
    ticks.emplace_back(i * step, Plain(i * step));
  }
  return ticks;
}

/// The same lines with heights in the unit of the widths. VTK draws a line into SVG by the mean of
/// the scales of both axes: only if they are equal it is as wide as was asked for.
Chart WithEqualScales(Chart chart)
{
  if (chart.YTicks.empty())
  {
    chart.YTicks = NumberTicks(std::max(Largest(chart, &Series::Y), SmallestTop));
  }
  const double height = chart.YTicks.back().first - chart.YTicks.front().first;
  const double factor = HeightByWidth * Largest(chart, &Series::X) / height;
  for (Series& series : chart.Series)
  {
    for (double& y : series.Y)
    {
      y *= factor;
    }
  }
  for (auto& [position, label] : chart.YTicks)
  {
    position *= factor;
  }
  return chart;
}

/// All of the data, widths from 0, heights from 0 or from the first tick.
void SetRanges(vtkChartXY* view, const Chart& chart)
{
  vtkAxis* bottom = view->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* left = view->GetAxis(vtkAxis::LEFT);
  bottom->SetBehavior(vtkAxis::FIXED);
  left->SetBehavior(vtkAxis::FIXED);
  const double margin = chart.IsBars ? RoomForBars : 0.0;
  bottom->SetRange(-margin, Largest(chart, &Series::X) + margin);
  if (chart.YTicks.empty())
  {
    left->SetRange(0.0, RoomForLegend * Largest(chart, &Series::Y));
  }
  else
  {
    left->SetRange(chart.YTicks.front().first, chart.YTicks.back().first);
  }
}

void SetUp(vtkChartXY* view, const Chart& chart)
{
  view->SetTitle(chart.Title);
  view->GetTitleProperties()->SetFontSize(TitleSize);
  view->SetBarWidthFraction(0.7F);
  view->SetShowLegend(true);
  view->GetLegend()->SetLabelSize(LabelSize);
  view->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  view->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  view->GetLegend()->SetInline(chart.IsBars);
  SetUpAxis(view->GetAxis(vtkAxis::BOTTOM), chart.XTitle, chart.XTicks);
  SetUpAxis(view->GetAxis(vtkAxis::LEFT), chart.YTitle, chart.YTicks);
  for (const Series& series : chart.Series)
  {
    AddPlot(view, series, chart.IsBars);
  }
  SetRanges(view, chart);
}

void WriteSvg(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkSVGExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->SetFileName(file.c_str());
  exporter->SetTitle("");
  exporter->SetDescription("");
  exporter->Write();
  if (vtksys::SystemTools::FileLength(file) == 0)
  {
    throw Measuring::Failure("Cannot write " + file + ": name a folder that can be written in.");
  }
}

}

void Write(const Chart& chart, const std::string& path)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkChartXY> view;
  SetUp(view, chart.IsBars ? chart : WithEqualScales(chart));
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(view);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  actor->GetScene()->SetRenderer(renderer);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(Width, Height);
  window->AddRenderer(renderer);
  window->Render();

  WritePng(FigurePictures::Grabbed(window), path + ".png");
  WriteSvg(window, path + ".svg");
}

}
