// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/DicomSlice.h"
#include "Files/FileCheck.h"
#include "Files/MedicalReader.h"
#include "Program/Quoted.h"

#include <vtkDICOMImageReader.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkVector.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <vector>

namespace
{

namespace fs = std::filesystem;

using Slices = std::vector<DicomSlice>;

constexpr double SameDirection = 1e-3; // difference of cosines that scanners write differently
constexpr double SameDistance = 0.02;  // of a distance between slices, that rounding makes

UserError NoSeries(const std::string& path)
{
  return UserError("The directory " + Quoted(path) +
    " holds no DICOM series that VTK reads; name the directory with the slices themselves.");
}

Slices SlicesIn(const std::string& directory)
{
  Slices slices;
  std::error_code error;
  std::vector<std::string> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error))
  {
    if (!entry.is_directory(error))
    {
      paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  for (const std::string& path : paths)
  {
    const std::optional<DicomSlice> slice = ReadDicomHeader(path);
    if (slice && slice->HasPixels()) // reports have none
    {
      slices.push_back(*slice);
    }
  }
  return slices;
}

// Whether slices may be parts of one volume.
bool AreParallel(const DicomSlice& a, const DicomSlice& b)
{
  bool areAlike = a.Rows == b.Rows && a.Columns == b.Columns && a.Components == b.Components &&
    a.Orientation.size() == b.Orientation.size() &&
    a.Position.has_value() == b.Position.has_value();
  for (std::size_t i = 0; areAlike && i < a.Orientation.size(); ++i)
  {
    areAlike = std::abs(a.Orientation[i] - b.Orientation[i]) < SameDirection;
  }
  return areAlike;
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
  return slice.Normal().Dot(*slice.Position);
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
      way[i] = (*slice.Position)[i] - (*slices.front().Position)[i];
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
      throw UserError(Quoted(slices[i].Path) + " and " + Quoted(slices[i - 1].Path) +
        " are slices of one DICOM series at one place; keep one slice of each place in the "
        "directory.");
    }
    if (!isOfStack)
    {
      throw UserError(Quoted(slices[i].Path) +
        " lies beside the line of the other slices of its DICOM series; move slices that are no "
        "part "
        "of the stack elsewhere.");
    }
    stack.IsEven =
      stack.IsEven && std::abs(place[2] - step * static_cast<double>(i)) <= SameDistance * step;
  }
  return stack;
}

// Between columns and between rows. VTK before 9.6 takes one for the other.
void SpacePixels(const DicomSlice& slice, vtkImageData* image)
{
  if (!slice.Spacing.empty())
  {
    image->SetSpacing(slice.Spacing[1], slice.Spacing[0], image->GetSpacing()[2]);
  }
}

// The samples of all slices, one after the other.
vtkSmartPointer<vtkDataArray> SamplesOf(
  const Slices& slices, const ReadingProgress& progress, vtkImageData* first)
{
  vtkSmartPointer<vtkDataArray> all;
  vtkIdType count = 0, done = 0;
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    if (progress && !progress(static_cast<double>(i) / static_cast<double>(slices.size())))
    {
      throw Stopped(fs::path(slices[i].Path).parent_path().string());
    }
    vtkNew<vtkDICOMImageReader> reader;
    reader->SetFileName(slices[i].Path.c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    vtkDataArray* samples = image->GetPointData()->GetScalars();
    if (i == 0)
    {
      first->ShallowCopy(image);
      count = samples ? samples->GetNumberOfTuples() : 0;
    }
    if (!samples || samples->GetNumberOfTuples() != count || count == 0 ||
      (all && samples->GetNumberOfComponents() != all->GetNumberOfComponents()))
    {
      throw Damaged(slices[i].Path, "its slice is of another kind than others of the directory");
    }
    // A slope that is no whole number makes floats, which may be so in one slice only.
    if (!all || (samples->GetDataType() != all->GetDataType() && all->GetDataType() != VTK_FLOAT))
    {
      const auto wider = vtkSmartPointer<vtkDataArray>::Take(
        vtkDataArray::CreateDataArray(all ? VTK_FLOAT : samples->GetDataType()));
      wider->SetName(samples->GetName());
      wider->SetNumberOfComponents(samples->GetNumberOfComponents());
      wider->SetNumberOfTuples(count * static_cast<vtkIdType>(slices.size()));
      if (all)
      {
        wider->InsertTuples(0, done, 0, all);
      }
      all = wider;
    }
    all->InsertTuples(done, count, 0, samples);
    done += count;
  }
  return all;
}

vtkSmartPointer<vtkDataObject> EvenVolume(
  vtkImageData* first, int count, const Stack& stack, vtkDataArray* samples)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  int n[3];
  double spacing[3];
  first->GetDimensions(n);
  first->GetSpacing(spacing);
  image->SetDimensions(n[0], n[1], count);
  // A gantry that was tilted moves each slice aside.
  vtkVector3d step = stack.Shift;
  const double length = step.Norm();
  const bool isTilted = std::hypot(step[0], step[1]) > SameDistance * step[2];
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
  image->GetPointData()->SetScalars(samples);
  return image;
}

vtkSmartPointer<vtkDataObject> UnevenVolume(
  vtkImageData* first, const Stack& stack, vtkDataArray* samples)
{
  const auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  int n[3];
  double spacing[3];
  first->GetDimensions(n);
  first->GetSpacing(spacing);
  grid->SetDimensions(n[0], n[1], static_cast<int>(stack.Places.size()));
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkDoubleArray> coordinates;
    for (int i = 0; i < grid->GetDimensions()[axis]; ++i)
    {
      coordinates->InsertNextValue(
        axis < 2 ? spacing[axis] * i : stack.Places[static_cast<std::size_t>(i)]);
    }
    axis == 0     ? grid->SetXCoordinates(coordinates)
      : axis == 1 ? grid->SetYCoordinates(coordinates)
                  : grid->SetZCoordinates(coordinates);
  }
  grid->GetPointData()->SetScalars(samples);
  return grid;
}

// Of slices whose headers tell no places: the order is that of their numbers.
vtkSmartPointer<vtkImageData> ReadWithoutPlaces(
  const std::string& path, const ReadingProgress& progress)
{
  vtkNew<vtkDICOMImageReader> reader;
  reader->SetDirectoryName(path.c_str());
  Watch(reader, progress).Update(path);
  // A directory without a series leaves no file to name.
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPoints() < 2)
  {
    throw NoSeries(path);
  }
  return reader->GetOutput();
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
  if (!slices.front().Position || slices.front().Orientation.empty() || slices.size() < 2)
  {
    const vtkSmartPointer<vtkImageData> image = ReadWithoutPlaces(path, progress);
    SpacePixels(slices.front(), image);
    volume.Data = image;
    return;
  }
  if (slices.size() < series.size())
  {
    volume.Remark = std::to_string(series.size() - slices.size()) + " of " +
      std::to_string(series.size()) + " slices of the DICOM series in " + Quoted(path) +
      " are left out: they have another orientation or size.";
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
  vtkNew<vtkImageData> first;
  const vtkSmartPointer<vtkDataArray> samples = SamplesOf(slices, progress, first);
  SpacePixels(slices.front(), first);
  if (stack.IsEven)
  {
    volume.Data = EvenVolume(first, static_cast<int>(slices.size()), stack, samples);
    return;
  }
  volume.Data = UnevenVolume(first, stack, samples);
  volume.Remark = "The slices of the DICOM series in " + Quoted(path) +
    " lie at unequal distances, as if some were missing: each is drawn where it lies." +
    (volume.Remark.empty() ? "" : " " + volume.Remark);
}
