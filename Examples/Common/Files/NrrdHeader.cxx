// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/NrrdHeader.h"

#include "Files/FileCheck.h"
#include "Files/Reading.h"
#include "Program/Quoted.h"

#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>

namespace
{

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr std::uintmax_t MostNrrdHeader = 1 << 20; // bytes
constexpr std::size_t MostFiles = 10000;
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

const std::map<std::string, int>& Types()
{
  static const std::map<std::string, int> types = { { "signed char", VTK_SIGNED_CHAR },
    { "int8", VTK_SIGNED_CHAR }, { "int8_t", VTK_SIGNED_CHAR }, { "uchar", VTK_UNSIGNED_CHAR },
    { "unsigned char", VTK_UNSIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "uint8_t", VTK_UNSIGNED_CHAR }, { "short", VTK_SHORT }, { "short int", VTK_SHORT },
    { "signed short", VTK_SHORT }, { "signed short int", VTK_SHORT }, { "int16", VTK_SHORT },
    { "int16_t", VTK_SHORT }, { "ushort", VTK_UNSIGNED_SHORT },
    { "unsigned short", VTK_UNSIGNED_SHORT }, { "unsigned short int", VTK_UNSIGNED_SHORT },
    { "uint16", VTK_UNSIGNED_SHORT }, { "uint16_t", VTK_UNSIGNED_SHORT }, { "int", VTK_INT },
    { "signed int", VTK_INT }, { "int32", VTK_INT }, { "int32_t", VTK_INT },
    { "uint", VTK_UNSIGNED_INT }, { "unsigned int", VTK_UNSIGNED_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "uint32_t", VTK_UNSIGNED_INT }, { "longlong", VTK_LONG_LONG },
    { "long long", VTK_LONG_LONG }, { "long long int", VTK_LONG_LONG },
    { "signed long long", VTK_LONG_LONG }, { "signed long long int", VTK_LONG_LONG },
    { "int64", VTK_LONG_LONG }, { "int64_t", VTK_LONG_LONG },
    { "ulonglong", VTK_UNSIGNED_LONG_LONG }, { "unsigned long long", VTK_UNSIGNED_LONG_LONG },
    { "unsigned long long int", VTK_UNSIGNED_LONG_LONG }, { "uint64", VTK_UNSIGNED_LONG_LONG },
    { "uint64_t", VTK_UNSIGNED_LONG_LONG }, { "float", VTK_FLOAT }, { "double", VTK_DOUBLE } };
  return types;
}

std::string Trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r");
  return begin == std::string::npos
    ? ""
    : text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

Words WordsOf(const std::string& text)
{
  std::istringstream in(text);
  return Words(std::istream_iterator<std::string>(in), {});
}

double NumberOf(const std::string& word)
{
  std::istringstream in(word);
  double number = 0.0;
  return in >> number && (in >> std::ws).eof() ? number : NotANumber;
}

// Axes of the file, the fastest first.
struct Axis
{
  int Size = 0;
  std::string Kind;
  double Spacing = 1.0; // no number where the axis is none of space
  bool HasDirection = false;
  vtkVector3d Direction = { 0.0, 0.0, 0.0 };
};

class Parser
{
public:
  explicit Parser(const std::string& path)
    : Path(path)
  {
  }

  NrrdHeader Parse()
  {
    this->ReadFields();
    this->SetFormat();
    this->SetAxes();
    this->Assign();
    this->SetSpace();
    if (const std::string list = this->Field("data file"); !list.empty())
    {
      this->SetFiles(list);
    }
    return this->Header;
  }

private:
  UserError Refused(const std::string& what) const { return UserError(Quoted(this->Path) + what); }

  // Empty where there is none.
  std::string Field(const std::string& name)
  {
    std::string joined = name;
    joined.erase(std::remove(joined.begin(), joined.end(), ' '), joined.end());
    return this->Fields.count(name) ? this->Fields[name] : this->Fields[joined];
  }

  int Whole(const std::string& name, const std::string& word, int least, double most) const
  {
    const double number = NumberOf(word);
    if (!(number >= least && number <= most) || std::floor(number) != number)
    {
      throw Damaged(this->Path, "it has " + Quoted(word) + " as " + name);
    }
    return static_cast<int>(number);
  }

  void ReadFields()
  {
    const std::string text = BytesOf(this->Path, MostNrrdHeader);
    if (text.compare(0, 4, "NRRD") != 0)
    {
      throw Unreadable(this->Path);
    }
    bool hasEnd = false, isList = false;
    std::size_t at = 0;
    while (!hasEnd && at < text.size())
    {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      const std::string line = Trimmed(text.substr(at, end - at));
      at = end + 1;
      hasEnd = line.empty();
      const std::size_t colon = line.find(": ");
      if (isList && !hasEnd)
      {
        this->Listed.push_back(line);
      }
      else if (line.compare(0, 1, "#") != 0 && colon < line.find(":="))
      {
        const std::string name = LowerCase(line.substr(0, colon));
        this->Fields[name] = Trimmed(line.substr(colon + 2));
        isList = (name == "data file" || name == "datafile") &&
          this->Fields[name].compare(0, 4, "LIST") == 0;
      }
    }
    this->Header.Size = std::min(at, text.size());
    if (this->Field("data file").empty() && !hasEnd)
    {
      throw Damaged(this->Path, "its header has no end");
    }
  }

  void SetFormat()
  {
    const std::string type = this->Field("type");
    if (Types().count(type) == 0)
    {
      throw this->Refused(" has samples of the type " + Quoted(type) +
        ", which is not read here; save them as short, int, float or double.");
    }
    this->Header.Type = Types().at(type);
    static const std::map<std::string, NrrdHeader::Encodings> encodings = {
      { "raw", NrrdHeader::Raw }, { "gzip", NrrdHeader::Gzip }, { "gz", NrrdHeader::Gzip },
      { "text", NrrdHeader::Text }, { "txt", NrrdHeader::Text }, { "ascii", NrrdHeader::Text }
    };
    const std::string encoding = LowerCase(this->Field("encoding"));
    if (encodings.count(encoding) == 0)
    {
      throw this->Refused(" has the encoding " + Quoted(encoding) +
        ", which is not read here; save it with the encoding raw, gzip or text.");
    }
    this->Header.Encoding = encodings.at(encoding);
    const std::string endian = LowerCase(this->Field("endian"));
    const bool isOfBytes =
      this->Header.Type == VTK_SIGNED_CHAR || this->Header.Type == VTK_UNSIGNED_CHAR;
    if (endian != "little" && endian != "big" &&
      !(endian.empty() && (isOfBytes || this->Header.Encoding == NrrdHeader::Text)))
    {
      throw this->Refused(" does not say in which order the bytes of a sample are; add \"endian: "
                          "little\" or \"endian: big\" to its header.");
    }
    this->Header.IsBigEndian = endian == "big";
    if (const std::string lines = this->Field("line skip"); !lines.empty() && lines != "0")
    {
      throw this->Refused(" skips lines of its samples, which is not read here; save it without "
                          "\"line skip\".");
    }
    if (const std::string bytes = this->Field("byte skip"); !bytes.empty())
    {
      const bool isRaw = this->Header.Encoding == NrrdHeader::Raw;
      this->Header.Skip = this->Whole("byte skip", bytes, isRaw ? -1 : 0, VTK_INT_MAX);
    }
  }

  // A word for each axis, or none.
  Words OfAxes(const std::string& name)
  {
    const Words words = WordsOf(this->Field(name));
    if (!words.empty() && words.size() != this->Axes.size())
    {
      throw Damaged(this->Path,
        "it has " + std::to_string(words.size()) + " " + name + " of " +
          std::to_string(this->Axes.size()) + " axes");
    }
    return words;
  }

  void SetAxes()
  {
    constexpr double MostAxes = 16;
    const int count = this->Whole("dimension", this->Field("dimension"), 1, MostAxes);
    this->Axes.resize(static_cast<std::size_t>(count));
    const Words sizes = this->OfAxes("sizes"), kinds = this->OfAxes("kinds"),
                spacings = this->OfAxes("spacings");
    if (sizes.empty())
    {
      throw Damaged(this->Path, "it has no sizes");
    }
    for (std::size_t i = 0; i < this->Axes.size(); ++i)
    {
      Axis& axis = this->Axes[i];
      axis.Size = this->Whole("one of its sizes", sizes[i], 1, VTK_INT_MAX);
      axis.Kind = kinds.empty() ? "" : LowerCase(kinds[i]);
      axis.Spacing = spacings.empty() ? 1.0 : NumberOf(spacings[i]);
    }
    if (const std::string directions = this->Field("space directions"); !directions.empty())
    {
      this->SetDirections(directions);
    }
  }

  vtkVector3d Vector(const std::string& text) const
  {
    std::string words = text;
    std::replace(words.begin(), words.end(), ',', ' ');
    const Words numbers = WordsOf(words);
    vtkVector3d vector(0.0, 0.0, 0.0);
    for (std::size_t i = 0; i < 3 && numbers.size() == 3; ++i)
    {
      vector[static_cast<int>(i)] = NumberOf(numbers[i]);
    }
    if (numbers.size() != 3 || !std::isfinite(vector.Norm()))
    {
      throw Damaged(this->Path, "it has " + Quoted("(" + text + ")") + " as a place in space");
    }
    return vector;
  }

  // "none (1,0,0) (0,1,0) (0,0,1)"
  void SetDirections(const std::string& text)
  {
    std::size_t axis = 0;
    for (std::size_t at = text.find_first_not_of(' '); at < text.size();
         at = text.find_first_not_of(' ', at), ++axis)
    {
      const bool isVector = text[at] == '(';
      const std::size_t end = std::min(text.find(isVector ? ')' : ' ', at), text.size());
      if (axis < this->Axes.size() && isVector)
      {
        this->Axes[axis].HasDirection = true;
        this->Axes[axis].Direction = this->Vector(text.substr(at + 1, end - at - 1));
      }
      at = std::min(end + 1, text.size());
    }
    if (axis != this->Axes.size())
    {
      throw Damaged(this->Path, "it has not a space direction for each axis");
    }
    for (Axis& one : this->Axes)
    {
      one.Spacing = one.HasDirection ? 1.0 : NotANumber;
    }
  }

  static bool IsOfSpace(const Axis& axis)
  {
    return std::isfinite(axis.Spacing) &&
      (axis.HasDirection || axis.Kind.empty() || axis.Kind == "domain" || axis.Kind == "space" ||
        axis.Kind == "???" || axis.Kind == "none");
  }

  static bool IsOfTime(const Axis& axis) { return axis.Kind == "time" || axis.Kind == "list"; }

  // Three axes are of space. One before them has what belongs to a sample, or its time steps; one
  // behind them has volumes.
  void Assign()
  {
    constexpr int MostColors = 4;
    std::vector<Axis>& axes = this->Axes;
    auto ofSpace = std::find_if(axes.begin(), axes.end(), IsOfSpace);
    if (axes.size() == 4 && std::all_of(axes.begin(), axes.end(), IsOfSpace))
    {
      // The header does not tell. Colours come first.
      ofSpace += axes.front().Size <= MostColors ? 1 : 0;
    }
    const auto before = ofSpace - axes.begin(), behind = axes.end() - ofSpace - 3;
    if (behind < 0 || !std::all_of(ofSpace, ofSpace + 3, IsOfSpace))
    {
      throw this->Refused(" has not three axes of space beside each other, by its kinds and "
                          "directions; save it as a volume.");
    }
    const bool isTold = !axes.front().Kind.empty();
    this->Header.AreInterleaved = before == 1 && isTold && IsOfTime(axes.front());
    if (before > 1 || behind > 1 || (behind == 1 && this->Header.AreInterleaved) ||
      (behind == 1 && isTold && !IsOfTime(axes.back())))
    {
      throw this->Refused(" has more axes than three of space, one before them for colours or "
                          "vectors, and one of time; save a part of it.");
    }
    (this->Header.AreInterleaved ? this->Header.TimeSteps : this->Header.Components) =
      before == 1 ? axes.front().Size : 1;
    this->Header.TimeSteps = behind == 1 ? axes.back().Size : this->Header.TimeSteps;
    for (std::size_t i = 0; i < 3; ++i, ++ofSpace)
    {
      this->Header.Dimensions[i] = ofSpace->Size;
      this->Header.Axes[i][static_cast<int>(i)] = ofSpace->Spacing;
      this->Header.Axes[i] = ofSpace->HasDirection ? ofSpace->Direction : this->Header.Axes[i];
    }
  }

  void SetSpace()
  {
    if (const std::string origin = this->Field("space origin"); !origin.empty())
    {
      const std::size_t begin = origin.find('('), end = origin.find(')');
      this->Header.Origin =
        this->Vector(begin < end ? origin.substr(begin + 1, end - begin - 1) : origin);
    }
    const std::string space = LowerCase(this->Field("space"));
    const bool isLeft = space == "las" || space == "left-anterior-superior";
    if (isLeft || space == "ras" || space == "right-anterior-superior")
    {
      this->Header.From = "+y";
    }
    // A space that is a mirror picture of others.
    if (isLeft || space == "3d-left-handed")
    {
      this->Header.Origin[0] *= -1.0;
      for (vtkVector3d& axis : this->Header.Axes)
      {
        axis[0] *= -1.0;
      }
    }
  }

  // A name, "LIST" and names in lines, or a pattern: "slice%03d.raw 1 20 1".
  void SetFiles(const std::string& field)
  {
    const Words words = WordsOf(field);
    Words names = { field };
    if (words[0] == "LIST")
    {
      names = this->Listed;
    }
    else if (words.size() >= 4 && words[0].find('%') != std::string::npos)
    {
      names = this->ByPattern(words);
    }
    // Files of parts of slices, or of several, come to the same.
    for (const std::string& name : names)
    {
      this->Header.Files.push_back((fs::path(this->Path).parent_path() / name).string());
    }
    if (names.empty() || names.size() > MostFiles)
    {
      throw Damaged(this->Path, "it names " + std::to_string(names.size()) + " files of samples");
    }
  }

  Words ByPattern(const Words& words) const
  {
    const std::string& pattern = words[0];
    const std::size_t percent = pattern.find('%'),
                      end = pattern.find_first_not_of("0123456789", percent + 1);
    const std::string width = pattern.substr(percent + 1, end - percent - 1);
    if (end == std::string::npos || pattern[end] != 'd' || width.size() > 2 ||
      pattern.find('%', end) != std::string::npos)
    {
      throw Damaged(
        this->Path, "its pattern of files " + Quoted(pattern) + " is none like a%03d.raw");
    }
    const int first = this->Whole("the first file", words[1], 0, VTK_INT_MAX),
              last = this->Whole("the last file", words[2], 0, VTK_INT_MAX),
              step = this->Whole("the step between files", words[3], 1, VTK_INT_MAX);
    Words names;
    for (std::int64_t i = first; i <= last && names.size() <= MostFiles; i += step)
    {
      std::string number = std::to_string(i);
      const std::size_t digits = width.empty() ? 0 : std::stoul(width);
      number.insert(0, digits > number.size() ? digits - number.size() : 0,
        width.compare(0, 1, "0") == 0 ? '0' : ' ');
      names.push_back(pattern.substr(0, percent) + number + pattern.substr(end + 1));
    }
    return names;
  }

  std::string Path;
  std::map<std::string, std::string> Fields;
  Words Listed; // files
  std::vector<Axis> Axes;
  NrrdHeader Header;
};

}

double NrrdHeader::Samples() const
{
  double samples = static_cast<double>(this->Components) * this->TimeSteps;
  for (const int n : this->Dimensions)
  {
    samples *= n;
  }
  return samples;
}

NrrdHeader ReadNrrdHeader(const std::string& path)
{
  return Parser(path).Parse();
}
