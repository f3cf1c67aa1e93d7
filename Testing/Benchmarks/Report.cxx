// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "Measuring.h"

#include <vtkSMPTools.h>
#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace
{

std::string Quoted(const std::string& text)
{
  std::string quoted = "\"";
  for (const char c : text)
  {
    if (c == '"' || c == '\\')
    {
      quoted += '\\';
    }
    quoted += c;
  }
  return quoted + '"';
}

}

std::string Fixed(double value, int digits)
{
  if (!std::isfinite(value))
  {
    return "-";
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string Plain(double value)
{
  std::ostringstream text;
  text << std::setprecision(7) << value;
  return text.str();
}

PagePart::PagePart(const std::string& name)
{
  std::cout << "<!-- made: " << name << " -->\n\n";
}

PagePart::~PagePart()
{
  std::cout << "\n<!-- end -->\n" << std::endl;
}

MarkdownTable::MarkdownTable(const std::vector<std::string>& head)
{
  this->Row(head);
  this->Row(std::vector<std::string>(head.size(), "---"));
}

void MarkdownTable::Row(const std::vector<std::string>& cells) const
{
  for (const std::string& cell : cells)
  {
    std::cout << "| " << cell << ' ';
  }
  std::cout << "|" << std::endl;
}

void JsonWriter::Begin(const std::string& name)
{
  if (!this->Ends.empty())
  {
    this->Text += this->IsFirst ? "\n" : ",\n";
    this->Text.append(2 * this->Ends.size(), ' ');
  }
  if (!name.empty())
  {
    this->Text += Quoted(name) + ": ";
  }
  this->IsFirst = false;
}

void JsonWriter::Open(const std::string& name, char open, char close)
{
  this->Begin(name);
  this->Text += open;
  this->Ends += close;
  this->IsFirst = true;
}

void JsonWriter::Close()
{
  const char end = this->Ends.back();
  this->Ends.pop_back();
  this->Text += '\n';
  this->Text.append(2 * this->Ends.size(), ' ');
  this->Text += end;
  this->IsFirst = false;
}

void JsonWriter::CloseTo(std::size_t depth)
{
  while (this->Ends.size() > depth)
  {
    this->Close();
  }
}

void JsonWriter::Add(const std::string& name, double value)
{
  this->Begin(name);
  this->Text += std::isfinite(value) ? Plain(value) : "null";
}

void JsonWriter::Add(const std::string& name, const std::string& value)
{
  this->Begin(name);
  this->Text += Quoted(value);
}

void JsonWriter::Add(const std::string& name, const std::vector<double>& values)
{
  this->OpenList(name);
  for (const double value : values)
  {
    this->Add("", value);
  }
  this->Close();
}

void JsonWriter::Write(const std::string& path) const
{
  JsonWriter whole = *this;
  while (!whole.Ends.empty())
  {
    whole.Close();
  }
  std::ofstream file(path);
  file << whole.Text << '\n';
  if (!file.flush())
  {
    throw Measuring::Failure(
      "Cannot write " + path + ": name a file in a folder that exists and has room.");
  }
}

void RequireFolder(const std::string& path)
{
  if (!vtksys::SystemTools::MakeDirectory(path))
  {
    throw Measuring::Failure(
      "Cannot make the folder " + path + ": name one that can be written in.");
  }
}

void AddMachine(JsonWriter& json, int size)
{
  json.Add("pixels", size);
  json.Add("threads", vtkSMPTools::GetEstimatedNumberOfThreads());
  json.Add("threadsBy", std::string(vtkSMPTools::GetBackend()));
}
