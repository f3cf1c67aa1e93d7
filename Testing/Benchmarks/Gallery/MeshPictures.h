// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_MeshPictures_h
#define Gallery_MeshPictures_h

#include "FeatureScene.h"

/// Irregular grids.
namespace MeshPictures
{

/// Hexahedra of a reactor, in an unstructured grid.
Shot Unstructured(GallerySettings& settings);

/// Air flow at a fin, in a curvilinear grid.
Shot Curvilinear(GallerySettings& settings);

}

#endif
