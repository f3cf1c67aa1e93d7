// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MessagePanel_h
#define MessagePanel_h

#include "Panels/Panel.h"

#include <string>
#include <vector>

// A sentence on the view, as large as it needs to be: what was done, or what went wrong.
class MessagePanel : public Panel
{
public:
  using Panel::Panel;

  void Say(const std::string& sentence, bool isWarning);
  void Clear();
  bool HasMessage() const { return !this->Sentence.empty(); }

  // Lies at the upper left of the space.
  void Fit(const Rect& space, int windowHeight);

protected:
  void Draw(Canvas& canvas) override;

private:
  std::string Sentence;
  bool IsWarning = false;
  std::vector<std::string> Lines;
};

#endif
