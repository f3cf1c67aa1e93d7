// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Opens files in the ways of the example programs, each in a process of its own: see usage().
#include "Draw.h"
#include "Program/CommandLine.h"
#include "Program/UserError.h"

#include <vtkSMPTools.h>

#include <cstdio>
#include <cstdlib>
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

A request is a line WAY<tab>FILE<tab>SAID[<tab>LAYOUT]: WAY is explorer, session or orbit, FILE what
is opened, SAID a file for what is printed, LAYOUT what --raw takes. The answer is a line with the
status that wait() gave and the most memory that the process had, in KiB: "0 51234". A process that
takes more than 20 s is ended by SIGALRM; one that asks for more than 1 GiB is refused it.
)";

struct Request
{
  std::string Way, File, Said, Layout;
};

Request Parse(const std::string& line)
{
  Request request;
  std::istringstream in(line);
  std::getline(in, request.Way, '\t');
  std::getline(in, request.File, '\t');
  std::getline(in, request.Said, '\t');
  std::getline(in, request.Layout, '\t');
  return request;
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
  vtkSMPTools::Initialize(2);
  return RunProgram("OpenFiles",
    [&request]
    {
      VolumeSource source;
      source.Path = request.File;
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
