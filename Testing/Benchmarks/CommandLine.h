// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_CommandLine_h
#define Benchmarks_CommandLine_h

#include "Volumes.h"

#include <functional>
#include <string>
#include <vector>

/// The options of a benchmark: each a name, what it means, and where its value goes.
class CommandLine
{
public:
  CommandLine(const std::string& program, const std::string& purpose);

  void Flag(const std::string& name, const std::string& meaning, bool& value);
  /// A whole number of at least 1.
  void Number(const std::string& name, const std::string& meaning, int& value);
  void Text(const std::string& name, const std::string& meaning, std::string& value);
  /// Accept pairs of VOLUME and ISOVALUE; without any, `volumes` keeps what it holds.
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
    std::function<bool(const std::string&)> Take; ///< false if it cannot be such a value
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
  std::vector<::Volumes::Sample>* Wanted = nullptr;
  std::vector<::Volumes::Sample> Given;
};

#endif
