// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Hdf5Volume_h
#define TemporalCoherence_Hdf5Volume_h

#include "VolumeFiles/VolumeFile.h"

#include <memory>
#include <string>

namespace TemporalCoherence
{

/// Open a volume in an HDF5 file: of Imaris (.ims), of BigDataViewer (.h5), or any data set of
/// three dimensions in the order z, y, x. The file stays open as long as the volume lives.
///
/// Threads read one after the other, as HDF5 demands. Chunks that are compressed by deflate alone,
/// or by shuffle and deflate, are decompressed in parallel. Samples may be integers of 8 to 64
/// bits, or floating-point numbers of 16 (read as 32), 32 and 64 bits, in either byte order.
/// Volumes that lead to other files are refused.
///
/// Other users of HDF5 in the process, such as vtkHDFReader, do not wait for these threads. Only a
/// thread-safe build of HDF5 serves both at the same time.
///
/// \param choice a channel and a time point of Imaris; a setup and a time point of BigDataViewer;
///               or the name of a data set, in any file
/// \param error  receives what is wrong, in one sentence
/// \return null if the file or the choice cannot be read
/// \throws std::bad_alloc
std::unique_ptr<VolumeFile> OpenHdf5(
  const std::string& path, const VolumeChoice& choice, std::string& error);

}

#endif
