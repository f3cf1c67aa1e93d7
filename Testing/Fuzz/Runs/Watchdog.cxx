// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Runs/Watchdog.h"

#include <csignal>
#include <cstdlib>
#include <unistd.h>

namespace Fuzz
{
namespace Watchdog
{
namespace
{

unsigned Patience = 0;
void (*Bark)() = nullptr;

void HearAlarm(int)
{
  Bark();
  std::_Exit(EXIT_FAILURE);
}

}

void Release(unsigned seconds, void (*bark)())
{
  Patience = seconds;
  Bark = bark;
  std::signal(SIGALRM, HearAlarm);
}

void Feed()
{
  if (Patience > 0)
  {
    alarm(Patience);
  }
}

void Rest()
{
  alarm(0);
}

}
}
