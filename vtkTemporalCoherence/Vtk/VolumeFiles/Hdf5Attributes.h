// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Hdf5Attributes_h
#define TemporalCoherence_Hdf5Attributes_h

#include "VolumeFiles/Hdf5Library.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Read a number from an attribute that holds its digits: a text, or an array of single characters
/// as in Imaris files. Needs an Hdf5Turn.
/// \param object    name of the group with the attribute
/// \param attribute name of the attribute
/// \return false if there is none, or if it is no finite number
bool ReadNumber(
  const Hdf5File& file, const std::string& object, const std::string& attribute, double& number);

/// Read a data set of rows of three numbers, as BigDataViewer stores factors. Needs an Hdf5Turn.
/// \param most rows that are read at most
/// \return false if there is none, or if it has another shape or too many rows
bool ReadTriples(
  const Hdf5File& file, const std::string& name, std::size_t most, std::vector<glm::dvec3>& rows);

}

#endif
