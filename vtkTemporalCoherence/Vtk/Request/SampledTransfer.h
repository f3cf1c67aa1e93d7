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
  /// Take functions.
  /// \param error receives the mistake and its remedy
  /// \return false on error, for example if a node is NaN
  bool Find(const TransferFunctions& functions, std::string& error);

  /// Take a mixture of functions, as VTK's masks mix: others that have no opacity count as black.
  /// \param share of the functions; the rest is that of the others
  bool FindMixture(const TransferFunctions& functions, double share,
    const TransferFunctions& others, std::string& error);

  /// Sample the found functions unless known samples fit.
  const TransferFunction& Sample(const AskedValues& asked);

  /// Sample the found functions for the values of a field.
  /// \param range            of the values
  /// \param mayLeaveOutRare  far values that hardly any sample has may look alike
  const TransferFunction& SampleFor(
    const Field& field, const glm::dvec2& range, bool mayLeaveOutRare = true);

private:
  glm::dvec2 RangeOfCloseNodes(const glm::dvec2& range) const;

  /// Functions that were found.
  struct Found
  {
    explicit Found(const TransferFunctions& functions);
    bool operator==(const Found& other) const;

    TransferFunctions Functions;
    vtkSmartPointer<vtkObject> Colors, Opacities; ///< own the functions
    vtkMTimeType ColorTime = 0, OpacityTime = 0;
  };

  bool Find(const std::vector<Found>& sources, double share, std::string& error);

  TransferFunction Transfer;  ///< without nodes if out of date
  AskedValues Asked{};        ///< of Transfer
  std::vector<double> Nodes;  ///< of all functions
  std::vector<Found> Sources; ///< the functions and, in a mixture, the others
  double Share = 1.0;         ///< of the functions
};

}

#endif
