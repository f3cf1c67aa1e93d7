// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileList_h
#define FileList_h

#include <filesystem>
#include <string>
#include <vector>

// The volumes, sessions and directories in a directory, one of them selected.
class FileList
{
public:
  struct Entry
  {
    std::string Label;
    std::filesystem::path Path;
    bool IsDirectory = false; // to go to; a DICOM series is a volume
  };

  // Throws UserError if the directory cannot be read; the list stays then.
  void Go(const std::filesystem::path& directory);

  const std::filesystem::path& Directory() const { return this->Where; }
  const std::vector<Entry>& Entries() const { return this->Found; }
  int Selected() const { return this->Selection; }
  void Select(int entry);

private:
  std::filesystem::path Where;
  std::vector<Entry> Found;
  int Selection = 0;
};

#endif
