#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build and run the benchmarks, from nothing if need be.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Build vtkTemporalCoherence and measure it: all scenarios of the program Benchmark (its --help tells
them), single kernels, and the paper's figures.

usage: Testing/Benchmarks/run.sh [--quick] [--output FOLDER] [--no-packages]

  --quick          small pictures and few frames: a minute, to see that all works
  --output FOLDER  where tables, JSON and figures go; default: benchmarks, in the build directory
  --no-packages    install no packages (see Module/setup.sh --help)
  --help           show this text

Volumes are looked for in the folder that TEMPORAL_COHERENCE_DATA names; those that are not there
are left out. Nothing else should run meanwhile. Without DISPLAY, charts and windows are drawn on
a display of their own. The exit status is not 0 if a program fails.
TEXT
}

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
export TEMPORAL_COHERENCE_BUILD=${TEMPORAL_COHERENCE_BUILD:-$repository/build}
build=$TEMPORAL_COHERENCE_BUILD
output=$build/benchmarks

say() { printf '[benchmarks] %s\n' "$*"; }
fail() { printf '[benchmarks] %s\n' "$*" >&2; exit 1; }

setup_options=(--with-tests)
quick=no
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --quick) quick=yes ;;
    --no-packages) setup_options+=("$1") ;;
    --output)
      [ $# -gt 1 ] || fail "--output needs a folder behind it."
      output=$2
      shift ;;
    *) fail "There is no option $1; --help lists those there are." ;;
  esac
  shift
done

scenarios=()
kernels=()
figures=()
if [ "$quick" = yes ]; then
  scenarios=(--quick)
  kernels=(--benchmark_min_time=0.01)
  figures=(--quick)
fi

# On the display there is, or on one of its own.
with_display() # COMMAND...
{
  local started=$output/started attempt display
  if [ -n "${DISPLAY:-}" ]; then
    "$@"
    return
  fi
  rm -f "$started"
  # A number far from 99, where everybody begins: in a container, xvfb-run does not see a server
  # of the machine around it, but clients of the same number would connect to that one.
  for attempt in 1 2 3 4 5; do
    display=$((200 + RANDOM % 700))
    # shellcheck disable=SC2016 # expanded by the inner shell
    xvfb-run --server-num="$display" --auto-servernum --server-args="-screen 0 1280x1024x24 -noreset" \
      bash -c 'touch "$0" && exec "$@"' "$started" "$@" && rm -f "$started" && return 0
    # What failed was the program, not the display.
    if [ -f "$started" ]; then
      rm -f "$started"
      return 1
    fi
    say "No X server at display $display (attempt $attempt of 5)" >&2
  done
  return 1
}

# Runs a program; what it prints goes into a file too.
measure() # TITLE FILE PROGRAM ARGUMENTS...
{
  local title=$1 file=$output/$2 program=$3 begin=$SECONDS
  shift 3
  say "$title: $program $*"
  with_display "$build/bin/$program" "$@" | tee "$file" ||
    fail "$program has failed; what it printed until then is in $file"
  say "$title: done in $((SECONDS - begin)) s"
}

"$repository/Module/setup.sh" "${setup_options[@]}"
mkdir -p "$output" 2>/dev/null ||
  fail "Cannot make the folder $output; name one that can be written in with --output."
output=$(cd "$output" && pwd)

measure "All scenarios" benchmark.md Benchmark "${scenarios[@]}" --json "$output/benchmark.json"
if [ -x "$build/bin/BenchmarkKernels" ]; then
  measure "Single kernels" kernels.txt BenchmarkKernels "${kernels[@]}" \
    --benchmark_out="$output/kernels.json" --benchmark_out_format=json
else
  say "Single kernels are left out: there is no Google Benchmark."
fi
if [ -x "$build/bin/PaperFigures" ]; then
  measure "The paper's figures" figures.md PaperFigures "${figures[@]}" --output "$output/figures"
else
  say "The paper's figures are left out: this VTK has no charts."
fi
say "Tables (.md, .txt), JSON and the folder of figures are in $output"
