// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewHeaderParts_h
#define TemporalCoherence_ViewHeaderParts_h

#include "ViewFile/ViewDescription.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <stdexcept>

namespace TemporalCoherence
{

using Json = nlohmann::json;

/// What is wrong with a header.
class WrongHeader : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// \throws WrongHeader unless it is true
void Require(bool isTrue, const char* wrong);

/// A finite number.
/// \throws WrongHeader, Json::exception
double Finite(const Json& json);

/// \throws WrongHeader, Json::exception
int WholeNumber(const Json& json, int low, int high);

/// A whole number from 0 to 2^53.
/// \throws WrongHeader, Json::exception
std::uint64_t LargeNumber(const Json& json);

/// All of a file but its views.
Json DescriptionAsJson(const ViewDescription& description);
/// \throws WrongHeader, Json::exception
void ReadDescription(const Json& json, ViewDescription& description);

/// Where the rays of a view go.
Json GeometryAsJson(const ViewGeometry& geometry);
/// \param largest side of a picture
/// \throws WrongHeader, Json::exception
void ReadGeometry(const Json& json, int largest, ViewGeometry& geometry);

}

#endif
