// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Mappers that are made behind the factory and deleted leave no memory behind.

#include "Checks/Expect.h"
#include "Checks/ProcessMemory.h"
#include "Checks/Sanitized.h"
#include "Checks/Skip.h"
#include "vtkTemporalCoherenceGPUVolumeRayCastMapper.h"
#include "vtkTemporalCoherenceObjectFactory.h"

#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkNew.h>

#include <cmath>
#include <cstdlib>

namespace
{

void Make(int count)
{
  for (int i = 0; i < count; ++i)
  {
    const vtkNew<vtkGPUVolumeRayCastMapper> mapper;
    Expect(vtkTemporalCoherenceGPUVolumeRayCastMapper::SafeDownCast(mapper), "the factory is used");
  }
}

}

int TestEverywhereMemory(int, char*[])
{
  if (IsMemorySanitized || std::isnan(ProcessMemory::Resident()))
  {
    return Skip(IsMemorySanitized ? "this is a build with a sanitizer, which keeps what is freed"
                                  : "this system does not tell how much memory a process has");
  }
  vtkTemporalCoherenceObjectFactory::UseEverywhere();
  Make(200);
  const double before = ProcessMemory::Resident();
  Make(1000);
  const double lost = ProcessMemory::Resident() - before;
  Expect(
    lost <= 1 << 20, std::to_string(lost) + " bytes are lost in 1000 mappers made and deleted");
  vtkTemporalCoherenceObjectFactory::UseNowhere();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
