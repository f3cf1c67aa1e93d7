// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/Hdf5Library.h"

namespace TemporalCoherence
{

namespace
{

std::mutex Mutex;

/// True if the last object was not opened because a link leads out of its file.
thread_local bool MetExternalLink = false;

/// HDF5 calls this before it follows a link to another file.
herr_t RefuseExternalLink(
  const char*, const char*, const char*, const char*, unsigned*, hid_t, void*)
{
  MetExternalLink = true;
  return -1;
}

herr_t CloseObject(hid_t id)
{
  return H5Oclose(id);
}

}

Hdf5Turn::Hdf5Turn()
  : Lock(Mutex)
{
  unsigned isNew = 0;
  // A process that set a printer by the old interface keeps it.
  if (H5Eauto_is_v2(H5E_DEFAULT, &isNew) >= 0 && isNew &&
    H5Eget_auto2(H5E_DEFAULT, &this->Printer, &this->PrinterData) >= 0)
  {
    this->IsSilenced = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  }
}

Hdf5Turn::~Hdf5Turn()
{
  if (this->IsSilenced)
  {
    H5Eset_auto2(H5E_DEFAULT, this->Printer, this->PrinterData);
  }
}

bool Hdf5File::Open(const std::string& path, std::string& error)
{
  this->Name = path;
  this->File = Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  this->LinkAccess = Hdf5Handle(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
  // Chunks are read once and kept by others: no cache of HDF5 is needed.
  if (!this->File.IsValid() || !this->LinkAccess.IsValid() ||
    H5Pset_elink_cb(this->LinkAccess.Get(), RefuseExternalLink, nullptr) < 0 ||
    H5Pset_chunk_cache(this->LinkAccess.Get(), 0, 0, 1.0) < 0)
  {
    error = "File '" + path +
      "' cannot be opened as HDF5; check that it exists, is complete and is not open for writing.";
    return false;
  }
  return true;
}

Hdf5Handle Hdf5File::OpenObject(const std::string& name) const
{
  MetExternalLink = false;
  return Hdf5Handle(H5Oopen(this->File.Get(), name.c_str(), this->LinkAccess.Get()), CloseObject);
}

bool Hdf5File::Has(const std::string& name) const
{
  return this->OpenObject(name).IsValid();
}

std::string Hdf5File::DataSetText(const std::string& name) const
{
  return "Data set '" + name + "' of file '" + this->Name + "' ";
}

std::string Hdf5File::WhyNotOpened(const std::string& name) const
{
  return this->DataSetText(name) +
    (MetExternalLink
        ? "lies in another file, which is not followed; copy the data set into this file."
        : "is missing or cannot be opened; choose another one, or write the file again.");
}

}
