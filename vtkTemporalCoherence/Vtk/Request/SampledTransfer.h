// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampledTransfer_h
#define TemporalCoherence_SampledTransfer_h

#include "Scene/Blending.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkObject.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The colour and the opacity of one component of a property, sampled. It is sampled again when the
/// functions change.
///
/// The functions themselves are asked at each sample, so that midpoints, sharpness, scales, spaces
/// of colours and clamping have VTK's meaning. There is a sample at each node if all nodes have
/// places in one grid, such as integers or decimals.
class SampledTransfer
{
public:
  /// Sample the functions of a component, unless they are as they were.
  /// \param error gets what is wrong and what to do about it
  /// \return false on error, for example if a node is NaN
  bool Sample(vtkVolumeProperty* property, int component, std::string& error);

  const TransferFunction& Made() const { return this->Transfer; }

private:
  TransferFunction Transfer;
  vtkSmartPointer<vtkObject> Colors, Opacities; ///< the functions that were sampled
  vtkMTimeType ColorTime = 0, OpacityTime = 0;
};

}

#endif
