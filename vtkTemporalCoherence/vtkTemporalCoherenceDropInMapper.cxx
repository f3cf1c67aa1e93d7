// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceDropInMapper.h"

#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkMultiThreader.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTemporalCoherenceDropInMapper::vtkTemporalCoherenceDropInMapper()
  : NumberOfThreads(vtkMultiThreader::GetGlobalDefaultNumberOfThreads())
{
}

//------------------------------------------------------------------------------
vtkTemporalCoherenceDropInMapper::~vtkTemporalCoherenceDropInMapper() = default;

//------------------------------------------------------------------------------
int vtkTemporalCoherenceDropInMapper::IsRenderSupported(vtkRenderWindow*, vtkVolumeProperty*)
{
  return 1;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceDropInMapper::GetReductionRatio(double ratio[3])
{
  std::fill_n(ratio, 3, 1.0);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceDropInMapper::SetPartitions(
  unsigned short x, unsigned short y, unsigned short z)
{
  const unsigned short partitions[3] = { x, y, z };
  if (!std::equal(partitions, partitions + 3, this->Partitions))
  {
    std::copy_n(partitions, 3, this->Partitions);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkDataSet* vtkTemporalCoherenceDropInMapper::GetInput()
{
  return vtkDataSet::SafeDownCast(this->GetInputDataObject(0, 0));
}

//------------------------------------------------------------------------------
vtkDataSet* vtkTemporalCoherenceDropInMapper::GetInput(int port)
{
  auto* input = vtkDataSet::SafeDownCast(this->GetInputDataObject(port, 0));
  // The superclass copies the returned data set, for example in GetBoundsFromPort. It would crash
  // on null.
  return input || this->GetNumberOfInputConnections(port) == 0 ? input : this->NoDataSet.Get();
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceDropInMapper::GPURender(vtkRenderer* renderer, vtkVolume* volume)
{
  this->Render(renderer, volume);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceDropInMapper::PreRender(
  vtkRenderer*, vtkVolume*, double[6], double[2], int, unsigned int)
{
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceDropInMapper::RenderBlock(vtkRenderer*, vtkVolume*, unsigned int) {}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceDropInMapper::PostRender(vtkRenderer*, int) {}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceDropInMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RequestedRenderMode: " << this->RequestedRenderMode << endl;
  os << indent << "InterpolationMode: " << this->InterpolationMode << endl;
  os << indent << "LowResMode: " << this->LowResMode << endl;
  os << indent << "InteractiveUpdateRate: " << this->InteractiveUpdateRate << endl;
  os << indent << "InteractiveAdjustSampleDistances: " << this->InteractiveAdjustSampleDistances
     << endl;
  os << indent << "InteractiveSampleDistance: " << this->InteractiveSampleDistance << endl;
  os << indent << "IntermixIntersectingGeometry: " << this->IntermixIntersectingGeometry << endl;
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << endl;
  os << indent << "Partitions: " << this->Partitions[0] << ", " << this->Partitions[1] << ", "
     << this->Partitions[2] << endl;
}
VTK_ABI_NAMESPACE_END
