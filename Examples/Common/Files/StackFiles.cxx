// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/StackFiles.h"

#include "Files/Reading.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace
{

namespace fs = std::filesystem;

constexpr const char* Digits = "0123456789";

struct Name
{
  std::string Path;
  std::string Stem;   // all of the name but its last number
  std::string Number; // without zeros before it; empty: it has none
};

Name NameOf(const fs::path& path)
{
  const std::string suffix = path.extension().string();
  const std::string stem = path.stem().string();
  const std::size_t last = stem.find_last_of(Digits);
  if (last == std::string::npos)
  {
    return { path.string(), stem + suffix, "" };
  }
  const std::size_t before = stem.find_last_not_of(Digits, last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  const std::string number = stem.substr(first, last + 1 - first);
  return { path.string(), stem.substr(0, first) + '*' + stem.substr(last + 1) + LowerCase(suffix),
    number.substr(std::min(number.find_first_not_of('0'), number.size() - 1)) };
}

bool IsBefore(const Name& a, const Name& b)
{
  return a.Number.size() != b.Number.size() ? a.Number.size() < b.Number.size()
    : a.Number != b.Number                  ? a.Number < b.Number
                                            : a.Path < b.Path;
}

// Of numbers in their order, how many there are between them that others of them lead to expect.
double MissingIn(const std::vector<Name>& names)
{
  constexpr std::size_t MostDigits = 15; // that a number of 64 bits holds
  double step = 0.0, before = 0.0, first = 0.0;
  for (const Name& name : names)
  {
    if (name.Number.empty() || name.Number.size() > MostDigits)
    {
      return 0.0;
    }
    const double number = std::stod(name.Number);
    const bool isFirst = &name == &names.front();
    first = isFirst ? number : first;
    step = isFirst ? 0.0 : step > 0.0 ? std::min(step, number - before) : number - before;
    before = number;
  }
  return step > 0.0 ? (before - first) / step + 1.0 - static_cast<double>(names.size()) : 0.0;
}

}

bool IsPictureName(const std::string& path)
{
  const std::string name = LowerCase(path);
  return EndsWith(name, ".tif") || EndsWith(name, ".tiff") || EndsWith(name, ".png");
}

bool IsFolderOfPictures(const std::string& folder)
{
  std::error_code error;
  std::size_t pictures = 0, files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
  {
    const bool isFile = entry.is_regular_file(error);
    files += isFile ? 1 : 0;
    pictures += isFile && IsPictureName(entry.path().string()) ? 1 : 0;
  }
  return 2 * pictures > files;
}

StackFiles StackFilesOf(const std::string& path)
{
  std::error_code error;
  const bool isFolder = fs::is_directory(path, error);
  const fs::path parent = fs::path(path).parent_path();
  const fs::path folder = isFolder ? fs::path(path) : parent.empty() ? fs::path(".") : parent;
  const Name opened = NameOf(path);
  std::map<std::string, std::vector<Name>> stacks;
  std::size_t pictures = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
  {
    const std::string name = entry.path().filename().string();
    // Systems put files that begin with a dot beside others.
    if (IsPictureName(name) && name[0] != '.' && entry.is_regular_file(error))
    {
      // As the folder was named, so that messages name files as it was.
      const Name one = NameOf(parent.empty() && !isFolder ? fs::path(name) : folder / name);
      stacks[one.Stem].push_back(one);
      ++pictures;
    }
  }
  std::vector<Name> names = { opened };
  if (isFolder && !stacks.empty())
  {
    names = std::max_element(stacks.begin(), stacks.end(),
      [](const auto& a, const auto& b) {
        return a.second.size() < b.second.size();
      })->second;
  }
  else if (!isFolder && !opened.Number.empty() && stacks.count(opened.Stem) == 1)
  {
    names = stacks[opened.Stem];
  }
  std::sort(names.begin(), names.end(), IsBefore);
  StackFiles files;
  files.Missing = MissingIn(names);
  files.Others = isFolder ? pictures - std::min(pictures, names.size()) : 0;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    files.Paths.push_back(names[i].Path);
    files.Twin = i > 0 && names[i].Number == names[i - 1].Number ? names[i].Path : files.Twin;
  }
  return files;
}
