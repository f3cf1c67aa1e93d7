// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/CinemaWriter.h"

#include "Scene/Frame.h"
#include "ViewFile/ViewFile.h"
#include "ViewFile/ViewLookUp.h"
#include "ViewFile/WholeFile.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <sstream>
#include <system_error>

namespace TemporalCoherence
{
namespace
{

constexpr const char* FileName = "views.tcview";
constexpr const char* TableName = "data.csv";

/// A number that reads back as the same. It has a point or an exponent: to Cinema, others are whole
/// numbers, and a column has one type.
std::string TextOf(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<double>::max_digits10) << number;
  const std::string written = text.str();
  return written.find_first_of(".e") == std::string::npos ? written + ".0" : written;
}

/// A text as a field of a CSV file.
std::string FieldOf(const std::string& text)
{
  std::string field = "\"";
  for (const char character : text)
  {
    field += character == '"' ? "\"\"" : std::string(1, character == '\n' ? ' ' : character);
  }
  return field + "\"";
}

/// The range of depths on surfaces; (0, 1) without any.
glm::dvec2 DepthsOf(const Frame& frame)
{
  glm::dvec2 range(std::numeric_limits<double>::infinity(), 0.0);
  for (const double depth : frame.Depth)
  {
    if (std::isfinite(depth))
    {
      range = { std::min(range.x, depth), std::max(range.y, depth) };
    }
  }
  return std::isfinite(range.x) ? range : glm::dvec2(0.0, 1.0);
}

/// Writes the images of one isovalue.
class ImageWriter
{
public:
  ImageWriter(const std::filesystem::path& folder, const Frame& frame)
    : Folder(folder)
    , Size(frame.Size)
    , Picture(frame)
    , Depths(DepthsOf(frame))
  {
    this->Image->SetDimensions(this->Size.x, this->Size.y, 1);
  }

  /// 16 bits: 0 without a surface; 1 to 65535 from the smallest depth to the largest.
  bool WriteDepths(const std::string& name)
  {
    constexpr double steps = 65534.0;
    const double length = std::max(this->Depths.y - this->Depths.x, 1e-300);
    vtkNew<vtkUnsignedShortArray> values;
    values->SetNumberOfValues(static_cast<vtkIdType>(this->Picture.Depth.size()));
    for (std::size_t i = 0; i < this->Picture.Depth.size(); ++i)
    {
      const double depth = this->Picture.Depth[i];
      values->SetValue(static_cast<vtkIdType>(i),
        std::isfinite(depth)
          ? static_cast<unsigned short>(1.5 + steps * (depth - this->Depths.x) / length)
          : static_cast<unsigned short>(0));
    }
    return this->Write(name, values);
  }

  /// Three bytes: -1 to 1 as 1 to 255; 0 without a surface.
  bool WriteNormals(const std::string& name)
  {
    constexpr float middle = 128.0f, unit = 127.0f;
    vtkNew<vtkUnsignedCharArray> values;
    values->SetNumberOfComponents(3);
    values->SetNumberOfTuples(static_cast<vtkIdType>(this->Picture.Normals.size()));
    for (std::size_t i = 0; i < this->Picture.Normals.size(); ++i)
    {
      const bool isHit = std::isfinite(this->Picture.Depth[i]);
      for (int c = 0; c < 3; ++c)
      {
        const float component = std::round(middle + unit * this->Picture.Normals[i][c]);
        values->SetTypedComponent(
          static_cast<vtkIdType>(i), c, static_cast<unsigned char>(isHit ? component : 0.0f));
      }
    }
    return this->Write(name, values);
  }

  const glm::dvec2& RangeOfDepths() const { return this->Depths; }

private:
  bool Write(const std::string& name, vtkDataArray* values)
  {
    this->Image->GetPointData()->SetScalars(values);
    vtkNew<vtkPNGWriter> writer;
    writer->SetFileName((this->Folder / name).u8string().c_str());
    writer->SetInputData(this->Image);
    writer->Write();
    return writer->GetErrorCode() == 0;
  }

  std::filesystem::path Folder;
  glm::ivec2 Size;
  const Frame& Picture;
  glm::dvec2 Depths;
  vtkNew<vtkImageData> Image;
};

/// Name of an image.
std::string NameOf(const char* kind, std::size_t view, int isovalue)
{
  char name[64];
  std::snprintf(name, sizeof(name), "%s-%02zu-%04d.png", kind, view + 1, isovalue + 1);
  return name;
}

/// Writes the images and the table of a database into an empty folder.
class DatabaseWriter
{
public:
  DatabaseWriter(const std::filesystem::path& folder, int isovalues)
    : Folder(folder)
    , Isovalues(isovalues)
  {
  }

  /// \return false if an image cannot be written, or after a stop
  bool WriteImages(const LoadedViews& views, const ReportProgress& report)
  {
    const auto count = static_cast<double>(views.Knots.size());
    for (std::size_t view = 0; view < views.Knots.size(); ++view)
    {
      for (int i = 0; i < this->Isovalues; ++i)
      {
        if (!this->WriteIsovalue(views, view, i))
        {
          return false;
        }
        const double done = static_cast<double>(view) + (i + 1.0) / this->Isovalues;
        this->IsStopped = report && !report(done / count);
        if (this->IsStopped)
        {
          return false;
        }
      }
    }
    return true;
  }

  std::string Table = "view,isovalue,depth_min,depth_max,FILE_depth,FILE_normal,FILE_view\n";
  bool IsStopped = false;

private:
  bool WriteIsovalue(const LoadedViews& views, std::size_t view, int i)
  {
    const ViewEntry& entry = views.Header.Views[view];
    const double isovalue = i + 1 == this->Isovalues
      ? entry.Range.High
      : glm::mix(entry.Range.Low, entry.Range.High, i / (this->Isovalues - 1.0));
    LookUpView(entry.Geometry, views.Knots[view], isovalue, this->Picture);
    ImageWriter images(this->Folder, this->Picture);
    const std::string depth = NameOf("depth", view, i), normal = NameOf("normal", view, i);
    this->Table += FieldOf(entry.Geometry.Name) + ',' + TextOf(isovalue) + ',' +
      TextOf(images.RangeOfDepths().x) + ',' + TextOf(images.RangeOfDepths().y) + ',' + depth +
      ',' + normal + ',' + FileName + '\n';
    return images.WriteDepths(depth) && images.WriteNormals(normal);
  }

  std::filesystem::path Folder;
  int Isovalues;
  Frame Picture;
};

/// A temporary folder: a database is made there, then renamed. The destructor removes leftovers.
class UnfinishedFolder
{
public:
  explicit UnfinishedFolder(const std::filesystem::path& finished)
    : Finished(finished)
    , Place(finished)
  {
    this->Place += ".part";
    std::error_code ignored;
    std::filesystem::remove_all(this->Place, ignored);
    std::filesystem::create_directories(this->Place, this->Failure);
  }
  ~UnfinishedFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Place, ignored);
  }
  UnfinishedFolder(const UnfinishedFolder&) = delete;
  UnfinishedFolder& operator=(const UnfinishedFolder&) = delete;

  const std::filesystem::path& Path() const { return this->Place; }

  /// Move all files to their place; the table last.
  void Finish()
  {
    std::filesystem::create_directories(this->Finished, this->Failure);
    std::vector<std::filesystem::path> names;
    for (const auto& file : std::filesystem::directory_iterator(this->Place))
    {
      names.push_back(file.path().filename());
    }
    std::sort(names.begin(), names.end(),
      [](const auto& a, const auto& b) { return a != TableName && (b == TableName || a < b); });
    for (const std::filesystem::path& name : names)
    {
      if (!this->Failure)
      {
        std::filesystem::rename(this->Place / name, this->Finished / name, this->Failure);
      }
    }
  }

  std::error_code Failure;

private:
  std::filesystem::path Finished, Place;
};

}

std::string WriteCinema(const std::string& folder, const std::vector<std::uint8_t>& file,
  int isovalues, const ReportProgress& report)
{
  LoadedViews views;
  const std::string wrong = ReadViews(file, views);
  if (!wrong.empty())
  {
    return wrong;
  }
  const std::filesystem::path place = std::filesystem::u8path(folder);
  std::error_code failure;
  if (std::filesystem::exists(place, failure) &&
    !std::filesystem::exists(place / TableName, failure))
  {
    return folder + " exists, and is no Cinema database; give another name.";
  }
  UnfinishedFolder unfinished(place);
  if (unfinished.Failure)
  {
    return folder + " cannot be made: " + unfinished.Failure.message() + ".";
  }
  DatabaseWriter database(unfinished.Path(), isovalues);
  if (!database.WriteImages(views, report))
  {
    return database.IsStopped ? std::string()
                              : folder + " cannot be filled with images; is there room?";
  }
  std::string error = ReplaceFile((unfinished.Path() / FileName).u8string(), file);
  error = error.empty() ? ReplaceFile((unfinished.Path() / TableName).u8string(),
                            { database.Table.begin(), database.Table.end() })
                        : error;
  if (!error.empty())
  {
    return error;
  }
  unfinished.Finish();
  return unfinished.Failure ? folder + " cannot be made: " + unfinished.Failure.message() + "."
                            : std::string();
}

}
