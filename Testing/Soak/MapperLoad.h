// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Soak_MapperLoad_h
#define Soak_MapperLoad_h

#include "Load.h"
#include "Walks/Sweep.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

/// Mappers that are made, draw an image by each route, and are deleted.
class MapperLoad : public Load
{
public:
  MapperLoad();
  void DoOnce() override;
  std::string Describe() const override;
  bool HasReachedAll() const override;

private:
  vtkSmartPointer<vtkImageData> Image;
  Sweep::Routes Routes;
};

#endif
