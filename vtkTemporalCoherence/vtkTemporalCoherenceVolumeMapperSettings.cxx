// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Settings that are checked: choices, numbers that have to be finite, and values that are
// deprecated. PrintSelf lists all settings.
#include "vtkTemporalCoherenceVolumeMapper.h"

#include "Choice.h"
#include "vtkTemporalCoherenceVolumeMapperInternals.h"

#include <vtkScalarsToColors.h>

#include <algorithm>
#include <cmath>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
template <typename T>
void vtkTemporalCoherenceVolumeMapper::Internals::SetWithin(
  const char* name, T value, double low, double high, T& setting)
{
  // A distance is clamped to its range, so infinity is valid. A tolerance has no upper limit.
  if (std::isnan(value) || (std::isinf(value) && !(high < VTK_DOUBLE_MAX)))
  {
    std::ostringstream what;
    what << name << " must be a finite number";
    if (high < VTK_DOUBLE_MAX)
    {
      what << " from " << low << " to " << high;
    }
    else
    {
      what << " >= " << low;
    }
    what << ", got " << value << "; it stays " << setting << '.';
    // Errors of frames are compared with the last error of a frame, not with this one.
    if (what.str() != this->LastSettingError)
    {
      this->LastSettingError = what.str();
      vtkErrorWithObjectMacro(this->Self, << what.str());
    }
    return;
  }
  this->LastSettingError.clear();
  value = static_cast<T>(std::min(std::max(static_cast<double>(value), low), high));
  if (value != setting)
  {
    setting = value;
    this->Self->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetSurfaceMode(int mode)
{
  TemporalCoherence::SetChoice(this, "SurfaceMode", mode,
    { { CROSSING, "CROSSING" }, { THRESHOLD, "THRESHOLD" }, { LABELS, "LABELS" } },
    this->SurfaceMode);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetLabelTable(vtkScalarsToColors* table)
{
  if (this->LabelTable != table)
  {
    this->LabelTable = table;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkScalarsToColors* vtkTemporalCoherenceVolumeMapper::GetLabelTable()
{
  return this->LabelTable;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetLabelRadius(double samples)
{
  this->Internal->SetWithin("LabelRadius", samples, 0.0, 8.0, this->LabelRadius);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetColorTable(vtkScalarsToColors* table)
{
  if (this->ColorTable != table)
  {
    this->ColorTable = table;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkScalarsToColors* vtkTemporalCoherenceVolumeMapper::GetColorTable()
{
  return this->ColorTable;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetVectorMode(int mode)
{
  TemporalCoherence::SetChoice(this, "VectorMode", mode,
    { { DISABLED, "DISABLED" }, { MAGNITUDE, "MAGNITUDE" }, { COMPONENT, "COMPONENT" } },
    this->VectorMode);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetAntialiasing(int mode)
{
  TemporalCoherence::SetChoice(this, "Antialiasing", mode,
    { { ANTIALIASING_OFF, "ANTIALIASING_OFF" },
      { ANTIALIASING_WHEN_STILL, "ANTIALIASING_WHEN_STILL" },
      { ANTIALIASING_ALWAYS, "ANTIALIASING_ALWAYS" } },
    this->Antialiasing);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetReuseAccuracy(int accuracy)
{
  if (accuracy == BOUNDED && !this->Internal->HasWarnedOfBounded)
  {
    this->Internal->HasWarnedOfBounded = true;
    vtkWarningMacro(<< "ReuseAccuracy BOUNDED is removed and counts as EXACT: call "
                       "SetReuseAccuracyToExact() instead.");
  }
  TemporalCoherence::SetChoice(this, "ReuseAccuracy", accuracy == BOUNDED ? EXACT : accuracy,
    { { EXACT, "EXACT" }, { PAPER, "PAPER" } }, this->ReuseAccuracy);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetAmbientOcclusionRadius(double radius)
{
  this->Internal->SetWithin(
    "AmbientOcclusionRadius", radius, 0.0, VTK_DOUBLE_MAX, this->AmbientOcclusionRadius);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetLightRadius(double radius)
{
  constexpr double most = 1e100; // its square is a finite number
  this->Internal->SetWithin("LightRadius", radius, 0.0, most, this->LightRadius);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetAmbientOcclusionStrength(double strength)
{
  this->Internal->SetWithin(
    "AmbientOcclusionStrength", strength, 0.0, 1.0, this->AmbientOcclusionStrength);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetIsomapTolerance(double voxels)
{
  this->Internal->SetWithin("IsomapTolerance", voxels, 0.0, VTK_DOUBLE_MAX, this->IsomapTolerance);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetImageSampleDistance(float pixels)
{
  this->Internal->SetWithin("ImageSampleDistance", pixels, 0.1, 100.0, this->ImageSampleDistance);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetMinimumImageSampleDistance(float pixels)
{
  this->Internal->SetWithin(
    "MinimumImageSampleDistance", pixels, 0.1, 100.0, this->MinimumImageSampleDistance);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::SetMaximumImageSampleDistance(float pixels)
{
  this->Internal->SetWithin(
    "MaximumImageSampleDistance", pixels, 0.1, 100.0, this->MaximumImageSampleDistance);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const modes[] = { "CROSSING", "THRESHOLD", "LABELS" };
  os << indent << "SurfaceMode: " << modes[this->SurfaceMode] << endl;
  os << indent << "LabelTable: " << this->LabelTable.GetPointer() << endl;
  os << indent << "OutsideLabel: " << this->OutsideLabel << endl;
  os << indent << "LabelRadius: " << this->LabelRadius << endl;
  os << indent << "ColorArrayName: " << this->ColorArrayName << endl;
  os << indent << "ColorArrayOnCells: " << (this->ColorArrayOnCells ? "On" : "Off") << endl;
  os << indent << "ColorArrayComponent: " << this->ColorArrayComponent << endl;
  os << indent << "ColorArrayOpacity: " << (this->ColorArrayOpacity ? "On" : "Off") << endl;
  os << indent << "ColorTable: " << this->ColorTable.GetPointer() << endl;
  os << indent << "VectorMode: " << this->VectorMode << endl;
  os << indent << "VectorComponent: " << this->VectorComponent << endl;
  os << indent << "SmoothMeshNormals: " << this->SmoothMeshNormals << endl;
  os << indent << "MeshMemoryLimit: " << this->MeshMemoryLimit << endl;
  os << indent << "AmbientOcclusion: " << this->AmbientOcclusion << endl;
  os << indent << "AmbientOcclusionRadius: " << this->AmbientOcclusionRadius << endl;
  os << indent << "AmbientOcclusionStrength: " << this->AmbientOcclusionStrength << endl;
  os << indent << "AmbientOcclusionRays: " << this->AmbientOcclusionRays << endl;
  os << indent << "Shadows: " << this->Shadows << endl;
  os << indent << "LightRadius: " << this->LightRadius << endl;
  os << indent << "Antialiasing: " << this->Antialiasing << endl;
  os << indent << "ProgressiveImages: " << this->ProgressiveImages << endl;
  os << indent << "ReuseFrames: " << this->ReuseFrames << endl;
  os << indent << "Isomap: " << this->Isomap << endl;
  os << indent << "ReuseAccuracy: " << this->ReuseAccuracy << endl;
  os << indent << "RefineWhenStill: " << this->RefineWhenStill << endl;
  os << indent << "NumberOfCachedImages: " << this->NumberOfCachedImages << endl;
  os << indent << "IsomapTolerance: " << this->IsomapTolerance << endl;
  os << indent << "IsomapRange: " << this->IsomapRange[0] << ", " << this->IsomapRange[1] << endl;
  os << indent << "IsomapMemoryLimit: " << this->IsomapMemoryLimit << endl;
  os << indent << "FixedStepSampling: " << this->FixedStepSampling << endl;
  os << indent << "WarnOfIsovalues: " << this->WarnOfIsovalues << endl;
  os << indent << "Statistics:" << endl;
  this->GetStatistics()->PrintSelf(os, indent.GetNextIndent());
}
VTK_ABI_NAMESPACE_END
