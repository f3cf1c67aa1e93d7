// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A library to preload: it reports invalid floating-point operations, divisions by zero and
// overflows of our code. Other libraries do theirs as if nothing were watched.
//
// Whose an exception is, is decided where it happens. The processor stops at the instruction; its
// address tells the module. Code that is in no file (that of Mesa's compiler) is nobody's. What the
// library of mathematical functions raises belongs to the code that called it. Then the one
// instruction is repeated without traps, and the program goes on. Each place is told once.
//
// Comparisons, smallest and largest may meet values that are no numbers: samples may be such, and a
// comparison that is false then is what the code wants. Who makes one by arithmetic is told there.
//
// environment:
//   TRAP_BELOW    the directory of our modules; those named after the library are ours anywhere
//   TRAP_REPORTS  where reports go, each into a file named after the process; default: standard
//   error
//
// For Linux on x86-64: traps are those of SSE and AVX, which do all arithmetic of float and double
// there.

#if !defined(__linux__) || !defined(__x86_64__)
#error "Traps are known for Linux on x86-64 only."
#endif

#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <pthread.h>
#include <signal.h>
#include <ucontext.h>
#include <unistd.h>
#include <xmmintrin.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace
{

constexpr unsigned Watched = _MM_MASK_INVALID | _MM_MASK_DIV_ZERO | _MM_MASK_OVERFLOW;
constexpr greg_t SingleStep = 0x100; // in the register of flags

std::array<char, PATH_MAX> Program, Below, Reports;

void WatchThisThread()
{
  _mm_setcsr(_mm_getcsr() & ~Watched);
}

/// The file that an address was loaded from.
struct Module
{
  explicit Module(std::uintptr_t address)
    : Address(address)
  {
    dl_iterate_phdr(&Module::Ask, this);
  }

  /// The program itself has no name here.
  const char* Path() const { return *this->Name ? this->Name : Program.data(); }
  bool IsOurs() const
  {
    const char* path = this->Path();
    const char* file = std::strrchr(path, '/');
    return this->IsFound &&
      (!std::strncmp(path, Below.data(), std::strlen(Below.data())) ||
        std::strstr(file ? file : path, "vtkTemporalCoherence"));
  }
  bool IsMathematics() const { return this->IsFound && std::strstr(this->Name, "/libm.so"); }

  std::uintptr_t Address, Base = 0;
  const char* Name = "";
  bool IsFound = false;

private:
  static int Ask(dl_phdr_info* info, std::size_t, void* that)
  {
    auto* module = static_cast<Module*>(that);
    for (int i = 0; i < info->dlpi_phnum; ++i)
    {
      const std::uintptr_t begin = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
      if (info->dlpi_phdr[i].p_type == PT_LOAD && module->Address >= begin &&
        module->Address - begin < info->dlpi_phdr[i].p_memsz)
      {
        module->Base = info->dlpi_addr;
        module->Name = info->dlpi_name;
        module->IsFound = true;
      }
    }
    return module->IsFound;
  }
};

/// The functions that are running, the innermost first.
struct Stack
{
  Stack() { this->Depth = backtrace(this->Calls.data(), static_cast<int>(this->Calls.size())); }

  /// Where the exception is, as frames of the signal lie before it.
  int Find(std::uintptr_t address) const
  {
    int i = 0;
    while (i < this->Depth && this->At(i) != address)
    {
      ++i;
    }
    return i;
  }
  std::uintptr_t At(int i) const
  {
    return reinterpret_cast<std::uintptr_t>(this->Calls[static_cast<std::size_t>(i)]);
  }

  std::array<void*, 64> Calls;
  int Depth;
};

bool IsOurs(std::uintptr_t address)
{
  const Module module(address);
  if (!module.IsMathematics())
  {
    return module.IsOurs();
  }
  const Stack stack;
  for (int i = stack.Find(address); i < stack.Depth; ++i)
  {
    const Module caller(stack.At(i));
    if (!caller.IsMathematics())
    {
      return caller.IsOurs();
    }
  }
  return false;
}

/// Of all instructions that can raise exceptions; what is before the code of the operation is
/// skipped.
bool IsComparison(const unsigned char* instruction)
{
  const unsigned char* at = instruction;
  if (*at == 0xc5) // VEX of two bytes
  {
    at += 2;
  }
  else if (*at == 0xc4) // VEX of three bytes
  {
    at += 3;
  }
  else if (*at == 0x62) // EVEX
  {
    at += 4;
  }
  else
  {
    at += *at == 0x66 || *at == 0xf2 || *at == 0xf3 ? 1 : 0;
    at += (*at & 0xf0) == 0x40 ? 1 : 0; // REX
    if (*at++ != 0x0f)
    {
      return false;
    }
  }
  constexpr unsigned char Ucomis = 0x2e, Comis = 0x2f, Min = 0x5d, Max = 0x5f, Cmp = 0xc2;
  return *at == Ucomis || *at == Comis || *at == Min || *at == Max || *at == Cmp;
}

/// True for the first time that an address is asked for.
bool IsNew(std::uintptr_t address)
{
  static std::array<std::atomic<std::uintptr_t>, 1024> known;
  for (std::atomic<std::uintptr_t>& place : known)
  {
    std::uintptr_t there = 0;
    if (place.compare_exchange_strong(there, address))
    {
      return true;
    }
    if (there == address)
    {
      return false;
    }
  }
  return false; // a thousand are told
}

void Tell(int code, std::uintptr_t address)
{
  const char* what = code == FPE_FLTDIV ? "division by zero"
    : code == FPE_FLTOVF                ? "overflow"
    : code == FPE_FLTINV                ? "invalid operation"
                                        : "arithmetic exception";
  const int file = Reports[0] ? open(Reports.data(), O_WRONLY | O_CREAT | O_APPEND, 0666) : -1;
  const int out = file < 0 ? STDERR_FILENO : file;
  const Module module(address);
  dprintf(out, "TRAP: %s; addr2line -Cfie %s 0x%lx\n", what, module.Path(),
    static_cast<unsigned long>(address - module.Base));
  const Stack stack;
  const int first = stack.Find(address) % stack.Depth;
  backtrace_symbols_fd(stack.Calls.data() + first, stack.Depth - first, out);
  if (file >= 0)
  {
    close(file);
  }
}

template <typename Function>
Function Next(const char* name)
{
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

using SetAction = int (*)(int, const struct sigaction*, struct sigaction*);

/// \param handler none: as the system does
void Handle(int signal, void (*handler)(int, siginfo_t*, void*))
{
  struct sigaction action = {};
  if (handler)
  {
    action.sa_sigaction = handler;
    action.sa_flags = SA_SIGINFO | SA_NODEFER;
  }
  Next<SetAction>("sigaction")(signal, &action, nullptr);
}

void OnException(int, siginfo_t* info, void* data)
{
  mcontext_t& context = static_cast<ucontext_t*>(data)->uc_mcontext;
  const auto address = static_cast<std::uintptr_t>(context.gregs[REG_RIP]);
  if (info->si_code == FPE_INTDIV)
  {
    Handle(SIGFPE, nullptr); // there is no way on
    return;
  }
  const bool isAllowed =
    info->si_code == FPE_FLTINV && IsComparison(reinterpret_cast<const unsigned char*>(address));
  if (!isAllowed && IsOurs(address) && IsNew(address))
  {
    Tell(info->si_code, address);
  }
  context.fpregs->mxcsr |= Watched;
  context.gregs[REG_EFL] |= SingleStep;
}

void AfterOneInstruction(int, siginfo_t*, void* data)
{
  mcontext_t& context = static_cast<ucontext_t*>(data)->uc_mcontext;
  context.fpregs->mxcsr &= ~Watched;
  context.gregs[REG_EFL] &= ~SingleStep;
}

struct Start
{
  void* (*Function)(void*);
  void* Argument;
};

/// A thread whose signals are blocked (Mesa's) would be killed by its first exception.
void* Begin(void* data)
{
  const Start start = *static_cast<Start*>(data);
  delete static_cast<Start*>(data);
  sigset_t blocked;
  pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
  if (sigismember(&blocked, SIGFPE))
  {
    _mm_setcsr(_mm_getcsr() | Watched);
  }
  else
  {
    WatchThisThread();
  }
  return start.Function(start.Argument);
}

__attribute__((constructor)) void Watch()
{
  const char* below = std::getenv("TRAP_BELOW");
  const ssize_t length = readlink("/proc/self/exe", Program.data(), Program.size() - 1);
  if (!below || !*below || std::strlen(below) >= Below.size() || length < 0)
  {
    return;
  }
  std::strcpy(Below.data(), below);
  if (const char* reports = std::getenv("TRAP_REPORTS"))
  {
    std::snprintf(
      Reports.data(), Reports.size(), "%s/trap.%d", reports, static_cast<int>(getpid()));
  }
  const Stack unwinderIsLoaded;
  Handle(SIGFPE, OnException);
  Handle(SIGTRAP, AfterOneInstruction);
  WatchThisThread();
}

}

// What would switch traps or their handler off: VTK's test driver, tests in windows, Python. A
// thread inherits what the one that makes it has; what is blocked is asked for when it runs.
extern "C"
{

  int pthread_create(
    pthread_t* thread, const pthread_attr_t* attributes, void* (*function)(void*), void* argument)
  {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static const auto create = Next<Create>("pthread_create");
    if (!Below[0])
    {
      return create(thread, attributes, function, argument);
    }
    auto* start = new Start{ function, argument };
    const int result = create(thread, attributes, Begin, start);
    if (result != 0)
    {
      delete start;
    }
    return result;
  }

  int sigaction(int signal, const struct sigaction* action, struct sigaction* before)
  {
    static const auto next = Next<SetAction>("sigaction");
    const bool isOurs = Below[0] && (signal == SIGFPE || signal == SIGTRAP);
    return next(signal, isOurs ? nullptr : action, before);
  }

  sighandler_t signal(int number, sighandler_t handler)
  {
    using SetHandler = sighandler_t (*)(int, sighandler_t);
    static const auto next = Next<SetHandler>("signal");
    return Below[0] && (number == SIGFPE || number == SIGTRAP) ? SIG_DFL : next(number, handler);
  }

  int feenableexcept(int)
  {
    return 0;
  }

  int fedisableexcept(int)
  {
    return 0;
  }
}
