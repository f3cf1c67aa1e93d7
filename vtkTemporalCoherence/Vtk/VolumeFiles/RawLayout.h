// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RawLayout_h
#define TemporalCoherence_RawLayout_h

#include "Scene/ScalarType.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>

namespace TemporalCoherence
{

/// How samples lie in a file: x fastest, without gaps.
struct RawLayout
{
  ScalarType Type = ScalarType::UInt8;
  glm::ivec3 Dimensions{ 0 };
  glm::dvec3 Spacing{ 1.0 };
  glm::dvec3 Origin{ 0.0 };
  std::uint64_t Offset = 0; ///< bytes before the first sample
  bool IsBigEndian = false; ///< the byte order of samples in the file
};

/// Bytes of all samples.
/// \return false if `dimensions` are not positive, or the number of bytes is beyond the range of
///         signed 64-bit integers, in which systems count bytes
bool BytesOf(const glm::ivec3& dimensions, ScalarType type, std::uint64_t& bytes);

/// Check dimensions, spacing and origin.
/// \param path  names the file in the error
/// \param error receives what is wrong and what to do, in one sentence
bool CheckLayout(const std::string& path, const RawLayout& layout, std::string& error);

/// Dimensions in messages: "3 x 4 x 5".
std::string TextOf(const glm::ivec3& dimensions);

}

#endif
