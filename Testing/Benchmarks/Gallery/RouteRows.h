// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_RouteRows_h
#define Gallery_RouteRows_h

#include "GallerySettings.h"

/// Every way in which a frame is made: its picture, the rays it had to trace, its time.
namespace RouteRows
{

/// Write a picture of each route, and print them as a table.
void Make(GallerySettings& settings, JsonWriter& json);

}

#endif
