// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Does memory stay flat? Frames over all features, mappers and windows again and again, with the
// resident memory of the process at ten stages of each. The first tenth is the warm-up: caches of
// mappers, of VTK and of OpenGL fill. From there to the end memory may grow by 5 %.

#include "Checks/ProcessMemory.h"
#include "FrameLoad.h"
#include "MapperLoad.h"
#include "WindowLoad.h"

#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace
{

constexpr double MiB = 1024.0 * 1024.0;
constexpr int SkipReturnCode = 125; ///< as VTK's tests have it
constexpr double Allowed = 0.05;    ///< growth behind the warm-up, a part of what there was

struct Options
{
  long Frames = 100000, Mappers = 2000, Windows = 300;
  long Leak = 0; ///< bytes in each round
  bool IsJudged = true;
  bool IsControlled = false;
};

const char* const Usage =
  "Holds that memory stays flat over frames, mappers and windows.\n\n"
  "usage: Soak [OPTIONS]\n\n"
  "  --frames N    small frames of one mapper over all features; default: 100000\n"
  "  --mappers N   mappers that are made, used and deleted; default: 2000\n"
  "  --windows N   windows that are opened and closed; default: 300. They need a display\n"
  "  --control     as many windows with a software mapper of VTK, to compare with\n"
  "  --unjudged    small numbers: tell of memory, but judge only what was reached\n"
  "  --leak BYTES  lose so much in each round, to see that it is told\n"
  "  --help        show this text\n\n"
  "The last line is the verdict. The exit status is 0 if memory is flat and all was reached, and\n"
  "125 where the system does not tell how much memory there is.\n";

[[noreturn]] void Refuse(const std::string& why)
{
  std::cerr << why << "; --help lists the options there are.\n";
  std::exit(EXIT_FAILURE);
}

long ToNumber(const std::string& option, const char* text)
{
  char* end = nullptr;
  const long number = text ? std::strtol(text, &end, 10) : -1;
  if (!text || !*text || *end || number < 0)
  {
    Refuse(option + " takes a number that is not negative");
  }
  return number;
}

Options ReadOptions(int argc, char* argv[])
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string option = argv[i];
    const auto number = [&]
    {
      ++i;
      return ToNumber(option, i < argc ? argv[i] : nullptr);
    };
    if (option == "--help")
    {
      std::cout << Usage;
      std::exit(EXIT_SUCCESS);
    }
    else if (option == "--control")
    {
      options.IsControlled = true;
    }
    else if (option == "--unjudged")
    {
      options.IsJudged = false;
    }
    else if (option == "--frames" || option == "--mappers" || option == "--windows" ||
      option == "--leak")
    {
      (option == "--frames"       ? options.Frames
          : option == "--mappers" ? options.Mappers
          : option == "--windows" ? options.Windows
                                  : options.Leak) = number();
    }
    else
    {
      Refuse("There is no option " + option);
    }
  }
  return options;
}

/// Does a load so often and tells of memory.
/// \return what is wrong with it, or nothing
std::string Soak(const std::string& name, Load& load, long many, const Options& options)
{
  static std::vector<std::unique_ptr<char[]>> leaked;
  // What a frame keeps differs from frame to frame: of the rounds before a stage the least counts,
  // which is what stays.
  const long stage = (many + 9) / 10, watched = std::max(many / 100, 1L),
             step = (watched + 19) / 20;
  const int before = Failures;
  double warm = 0.0, now = 0.0, least = std::numeric_limits<double>::infinity();
  for (long i = 1; i <= many; ++i)
  {
    load.DoOnce();
    if (Failures > before)
    {
      return name + ": failed in round " + std::to_string(i);
    }
    if (options.Leak > 0)
    {
      leaked.push_back(std::make_unique<char[]>(static_cast<std::size_t>(options.Leak)));
    }
    const long left = i == many ? 0 : stage - 1 - (i - 1) % stage;
    if (left < watched && left % step == 0)
    {
      const double resident = ProcessMemory::Resident();
      least = resident >= least ? least : resident;
    }
    if (left == 0)
    {
      now = least;
      warm = i == stage ? now : warm;
      least = std::numeric_limits<double>::infinity();
      std::printf("| %-8s | %7ld | %13.1f |\n", name.c_str(), i, now / MiB);
      std::fflush(stdout);
    }
  }
  const double growth = (now - warm) / warm;
  std::printf("\n%s: %+.2f %% from %ld to %ld; %s\n\n", name.c_str(), 100.0 * growth, stage, many,
    load.Describe().c_str());
  if (!load.HasReachedAll())
  {
    return name + ": not everything was reached";
  }
  return options.IsJudged && !(growth <= Allowed) ? name + ": memory GROWS" : "";
}

bool HasDisplay()
{
  const vtkNew<vtkRenderWindow> window;
  return !window->IsA("vtkXOpenGLRenderWindow") || std::getenv("DISPLAY");
}

}

int main(int argc, char* argv[])
{
  const Options options = ReadOptions(argc, argv);
  if (options.IsJudged && std::isnan(ProcessMemory::Resident()))
  {
    std::printf("[soak] SKIPPED: this system does not tell how much memory a process has\n");
    return SkipReturnCode;
  }
  std::string wrong, skipped;
  std::printf("| part     |   round | resident, MiB |\n|----------|--------:|--------------:|\n");
  const auto soak = [&](const std::string& name, Load&& load, long many)
  {
    const std::string found = many > 0 ? Soak(name, load, many, options) : "";
    wrong += (wrong.empty() || found.empty() ? "" : "; ") + found;
  };
  soak("frames", FrameLoad(), options.Frames);
  soak("mappers", MapperLoad(), options.Mappers);
  if (options.Windows > 0 && !HasDisplay())
  {
    skipped = " (windows SKIPPED: there is no display)";
  }
  else
  {
    soak("windows", WindowLoad(WindowLoad::Ours), options.Windows);
    if (options.IsControlled)
    {
      soak("control", WindowLoad(WindowLoad::OfVtk), options.Windows);
    }
  }
  if (!wrong.empty())
  {
    std::printf("[soak] FAILED: %s%s\n", wrong.c_str(), skipped.c_str());
    return EXIT_FAILURE;
  }
  std::printf("[soak] PASSED: %s%s\n",
    options.IsJudged ? "memory is flat" : "all was reached; memory was not judged",
    skipped.c_str());
  return EXIT_SUCCESS;
}
