// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewPage_h
#define TemporalCoherence_ViewPage_h

#include "ViewFile/ViewDescription.h"

#include <cstdint>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// The page that shows a view file, with the file in it.
/// \param poster PNG file that it shows while it opens, and without scripts
/// \throws std::bad_alloc
std::vector<std::uint8_t> PageOf(const std::vector<std::uint8_t>& file,
  const std::vector<std::uint8_t>& poster, const ViewTexts& texts);

/// True if bytes begin like a page.
bool IsPage(const std::vector<std::uint8_t>& bytes);

/// The view file in a page.
/// \return what is wrong, as a sentence; empty if nothing is
std::string FileInPage(const std::vector<std::uint8_t>& page, std::vector<std::uint8_t>& file);

}

#endif
