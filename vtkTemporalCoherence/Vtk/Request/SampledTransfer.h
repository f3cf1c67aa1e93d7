// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SampledTransfer_h
#define TemporalCoherence_SampledTransfer_h

#include "Request/TransferNodes.h"
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

/// The values at which functions are evaluated.
struct AskedValues
{
  glm::dvec2 Range; ///< of the data
  glm::dvec2 Dense; ///< a part of it; values beyond may look like the farthest ones
  bool AreClamped;  ///< other values may occur; they are as opaque as the nearest end of the range
};

inline bool operator==(const AskedValues& a, const AskedValues& b)
{
  return a.Range == b.Range && a.Dense == b.Dense && a.AreClamped == b.AreClamped;
}

/// The colour and the opacity of one component of a property, sampled. It is sampled again when the
/// functions change, or the range of the data.
///
/// VTK's functions are evaluated at each sample, so that midpoints, sharpness, scales, colour
/// spaces and clamping have VTK's meaning. Each node has a sample if all nodes fit one grid, such
/// as integers or decimals. Otherwise samples are spread evenly.
class SampledTransfer
{
public:
  /// Take the functions of a component.
  /// \param error receives the mistake and its remedy
  /// \return false on error, for example if a node is NaN
  bool Find(vtkVolumeProperty* property, int component, std::string& error);

  /// The surroundings of nodes that lie close together, if the other nodes in a range are so far
  /// away that samples between all of them would not tell the close ones apart; else the range.
  glm::dvec2 RangeOfCloseNodes(const glm::dvec2& range) const;

  /// Sample the found functions unless known samples fit.
  const TransferFunction& Sample(const AskedValues& asked);

private:
  TransferFunction Transfer;                    ///< without nodes if out of date
  AskedValues Asked{};                          ///< of Transfer
  std::vector<double> Nodes;                    ///< of the functions
  std::optional<TransferFunctions> Functions;   ///< found functions
  vtkSmartPointer<vtkObject> Colors, Opacities; ///< own the functions
  vtkMTimeType ColorTime = 0, OpacityTime = 0;
};

}

#endif
