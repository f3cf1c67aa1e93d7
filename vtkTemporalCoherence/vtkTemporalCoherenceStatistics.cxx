// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceStatistics.h"

#include <vtkObjectFactory.h>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTemporalCoherenceStatistics);

//------------------------------------------------------------------------------
void vtkTemporalCoherenceStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Route: " << this->RouteName << endl;
  os << indent << "NumberOfRays: " << this->NumberOfRays << endl;
  os << indent << "NumberOfDefiniteHits: " << this->NumberOfDefiniteHits << endl;
  os << indent << "NumberOfDefiniteMisses: " << this->NumberOfDefiniteMisses << endl;
  os << indent << "NumberOfPossibleHits: " << this->NumberOfPossibleHits << endl;
  os << indent << "NumberOfTracedRays: " << this->NumberOfTracedRays << endl;
  os << indent << "NumberOfFieldSamples: " << this->NumberOfFieldSamples << endl;
  os << indent << "NumberOfLayers: " << this->NumberOfLayers << endl;
  os << indent << "NumberOfMergedLayers: " << this->NumberOfMergedLayers << endl;
  os << indent << "IsomapMemory: " << this->IsomapMemory << endl;
  os << indent << "NumberOfIsomapKnots: " << this->NumberOfIsomapKnots << endl;
  os << indent << "FrameTime: " << this->FrameTime << endl;
  os << indent << "TraceTime: " << this->TraceTime << endl;
  os << indent << "QueryTime: " << this->QueryTime << endl;
  os << indent << "IsomapBuildTime: " << this->IsomapBuildTime << endl;
  os << indent << "ShadeTime: " << this->ShadeTime << endl;
  os << indent << "PresentTime: " << this->PresentTime << endl;
  os << indent << "MeshSetUp: " << this->MeshSetUp << endl;
  os << indent << "MeshSetUpTime: " << this->MeshSetUpTime << endl;
  os << indent << "MeshMemory: " << this->MeshMemory << endl;
  os << indent << "ScalarsWereAveraged: " << this->ScalarsWereAveraged << endl;
  os << indent << "MeshPointError: " << this->MeshPointError << endl;
  os << indent << "MeshValueError: " << this->MeshValueError << endl;
}
VTK_ABI_NAMESPACE_END
