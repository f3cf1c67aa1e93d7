// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/KernelsBeam.h"

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsBeam.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsBeam-inl.h"
#include "Lattice/KernelsBeamTree-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

template <bool IsPlain, class Lattice>
void SearchIn(const Lattice& lattice, const BeamTask& task, BeamScene& scene, TileBeam& beam)
{
  using Cells = CellSearch<IsPlain, Lattice>;
  Cells cells(task, lattice, scene, beam);
  BeamTree<Cells, Lattice>(task.Active, scene, lattice, beam, cells).Visit();
  cells.Decide();
}

template <class Lattice>
void SearchAny(const Lattice& lattice, const BeamTask& task, BeamScene& scene, TileBeam& beam)
{
  if (beam.IsPlain)
  {
    SearchIn<true>(lattice, task, scene, beam);
    return;
  }
  SearchIn<false>(lattice, task, scene, beam);
}

void Search(const BeamTask& task, BeamScene& scene, TileBeam& beam)
{
  if (task.Grid)
  {
    SearchAny(RectilinearLattice(beam, *task.Grid), task, scene, beam);
    return;
  }
  SearchAny(UniformLattice(beam), task, scene, beam);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace BeamKernels
{
HWY_EXPORT(Search);
}

void SearchBeam(const BeamTask& task, BeamScene& scene, TileBeam& beam)
{
  using namespace BeamKernels;
  HWY_DYNAMIC_DISPATCH(Search)(task, scene, beam);
}

}
#endif
