// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HelpPanel_h
#define HelpPanel_h

#include "Panels/Panel.h"

// All keys and what they do.
class HelpPanel : public Panel
{
public:
  using Panel::Panel;

protected:
  void Draw(Canvas& canvas) override;
};

#endif
