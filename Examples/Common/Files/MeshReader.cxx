// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MeshReader.h"

#include "Files/Arrays.h"
#include "Files/OneTimeStep.h"
#include "Files/WholeCheck.h"
#include "Program/Quoted.h"
#include "Program/Silence.h"

#include <vtkDataSet.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLGenericDataObjectReader.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPImageDataReader.h>
#include <vtkXMLPRectilinearGridReader.h>
#include <vtkXMLPStructuredGridReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUniformGridAMRReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#ifdef EXAMPLES_HAVE_IOCGNSReader
#include <vtkCGNSReader.h>
#endif
#ifdef EXAMPLES_HAVE_IOExodus
#include <vtkExodusIIReader.h>
#endif
#ifdef EXAMPLES_HAVE_IOParallel
#include <vtkMultiBlockPLOT3DReader.h>
#endif

#include <algorithm>
#include <filesystem>
#include <functional>
#include <vector>

namespace
{

// A way to make a reader of a file, which may be refused.
struct Format
{
  std::vector<const char*> Suffixes;
  std::function<vtkSmartPointer<vtkAlgorithm>(const std::string& path)> Open;
};

template <typename Reader>
vtkSmartPointer<vtkAlgorithm> OpenXml(const std::string& path)
{
  RequireWholeXml(path);
  const auto reader = vtkSmartPointer<Reader>::New();
  if (!reader->CanReadFile(path.c_str()))
  {
    throw Unreadable(path);
  }
  reader->SetFileName(path.c_str());
  return reader;
}

vtkSmartPointer<vtkAlgorithm> OpenAdaptive(const std::string& path)
{
  const auto reader = OpenXml<vtkXMLUniformGridAMRReader>(path);
  // Before VTK 9.6 it is the coarsest one by default.
  vtkXMLUniformGridAMRReader::SafeDownCast(reader)->SetMaximumLevelsToReadByDefault(0);
  return reader;
}

vtkSmartPointer<vtkAlgorithm> OpenLegacy(const std::string& path)
{
  const auto reader = vtkSmartPointer<vtkGenericDataObjectReader>::New();
  reader->SetFileName(path.c_str());
  ReadAllArrays(reader);
  return reader;
}

#ifdef EXAMPLES_HAVE_IOExodus
vtkSmartPointer<vtkAlgorithm> OpenExodus(const std::string& path)
{
  RequireWholeNetcdf(path);
  const auto reader = vtkSmartPointer<vtkExodusIIReader>::New();
  if (!reader->CanReadFile(path.c_str()))
  {
    throw Unreadable(path);
  }
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  reader->GenerateObjectIdCellArrayOff();
  reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
  reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
  return reader;
}
#endif

#ifdef EXAMPLES_HAVE_IOCGNSReader
vtkSmartPointer<vtkAlgorithm> OpenCgns(const std::string& path)
{
  const auto reader = vtkSmartPointer<vtkCGNSReader>::New();
  if (!reader->CanReadFile(path.c_str()))
  {
    throw Unreadable(path);
  }
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  reader->EnableAllBases();
  reader->EnableAllPointArrays();
  reader->EnableAllCellArrays();
  return reader;
}
#endif

#ifdef EXAMPLES_HAVE_IOParallel
// The values lie in another file, whose name has a q instead of xyz.
std::string NameOfValues(const std::string& path)
{
  const std::filesystem::path whole(path);
  std::string name = whole.filename().string();
  const std::size_t at = name.rfind("xyz");
  name.replace(at, 3, "q");
  return (whole.parent_path() / name).string();
}

vtkSmartPointer<vtkAlgorithm> OpenPlot3D(const std::string& path)
{
  const std::string values = NameOfValues(path);
  std::error_code error;
  if (!std::filesystem::is_regular_file(values, error))
  {
    throw UserError(Quoted(path) + " has the points of a PLOT3D grid, but there is no file " +
      Quoted(values) + " with its values; put it beside the other.");
  }
  const auto reader = vtkSmartPointer<vtkMultiBlockPLOT3DReader>::New();
  reader->AutoDetectFormatOn();
  reader->SetXYZFileName(path.c_str());
  reader->SetQFileName(values.c_str());
  return reader;
}
#endif

const std::vector<Format>& Formats()
{
  static const std::vector<Format> formats = {
    { { ".vtu" }, OpenXml<OneTimeStep<vtkXMLUnstructuredGridReader>> },
    { { ".pvti" }, OpenXml<vtkXMLPImageDataReader> },
    { { ".pvtu" }, OpenXml<vtkXMLPUnstructuredGridReader> },
    { { ".vts" }, OpenXml<OneTimeStep<vtkXMLStructuredGridReader>> },
    { { ".pvts" }, OpenXml<vtkXMLPStructuredGridReader> },
    { { ".vtr" }, OpenXml<OneTimeStep<vtkXMLRectilinearGridReader>> },
    { { ".pvtr" }, OpenXml<vtkXMLPRectilinearGridReader> },
    { { ".vtm", ".vtmb" }, OpenXml<vtkXMLMultiBlockDataReader> },
    { { ".vth", ".vthb" }, OpenAdaptive },
#ifdef EXAMPLES_HAVE_IOExodus
    { { ".ex2", ".exo", ".e" }, OpenExodus },
#endif
#ifdef EXAMPLES_HAVE_IOCGNSReader
    { { ".cgns" }, OpenCgns },
#endif
#ifdef EXAMPLES_HAVE_IOParallel
    { { ".xyz", "xyz.bin" }, OpenPlot3D },
#endif
  };
  return formats;
}

const Format* FormatOf(const std::string& path)
{
  const std::string name = LowerCase(path);
  for (const Format& format : Formats())
  {
    for (const char* suffix : format.Suffixes)
    {
      if (EndsWith(name, suffix))
      {
        return &format;
      }
    }
  }
  return nullptr;
}

// The first file that a list of files names which cannot be read, or is read without cells. Empty
// if there is none.
std::string BadPartOf(const std::string& path, bool mayBeEmpty)
{
  for (const std::string& part : PartsOf(path))
  {
    const Silence silence;
    vtkNew<vtkXMLGenericDataObjectReader> reader;
    reader->SetFileName(part.c_str());
    reader->Update();
    auto* const set = vtkDataSet::SafeDownCast(reader->GetOutput());
    if (silence.HeardErrors() || !reader->GetOutput() ||
      (!mayBeEmpty && set && set->GetNumberOfCells() == 0))
    {
      return part;
    }
  }
  return "";
}

// Of files of blocks one hears of those without cells: others are seen.
std::string RemarkOnEmptyParts(const std::string& path, vtkDataObject* data)
{
  const std::vector<vtkDataSet*> sets = DataSetsOf(data);
  const bool isOfBlocks = EndsWith(LowerCase(path), ".vtm") || EndsWith(LowerCase(path), ".vtmb");
  const bool hasEmpty = isOfBlocks &&
    std::any_of(
      sets.begin(), sets.end(), [](vtkDataSet* set) { return set->GetNumberOfCells() == 0; });
  const std::string part = hasEmpty ? BadPartOf(path, false) : "";
  return part.empty() ? ""
                      : Quoted(path) + " names the file " + Quoted(part) +
      ", which has no cells: nothing of it is drawn.";
}

}

bool IsMeshName(const std::string& path)
{
  return FormatOf(path) != nullptr;
}

std::string ListOfMeshSuffixes()
{
  std::string list;
  for (const Format& format : Formats())
  {
    for (const char* suffix : format.Suffixes)
    {
      list += std::string(list.empty() ? "" : ", ") + suffix;
    }
  }
  return list;
}

void ReadMesh(const VolumeSource& source, const ReadingProgress& progress, Volume& volume)
{
  const Format* format = FormatOf(source.Path);
  const vtkSmartPointer<vtkAlgorithm> reader =
    format ? format->Open(source.Path) : OpenLegacy(source.Path);
  reader->UpdateInformation();
  volume.TimeSteps = TimeStepsOf(reader);
  if (source.TimeStep <= volume.TimeSteps)
  {
    Watch(reader, progress).Update(source.Path, source.TimeStep);
  }
  volume.Data = reader->GetOutputDataObject(0);
  if (!volume.Data)
  {
    throw Unreadable(source.Path);
  }
  volume.Remark = RemarkOnEmptyParts(source.Path, volume.Data);
}

UserError UnreadableOrPart(const std::string& path)
{
  const std::string part = IsXmlName(path) ? BadPartOf(path, true) : "";
  return part.empty()
    ? Unreadable(path)
    : UserError(Quoted(path) + " names the file " + Quoted(part) +
        ", which could not be read; check that it is whole and of one of VTK's XML formats.");
}
