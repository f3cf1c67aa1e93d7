// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/WholeCheck.h"

#include "Files/FileCheck.h"
#include "Files/Reading.h"
#include "Program/Quoted.h"

#include <vtkExtentSplitter.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

// A fault is told as what "the file" does: "ends too early". It is empty where there is none.
namespace
{

namespace fs = std::filesystem;
using Element = vtkSmartPointer<vtkXMLDataElement>;
using Box = std::array<int, 6>; // least and greatest place along each axis

// The element that all others lie in; null if the file does not end with it.
Element RootOf(const std::string& path)
{
  const auto tail = static_cast<std::streamoff>(std::min<std::uintmax_t>(SizeOf(path), 1024));
  std::ifstream file(path, std::ios::binary);
  file.seekg(-tail, std::ios::end);
  const std::string end(std::istreambuf_iterator<char>(file), {});
  vtkNew<vtkXMLDataParser> parser; // which stops where appended data begin
  parser->SetFileName(path.c_str());
  return end.find("</VTKFile") != std::string::npos && parser->Parse() ? parser->GetRootElement()
                                                                       : nullptr;
}

std::vector<Element> NestedIn(vtkXMLDataElement* element, const std::string& name)
{
  std::vector<Element> nested;
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* one = element->GetNestedElement(i);
    nested.insert(nested.end(), name == one->GetName() ? 1 : 0, one);
  }
  return nested;
}

// The file that an element names; empty if it names none.
std::string PartOf(const std::string& path, vtkXMLDataElement* element)
{
  const char* file = element->GetAttribute("file");
  const char* name = file ? file : element->GetAttribute("Source");
  return name && *name ? (fs::path(path).parent_path() / name).string() : "";
}

// The elements that name files.
void AddParts(const std::string& path, vtkXMLDataElement* element, std::vector<Element>& parts)
{
  parts.insert(parts.end(), PartOf(path, element).empty() ? 0 : 1, element);
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    AddParts(path, element->GetNestedElement(i), parts);
  }
}

// VTK's reader leaves what no piece has as it was in memory. Of a part it asks for the extent that
// the list tells of it, if any.
std::string FaultOfPieces(vtkXMLDataElement* grid, vtkXMLDataElement* inList)
{
  vtkNew<vtkExtentSplitter> splitter;
  vtkXMLDataElement* cells = grid->FindNestedElementWithName("PCellData");
  bool hasCells = cells && cells->GetNumberOfNestedElements() > 0;
  Box box{};
  for (int i = 0; i < grid->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* piece = grid->GetNestedElement(i);
    if (piece->GetVectorAttribute("Extent", 6, box.data()) == 6)
    {
      splitter->AddExtentSource(i, 0, box.data());
    }
    cells = piece->FindNestedElementWithName("CellData");
    hasCells = hasCells || (cells && cells->GetNumberOfNestedElements() > 0);
  }
  splitter->SetPointMode(!hasCells);
  const bool isInList = inList && inList->GetVectorAttribute("Extent", 6, box.data()) == 6;
  if ((isInList || grid->GetVectorAttribute("WholeExtent", 6, box.data()) == 6) &&
    box != Box{ 0, -1, 0, -1, 0, -1 })
  {
    splitter->AddExtent(box.data());
  }
  return splitter->ComputeSubExtents() ? ""
    : isInList                         ? "has pieces that do not cover its Extent in the list"
                                       : "has pieces that do not cover its WholeExtent";
}

// Whether the image of a block, if it names one, has the size of its box, which is not far away.
bool IsBoxOf(const std::string& part, const Box& box)
{
  constexpr int Farthest = 1 << 24; // so that cells of finer levels can be counted, too
  Box whole{};
  const Element root = part.empty() ? nullptr : RootOf(part);
  const Element image = root ? root->FindNestedElementWithName("ImageData") : nullptr;
  bool isSo =
    part.empty() || (image && image->GetVectorAttribute("WholeExtent", 6, whole.data()) == 6);
  for (std::size_t i = 0; i < 6; i += 2)
  {
    isSo = isSo && -Farthest <= box[i] && box[i] <= box[i + 1] && box[i + 1] <= Farthest &&
      (part.empty() || whole[i + 1] - whole[i] == box[i + 1] - box[i] + 1);
  }
  return isSo;
}

// VTK's reader takes levels, numbers and boxes of blocks as indices of what it has in memory.
std::string FaultOfBlocks(const std::string& path, vtkXMLDataElement* grid)
{
  double coarser = HUGE_VAL;
  int levels = 0;
  for (const Element& level : NestedIn(grid, "Block"))
  {
    const std::vector<Element> blocks = NestedIn(level, "DataSet");
    std::array<double, 3> spacing{};
    int number = -1, index = 0;
    level->GetScalarAttribute("level", number);
    level->GetVectorAttribute("spacing", 3, spacing.data());
    if (number != levels++ || blocks.empty() || std::round(coarser / spacing[0]) < 1.0 ||
      *std::min_element(spacing.begin(), spacing.end()) <= 0.0)
    {
      return "has a level of a wrong number or spacing, or without blocks";
    }
    coarser = spacing[0];
    for (const Element& block : blocks)
    {
      Box box{};
      number = -1;
      block->GetScalarAttribute("index", number);
      if (number != index++ || block->GetVectorAttribute("amr_box", 6, box.data()) != 6 ||
        !IsBoxOf(PartOf(path, block), box))
      {
        return "has a block of a wrong index or amr_box";
      }
    }
  }
  return "";
}

std::string FaultOf(const std::string& path, int depth, vtkXMLDataElement* inList)
{
  constexpr int MostLists = 4; // within each other
  const Element root = RootOf(path);
  if (!root)
  {
    return "does not end as XML of VTK does";
  }
  std::vector<Element> parts;
  AddParts(path, root, parts);
  std::error_code error;
  std::string fault;
  for (std::size_t i = 0; i < parts.size() && fault.empty(); ++i)
  {
    const std::string part = PartOf(path, parts[i]);
    fault = !fs::is_regular_file(part, error) ? "is not there"
      : depth < MostLists && IsXmlName(part)  ? FaultOf(part, depth + 1, parts[i])
                                              : "";
    fault = fault.empty() ? "" : "names " + Quoted(part) + ", which " + fault;
  }
  for (int i = 0; i < root->GetNumberOfNestedElements() && fault.empty(); ++i)
  {
    vtkXMLDataElement* grid = root->GetNestedElement(i);
    const std::string kind = grid->GetName();
    const bool isAdaptive = kind == "vtkOverlappingAMR" || kind == "vtkHierarchicalBoxDataSet";
    fault = isAdaptive ? FaultOfBlocks(path, grid) : FaultOfPieces(grid, inList);
  }
  return fault;
}

}

bool IsXmlName(const std::string& path)
{
  const std::string suffix = LowerCase(fs::path(path).extension().string()).substr(0, 4);
  return suffix == ".pvt" || (suffix.substr(0, 3) == ".vt" && suffix != ".vtk");
}

std::vector<std::string> PartsOf(const std::string& path)
{
  std::vector<Element> parts;
  if (const Element root = RootOf(path))
  {
    AddParts(path, root, parts);
  }
  std::vector<std::string> names;
  for (const Element& part : parts)
  {
    names.push_back(PartOf(path, part));
  }
  return names;
}

void RequireWholeXml(const std::string& path)
{
  if (const std::string fault = FaultOf(path, 0, nullptr); !fault.empty())
  {
    throw Damaged(path, "it " + fault);
  }
}
