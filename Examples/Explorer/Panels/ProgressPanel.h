// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ProgressPanel_h
#define ProgressPanel_h

#include "Panels/Panel.h"

#include <string>

// How far something is that takes long.
class ProgressPanel : public Panel
{
public:
  using Panel::Panel;

  void Show(const std::string& what, double share);

protected:
  void Draw(Canvas& canvas) override;

private:
  std::string What;
  double Share = 0.0;
};

#endif
