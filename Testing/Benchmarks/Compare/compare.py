#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compare cold frames of two builds of this module, drawn in turn, as a Markdown table.

Each build is a build directory with its Python module: that of another commit, or the same one
twice with two numbers of threads. Each scene is drawn by both builds, each in a process of its own,
in turn, five frames a turn. The table shows the least of all frames: their CPU time of all threads,
or their wall time. Nothing else should run meanwhile. Volumes that are not in the folder that
TEMPORAL_COHERENCE_DATA names are left out.

With --layers the scenes are see-through ones, and what a layer takes stands beside what a hit of
the second build's opaque frame takes.
"""

from __future__ import annotations

import argparse
import contextlib
import dataclasses
import json
import os
import pathlib
import subprocess
import sys

import scenes

QUICK = {"size": 128, "rounds": 1, "scenes": [0, 3, 10, 12]}
QUICK_LAYERS = [2]
HERE = pathlib.Path(__file__).resolve().parent


class Failure(Exception):
    """What cannot be measured; the text is a sentence for the user."""


@dataclasses.dataclass(frozen=True)
class Build:
    """One side of the comparison."""

    name: str
    folder: pathlib.Path
    threads: int  # 0: all

    def start(self, scene: dict) -> subprocess.Popen:
        """A process that draws a scene when it is asked to."""
        module = self.folder / "python"
        if not (module / "vtkTemporalCoherence").is_dir():
            raise Failure(f"{self.folder} is no build directory with a Python module: name one.")
        paths = [str(module), *filter(None, [os.environ.get("PYTHONPATH")])]
        environment = dict(os.environ, PYTHONPATH=os.pathsep.join(paths))
        if self.threads:
            environment["VTK_SMP_MAX_THREADS"] = str(self.threads)
        return subprocess.Popen(
            [sys.executable, str(HERE / "worker.py"), json.dumps(scene)], env=environment,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def ask(worker: subprocess.Popen, request: str):
    """What a worker answers to a request."""
    try:
        worker.stdin.write(request + "\n")
        worker.stdin.flush()
    except BrokenPipeError:
        pass  # what it said before is there to be read
    answer = worker.stdout.readline()
    if not answer:
        raise Failure("A build cannot draw the scene, for the reason above.")
    return json.loads(answer)


def stop(worker: subprocess.Popen) -> None:
    """End a worker, which may have ended itself."""
    with contextlib.suppress(BrokenPipeError):
        worker.stdin.close()
    worker.wait()
    worker.stdout.close()


def least_times(workers, rounds: int, kind: int) -> list[float]:
    """The least time of each worker, of so many turns."""
    least = [float("inf")] * len(workers)
    for _ in range(rounds):
        for side, worker in enumerate(workers):
            least[side] = min(least[side], ask(worker, "turn")[kind])
    return least


def compare(sides, arguments) -> list[dict]:
    """A row for each view; none if the volume is not there.

    Each side is a build and the scene that it draws.
    """
    kind = ("cpu", "wall").index(arguments.time)
    rows = []
    workers = []
    try:
        for build, scene in sides:
            workers.append(build.start(dict(dataclasses.asdict(scene), size=arguments.size,
                                            avx512=not arguments.no_avx512)))
        for view in arguments.views:
            hits = [ask(worker, view) for worker in workers]
            if None in hits:
                print(f"{sides[0][1].volume} is left out: it is not in the folder that "
                      "TEMPORAL_COHERENCE_DATA names.", file=sys.stderr)
                break
            times = least_times(workers, arguments.rounds, kind)
            rows.append({"view": view, "hitPercent": hits, "ms": times,
                         "layers": [ask(worker, "layers") for worker in workers]})
    finally:
        for worker in workers:
            stop(worker)
    return rows


def print_row(cells) -> None:
    print("| " + " | ".join(cells) + " |", flush=True)


def print_table(builds, arguments) -> list[dict]:
    """Measure and print, row by row; what was measured."""
    names = [build.name for build in builds]
    head = ["volume", "isovalue", "hit"]
    for view in arguments.views:
        head += [f"{view}: {names[0]}", names[1], "ratio"]
    print_row(head)
    print_row(["---"] * len(head))
    results = []
    for number in arguments.scenes or range(len(scenes.SCENES)):
        scene = scenes.SCENES[number]
        rows = compare([(build, scene) for build in builds], arguments)
        if not rows:
            continue
        hits = ", ".join(f"{row['hitPercent'][1]:.0f}" for row in rows) + " %"
        cells = [scene.title(), ", ".join(f"{value:g}" for value in scene.isovalues), hits]
        for row in rows:
            first, second = row["ms"]
            cells += [f"{first:.1f}", f"{second:.1f}", f"{second / first:.2f}"]
            if abs(row["hitPercent"][0] - row["hitPercent"][1]) > 0.01:
                print(f"{scene.title()}: the builds hit {row['hitPercent']} % of the pixels.",
                      file=sys.stderr)
        print_row(cells)
        results.append(dict(dataclasses.asdict(scene), views=rows))
    return results


def print_layers(builds, arguments) -> list[dict]:
    """The same of see-through scenes, a view a row."""
    names = [build.name for build in builds]
    head = ["volume", "isovalue", "view", "layers", *names, "times faster", "ns a layer",
            "ns a hit", "ratio"]
    print_row(head)
    print_row(["---"] * len(head))
    results = []
    for number in arguments.scenes or range(len(scenes.LAYERS)):
        scene = scenes.LAYERS[number]
        opaque = dataclasses.replace(scene, opacity=1.0)
        rows = compare([(builds[0], scene), (builds[1], scene), (builds[1], opaque)], arguments)
        for row in rows:
            before, now, solid = row["ms"]
            layers = row["layers"][1]
            hits = 0.01 * row["hitPercent"][2] * arguments.size ** 2
            each, hit = 1e6 * now / layers, 1e6 * solid / hits
            print_row([scene.title(), ", ".join(f"{value:g}" for value in scene.isovalues),
                       row["view"], f"{1e-6 * layers:.2f} M", f"{before:.0f}", f"{now:.0f}",
                       f"{before / now:.1f}", f"{each:.0f}", f"{hit:.0f}", f"{each / hit:.2f}"])
        results += [dict(dataclasses.asdict(scene), views=rows)] if rows else []
    return results


def numbers(text: str) -> list[int]:
    return [int(part) for part in text.split(",")]


def view_names(text: str) -> list[str]:
    names = text.split(",")
    for name in names:
        if name not in scenes.VIEWS:
            known = " and ".join(scenes.VIEWS)
            raise argparse.ArgumentTypeError(f"there is no view '{name}', only {known}")
    return names


def read_arguments() -> argparse.Namespace:
    listed = "\n".join(
        f"  {number:2}  {scene.title()} {', '.join(f'{value:g}' for value in scene.isovalues)}"
        for known in (scenes.SCENES, scenes.LAYERS) for number, scene in enumerate(known))
    parser = argparse.ArgumentParser(
        description=__doc__, epilog="scenes, and those of --layers:\n" + listed,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("builds", nargs=2, type=pathlib.Path, metavar="BUILD", help="a build directory")
    add("--names", default="before,now", help="what the table calls them (before,now)")
    add("--scenes", type=numbers, metavar="NUMBER,...", help="only these of the scenes below (all)")
    add("--views", type=view_names, default=list(scenes.VIEWS), metavar="NAME,...",
        help="only these of whole and close: ResetCamera, Azimuth 30, Elevation 20, Zoom 1.3 or 2.2")
    add("--layers", action="store_true", help="see-through scenes: surfaces of opacity 0.4")
    add("--size", type=int, help="pixels of a picture in each direction (1024)")
    add("--rounds", type=int, help="turns of each build (5)")
    add("--time", choices=("cpu", "wall"), default="cpu", help="which time the table shows (cpu)")
    add("--threads", type=numbers, default=[0], metavar="NUMBER[,NUMBER]",
        help="threads of both builds, or of the first and the second (all)")
    add("--no-avx512", action="store_true", help="vectors of AVX2 at most")
    add("--quick", action="store_true",
        help="small pictures, one turn and few scenes, to see that all works")
    add("--json", type=pathlib.Path, metavar="FILE", help="write all figures to this file too")
    arguments = parser.parse_args()
    known = scenes.LAYERS if arguments.layers else scenes.SCENES
    quick = dict(QUICK, scenes=QUICK_LAYERS) if arguments.layers else QUICK
    for name, usual in (("size", 1024), ("rounds", 5), ("scenes", None)):
        if getattr(arguments, name) is None:
            setattr(arguments, name, quick[name] if arguments.quick else usual)
    if min(arguments.size, arguments.rounds) < 1 or min(arguments.threads) < 0:
        parser.error("--size, --rounds and --threads need numbers above 0")
    if not all(0 <= number < len(known) for number in arguments.scenes or []):
        parser.error("--scenes needs numbers of the list below --help")
    arguments.names = arguments.names.split(",")
    if len(arguments.names) != 2 or len(arguments.threads) > 2:
        parser.error("--names needs two names, --threads one or two numbers")
    return arguments


def main() -> None:
    arguments = read_arguments()
    threads = 2 * arguments.threads
    builds = [Build(name, folder, count) for name, folder, count in
              zip(arguments.names, arguments.builds, threads)]
    print(f"{arguments.size} x {arguments.size} pixels; milliseconds, the least "
          f"{arguments.time} time of cold frames in {arguments.rounds} turns"
          f"{', without AVX-512' if arguments.no_avx512 else ''}\n")
    try:
        results = (print_layers if arguments.layers else print_table)(builds, arguments)
    except Failure as failure:
        sys.exit(str(failure))
    if arguments.json:
        arguments.json.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    if not results:
        sys.exit("Nothing was measured.")


if __name__ == "__main__":
    main()
