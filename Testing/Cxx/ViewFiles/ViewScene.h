// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ViewScene_h
#define Testing_ViewScene_h

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "vtkTemporalCoherenceView.h"
#include "vtkTemporalCoherenceViewWriter.h"

#include <vtkCommand.h>
#include <vtkTestErrorObserver.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <system_error>

/// A folder that is removed at the end of a test.
class ScratchFolder
{
public:
  ScratchFolder()
    : Root(std::filesystem::temp_directory_path() /
        ("views-" + std::to_string(std::random_device()())))
  {
    std::filesystem::create_directories(this->Root);
  }
  ~ScratchFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Root, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string operator/(const std::string& name) const { return (this->Root / name).u8string(); }

  /// How many files and folders it holds.
  std::size_t Count() const
  {
    return static_cast<std::size_t>(
      std::distance(std::filesystem::recursive_directory_iterator(this->Root),
        std::filesystem::recursive_directory_iterator()));
  }

private:
  std::filesystem::path Root;
};

inline std::string BytesOf(const std::string& path)
{
  std::ifstream file(std::filesystem::u8path(path), std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

inline void WriteBytes(const std::string& path, const std::string& bytes)
{
  std::ofstream(std::filesystem::u8path(path), std::ios::binary) << bytes;
}

/// A scene whose view is written.
struct ViewScene : Scene
{
  /// \param data may be null
  explicit ViewScene(vtkDataSet* data, const std::vector<double>& isovalues = { 100.0 })
    : Scene(data, isovalues)
  {
    this->LookFrom(1.0, 2.0, 0.5);
    this->Writer->SetSize(24, 16);
    this->Writer->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    this->View->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    this->Mapper->AddObserver(vtkCommand::ErrorEvent, this->Errors);
  }

  bool Write(const std::string& path)
  {
    return this->Writer->WriteView(path.c_str(), this->Renderer, this->Volume);
  }

  /// What was said since the last call; empty if nothing was.
  std::string Said()
  {
    const std::string text = this->Errors->GetError() ? this->Errors->GetErrorMessage() : "";
    this->Errors->Clear();
    return text;
  }

  vtkNew<vtkTemporalCoherenceViewWriter> Writer;
  vtkNew<vtkTemporalCoherenceView> View;
  vtkNew<vtkTest::ErrorObserver> Errors;
};

#endif
