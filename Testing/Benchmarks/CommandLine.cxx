// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include <algorithm>
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

/// The sentence that tells what an option needs.
std::string NeedOf(const std::string& name, const std::string& need, const std::string& given)
{
  return name + " needs " + need + " behind it" + (given.empty() ? "." : ", not '" + given + "'.");
}

std::vector<std::string> SplitAtCommas(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  return parts;
}

}

CommandLine::CommandLine(const std::string& program, const std::string& purpose)
  : Program(program)
  , Purpose(purpose)
{
}

void CommandLine::Flag(const std::string& name, const std::string& meaning, bool& value)
{
  const auto take = [&value](const std::string&)
  {
    value = true;
    return std::string();
  };
  this->Options.push_back({ name, "", meaning, take });
}

void CommandLine::Number(
  const std::string& name, const std::string& meaning, int& value, int smallest, int largest)
{
  const std::string need = "a whole number of at least " + std::to_string(smallest) +
    (largest < std::numeric_limits<int>::max() ? " and at most " + std::to_string(largest) : "");
  const auto take = [=, &value](const std::string& text)
  {
    return ReadNumber(text, value) && value >= smallest && value <= largest
      ? std::string()
      : NeedOf(name, need, text);
  };
  this->Options.push_back({ name, "NUMBER", meaning, take });
}

void CommandLine::Text(const std::string& name, const std::string& meaning, std::string& value)
{
  const auto take = [name, &value](const std::string& text)
  {
    value = text;
    return text.empty() ? NeedOf(name, "a path", text) : std::string();
  };
  this->Options.push_back({ name, "PATH", meaning, take });
}

void CommandLine::Choices(const std::string& name, const std::string& meaning,
  const std::string& noun, const std::vector<Choice>& choices, std::vector<std::string>& chosen)
{
  this->Kinds.push_back({ noun, choices });
  const auto take = [name, noun, choices, &chosen](const std::string& text)
  {
    chosen = SplitAtCommas(text);
    for (const std::string& one : chosen)
    {
      if (std::none_of(choices.begin(), choices.end(),
            [&one](const Choice& choice) { return choice.Name == one; }))
      {
        return "There is no " + noun + " '" + one + "'; --help lists those there are.";
      }
    }
    return chosen.empty() ? NeedOf(name, "the name of a " + noun, text) : std::string();
  };
  this->Options.push_back({ name, "NAME,...", meaning, take });
}

void CommandLine::Volumes(std::vector<::Volumes::Sample>& volumes)
{
  this->Given = &volumes;
}

void CommandLine::PrintHelp() const
{
  std::cout << this->Purpose << "\n\nusage: " << this->Program << " [OPTIONS]"
            << (this->Given ? " [VOLUME ISOVALUE]..." : "") << "\n\n";
  for (const Option& option : this->Options)
  {
    std::cout << "  " << std::left << std::setw(NameWidth) << option.Name + " " + option.Value
              << option.Meaning << '\n';
  }
  std::cout << "  " << std::setw(NameWidth) << "--help"
            << "show this text\n";
  for (const Kind& kind : this->Kinds)
  {
    std::cout << "\n" << kind.Noun << "s:\n";
    for (const Choice& choice : kind.Choices)
    {
      std::cout << "  " << std::setw(NameWidth) << choice.Name << choice.Meaning << '\n';
    }
  }
  if (this->Given)
  {
    std::cout
      << "\nVOLUME is spheres, marschner-lobb or noise with a number of samples behind it, as "
         "spheres256,\nor a file in the folder that TEMPORAL_COHERENCE_DATA names.\n";
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
    const std::string mistake = option.Take(value);
    return mistake.empty() || this->Mistake(mistake);
  }
  return this->Mistake("There is no option " + name + "; --help lists those there are.");
}

bool CommandLine::ReadVolume(const std::vector<std::string>& arguments, std::size_t& at)
{
  const std::string& name = arguments[at];
  double isovalue = 0.0;
  if (!this->Given)
  {
    return this->Mistake("Volumes are not chosen here: leave '" + name + "' out.");
  }
  if (at + 1 == arguments.size() || !ReadNumber(arguments[++at], isovalue))
  {
    return this->Mistake("Give a number behind " + name + ": its isovalue.");
  }
  this->Given->push_back({ name, isovalue });
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
    this->Mistake("Nothing was measured, for the reasons above.");
  }
  catch (const std::exception& failure)
  {
    this->Mistake(failure.what());
  }
  return this->ExitStatus;
}
