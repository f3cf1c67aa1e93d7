#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# No sanitizer reports our code: memory, undefined behaviour, data races, invalid operations, divisions
# by zero and overflows.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Build vtkTemporalCoherence with a sanitizer, in a build directory of its own, and run all tests.

usage: Testing/Sanitizers/run.sh [--no-packages] KIND [CTEST_ARGUMENTS]

KIND
  address            memory that is not ours or no longer, leaks
  undefined          undefined behaviour of C++, and floats that no integer can hold
  address,undefined  both in one build
  thread             data races; threads are those of VTK's backend STDThread
  traps              invalid floating-point operations, divisions by zero and overflows
  ci                 a part in a few minutes: the engine's tests with address,undefined, and where
                     its threads share most with thread

  --no-packages      install no packages (see Module/setup.sh --help)
  --help             show this text

CTEST_ARGUMENTS go to ctest, for example -R Engine or -j 2. A report is a fault of ours: what others'
code does, and tests whose numbers traps are not made for, are left out by the files *.supp beside
this script, each with its reason. First, a program of faults shows that the sanitizer is awake. The
exit status is 0 only if tests ran, none failed and there is no report.

environment:
  TEMPORAL_COHERENCE_BUILD        what names of build directories begin with, for example
                                  build-thread; default: build, in the repository
  TEMPORAL_COHERENCE_CMAKE_FLAGS  further arguments for CMake, separated by spaces

It takes GCC, whose Debian package g++ has all run-time libraries: g++ where CXX is another compiler.
With Clang traps would report what the program does not do, as it moves divisions before the
conditions that they depend on.
TEXT
}

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
repository=$(cd "$here/../.." && pwd)
builds=${TEMPORAL_COHERENCE_BUILD:-$repository/build}
# shellcheck source-path=SCRIPTDIR source=../Common/Display.sh
. "$repository/Testing/Common/Display.sh"

say() { printf '[sanitizers] %s\n' "$*"; }
fail() { printf '[sanitizers] %s\n' "$*" >&2; exit 1; }

setup_options=(--with-tests)
read -ra cmake_flags <<<"${TEMPORAL_COHERENCE_CMAKE_FLAGS:-}"
kind=
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --no-packages) setup_options+=("$1") ;;
    address | undefined | address,undefined | thread | traps | ci) kind=$1; shift; break ;;
    *) fail "There is no kind $1; --help lists those there are." ;;
  esac
  shift
done
[ -n "$kind" ] || fail "Name one of address, undefined, address,undefined, thread, traps and ci."
[ "$kind" != ci ] || [ $# -eq 0 ] || fail "ci takes no arguments for ctest."
[ "$(uname -sm)" = "Linux x86_64" ] || [ "$kind" != traps ] || fail "traps take Linux on x86-64."

compiler=${CXX:-c++}
is_gcc() { [[ $("$compiler" --version 2>/dev/null) == *"Free Software Foundation"* ]]; }
if ! is_gcc; then
  say "$compiler is not GCC; taking g++."
  compiler=g++
  is_gcc || fail "There is no GCC: install g++, or set CXX to one."
fi
export CXX=$compiler

# Assertions are on, those of the standard library, too.
common_flags="-O1 -g1 -fno-omit-frame-pointer -D_GLIBCXX_ASSERTIONS"

flags_of() # KIND
{
  case $1 in
    address) printf '%s -fsanitize=address' "$common_flags" ;;
    # No division by zero of floats: it is defined where floats are those of IEEE, and what the code
    # does with infinity is no fault of its own. traps tells where it happens.
    undefined) printf '%s -fsanitize=undefined,float-cast-overflow -fno-sanitize-recover=all' "$common_flags" ;;
    address,undefined) printf '%s -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all' "$common_flags" ;;
    thread) printf '%s -fsanitize=thread' "$common_flags" ;;
    traps) printf '%s' "$common_flags" ;;
  esac
}

# What has to be reported before silence is believed.
faults_of() # KIND
{
  case $1 in
    address) printf 'use-after-free leak' ;;
    undefined) printf 'integer-overflow float-to-integer' ;;
    address,undefined) printf 'use-after-free leak integer-overflow float-to-integer' ;;
    thread) printf 'race' ;;
    traps) printf 'division-by-zero invalid-logarithm overflow float-to-integer' ;;
  esac
}

# The library to preload where the program is not built here: Python.
preload_of() # KIND
{
  local library=
  case $1 in
    address*) library=libasan.so ;;
    undefined) library=libubsan.so ;;
    thread) library=libtsan.so ;;
    *) return 0 ;;
  esac
  # With the standard library, as exceptions are followed.
  printf 'LD_PRELOAD=%s %s' "$(real_library "$library")" "$(real_library libstdc++.so)"
}
real_library() { readlink -f "$("$compiler" -print-file-name="$1")"; }

# Sets `environment` to the sanitizer's options; reports go into files.
set_environment() # KIND
{
  local options="log_path=$reports/report"
  case $1 in
    traps)
      environment=("TRAP_BELOW=$build" "TRAP_REPORTS=$reports" "LD_PRELOAD=$preloads/libTrapFloatingPoint.so") ;;
    thread)
      # VTK is not instrumented. Memory that it alone touches is not ours to judge, but its locks
      # and threads are seen. TBB's are not, as they are made of atomics.
      environment=("TSAN_OPTIONS=$options:exitcode=66:history_size=4:second_deadlock_stack=1:ignore_noninstrumented_modules=1:suppressions=$here/thread.supp"
        VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=4) ;;
    *)
      environment=("LD_PRELOAD=$preloads/libKeepLoaded.so"
        "ASAN_OPTIONS=$options:verify_asan_link_order=0:detect_stack_use_after_return=1:strict_string_checks=1:check_initialization_order=1"
        "LSAN_OPTIONS=suppressions=$here/leaks.supp:print_suppressions=0"
        "UBSAN_OPTIONS=$options:print_stacktrace=1") ;;
  esac
}

# Runs a program with the sanitizer's options.
watched() # KIND COMMAND...
{
  local environment=()
  set_environment "$1"
  shift
  env "${environment[@]}" "$@"
}

number_of_reports() { find "$reports" -type f -size +0 | wc -l; }

# Begins in an empty directory of reports.
forget_reports()
{
  rm -rf "$reports"
  mkdir -p "$reports"
}

show_awake() # KIND
{
  local fault flags told
  read -ra flags <<<"$(flags_of "$1")"
  "$compiler" -std=c++17 -g "${flags[@]}" -o "$build/Faults" "$here/Faults.cxx" -pthread
  for fault in none $(faults_of "$1"); do
    forget_reports
    told=no
    # With address, undefined behaviour ends the program, but is told on standard error only.
    watched "$1" "$build/Faults" "$fault" >/dev/null 2>&1 || told=yes
    [ "$(number_of_reports)" -eq 0 ] || told=yes
    if [ "$fault" = none ]; then
      [ "$told" = no ] || fail "$1 reports where there is no fault; see $reports"
    else
      [ "$told" = yes ] || fail "$1 is not awake: it does not report $fault."
    fi
  done
  forget_reports
  say "$1 is awake: $(faults_of "$1") reported."
}

# Makes a library to preload of the file of its name. It does not lie in the build directory, as a
# test looks for what is loaded from there.
preload() # NAME
{
  mkdir -p "$preloads"
  "$compiler" -std=c++17 -O1 -g -Wall -Wextra -shared -fPIC -o "$preloads/lib$1.so" \
    "$here/$1.cxx" -ldl -pthread
}

prepare() # KIND
{
  build=$builds-${1/,/-}
  reports=$build/reports
  preloads=$build-preload
  mkdir -p "$build" 2>/dev/null ||
    fail "Cannot write in $build; set TEMPORAL_COHERENCE_BUILD to what you may write in."
  case $1 in
    traps) preload TrapFloatingPoint ;;
    address* | undefined) preload KeepLoaded ;;
  esac
  show_awake "$1"
}

# True if there are none; tells those there are, the first in full.
no_reports()
{
  local first many
  many=$(number_of_reports)
  [ "$many" -gt 0 ] || return 0
  first=$(find "$reports" -type f -size +0 | sort | head -n 1)
  printf '\n'
  head -n 80 "$first"
  grep -rhE '^SUMMARY|^TRAP|runtime error' "$reports" | sort | uniq -c | sort -rn | head -n 40
  say "$many report(s) in $reports"
  return 1
}

whole_suite() # KIND CTEST_ARGUMENTS...
{
  local kind=$1 begin=$SECONDS log summary left_out python=() environment=() status=0
  shift
  prepare "$kind"
  log=$build/ctest.log
  # The interpreter leaks on purpose and is in the stack of every call from Python: there leaks are
  # not looked for. PYTHONMALLOC: each block of Python is one of malloc.
  python=("$(preload_of "$kind")" "LSAN_OPTIONS=detect_leaks=0" PYTHONMALLOC=malloc)
  [ -n "${python[0]}" ] || python=()
  TEMPORAL_COHERENCE_BUILD=$build "$repository/Module/setup.sh" "${setup_options[@]}" -- \
    -DCMAKE_BUILD_TYPE=None "-DCMAKE_CXX_FLAGS=$(flags_of "$kind")" \
    "-DTEMPORAL_COHERENCE_PYTHON_ENVIRONMENT=$(IFS=';'; printf '%s' "${python[*]}")"
  # Packages are made of releases.
  left_out=PackagesOfBuild
  [ "$kind" != traps ] || left_out+=$(sed '/^#/d; s/^/|/' "$here/traps.supp" | tr -d '\n')
  set_environment "$kind"
  on_own_display env "${environment[@]}" ctest --test-dir "$build" --output-on-failure --no-tests=error \
    --timeout 7200 -E "$left_out" "$@" 2>&1 | tee "$log" || status=1
  no_reports || status=1
  summary=$(grep -E '^[0-9]+% tests passed' "$log" | tail -n 1 || true)
  if [ "$status" -eq 0 ] && [ -n "$summary" ]; then
    say "$kind PASSED: no report; $summary, in $((SECONDS - begin)) s"
  else
    say "$kind FAILED: ${summary:-no test ran}, in $((SECONDS - begin)) s; all output is in $log"
    return 1
  fi
}

# One program of the engine's tests, without the rest.
engine_tests() # KIND PROGRAM FILTER FLAGS
{
  local kind=$1 program=$2 begin=$SECONDS status=0 share shares process processes=()
  prepare "$kind"
  build=$build-engine
  mkdir -p "$build"
  say "Building $program with $kind in $build"
  { cmake -S "$repository" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DBUILD_TESTING=ON \
      -DTEMPORAL_COHERENCE_BUILD_BENCHMARKS=OFF -DTEMPORAL_COHERENCE_WRAP_PYTHON=OFF \
      "-DCMAKE_CXX_FLAGS=$(flags_of "$kind") $4" "${cmake_flags[@]}" &&
    cmake --build "$build" --target "$program"; } >"$build/build.log" 2>&1 ||
    { tail -n 40 "$build/build.log" >&2; fail "The build failed; all that was said is in $build/build.log"; }
  say "Built in $((SECONDS - begin)) s"
  # A process for each processor, with a share of the tests.
  shares=$(nproc 2>/dev/null || echo 2)
  for ((share = 0; share < shares; ++share)); do
    watched "$kind" env "GTEST_TOTAL_SHARDS=$shares" "GTEST_SHARD_INDEX=$share" \
      "$build/bin/$program" --gtest_brief=1 "--gtest_filter=$3" &
    processes+=($!)
  done
  for process in "${processes[@]}"; do
    wait "$process" || status=1
  done
  no_reports || status=1
  [ "$status" -eq 0 ] || fail "$kind FAILED in $((SECONDS - begin)) s"
  say "$kind passed in $((SECONDS - begin)) s"
}

if [ "$kind" != ci ]; then
  whole_suite "$kind" "$@"
  exit
fi
"$repository/Module/setup.sh" "${setup_options[@]}" --packages-only
# Other runs than ci take everything. Here three things are left out, as kernels and long walks take
# most of the time:
# - all kinds of vectors but one,
# - checks of each access to memory, but of the heap: address sees null pointers, and the library's
#   assertions the bounds of its arrays,
# - tests that take many seconds each: their code is that of shorter ones beside them.
fewer_checks="-DHWY_COMPILE_ONLY_STATIC -fno-sanitize=null,alignment,object-size --param=asan-stack=0"
long_tests=$(sed '/^#/d' "$here/long.supp" | paste -sd :)
engine_tests address,undefined TemporalCoherenceEngineTests "-$long_tests" "$fewer_checks"
# Its gathers read word by word, beside threads that write. The rest of the tests of isomaps takes
# minutes.
engine_tests thread TemporalCoherenceThreadTests \
  'BrickCacheTest*:BricksOf*Volume:FieldStructures*:FrameRenderer*:IsomapTest.ABuildThatIsStopped*' -DHWY_COMPILE_ONLY_STATIC
say "ci PASSED: no report, in $SECONDS s"
