// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SoftwareOpenGL_h
#define TemporalCoherence_SoftwareOpenGL_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// True if the name of an OpenGL renderer is that of a rasteriser that runs on the CPU.
bool IsSoftwareRenderer(const std::string& name);

/// True if the OpenGL of a window, whose context is current, runs on the CPU. Takes a while.
bool HasSoftwareOpenGL(vtkRenderWindow* window);

}

#endif
