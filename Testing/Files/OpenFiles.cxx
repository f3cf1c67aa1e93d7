// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Opens files in the ways of the example programs, each in a process of its own: see usage().
#include "Draw.h"
#include "Files/Arrays.h"
#include "Files/HandOver.h"
#include "Files/Trial.h"
#include "Files/VolumeReader.h"
#include "Program/CommandLine.h"
#include "Program/UserError.h"
#include "View/Histogram.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkSMPTools.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HAS_SANITIZER
#endif
#endif

namespace
{

constexpr unsigned int MostSeconds = 20;
constexpr rlim_t MostBytes = rlim_t(1) << 30; // beyond what the program has at first

const char* const Usage =
  R"(Open files as the example programs do, each in a process of its own.

usage: OpenFiles < REQUESTS

A request is a line WAY<tab>FILE<tab>SAID[<tab>LAYOUT[<tab>TIME]]: WAY is explorer, session, orbit, tell or
pass, with large- before it as with --large, FILE what is opened, SAID a file for what is printed, LAYOUT
what --raw takes, or of tell an array, TIME its time step, from 1. With
tell nothing is drawn: what was read is told, and where its samples lie; with pass it is handed over by
a file first, as from a process that tries it. The answer is a line with the
status that wait() gave and the most memory that the process had, in KiB: "0 51234". A process that
takes more than 20 s is ended by SIGALRM; one that asks for more than 1 GiB is refused it.
)";

struct Request
{
  std::string Way, File, Said, Layout, Time;
  bool IsLarge = false;
};

Request Parse(const std::string& line)
{
  Request request;
  std::istringstream in(line);
  std::getline(in, request.Way, '\t');
  std::getline(in, request.File, '\t');
  std::getline(in, request.Said, '\t');
  std::getline(in, request.Layout, '\t');
  std::getline(in, request.Time, '\t');
  const std::string large = "large-";
  if (request.Way.compare(0, large.size(), large) == 0)
  {
    request.IsLarge = true;
    request.Way.erase(0, large.size());
  }
  return request;
}

// What was read, and places and values of samples: of the first one, its neighbours and the last.
// \param onTheWay a file: what was read is handed over by it first
void Tell(VolumeSource source, const std::string& array, const std::string& onTheWay)
{
  source.Array = array;
  Volume volume = ReadVolume(source);
  if (!onTheWay.empty())
  {
    const bool isWritten = WriteHandOver(volume, onTheWay);
    volume = ReadHandOver(isWritten ? onTheWay : "").value();
  }
  const Histogram histogram = CountSamples(volume);
  std::printf("array %s%s\n", volume.Array.Name.c_str(), volume.Array.IsOnCells ? " of cells" : "");
  std::printf("range %.10g %.10g\n", histogram.Range[0], histogram.Range[1]);
  int n[3] = { 0, 0, 0 };
  if (auto* image = vtkImageData::SafeDownCast(volume.Data))
  {
    image->GetDimensions(n);
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(volume.Data))
  {
    grid->GetDimensions(n);
  }
  const vtkIdType plane = static_cast<vtkIdType>(n[0]) * n[1], count = plane * n[2];
  for (const vtkIdType point : { vtkIdType(0), vtkIdType(1), vtkIdType(n[0]), plane, count - 1 })
  {
    if (count == 0)
    {
      break;
    }
    double place[4] = { 0.0, 0.0, 0.0, 1.0 };
    DataSetsOf(volume.Data).front()->GetPoint(point, place);
    if (volume.Placement)
    {
      volume.Placement->MultiplyPoint(place, place);
    }
    const double value =
      volume.Array.IsOnCells ? 0.0 : ShownArrays(volume).front()->GetComponent(point, 0);
    std::printf("sample %g %g %g %.10g\n", place[0], place[1], place[2], value);
  }
  if (!volume.Remark.empty())
  {
    std::printf("remark %s\n", volume.Remark.c_str());
  }
}

void Limit()
{
  alarm(MostSeconds);
  const rlimit none = { 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
#if defined(__linux__) && !defined(HAS_SANITIZER)
  long pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlimit bytes = { static_cast<rlim_t>(pages) * 4096 + MostBytes, RLIM_INFINITY };
  setrlimit(RLIMIT_AS, &bytes);
#endif
}

// In the process that is there for this alone.
int Open(const Request& request)
{
  const int said = open(request.Said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(said, STDOUT_FILENO);
  dup2(said, STDERR_FILENO);
  Limit();
  BeginTrials();
  vtkSMPTools::Initialize(2);
  return RunProgram("OpenFiles",
    [&request]
    {
      VolumeSource source;
      source.Path = request.File;
      source.IsLarge = request.IsLarge;
      source.TimeStep = request.Time.empty() ? 1 : std::stoi(request.Time);
      if (request.Way == "tell" || request.Way == "pass")
      {
        Tell(source, request.Layout, request.Way == "pass" ? request.Said + ".passed" : "");
        return;
      }
      if (!request.Layout.empty())
      {
        source.Raw = ParseRaw(request.Layout);
      }
      if (request.Way == "session")
      {
        DrawSessionInExplorer(request.File);
      }
      else if (request.Way == "explorer")
      {
        DrawInExplorer(source);
      }
      else
      {
        DrawInOrbitAndSweep(source);
      }
    });
}

}

int main(int argc, char*[])
{
  if (argc > 1)
  {
    std::fputs(Usage, stderr);
    return 1;
  }
  for (std::string line; std::getline(std::cin, line);)
  {
    const pid_t child = fork();
    if (child == 0)
    {
      const int status = Open(Parse(line));
      std::fflush(stdout);
      _exit(status);
    }
    int status = 0;
    rusage used = {};
    wait4(child, &status, 0, &used);
    std::printf("%d %ld\n", status, used.ru_maxrss);
    std::fflush(stdout);
  }
  return 0;
}
