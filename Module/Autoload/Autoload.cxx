// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What VTK looks for in the libraries of VTK_AUTOLOAD_PATH; and, where the library is preloaded,
// what is called instead of VTK's own.
#include "vtkTemporalCoherenceGPUVolumeRayCastMapper.h"
#include "vtkTemporalCoherenceObjectFactory.h"

#include "vtkVersion.h"

// As VTK_FACTORY_INTERFACE_IMPLEMENT does, which however gives VTK a factory to ask last: when this
// library is loaded, so is VTK's module with the mapper, and its factory is registered already.
extern "C" VTK_FACTORY_INTERFACE_EXPORT const char* vtkGetFactoryVersion();
extern "C" VTK_FACTORY_INTERFACE_EXPORT vtkObjectFactory* vtkLoad();

const char* vtkGetFactoryVersion()
{
  return VTK_SOURCE_VERSION;
}

VTK_ABI_NAMESPACE_BEGIN
// VTK's own asks no factory. Where LD_PRELOAD names this library the dynamic linker takes this one
// for both; else nobody calls it.
vtkOpenGLGPUVolumeRayCastMapper* vtkOpenGLGPUVolumeRayCastMapper::New()
{
  return vtkTemporalCoherenceGPUVolumeRayCastMapper::New();
}
VTK_ABI_NAMESPACE_END

vtkObjectFactory* vtkLoad()
{
  vtkTemporalCoherenceObjectFactory::UseEverywhere();
  return vtkTemporalCoherenceObjectFactory::New(); // VTK insists on one, which is never asked
}
