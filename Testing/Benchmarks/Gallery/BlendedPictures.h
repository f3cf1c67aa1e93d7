// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_BlendedPictures_h
#define Gallery_BlendedPictures_h

#include "FeatureScene.h"
#include "GallerySettings.h"

/// Composite volumes.
namespace BlendedPictures
{

/// A tree whose leaves are translucent, and light falls on it.
Shot Tree(GallerySettings& settings);

/// A fire that glows.
Shot Fire(GallerySettings& settings);

}

#endif
