// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VtkTests_TestDriver_h
#define VtkTests_TestDriver_h

/// Run a test of VTK's as VTK's own driver does: it may look at its arguments, interactors take no
/// part, and its picture is written to the directory after -T under the name of the file after -V,
/// which is not there.
///
/// The environment variable VTK_TESTS_SCENE changes what is drawn: see ChangedScene.h.
int DriveTest(int argc, char* argv[], int (*test)(int, char*[]));

#endif
