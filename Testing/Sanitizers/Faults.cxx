// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What each sanitizer has to report. A net that catches nothing looks like code without faults, so
// run.sh makes these before it believes a silent suite.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <thread>

namespace
{

// Volatile: the compiler knows no values.
volatile int One = 1;
volatile double Zero = 0.0, Huge = 1e300;
volatile double Result = 0.0;
int Shared = 0;

void UseAfterFree()
{
  int* gone = new int(One);
  delete gone;
  Result = *gone;
}

void Leak()
{
  volatile std::size_t size = 100;
  // Nothing on the stack may still point to it.
  for (int i = 0; i < 10; ++i)
  {
    char* volatile lost = static_cast<char*>(std::malloc(size));
    lost[0] = 'a';
    lost = nullptr;
  }
}

void IntegerOverflow()
{
  Result = std::numeric_limits<int>::max() + One;
}

void FloatToInteger()
{
  Result = static_cast<int>(Huge);
}

void Race()
{
  std::thread other([] { ++Shared; });
  ++Shared;
  other.join();
}

void DivisionByZero()
{
  Result = One / Zero;
}

/// In a thread, and in the library of functions.
void InvalidLogarithm()
{
  std::thread([] { Result = std::log(-1.0 * One); }).join();
}

void Overflow()
{
  Result = Huge * Huge;
}

}

int main(int argc, char* argv[])
{
  const std::string fault = argc > 1 ? argv[1] : "";
  if (fault == "use-after-free")
  {
    UseAfterFree();
  }
  else if (fault == "leak")
  {
    Leak();
  }
  else if (fault == "integer-overflow")
  {
    IntegerOverflow();
  }
  else if (fault == "float-to-integer")
  {
    FloatToInteger();
  }
  else if (fault == "race")
  {
    Race();
  }
  else if (fault == "division-by-zero")
  {
    DivisionByZero();
  }
  else if (fault == "invalid-logarithm")
  {
    InvalidLogarithm();
  }
  else if (fault == "overflow")
  {
    Overflow();
  }
  else
  {
    std::printf("There is no fault %s.\n", fault.c_str());
  }
  return EXIT_SUCCESS;
}
