// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ReaderErrors.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkXMLReader.h>

namespace TemporalCoherence
{

namespace
{

/// VTK's text is "ERROR: In file, line n\nclass (address): message\n\n".
std::string MessageIn(const std::string& text)
{
  std::size_t begin = text.find('\n');
  begin = begin == std::string::npos ? 0 : begin + 1;
  const std::size_t address = text.find(" (0x", begin);
  const std::size_t end = address == std::string::npos ? address : text.find("): ", address);
  std::string message = text.substr(end == std::string::npos ? begin : end + 3);
  while (!message.empty() && (message.back() == '\n' || message.back() == '.'))
  {
    message.pop_back();
  }
  for (char& character : message)
  {
    character = character == '\n' ? ' ' : character;
  }
  return message;
}

}

ReaderErrors::ReaderErrors(vtkAlgorithm* reader)
  : Reader(reader)
{
  this->Observer->SetCallback(ReaderErrors::Collect);
  this->Observer->SetClientData(this);
  reader->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  if (auto* const xml = vtkXMLReader::SafeDownCast(reader))
  {
    this->EarlierObserver = xml->GetParserErrorObserver();
    xml->SetParserErrorObserver(this->Observer);
  }
}

ReaderErrors::~ReaderErrors()
{
  this->Reader->RemoveObserver(this->Observer);
  this->Reader->GetExecutive()->RemoveObserver(this->Observer);
  if (auto* const xml = vtkXMLReader::SafeDownCast(this->Reader))
  {
    xml->SetParserErrorObserver(this->EarlierObserver);
  }
}

std::string ReaderErrors::Text() const
{
  if (!this->First.empty())
  {
    return this->First;
  }
  const unsigned long code = this->Reader->GetErrorCode();
  return code != vtkErrorCode::NoError ? vtkErrorCode::GetStringFromErrorCode(code) : "";
}

void ReaderErrors::Collect(vtkObject*, unsigned long, void* self, void* text)
{
  std::string& first = static_cast<ReaderErrors*>(self)->First;
  if (first.empty())
  {
    first = MessageIn(text ? static_cast<const char*>(text) : "");
    first = first.empty() ? "unknown error" : first;
  }
}

}
