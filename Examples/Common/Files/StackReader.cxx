// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/StackReader.h"

#include "Files/FileCheck.h"
#include "Files/PictureFile.h"
#include "Files/StackFiles.h"
#include "Program/Quoted.h"

#include <vtkAbstractArray.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <filesystem>
#include <sstream>

namespace
{

// How many pictures a file has; all are looked at.
int PagesOf(const std::string& path)
{
  const std::unique_ptr<PictureFile> file = OpenPicture(path);
  int pages = 0;
  while (file->Next())
  {
    ++pages;
  }
  return pages;
}

class Stack
{
public:
  Stack(const std::string& path, const ReadingProgress& progress)
    : Path(path)
    , Progress(progress)
  {
  }

  // \param pages of each file
  vtkSmartPointer<vtkImageData> Read(const std::vector<std::string>& files, int pages)
  {
    this->Slices = static_cast<int>(files.size()) * pages;
    for (const std::string& file : files)
    {
      this->ReadFile(file, pages);
    }
    return this->Image;
  }

  PictureKind Kind;

private:
  void ReadFile(const std::string& file, int pages)
  {
    const std::unique_ptr<PictureFile> picture = OpenPicture(file);
    int page = 0;
    for (; picture->Next(); ++page, ++this->Done)
    {
      if (this->Progress && !this->Progress(static_cast<double>(this->Done) / this->Slices))
      {
        throw Stopped(this->Path);
      }
      if (this->Done == 0)
      {
        this->Begin(picture->Kind());
      }
      if (page == pages)
      {
        throw UserError(Quoted(file) +
          " has several pictures, a stack of its own, among files of one slice; open it alone, or "
          "move it elsewhere.");
      }
      RequireLike(this->Kind, *picture, file, pages > 1 ? page + 1 : 0);
      picture->Read(static_cast<unsigned char*>(this->Image->GetScalarPointer(0, 0, this->Done)));
    }
  }

  // What the first slice tells is expected of all.
  void Begin(const PictureKind& kind)
  {
    this->Kind = kind;
    RequireBytesFor(this->Path,
      static_cast<double>(kind.BytesOfRow()) * kind.Height * static_cast<double>(this->Slices));
    this->Image->SetDimensions(kind.Width, kind.Height, this->Slices);
    this->Image->SetSpacing(kind.Spacing.data());
    this->Image->AllocateScalars(kind.Type, kind.Components);
    this->Image->GetPointData()->GetScalars()->SetName("slices");
  }

  const std::string Path;
  const ReadingProgress& Progress;
  const vtkSmartPointer<vtkImageData> Image = vtkSmartPointer<vtkImageData>::New();
  int Slices = 0, Done = 0;
};

}

std::size_t PictureKind::BytesOfRow() const
{
  return static_cast<std::size_t>(this->Width) * static_cast<std::size_t>(this->Components) *
    static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(this->Type));
}

bool PictureKind::IsLike(const PictureKind& other) const
{
  return this->Width == other.Width && this->Height == other.Height &&
    this->Components == other.Components && this->Type == other.Type &&
    this->IsOfPalette == other.IsOfPalette;
}

std::string PictureKind::Text() const
{
  std::ostringstream text;
  text << this->Width << " x " << this->Height << ", "
       << (this->Components > 1 ? std::to_string(this->Components) + " x " : "")
       << vtkImageScalarTypeNameMacro(this->Type) << (this->IsOfPalette ? ", palette" : "");
  return text.str();
}

std::unique_ptr<PictureFile> OpenPicture(const std::string& path)
{
  return EndsWith(LowerCase(path), ".png") ? OpenPng(path) : OpenTiff(path);
}

void RequireLike(
  const PictureKind& before, const PictureFile& picture, const std::string& file, int page)
{
  if (!picture.Kind().IsLike(before))
  {
    throw UserError((page > 0 ? "Picture " + std::to_string(page) + " of " : "") + Quoted(file) +
      " is of another size or type (" + picture.Kind().Text() + ") than the slices before it (" +
      before.Text() + "); save them alike, or move it elsewhere.");
  }
}

SliceStack SlicesOf(const std::string& path)
{
  StackFiles stack = StackFilesOf(path);
  std::error_code error;
  const bool isFolder = std::filesystem::is_directory(path, error);
  SliceStack slices;
  if (!isFolder || stack.Paths.size() == 1)
  {
    // A file of several pictures is a volume, whatever is beside it.
    const std::string& file = isFolder ? stack.Paths.front() : path;
    slices.Pages = PagesOf(file);
    if (slices.Pages > 1)
    {
      stack = { { file }, "", 0.0, stack.Others };
    }
  }
  slices.Files = stack.Paths;
  if (slices.Count() < 2)
  {
    throw UserError(Quoted(path) +
      " is one slice without others: there are no pictures beside it whose names differ by a "
      "number; put the other slices there, as slice_001.tif, slice_002.tif and so on.");
  }
  if (!stack.Twin.empty())
  {
    throw UserError(Quoted(stack.Twin) +
      " has the number of another picture beside it; keep one picture of each number.");
  }
  const auto count = static_cast<double>(stack.Paths.size());
  std::ostringstream remark;
  remark.precision(15);
  if (stack.Missing > 0.0)
  {
    remark << stack.Missing << " of " << stack.Missing + count << " numbers are missing between "
           << Quoted(stack.Paths.front()) << " and " << Quoted(stack.Paths.back())
           << ": the slices are stacked without a gap.";
  }
  else if (stack.Others > 0)
  {
    remark << stack.Others << " of " << stack.Others + stack.Paths.size() << " pictures in "
           << Quoted(path)
           << " are left out: their names differ from those of the stack by more than a number.";
  }
  slices.Remark = remark.str();
  return slices;
}

void ReadStack(const std::string& path, const ReadingProgress& progress, Volume& volume)
{
  const SliceStack slices = SlicesOf(path);
  Stack reader(path, progress);
  volume.Data = reader.Read(slices.Files, slices.Pages);
  volume.Remark = slices.Remark;
  if (volume.Remark.empty() && reader.Kind.IsOfPalette)
  {
    volume.Remark = "The slices of " + Quoted(path) +
      " have colours from a table: the numbers of the colours are drawn.";
  }
}
