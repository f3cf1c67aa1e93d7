// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/WholeCheck.h"

#include "Files/FileCheck.h"
#include "Files/Reading.h"
#include "Program/Quoted.h"

#include <vtkNew.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <set>

namespace
{

namespace fs = std::filesystem;
using Box = std::array<int, 6>; // least and greatest place along each axis

constexpr int MostLists = 4; // within each other

std::string AttributeOf(vtkXMLDataElement* element, const char* name)
{
  const char* text = element->GetAttribute(name);
  return text ? text : "";
}

std::optional<Box> BoxOf(vtkXMLDataElement* element, const char* attribute)
{
  Box box{};
  return element->GetVectorAttribute(attribute, 6, box.data()) == 6 ? std::optional<Box>(box)
                                                                    : std::nullopt;
}

void ForEach(vtkXMLDataElement* element, const std::function<void(vtkXMLDataElement*)>& visit)
{
  visit(element);
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    ForEach(element->GetNestedElement(i), visit);
  }
}

std::vector<vtkXMLDataElement*> NestedIn(vtkXMLDataElement* element, const char* name)
{
  std::vector<vtkXMLDataElement*> nested;
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    const bool isWanted = std::strcmp(element->GetNestedElement(i)->GetName(), name) == 0;
    nested.insert(nested.end(), isWanted ? 1 : 0, element->GetNestedElement(i));
  }
  return nested;
}

// Elements of a file, up to its appended data, and where arrays lie in it.
class XmlFile
{
public:
  explicit XmlFile(const std::string& path)
    : Path(path)
    , Size(static_cast<double>(SizeOf(path)))
    , File(path, std::ios::binary)
  {
    this->Parser->SetFileName(path.c_str());
    if (!this->Parser->Parse() || !this->Parser->GetRootElement())
    {
      throw Unreadable(path);
    }
    this->Root = this->Parser->GetRootElement();
    vtkXMLDataElement* appended = this->Root->FindNestedElementWithName("AppendedData");
    this->IsRaw = appended && AttributeOf(appended, "encoding") == "raw";
    this->EndOfAppended = this->Size;
    // Raw bytes may hold the same text by chance, but not where the file ends.
    const double tail = std::min(this->Size, 4096.0);
    const std::string text = this->TextAt(this->Size - tail, static_cast<std::size_t>(tail));
    const std::size_t end = text.rfind("</AppendedData");
    this->EndOfAppended =
      this->Size - tail + (end == std::string::npos ? tail : static_cast<double>(end));
  }

  vtkXMLDataElement* Root = nullptr;

  // Of arrays that are not compressed VTK's reader takes as many bytes as there are.
  void RequireArray(vtkXMLDataElement* array)
  {
    const std::string format = AttributeOf(array, "format");
    const bool isAppended = format == "appended";
    if (this->Root->GetAttribute("compressor") || (!isAppended && format != "binary"))
    {
      return;
    }
    double begin = 0.0, end = this->EndOfAppended;
    if (isAppended)
    {
      double offset = 0.0;
      array->GetScalarAttribute("offset", offset);
      begin = static_cast<double>(this->Parser->GetAppendedDataPosition()) + offset;
    }
    else
    {
      begin = this->Find('>', static_cast<double>(array->GetXMLByteIndex())) + 1.0;
      end = this->Find('<', begin);
    }
    if (!(begin + this->BytesOfArray(begin, end, isAppended && this->IsRaw) <= end))
    {
      throw Damaged(this->Path,
        "its array " + Quoted(AttributeOf(array, "Name")) + " ends before its header says");
    }
  }

private:
  std::string TextAt(double begin, std::size_t size)
  {
    std::string text(size, '\0');
    this->File.clear();
    this->File.seekg(static_cast<std::streamoff>(begin));
    this->File.read(text.data(), static_cast<std::streamsize>(size));
    text.resize(static_cast<std::size_t>(this->File.gcount()));
    return text;
  }

  // The place of a character, or the end of the file.
  double Find(char wanted, double begin)
  {
    constexpr std::size_t Step = 1 << 16;
    for (double at = begin; at < this->Size; at += Step)
    {
      const std::size_t found = this->TextAt(at, Step).find(wanted);
      if (found != std::string::npos)
      {
        return at + static_cast<double>(found);
      }
    }
    return this->Size;
  }

  // With its header, and white space before it.
  double BytesOfArray(double begin, double end, bool isRaw)
  {
    const bool isLong = AttributeOf(this->Root, "header_type") == "UInt64";
    const std::size_t header = isLong ? 8 : 4;
    std::string text = this->TextAt(begin, 256);
    text.resize(std::min(text.size(), static_cast<std::size_t>(std::max(end - begin, 0.0))));
    std::size_t blanks = 0;
    if (!isRaw)
    {
      blanks = std::min(text.find_first_not_of(" \t\r\n"), text.size());
      text = Decoded(text.substr(blanks, 12));
    }
    if (text.size() < header)
    {
      return end - begin + 1.0;
    }
    text.resize(header);
    if (AttributeOf(this->Root, "byte_order") != "BigEndian")
    {
      std::reverse(text.begin(), text.end());
    }
    double bytes = static_cast<double>(header);
    double count = 0.0;
    for (const char c : text)
    {
      count = 256.0 * count + static_cast<unsigned char>(c);
    }
    bytes += count;
    return isRaw ? bytes : static_cast<double>(blanks) + 4.0 * std::ceil(bytes / 3.0);
  }

  static std::string Decoded(const std::string& base64)
  {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned int bits = 0, count = 0;
    for (const char c : base64)
    {
      const std::size_t digit = digits.find(c);
      if (digit == std::string::npos)
      {
        break;
      }
      bits = bits << 6 | static_cast<unsigned int>(digit);
      count += 6;
      if (count >= 8)
      {
        count -= 8;
        bytes += static_cast<char>(bits >> count & 255u);
      }
    }
    return bytes;
  }

  std::string Path;
  double Size;
  std::ifstream File;
  vtkNew<vtkXMLDataParser> Parser;
  bool IsRaw = false;
  double EndOfAppended = 0.0;
};

// A place of a box that none of others holds. Along an axis, places between two neighbouring ends
// of boxes lie in the same ones.
std::optional<std::array<int, 3>> HoleIn(const Box& whole, const std::vector<Box>& boxes, int more)
{
  std::array<std::vector<int>, 3> ends;
  std::array<std::size_t, 3> n{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int first = whole[2 * axis], last = whole[2 * axis + 1] + more;
    std::vector<int>& own = ends[axis] = { first, last };
    for (const Box& box : boxes)
    {
      own.push_back(std::clamp(box[2 * axis], first, std::max(first, last)));
      own.push_back(std::clamp(box[2 * axis + 1] + more, first, std::max(first, last)));
    }
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    n[axis] = own.size() - 1;
  }
  constexpr double Most = 1 << 26;
  if (static_cast<double>(n[0]) * static_cast<double>(n[1]) * static_cast<double>(n[2]) > Most)
  {
    return std::nullopt;
  }
  std::vector<bool> isHeld(n[0] * n[1] * n[2], false);
  for (const Box& box : boxes)
  {
    std::array<std::size_t, 6> range{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto place = [&](int end)
      {
        const auto at = std::lower_bound(ends[axis].begin(), ends[axis].end(), end);
        return std::min(static_cast<std::size_t>(at - ends[axis].begin()), n[axis]);
      };
      range[2 * axis] = place(box[2 * axis]);
      range[2 * axis + 1] = place(box[2 * axis + 1] + more);
    }
    for (std::size_t k = range[4]; k < range[5]; ++k)
    {
      for (std::size_t j = range[2]; j < range[3]; ++j)
      {
        for (std::size_t i = range[0]; i < range[1]; ++i)
        {
          isHeld[i + n[0] * (j + n[1] * k)] = true;
        }
      }
    }
  }
  const auto hole =
    static_cast<std::size_t>(std::find(isHeld.begin(), isHeld.end(), false) - isHeld.begin());
  if (hole == isHeld.size())
  {
    return std::nullopt;
  }
  return std::array<int, 3>{ ends[0][hole % n[0]], ends[1][hole / n[0] % n[1]],
    ends[2][hole / (n[0] * n[1])] };
}

bool HasCellArrays(vtkXMLDataElement* grid)
{
  bool has = false;
  ForEach(grid,
    [&has](vtkXMLDataElement* element)
    {
      const std::string name = element->GetName();
      has = has || ((name == "CellData" || name == "PCellData") && element->GetNestedElement(0));
    });
  return has;
}

// A reader leaves samples that no piece has as they are in memory.
void RequireCovered(const std::string& path, vtkXMLDataElement* grid)
{
  const std::optional<Box> whole = BoxOf(grid, "WholeExtent");
  std::vector<Box> pieces;
  for (vtkXMLDataElement* piece : NestedIn(grid, "Piece"))
  {
    const std::optional<Box> box = BoxOf(piece, "Extent");
    pieces.insert(pieces.end(), box ? 1 : 0, box.value_or(Box{}));
  }
  if (!whole || pieces.empty())
  {
    return;
  }
  for (const int more : { 1, 0 })
  {
    const auto hole =
      more == 1 || HasCellArrays(grid) ? HoleIn(*whole, pieces, more) : std::nullopt;
    if (hole)
    {
      throw Damaged(path,
        std::string("none of its pieces has the ") + (more == 1 ? "point (" : "cell (") +
          std::to_string((*hole)[0]) + ", " + std::to_string((*hole)[1]) + ", " +
          std::to_string((*hole)[2]) + ") of its extent");
    }
  }
}

std::vector<std::string> PartsOf(const std::string& path, vtkXMLDataElement* root)
{
  std::vector<std::string> parts;
  ForEach(root,
    [&](vtkXMLDataElement* element)
    {
      const bool isPiece = std::strcmp(element->GetName(), "Piece") == 0;
      const std::string name = isPiece                    ? AttributeOf(element, "Source")
        : std::strcmp(element->GetName(), "DataSet") == 0 ? AttributeOf(element, "file")
                                                          : "";
      if (!name.empty())
      {
        parts.push_back((fs::path(path).parent_path() / name).string());
      }
    });
  return parts;
}

// VTK's reader takes levels, numbers and boxes of blocks as indices of what it has in memory.
class AdaptiveBlocks
{
public:
  AdaptiveBlocks(const std::string& path, vtkXMLDataElement* grid)
    : Path(path)
  {
    for (vtkXMLDataElement* block : NestedIn(grid, "Block"))
    {
      this->Add(block);
    }
    int level = 0;
    double coarser = 0.0;
    for (const auto& [number, of] : this->Levels)
    {
      this->Require(number == level, "its levels are not numbered from 0");
      this->Require(
        level == 0 || std::round(coarser / of.Spacing) >= 1.0, "a finer level has no finer cells");
      this->Require(of.Blocks.size() == static_cast<std::size_t>(*of.Blocks.rbegin()) + 1,
        "its blocks are not numbered from 0");
      coarser = of.Spacing;
      ++level;
    }
  }

private:
  struct Level
  {
    double Spacing = 0.0;
    std::set<int> Blocks;
  };

  void Require(bool isSo, const char* otherwise) const
  {
    if (!isSo)
    {
      throw Damaged(this->Path, otherwise);
    }
  }

  void Add(vtkXMLDataElement* element)
  {
    int number = -1;
    std::array<double, 3> spacing{};
    const bool hasBoth = element->GetScalarAttribute("level", number) == 1 &&
      element->GetVectorAttribute("spacing", 3, spacing.data()) == 3;
    this->Require(hasBoth &&
        std::all_of(spacing.begin(), spacing.end(),
          [](double step) { return step > 0.0 && std::isfinite(step); }),
      "a level or a spacing is missing");
    Level& level = this->Levels[number];
    level.Spacing = spacing[0];
    for (vtkXMLDataElement* block : NestedIn(element, "DataSet"))
    {
      const std::optional<Box> box = BoxOf(block, "amr_box");
      int index = -1;
      this->Require(block->GetScalarAttribute("index", index) == 1 && index >= 0 && box,
        "an index or an amr_box is missing");
      level.Blocks.insert(index);
      this->RequireSize(block, *box);
    }
    this->Require(!level.Blocks.empty(), "a level has no blocks");
  }

  void RequireSize(vtkXMLDataElement* block, const Box& box) const
  {
    constexpr int Farthest = 1 << 24; // so that finer levels can be counted, too
    for (std::size_t axis = 0; axis < 6; axis += 2)
    {
      this->Require(
        -Farthest <= box[axis] && box[axis] <= box[axis + 1] && box[axis + 1] <= Farthest,
        "an amr_box has no volume, or lies too far away");
    }
    const std::string part =
      (fs::path(this->Path).parent_path() / AttributeOf(block, "file")).string();
    if (!EndsWith(LowerCase(part), ".vti"))
    {
      return;
    }
    XmlFile file(part);
    vtkXMLDataElement* image = file.Root->FindNestedElementWithName("ImageData");
    const std::optional<Box> whole = image ? BoxOf(image, "WholeExtent") : std::nullopt;
    for (std::size_t axis = 0; axis < 6; axis += 2)
    {
      if (!whole || (*whole)[axis + 1] - (*whole)[axis] != box[axis + 1] - box[axis] + 1)
      {
        throw Damaged(this->Path, "its block " + Quoted(part) + " has not the size of its amr_box");
      }
    }
  }

  std::string Path;
  std::map<int, Level> Levels;
};

void RequireWholeXml(const std::string& path, int depth)
{
  XmlFile file(path);
  for (const std::string& part : PartsOf(path, file.Root))
  {
    std::error_code error;
    if (!fs::is_regular_file(part, error))
    {
      throw UserError(Quoted(path) + " names the file " + Quoted(part) +
        ", which is not there; put it there, or correct the name.");
    }
    if (depth < MostLists && IsXmlName(part))
    {
      try
      {
        RequireWholeXml(part, depth + 1);
      }
      catch (const UserError& reason)
      {
        throw UserError(Quoted(path) + " names a file that is not whole: " + reason.what());
      }
    }
  }
  const std::string type = AttributeOf(file.Root, "type");
  if (type == "vtkOverlappingAMR" || type == "vtkHierarchicalBoxDataSet")
  {
    for (vtkXMLDataElement* grid : NestedIn(file.Root, type.c_str()))
    {
      AdaptiveBlocks(path, grid);
    }
  }
  ForEach(file.Root,
    [&](vtkXMLDataElement* element)
    {
      const std::string name = element->GetName();
      if (name == "DataArray" || name == "Array")
      {
        file.RequireArray(element);
      }
      else if (element->GetAttribute("WholeExtent"))
      {
        RequireCovered(path, element);
      }
    });
}

}

bool IsXmlName(const std::string& path)
{
  const std::string suffix = LowerCase(fs::path(path).extension().string());
  return suffix != ".vtk" &&
    (suffix.compare(0, 3, ".vt") == 0 || suffix.compare(0, 4, ".pvt") == 0);
}

std::vector<std::string> PartsOf(const std::string& path)
{
  return PartsOf(path, XmlFile(path).Root);
}

void RequireWholeXml(const std::string& path)
{
  RequireWholeXml(path, 0);
}
