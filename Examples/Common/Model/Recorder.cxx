// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Recorder.h"

#include "View/Picture.h"

#include <cstdio>
#include <filesystem>

namespace
{

namespace fs = std::filesystem;

constexpr int Rate = 25; // pictures a second
const char* const Remedy = "name another directory with --output";

std::string Numbered(const std::string& before, int number, const std::string& after)
{
  char digits[16];
  std::snprintf(digits, sizeof(digits), "%04d", number);
  return before + digits + after;
}

fs::path FirstFree(const fs::path& directory, const std::string& before, const std::string& after)
{
  std::error_code error;
  fs::create_directories(directory, error);
  int number = 1;
  while (fs::exists(directory / Numbered(before, number, after), error))
  {
    ++number;
  }
  return (directory / Numbered(before, number, after)).lexically_normal();
}

}

Recorder::Recorder(const std::string& directory)
  : Directory(directory)
{
}

std::string Recorder::NextPath() const
{
  return FirstFree(this->Directory, "explorer-", ".png").string();
}

std::string Recorder::Save(vtkImageData* picture)
{
  const std::string path = this->NextPath();
  WritePng(picture, path, Remedy);
  return path;
}

void Recorder::Start(const std::string& format)
{
  const std::string end = format == "png" ? "" : ".ogv";
  this->Target.emplace(FirstFree(this->Directory, "recording-", end), Rate, Remedy);
  this->IsOn = true;
}

void Recorder::Add(vtkImageData* picture)
{
  this->IsOn = false; // a recording that fails ends
  this->Target->Add(picture);
  this->IsOn = true;
}

std::string Recorder::Stop()
{
  this->IsOn = false;
  this->Target->End();
  return "Recorded " + std::to_string(this->Target->NumberOfPictures()) +
    " frames: " + this->Target->Path().string();
}
