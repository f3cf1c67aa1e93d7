// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What VTK looks for in the libraries of VTK_AUTOLOAD_PATH.
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

vtkObjectFactory* vtkLoad()
{
  vtkTemporalCoherenceObjectFactory::UseEverywhere();
  return vtkTemporalCoherenceObjectFactory::New(); // VTK insists on one, which is never asked
}
