// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Infinity_h
#define Testing_Infinity_h

#include <limits>

inline constexpr double Infinity = std::numeric_limits<double>::infinity();

#endif
