// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CommandLine_h
#define CommandLine_h

#include "Program/VolumeSource.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

// What all example programs are told: a volume and how to look at it.
struct CommonOptions
{
  VolumeSource Source;
  std::optional<double> Isovalue;
  bool ThresholdMode = false; // THRESHOLD instead of CROSSING
  int Width = 1024;
  int Height = 1024;
  std::string From; // "+y": the viewer's place, seen from the middle; empty: what suits the file
  std::string Up = "+z";
  bool Help = false;
};

// Reads a command line: [VOLUME [ISOVALUE]] and the options that it was given. The functions throw
// UserError.
class CommandLine
{
public:
  using Switch = std::function<void()>;
  using Setting = std::function<void(const std::string& option, const std::string& value)>;

  explicit CommandLine(CommonOptions& options);

  void AddSwitch(const std::string& option, const Switch& action);
  void AddSetting(const std::string& option, const Setting& action);
  void Parse(const std::vector<std::string>& arguments);

private:
  void TakePositional(const std::string& argument, int position);

  CommonOptions& Options;
  std::map<std::string, Switch> Switches;
  std::map<std::string, Setting> Settings;
};

// A whole number from 1 to the most there may be.
int ParseCount(const std::string& option, const std::string& text, int most);

// VTK's types by their names: uchar, short, float and so on.
const std::map<std::string, int>& ScalarTypes();

// NX,NY,NZ,TYPE[,SX,SY,SZ], and the same the other way round.
RawLayout ParseRaw(const std::string& text);
std::string RawAsText(const RawLayout& layout);

// The whole text as a finite number.
bool IsNumber(const std::string& text, double& number);

// Lines for --help: what VOLUME and ISOVALUE may be, and the options of all programs.
extern const char* const VolumeHelp;
extern const char* const CommonOptionsHelp;

#endif
