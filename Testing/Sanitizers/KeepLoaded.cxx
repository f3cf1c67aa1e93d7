// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A library to preload: no library is unloaded before a program ends.
//
// Drivers of OpenGL are loaded and unloaded at run time. When leaks are looked for they are gone,
// and so is what pointed to memory that they still hold: it would be reported, without a name.

extern "C" __attribute__((visibility("default"))) int dlclose(void*)
{
  return 0;
}
