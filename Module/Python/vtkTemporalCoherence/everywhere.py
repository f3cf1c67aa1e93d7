# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mapper for scripts that make VTK's own."""

from .vtkTemporalCoherence import vtkTemporalCoherenceObjectFactory

__all__ = ["use_everywhere"]


def use_everywhere(use: bool = True) -> None:
    """Let vtkTemporalCoherenceVolumeMapper draw the isosurfaces of VTK's own mappers.

    From now on each vtkGPUVolumeRayCastMapper, vtkSmartVolumeMapper and vtkMultiBlockVolumeMapper
    that is made draws blend mode ISOSURFACE_BLEND by temporal coherence, and everything else as
    ever. Those that were made before stay as they are.

    use    False: make VTK's own again

    VTK's log tells once in a process that it draws. The environment variable
    VTK_TEMPORAL_COHERENCE_LOG, set to OFF, switches that off.

    A script that is not to be changed gets the same where the environment variable
    VTK_AUTOLOAD_PATH names the directory vtkTemporalCoherence/autoload beside the library.
    """
    if use:
        vtkTemporalCoherenceObjectFactory.UseEverywhere()
    else:
        vtkTemporalCoherenceObjectFactory.UseNowhere()
