#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# VTK's own tests of volume mappers: behind the factory VTK's pictures, byte for byte, and outlines of
# isosurfaces within a pixel; with the name of the class changed VTK's look, or one message.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Take the tests of volume mappers out of a source tree of VTK and compile them with the VTK that is
installed, twice: as they are, and with the name of the mapper's class and of its header changed to
vtkTemporalCoherenceVolumeMapper, and nothing else. With VTK's testing data they are run, too, and
their pictures are judged.

usage: Testing/VtkTests/run.sh VTK_SOURCE [--data DIR] [--only PATTERN] [--limit SECONDS] [--jobs N]
         [--built] [--no-packages] [--at-least COUNT]

  --data DIR        run the tests; DIR is what VTK's tests get as -D, with Data/ in it. Tests whose
                    data is not there are SKIPPED
  --only PATTERN    run the tests whose names match this (regular expression); default: all
  --limit SECONDS   what a run may take; default: 600
  --jobs N          tests that run at once; default: as many as there are processors
  --built           build nothing of this repository: the build directory is up to date
  --no-packages     install no packages (see Module/setup.sh --help)
  --at-least COUNT  fail if fewer tests compile with the name changed; default: all but two
  --help            show this text

VTK_SOURCE is VTK's source tree, best of the version that is installed: the tests of another one may
use what that has not. They are those of Rendering/Volume and Rendering/VolumeOpenGL2 that name
vtkGPUVolumeRayCastMapper, vtkOpenGLGPUVolumeRayCastMapper, vtkSmartVolumeMapper,
vtkFixedPointVolumeRayCastMapper or vtkMultiBlockVolumeMapper. VTK's build fetches its testing data
into ExternalData/Testing of its build directory.

The tests are run on a display of their own, and judged by four doors:

  factory           as they are, with VTK_AUTOLOAD_PATH: the picture of VTK's mapper, byte for byte;
                    where they show isosurfaces, their outlines within a pixel
  renamed           with the name changed: VTK's look, or at least its outlines; or exactly one message by each mapper that
                    tells why it draws nothing, and the picture without its volume; or, where a test
                    never sets a blend mode, the isosurfaces of its property as polygons have them
  surfaces-factory  as they are, with VTK_AUTOLOAD_PATH and each volume made to show an opaque
                    isosurface: the outlines of polygons within a pixel, unless VTK's mapper draws
  surfaces-renamed  the same with the name changed

The verdicts are: same (byte for byte), look, outline, as documented, VTK draws, SKIPPED; and where something
is wrong DIFFERENT, SILENT (nothing drawn, nothing told), CRASH, TOO SLOW, NO PICTURE, NOT RUN.
README.md beside this script has the table for VTK 9.1; differences.txt has the pictures that differ
for a good reason.

Copies, programs, pictures (runs/) and the table (verdicts.txt) are in vtk-tests in the build directory.
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

# shellcheck source-path=SCRIPTDIR source=../Common/Display.sh
. "$repository/Testing/Common/Display.sh"

setup_options=(--with-tests)
run_options=(--limit 600)
built=no
data=
least=
source=
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --built) built=yes ;;
    --no-packages) setup_options+=("$1") ;;
    --data)
      [ -d "${2:-}/Data" ] || fail "--data needs a directory behind it that has Data/ in it."
      data=$(realpath "$2")
      shift ;;
    --only | --limit | --jobs)
      [ $# -gt 1 ] || fail "$1 needs a value behind it."
      run_options+=("$1" "$2")
      shift ;;
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
  mkdir -p "$work/tests/unchanged" "$work/tests/renamed"
  for folder in "${folders[@]}"; do
    for test in "$source/$folder"/*.cxx; do
      if grep -qE "\b$mappers\b" "$test"; then
        cp "$test" "$work/tests/unchanged"
        sed -E "s/\b$mappers\b/vtkTemporalCoherenceVolumeMapper/g" "$test" \
          >"$work/tests/renamed/${test##*/}"
      fi
    done
    find "$source/$folder" -maxdepth 1 -name '*.glsl' -exec cp -t "$work/tests" {} +
  done
}

compile_tests()
{
  rm -rf "$work/build"
  cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG="-O0 -DNDEBUG" -DTESTS="$work/tests" \
    -DvtkTemporalCoherence_DIR="$TEMPORAL_COHERENCE_BUILD/lib/cmake/vtkTemporalCoherence" \
    >"$log" 2>&1 || { tail -n 20 "$log" >&2; fail "CMake does not configure the tests: $log"; }
  # Those that do not compile are what the table is for.
  cmake --build "$work/build" --parallel -- -k 0 >>"$log" 2>&1 || true
}

# A line for each test: whether it compiles with the name changed, or the first error.
write_table()
{
  local test name
  for test in "$work"/tests/renamed/*.cxx; do
    name=$(basename "$test" .cxx)
    if [ -x "$work/build/renamed/$name" ]; then
      printf 'compiles  %s\n' "$name"
    else
      printf 'FAILS     %s: %s\n' "$name" "$(grep -m 1 -oE "$name.cxx:.*error.*" "$log" || echo "see $log")"
    fi
  done
}

run_tests()
{
  rm -rf "$work/runs"
  on_own_display /usr/bin/python3 "$here/run_tests.py" "$work/tests/unchanged" "$work/build" "$data" \
    "$work/runs" --autoload "$TEMPORAL_COHERENCE_BUILD/lib/vtkTemporalCoherence/autoload" \
    "${run_options[@]}"
}

[ "$built" = yes ] || "$repository/Module/setup.sh" "${setup_options[@]}"
mkdir -p "$work"
copy_tests
say "Compiling the tests of $source (log: $log)"
compile_tests
write_table >"$work/verdicts.txt"
cat "$work/verdicts.txt"
all=$(wc -l <"$work/verdicts.txt")
good=$(grep -c '^compiles' "$work/verdicts.txt" || true)
[ "$all" -gt 0 ] || fail "No test in $source names a volume mapper."
summary="$good of $all tests compile with only the name of the class changed"
[ "$good" -ge "${least:-$((all - 2))}" ] || fail "$summary; the table is $work/verdicts.txt"
if [ -n "$data" ]; then
  say "Running the tests (pictures and logs: $work/runs)"
  run_tests
  status=0
  /usr/bin/python3 "$here/judge.py" "$work/runs" | tee -a "$work/verdicts.txt" || status=1
  [ "$status" -eq 0 ] || fail "$summary, but not all pictures are right; the table is $work/verdicts.txt"
  summary="$summary, and no picture is wrong"
fi
say "PASSED: $summary; the table is $work/verdicts.txt"
