# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tests of a build, one by one, and whether a mutant passes them."""

import dataclasses
import json
import os
import re
import resource
import signal
import subprocess

ENGINE = "TemporalCoherenceEngineTests"
MAPPER = "vtkTemporalCoherenceCxxTests"  # makes a program for each folder of Testing/Cxx

# A mutant that asks for more than this is stopped, before the machine is out of memory.
MOST_BYTES = 16 << 30

# A test hangs that takes this many times the processor time that it takes without a mutant, or, where
# it waits for something, that much of the clock's.
PATIENCE, SECONDS_MORE = 10, 30
WAITING = 10


@dataclasses.dataclass
class Test:
    """One test program's run: a suite of the engine, or a test of the mapper."""

    name: str
    program: str
    command: list
    folder: str
    seconds: float = 0.0  # of processor time, without a mutant
    kills: int = 0
    refused: tuple = ()  # what a test that passes does not say, such as VTK's errors
    skipped: int = 0  # what it returns where it cannot be run here, if not 0


def run(test, limit):
    """What a test says, how it ended (passed, skipped, failed or hung), and the processor time it took."""
    def limit_resources():
        resource.setrlimit(resource.RLIMIT_AS, (MOST_BYTES, MOST_BYTES))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))

    used = lambda: sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
    before = used()
    with subprocess.Popen(
            test.command, cwd=test.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            errors="replace", start_new_session=True, preexec_fn=limit_resources) as process:
        try:
            output, _ = process.communicate(timeout=WAITING * limit)
            ends = {test.skipped: "skipped", 0: "passed", -signal.SIGXCPU: "hung"}
            end = ends.get(process.returncode, "failed")
            if end == "passed" and any(re.search(pattern, output) for pattern in test.refused):
                end = "failed"
            return output, end, used() - before
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            return process.communicate()[0], "hung", used() - before


def find_engine_tests(build):
    program = str(build / "bin" / ENGINE)
    listing = subprocess.run(
        [program, "--gtest_list_tests"], check=True, capture_output=True, text=True).stdout
    # A line that is not indented names a suite; what is behind a slash is one of its types.
    suites = [re.split(r"[./]", line)[0] for line in listing.splitlines()
              if re.match(r"\w+(/\d+)?\.", line)]
    return [Test(suite, ENGINE, [program, f"--gtest_filter={suite}.*:{suite}/*", "--gtest_fail_fast"],
                 str(build)) for suite in dict.fromkeys(suites)]


def find_mapper_tests(build):
    listing = json.loads(subprocess.run(
        ["ctest", "--show-only=json-v1"], cwd=build, check=True, capture_output=True,
        text=True).stdout)
    tests = []
    for entry in listing["tests"]:
        command = entry.get("command", [])
        if any(re.fullmatch(r"vtkTemporalCoherenceCxx\w+Tests", os.path.basename(part))
               for part in command):
            properties = {p["name"]: p["value"] for p in entry.get("properties", [])}
            tests.append(Test(entry["name"].split("-", 1)[-1], MAPPER, command,
                              properties.get("WORKING_DIRECTORY", str(build)),
                              refused=tuple(properties.get("FAIL_REGULAR_EXPRESSION", ())),
                              skipped=int(properties.get("SKIP_RETURN_CODE", 0))))
    return tests


def measure(tests, record):
    """Run tests without a mutant for the time that each takes; those known already are not run."""
    for test in tests:
        if test.name not in record:
            output, end, seconds = run(test, 600)
            if end not in ("passed", "skipped"):
                raise RuntimeError(f"{test.name} {end} without a mutant:\n{output[-4000:]}")
            record[test.name] = round(seconds, 2)
        test.seconds = record[test.name]


def first_failure(tests):
    """The test that a mutant does not pass, how it ended and what it said, or None. Those that are
    quick and have caught others come first."""
    for test in sorted(tests, key=lambda test: (test.seconds + 0.2) / (1 + test.kills)):
        output, end, _ = run(test, int(PATIENCE * test.seconds) + SECONDS_MORE)
        if end not in ("passed", "skipped"):
            test.kills += 1
            return test, end, output
    return None
