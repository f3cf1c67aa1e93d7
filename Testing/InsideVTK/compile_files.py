#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compile the files of one part of a build, and nothing that the build would make before them.

A build with Ninja waits for all libraries that a part of VTK needs, even if its files only include
their headers. The compiler does not. What to run is in the compile_commands.json of the build.
"""

import argparse
import concurrent.futures
import json
import os
import subprocess
import sys


def commands_of(build, part):
    """The commands of the files whose objects lie below PART of the build directory."""
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        entries = json.load(file)
    marker = f" -o {part}/"
    return [entry for entry in entries if marker in entry["command"]]


def compile_file(entry):
    """Run one command; what it said, and whether it failed."""
    target = entry["command"].split(" -o ")[1].split(" ")[0]
    os.makedirs(os.path.dirname(os.path.join(entry["directory"], target)), exist_ok=True)
    result = subprocess.run(entry["command"], cwd=entry["directory"], shell=True, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return entry["file"], result.stdout, result.returncode != 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("build", help="the build directory, with compile_commands.json")
    parser.add_argument("part", help="a directory of the build, relative to it")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="compilers at once")
    arguments = parser.parse_args()

    commands = commands_of(arguments.build, arguments.part)
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for file, output, is_failed in pool.map(compile_file, commands):
            failed += is_failed
            if output:
                print(f"{file}:\n{output}", flush=True)
    print(f"{len(commands)} files, {failed} of them with errors")
    sys.exit(1 if failed or not commands else 0)


if __name__ == "__main__":
    main()
