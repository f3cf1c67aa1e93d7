// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Report_h
#define Benchmarks_Report_h

#include <string>
#include <vector>

/// A number with so many digits behind the point; "-" if it is none.
std::string Fixed(double value, int digits);

/// A number in as few digits as show it, such as an isovalue.
std::string Plain(double value);

/// A table in Markdown, printed line by line as it is measured.
class MarkdownTable
{
public:
  /// Print the head.
  explicit MarkdownTable(const std::vector<std::string>& head);
  void Row(const std::vector<std::string>& cells) const;
};

/// A part of a page that a program has made: what is printed while it is there stands between two
/// comments, and takes the place of the part of that name in the page (Documentation/gallery.sh).
class PagePart
{
public:
  explicit PagePart(const std::string& name);
  ~PagePart();
  PagePart(const PagePart&) = delete;
  PagePart& operator=(const PagePart&) = delete;
};

/// JSON text, written from front to end. Names are needed in objects and left out in lists.
class JsonWriter
{
public:
  JsonWriter() { this->OpenObject(); }

  void OpenObject(const std::string& name = {}) { this->Open(name, '{', '}'); }
  void OpenList(const std::string& name = {}) { this->Open(name, '[', ']'); }
  void Close();

  /// Brackets that are open, and closing all that were opened since there were so many.
  std::size_t Depth() const { return this->Ends.size(); }
  void CloseTo(std::size_t depth);

  void Add(const std::string& name, double value);
  void Add(const std::string& name, const std::string& value);
  void Add(const std::string& name, const std::vector<double>& values);

  /// Write the file, with what is open closed there. The text can go on afterwards.
  /// \throws Measuring::Failure if the file cannot be written
  void Write(const std::string& path) const;

private:
  void Open(const std::string& name, char open, char close);
  void Begin(const std::string& name);

  std::string Text;
  std::string Ends; ///< closing brackets of what is open, innermost last
  bool IsFirst = true;
};

/// Make a folder that something is to be written into.
/// \throws Measuring::Failure if it cannot be made
void RequireFolder(const std::string& path);

/// Begin a report: picture size and threads, which all figures depend on.
void AddMachine(JsonWriter& json, int size);

#endif
