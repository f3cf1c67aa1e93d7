// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/WholeCheck.h"

#include "Files/FileCheck.h"

#include <algorithm>
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

  // Bytes that the file must have. A variable that has records is told of by the first of them: the
  // others follow, each behind those of all such variables.
  double BytesNeeded()
  {
    const double none = this->Version == 5 ? 18446744073709551615.0 : 4294967295.0;
    const double count = this->Count(), records = count == none ? 0.0 : count;
    double dimensionOfRecords = none, bytesOfRecord = 0.0, end = 0.0, endOfRecord = 0.0;
    this->ForEachListed([&](double dimension)
      { dimensionOfRecords = this->Count() == 0.0 ? dimension : dimensionOfRecords; });
    this->SkipAttributes();
    this->ForEachListed(
      [&](double) // variable
      {
        bool hasRecords = false;
        for (double left = this->Count(); left > 0.0 && this->File; --left)
        {
          hasRecords = this->Count() == dimensionOfRecords || hasRecords;
        }
        this->SkipAttributes();
        this->Number(4); // type
        const double bytes = this->Count(), begin = this->Number(this->Version == 1 ? 4 : 8);
        bytesOfRecord += hasRecords ? bytes : 0.0;
        double& last = hasRecords ? endOfRecord : end;
        last = std::max(last, begin + bytes);
      });
    return std::max(end, records > 0.0 ? endOfRecord + (records - 1.0) * bytesOfRecord : 0.0);
  }

private:
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

  // Calls a function where the name of each thing in a list has been read.
  template <typename Function>
  void ForEachListed(Function visit)
  {
    this->Number(4); // the kind of what is listed
    for (double i = 0.0, count = this->Count(); i < count && this->File; ++i)
    {
      this->Skip(this->Count());
      visit(i);
    }
  }

  void SkipAttributes()
  {
    constexpr double Bytes[] = { 0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 }; // by type
    this->ForEachListed(
      [&](double)
      {
        const double type = this->Number(4), count = this->Count();
        this->Skip(type < 12.0 ? count * Bytes[static_cast<int>(type)] : 0.0);
      });
  }

  // All is filled up to 4 bytes.
  void Skip(double bytes)
  {
    this->File.seekg(4 * (static_cast<std::streamoff>(bytes + 3.0) / 4), std::ios::cur);
  }

  std::ifstream File;
  int Version = 0;
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
