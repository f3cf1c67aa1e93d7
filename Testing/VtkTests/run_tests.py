#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run VTK's tests of volume mappers by each door, and keep pictures, logs and exit statuses.

Each run has a folder PLACE/RUN with NAME.png and NAME.log; PLACE/results.json has for each test the
file of VTK's data that is missing (or null), and for each run the exit status and the seconds. The
status is null for a run that took too long.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import tempfile
import time

# A run: which programs, whether they get the factory, and what becomes of the volumes in them
# (ChangedScene.h).
RUNS = {
    "vtk": ("unchanged", False, None),
    "factory": ("unchanged", True, None),
    "renamed": ("renamed", False, None),
    "hidden": ("renamed", False, "hidden"),
    "polygons": ("renamed", False, "polygons"),
    "surfaces-factory": ("unchanged", True, "surfaces"),
    "surfaces-renamed": ("renamed", False, "surfaces"),
    "surfaces-polygons": ("renamed", False, "surfaces-polygons"),
}


def missing_data(source, data):
    """The first file that a test names and VTK's data lacks."""
    for name in re.findall(r'"/?(Data/[^"]*)"', source.read_text(encoding="utf-8")):
        # Slices are named by their prefix.
        if not list(data.glob(name + "*")):
            return name
    return None


def asks_no_factory(source):
    """True if a test makes its mapper by a New() of VTK that asks no factory."""
    return "vtkOpenGLGPUVolumeRayCastMapper" in source.read_text(encoding="utf-8")


def run_test(arguments, run, name):
    """The exit status of a test, or None if it took too long, and the seconds."""
    variant, has_factory, scene = RUNS[run]
    folder = arguments.place / run
    folder.mkdir(parents=True, exist_ok=True)
    picture = folder / f"{name}.png"
    picture.unlink(missing_ok=True)
    environment = {key: value for key, value in os.environ.items() if not key.startswith("VTK_")}
    if has_factory:
        environment["VTK_AUTOLOAD_PATH"] = str(arguments.autoload)
        # Whatever OpenGL runs on: what VTK's mapper blends is compared byte for byte.
        environment["VTK_TEMPORAL_COHERENCE_BLEND_VOLUMES"] = "NEVER"
        if asks_no_factory(arguments.sources / f"{name}.cxx"):
            environment["LD_PRELOAD"] = str(next(arguments.autoload.glob("*.so")))
    if scene:
        environment["VTK_TESTS_SCENE"] = scene
    # A baseline that is not there makes VTK write the picture, from what the window shows.
    command = [arguments.programs / variant / name, "-D", arguments.data, "-T", folder,
               "-V", f"/no/baseline/{name}.png", "-NoRerender"]
    begin = time.monotonic()
    with tempfile.TemporaryDirectory() as scratch, open(folder / f"{name}.log", "wb") as log:
        try:
            status = subprocess.run(
                command, env=environment, cwd=scratch, stdin=subprocess.DEVNULL, stdout=log,
                stderr=subprocess.STDOUT, timeout=arguments.limit, check=False).returncode
        except subprocess.TimeoutExpired:
            status = None
    return status, round(time.monotonic() - begin, 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("sources", type=pathlib.Path, help="folder of the unchanged tests")
    parser.add_argument("programs", type=pathlib.Path, help="folder of unchanged/ and renamed/")
    parser.add_argument("data", type=pathlib.Path, help="VTK's testing data, with Data/ in it")
    parser.add_argument("place", type=pathlib.Path, help="folder for what comes out")
    parser.add_argument("--autoload", type=pathlib.Path, required=True,
                        help="what VTK_AUTOLOAD_PATH becomes")
    parser.add_argument("--only", default="", help="run the tests whose names match this pattern")
    parser.add_argument("--runs", nargs="+", choices=RUNS, default=list(RUNS), help="only these")
    parser.add_argument("--limit", type=float, default=300, help="seconds for a run")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="tests at once")
    arguments = parser.parse_args()

    file = arguments.place / "results.json"
    arguments.place.mkdir(parents=True, exist_ok=True)
    results = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
    todo = []
    for source in sorted(arguments.sources.glob("*.cxx")):
        name = source.stem
        if not re.search(arguments.only, name):
            continue
        result = results.setdefault(name, {"runs": {}})
        result["missing"] = missing_data(source, arguments.data)
        if not result["missing"]:
            todo += [(run, name) for run in arguments.runs
                     if (arguments.programs / RUNS[run][0] / name).exists()]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for (run, name), (status, seconds) in zip(
                todo, pool.map(lambda each: run_test(arguments, *each), todo)):
            results[name]["runs"][run] = {"status": status, "seconds": seconds}
            print(f"{run} {name}: status {status}, {seconds} s", flush=True)
            file.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
