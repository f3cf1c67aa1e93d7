// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VtkTests_ChangedScene_h
#define VtkTests_ChangedScene_h

#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>

#include <string>

/// A factory whose renderers change the volumes of a test that knows nothing of it, while they
/// draw.
///
/// \param change what is drawn instead of the volumes:
///   "hidden"             nothing
///   "polygons"           the isosurfaces that their properties ask for, as polygons
///   "surfaces"           one opaque isosurface, in the middle of the range of the samples
///   "surfaces-polygons"  the same as polygons
vtkSmartPointer<vtkObjectFactory> MakeFactoryOfChangedScenes(const std::string& change);

#endif
