// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_CommandLine_h
#define Benchmarks_CommandLine_h

#include "Volumes/Volumes.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

/// The options of a benchmark: each a name, what it means, and where its value goes.
class CommandLine
{
public:
  CommandLine(const std::string& program, const std::string& purpose);

  void Flag(const std::string& name, const std::string& meaning, bool& value);
  /// A whole number between two, both included.
  void Number(const std::string& name, const std::string& meaning, int& value, int smallest = 1,
    int largest = std::numeric_limits<int>::max());
  void Text(const std::string& name, const std::string& meaning, std::string& value);
  /// Something that can be chosen by its name.
  struct Choice
  {
    std::string Name, Meaning;
  };
  /// One or more of some choices, by names with commas between them.
  /// \param noun what a choice is called
  void Choices(const std::string& name, const std::string& meaning, const std::string& noun,
    const std::vector<Choice>& choices, std::vector<std::string>& chosen);
  /// Accept pairs of VOLUME and ISOVALUE.
  void Volumes(std::vector<Volumes::Sample>& volumes);

  /// A whole program: read the options, then measure. What goes wrong is told in one sentence.
  /// \param measure false if there was nothing to measure
  /// \return the exit status
  int Run(int argc, char* argv[], const std::function<bool()>& measure);

private:
  struct Option
  {
    std::string Name;
    std::string Value; ///< what the help calls the value; empty for a flag
    std::string Meaning;
    /// What is wrong with a value, as one sentence; empty if it is taken.
    std::function<std::string(const std::string&)> Take;
  };

  /// False after --help or a mistake, which is told in one sentence.
  bool Read(int argc, char* argv[]);
  void PrintHelp() const;
  bool Mistake(const std::string& sentence);
  bool ReadOption(const std::vector<std::string>& arguments, std::size_t& at);
  bool ReadVolume(const std::vector<std::string>& arguments, std::size_t& at);

  int ExitStatus = 0;
  std::string Program;
  std::string Purpose;
  std::vector<Option> Options;
  /// Things of one kind to choose from.
  struct Kind
  {
    std::string Noun;
    std::vector<Choice> Choices;
  };
  std::vector<Kind> Kinds;
  std::vector<::Volumes::Sample>* Given = nullptr;
};

#endif
