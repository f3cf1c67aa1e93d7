// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MeshReader.h"

#include "Files/FileCheck.h"
#include "Files/OneTimeStep.h"
#include "Program/Quoted.h"

#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLMultiBlockDataReader.h>
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
  const auto reader = vtkSmartPointer<Reader>::New();
  if (!reader->CanReadFile(path.c_str()))
  {
    throw Unreadable(path);
  }
  reader->SetFileName(path.c_str());
  return reader;
}

// A file that names others, which hold the parts.
template <typename Reader>
vtkSmartPointer<vtkAlgorithm> OpenList(const std::string& path)
{
  RequireParts(path);
  return OpenXml<Reader>(path);
}

vtkSmartPointer<vtkAlgorithm> OpenLegacy(const std::string& path)
{
  const auto reader = vtkSmartPointer<vtkGenericDataObjectReader>::New();
  reader->SetFileName(path.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllFieldsOn();
  return reader;
}

#ifdef EXAMPLES_HAVE_IOExodus
vtkSmartPointer<vtkAlgorithm> OpenExodus(const std::string& path)
{
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
    { { ".pvtu" }, OpenList<vtkXMLPUnstructuredGridReader> },
    { { ".vts" }, OpenXml<OneTimeStep<vtkXMLStructuredGridReader>> },
    { { ".pvts" }, OpenList<vtkXMLPStructuredGridReader> },
    { { ".vtr" }, OpenXml<OneTimeStep<vtkXMLRectilinearGridReader>> },
    { { ".pvtr" }, OpenList<vtkXMLPRectilinearGridReader> },
    { { ".vtm", ".vtmb" }, OpenList<vtkXMLMultiBlockDataReader> },
    { { ".vth", ".vthb" }, OpenList<vtkXMLUniformGridAMRReader> },
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
}
