# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Temporal coherence: a volume mapper that re-uses the last frame
#
# License: BSD-3-Clause. Maintainers: the vtkTemporalCoherence authors.
# Needs GLM and Highway, see Documentation/Building.md of the module.
#
# To be put into Remote/ of VTK's tree. The address stands for the one at which the module is published.

vtk_fetch_module(TemporalCoherence
  "Isosurfaces of volumes, ray cast on the CPU, that re-use the last frame."
  GIT_REPOSITORY https://vtktemporalcoherence.invalid/vtkTemporalCoherence.git
  # vtkTemporalCoherence 0.3.0
  GIT_TAG v0.3.0
  )
