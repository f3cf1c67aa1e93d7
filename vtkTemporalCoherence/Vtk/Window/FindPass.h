// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FindPass_h
#define TemporalCoherence_FindPass_h

#include <vtkInformation.h>
#include <vtkInformationObjectBaseVectorKey.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkProp.h>

namespace TemporalCoherence
{

/// The render pass of a class that is drawing a prop now, or null.
template <typename Pass>
Pass* FindPass(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  auto* const passes = vtkOpenGLRenderPass::RenderPasses();
  if (keys && keys->Has(passes))
  {
    for (int i = 0; i < passes->Length(keys); ++i)
    {
      if (auto* pass = Pass::SafeDownCast(passes->Get(keys, i)))
      {
        return pass;
      }
    }
  }
  return nullptr;
}

}

#endif
