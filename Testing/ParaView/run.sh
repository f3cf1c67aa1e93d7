#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# ParaView's pictures agree with brute force, are re-used, and show each property of the panel. Pictures
# of 2 and 4 processes are those of one, but for less than 0.1 % of the pixels: opaque ones byte for
# byte, translucent ones within 2/255.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Build the ParaView plugin and run its tests with pvbatch, in one process and distributed.

usage: Testing/ParaView/run.sh [OPTIONS] [-- CMAKE_ARGUMENTS]

  --figures      measure milliseconds and memory of 1, 2 and 4 processes as well, and make the pictures
                 of Documentation/Pictures/paraview-*.png anew
  --no-packages  install nothing: ParaView and all packages are there
  --help         show this text

On Debian 12 or later, as root or with sudo. ParaView's packages are unpacked, not installed, because
on Debian 12 one of them conflicts with what libvtk9-dev needs; what they depend on is installed with
apt. A second run takes up what is there. Tests run under an X server of their own (Xvfb). Each check is
a line; the last line says PASSED or FAILED, and so does the exit status.

environment:
  TEMPORAL_COHERENCE_PARAVIEW        where ParaView is or goes (700 MB); default: /opt/paraview where
                                     one may write, else /var/tmp/vtkTemporalCoherence-paraview
  TEMPORAL_COHERENCE_PARAVIEW_BUILD  where the plugin is built; default: build/paraview, in the
                                     repository
  TEMPORAL_COHERENCE_DATA            a directory with real volumes: ironProt.vtk is drawn too if it is
                                     there, engine.vti is for the documentation's pictures
TEXT
}

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
repository=$(cd "$here/../.." && pwd)
build=${TEMPORAL_COHERENCE_PARAVIEW_BUILD:-$repository/build/paraview}
log=$build/run.log
output=$build/pictures
prefix=${TEMPORAL_COHERENCE_PARAVIEW:-}
if [ -z "$prefix" ]; then
  prefix=/opt/paraview
  [ -x "$prefix/usr/bin/pvbatch" ] || { mkdir -p "$prefix" 2>/dev/null && [ -w "$prefix" ]; } ||
    prefix=/var/tmp/vtkTemporalCoherence-paraview
fi

# What paraview-dev needs and does not ask for, what the library needs, and what runs the tests.
packages=(g++ cmake ninja-build libglm-dev libhwy-dev nlohmann-json3-dev zlib1g-dev openmpi-bin libopenmpi-dev libglew-dev
  libfreetype-dev libpython3-dev xvfb xauth libgl1-mesa-dri)
paraview_packages=(paraview paraview-dev python3-paraview)

say() { printf '[paraview] %s\n' "$*"; }
fail() { printf '[paraview] FAILED: %s\n' "$*" >&2; exit 1; }

logged()
{
  if ! "$@" >>"$log" 2>&1; then
    tail -n 30 "$log" >&2
    fail "$1 $2 ended with an error; all that was said is in $log"
  fi
}

apt()
{
  local command=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600)
  if [ "$(id -u)" -ne 0 ]; then
    command=(sudo "${command[@]}")
  fi
  "${command[@]}" "$@"
}

missing_packages()
{
  local package
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' ||
      printf '%s ' "$package"
  done
}

# What the unpacked packages depend on, apart from one another.
dependencies_of() # FILES
{
  local file
  for file in "$@"; do
    dpkg-deb -f "$file" Depends
  done | tr ',' '\n' | sed 's/^ *//; s/ *$//' |
    grep -vE '^(paraview|python3-paraview|paraview-dev)( |$)' | sort -u | paste -sd,
}

# ParaView's CMake files name its Python modules without the tag that later packages of Debian give
# them: modules/vtkX.so is there as modules/vtkX.cpython-314-x86_64-linux-gnu.so.
link_python_modules()
{
  local module
  for module in "$prefix"/usr/lib/python3/dist-packages/paraview/*/*.cpython-*.so; do
    [ ! -e "$module" ] || ln -sf "${module##*/}" "${module%.cpython-*}.so"
  done
}

ensure_paraview()
{
  local missing files dependencies
  command -v apt-get >/dev/null || fail "This is not a Debian system; build the plugin as \
Examples/ParaViewPlugin/README.md says."
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    fail "You are not root and there is no sudo; have it run once by root, then give --no-packages."
  fi
  read -ra missing <<<"$(missing_packages "${packages[@]}")"
  if [ "${#missing[@]}" -eq 0 ] && [ -e "$prefix/.complete" ]; then
    say "Using the ParaView in $prefix"
    return
  fi
  say "Bringing apt's lists up to date"
  apt update >>"$log" 2>&1 || say "apt-get update failed; trying with the lists there are."
  if [ "${#missing[@]}" -gt 0 ]; then
    say "Installing ${missing[*]}"
    logged apt install -y --no-install-recommends "${missing[@]}"
  fi
  [ ! -e "$prefix/.complete" ] || return 0

  say "Unpacking ParaView into $prefix"
  mkdir -p "$prefix" || fail "Cannot write in $prefix; set TEMPORAL_COHERENCE_PARAVIEW."
  downloads=$(mktemp -d)
  trap 'rm -rf "$downloads"' EXIT
  (cd "$downloads" && logged apt-get -o APT::Sandbox::User=root download "${paraview_packages[@]}")
  files=("$downloads"/*.deb)
  dependencies=$(dependencies_of "${files[@]}")
  logged apt satisfy -y --no-install-recommends "$dependencies"
  # A later ParaView has no VTK of its own, and the plugin is built with that of the system.
  case $dependencies in
    *python3-vtk9*) logged apt install -y --no-install-recommends libvtk9-dev ;;
  esac
  local file
  for file in "${files[@]}"; do
    logged dpkg-deb -x "$file" "$prefix"
  done
  link_python_modules
  touch "$prefix/.complete"
}

find_paraview()
{
  local found
  found=("$prefix"/usr/lib/*/cmake/paraview-*/paraview-config.cmake)
  if [ ! -e "${found[0]}" ] || [ ! -x "$prefix/usr/bin/pvbatch" ]; then
    fail "There is no ParaView in $prefix; run this without --no-packages, or set \
TEMPORAL_COHERENCE_PARAVIEW."
  fi
  paraview_cmake=$(dirname "${found[0]}")
  paraview_libraries=${paraview_cmake%/cmake/*}
}

build_plugin()
{
  say "Building the plugin against ${paraview_cmake##*/} (log: $log)"
  logged cmake -S "$repository/Examples/ParaViewPlugin" -B "$build" -G Ninja \
    "-DParaView_DIR=$paraview_cmake" "$@"
  logged cmake --build "$build"
  plugin=$(find "$build" -name TemporalIsosurface.so | head -n 1)
  [ -n "$plugin" ] || fail "The build made no TemporalIsosurface.so; its log is $log"
  say "Built $plugin"
}

# Packages are installed with the same log.
has_no_warnings() { ! grep 'warning:' "$log" | grep -qv '^update-alternatives: '; }

start_display()
{
  local number=$build/display
  Xvfb -displayfd 3 -noreset -nolisten tcp -screen 0 1280x1024x24 3>"$number" 2>>"$log" &
  display_process=$!
  trap 'kill "$display_process" 2>/dev/null || true; rm -rf "${downloads:-}"' EXIT
  for _ in $(seq 600); do
    [ ! -s "$number" ] || break
    kill -0 "$display_process" 2>/dev/null || break
    sleep 0.2
  done
  [ -s "$number" ] || fail "Xvfb did not start; what it said is in $log"
  DISPLAY=:$(cat "$number")
  export DISPLAY
  unset XAUTHORITY
}

# ParaView's libraries and its Python come first: a VTK that is installed may be another.
pvbatch() # PROCESSES ARGUMENTS
{
  local command=("$prefix/usr/bin/pvbatch") processes=$1
  shift
  if [ "$processes" -gt 1 ]; then
    command=(mpirun --allow-run-as-root --oversubscribe -np "$processes" "${command[@]}")
  fi
  PATH=$prefix/usr/bin:$PATH LD_LIBRARY_PATH=$paraview_libraries \
    PYTHONPATH=$prefix/usr/lib/python3/dist-packages:$here PYTHONDONTWRITEBYTECODE=1 \
    TEMPORAL_ISOSURFACE_PLUGIN=$plugin TEMPORAL_ISOSURFACE_OUTPUT=$output \
    timeout 900 "${command[@]}" "$@"
}

# Shows the lines of checks that a script prints and counts them; a script that ends early is one that
# failed.
passed=0
failed=0
run_checks() # PROCESSES SCRIPT ARGUMENTS
{
  local script=$2 said status=0
  said=$build/$(basename "$script" .py)-$1.txt
  set -- "$1" "$here/$script" "${@:3}"
  pvbatch "$@" >"$said" 2>&1 || status=$?
  grep -E '^(passed|FAILED|skipped): ' "$said" || true
  passed=$((passed + $(grep -c '^passed: ' "$said" || true)))
  failed=$((failed + $(grep -c '^FAILED: ' "$said" || true)))
  if [ "$status" -ne 0 ] || grep -qE '^Traceback|ERR\||WARN\|' "$said"; then
    failed=$((failed + 1))
    printf 'FAILED: %s in %s process(es) ended with status %s or an error; see %s\n' \
      "$script" "$1" "$status" "$said"
  fi
}

check() # NAME COMMAND
{
  local name=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
    printf 'passed: %s\n' "$name"
  else
    failed=$((failed + 1))
    printf 'FAILED: %s\n' "$name"
  fi
}

# What was said in one case of wrong use.
said_of() # FILE CASE
{
  sed -n "/^case: $2\$/,/^case: /p" "$1" | grep -v '^case: '
}

says_once() # FILE CASE SENTENCE
{
  [ "$(said_of "$1" "$2" | grep -c 'TemporalI\|TemporalC' || true)" -eq 1 ] &&
    said_of "$1" "$2" | grep -qF "$3"
}

check_wrong_use() # PROCESSES
{
  local said=$build/WrongUse-$1.txt
  pvbatch "$1" "$here/WrongUse.py" >"$said" 2>&1 || true
  check "wrong use, $1 process(es): an isovalue outside of the data" says_once "$said" isovalue \
    "No isosurface of 'RTData' has the isovalue 1500; give Isovalues between 34.0153 and 286.341."
  check "wrong use, $1 process(es): isovalues that are no numbers" says_once "$said" 'no number' \
    "No isosurface of 'RTData' has the isovalue nan, inf; give Isovalues between 34.0153 and 286.341."
  check "wrong use, $1 process(es): the others are shown" grep -qx 'shown: 150.0' "$said"
  check "wrong use, $1 process(es): a scale of 0" says_each "$said" flat \
    "The transform of the volume is singular"
  check "wrong use, $1 process(es): frames that failed are not counted" \
    grep -q '^counted: False' "$said"
  check "wrong use, $1 process(es): a wrong name of an array" says_once "$said" array \
    "The input has no point array 'Nonsense'; choose one that it has with ColorBy: ('POINTS', 'RTData')."
  [ "$1" -eq 1 ] ||
    check "wrong use, $1 process(es): a translucent solid" says_once "$said" 'translucent solid' \
      "Translucent solids show where processes' parts are cut; choose the SurfaceMode Crossing"
  check "wrong use, $1 process(es): floats as labels" says_once "$said" fractions \
    "'RTData' cannot be drawn as labels, which are whole numbers on an image"
  check "wrong use, $1 process(es): a mesh as labels" says_once "$said" 'labels of a mesh' \
    "'Parts' cannot be drawn as labels, which are whole numbers on an image"
  check "wrong use, $1 process(es): no array for colours" says_once "$said" 'no colours' \
    "The input has no point array 'Nonsense'; choose one that it has with ColorBy: ('POINTS', 'RTData')."
  check "wrong use, $1 process(es): no array for surfaces" says_once "$said" 'no surfaces' \
    "The input has no point array 'Nonsense'; choose one that it has with SurfaceArrayName: "
  [ "$1" -eq 1 ] ||
    check "wrong use, $1 process(es): translucent labels" says_once "$said" 'translucent labels' \
      "Translucent labels show where processes' parts are cut; give each label an opacity of 0 or 1."
  check "wrong use, $1 process(es): then all is well again" grep -q '^seen: True' "$said"
  check "wrong use, $1 process(es): an image without arrays" says_once "$said" 'no array' \
    "The input has no array of numbers; give it one"
  check "wrong use, $1 process(es): blocks of two lattices" says_each "$said" 'blocks apart' \
    "Block 2 does not fit the points of Block 1"
  check "wrong use, $1 process(es): no traceback, and it goes on" goes_on "$said"
}

# Each process has its own blocks, and says what is wrong with them.
says_each() { said_of "$1" "$2" | grep -qF "$3"; }
goes_on() { ! grep -q Traceback "$1" && grep -q '^case: end' "$1"; }

measure()
{
  local processes said
  say "Measuring, a volume of 257^3 floats in 1024 x 1024 pixels:"
  printf '%s\n' 'processes rank   ms cold  orbit  sweep   MiB volume  kept  isomap'
  for processes in 1 2 4; do
    said=$build/Measure-$processes.txt
    pvbatch "$processes" --sym "$here/Measure.py" >"$said" 2>&1 || true
    grep -o 'figures.*' "$said" | sort -k3n |
      awk '{ printf "%9d %4d %9d %6d %6d %12d %5d %7d\n", $2, $3, $4, $5, $6, $7, $8, $9 }' ||
      fail "Measure.py gave no figures of $processes process(es); see $said"
  done
}

draw_documentation()
{
  local pictures=$repository/Documentation/Pictures
  say "Drawing $pictures/paraview-*.png"
  TEMPORAL_ISOSURFACE_DOCUMENTATION=$pictures \
    logged pvbatch 4 --sym "$here/DocumentationPictures.py"
}

packages_wanted=yes
figures=no
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --figures) figures=yes ;;
    --no-packages) packages_wanted=no ;;
    --) shift; break ;;
    *) fail "There is no option $1; --help lists those there are." ;;
  esac
  shift
done

begin=$SECONDS
if ! mkdir -p "$build" 2>/dev/null || ! : 2>/dev/null >"$log"; then
  fail "Cannot write in $build; set TEMPORAL_COHERENCE_PARAVIEW_BUILD."
fi
rm -rf "$output"
mkdir -p "$output"
[ "$packages_wanted" = no ] || ensure_paraview
find_paraview
say "ParaView is there after $((SECONDS - begin)) s"
build_plugin "$@"
say "The plugin is there after $((SECONDS - begin)) s"
check "the plugin builds without warnings" has_no_warnings
start_display

run_checks 1 TestPicture.py
run_checks 1 TestReuse.py
run_checks 1 TestProperties.py
run_checks 1 TestLabels.py
run_checks 1 TestSurfaceArray.py
run_checks 1 TestRecipe.py
run_checks 1 TestSharing.py
for processes in 1 2 4; do
  run_checks "$processes" DistributedScenes.py
done
run_checks 1 ComparePictures.py "$output" 2 4
check_wrong_use 1
check_wrong_use 2
if [ "$figures" = yes ]; then
  measure
  draw_documentation
fi

say "$passed checks passed, $failed failed, in $((SECONDS - begin)) s; pictures are in $output"
[ "$failed" -eq 0 ] || fail "$failed checks"
[ "$passed" -gt 0 ] || fail "there was no check"
say "PASSED"
