// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef WholeCheck_h
#define WholeCheck_h

#include <map>
#include <string>
#include <vector>

class vtkMetaImageReader;

// Some of VTK's readers draw what is missing in a file as zeros or as what memory held before,
// without a word. These functions throw UserError for files that are cut short, and leave what the
// readers refuse to them.

// An XML file and those it names have their ends, pieces cover the extent, and blocks of an
// adaptive grid are numbered and have the size of their boxes.
void RequireWholeXml(const std::string& path);

// Whether a file is one of VTK's XML, by its name.
bool IsXmlName(const std::string& path);

// The files that such a file names as its parts, in their order.
std::vector<std::string> PartsOf(const std::string& path);

// An Exodus file in netCDF's classic format is as long as its header says.
void RequireWholeNetcdf(const std::string& path);

// A MetaImage has, or names, as many samples as its header tells of. Returns a sentence if there
// are more, or if that cannot be known; empty if not.
// \param reader whose information is up to date
std::string RequireWholeMetaImage(
  vtkMetaImageReader* reader, std::map<std::string, std::string> fields);

#endif
