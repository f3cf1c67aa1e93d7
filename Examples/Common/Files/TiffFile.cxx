// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/PictureFile.h"

#include "Files/FileCheck.h"
#include "Files/Reading.h"
#include "Program/Quoted.h"

#include <vtkType.h>
#include <vtk_tiff.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <vector>

namespace
{

// The type of samples; VTK_VOID if there is none of so many bits.
int TypeOf(unsigned bits, unsigned format)
{
  static const std::map<std::pair<unsigned, unsigned>, int> types = { { { 8, SAMPLEFORMAT_UINT },
                                                                        VTK_UNSIGNED_CHAR },
    { { 8, SAMPLEFORMAT_INT }, VTK_SIGNED_CHAR }, { { 16, SAMPLEFORMAT_UINT }, VTK_UNSIGNED_SHORT },
    { { 16, SAMPLEFORMAT_INT }, VTK_SHORT }, { { 32, SAMPLEFORMAT_UINT }, VTK_UNSIGNED_INT },
    { { 32, SAMPLEFORMAT_INT }, VTK_INT }, { { 64, SAMPLEFORMAT_UINT }, VTK_UNSIGNED_LONG_LONG },
    { { 64, SAMPLEFORMAT_INT }, VTK_LONG_LONG }, { { 32, SAMPLEFORMAT_IEEEFP }, VTK_FLOAT },
    { { 64, SAMPLEFORMAT_IEEEFP }, VTK_DOUBLE } };
  const auto found =
    types.find({ bits, format == SAMPLEFORMAT_VOID ? unsigned(SAMPLEFORMAT_UINT) : format });
  return found == types.end() ? VTK_VOID : found->second;
}

class TiffFile : public PictureFile
{
public:
  explicit TiffFile(const std::string& path)
    : Path(path)
  {
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
    this->File = TIFFOpen(path.c_str(), "rm"); // not mapped to memory: files change
    if (!this->File)
    {
      throw Unreadable(path);
    }
  }
  ~TiffFile() override { TIFFClose(this->File); }
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;

  bool Next() override
  {
    do
    {
      if (this->IsBegun && TIFFLastDirectory(this->File))
      {
        return false;
      }
      if (this->IsBegun && !TIFFReadDirectory(this->File))
      {
        throw Damaged(this->Path, "one of its pictures has no whole header");
      }
      this->IsBegun = true;
    } while (this->Whole(TIFFTAG_SUBFILETYPE) & FILETYPE_REDUCEDIMAGE); // of others, to look at
    this->ReadKind();
    return true;
  }

  void Read(unsigned char* to) override
  {
    const bool isRead = TIFFIsTiled(this->File) ? this->ReadTiles(to) : this->ReadRows(to);
    if (!isRead)
    {
      throw Damaged(this->Path, "its pictures end too early, or are broken");
    }
    const std::size_t row = this->Picture.BytesOfRow(),
                      rows = static_cast<std::size_t>(this->Picture.Height);
    if (this->Short(TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_MINISWHITE)
    {
      // Of whole numbers without a sign, the largest less a number is all its bits turned.
      std::transform(to, to + row * rows, to,
        [](unsigned char byte) { return static_cast<unsigned char>(~byte); });
    }
    for (std::size_t i = 0; this->Short(TIFFTAG_ORIENTATION) == ORIENTATION_BOTLEFT && 2 * i < rows;
         ++i)
    {
      std::swap_ranges(to + i * row, to + (i + 1) * row, to + (rows - 1 - i) * row);
    }
  }

private:
  UserError Refused(const std::string& what) const
  {
    return UserError(Quoted(this->Path) + " has " + what +
      ", which is not read here; save it as grey or RGB with 8, 16, 32 or 64 bits.");
  }

  std::uint32_t Whole(std::uint32_t tag) const
  {
    std::uint32_t value = 0;
    return TIFFGetField(this->File, tag, &value) ? value : 0;
  }

  std::uint16_t Short(std::uint32_t tag) const
  {
    std::uint16_t value = 0;
    return TIFFGetFieldDefaulted(this->File, tag, &value) ? value : std::uint16_t(0);
  }

  double Real(std::uint32_t tag) const
  {
    float value = 0.0F;
    return TIFFGetField(this->File, tag, &value) ? static_cast<double>(value) : 0.0;
  }

  // Of each picture of ImageJ: "ImageJ=1.53\nimages=20\nspacing=2.5\n". 0 where it has none.
  double ImageJ(const std::string& key) const
  {
    char* description = nullptr;
    if (!TIFFGetField(this->File, TIFFTAG_IMAGEDESCRIPTION, &description) || !description ||
      std::strncmp(description, "ImageJ=", 7) != 0)
    {
      return 0.0;
    }
    std::istringstream in(description);
    double number = 0.0;
    for (std::string line; std::getline(in, line);)
    {
      if (line.compare(0, key.size() + 1, key + "=") == 0)
      {
        std::istringstream(line.substr(key.size() + 1)) >> number;
      }
    }
    return number;
  }

  void ReadKind()
  {
    PictureKind& kind = this->Picture;
    kind = {};
    const std::uint32_t width = this->Whole(TIFFTAG_IMAGEWIDTH),
                        height = this->Whole(TIFFTAG_IMAGELENGTH);
    constexpr std::uint32_t Most = 1 << 20;
    if (width == 0 || height == 0 || width > Most || height > Most)
    {
      throw Damaged(this->Path,
        "it has a picture of " + std::to_string(width) + " x " + std::to_string(height));
    }
    const unsigned bits = this->Short(TIFFTAG_BITSPERSAMPLE),
                   format = this->Short(TIFFTAG_SAMPLEFORMAT),
                   components = this->Short(TIFFTAG_SAMPLESPERPIXEL),
                   photometric = this->Short(TIFFTAG_PHOTOMETRIC);
    kind.Width = static_cast<int>(width);
    kind.Height = static_cast<int>(height);
    kind.Components = static_cast<int>(components);
    kind.Type = TypeOf(bits, format);
    kind.IsOfPalette = photometric == PHOTOMETRIC_PALETTE;
    if (kind.Type == VTK_VOID)
    {
      throw this->Refused("samples of " + std::to_string(bits) + " bits" +
        (format == SAMPLEFORMAT_UINT ? "" : " with a format of samples of its own"));
    }
    if (photometric > PHOTOMETRIC_PALETTE ||
      (photometric == PHOTOMETRIC_MINISWHITE && format != SAMPLEFORMAT_UINT))
    {
      throw this->Refused("colours that are neither grey nor RGB");
    }
    if (components == 0 || components > 64 ||
      (components > 1 && this->Short(TIFFTAG_PLANARCONFIG) != PLANARCONFIG_CONTIG))
    {
      throw this->Refused("colours in planes");
    }
    if (!TIFFIsCODECConfigured(this->Short(TIFFTAG_COMPRESSION)))
    {
      throw this->Refused("a compression of its own");
    }
    if (this->ImageJ("images") > 1.0 && TIFFLastDirectory(this->File) &&
      TIFFCurrentDirectory(this->File) == 0)
    {
      throw this->Refused("pictures without headers, as ImageJ writes large files");
    }
    this->ReadSpacing();
  }

  void ReadSpacing()
  {
    const double x = this->Real(TIFFTAG_XRESOLUTION), y = this->Real(TIFFTAG_YRESOLUTION);
    constexpr double Least = 1e-6, Most = 1e9;
    if (!(x > Least && y > Least && x < Most && y < Most))
    {
      return;
    }
    const unsigned unit = this->Short(TIFFTAG_RESOLUTIONUNIT);
    const double distance = this->ImageJ("spacing");
    // In mm, or in the file's own unit, in which x and y may still differ.
    const double one = unit == RESUNIT_INCH ? 25.4 : unit == RESUNIT_CENTIMETER ? 10.0 : 1.0;
    this->Picture.Spacing = { one / x, one / y, one / x };
    if (distance > Least && distance < Most)
    {
      this->Picture.Spacing[2] = distance;
    }
  }

  bool ReadRows(unsigned char* to)
  {
    const std::size_t bytes = this->Picture.BytesOfRow();
    bool isRead = TIFFScanlineSize64(this->File) == bytes;
    for (int row = 0; row < this->Picture.Height && isRead; ++row)
    {
      isRead = TIFFReadScanline(this->File, to + static_cast<std::size_t>(row) * bytes,
                 static_cast<std::uint32_t>(row), 0) > 0;
    }
    return isRead;
  }

  bool ReadTiles(unsigned char* to)
  {
    const std::size_t row = this->Picture.BytesOfRow(),
                      pixel = row / static_cast<std::size_t>(this->Picture.Width);
    const std::uint32_t width = this->Whole(TIFFTAG_TILEWIDTH),
                        height = this->Whole(TIFFTAG_TILELENGTH);
    const auto columns = static_cast<std::uint32_t>(this->Picture.Width),
               rows = static_cast<std::uint32_t>(this->Picture.Height);
    const std::size_t size = pixel * width * height;
    if (size == 0 || TIFFTileSize64(this->File) != size)
    {
      return false;
    }
    RequireBytesFor(this->Path, static_cast<double>(size));
    std::vector<unsigned char> tile(size);
    for (std::uint32_t y = 0; y < rows; y += height)
    {
      for (std::uint32_t x = 0; x < columns; x += width)
      {
        if (TIFFReadTile(this->File, tile.data(), x, y, 0, 0) < 0)
        {
          return false;
        }
        const std::size_t length = pixel * std::min(width, columns - x);
        for (std::uint32_t j = 0; j < std::min(height, rows - y); ++j)
        {
          std::copy_n(tile.data() + j * pixel * width, length, to + (y + j) * row + x * pixel);
        }
      }
    }
    return true;
  }

  std::string Path;
  TIFF* File = nullptr;
  bool IsBegun = false;
};

}

std::unique_ptr<PictureFile> OpenTiff(const std::string& path)
{
  return std::make_unique<TiffFile>(path);
}
