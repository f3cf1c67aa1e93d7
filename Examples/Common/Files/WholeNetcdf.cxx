// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/WholeCheck.h"

#include "Files/FileCheck.h"

#include <algorithm>
#include <cstdint>
#include <fstream>

namespace
{

// The header of a file of netCDF's classic formats, CDF-1, CDF-2 and CDF-5: "NetCDF Classic Format
// Specification", Unidata. Reads of what is not there give zeros.
class Header
{
public:
  explicit Header(const std::string& path)
    : File(path, std::ios::binary)
  {
    char magic[4] = {};
    this->File.read(magic, 4);
    this->Version = std::string(magic, 3) == "CDF" ? magic[3] : 0;
  }

  bool IsClassic() const { return this->Version == 1 || this->Version == 2 || this->Version == 5; }

  // Bytes that the file must have.
  double BytesNeeded()
  {
    double records = this->Count();
    const double unknown = this->Version == 5 ? 18446744073709551615.0 : 4294967295.0;
    records = records == unknown ? 0.0 : records;
    this->ReadDimensions();
    this->SkipAttributes();
    std::vector<Variable> ofRecords;
    double end = 0.0, record = 0.0;
    for (double left = this->ListSize(); left > 0.0 && this->File; --left)
    {
      const Variable variable = this->ReadVariable();
      if (!variable.HasRecords)
      {
        end = std::max(end, variable.Begin + variable.Bytes);
        continue;
      }
      record += Padded(variable.Bytes);
      ofRecords.push_back(variable);
    }
    // Of one variable records are not padded.
    record = ofRecords.size() == 1 ? ofRecords[0].Bytes : record;
    for (const Variable& variable : ofRecords)
    {
      end = std::max(
        end, records > 0.0 ? variable.Begin + (records - 1.0) * record + variable.Bytes : 0.0);
    }
    return end;
  }

private:
  struct Variable
  {
    double Begin = 0.0, Bytes = 0.0; // Bytes: of a record, if it has such
    bool HasRecords = false;
  };

  static double Padded(double bytes)
  {
    return 4.0 * static_cast<double>(std::int64_t(bytes + 3) / 4);
  }

  double Number(int bytes)
  {
    double number = 0.0;
    for (int i = 0; i < bytes; ++i)
    {
      number = 256.0 * number + std::max(this->File.get(), 0);
    }
    return number;
  }
  double Count() { return this->Number(this->Version == 5 ? 8 : 4); }
  double ListSize()
  {
    this->Number(4); // the kind of what is listed
    return this->Count();
  }
  void Skip(double bytes) { this->File.seekg(std::streamoff(Padded(bytes)), std::ios::cur); }

  static double BytesOfType(double type)
  {
    constexpr double Bytes[] = { 0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 };
    return type < 12.0 ? Bytes[static_cast<int>(type)] : 0.0;
  }

  void ReadDimensions()
  {
    for (double left = this->ListSize(); left > 0.0 && this->File; --left)
    {
      this->Skip(this->Count());
      this->Dimensions.push_back(this->Count());
    }
  }

  void SkipAttributes()
  {
    for (double left = this->ListSize(); left > 0.0 && this->File; --left)
    {
      this->Skip(this->Count());
      const double type = this->Number(4);
      this->Skip(this->Count() * BytesOfType(type));
    }
  }

  Variable ReadVariable()
  {
    Variable variable;
    this->Skip(this->Count());
    double values = 1.0;
    for (double left = this->Count(); left > 0.0 && this->File; --left)
    {
      const auto i = static_cast<std::size_t>(this->Count());
      const double size = i < this->Dimensions.size() ? this->Dimensions[i] : 1.0;
      variable.HasRecords = variable.HasRecords || size == 0.0;
      values *= size == 0.0 ? 1.0 : size;
    }
    this->SkipAttributes();
    variable.Bytes = values * BytesOfType(this->Number(4));
    this->Count(); // bytes, which are wrong for large variables
    variable.Begin = this->Number(this->Version == 1 ? 4 : 8);
    return variable;
  }

  std::ifstream File;
  int Version = 0;
  std::vector<double> Dimensions;
};

}

void RequireWholeNetcdf(const std::string& path)
{
  Header header(path);
  if (header.IsClassic() && header.BytesNeeded() > static_cast<double>(SizeOf(path)))
  {
    throw Damaged(path, "it ends before its header says");
  }
}
