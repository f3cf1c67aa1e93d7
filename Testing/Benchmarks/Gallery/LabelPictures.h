// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_LabelPictures_h
#define Gallery_LabelPictures_h

#include "FeatureScene.h"
#include "GallerySettings.h"

/// Labels of segmentations, and colours of another array.
namespace LabelPictures
{

/// The organs of an animal.
Shot Organs(GallerySettings& settings);

/// Surfaces of a temperature in the colours of the methane on them.
Shot Methane(GallerySettings& settings);

}

#endif
