#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# VTK's own tests of volume mappers, with ours in their place.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Take the tests of volume mappers out of a source tree of VTK, change in each copy the name of the
mapper's class and of its header to vtkTemporalCoherenceVolumeMapper, and nothing else, and compile
them with the VTK that is installed. A table tells which compile, and what is wrong with the others.

usage: Testing/VtkTests/run.sh VTK_SOURCE [--built] [--no-packages] [--at-least COUNT]

  --built           build nothing of this repository: the build directory is up to date
  --no-packages     install no packages (see Module/setup.sh --help)
  --at-least COUNT  fail if fewer tests compile; default: all but two
  --help            show this text

VTK_SOURCE is VTK's source tree, best of the version that is installed: the tests of another one may
use what that has not. They are those of Rendering/Volume and Rendering/VolumeOpenGL2 that name
vtkGPUVolumeRayCastMapper, vtkOpenGLGPUVolumeRayCastMapper, vtkSmartVolumeMapper,
vtkFixedPointVolumeRayCastMapper or vtkMultiBlockVolumeMapper.

The copies, what was compiled and the table (verdicts.txt) are in vtk-tests in the build directory.
TEXT
}

say() { printf '[vtk-tests] %s\n' "$*"; }
fail() { printf '[vtk-tests] FAILED: %s\n' "$*" >&2; exit 1; }

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
repository=$(cd "$here/../.." && pwd)
TEMPORAL_COHERENCE_BUILD=$(realpath -m "${TEMPORAL_COHERENCE_BUILD:-$repository/build}")
export TEMPORAL_COHERENCE_BUILD
work=$TEMPORAL_COHERENCE_BUILD/vtk-tests
log=$work/compile.log
folders=(Rendering/Volume/Testing/Cxx Rendering/VolumeOpenGL2/Testing/Cxx)
mappers='vtk(OpenGLGPUVolumeRayCast|GPUVolumeRayCast|SmartVolume|FixedPointVolumeRayCast|MultiBlockVolume)Mapper'

setup_options=(--with-tests)
built=no
least=
source=
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --built) built=yes ;;
    --no-packages) setup_options+=("$1") ;;
    --at-least)
      [[ ${2:-} =~ ^[0-9]+$ ]] || fail "--at-least needs a number behind it."
      least=$2
      shift ;;
    -*) fail "There is no option $1; --help lists those there are." ;;
    *) source=$1 ;;
  esac
  shift
done
[ -n "$source" ] || { usage >&2; fail "Which source tree of VTK?"; }
for folder in "${folders[@]}"; do
  [ -d "$source/$folder" ] || fail "$source has no $folder: give the source tree of VTK 9.1 or later."
done

copy_tests()
{
  local folder test
  rm -rf "$work/tests"
  mkdir -p "$work/tests"
  for folder in "${folders[@]}"; do
    for test in "$source/$folder"/*.cxx; do
      if grep -qE "\b$mappers\b" "$test"; then
        sed -E "s/\b$mappers\b/vtkTemporalCoherenceVolumeMapper/g" "$test" >"$work/tests/${test##*/}"
      fi
    done
    find "$source/$folder" -maxdepth 1 -name '*.glsl' -exec cp -t "$work/tests" {} +
  done
}

compile_tests()
{
  rm -rf "$work/build"
  cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 \
    -DTESTS="$work/tests" \
    -DvtkTemporalCoherence_DIR="$TEMPORAL_COHERENCE_BUILD/lib/cmake/vtkTemporalCoherence" \
    >"$log" 2>&1 || { tail -n 20 "$log" >&2; fail "CMake does not configure the tests: $log"; }
  # Those that do not compile are what the table is for.
  cmake --build "$work/build" --parallel -- -k 0 >>"$log" 2>&1 || true
}

# A line for each test: whether it compiles, or the first error.
write_table()
{
  local test name
  for test in "$work"/tests/*.cxx; do
    name=$(basename "$test" .cxx)
    if [ -n "$(find "$work/build" -name "$name.cxx.o" -print -quit)" ]; then
      printf 'compiles  %s\n' "$name"
    else
      printf 'FAILS     %s: %s\n' "$name" "$(grep -m 1 -oE "$name.cxx:.*error.*" "$log" || echo "see $log")"
    fi
  done
}

[ "$built" = yes ] || "$repository/Module/setup.sh" "${setup_options[@]}"
mkdir -p "$work"
copy_tests
say "Compiling the tests of $source with the name of the class changed (log: $log)"
compile_tests
write_table >"$work/verdicts.txt"
cat "$work/verdicts.txt"
all=$(wc -l <"$work/verdicts.txt")
good=$(grep -c '^compiles' "$work/verdicts.txt" || true)
[ "$all" -gt 0 ] || fail "No test in $source names a volume mapper."
summary="$good of $all tests compile with only the name of the class changed; the table is $work/verdicts.txt"
[ "$good" -ge "${least:-$((all - 2))}" ] || fail "$summary"
say "PASSED: $summary"
