// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef WholeCheck_h
#define WholeCheck_h

#include <map>
#include <string>
#include <vector>

// Some of VTK's readers draw what is missing in a file as zeros or as what memory held before,
// without a word. These functions throw UserError for such files, and leave those to the readers
// that they refuse themselves.

// An XML file and those it names: arrays end where their headers say, pieces cover the extent, and
// blocks of an adaptive grid have the size of their boxes.
void RequireWholeXml(const std::string& path);

// Whether a file is one of VTK's XML, by its name.
bool IsXmlName(const std::string& path);

// The files that such a file names as its parts, in their order.
std::vector<std::string> PartsOf(const std::string& path);

// An Exodus file in netCDF's classic format is as long as its header says.
void RequireWholeNetcdf(const std::string& path);

// The fields of a MetaImage do not contradict each other, and there are samples for all of them.
// Returns a sentence if there are more than that; empty if not.
std::string RequireWholeMetaImage(
  const std::string& path, std::map<std::string, std::string> fields);

#endif
