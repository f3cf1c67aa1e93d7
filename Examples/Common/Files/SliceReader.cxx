// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/SliceReader.h"

#include "Program/Quoted.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cstring>
#include <vector>

vtkStandardNewMacro(SliceReader);

void SliceReader::SetSlices(const SliceStack& slices, const PictureKind& first)
{
  this->Stack = slices;
  this->First = first;
  if (slices.Pages > 1)
  {
    this->SetFileName(slices.Files.front().c_str());
  }
  else // a slice each, as VTK takes it
  {
    vtkNew<vtkStringArray> names;
    for (const std::string& file : slices.Files)
    {
      names->InsertNextValue(file);
    }
    this->SetFileNames(names);
  }
  this->SetDataExtent(0, first.Width - 1, 0, first.Height - 1, 0, slices.Count() - 1);
  this->SetDataSpacing(first.Spacing[0], first.Spacing[1], first.Spacing[2]);
  this->SetDataScalarType(first.Type);
  this->SetNumberOfScalarComponents(1);
}

void SliceReader::ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* information)
{
  vtkImageData* const image = this->AllocateOutputData(output, information);
  image->GetPointData()->GetScalars()->SetName("slices");
  const int* const extent = image->GetExtent();
  const std::size_t ofRow = this->First.BytesOfRow();
  const std::size_t ofSample = ofRow / static_cast<std::size_t>(this->First.Width);
  const std::size_t ofPart = ofSample * static_cast<std::size_t>(extent[1] - extent[0] + 1);
  std::vector<unsigned char> whole(ofRow * static_cast<std::size_t>(this->First.Height));
  try
  {
    for (int slice = extent[4]; slice <= extent[5]; ++slice)
    {
      this->ReadSlice(slice, whole.data());
      for (int row = extent[2]; row <= extent[3]; ++row)
      {
        std::memcpy(image->GetScalarPointer(extent[0], row, slice),
          &whole[ofRow * static_cast<std::size_t>(row) +
            ofSample * static_cast<std::size_t>(extent[0])],
          ofPart);
      }
    }
  }
  catch (const UserError& failure)
  {
    this->Picture = nullptr;
    vtkErrorMacro(<< failure.what());
  }
}

// Pages of a file come one after the other.
void SliceReader::ReadSlice(int slice, unsigned char* to)
{
  const int file = slice / this->Stack.Pages, page = slice % this->Stack.Pages;
  const std::string& path = this->Stack.Files[static_cast<std::size_t>(file)];
  if (!this->Picture || file != this->File || page <= this->Page)
  {
    this->Picture = OpenPicture(path);
    this->File = file;
    this->Page = -1;
  }
  while (this->Page < page)
  {
    if (!this->Picture->Next())
    {
      throw UserError(Quoted(path) + " has fewer pictures than before; open it again.");
    }
    ++this->Page;
  }
  RequireLike(this->First, *this->Picture, path, this->Stack.Pages > 1 ? page + 1 : 0);
  this->Picture->Read(to);
}
