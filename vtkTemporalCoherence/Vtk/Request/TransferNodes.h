// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TransferNodes_h
#define TemporalCoherence_TransferNodes_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkColorTransferFunction;
class vtkObject;
class vtkPiecewiseFunction;
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The functions of values of a component, or of a label of a mask. The pointers are not owned.
struct TransferFunctions
{
  TransferFunctions(vtkVolumeProperty* property, int component);

  /// The functions of a label above 0. Functions that it lacks are the component's.
  TransferFunctions(vtkVolumeProperty* property, int component, int label);

  vtkObject* Colors() const;

  vtkColorTransferFunction* Color = nullptr; ///< or null
  vtkPiecewiseFunction* Gray = nullptr;      ///< used if Color is null
  vtkPiecewiseFunction* Opacity = nullptr;
  int LabelOfColor = 0, LabelOfOpacity = 0; ///< whose functions they are; 0: the component's
};

/// Find the values at which functions have nodes: ascending, each once. Without nodes, {0}.
/// \param error receives the mistake and its remedy
/// \return false on error, for example if a colour is NaN
bool FindNodes(const TransferFunctions& functions, std::vector<double>& nodes, std::string& error);

/// The longest step that divides all distances between neighbouring nodes into whole steps, and
/// covers a range in at most `most` steps; 0 if no such step is found.
/// \param nodes ascending
/// \param width of the range
double CommonStep(const std::vector<double>& nodes, double width, double most);

}

#endif
