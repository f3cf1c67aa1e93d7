#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The tests notice small mistakes in the engine and the bridge.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Make small changes to the engine, mutants, and tell which of them no test notices.

usage: Testing/Mutants/run.sh [OPTIONS] [NAMES]

  NAMES           only these mutants, whatever is known of them (see --list)
  --named         only the mutants of named.json
  --random N      and N that are drawn from all comparisons, margins, indices, ...; default: 60
  --seed S        which ones; default: 1
  --quick         leave out tests that take long; what gets past the others is doubtful, and tried
                  again without this option
  --again STATE   try those again that survived, or were killed, hung, refused or doubtful; or all
  --judged        try those too that judged.json knows to change nothing but speed
  --jobs N        for the compiler; default: 2
  --list          name the mutants, try none
  --report        print what is known of them, try none
  --no-packages   install no packages (see Module/setup.sh --help)
  --help          show this text

Every mutant is built in a copy of the tree, below build/mutants, and compared with the engine's own
tests and then those of the mapper, until one of them fails. What became of it is kept in
build/mutants/results.jsonl: another run goes on where the last one was stopped. All 60 take some
hours on two cores; ccache, where it is installed, makes what changes back free.

environment:
  TEMPORAL_COHERENCE_BUILD   the build directory; default: build, in the repository

The exit status is 0 only if every mutant was tried and killed, or is judged in judged.json.
TEXT
}

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
export TEMPORAL_COHERENCE_BUILD=${TEMPORAL_COHERENCE_BUILD:-$repository/build}
# shellcheck source-path=SCRIPTDIR source=../Common/Display.sh
. "$repository/Testing/Common/Display.sh"

setup_options=(--with-tests --packages-only)
arguments=()
needs_display=yes
for argument in "$@"; do
  case $argument in
    --help | -h) usage; exit 0 ;;
    --no-packages) setup_options+=("$argument") ;;
    --list) needs_display=no; arguments+=("$argument") ;;
    *) arguments+=("$argument") ;;
  esac
done
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}
fi

mutate=(python3 -B "$repository/Testing/Mutants/mutate.py" --place "$TEMPORAL_COHERENCE_BUILD/mutants"
  "${arguments[@]}")
if [ "$needs_display" = no ]; then
  exec "${mutate[@]}"
fi
"$repository/Module/setup.sh" "${setup_options[@]}"
if on_own_display "${mutate[@]}"; then
  printf '[mutants] PASSED: no mutant that matters survived\n'
else
  printf '[mutants] FAILED: see above\n'
  exit 1
fi
