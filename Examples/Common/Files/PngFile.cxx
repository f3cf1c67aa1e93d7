// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/PictureFile.h"

#include "Files/FileCheck.h"
#include "Files/Reading.h"

#include <vtkByteSwap.h>
#include <vtkType.h>
#include <vtk_png.h>

#include <csetjmp>
#include <cstdio>
#include <vector>

namespace
{

void OnError(png_structp png, png_const_charp)
{
  png_longjmp(png, 1);
}

void OnWarning(png_structp, png_const_charp) {}

// libpng jumps back to where setjmp was called: functions that do so have nothing to destroy.
class PngFile : public PictureFile
{
public:
  explicit PngFile(const std::string& path)
    : Path(path)
    , File(std::fopen(path.c_str(), "rb"))
    , Png(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, OnError, OnWarning))
    , Info(this->Png ? png_create_info_struct(this->Png) : nullptr)
  {
    if (!this->File || !this->Info || !this->ReadHeader())
    {
      this->Close(); // the destructor is not called
      throw Unreadable(path);
    }
  }
  ~PngFile() override { this->Close(); }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  bool Next() override
  {
    const bool isFirst = !this->IsBegun;
    this->IsBegun = true;
    return isFirst;
  }

  void Read(unsigned char* to) override
  {
    std::vector<png_bytep> rows;
    for (int row = 0; row < this->Picture.Height; ++row)
    {
      rows.push_back(to + static_cast<std::size_t>(row) * this->Picture.BytesOfRow());
    }
    if (!this->ReadRows(rows.data()))
    {
      throw Damaged(this->Path, "it ends too early, or is broken");
    }
    if (this->Picture.Type == VTK_UNSIGNED_SHORT)
    {
      const std::size_t bytes =
        this->Picture.BytesOfRow() * static_cast<std::size_t>(this->Picture.Height);
      vtkByteSwap::Swap2BERange(to, bytes / 2);
    }
  }

private:
  bool ReadHeader()
  {
    if (setjmp(png_jmpbuf(this->Png)))
    {
      return false;
    }
    png_init_io(this->Png, this->File);
    png_read_info(this->Png, this->Info);
    png_set_interlace_handling(this->Png);
    const int bits = png_get_bit_depth(this->Png, this->Info);
    const int color = png_get_color_type(this->Png, this->Info);
    if (color == PNG_COLOR_TYPE_GRAY && bits < 8)
    {
      png_set_expand_gray_1_2_4_to_8(this->Png);
    }
    png_set_packing(this->Png); // a byte for each number of a colour
    png_read_update_info(this->Png, this->Info);
    this->Picture.Width = static_cast<int>(png_get_image_width(this->Png, this->Info));
    this->Picture.Height = static_cast<int>(png_get_image_height(this->Png, this->Info));
    this->Picture.Components = png_get_channels(this->Png, this->Info);
    this->Picture.Type = bits > 8 ? VTK_UNSIGNED_SHORT : VTK_UNSIGNED_CHAR;
    this->Picture.IsOfPalette = color == PNG_COLOR_TYPE_PALETTE;
    return png_get_rowbytes(this->Png, this->Info) == this->Picture.BytesOfRow();
  }

  bool ReadRows(png_bytepp rows)
  {
    if (setjmp(png_jmpbuf(this->Png)))
    {
      return false;
    }
    png_read_image(this->Png, rows);
    png_read_end(this->Png, nullptr);
    return true;
  }

  void Close()
  {
    png_destroy_read_struct(&this->Png, &this->Info, nullptr);
    if (this->File)
    {
      std::fclose(this->File);
    }
  }

  std::string Path;
  std::FILE* File;
  png_structp Png;
  png_infop Info;
  bool IsBegun = false;
};

}

std::unique_ptr<PictureFile> OpenPng(const std::string& path)
{
  return std::make_unique<PngFile>(path);
}
