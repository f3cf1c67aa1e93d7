// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_DrawnVolume_h
#define TemporalCoherence_DrawnVolume_h

#include "vtkTemporalCoherenceCompatibility.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// A mapper, and the volume and renderer that it draws for.
struct DrawnVolume
{
  vtkVolumeMapper* Mapper;
  vtkVolume* Volume;
  vtkRenderer* Renderer;
};

/// True if settings may be meant for more data than the mapper's input: for a piece of a pipeline's
/// data, for one block of several, and if several volumes share the property. Reads ghost arrays,
/// which takes a while.
bool MaySeePartOnly(const DrawnVolume& drawn);

}

#endif
