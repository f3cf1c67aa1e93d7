// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_FeaturePictures_h
#define Gallery_FeaturePictures_h

#include "GallerySettings.h"

/// What the mapper can show, each feature on a volume that has something to show with it.
namespace FeaturePictures
{

/// Of all pictures.
std::vector<std::string> Names();

/// Write a picture of each feature, and print them as a page of Markdown.
void Make(GallerySettings& settings, JsonWriter& json);

}

#endif
