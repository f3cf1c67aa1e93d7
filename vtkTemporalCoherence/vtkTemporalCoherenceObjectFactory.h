// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceObjectFactory
 * @brief   makes vtkTemporalCoherenceGPUVolumeRayCastMapper where vtkGPUVolumeRayCastMapper is made
 *
 * After UseEverywhere() every vtkGPUVolumeRayCastMapper that is made, by the program or by
 * vtkSmartVolumeMapper and vtkMultiBlockVolumeMapper, draws isosurfaces by
 * vtkTemporalCoherenceVolumeMapper, and all the rest as ever. Those that were made before stay what
 * they are.
 *
 * A program that is not rebuilt gets the same by the environment variable VTK_AUTOLOAD_PATH. It
 * names the directory vtkTemporalCoherence/autoload beside the library of this module.
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
   * Ask a factory of this class before all others that are there, or none of this class any more;
   * and whether there is one. Calls that change nothing do no harm.
   */
  static void UseEverywhere();
  static void UseNowhere();
  static bool IsUsed();
  //@}

  //@{
  /**
   * The version of VTK that the factory was built with, and what it is, in words.
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
