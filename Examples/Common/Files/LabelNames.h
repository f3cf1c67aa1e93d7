// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LabelNames_h
#define LabelNames_h

#include <array>
#include <optional>
#include <string>
#include <vector>

// What a file tells of a label.
struct LabelName
{
  int Label = 0;
  std::string Name;                           // printable
  std::optional<std::array<double, 3>> Color; // 0 to 1
  std::optional<double> Opacity;              // 0: it is hidden
};

// Read label descriptions of ITK-SNAP, colour tables of Slicer, or JSON: {"1": "liver"},
// {"liver": 1}, such an object under "labels", or a list of {"value", "name", "color"}. Throws
// UserError if it is none of these. With mayBeOther, {"liver": 1} is none: many other files look
// so.
std::vector<LabelName> ReadLabelNames(const std::string& path, bool mayBeOther = false);

// The file of names that lies beside a volume: of the same name, with .label, .ctbl, .txt or .json.
// Empty if there is none.
std::string LabelNamesBeside(const std::string& volume);

#endif
