// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include <cstddef>
#include <exception>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace
{

constexpr int NameWidth = 26;

template <typename Number>
bool ReadNumber(const std::string& text, Number& number)
{
  std::istringstream stream(text);
  return stream >> number && stream.eof();
}

}

CommandLine::CommandLine(const std::string& program, const std::string& purpose)
  : Program(program)
  , Purpose(purpose)
{
}

void CommandLine::Flag(const std::string& name, const std::string& meaning, bool& value)
{
  this->Options.push_back(
    { name, "", meaning, [&value](const std::string&) { return value = true; } });
}

void CommandLine::Number(const std::string& name, const std::string& meaning, int& value)
{
  const auto take = [&value](const std::string& text)
  { return ReadNumber(text, value) && value >= 1; };
  this->Options.push_back({ name, "NUMBER", meaning, take });
}

void CommandLine::Text(const std::string& name, const std::string& meaning, std::string& value)
{
  const auto take = [&value](const std::string& text)
  {
    value = text;
    return !text.empty();
  };
  this->Options.push_back({ name, "PATH", meaning, take });
}

void CommandLine::Volumes(std::vector<::Volumes::Sample>& volumes)
{
  this->Wanted = &volumes;
}

void CommandLine::PrintHelp() const
{
  std::cout << this->Purpose << "\n\nusage: " << this->Program << " [OPTIONS]"
            << (this->Wanted ? " [VOLUME ISOVALUE]..." : "") << "\n\n";
  for (const Option& option : this->Options)
  {
    std::cout << "  " << std::left << std::setw(NameWidth) << option.Name + " " + option.Value
              << option.Meaning << '\n';
  }
  std::cout << "  " << std::setw(NameWidth) << "--help"
            << "show this text\n";
  if (this->Wanted)
  {
    std::cout
      << "\nVOLUME is spheres or marschner-lobb with a number of samples behind it, as "
         "spheres256,\nor a file in the folder that TEMPORAL_COHERENCE_DATA names. Default:";
    for (const ::Volumes::Sample& sample : *this->Wanted)
    {
      std::cout << ' ' << sample.Name << ' ' << sample.Isovalue;
    }
    std::cout << '\n';
  }
}

bool CommandLine::Mistake(const std::string& sentence)
{
  std::cerr << this->Program << ": " << sentence << '\n';
  this->ExitStatus = 1;
  return false;
}

bool CommandLine::ReadOption(const std::vector<std::string>& arguments, std::size_t& at)
{
  const std::string& name = arguments[at];
  for (const Option& option : this->Options)
  {
    if (option.Name != name)
    {
      continue;
    }
    const bool hasValue = !option.Value.empty();
    const std::string value = hasValue && at + 1 < arguments.size() ? arguments[++at] : "";
    return option.Take(value) ||
      this->Mistake(name + " needs " +
        (option.Value == "NUMBER" ? "a whole number of at least 1" : "a path") + " behind it" +
        (value.empty() ? "." : ", not '" + value + "'."));
  }
  return this->Mistake("There is no option " + name + "; --help lists those there are.");
}

bool CommandLine::ReadVolume(const std::vector<std::string>& arguments, std::size_t& at)
{
  const std::string& name = arguments[at];
  double isovalue = 0.0;
  if (!this->Wanted)
  {
    return this->Mistake("Volumes are not chosen here: leave '" + name + "' out.");
  }
  if (at + 1 == arguments.size() || !ReadNumber(arguments[++at], isovalue))
  {
    return this->Mistake("Give a number behind " + name + ": its isovalue.");
  }
  this->Given.push_back({ name, isovalue });
  return true;
}

bool CommandLine::Read(int argc, char* argv[])
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  for (std::size_t at = 0; at < arguments.size(); ++at)
  {
    if (arguments[at] == "--help" || arguments[at] == "-h")
    {
      this->PrintHelp();
      return false;
    }
    const bool isOption = arguments[at].rfind('-', 0) == 0;
    if (!(isOption ? this->ReadOption(arguments, at) : this->ReadVolume(arguments, at)))
    {
      return false;
    }
  }
  if (!this->Given.empty())
  {
    *this->Wanted = this->Given;
  }
  return true;
}

int CommandLine::Run(int argc, char* argv[], const std::function<bool()>& measure)
{
  if (!this->Read(argc, argv))
  {
    return this->ExitStatus;
  }
  try
  {
    if (measure())
    {
      return 0;
    }
    this->Mistake("Nothing was measured: name a volume that is there.");
  }
  catch (const std::exception& failure)
  {
    this->Mistake(failure.what());
  }
  return this->ExitStatus;
}
