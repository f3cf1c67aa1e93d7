// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Soak_FrameLoad_h
#define Soak_FrameLoad_h

#include "Load.h"
#include "Walks/ChangingScene.h"

/// Small frames of one mapper, which meets all inputs, features and settings, and now and then is
/// stopped, asked for what it shows, or draws what another viewer sees.
class FrameLoad : public Load
{
public:
  void DoOnce() override;
  std::string Describe() const override;

  /// Every route and every feature.
  bool HasReachedAll() const override;

private:
  void Ask();

  ChangingScene Scene{ 1, 16 };
  long Frames = 0, Stopped = 0, Picked = 0;
  Sweep::Routes Routes;
  std::set<std::string> Features;
};

#endif
