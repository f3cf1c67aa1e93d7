// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceBrickSource.h"

#include "OutOfCore/BrickArray.h"
#include "OutOfCore/OutOfCoreVolume.h"
#include "OutOfCore/VolumeOpener.h"
#include "VolumeFiles/VtkTypes.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstddef>
#include <new>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTemporalCoherenceBrickSource);

namespace
{

constexpr vtkTypeInt64 LeastLimit = vtkTypeInt64(1) << 20;
constexpr vtkTypeInt64 UsualLimit = vtkTypeInt64(3) << 29;

/// Tell VTK the range of the values of a mapped array, for which it would read all samples. Arrays
/// in bricks tell it themselves. A change of the array, such as another name, makes VTK forget it.
void TellRange(vtkDataArray* array, const TemporalCoherence::OutOfCoreVolume& volume)
{
  const TemporalCoherence::KnownRanges& known = *volume.Ranges();
  const auto tell = [array](vtkInformationInformationVectorKey* key, const glm::dvec2& range)
  {
    vtkNew<vtkInformation> component;
    component->Set(vtkDataArray::COMPONENT_RANGE(), &range.x, 2);
    vtkNew<vtkInformationVector> components;
    components->Append(component);
    array->GetInformation()->Set(key, components);
  };
  if (volume.Mapped() && known.HasFinite)
  {
    tell(vtkAbstractArray::PER_COMPONENT(), known.Whole);
    tell(vtkAbstractArray::PER_FINITE_COMPONENT(), known.Finite);
  }
}

}

//------------------------------------------------------------------------------
class vtkTemporalCoherenceBrickSource::Internals
{
public:
  vtkSmartPointer<vtkAlgorithm> Reader;
  std::shared_ptr<const TemporalCoherence::VolumeFile> File;
  std::shared_ptr<TemporalCoherence::OutOfCoreVolume> Volume; ///< of the last update
  vtkSmartPointer<vtkDataArray> Array;                        ///< of the volume
  vtkSmartPointer<vtkImageData> Coarse;                       ///< null: not made yet
};

//------------------------------------------------------------------------------
vtkTemporalCoherenceBrickSource::vtkTemporalCoherenceBrickSource()
  : MemoryLimit(UsualLimit)
  , Inner(new Internals)
{
  this->SetNumberOfInputPorts(0);
}

vtkTemporalCoherenceBrickSource::~vtkTemporalCoherenceBrickSource() = default;

//------------------------------------------------------------------------------
void vtkTemporalCoherenceBrickSource::SetFileName(const std::string& name)
{
  if (name != this->FileName)
  {
    this->FileName = name;
    this->Modified();
  }
}

void vtkTemporalCoherenceBrickSource::SetArrayName(const std::string& name)
{
  if (name != this->ArrayName)
  {
    this->ArrayName = name;
    this->Modified();
  }
}

void vtkTemporalCoherenceBrickSource::SetRangesFolder(const std::string& folder)
{
  if (folder != this->RangesFolder)
  {
    this->RangesFolder = folder;
    this->Modified();
  }
}

void vtkTemporalCoherenceBrickSource::SetReader(vtkAlgorithm* reader)
{
  if (reader != this->Inner->Reader)
  {
    this->Inner->Reader = reader;
    this->Modified();
  }
}

vtkAlgorithm* vtkTemporalCoherenceBrickSource::GetReader()
{
  return this->Inner->Reader;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceBrickSource::SetRawLayout(
  const int dimensions[3], int scalarType, vtkTypeInt64 headerSize, bool isBigEndian)
{
  std::copy_n(dimensions, 3, this->RawDimensions);
  this->RawScalarType = scalarType;
  this->RawHeaderSize = headerSize;
  this->RawIsBigEndian = isBigEndian;
  this->Modified();
}

void vtkTemporalCoherenceBrickSource::SetRawLayout(
  int x, int y, int z, int scalarType, vtkTypeInt64 headerSize, bool isBigEndian)
{
  const int dimensions[3] = { x, y, z };
  this->SetRawLayout(dimensions, scalarType, headerSize, isBigEndian);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceBrickSource::SetMemoryLimit(vtkTypeInt64 bytes)
{
  // The image stays the same: this is no modification.
  this->MemoryLimit = std::max(bytes, LeastLimit);
  if (this->Inner->Volume)
  {
    this->Inner->Volume->SetMemoryLimit(static_cast<std::size_t>(this->MemoryLimit));
  }
}

//------------------------------------------------------------------------------
int vtkTemporalCoherenceBrickSource::GetNumberOfLevels()
{
  return this->Inner->File ? static_cast<int>(this->Inner->File->Levels().size()) : 0;
}

void vtkTemporalCoherenceBrickSource::GetLevelDimensions(int level, int dimensions[3])
{
  const bool isThere = level >= 0 && level < this->GetNumberOfLevels();
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] =
      isThere ? this->Inner->File->Levels()[static_cast<std::size_t>(level)].Dimensions[axis] : 0;
  }
}

vtkTypeInt64 vtkTemporalCoherenceBrickSource::GetMemoryInUse()
{
  return this->Inner->Volume ? static_cast<vtkTypeInt64>(this->Inner->Volume->MemoryInBytes()) : 0;
}

vtkTypeInt64 vtkTemporalCoherenceBrickSource::GetNumberOfReads()
{
  const auto& volume = this->Inner->Volume;
  return volume && volume->Bricks() ? volume->Bricks()->NumberOfReads() : 0;
}

bool vtkTemporalCoherenceBrickSource::GetIsMapped()
{
  return this->Inner->Volume && this->Inner->Volume->Mapped();
}

bool vtkTemporalCoherenceBrickSource::GetHadRanges()
{
  return this->Inner->Volume && this->Inner->Volume->HadRanges();
}

vtkImageData* vtkTemporalCoherenceBrickSource::GetCoarseImage()
{
  if (!this->Inner->Coarse && this->Inner->Volume)
  {
    this->Inner->Coarse = TemporalCoherence::MakeCoarseImage(*this->Inner->Volume);
  }
  return this->Inner->Coarse;
}

void vtkTemporalCoherenceBrickSource::Close()
{
  this->Inner->File.reset();
  this->Inner->Volume.reset();
  this->Inner->Array = nullptr;
  this->Inner->Coarse = nullptr;
  this->GetOutput()->Initialize();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkTemporalCoherenceBrickSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  TemporalCoherence::VolumeRequest request;
  request.Path = this->FileName;
  request.Reader = this->Inner->Reader;
  request.Choice = { this->Channel, this->TimePoint, this->ArrayName };
  request.RawDimensions = { this->RawDimensions[0], this->RawDimensions[1],
    this->RawDimensions[2] };
  request.RawType = this->RawScalarType;
  request.RawHeaderSize = this->RawHeaderSize;
  request.RawIsBigEndian = this->RawIsBigEndian;
  request.RawSpacing = { this->RawSpacing[0], this->RawSpacing[1], this->RawSpacing[2] };
  request.RawOrigin = { this->RawOrigin[0], this->RawOrigin[1], this->RawOrigin[2] };
  std::string error;
  try
  {
    this->Inner->File = TemporalCoherence::OpenVolume(request, error);
  }
  catch (const std::bad_alloc&)
  {
    this->Inner->File.reset();
    error = "There is not enough memory to open " + this->FileName + "; free memory.";
  }
  this->Inner->Volume.reset();
  this->Inner->Coarse = nullptr;
  if (this->Inner->File && this->Level >= this->GetNumberOfLevels())
  {
    error = "Level " + std::to_string(this->Level) + " is not there; set one from 0 to " +
      std::to_string(this->GetNumberOfLevels() - 1) + ".";
  }
  if (!error.empty())
  {
    this->Inner->File.reset();
    this->GetOutput()->Initialize();
    vtkErrorMacro(<< error);
    return 0;
  }
  const TemporalCoherence::VolumeLevel& level =
    this->Inner->File->Levels()[static_cast<std::size_t>(this->Level)];
  const int extent[6] = { 0, level.Dimensions.x - 1, 0, level.Dimensions.y - 1, 0,
    level.Dimensions.z - 1 };
  vtkInformation* const output = outputs->GetInformationObject(0);
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  output->Set(vtkDataObject::SPACING(), &level.Spacing.x, 3);
  output->Set(vtkDataObject::ORIGIN(), &level.Origin.x, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(
    output, TemporalCoherence::VtkTypeOf(this->Inner->File->Type()), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkTemporalCoherenceBrickSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  auto* const image = vtkImageData::GetData(outputs);
  image->Initialize();
  if (!this->Inner->File)
  {
    return 0;
  }
  const TemporalCoherence::VolumeLevel& level =
    this->Inner->File->Levels()[static_cast<std::size_t>(this->Level)];
  if (!this->Inner->Volume)
  {
    std::string error;
    try
    {
      const TemporalCoherence::OutOfCoreOptions options = { static_cast<std::size_t>(this->Level),
        static_cast<std::size_t>(this->MemoryLimit),
        TemporalCoherence::RangesPathsOf(this->Inner->Reader ? "" : this->FileName,
          this->RangesFolder, *this->Inner->File,
          { this->Channel, this->TimePoint, this->ArrayName }, this->Level) };
      const auto report = [this](double done)
      {
        this->UpdateProgress(done);
        return !this->GetAbortExecute();
      };
      this->Inner->Volume =
        TemporalCoherence::OutOfCoreVolume::Open(this->Inner->File, options, report, error);
      this->Inner->Array =
        this->Inner->Volume ? TemporalCoherence::MakeArray(this->Inner->Volume) : nullptr;
    }
    catch (const std::bad_alloc&)
    {
      error = "There is not enough memory for the value ranges of " + this->FileName +
        "; free memory, or let them be written into a file (SetRangesFolder).";
    }
    if (!this->Inner->Volume)
    {
      if (!error.empty())
      {
        vtkErrorMacro(<< error);
      }
      return 0;
    }
  }
  image->SetExtent(0, level.Dimensions.x - 1, 0, level.Dimensions.y - 1, 0, level.Dimensions.z - 1);
  image->SetSpacing(&level.Spacing.x);
  image->SetOrigin(&level.Origin.x);
  this->Inner->Array->SetName(this->ArrayName.empty() ? "Samples" : this->ArrayName.c_str());
  TellRange(this->Inner->Array, *this->Inner->Volume);
  image->GetPointData()->SetScalars(this->Inner->Array);
  return 1;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceBrickSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << '\n';
  os << indent << "Reader: " << this->Inner->Reader.Get() << '\n';
  os << indent << "RawDimensions: " << this->RawDimensions[0] << ", " << this->RawDimensions[1]
     << ", " << this->RawDimensions[2] << '\n';
  os << indent << "RawScalarType: " << this->RawScalarType << '\n';
  os << indent << "RawHeaderSize: " << this->RawHeaderSize << '\n';
  os << indent << "RawIsBigEndian: " << this->RawIsBigEndian << '\n';
  os << indent << "RawSpacing: " << this->RawSpacing[0] << ", " << this->RawSpacing[1] << ", "
     << this->RawSpacing[2] << '\n';
  os << indent << "RawOrigin: " << this->RawOrigin[0] << ", " << this->RawOrigin[1] << ", "
     << this->RawOrigin[2] << '\n';
  os << indent << "Channel: " << this->Channel << '\n';
  os << indent << "TimePoint: " << this->TimePoint << '\n';
  os << indent << "ArrayName: " << this->ArrayName << '\n';
  os << indent << "Level: " << this->Level << '\n';
  os << indent << "MemoryLimit: " << this->MemoryLimit << '\n';
  os << indent << "RangesFolder: " << this->RangesFolder << '\n';
}

VTK_ABI_NAMESPACE_END
