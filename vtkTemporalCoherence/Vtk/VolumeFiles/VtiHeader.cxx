// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/VtiHeader.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLParser.h>

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// VTK's parser, which calls StartElement() and EndElement(). vtkXMLDataParser would build a tree
/// of elements, whose depth a file could choose.
class HeaderParser : public vtkXMLParser
{
public:
  static HeaderParser* New();
  vtkTypeMacro(HeaderParser, vtkXMLParser);

  VtiHeader* Header = nullptr;

  HeaderParser(const HeaderParser&) = delete;
  void operator=(const HeaderParser&) = delete;

protected:
  HeaderParser() = default;
  ~HeaderParser() override = default;

  void StartElement(const char* name, const char** attributes) override
  {
    const std::string element = name;
    if (element == "VTKFile")
    {
      this->Header->File = XmlAttributes(attributes);
    }
    else if (element == "ImageData")
    {
      this->Header->Image = XmlAttributes(attributes);
    }
    else if (element == "Piece")
    {
      this->Header->Piece = XmlAttributes(attributes);
      ++this->Header->NumberOfPieces;
    }
    else if (element == "PointData")
    {
      this->Header->PointData = XmlAttributes(attributes);
      this->OnPoints = true;
    }
    else if (element == "DataArray" && this->OnPoints)
    {
      this->Header->Arrays.emplace_back(attributes);
    }
    else if (element == "AppendedData")
    {
      this->Header->Appended = XmlAttributes(attributes);
      this->Header->HasAppended = true;
    }
  }

  void EndElement(const char* name) override
  {
    if (std::string(name) == "PointData")
    {
      this->OnPoints = false;
    }
  }

  void CharacterDataHandler(const char* /*text*/, int /*length*/) override {}

  // The text ends before its last element does. OpenVti() tells of mistakes.
  void ReportXmlParseError() override {}

private:
  bool OnPoints = false;
};

vtkStandardNewMacro(HeaderParser);

/// The place behind the '>' of a tag that begins at `tag`; the text's size if it has none.
std::size_t EndOfTag(const std::string& text, std::size_t tag)
{
  char quote = 0;
  for (std::size_t i = tag; i < text.size(); ++i)
  {
    if (quote != 0)
    {
      quote = text[i] == quote ? char(0) : quote;
    }
    else if (text[i] == '"' || text[i] == '\'')
    {
      quote = text[i];
    }
    else if (text[i] == '>')
    {
      return i + 1;
    }
  }
  return text.size();
}

}

XmlAttributes::XmlAttributes(const char** pairs)
{
  for (; pairs && pairs[0] && pairs[1]; pairs += 2)
  {
    this->Values[pairs[0]] = pairs[1];
  }
}

std::string XmlAttributes::Get(const std::string& name, const std::string& fallback) const
{
  const auto found = this->Values.find(name);
  return found == this->Values.end() ? fallback : found->second;
}

bool ParseVti(const std::string& text, VtiHeader& header, std::size_t& data, std::string& what)
{
  const std::size_t tag = std::min(text.find("<AppendedData"), text.size());
  const std::size_t end = EndOfTag(text, tag);
  const std::string head = text.substr(0, end);
  // Entities, which only a document type can define, could make a short text very long.
  if (head.find("<!DOCTYPE") != std::string::npos)
  {
    what = "it defines a document type";
    return false;
  }
  vtkNew<HeaderParser> parser;
  parser->Header = &header;
  const bool isParsed = parser->InitializeParser() != 0 &&
    parser->ParseChunk(head.data(), static_cast<unsigned int>(head.size())) != 0;
  parser->CleanupParser();
  if (!isParsed)
  {
    what = "its beginning is no correct XML";
    return false;
  }
  const std::size_t mark = text.find_first_not_of(" \t\r\n", end);
  data = mark != std::string::npos && text[mark] == '_' ? mark + 1 : 0;
  return true;
}

}
