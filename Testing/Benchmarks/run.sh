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
them) with plots of some, and single kernels: what Documentation/Performance.md tells. Pictures and
the paper's figures are made by Documentation/gallery.sh, which calls this with --only.

usage: Testing/Benchmarks/run.sh [--only PART,...] [--quick] [--output FOLDER] [--no-packages]

  --only PART,...  of scenarios, kernels (these two are the default), figures (those of the paper),
                   pictures (routes and features)
  --quick          small pictures and few frames: a minute, to see that all works
  --output FOLDER  where tables, JSON, plots and pictures go; default: benchmarks, in the build
                   directory
  --no-packages    install no packages (see Module/setup.sh --help)
  --built          build nothing: the build directory is up to date
  --help           show this text

Volumes are looked for in the folder that TEMPORAL_COHERENCE_DATA names; those that are not there
are left out, or others shown in their place. Nothing else should run meanwhile. Without DISPLAY,
charts and windows are drawn on a display of their own. The exit status is not 0 if a program fails.
TEXT
}

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
export TEMPORAL_COHERENCE_BUILD=${TEMPORAL_COHERENCE_BUILD:-$repository/build}
build=$TEMPORAL_COHERENCE_BUILD
output=$build/benchmarks
# shellcheck source-path=SCRIPTDIR source=../Common/Display.sh
. "$repository/Testing/Common/Display.sh"

say() { printf '[benchmarks] %s\n' "$*"; }
fail() { printf '[benchmarks] %s\n' "$*" >&2; exit 1; }

setup_options=(--with-tests)
quick=()
built=no
parts=scenarios,kernels
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --quick) quick=("$1") ;;
    --built) built=yes ;;
    --only)
      [ $# -gt 1 ] || fail "--only needs names of parts behind it."
      parts=$2
      shift ;;
    --no-packages) setup_options+=("$1") ;;
    --output)
      [ $# -gt 1 ] || fail "--output needs a folder behind it."
      output=$2
      shift ;;
    *) fail "There is no option $1; --help lists those there are." ;;
  esac
  shift
done

for part in ${parts//,/ }; do
  [[ $part =~ ^(scenarios|kernels|figures|pictures)$ ]] ||
    fail "There is no part $part; --help lists those there are."
done
asked_for() { [[ ,$parts, == *,$1,* ]]; }

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

[ "$built" = yes ] || "$repository/Module/setup.sh" "${setup_options[@]}"
mkdir -p "$output" 2>/dev/null ||
  fail "Cannot make the folder $output; name one that can be written in with --output."
output=$(cd "$output" && pwd)

charts=yes
if [ ! -x "$build/bin/PaperFigures" ]; then
  charts=no
  say "Plots, figures and pictures are left out: this VTK has no charts."
fi
if asked_for scenarios; then
  plots=(--plots "$output")
  [ "$charts" = yes ] || plots=()
  measure "All scenarios" benchmark.md Benchmark "${quick[@]}" --json "$output/benchmark.json" "${plots[@]}"
fi
if asked_for kernels && [ -x "$build/bin/BenchmarkKernels" ]; then
  measure "Single kernels" kernels.txt BenchmarkKernels ${quick:+--benchmark_min_time=0.01} \
    --benchmark_out="$output/kernels.json" --benchmark_out_format=json
elif asked_for kernels; then
  say "Single kernels are left out: there is no Google Benchmark."
fi
if asked_for figures && [ "$charts" = yes ]; then
  measure "The paper's figures" figures.md PaperFigures "${quick[@]}" --output "$output"
fi
if asked_for pictures && [ "$charts" = yes ]; then
  measure "Routes and features" pictures.md GalleryPictures "${quick[@]}" --output "$output"
fi
say "Tables (.md, .txt), JSON, plots and pictures are in $output"
