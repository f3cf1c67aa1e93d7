// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceObjectFactory.h"

#include "vtkTemporalCoherenceGPUVolumeRayCastMapper.h"

#include "vtkNew.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTemporalCoherenceObjectFactory);

namespace
{

VTK_CREATE_CREATE_FUNCTION(vtkTemporalCoherenceGPUVolumeRayCastMapper)

vtkTemporalCoherenceObjectFactory* FindRegistered()
{
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  for (int i = 0; i < factories->GetNumberOfItems(); ++i)
  {
    if (auto* factory =
          vtkTemporalCoherenceObjectFactory::SafeDownCast(factories->GetItemAsObject(i)))
    {
      return factory;
    }
  }
  return nullptr;
}

}

//------------------------------------------------------------------------------
vtkTemporalCoherenceObjectFactory::vtkTemporalCoherenceObjectFactory()
{
  this->RegisterOverride("vtkGPUVolumeRayCastMapper", "vtkTemporalCoherenceGPUVolumeRayCastMapper",
    "Isosurfaces and, without a GPU, blended volumes by temporal coherence; all else by OpenGL", 1,
    vtkObjectFactoryCreatevtkTemporalCoherenceGPUVolumeRayCastMapper);
}

//------------------------------------------------------------------------------
vtkTemporalCoherenceObjectFactory::~vtkTemporalCoherenceObjectFactory() = default;

//------------------------------------------------------------------------------
void vtkTemporalCoherenceObjectFactory::UseEverywhere()
{
  if (IsUsed())
  {
    return;
  }
  vtkNew<vtkTemporalCoherenceObjectFactory> factory;
  vtkObjectFactory::RegisterFactory(factory);
  // VTK asks the first factory that has an override, and its own factory is already registered.
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  if (factories->GetNumberOfItems() > 1) // an empty list allows no insertion
  {
    factories->RemoveItem(factory);
    factories->InsertItem(-1, factory);
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceObjectFactory::UseNowhere()
{
  while (vtkTemporalCoherenceObjectFactory* factory = FindRegistered())
  {
    vtkObjectFactory::UnRegisterFactory(factory);
  }
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceObjectFactory::IsUsed()
{
  return FindRegistered() != nullptr;
}

//------------------------------------------------------------------------------
const char* vtkTemporalCoherenceObjectFactory::GetVTKSourceVersion() VTK_FUTURE_CONST
{
  return VTK_SOURCE_VERSION;
}

//------------------------------------------------------------------------------
const char* vtkTemporalCoherenceObjectFactory::GetDescription() VTK_FUTURE_CONST
{
  return "vtkTemporalCoherence: pictures of volumes that re-use the last frame";
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceObjectFactory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
VTK_ABI_NAMESPACE_END
