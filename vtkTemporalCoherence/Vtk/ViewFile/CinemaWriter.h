// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CinemaWriter_h
#define TemporalCoherence_CinemaWriter_h

#include "Scene/Progress.h"

#include <cstdint>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Write a view file as a Cinema database of specification D: a folder with data.csv, images of
/// depths and normals for equally spaced isovalues of each view, and the file. It is made in a
/// folder beside its place, so that errors and stops leave nothing. \param folder    in UTF-8; is
/// made \param file      a view file \param isovalues how many, at least 2 \param report    called
/// with the progress; may stop it \return what went wrong, as a sentence; empty if nothing did, and
/// after a stop \throws std::bad_alloc
std::string WriteCinema(const std::string& folder, const std::vector<std::uint8_t>& file,
  int isovalues, const ReportProgress& report);

}

#endif
