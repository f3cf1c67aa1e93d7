#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# VTK's examples Medical1 and Medical4 run with the mapper dropped in.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Take VTK's examples Medical1 (skin as polygons) and Medical4 (ray casting) as Debian ships them in
vtk9-examples, drop our mapper in (the changes are Medical1.sed and Medical4.sed), build both and
run both on a display of their own: their pictures, and how long the first frame, a new isovalue
and a turned camera take.

usage: Testing/DropIn/run.sh [--output FOLDER] [--no-packages] [--built] [--quick]

  --output FOLDER  where the pictures (gallery-dropin-*.png) and the page part (dropin.md) go;
                   default: dropin, in the build directory
  --no-packages    install and download no packages
  --built          build nothing of this repository: the build directory is up to date
  --quick          generated spheres in place of a head, few frames
  --help           show this text

The examples are those installed below /usr/share/doc, or else are taken out of the package, which
is downloaded with apt-get into the build directory and not installed. Exit status 2: they cannot be
had.
TEXT
}

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
repository=$(cd "$here/../.." && pwd)
# Not relative: CMake looks for packages below other directories.
TEMPORAL_COHERENCE_BUILD=$(realpath -m "${TEMPORAL_COHERENCE_BUILD:-$repository/build}")
export TEMPORAL_COHERENCE_BUILD
build=$TEMPORAL_COHERENCE_BUILD
work=$build/dropin
output=$work
examples=(Medical1 Medical4)
# shellcheck source-path=SCRIPTDIR source=../Common/Display.sh
. "$repository/Testing/Common/Display.sh"

say() { printf '[drop-in] %s\n' "$*"; }
fail() { printf '[drop-in] FAILED: %s\n' "$*" >&2; exit "${status:-1}"; }

setup_options=(--with-tests)
packages=yes
built=no
slices_options=()
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --no-packages) packages=no; setup_options+=("$1") ;;
    --built) built=yes ;;
    --quick)
      slices_options=(--generated)
      export TEMPORAL_COHERENCE_FRAMES=3 ;;
    --output)
      [ $# -gt 1 ] || fail "--output needs a folder behind it."
      output=$2
      shift ;;
    *) fail "There is no option $1; --help lists those there are." ;;
  esac
  shift
done

logged()
{
  if ! "$@" >>"$work/dropin.log" 2>&1; then
    tail -n 40 "$work/dropin.log" >&2
    fail "$1 $2; all that was said is in $work/dropin.log"
  fi
}

# Names the folder of VTK's medical examples, installed or taken out of their package.
find_examples()
{
  local below=usr/share/doc/vtk9-examples/examples/Examples/Medical/Cxx
  if [ ! -e "/$below/Medical1.cxx" ] && [ ! -e "$work/package/$below/Medical1.cxx" ] &&
    [ "$packages" = yes ] && command -v apt-get >/dev/null && command -v dpkg-deb >/dev/null; then
    say "Downloading Debian's package vtk9-examples (not installed, taken apart in the build directory)"
    (cd "$work" && apt-get download vtk9-examples && dpkg-deb -x vtk9-examples_*.deb package) \
      >>"$work/dropin.log" 2>&1 || true
  fi
  for folder in "/$below" "$work/package/$below"; do
    if [ -e "$folder/Medical1.cxx" ]; then
      originals=$folder
      return
    fi
  done
  status=2 fail "VTK's examples are not there: have Debian's package vtk9-examples installed."
}

change_examples()
{
  local example
  mkdir -p "$work/original" "$work/drop-in"
  for example in "${examples[@]}"; do
    # Only what has changed is written: the rest need not be compiled again.
    cmp -s "$originals/$example.cxx" "$work/original/$example.cxx" ||
      cp "$originals/$example.cxx" "$work/original/$example.cxx"
    sed -f "$here/$example.sed" "$originals/$example.cxx" >"$work/changed.cxx"
    grep -q 'vtkTemporalCoherenceVolumeMapper>::New' "$work/changed.cxx" ||
      fail "$example is not the example that $example.sed knows: look into $originals."
    cmp -s "$work/changed.cxx" "$work/drop-in/$example.cxx" ||
      cp "$work/changed.cxx" "$work/drop-in/$example.cxx"
  done
}

build_examples()
{
  say "Building the examples, before and after, against an installation in $build/install"
  logged cmake --install "$build" --prefix "$build/install"
  logged cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$build/install" -DEXAMPLES="$work"
  logged cmake --build "$work/build" --parallel
}

# Runs one program; its times are in the variables first, isovalue and orbit.
run_example() # EXAMPLE KIND
{
  local times
  times=$(TEMPORAL_COHERENCE_PICTURE=$output/gallery-dropin-${1,,}-$2.png \
    with_display "$work/build/$1-$2" "$work/slices/quarter" 2>>"$work/dropin.log") ||
    fail "$1 ($2) has failed; what it said is in $work/dropin.log"
  first=$(awk '$1 == "first" { printf "%.0f", $2 }' <<<"$times")
  isovalue=$(awk '$1 == "isovalue" { printf "%.1f", $2 }' <<<"$times")
  orbit=$(awk '$1 == "orbit" { printf "%.1f", $2 }' <<<"$times")
  if [ -z "$orbit" ] || [ ! -s "$output/gallery-dropin-${1,,}-$2.png" ]; then
    fail "$1 ($2) has drawn nothing; what it said is in $work/dropin.log"
  fi
}

show_example() # EXAMPLE
{
  local example=$1 row before after
  local before_first before_isovalue before_orbit
  row=${example,,}
  run_example "$example" original
  before_first=$first before_isovalue=$isovalue before_orbit=$orbit
  run_example "$example" drop-in
  before="![$example as it is](Pictures/gallery-dropin-$row-original.png)"
  after="![$example with the mapper dropped in](Pictures/gallery-dropin-$row-drop-in.png)"
  cat <<TEXT

### $example

| | as Debian ships it | with the mapper dropped in |
| --- | --- | --- |
| picture | $before | $after |
| first frame, reading included | $before_first ms | $first ms |
| a new isovalue | $before_isovalue ms | $isovalue ms |
| the camera turned by 2 degrees | $before_orbit ms | $orbit ms |

\`\`\`diff
$(diff -U0 "$work/original/$example.cxx" "$work/drop-in/$example.cxx" | sed -e 1,2d -e '/^@@/d')
\`\`\`
TEXT
}

[ "$built" = yes ] || "$repository/Module/setup.sh" "${setup_options[@]}"
mkdir -p "$work/slices" "$output" 2>/dev/null ||
  fail "Cannot make the folder $output; name one that can be written in with --output."
output=$(cd "$output" && pwd)
: >"$work/dropin.log"
find_examples
change_examples
build_examples
volume=$("$work/build/HeadSlices" "$work/slices" "${slices_options[@]}") || fail "There are no slices to read."
say "Running them on $volume"
{
  printf '<!-- made: dropin -->\n\nThe volume: %s, 64 x 64 x 93; windows of 640 x 480 pixels.\n' "$volume"
  for example in "${examples[@]}"; do
    show_example "$example"
  done
  printf '\n<!-- end -->\n'
} >"$output/dropin.md"
say "PASSED: the pictures and dropin.md are in $output"
