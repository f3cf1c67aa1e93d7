// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Soak_WindowLoad_h
#define Soak_WindowLoad_h

#include "Load.h"

#include <vtkImageData.h>
#include <vtkProp.h>
#include <vtkSmartPointer.h>

class vtkRenderer;

/// Windows that are opened, drawn in and closed. Each shows a volume of its own and one that was in
/// all the windows before.
class WindowLoad : public Load
{
public:
  /// What windows show.
  enum Contents
  {
    Ours,
    OfVtk ///< vtkFixedPointVolumeRayCastMapper's, to compare with: what grows is not ours
  };
  explicit WindowLoad(Contents contents);
  void DoOnce() override;
  std::string Describe() const override;
  bool HasReachedAll() const override { return this->Windows > 0 && this->Drawn == this->Windows; }

private:
  void AddProps(vtkRenderer* renderer);

  const Contents Shown;
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkProp> Always;
  long Windows = 0, Drawn = 0;
};

#endif
