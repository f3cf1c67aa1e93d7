// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/FileListPanel.h"

#include <algorithm>
#include <map>

namespace
{

constexpr int HeadHeight = 52;
constexpr int FootHeight = 30;
constexpr int RowHeight = 22;

}

void FileListPanel::Open()
{
  this->Files.Go(this->Files.Directory().empty() ? "." : this->Files.Directory());
  this->FirstRow = 0;
  this->KeepSelectionInSight();
  this->SetVisible(true);
}

int FileListPanel::VisibleRows() const
{
  return std::max((this->Placed().Height - HeadHeight - FootHeight) / RowHeight, 1);
}

Rect FileListPanel::RowAt(int row) const
{
  return { 8, HeadHeight + row * RowHeight, this->Placed().Width - 16, RowHeight };
}

void FileListPanel::KeepSelectionInSight()
{
  const int selected = this->Files.Selected();
  this->FirstRow =
    std::clamp(this->FirstRow, std::max(selected - this->VisibleRows() + 1, 0), selected);
  this->Invalidate();
}

std::optional<FileList::Entry> FileListPanel::Enter()
{
  if (this->Files.Entries().empty())
  {
    return std::nullopt;
  }
  const FileList::Entry entry =
    this->Files.Entries()[static_cast<std::size_t>(this->Files.Selected())];
  if (!entry.IsDirectory)
  {
    return entry;
  }
  this->Files.Go(entry.Path);
  this->FirstRow = 0;
  this->KeepSelectionInSight();
  return std::nullopt;
}

std::optional<FileList::Entry> FileListPanel::Key(const std::string& name)
{
  const int page = this->VisibleRows() - 1;
  const int last = static_cast<int>(this->Files.Entries().size());
  const std::map<std::string, int> steps = { { "Up", -1 }, { "Down", 1 }, { "Prior", -page },
    { "Next", page }, { "Home", -last }, { "End", last } };
  if (name == "Return" || name == "KP_Enter")
  {
    return this->Enter();
  }
  if (name == "BackSpace")
  {
    this->Files.Go(this->Files.Directory() / "..");
  }
  else if (steps.count(name) == 1)
  {
    this->Files.Select(this->Files.Selected() + steps.at(name));
  }
  this->KeepSelectionInSight();
  return std::nullopt;
}

std::optional<FileList::Entry> FileListPanel::Click(int windowX, int windowY)
{
  const int x = windowX - this->Placed().X;
  const int y = windowY - this->Placed().Y;
  for (int row = 0; row < this->VisibleRows(); ++row)
  {
    const int entry = this->FirstRow + row;
    if (this->RowAt(row).Contains(x, y) && entry < static_cast<int>(this->Files.Entries().size()))
    {
      this->Files.Select(entry);
      this->Invalidate();
      return this->Enter();
    }
  }
  return std::nullopt;
}

void FileListPanel::ForEachPlace(
  const std::function<void(const std::string& name, int x, int y)>& tell) const
{
  const int count = static_cast<int>(this->Files.Entries().size());
  for (int row = 0; row < std::min(this->VisibleRows(), count - this->FirstRow); ++row)
  {
    const Rect area = this->RowAt(row);
    tell(this->Files.Entries()[static_cast<std::size_t>(this->FirstRow + row)].Label,
      this->Placed().X + area.X + area.Width / 2, this->Placed().Y + area.Y + area.Height / 2);
  }
}

void FileListPanel::Scroll(int rows)
{
  const int most = static_cast<int>(this->Files.Entries().size()) - this->VisibleRows();
  this->FirstRow = std::clamp(this->FirstRow + rows, 0, std::max(most, 0));
  this->Invalidate();
}

void FileListPanel::Draw(Canvas& canvas)
{
  const int width = canvas.Width() - 2 * Theme::Margin;
  canvas.Clear(Theme::Raised);
  canvas.Frame({ 0, 0, canvas.Width(), canvas.Height() }, Theme::Line);
  canvas.Write(Theme::Margin, 6, 24, "Open", BoldFont(), Theme::Text);
  canvas.Write(Theme::Margin, 27, 18,
    SmallFont().Shortened(this->Files.Directory().string(), width), SmallFont(), Theme::Quiet);
  const std::vector<FileList::Entry>& entries = this->Files.Entries();
  for (int row = 0; row < this->VisibleRows(); ++row)
  {
    const int entry = this->FirstRow + row;
    if (entry >= static_cast<int>(entries.size()))
    {
      break;
    }
    const Rect area = this->RowAt(row);
    const bool isSelected = entry == this->Files.Selected();
    canvas.Fill(area, isSelected ? Theme::Line : Theme::Raised);
    const FileList::Entry& shown = entries[static_cast<std::size_t>(entry)];
    canvas.Write(area.X + 8, area.Y, area.Height,
      NormalFont().Shortened(shown.Label, area.Width - 16), NormalFont(),
      shown.IsDirectory ? Theme::Accent : Theme::Text);
  }
  canvas.Write(Theme::Margin, canvas.Height() - FootHeight + 4, 20,
    SmallFont().Shortened("Enter or a click opens; Escape closes", width), SmallFont(),
    Theme::Quiet);
}
