// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VtiHeader_h
#define TemporalCoherence_VtiHeader_h

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// The attributes of an element of XML.
class XmlAttributes
{
public:
  XmlAttributes() = default;

  /// \param pairs names and values in turn, then null; as the parser gives them
  explicit XmlAttributes(const char** pairs);

  bool Has(const std::string& name) const { return this->Values.count(name) > 0; }

  /// The value of an attribute; a default where the element has none.
  std::string Get(const std::string& name, const std::string& fallback = {}) const;

private:
  std::map<std::string, std::string> Values;
};

/// What the XML of a .vti file tells. Only what OpenVti() needs.
struct VtiHeader
{
  XmlAttributes File;      ///< of the element VTKFile
  XmlAttributes Image;     ///< ImageData
  XmlAttributes Piece;     ///< the last one
  XmlAttributes PointData; ///< of the last piece
  XmlAttributes Appended;  ///< AppendedData
  int NumberOfPieces = 0;
  bool HasAppended = false;
  std::vector<XmlAttributes> Arrays; ///< on points
};

/// Parse the XML of a file, up to its appended data.
/// \param text the beginning of the file
/// \param data receives the place of the first byte of appended data; 0 if the text does not reach
///             it, or there is none
/// \return false if the text is no XML; tells why in `what`
bool ParseVti(const std::string& text, VtiHeader& header, std::size_t& data, std::string& what);

}

#endif
