// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ReaderFiles_h
#define TemporalCoherence_ReaderFiles_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The names of the files that a reader was told to read, as far as it tells. Files that are named
/// in a header file are not among them.
/// \pre the reader's information is up to date
std::vector<std::string> FilesOf(vtkAlgorithm* reader);

/// Check that the files of images are there, and that those of uncompressed samples are long
/// enough. Readers do not report all such mistakes: vtkTIFFReader leaves slices without a file
/// undefined. \param extent the whole extent \param error  receives the name of a file that is
/// missing or too short
bool CheckFiles(vtkAlgorithm* reader, const int extent[6], std::string& error);

/// Check that files of slices can be opened, if the reader leaves the samples of others undefined
/// without an error, as vtkTIFFReader does.
/// \param error receives the name of a file that cannot be opened
bool CheckSlices(vtkAlgorithm* reader, int first, int last, std::string& error);

}

#endif
