// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Stopper_h
#define Testing_Stopper_h

#include "vtkTemporalCoherenceVolumeMapper.h"

#include <vtkCommand.h>

/// Asks a mapper's next frame to stop at one of its reports.
class Stopper
{
public:
  Stopper(vtkTemporalCoherenceVolumeMapper* mapper, int report)
    : Of(mapper)
    , Left(report)
    , Tag(
        mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, this, &Stopper::CountDown))
  {
  }
  ~Stopper()
  {
    this->Of->RemoveObserver(this->Tag);
    this->Of->SetAbortExecute(0);
  }
  Stopper(const Stopper&) = delete;
  Stopper& operator=(const Stopper&) = delete;

private:
  void CountDown()
  {
    if (this->Left-- == 0)
    {
      this->Of->SetAbortExecute(1);
    }
  }

  vtkTemporalCoherenceVolumeMapper* Of;
  int Left;
  unsigned long Tag;
};

#endif
