// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileListPanel_h
#define FileListPanel_h

#include "Model/FileList.h"
#include "Panels/Panel.h"

#include <functional>
#include <optional>
#include <string>

// Shows a list of files and takes keys and clicks.
class FileListPanel : public Panel
{
public:
  using Panel::Panel;

  // Throws UserError if the present directory cannot be read.
  void Open();

  // A key by its X name, a click, a turn of the wheel. What they chose to open, if they did.
  // Directories are gone to; throws UserError where one cannot be read.
  std::optional<FileList::Entry> Key(const std::string& name);
  std::optional<FileList::Entry> Click(int windowX, int windowY);
  void Scroll(int rows);

  // For scripts: the middle of each row that is seen, by name.
  void ForEachPlace(const std::function<void(const std::string& name, int x, int y)>& tell) const;

protected:
  void Draw(Canvas& canvas) override;

private:
  int VisibleRows() const;
  Rect RowAt(int row) const; // in the panel, counted from the first that is seen
  std::optional<FileList::Entry> Enter();
  void KeepSelectionInSight();

  FileList Files;
  int FirstRow = 0;
};

#endif
