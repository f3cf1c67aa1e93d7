// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ReaderVolume_h
#define TemporalCoherence_ReaderVolume_h

#include "VolumeFiles/VolumeFile.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Use a VTK reader of images as a volume. The volume holds the reader. Nobody else may use the
/// reader, or change it, while the volume lives. Threads read one after the other.
///
/// These readers read only the part of a volume that is asked for: vtkImageReader, vtkImageReader2,
/// vtkTIFFReader (series of files, and files of several pages, whose directories it reads anew for
/// each chunk), vtkPNGReader, vtkJPEGReader, vtkBMPReader, vtkPNMReader, vtkMRCReader,
/// vtkNIFTIImageReader (compressed files are decompressed from their begin for each chunk),
/// vtkMINCImageReader, vtkXMLImageDataReader, vtkHDFReader, vtkNetCDFReader and vtkNetCDFCFReader.
/// Other readers are believed if they set CAN_PRODUCE_SUB_EXTENT.
///
/// These readers read the whole volume at once: vtkMetaImageReader and vtkDICOMImageReader (which
/// write beyond the end of memory if asked for less), vtkNrrdReader, vtkSLCReader, vtkTGAReader,
/// vtkOMETIFFReader, readers of legacy files, and all others. Their output is kept as long as the
/// volume lives. Volumes of more than 1 GiB are refused.
///
/// The direction matrix of an image is not used.
///
/// \param arrayName name of an array of points; empty: the scalars, or the first array
/// \param error     receives what is wrong, in one sentence. Errors of the reader are part of it
///                  and are not shown elsewhere
/// \return null if the reader gives no image of one component
/// \throws std::bad_alloc
std::unique_ptr<VolumeFile> OpenReader(
  vtkAlgorithm* reader, const std::string& arrayName, std::string& error);

}

#endif
