// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Hdf5Library_h
#define TemporalCoherence_Hdf5Library_h

#include <hdf5.h>

#include <mutex>
#include <string>

namespace TemporalCoherence
{

/// Holds the right to call HDF5, whose C library is not thread-safe. HDF5 prints no errors
/// meanwhile.
class Hdf5Turn
{
public:
  Hdf5Turn();
  ~Hdf5Turn();
  Hdf5Turn(const Hdf5Turn&) = delete;
  Hdf5Turn& operator=(const Hdf5Turn&) = delete;

private:
  std::lock_guard<std::mutex> Lock;
  H5E_auto2_t Printer = nullptr;
  void* PrinterData = nullptr;
  bool IsSilenced = false;
};

/// Owns an identifier of HDF5. Its destructor calls HDF5, so it needs an Hdf5Turn.
class Hdf5Handle
{
public:
  using Closer = herr_t (*)(hid_t);

  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Closer close)
    : Id(id)
    , Close(close)
  {
  }
  ~Hdf5Handle() { this->Reset(); }
  Hdf5Handle(Hdf5Handle&& other) noexcept
    : Id(other.Id)
    , Close(other.Close)
  {
    other.Id = H5I_INVALID_HID;
  }
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept
  {
    std::swap(this->Id, other.Id);
    std::swap(this->Close, other.Close);
    return *this;
  }

  bool IsValid() const { return this->Id >= 0; }
  hid_t Get() const { return this->Id; }

  void Reset()
  {
    if (this->Id >= 0)
    {
      this->Close(this->Id);
    }
    this->Id = H5I_INVALID_HID;
  }

private:
  hid_t Id = H5I_INVALID_HID;
  Closer Close = nullptr;
};

/// An open HDF5 file. It does not follow links to other files. All members but Path need an
/// Hdf5Turn, the destructor included.
class Hdf5File
{
public:
  /// \param error receives why the file cannot be opened
  bool Open(const std::string& path, std::string& error);

  const std::string& Path() const { return this->Name; }

  /// True if a group or a data set has this name. Links to other files do not count.
  bool Has(const std::string& name) const;

  /// Open a group or a data set.
  /// \return an invalid handle if there is none
  Hdf5Handle OpenObject(const std::string& name) const;

  /// The properties to open objects with, so that links to other files are not followed.
  hid_t Access() const { return this->LinkAccess.Get(); }

  hid_t Id() const { return this->File.Get(); }

  /// "Data set 'name' of file 'path' ", the begin of messages.
  std::string DataSetText(const std::string& name) const;

  /// Why a data set or a group cannot be opened, in one sentence.
  std::string WhyNotOpened(const std::string& name) const;

private:
  std::string Name;
  Hdf5Handle File;
  Hdf5Handle LinkAccess;
};

}

#endif
