// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMSurfaceRangeDomain
 * @brief   the range of the array whose isosurfaces are drawn
 *
 * That is the array of the required property SurfaceArraySelection or, where it names none,
 * ArraySelection, as of vtkSMArrayRangeDomain.
 */

#ifndef vtkSMSurfaceRangeDomain_h
#define vtkSMSurfaceRangeDomain_h

#include "vtkSMArrayRangeDomain.h"

class vtkSMSurfaceRangeDomain : public vtkSMArrayRangeDomain
{
public:
  static vtkSMSurfaceRangeDomain* New();
  vtkTypeMacro(vtkSMSurfaceRangeDomain, vtkSMArrayRangeDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Update(vtkSMProperty* property) override;

protected:
  vtkSMSurfaceRangeDomain();
  ~vtkSMSurfaceRangeDomain() override;

private:
  vtkSMSurfaceRangeDomain(const vtkSMSurfaceRangeDomain&) = delete;
  void operator=(const vtkSMSurfaceRangeDomain&) = delete;
};

#endif
