// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Runs/Report.h"

#include "World/Story.h"

#include <array>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <string>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__)
#define FUZZ_WITH_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(undefined_behavior_sanitizer)
#define FUZZ_WITH_SANITIZER 1
#endif
#endif
#ifdef FUZZ_WITH_SANITIZER
#include <sanitizer/common_interface_defs.h>
#endif

namespace Fuzz
{
namespace Report
{
namespace
{

// How many percent of pixels may differ by more than is promised, in all sane scenes together: a
// tolerance is kept at every pixel.
constexpr double MostTolerantOthers = 0.0;

std::string Folder, Name, File;
const std::vector<std::uint8_t>* Now = nullptr;
const Tally* Sum = nullptr;

void Write(int to, const void* text, std::size_t size)
{
  const auto* at = static_cast<const char*>(text);
  while (size > 0)
  {
    const ssize_t written = write(to, at, size);
    if (written <= 0)
    {
      return;
    }
    at += written;
    size -= static_cast<std::size_t>(written);
  }
}

void Say(const char* text)
{
  Write(STDERR_FILENO, text, std::strlen(text));
}

/// Safe in a signal handler: no memory is asked for.
void TellRun(const char* what)
{
  const std::string& story = Story::Text();
  Write(STDERR_FILENO, story.data(), story.size());
  Say("FAILED: ");
  Say(what);
  Say("\n  replay: FuzzMapper --tell ");
  Say(Name.c_str());
  Say("\n");
  if (!File.empty() && Now)
  {
    const int to = open(File.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0644);
    if (to >= 0)
    {
      Write(to, Now->data(), Now->size());
      close(to);
      Say("  its bytes: ");
      Say(File.c_str());
      Say("\n");
    }
  }
}

void HearCrash(int signal)
{
  std::signal(signal, SIG_DFL);
  TellRun("a crash");
  std::raise(signal);
}

[[maybe_unused]] void HearSanitizer()
{
  TellRun("a report of the sanitizer");
}

}

void SaveTo(const std::string& folder)
{
  Folder = folder;
}

void Begin(const std::vector<std::uint8_t>& bytes, const std::string& name, const Tally& tally)
{
  Now = &bytes;
  Name = name;
  Sum = &tally;
  File.clear();
  if (!Folder.empty())
  {
    std::string plain = name.substr(name.find_last_of('/') + 1);
    for (char& letter : plain)
    {
      letter = letter == ' ' ? '-' : letter;
    }
    File = Folder + "/failed" + plain;
  }
}

void TellFailure(const std::string& why)
{
  TellRun(why.c_str());
}

void TellCrashes()
{
#ifdef FUZZ_WITH_SANITIZER
  __sanitizer_set_death_callback(HearSanitizer);
#else
  for (const int signal : { SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL })
  {
    std::signal(signal, HearCrash);
  }
#endif
}

void TellHang()
{
  TellRun("a step takes too long");
}

bool Finish(const Tally& tally, int failures, bool expectsAll)
{
  const auto list = [](const char* title, const std::map<std::string, long>& counts)
  {
    std::cout << title;
    for (const auto& [name, count] : counts)
    {
      std::cout << "  " << name << ' ' << count;
    }
    std::cout << '\n';
  };
  const auto share = [](double others, double pixels)
  { return pixels > 0.0 ? 100.0 * others / pixels : 0.0; };
  std::cout << tally.Steps << " steps in " << tally.Runs << " runs, " << tally.Refused
            << " frames refused, " << tally.WithSurface << " with a surface\n";
  list("routes of frames with a surface:", tally.Routes);
  list("of these with merged layers:", tally.Merged);
  list("other acts:", tally.Acts);
  list("refusals:", tally.Errors);
  const double tolerant = share(tally.TolerantOthers, tally.TolerantPixels);
  std::cout << "with a tolerance: " << tolerant << " % of " << tally.TolerantPixels
            << " pixels differ\n";
  bool isWell = failures == 0;
  if (expectsAll)
  {
    const std::array<const char*, 10> routes = { "Cold", "Redisplay", "Reshade", "IsomapLookup",
      "IsomapBuild", "ImageCache", "TimeStep", "Recomposite", "KeepValues", "KeepLabels" };
    for (const char* route : routes)
    {
      if (tally.Routes.count(route) == 0)
      {
        std::cerr << "FAILED: no frame was made by " << route << '\n';
        isWell = false;
      }
    }
    long cold = 0, others = 0;
    for (const auto& [route, count] : tally.Merged)
    {
      (route == "Cold" ? cold : others) += count;
    }
    if (cold == 0 || others == 0)
    {
      std::cerr << "FAILED: merged layers have " << cold << " cold frames and " << others
                << " others\n";
      isWell = false;
    }
    const auto judge = [&](const char* name, double pixels, double others, double most)
    {
      if (!(pixels > 0.0) || others > most)
      {
        std::cerr << "FAILED: " << name << ": " << others << " % of " << pixels
                  << " pixels differ; there have to be some, and at most " << most << " %\n";
        isWell = false;
      }
    };
    judge("with a tolerance", tally.TolerantPixels, tolerant, MostTolerantOthers);
  }
  std::cout << (isWell ? "PASSED: " : "FAILED: ") << failures << " runs failed, " << tally.Steps
            << " steps\n";
  return isWell;
}

}
}
