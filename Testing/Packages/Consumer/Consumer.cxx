// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Includes every public header, and makes one of each class of the library.
#include <vtkNew.h>
#include <vtkTemporalCoherencePicker.h>
#include <vtkTemporalCoherenceVolume.h>
#include <vtkTemporalCoherenceVolumeMapper.h>

#include <cstdlib>

int main()
{
  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  vtkNew<vtkTemporalCoherenceVolume> volume;
  vtkNew<vtkTemporalCoherencePicker> picker;
  volume->SetMapper(mapper);
  return volume->GetMapper() == mapper ? EXIT_SUCCESS : EXIT_FAILURE;
}
