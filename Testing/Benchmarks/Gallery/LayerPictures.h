// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_LayerPictures_h
#define Gallery_LayerPictures_h

#include "FeatureScene.h"

/// Surfaces that are seen through others.
namespace LayerPictures
{

/// Skin over bone.
Shot Skull(GallerySettings& settings);

/// Sheets of fire within each other.
Shot Flames(GallerySettings& settings);

/// Vessels in a brain: two volumes.
Shot Vessels(GallerySettings& settings);

}

#endif
