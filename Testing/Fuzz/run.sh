#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Any sequence of calls of the mapper gives the picture of a mapper without a past: no crash, no hang.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Fuzz the mapper: bytes become scenes and changes of them, and every frame is compared with that of
a mapper without a past.

usage: Testing/Fuzz/run.sh [OPTIONS] [MINUTES]

  MINUTES          how long; default: 1
  --sanitized      with the address and undefined behaviour sanitizers, in a build of its own
  --guided         by libFuzzer, guided by coverage, with the same sanitizers (needs clang)
  --windows        in render windows, on a display of their own
  --seed N         the first seed; default: the seconds since 1970, so that each call makes others
  --jobs N         processes at the same time; default: 2
  --no-packages    install no packages (see Module/setup.sh --help)
  --help           show this text

Runs that fail are written to fuzz-failures/ in the build directory, and the command is printed
that replays them. What was a defect is kept in Testing/Fuzz/Seeds:

  build/bin/FuzzMapper --shrink Testing/Fuzz/Seeds/NAME FILE
TEXT
}

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
minutes=1
kind=plain
windows=no
seed=$(date +%s)
jobs=2
setup_options=()
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --sanitized) kind=sanitized ;;
    --guided) kind=guided ;;
    --windows) windows=yes ;;
    --seed) seed=${2:?--seed needs a number}; shift ;;
    --jobs) jobs=${2:?--jobs needs a number}; shift ;;
    --no-packages) setup_options+=(--no-packages) ;;
    *[!0-9.]*) printf '[fuzz] There is no option %s; --help lists those there are.\n' "$1" >&2; exit 2 ;;
    *) minutes=$1 ;;
  esac
  shift
done
# shellcheck source-path=SCRIPTDIR source=../Common/Display.sh
. "$repository/Testing/Common/Display.sh"

sanitizers=address,undefined,float-cast-overflow
sanitizer_flags="-O1 -g1 -fno-omit-frame-pointer -fsanitize=$sanitizers -fno-sanitize-recover=all"
targets=(FuzzMapper)
case $kind in
  plain)
    build=${TEMPORAL_COHERENCE_BUILD:-$repository/build}
    arguments=()
    ;;
  sanitized)
    build=${TEMPORAL_COHERENCE_BUILD:-$repository/build-fuzz-sanitized}
    arguments=(-DCMAKE_BUILD_TYPE=None "-DCMAKE_CXX_FLAGS=$sanitizer_flags")
    ;;
  guided)
    build=${TEMPORAL_COHERENCE_BUILD:-$repository/build-fuzz-guided}
    command -v clang++ >/dev/null || { printf '[fuzz] --guided needs clang (Debian: clang).\n' >&2; exit 1; }
    # Clang's null and vptr checks need sources of VTK that are checked, too.
    arguments=(-DCMAKE_BUILD_TYPE=None -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++
      "-DCMAKE_CXX_FLAGS=$sanitizer_flags -fsanitize=fuzzer-no-link -fno-sanitize=vptr"
      -DTEMPORAL_COHERENCE_BUILD_FUZZER=ON)
    # What the one finds the other replays in words.
    targets=(GuidedFuzzer FuzzMapper)
    ;;
esac

# Packages first, then only what is needed: the tests need most of the time.
"$repository/Module/setup.sh" --with-tests --packages-only "${setup_options[@]}"
if [ ! -f "$build/build.ninja" ]; then
  printf '[fuzz] Configuring in %s\n' "$build"
  cmake -S "$repository" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON \
    -DTEMPORAL_COHERENCE_BUILD_BENCHMARKS=OFF "${arguments[@]}" >"$build.log" 2>&1 ||
    { tail -n 20 "$build.log" >&2; printf '[fuzz] CMake could not configure.\n' >&2; exit 1; }
fi
printf '[fuzz] Building %s in %s\n' "${targets[*]}" "$build"
cmake --build "$build" --target "${targets[@]}" >"$build/fuzz-build.log" 2>&1 ||
  { tail -n 40 "$build/fuzz-build.log" >&2; printf '[fuzz] The build failed.\n' >&2; exit 1; }

failures=$build/fuzz-failures
mkdir -p "$failures"
# Reports name a line; leaks are looked for where VTK and the drivers of OpenGL do not leak.
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=0:allocator_may_return_null=1}
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
seconds=$(awk -v minutes="$minutes" 'BEGIN { printf "%d", 60 * minutes }')

if [ "$kind" = guided ]; then
  mkdir -p "$build/fuzz-corpus"
  status=0
  "$build/bin/GuidedFuzzer" "-max_total_time=$seconds" -max_len=2048 -timeout=20 -print_final_stats=1 \
    "-artifact_prefix=$failures/" "$build/fuzz-corpus" "$repository/Testing/Fuzz/Seeds" \
    >"$build/fuzz.log" 2>&1 || status=1
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$build/fuzz.log")
  if [ "$status" -ne 0 ]; then
    tail -n 60 "$build/fuzz.log"
    printf '[fuzz] FAILED: replay with %s/bin/FuzzMapper --tell FILE; the files are in %s\n' "$build" "$failures"
    exit 1
  fi
  printf '[fuzz] PASSED: %s runs of many steps, nothing found\n' "${runs:-?}"
  exit 0
fi

options=(--seconds "$seconds" --save "$failures")
runner=()
if [ "$windows" = yes ]; then
  options+=(--windows)
  runner=(on_own_display)
fi
"$build/bin/FuzzMapper" "$repository/Testing/Fuzz/Seeds" >"$build/fuzz-seeds.log" 2>&1 ||
  { tail -n 30 "$build/fuzz-seeds.log"; printf '[fuzz] FAILED: a kept seed fails again.\n'; exit 1; }
processes=()
for ((job = 0; job < jobs; ++job)); do
  # Seeds of the processes lie far apart.
  "${runner[@]}" "$build/bin/FuzzMapper" --seed "$((seed + job * 1000000000))" "${options[@]}" \
    >"$build/fuzz-$job.log" 2>&1 &
  processes+=($!)
done
status=0
for process in "${processes[@]}"; do
  wait "$process" || status=1
done
steps=0
for ((job = 0; job < jobs; ++job)); do
  made=$(sed -n 's/^\([0-9]*\) steps in .*/\1/p' "$build/fuzz-$job.log" | tail -n 1)
  steps=$((steps + ${made:-0}))
done
if [ "$status" -ne 0 ]; then
  for ((job = 0; job < jobs; ++job)); do
    grep -a -A 3 '^FAILED' "$build/fuzz-$job.log" | sed "s|FuzzMapper|$build/bin/FuzzMapper|" || true
  done
  printf '[fuzz] FAILED after %s steps; bytes that fail are in %s\n' "$steps" "$failures"
  exit 1
fi
printf '[fuzz] PASSED: %s steps, nothing found (first seed: %s)\n' "$steps" "$seed"
