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
them) with plots of some, single kernels, one thread beside two, and another build beside this one:
what Documentation/Performance.md tells. Pictures and the paper's figures are made by
Documentation/gallery.sh, which calls this with --only.

usage: Testing/Benchmarks/run.sh [--only PART,...] [--against BUILD] [--quick] [--output FOLDER]
                                 [--no-packages] [--built]

  --only PART,...  of routes, peers, drags, rest (other scenarios), kernels, builds (these are the
                   default), figures (those of the paper), pictures (routes and features)
  --against BUILD  part builds: the build directory of another commit, made by its Module/setup.sh
  --quick          small pictures and few frames, to see that all works in a few minutes
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
against=
# shellcheck source-path=SCRIPTDIR source=../Common/Display.sh
. "$repository/Testing/Common/Display.sh"

say() { printf '[benchmarks] %s\n' "$*"; }
fail() { printf '[benchmarks] %s\n' "$*" >&2; exit 1; }

setup_options=(--with-tests)
quick=()
built=no
parts=routes,peers,drags,rest,kernels,builds
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
    --against)
      [ $# -gt 1 ] || fail "--against needs a build directory behind it."
      against=$2
      shift ;;
    --output)
      [ $# -gt 1 ] || fail "--output needs a folder behind it."
      output=$2
      shift ;;
    *) fail "There is no option $1; --help lists those there are." ;;
  esac
  shift
done

for part in ${parts//,/ }; do
  [[ $part =~ ^(routes|peers|drags|rest|kernels|builds|figures|pictures)$ ]] ||
    fail "There is no part $part; --help lists those there are."
done
asked_for() { [[ ,$parts, == *,$1,* ]]; }

# Scenarios of Benchmark, as tables and JSON.
scenarios() # TITLE FILE SCENARIO,... OPTIONS...
{
  local title=$1 file=$2 names=$3
  shift 3
  measure "$title" "$file.md" Benchmark "${quick[@]}" --scenarios "$names" \
    --json "$output/$file.json" "$@"
}

# Cold frames of two builds in turn.
compare() # TITLE FILE BUILD BUILD OPTIONS...
{
  local title=$1 file=$2
  shift 2
  measure "$title" "$file.md" /usr/bin/python3 "$repository/Testing/Benchmarks/Compare/compare.py" \
    "${quick[@]}" --json "$output/$file.json" "$@"
}

# Runs a program of the build, or a script; what it prints goes into a file too.
measure() # TITLE FILE PROGRAM ARGUMENTS...
{
  local title=$1 file=$output/$2 program=$3 begin=$SECONDS
  shift 3
  [[ $program == */* ]] || program=$build/bin/$program
  say "$title: $program $*"
  with_display "$program" "$@" | tee "$file" ||
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
# A small picture and a small volume, to see that all works.
finer=(--size 2048 spheres256 100 engine.vti 70 bonsai.vti 40)
largest=(--largest 1024)
if [ ${#quick[@]} -gt 0 ]; then
  finer=(--size 512)
  largest=()
fi
if asked_for routes; then
  scenarios "Routes and floors" routes routes,floor --views afar,whole,close
  scenarios "Routes with more pixels" routes-finer routes --views close "${finer[@]}"
fi
if asked_for peers; then
  scenarios "Peers" peers peers,layer-peers --views whole,close
fi
if asked_for drags; then
  scenarios "Drags" drags drags --views whole,close
fi
if asked_for rest; then
  plots=(--plots "$output")
  [ "$charts" = yes ] || plots=()
  scenarios "Threads, vectors, features" variants threads,vectors,features,opacities,window,structures \
    --views whole,close
  scenarios "Images and isomaps" images image-cache,drift,isomap --views whole "${plots[@]}"
  scenarios "Growth" growth growth --views whole "${largest[@]}" "${plots[@]}"
fi
if asked_for kernels && [ -x "$build/bin/BenchmarkKernels" ]; then
  measure "Single kernels" kernels.txt BenchmarkKernels ${quick:+--benchmark_min_time=0.01} \
    --benchmark_out="$output/kernels.json" --benchmark_out_format=json
elif asked_for kernels; then
  say "Single kernels are left out: there is no Google Benchmark."
fi
if asked_for builds && [ -d "$build/python" ]; then
  compare "One thread beside two" one-two "$build" "$build" --names "one thread,two" --threads 1,2 \
    --time wall
  if [ -n "$against" ]; then
    compare "Another build beside this one" against "$against" "$build"
    compare "The same without AVX-512" against-avx2 "$against" "$build" --no-avx512
    compare "See-through surfaces" against-layers "$against" "$build" --layers --rounds 3
  else
    say "Another build is left out: --against names none."
  fi
elif asked_for builds; then
  say "Builds are not compared: there is no Python package."
fi
if asked_for figures && [ "$charts" = yes ]; then
  measure "The paper's figures" figures.md PaperFigures "${quick[@]}" --output "$output"
fi
if asked_for pictures && [ "$charts" = yes ]; then
  measure "Routes and features" pictures.md GalleryPictures "${quick[@]}" --output "$output"
fi
say "Tables (.md, .txt), JSON, plots and pictures are in $output"
