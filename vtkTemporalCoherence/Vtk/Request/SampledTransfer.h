// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampledTransfer_h
#define TemporalCoherence_SampledTransfer_h

#include "Request/TransferNodes.h"
#include "Request/TransferSamples.h"
#include "Scene/Blending.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkObject.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The colour and the opacity of one component of a property, sampled. It is sampled again when the
/// functions change, or the range of the data.
///
/// The functions themselves are asked at each sample, so that midpoints, sharpness, scales, spaces
/// of colours and clamping have VTK's meaning. There is a sample at each node if all nodes have
/// places in one grid, such as integers or decimals.
class SampledTransfer
{
public:
  /// Look at the functions of a component.
  /// \param error gets what is wrong and what to do about it
  /// \return false on error, for example if a node is NaN
  bool Find(vtkVolumeProperty* property, int component, std::string& error);

  /// Sample what was found, unless that was done before.
  const TransferFunction& Sample(const AskedValues& asked);

private:
  TransferFunction Transfer;                    ///< without nodes if it is out of date
  AskedValues Asked{};                          ///< of Transfer
  std::vector<double> Nodes;                    ///< of the functions
  std::optional<TransferFunctions> Functions;   ///< that were found
  vtkSmartPointer<vtkObject> Colors, Opacities; ///< keep them
  vtkMTimeType ColorTime = 0, OpacityTime = 0;
};

}

#endif
