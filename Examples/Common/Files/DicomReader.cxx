// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/DicomFile.h"
#include "Files/FileCheck.h"
#include "Files/MedicalReader.h"
#include "Program/Quoted.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkVector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <vector>

namespace
{

namespace fs = std::filesystem;

using Slices = std::vector<DicomSlice>;

constexpr double SameNumber = 1e-3;   // of cosines and distances that scanners write differently
constexpr double SameDistance = 0.02; // of a distance between slices, that rounding makes

UserError NoSeries(const std::string& path)
{
  return UserError("The directory " + Quoted(path) +
    " holds no DICOM series; name the directory with the slices themselves.");
}

Slices SlicesIn(const std::string& directory)
{
  Slices slices;
  std::error_code error;
  std::vector<std::string> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error))
  {
    if (entry.is_regular_file(error))
    {
      paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  for (const std::string& path : paths)
  {
    const Slices ofFile = ReadDicomHeader(path);
    slices.insert(slices.end(), ofFile.begin(), ofFile.end());
  }
  return slices;
}

// Whether slices may be parts of one volume.
bool AreParallel(const DicomSlice& a, const DicomSlice& b)
{
  const auto areClose = [](const std::vector<double>& one, const std::vector<double>& other)
  {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
      [](double x, double y) { return std::abs(x - y) < SameNumber; });
  };
  return a.Rows == b.Rows && a.Columns == b.Columns && a.Components == b.Components &&
    areClose(a.Orientation, b.Orientation) && areClose(a.Spacing, b.Spacing) &&
    a.Position.size() == b.Position.size();
}

// The largest of groups whose members belong together; the first of several.
Slices LargestGroup(
  const Slices& slices, const std::function<bool(const DicomSlice&, const DicomSlice&)>& isOfOne)
{
  std::vector<Slices> groups;
  for (const DicomSlice& slice : slices)
  {
    const auto group = std::find_if(groups.begin(), groups.end(),
      [&](const Slices& other) { return isOfOne(other.front(), slice); });
    (group == groups.end() ? *groups.insert(group, Slices()) : *group).push_back(slice);
  }
  const auto largest = std::max_element(groups.begin(), groups.end(),
    [](const Slices& a, const Slices& b) { return a.size() < b.size(); });
  return largest == groups.end() ? Slices() : *largest;
}

// As VTK's reader has them: from the end that the normal points to.
double PlaceOf(const DicomSlice& slice)
{
  return slice.Normal().Dot(vtkVector3d(slice.Position.data()));
}

// Where slices lie: the third axis of the volume, in the frame of VTK's reader, whose axes are that
// of the rows, against the columns, and against the normal.
struct Stack
{
  std::vector<double> Places;            // along the normal, ascending from 0
  vtkVector3d Shift = { 0.0, 0.0, 0.0 }; // from the first slice to the last
  bool IsEven = true;
};

Stack StackOf(const Slices& slices)
{
  Stack stack;
  const auto inFrame = [&slices](const DicomSlice& slice)
  {
    vtkVector3d way;
    for (int i = 0; i < 3; ++i)
    {
      const auto axis = static_cast<std::size_t>(i);
      way[i] = slice.Position[axis] - slices.front().Position[axis];
    }
    return vtkVector3d(way.Dot(slices.front().Along()), -way.Dot(slices.front().Down()),
      -way.Dot(slices.front().Normal()));
  };
  stack.Shift = inFrame(slices.back());
  const double last = static_cast<double>(slices.size() - 1);
  const double step = stack.Shift[2] / last;
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    const vtkVector3d place = inFrame(slices[i]);
    stack.Places.push_back(place[2]);
    const double share = stack.Shift[2] > 0.0 ? place[2] / stack.Shift[2] : 0.0;
    const bool isOfStack = std::abs(place[0] - share * stack.Shift[0]) <= SameDistance * step &&
      std::abs(place[1] - share * stack.Shift[1]) <= SameDistance * step;
    if (i > 0 && !(place[2] - stack.Places[i - 1] > SameDistance * step))
    {
      throw UserError(slices[i].Name() + " and " + slices[i - 1].Name() +
        " are slices of one DICOM series at one place; keep one slice of each place in the "
        "directory.");
    }
    if (!isOfStack)
    {
      throw UserError(slices[i].Name() +
        " lies beside the line of the other slices of its DICOM series; move slices that are no "
        "part of the stack elsewhere.");
    }
    stack.IsEven =
      stack.IsEven && std::abs(place[2] - step * static_cast<double>(i)) <= SameDistance * step;
  }
  return stack;
}

// Slices whose headers tell no places lie in the order of their numbers.
void PlaceByNumber(Slices& slices)
{
  std::stable_sort(slices.begin(), slices.end(),
    [](const DicomSlice& a, const DicomSlice& b) { return a.Number < b.Number; });
  const double told = slices.front().Distance, distance = told > 0.0 ? told : 1.0;
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    slices[i].Orientation = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0 };
    slices[i].Position = { 0.0, 0.0, -distance * static_cast<double>(i) };
  }
}

// The values of all slices, one after the other, rows from the lowest one.
vtkSmartPointer<vtkDataArray> ValuesOf(const Slices& slices, const ReadingProgress& progress)
{
  const auto row = static_cast<vtkIdType>(slices.front().Columns);
  const auto rows = static_cast<vtkIdType>(slices.front().Rows);
  const auto count = static_cast<vtkIdType>(slices.size());
  std::map<std::string, vtkSmartPointer<vtkDataArray>> files;
  vtkDataArray* first = nullptr;
  ValueType type;
  for (const DicomSlice& slice : slices)
  {
    vtkSmartPointer<vtkDataArray>& samples = files[slice.Path];
    const double done = static_cast<double>(files.size()) * slice.Frames;
    if (progress && !progress(done / static_cast<double>(slices.size() + slice.Frames)))
    {
      throw Stopped(fs::path(slice.Path).parent_path().string());
    }
    if (!slice.Fault.empty())
    {
      throw Damaged(slice.Path, slice.Fault);
    }
    samples = samples ? samples : ReadDicomPixels(slice.Path);
    first = files.at(slices.front().Path);
    if (samples->GetNumberOfTuples() != row * rows * slice.Frames ||
      samples->GetNumberOfComponents() != first->GetNumberOfComponents())
    {
      throw Damaged(slice.Path, "its slice is of another kind than others of the directory");
    }
    type.Add(samples, slice.Values);
  }
  const auto values = MakeArrayLike(first, type.Get(), row * rows * count);
  const vtkIdType length = row * first->GetNumberOfComponents();
  vtkIdType at = 0;
  for (const DicomSlice& slice : slices)
  {
    for (vtkIdType j = rows; j-- > 0; at += length)
    {
      const vtkIdType begin = (slice.Frame * rows + j) * length;
      Rescale(files[slice.Path], begin, begin + length, slice.Values, values, at);
    }
  }
  return values;
}

// Between columns and between rows.
std::array<double, 2> SpacingOf(const DicomSlice& slice)
{
  return slice.Spacing.empty() ? std::array<double, 2>{ 1.0, 1.0 }
                               : std::array<double, 2>{ slice.Spacing[1], slice.Spacing[0] };
}

vtkSmartPointer<vtkDataObject> EvenVolume(
  const DicomSlice& first, int count, const Stack& stack, vtkDataArray* values)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(first.Columns), static_cast<int>(first.Rows), count);
  // A gantry that was tilted moves each slice aside.
  vtkVector3d step = stack.Shift;
  const double length = step.Norm();
  const bool isTilted = std::hypot(step[0], step[1]) > SameDistance * step[2];
  const std::array<double, 2> spacing = SpacingOf(first);
  image->SetSpacing(spacing[0], spacing[1], (isTilted ? length : step[2]) / (count - 1));
  if (isTilted)
  {
    vtkNew<vtkMatrix3x3> direction;
    for (int i = 0; i < 3; ++i)
    {
      direction->SetElement(i, 2, step[i] / length);
    }
    image->SetDirectionMatrix(direction);
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

vtkSmartPointer<vtkDataObject> UnevenVolume(
  const DicomSlice& first, const Stack& stack, vtkDataArray* values)
{
  const auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  const std::array<double, 2> spacing = SpacingOf(first);
  grid->SetDimensions(static_cast<int>(first.Columns), static_cast<int>(first.Rows),
    static_cast<int>(stack.Places.size()));
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkDoubleArray> coordinates;
    for (int i = 0; i < grid->GetDimensions()[axis]; ++i)
    {
      coordinates->InsertNextValue(axis < 2 ? spacing[static_cast<std::size_t>(axis)] * i
                                            : stack.Places[static_cast<std::size_t>(i)]);
    }
    axis == 0     ? grid->SetXCoordinates(coordinates)
      : axis == 1 ? grid->SetYCoordinates(coordinates)
                  : grid->SetZCoordinates(coordinates);
  }
  grid->GetPointData()->SetScalars(values);
  return grid;
}

}

void ReadDicom(const std::string& path, const ReadingProgress& progress, Volume& volume)
{
  volume.From = "+y";
  const Slices series = LargestGroup(
    SlicesIn(path), [](const DicomSlice& a, const DicomSlice& b) { return a.Series == b.Series; });
  Slices slices = LargestGroup(series, AreParallel);
  if (slices.empty())
  {
    throw NoSeries(path);
  }
  if (slices.size() < 2)
  {
    throw UserError("The directory " + Quoted(path) +
      " holds a DICOM series of one slice; name a directory with at least 2.");
  }
  const auto remark = [&](const std::string& what)
  {
    volume.Remark += (volume.Remark.empty() ? "" : " ") +
      std::string("The slices of the DICOM series in ") + Quoted(path) + " " + what + ".";
  };
  if (slices.size() < series.size())
  {
    volume.Remark = std::to_string(series.size() - slices.size()) + " of " +
      std::to_string(series.size()) + " slices of the DICOM series in " + Quoted(path) +
      " are left out: they have another orientation, size or kind of pixels.";
  }
  if (slices.front().Position.empty() || slices.front().Orientation.empty())
  {
    PlaceByNumber(slices);
    remark("do not say where they lie: they are stacked in the order of their numbers");
  }
  if (slices.front().Spacing.empty())
  {
    remark("do not say how far their pixels are apart: 1 is taken for it");
  }
  std::stable_sort(slices.begin(), slices.end(),
    [](const DicomSlice& a, const DicomSlice& b) { return PlaceOf(a) > PlaceOf(b); });
  const Stack stack = StackOf(slices);
  const bool isTilted = std::hypot(stack.Shift[0], stack.Shift[1]) > SameDistance * stack.Shift[2];
  if (!stack.IsEven && isTilted)
  {
    throw UserError("The slices of the DICOM series in " + Quoted(path) +
      " lie aslant and at unequal distances, as if some were missing; complete the series, or "
      "resample it.");
  }
  const vtkSmartPointer<vtkDataArray> values = ValuesOf(slices, progress);
  if (stack.IsEven)
  {
    volume.Data = EvenVolume(slices.front(), static_cast<int>(slices.size()), stack, values);
    return;
  }
  volume.Data = UnevenVolume(slices.front(), stack, values);
  remark("lie at unequal distances, as if some were missing: each is drawn where it lies");
}
