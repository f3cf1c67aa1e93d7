// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The seeded fuzzer: runs of bytes made from seeds, or kept in files, each step compared with a
// mapper without a past.

#include "Runs/Report.h"
#include "Runs/Run.h"
#include "Runs/Shrink.h"
#include "Runs/Watchdog.h"
#include "Runs/Windows.h"
#include "World/Bytes.h"
#include "World/Story.h"

#include <vtkObject.h>
#include <vtkSMPTools.h>

#include <cctype>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace
{

const char* const Usage = R"(Fuzz vtkTemporalCoherenceVolumeMapper.

usage: FuzzMapper [OPTIONS] [FILE...]

  FILE             replay the bytes of a file, or of all files of a folder
  --seed N         replay the run of a seed; with --steps the first seed (default 1)
  --steps N        make runs of one seed after the other until so many steps are made
  --windows        in render windows, on the display
  --seconds S      make runs of one seed after the other for so long
  --tell           print what is done, in words (always, where a single run fails)
  --save FOLDER    write the bytes of runs that fail to a file there
  --shrink FILE    write the shortest and dullest bytes that fail in the same way to a file
  --crashes        what is shrunk crashes or hangs
  --keep-going     do not stop at the first run that fails
  --expect-all     fail if a route was not reached, or too many pixels differ where some may
  --patience S     seconds that a step may take (default 20)
)";

/// Of images, or of windows.
void (*MakeRun)(const std::vector<std::uint8_t>&, Fuzz::Tally&) = Fuzz::Run;

/// What ctest takes for a test that cannot run here.
constexpr int SkippedStatus = 125;

struct Options
{
  std::vector<std::string> Files;
  std::string ShrinkTo;
  std::uint64_t Seed = 1;
  long Steps = 0;
  double Seconds = 0.0;
  unsigned Patience = 20;
  bool KeepGoing = false, ExpectAll = false, IsOneSeed = false, Crashes = false;
};

/// The number behind an option; ends the program where there is none.
template <class Number>
Number ToNumber(const std::string& option, const std::string& text)
{
  std::istringstream stream(text);
  Number number{};
  const bool isNumber = !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) &&
    stream >> number && stream.peek() == std::istringstream::traits_type::eof();
  if (!isNumber)
  {
    std::cerr << option << " takes a number that is not negative, got \"" << text << "\".\n";
    std::exit(2);
  }
  return number;
}

bool Parse(int argc, char* argv[], Options& options)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const bool hasValue = i + 1 < argc;
    if (argument == "--tell")
    {
      Fuzz::Story::IsTold() = true;
    }
    else if (argument == "--keep-going")
    {
      options.KeepGoing = true;
    }
    else if (argument == "--windows")
    {
      MakeRun = Fuzz::Windows::Run;
    }
    else if (argument == "--crashes")
    {
      options.Crashes = true;
    }
    else if (argument == "--expect-all")
    {
      options.ExpectAll = true;
    }
    else if (argument == "--seed" && hasValue)
    {
      options.Seed = ToNumber<std::uint64_t>(argument, argv[++i]);
      options.IsOneSeed = true;
    }
    else if (argument == "--steps" && hasValue)
    {
      options.Steps = ToNumber<long>(argument, argv[++i]);
    }
    else if (argument == "--seconds" && hasValue)
    {
      options.Seconds = ToNumber<double>(argument, argv[++i]);
    }
    else if (argument == "--patience" && hasValue)
    {
      options.Patience = ToNumber<unsigned>(argument, argv[++i]);
    }
    else if (argument == "--shrink" && hasValue)
    {
      options.ShrinkTo = argv[++i];
    }
    else if (argument == "--save" && hasValue)
    {
      Fuzz::Report::SaveTo(argv[++i]);
    }
    else if (argument.rfind("--", 0) == 0)
    {
      return false;
    }
    else if (std::filesystem::is_directory(argument))
    {
      for (const auto& entry : std::filesystem::directory_iterator(argument))
      {
        options.Files.push_back(entry.path().string());
      }
    }
    else
    {
      options.Files.push_back(argument);
    }
  }
  return true;
}

/// \return false if the run fails
bool Make(const std::vector<std::uint8_t>& bytes, const std::string& name, Fuzz::Tally& tally)
{
  Fuzz::Report::Begin(bytes, name, tally);
  try
  {
    MakeRun(bytes, tally);
    return true;
  }
  catch (const std::exception& failure)
  {
    Fuzz::Report::TellFailure(failure.what());
  }
  catch (...)
  {
    Fuzz::Report::TellFailure("something was thrown");
  }
  return false;
}

using Run = std::vector<std::uint8_t>;

/// What is the same of two failures: their words, without numbers.
std::string KindOf(const std::string& why)
{
  std::string kind;
  for (const char letter : why.substr(0, 60))
  {
    kind += std::isalpha(static_cast<unsigned char>(letter)) ? std::string(1, letter) : "";
  }
  return kind.substr(0, 28);
}

/// Why a run fails; empty if it does not.
std::string WhyFails(const Run& bytes)
{
  Fuzz::Tally tally;
  try
  {
    MakeRun(bytes, tally);
    return {};
  }
  catch (const std::exception& failure)
  {
    return failure.what();
  }
}

void ShrinkTo(const std::string& file, const Run& bytes, bool crashes)
{
  // Who asks why a crash happens crashes.
  const std::string kind = crashes ? "" : KindOf(WhyFails(bytes));
  Fuzz::Watchdog::Rest();
  const Run shrunk = Fuzz::Shrink(bytes,
    [&](const Run& some)
    {
      const std::string why = WhyFails(some);
      return !crashes && !why.empty() && KindOf(why) == kind;
    });
  std::ofstream(file, std::ios::binary)
    .write(
      reinterpret_cast<const char*>(shrunk.data()), static_cast<std::streamsize>(shrunk.size()));
  std::cout << bytes.size() << " bytes shrunk to " << shrunk.size() << ": " << file << '\n';
}

Run BytesOf(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  const std::vector<char> bytes{ std::istreambuf_iterator<char>(stream), {} };
  return { bytes.begin(), bytes.end() };
}

}

int main(int argc, char* argv[])
{
  Options options;
  if (!Parse(argc, argv, options) ||
    (options.Files.empty() && options.Steps == 0 && options.Seconds == 0.0 && !options.IsOneSeed))
  {
    std::cout << Usage;
    return EXIT_FAILURE;
  }
  if (MakeRun == Fuzz::Windows::Run && !Fuzz::Windows::AreThere())
  {
    std::cout << "SKIPPED: there is no display\n";
    return SkippedStatus;
  }
  // Steps are so small that threads would only wait for each other.
  vtkSMPTools::SetBackend("Sequential");
  Fuzz::Report::TellCrashes();
  Fuzz::Watchdog::Release(options.Patience, Fuzz::Report::TellHang);

  if (!options.ShrinkTo.empty())
  {
    ShrinkTo(options.ShrinkTo,
      options.Files.empty() ? Fuzz::Bytes::FromSeed(options.Seed, Fuzz::BytesOfSeed)
                            : BytesOf(options.Files.front()),
      options.Crashes);
    return EXIT_SUCCESS;
  }
  Fuzz::Tally tally;
  int failures = 0;
  for (const std::string& file : options.Files)
  {
    failures += !Make(BytesOf(file), file, tally);
  }
  std::uint64_t seed = options.Seed;
  const bool isSeeded = options.Steps > 0 || options.Seconds > 0.0 || options.IsOneSeed;
  const auto begin = std::chrono::steady_clock::now();
  while (isSeeded && (failures == 0 || options.KeepGoing))
  {
    failures += !Make(
      Fuzz::Bytes::FromSeed(seed, Fuzz::BytesOfSeed), "--seed " + std::to_string(seed), tally);
    ++seed;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    if (tally.Steps >= options.Steps && spent.count() >= options.Seconds)
    {
      break;
    }
  }
  return Fuzz::Report::Finish(tally, failures, options.ExpectAll) ? EXIT_SUCCESS : EXIT_FAILURE;
}
