// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceObjectFactory
 * @brief   creates vtkTemporalCoherenceGPUVolumeRayCastMapper for vtkGPUVolumeRayCastMapper
 *
 * After UseEverywhere(), vtkGPUVolumeRayCastMapper::New() creates a
 * vtkTemporalCoherenceGPUVolumeRayCastMapper, also inside vtkSmartVolumeMapper and
 * vtkMultiBlockVolumeMapper. With vtkTemporalCoherenceVolumeMapper it draws isosurfaces and, where
 * OpenGL has no GPU, blended volumes for which VTK's mapper should need more time. It draws
 * everything else as before. Existing mappers do not change.
 *
 * A program that is not rebuilt can load this factory by the environment variable
 * VTK_AUTOLOAD_PATH. Set it to the directory vtkTemporalCoherence/autoload beside the library of
 * this module.
 *
 * @sa vtkTemporalCoherenceGPUVolumeRayCastMapper vtkObjectFactory
 */

#ifndef vtkTemporalCoherenceObjectFactory_h
#define vtkTemporalCoherenceObjectFactory_h

#include "vtkObjectFactory.h"
#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro

#ifndef VTK_FUTURE_CONST
#define VTK_FUTURE_CONST
#endif

VTK_ABI_NAMESPACE_BEGIN
class VTKTEMPORALCOHERENCE_EXPORT vtkTemporalCoherenceObjectFactory : public vtkObjectFactory
{
public:
  static vtkTemporalCoherenceObjectFactory* New();
  vtkTypeMacro(vtkTemporalCoherenceObjectFactory, vtkObjectFactory);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Register a factory of this class before all others, unregister it, or ask whether one is
   * registered. Repeated calls have no effect.
   */
  static void UseEverywhere();
  static void UseNowhere();
  static bool IsUsed();
  //@}

  //@{
  /**
   * Get the version of VTK that the factory was built with, and a description of the factory.
   */
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override;
  const char* GetDescription() VTK_FUTURE_CONST override;
  //@}

protected:
  vtkTemporalCoherenceObjectFactory();
  ~vtkTemporalCoherenceObjectFactory() override;

private:
  vtkTemporalCoherenceObjectFactory(const vtkTemporalCoherenceObjectFactory&) = delete;
  void operator=(const vtkTemporalCoherenceObjectFactory&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
