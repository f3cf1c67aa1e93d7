// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/Trial.h"

#include "Files/FileCheck.h"
#include "Files/HandOver.h"
#include "Files/VolumeReader.h"
#include "Program/Memory.h"

#ifdef _WIN32

void BeginTrials() {}
std::optional<Volume> TryReading(const VolumeSource&, const ReadingProgress&)
{
  return {};
}

#else

#include <vtkSMPTools.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TRIAL_HAS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TRIAL_HAS_SANITIZER
#endif
#endif

namespace
{

constexpr int PollMs = 50; // between two looks whether the reading is to be stopped
// A volume is handed over if reading took longer than that, and than the way takes.
constexpr double Noticeable = 0.15;          // seconds
constexpr double BytesPerSecond = 150 << 20; // on the way, on a busy machine
constexpr double MostOfMemory = 0.25;        // of the machine, which holds a volume twice then
constexpr double MostBusyShare = 8;          // of wall time: how long a reader may wait for a disk

// What the processes tell each other. Text follows it.
struct Message
{
  enum Kinds : int
  {
    Request, // text: what is to be read
    Begun,   // number: the process that reads
    Progress,
    Refused,  // text: a sentence
    WentWell, // text: the file by which the volume is handed over, if it is
    Ended,    // number: the status that wait() gave
  };
  int Kind = Request;
  int Number = 0;
  double Share = 0.0;
  std::size_t Size = 0; // of the text
};

#ifdef MSG_NOSIGNAL
constexpr int SendFlags = MSG_NOSIGNAL;
#else
constexpr int SendFlags = 0;
#endif

bool SendAll(int socket, const void* data, std::size_t size)
{
  const char* at = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t sent = send(socket, at, size, SendFlags);
    if (sent <= 0)
    {
      return false;
    }
    at += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool ReceiveAll(int socket, void* data, std::size_t size)
{
  char* at = static_cast<char*>(data);
  while (size > 0)
  {
    const ssize_t received = recv(socket, at, size, 0);
    if (received <= 0)
    {
      return false;
    }
    at += received;
    size -= static_cast<std::size_t>(received);
  }
  return true;
}

bool Send(int socket, Message message, const std::string& text = "")
{
  message.Size = text.size();
  return SendAll(socket, &message, sizeof(message)) && SendAll(socket, text.data(), text.size());
}

bool Receive(int socket, Message& message, std::string& text)
{
  if (!ReceiveAll(socket, &message, sizeof(message)))
  {
    return false;
  }
  text.assign(message.Size, '\0');
  return ReceiveAll(socket, text.data(), text.size());
}

std::string HandOverFile(pid_t reader)
{
  std::error_code error;
  std::filesystem::path folder = "/dev/shm"; // files in memory, on Linux
  if (!std::filesystem::is_directory(folder, error))
  {
    folder = std::filesystem::temp_directory_path(error);
  }
  return (folder / ("vtkTemporalCoherence-" + std::to_string(reader) + ".volume")).string();
}

// A file of the user's own, which was not there.
bool MakeFile(const std::string& path)
{
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, 0600);
  return file >= 0 && close(file) == 0;
}

// The process that reads

void SetLimit(decltype(RLIMIT_CPU) what, double most)
{
  rlimit limit = {};
  getrlimit(what, &limit);
  const double before =
    limit.rlim_cur == RLIM_INFINITY ? 1e18 : static_cast<double>(limit.rlim_cur);
  limit.rlim_cur = static_cast<rlim_t>(std::min(before, most));
  setrlimit(what, &limit);
}

void Limit(const ReadingLimits& limits)
{
  SetLimit(RLIMIT_CORE, 0.0);
  SetLimit(RLIMIT_CPU, limits.Seconds);
#if defined(__linux__) && !defined(TRIAL_HAS_SANITIZER)
  double pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  SetLimit(RLIMIT_AS,
    pages * static_cast<double>(sysconf(_SC_PAGESIZE)) + std::min(limits.Bytes, MemoryOfMachine()));
#endif
}

// The file by which the volume is handed over; empty if it is not.
std::string ReadAndHandOver(const VolumeSource& source, int socket)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const Volume volume = ReadUntried(source,
    [socket](double share) {
      return Send(socket, { Message::Progress, 0, share });
    });
  const std::chrono::duration<double> taken = Clock::now() - begin;
  const std::string file = HandOverFile(getpid());
  const double bytes = 1024.0 * static_cast<double>(volume.Data->GetActualMemorySize());
  const bool isHandedOver = taken.count() > std::max(Noticeable, bytes / BytesPerSecond) &&
    bytes < MostOfMemory * MemoryOfMachine() && MakeFile(file) && WriteHandOver(volume, file);
  return isHandedOver ? file : "";
}

void ReadHere(const VolumeSource& source, int socket)
{
  Send(socket, { Message::Begun, static_cast<int>(getpid()) });
  // Libraries below VTK's readers write on the terminal.
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
  {
    dup2(nowhere, stream);
  }
  try
  {
    vtkSMPTools::Initialize(1); // threads take memory, too
    Limit(LimitsOf(source.Path));
    const std::string file = ReadAndHandOver(source, socket);
    // All that was read is freed by now, which finds a heap that a reader has spoilt.
    Send(socket, { Message::WentWell }, file);
  }
  catch (const std::exception& failure)
  {
    Send(socket, { Message::Refused }, failure.what());
  }
  _exit(0);
}

// The process that waits for files

std::string TextOf(const VolumeSource& source)
{
  return std::to_string(source.TimeStep) + '\n' + std::to_string(source.Array.size()) + '\n' +
    source.Array + source.Path;
}

VolumeSource SourceOf(const std::string& text)
{
  VolumeSource source;
  const std::size_t first = text.find('\n'), second = text.find('\n', first + 1);
  const std::size_t size = std::stoul(text.substr(first + 1));
  source.TimeStep = std::stoi(text);
  source.Array = text.substr(second + 1, size);
  source.Path = text.substr(second + 1 + size);
  return source;
}

[[noreturn]] void Serve(int socket)
{
  Message message;
  std::string text;
  while (Receive(socket, message, text))
  {
    const pid_t reader = fork();
    if (reader == 0)
    {
      ReadHere(SourceOf(text), socket);
    }
    int status = -1;
    while (reader > 0 && waitpid(reader, &status, 0) < 0 && errno == EINTR)
    {
    }
    Send(socket, { Message::Ended, status });
  }
  _exit(0);
}

// The program

// The socket to the other process; negative where there is none.
int Server = -1;
std::mutex ServerIsBusy;

// Changes when the file does; of a folder, when a file comes or goes.
std::string IdentityOf(const VolumeSource& source)
{
  std::error_code error;
  const auto written = std::filesystem::last_write_time(source.Path, error).time_since_epoch();
  const auto size = std::filesystem::file_size(source.Path, error);
  return TextOf(source) + '\n' + std::to_string(written.count()) + '\n' +
    std::to_string(error ? 0 : size);
}

// What is heard of a reading elsewhere.
struct Outcome
{
  bool WentWell = false, IsStopped = false, IsLate = false;
  std::string Refusal, File;
  int Status = -1;
  pid_t Reader = 0;
};

// False if the process that waits for files has ended.
bool WaitFor(Outcome& outcome, const ReadingProgress& progress, double mostSeconds)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  pid_t reader = 0;
  double share = 0.0;
  while (true)
  {
    pollfd waiting = { Server, POLLIN, 0 };
    const bool hasMessage = poll(&waiting, 1, PollMs) > 0;
    Message message;
    std::string text;
    if (hasMessage && !Receive(Server, message, text))
    {
      return false;
    }
    if (hasMessage && message.Kind == Message::Ended)
    {
      outcome.Status = message.Number;
      return true;
    }
    if (hasMessage)
    {
      reader = message.Kind == Message::Begun ? message.Number : reader;
      share = message.Kind == Message::Progress ? message.Share : share;
      outcome.Refusal = message.Kind == Message::Refused ? text : outcome.Refusal;
      outcome.WentWell = outcome.WentWell || message.Kind == Message::WentWell;
      outcome.File = message.Kind == Message::WentWell ? text : outcome.File;
      outcome.Reader = message.Kind == Message::Begun ? message.Number : outcome.Reader;
    }
    outcome.IsStopped = outcome.IsStopped || (progress && !progress(share));
    const std::chrono::duration<double> passed = Clock::now() - begin;
    outcome.IsLate = outcome.IsLate || passed.count() > mostSeconds;
    if ((outcome.IsStopped || outcome.IsLate) && reader > 0)
    {
      kill(reader, SIGKILL);
      reader = 0;
    }
  }
}

void Judge(const Outcome& outcome, const std::string& path)
{
  if (outcome.IsStopped)
  {
    throw Stopped(path);
  }
  if (!outcome.Refusal.empty())
  {
    throw UserError(outcome.Refusal);
  }
  const int signal = WIFSIGNALED(outcome.Status) ? WTERMSIG(outcome.Status) : 0;
  if (outcome.IsLate || signal == SIGXCPU || signal == SIGALRM)
  {
    throw Damaged(path, "to read it would take too long");
  }
  if (signal == SIGKILL)
  {
    throw TooLarge(path); // the system's way where memory runs out
  }
  if (!outcome.WentWell)
  {
    throw Damaged(path, "its reader fails on it");
  }
}

}

void BeginTrials()
{
  int ends[2];
  if (Server >= 0 || socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
  {
    return;
  }
  for (const int end : ends)
  {
    fcntl(end, F_SETFD, FD_CLOEXEC);
#ifdef SO_NOSIGPIPE
    const int isOn = 1;
    setsockopt(end, SOL_SOCKET, SO_NOSIGPIPE, &isOn, sizeof(isOn));
#endif
  }
  const pid_t server = fork();
  if (server == 0)
  {
    close(ends[0]);
    Serve(ends[1]);
  }
  close(ends[1]);
  if (server < 0)
  {
    close(ends[0]);
    return;
  }
  Server = ends[0];
}

std::optional<Volume> TryReading(const VolumeSource& source, const ReadingProgress& progress)
{
  static std::set<std::string> known;
  const std::lock_guard<std::mutex> lock(ServerIsBusy);
  const std::string identity = IdentityOf(source);
  if (Server < 0 || known.count(identity) == 1)
  {
    return {};
  }
  Outcome outcome;
  if (!Send(Server, {}, TextOf(source)) ||
    !WaitFor(outcome, progress, MostBusyShare * LimitsOf(source.Path).Seconds))
  {
    close(Server);
    Server = -1;
    throw Damaged(source.Path, "the process that tries it has ended");
  }
  std::optional<Volume> volume;
  if (outcome.WentWell && !outcome.File.empty())
  {
    volume = ReadHandOver(outcome.File);
  }
  std::error_code error;
  std::filesystem::remove(HandOverFile(outcome.Reader), error); // also that of a reader that died
  Judge(outcome, source.Path);
  known.insert(identity);
  return volume;
}

#endif
