# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which small changes of the engine do the tests notice? run.sh --help says more."""

import argparse
import fcntl
import json
import pathlib
import sys
import time

import sites
import suite
import tree

HERE = pathlib.Path(__file__).resolve().parent
EXCUSED = ("equivalent", "speed")
QUICK = 8.0  # seconds that a quick test takes at most


def read_options():
    parser = argparse.ArgumentParser(prog="Testing/Mutants/run.sh", add_help=False)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--random", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--named", action="store_true")
    parser.add_argument("--again", action="append", default=[],
                        choices=["survived", "doubtful", "killed", "hung", "refused", "all"])
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--judged", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--report", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--place", type=pathlib.Path, required=True)
    return parser.parse_args()


def choose(options, copy):
    """The mutants that are asked for."""
    named = sites.read_named(HERE / "named.json", copy.read)
    all_sites = [m for file in copy.sources() for m in sites.find_sites(file, copy.read(file))]
    if options.names:
        there = {mutant.name: mutant for mutant in named + all_sites}
        unknown = [name for name in options.names if name not in there]
        if unknown:
            raise sites.NoSuchSource(f"There is no mutant {', '.join(unknown)}; --list names them.")
        return [there[name] for name in options.names]
    return named + ([] if options.named else sites.draw(all_sites, options.random, options.seed))


def read_judged():
    """What was judged by hand, by name of the mutant."""
    judged = json.loads((HERE / "judged.json").read_text(encoding="utf-8"))["judged"]
    return {entry["name"]: entry for entry in judged}


class Results:
    """What became of mutants, in a file that outlives this run."""

    def __init__(self, path):
        self.path = path
        self.all = {}
        if path.exists():
            for line in path.read_text().splitlines():
                record = json.loads(line)
                self.all[record["name"]] = record

    def is_known(self, mutant, again, is_quick):
        record = self.all.get(mutant.name)
        if record and record["state"] == "doubtful" and not is_quick:
            return False
        return bool(record) and record["context"] == mutant.context and \
            record["put"] == mutant.put and not {record["state"], "all"} & set(again)

    def add(self, mutant, state, by, seconds):
        record = {"name": mutant.name, "context": mutant.context, "put": mutant.put,
                  "state": state, "by": by, "seconds": round(seconds)}
        self.all[mutant.name] = record
        with self.path.open("a") as file:
            file.write(json.dumps(record) + "\n")
        return record


def try_mutant(mutant, copy, engine_tests, mapper_tests, is_quick):
    """Build a mutant and run tests until one notices: its state, and who noticed. Where it gets past
    quick tests alone, it is doubtful."""
    copy.plant(mutant)
    try:
        programs = [(suite.ENGINE, engine_tests), (suite.MAPPER, mapper_tests)]
        for program, tests in programs[mutant.file.startswith("Vtk/"):]:
            if copy.make(program):
                return "refused", "the compiler"
            quick = [test for test in tests if test.seconds <= QUICK]
            if failure := suite.first_failure(quick if is_quick else tests):
                test, end, output = failure
                is_checked = "Assertion '" in output
                by = f"the standard library's checks in {test.name}" if is_checked else test.name
                return ("hung" if end == "hung" else "killed"), by
        return ("doubtful" if is_quick else "survived"), ""
    finally:
        copy.restore(mutant)


def verdict_on(record, judged):
    """The state of a mutant, with the judgement of those that survived."""
    entry = judged.get(record["name"])
    if record["state"] in ("survived", "doubtful") and entry:
        return entry["verdict"]
    return record["state"]


def report(mutants, results, judged):
    """Print a table and the score. True if all were tried and nothing that matters got through."""
    count, untried = {}, 0
    print("\n| mutant | line | change | verdict | by |\n|---|---|---|---|---|")
    for mutant in mutants:
        record = results.all.get(mutant.name)
        if not record:
            untried += 1
            continue
        verdict = verdict_on(record, judged)
        count[verdict] = count.get(verdict, 0) + 1
        why = judged[mutant.name]["reason"] if verdict in EXCUSED else record["by"]
        change = mutant.name if mutant.kind == "named" else mutant.change().replace("|", "\\|")
        print(f"| {mutant.name} | {mutant.file}:{mutant.line} | {change} | {verdict} | {why} |")
    killed = count.get("killed", 0) + count.get("hung", 0)
    compiled = sum(count.values()) - count.get("refused", 0)
    excused = sum(count.get(verdict, 0) for verdict in EXCUSED)
    wrong = [name for name in judged if results.all.get(name, {}).get("state") in ("killed", "hung")]
    for name in wrong:
        print(f"[mutants] {name} is judged {judged[name]['verdict']}, but was killed: judge it anew.")
    counts = ", ".join(f"{number} {verdict}" for verdict, number in sorted(count.items()))
    share = 100.0 * killed / max(1, compiled - excused)
    print(f"\n[mutants] {counts}")
    print(f"[mutants] score: {killed} of {compiled - excused} killed, {share:.1f} %; "
          f"{excused} change nothing but speed, {count.get('refused', 0)} do not compile")
    if untried:
        print(f"[mutants] {untried} of {len(mutants)} were not tried")
    return not (wrong or untried or count.get("survived", 0) or count.get("doubtful", 0))


def main():
    options = read_options()
    sys.stdout.reconfigure(line_buffering=True)
    repository = HERE.parent.parent
    copy = tree.Tree(repository, options.place, options.jobs)
    try:
        mutants = choose(options, copy)
    except sites.NoSuchSource as error:
        sys.exit(f"[mutants] {error}")
    if options.list:
        for mutant in mutants:
            print(f"{mutant.name:32} {mutant.kind:11} {mutant.file}:{mutant.line}: {mutant.change()}")
        return
    judged = read_judged()
    options.place.mkdir(parents=True, exist_ok=True)
    guard = (options.place / "lock").open("w")
    try:
        fcntl.flock(guard, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        sys.exit(f"[mutants] Another run works in {options.place}; wait until it ends.")
    results = Results(options.place / "results.jsonl")
    again = list(options.again) + (["all"] if options.names else [])
    todo = [m for m in mutants if not results.is_known(m, again, options.quick)
            and (options.judged or options.names or m.name not in judged)]
    for mutant in mutants:
        if mutant.name in judged and mutant not in todo and mutant.name not in results.all:
            results.all[mutant.name] = {"name": mutant.name, "state": "survived", "by": ""}

    if options.report:
        todo = []
    # A header is built into many files: such mutants wait until the others have been seen.
    todo.sort(key=lambda mutant: mutant.kind != "named" and mutant.file.endswith(".h"))

    if todo:
        print(f"[mutants] {len(todo)} to try, {len(mutants) - len(todo)} known; building in {copy.copy}")
        copy.update()
        copy.configure()
        engine_tests, mapper_tests = copy.tests()
        times = options.place / "seconds.json"
        record = json.loads(times.read_text()) if times.exists() else {}
        try:
            suite.measure(engine_tests + mapper_tests, record)
        finally:
            times.write_text(json.dumps(record, indent=1))
        for earlier in results.all.values():
            for test in engine_tests + mapper_tests:
                test.kills += earlier["by"].endswith(test.name)
    for number, mutant in enumerate(todo, 1):
        begin = time.monotonic()
        state, by = try_mutant(mutant, copy, engine_tests, mapper_tests, options.quick)
        made = results.add(mutant, state, by, time.monotonic() - begin)
        print(f"[mutants] {number}/{len(todo)} {mutant.name} ({mutant.file}:{mutant.line}, "
              f"{mutant.change()[:60]}): {state}{' by ' + by if by else ''}, {made['seconds']} s")
    sys.exit(0 if report(mutants, results, judged) else 1)


if __name__ == "__main__":
    main()
