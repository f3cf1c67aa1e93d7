// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FileFacts_h
#define TemporalCoherence_FileFacts_h

#include <string>

namespace TemporalCoherence
{

/// The name, the size and the modification time of a file, in one line. A file that cannot be
/// examined gives its name alone.
std::string FileFacts(const std::string& path);

}

#endif
