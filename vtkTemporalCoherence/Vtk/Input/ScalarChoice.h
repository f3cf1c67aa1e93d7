// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ScalarChoice_h
#define TemporalCoherence_ScalarChoice_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSet;
class vtkVolumeMapper;
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The array chosen by the user of a mapper: scalar mode and, for field data, name or number.
struct ScalarChoice
{
  int Mode = 0; ///< VTK_SCALAR_MODE_...
  bool IsByName = false;
  int Number = -1;
  std::string Name;
};

ScalarChoice ChoiceOf(vtkVolumeMapper* mapper);

/// An array that gives surfaces their colours.
struct ArrayChoice
{
  bool IsAsked() const { return !this->Name.empty(); }

  /// Its array, as a choice of scalars.
  ScalarChoice Scalars() const;

  /// Components to read: lengths of vectors need all.
  std::vector<int> ComponentsOf(vtkDataArray* array) const;

  std::string Name;     ///< empty: none
  bool OnCells = false; ///< one tuple for each cell, otherwise for each point
  int Component = 0;    ///< below 0: the length of vectors
};

/// The error message if some data lack a chosen array.
std::string WhyThereIsNoArray(const ArrayChoice& choice);

/// The array of a data set for a choice.
struct ChosenScalars
{
  vtkDataArray* Array = nullptr; ///< null if there is none
  bool OnCells = false;
};

ChosenScalars FindScalars(vtkDataSet* dataSet, const ScalarChoice& choice);

/// Resolve the default scalar mode for all data sets alike: points if any has scalars there, else
/// cells.
ScalarChoice ChoiceForAll(const std::vector<vtkDataSet*>& dataSets, const ScalarChoice& choice);

/// True if arrays of cells are chosen.
/// \pre the mode is not the default, which depends on the data
bool IsOnCells(const ScalarChoice& choice);

/// The user's choice of a scalar for arrays with several components.
struct VectorChoice
{
  enum class Modes
  {
    Property, ///< as the volume's property treats components
    Magnitude,
    Component
  };

  Modes Mode = Modes::Property;
  int Component = 0;
  bool AreBlended = false; ///< Property: all components are drawn, not just one
};

/// The drawn scalar of an array's tuples.
struct DrawnComponent
{
  /// A number that identifies the scalar, even for components that no array has.
  double Key() const { return this->IsMagnitude ? 0.5 : this->Number; }

  bool IsMagnitude = false; ///< the length of each tuple
  int Number = 0;           ///< of the component, which the array may lack
  int OfProperty = 0;       ///< component of the property that gives colour and shading
  int Count = 1;            ///< number of drawn components, from Number on
};

/// \param components of the array; 0 without an array
DrawnComponent ChooseComponent(
  vtkVolumeProperty* property, const VectorChoice& vectors, int components);

/// The error message if there are no scalars for a choice.
std::string WhyThereAreNoScalars(const ScalarChoice& choice);

}

#endif
