// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/HelpPanel.h"

#include "Model/Actions.h"
#include "Model/Choices.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace
{

constexpr int LeastRowHeight = 12;

std::vector<std::pair<std::string, std::string>> AllLines(bool hasGaps)
{
  std::vector<std::pair<std::string, std::string>> lines;
  for (const Gesture& gesture : AllGestures())
  {
    lines.emplace_back(gesture.Keys, gesture.Help);
  }
  if (hasGaps)
  {
    lines.emplace_back("", "");
  }
  for (const Action& action : AllActions())
  {
    lines.emplace_back(std::string(1, action.Key), action.Help);
  }
  if (hasGaps)
  {
    lines.emplace_back("", "");
  }
  for (const Choice& choice : AllChoices())
  {
    lines.emplace_back(std::string(1, choice.Key), choice.Help);
  }
  lines.emplace_back("Shift + key", "the value before");
  return lines;
}

}

void HelpPanel::Draw(Canvas& canvas)
{
  const bool isSmall = canvas.Height() < 500;
  const auto lines = AllLines(!isSmall);
  const int padding = isSmall ? 8 : 20;
  const int head = isSmall ? 0 : 34;
  // In two columns where one is not high enough.
  const int rows = static_cast<int>(lines.size());
  const int space = canvas.Height() - 2 * padding - head;
  const int columns = rows * LeastRowHeight <= space ? 1 : 2;
  const int perColumn = (rows + columns - 1) / columns;
  const int rowHeight = std::clamp(space / perColumn, 1, 20);
  const int width = (canvas.Width() - (columns + 1) * padding) / columns;
  const int keys = columns == 1 ? 128 : std::min(118, width * 2 / 5);

  canvas.Clear(Theme::Raised);
  canvas.Frame({ 0, 0, canvas.Width(), canvas.Height() }, Theme::Line);
  if (head > 0)
  {
    canvas.Write(padding, padding - 4, 24, "Mouse and keys", LargeFont(), Theme::Text);
  }
  for (int i = 0; i < rows; ++i)
  {
    const int x = padding + (i / perColumn) * (width + padding);
    const int y = padding + head + (i % perColumn) * rowHeight;
    const auto& [key, help] = lines[static_cast<std::size_t>(i)];
    canvas.Write(x, y, rowHeight, SmallFont().Shortened(key, keys - 6), SmallFont(), Theme::Accent);
    canvas.Write(
      x + keys, y, rowHeight, SmallFont().Shortened(help, width - keys), SmallFont(), Theme::Text);
  }
}
