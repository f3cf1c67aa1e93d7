# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What two builds are compared on. Volumes and views are those of the program Benchmark."""

from __future__ import annotations

import dataclasses


@dataclasses.dataclass(frozen=True)
class Scene:
    """A volume, and how its surfaces are drawn."""

    volume: str  # a file below TEMPORAL_COHERENCE_DATA, or spheres, marschner-lobb and a size
    isovalues: tuple[float, ...]
    sample_type: str = ""  # a type of NumPy; empty: as in the file
    is_threshold: bool = False  # surface mode THRESHOLD, not CROSSING
    is_rectilinear: bool = False  # on coordinates of uneven steps
    opacity: float = 1.0

    def title(self) -> str:
        """The first column of the table."""
        ways = [self.volume]
        ways += [f"as {self.sample_type}"] if self.sample_type else []
        ways += ["THRESHOLD"] if self.is_threshold else []
        ways += ["rectilinear grid"] if self.is_rectilinear else []
        return ", ".join(ways)


ENGINE = Scene("engine.vti", (70.0,))

SCENES = (
    Scene("spheres256", (100.0,)),
    Scene("marschner-lobb256", (128.0,)),
    Scene("marschner-lobb512", (128.0,)),
    ENGINE,
    Scene("brain.vti", (40.0,)),
    Scene("bonsai.vti", (40.0,)),
    Scene("heptane.vti", (60.0,)),
    dataclasses.replace(ENGINE, sample_type="int16"),
    dataclasses.replace(ENGINE, sample_type="float32"),
    dataclasses.replace(ENGINE, sample_type="float64"),
    dataclasses.replace(ENGINE, is_threshold=True),
    dataclasses.replace(ENGINE, isovalues=(70.0, 120.0, 180.0)),
    dataclasses.replace(ENGINE, is_rectilinear=True),
)

# See-through ones.
LAYERS = tuple(dataclasses.replace(scene, opacity=0.4) for scene in (
    ENGINE,
    Scene("brain.vti", (40.0,)),
    Scene("spheres256", (100.0,)),
    Scene("marschner-lobb256", (128.0,)),
    Scene("cthead.vti", (600.0, 1500.0)),
    dataclasses.replace(ENGINE, is_threshold=True),
))

# Zooms behind ResetCamera, Azimuth 30, Elevation 20.
VIEWS = {"whole": 1.3, "close": 2.2}
