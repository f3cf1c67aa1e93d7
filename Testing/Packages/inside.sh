#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What run.sh does inside of the system: everything below /test, which run.sh put there.
set -euo pipefail

library=$(cd /test/packages && find . -name 'libvtktemporalcoherence[0-9]*' -printf '%f' | sed 's/_.*//')
development=libvtktemporalcoherence-dev
python=python3-vtktemporalcoherence
command=vtktemporalcoherence-bin
explorer=vtktemporalcoherence-explorer
pages=vtktemporalcoherence-doc
logs=/test/logs
mkdir -p "$logs" /test/results
unset DISPLAY WAYLAND_DISPLAY

say() { printf '[packages] %s\n' "$*"; }
fail() { printf '[packages] %s\n' "$*" >&2; exit 1; }

# Runs a command that has to succeed, with its output in a log of that name.
logged() # NAME COMMAND...
{
  local log=$logs/$1.log
  shift
  "$@" >"$log" 2>&1 </dev/null || { tail -n 30 "$log" >&2; fail "failed: $*"; }
}

apt() { DEBIAN_FRONTEND=noninteractive apt-get -y --no-install-recommends "$@"; }

install() # NAME PACKAGES...
{
  local begin=$SECONDS before now
  before=$(dpkg-query -W | wc -l)
  logged "install-$1" apt install "${@:2}"
  now=$(dpkg-query -W | wc -l)
  say "Installed ${*:2}: $((now - before)) packages, $((SECONDS - begin)) s"
}

check_pictures() # COUNT FILES...
{
  logged pictures python3 /test/Testing/Packages/check_pictures.py "$@"
}

test_python()
{
  install python "/test/packages/$library"_*.deb "/test/packages/$python"_*.deb
  [ ! -e /usr/include/vtkTemporalCoherence ] || fail "headers were installed with the Python package"
  logged python-import python3 -c '
from vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper
mapper = vtkTemporalCoherenceVolumeMapper()
print(mapper.GetClassName(), mapper.GetRouteAsString())'
  say "Python imports the package"

  local autoload
  autoload=$(dirname "$(dpkg -L "$library" | grep '/autoload/.*[.]so$')")
  logged autoload env VTK_AUTOLOAD_PATH="$autoload" python3 -c '
from vtkmodules.all import vtkGPUVolumeRayCastMapper
name = vtkGPUVolumeRayCastMapper().GetClassName()
assert name == "vtkTemporalCoherenceGPUVolumeRayCastMapper", name'
  say "VTK loads the mapper of $autoload by itself"

  # What others import is a part of them, also where they try to.
  local example name directory test
  for example in /test/Examples/Python/*.py; do
    name=$(basename "$example" .py)
    ! grep -q "^ *from $name import" /test/Examples/Python/*.py || continue
    directory=/test/results/$name
    mkdir -p "$directory"
    local arguments=()
    [ "$name" != depth ] || arguments=(--output depth.png) # else it opens a window
    (cd "$directory" && logged "python-$name" python3 "$example" "${arguments[@]}")
    find "$directory" -type f -size +1k | grep -q . || fail "$name wrote nothing"
    say "Examples/Python/$name.py: it runs"
  done
  check_pictures 2 /test/results/drop_in/*.png /test/results/render_server/pictures/*.png
  # The tests put directories before those of PYTHONPATH; here it has to name none of ours.
  for test in Arrays Examples Frames Isosurface Names; do
    logged "python-Test$test" env PYTHONPATH=/nowhere python3 "/test/Testing/Python/Test$test.py"
    say "Testing/Python/Test$test.py: $(tail -n 1 "$logs/python-Test$test.log")"
  done
}

test_command()
{
  local results=/test/results/command
  install command "/test/packages/$library"_*.deb "/test/packages/$command"_*.deb
  mkdir -p "$results"
  logged command-picture temporal-coherence --spheres 64 --iso 80,180 -o "$results/surfaces.png"
  logged command-preset temporal-coherence --spheres 64 --preset mr --size 300 -o "$results/mr.png"
  logged command-film temporal-coherence --spheres 64 --film turn --frames 3 --size 200 -o "$results/film"
  check_pictures 5 "$results"/*.png "$results"/film/*.png
  # Manual pages are left out of small systems when packages are unpacked.
  dpkg -L "$command" | grep -q '/man1/temporal-coherence.1.gz$' || fail "the command has no manual page"
  say "temporal-coherence draws: $(tail -n 1 "$logs/command-picture.log")"
}

build_example() # NAME [DIRECTORY OF THE EXAMPLES]
{
  logged "configure-$1" cmake -S "${2:-/test/Examples}/$1" -B "/test/build/$1" -G Ninja
  logged "build-$1" cmake --build "/test/build/$1"
}

test_development()
{
  install development "/test/packages/$development"_*.deb g++ cmake ninja-build
  ! dpkg-query -W libglm-dev libhwy-dev >"$logs/private.log" 2>&1 ||
    fail "the development package brings what only the library itself is built with"

  build_example DropIn
  mkdir -p /test/results/DropIn
  (cd /test/results/DropIn && logged run-DropIn /test/build/DropIn/DropIn)
  check_pictures 1 /test/results/DropIn/*.png
  say "Examples/DropIn: built and run"

  build_example OrbitAndSweep
  logged run-OrbitAndSweep /test/build/OrbitAndSweep/OrbitAndSweep \
    --spheres 64 --isovalue 100 --quick --output /test/results/OrbitAndSweep
  check_pictures 11 /test/results/OrbitAndSweep/*.png
  say "Examples/OrbitAndSweep: built and run"

}

# It draws in a window, which there is none of here, and says so.
test_explorer()
{
  install explorer libvtk9-qt-dev
  build_example Explorer
  ! /test/build/Explorer/Explorer --spheres 16 >"$logs/run-Explorer.log" 2>&1 ||
    fail "the Explorer finds a display where there is none"
  [ "$(wc -l <"$logs/run-Explorer.log")" -eq 1 ] || fail "the Explorer needs more than a sentence to say so"
  say "Examples/Explorer: built; $(cat "$logs/run-Explorer.log")"

  install explorer-package "/test/packages/$explorer"_*.deb shared-mime-info desktop-file-utils
  ! "$explorer" --spheres 16 >"$logs/run-explorer.log" 2>&1 ||
    fail "the packaged Explorer finds a display where there is none"
  [ "$(wc -l <"$logs/run-explorer.log")" -eq 1 ] ||
    fail "the packaged Explorer needs more than a sentence to say so"
  logged desktop desktop-file-validate "/usr/share/applications/$explorer.desktop"
  grep -q 'application/x-nifti:[*][.]nii' /usr/share/mime/globs2 ||
    fail "the desktop does not know types of volumes"
  say "$explorer: installed; the desktop knows it and its types of files"
}

test_pages()
{
  local directory=/usr/share/doc/$pages
  logged install-pages apt install "/test/packages/$pages"_*.deb
  if [ -e "$directory/README.md" ]; then
    build_example Command "$directory/Examples"
    logged run-Command /test/build/Command/temporal-coherence --spheres 32 -o /test/results/pages.png
    say "$pages: Examples/Command is built as it lies there"
  else
    say "$pages: installed; this system leaves documents out"
  fi
}

test_wrong_version()
{
  local log=$logs/wrong-version.log version
  # shellcheck disable=SC2016 # expanded by dpkg
  version=$(dpkg-query -W -f '${Version}' "$development")
  if cmake -S /test/Testing/Packages/Consumer -B /test/build/Consumer -G Ninja -DWANTED_VERSION=99.1 >"$log" 2>&1; then
    fail "a program that wants version 99.1 was given ${version%-*}"
  fi
  if ! grep -q 'requested version "99.1"' "$log" || ! grep -q "version: ${version%-*}" "$log"; then
    fail "a program that wants version 99.1 is not told which there is; see $log"
  fi
  say "A program that wants another version is told which there is"
}

test_purge()
{
  local left
  logged purge apt purge "$development" "$python" "$command" "$explorer" "$pages" "$library"
  ldconfig
  left=$(find / -xdev -ipath '*temporalcoherence*' -not -path '/test/*' -not -path '/proc/*')
  [ -z "$left" ] || fail "left after purging: $left"
  [ -z "$(dpkg-query -W '*temporalcoherence*' 2>/dev/null | grep . || true)" ] ||
    fail "dpkg still knows: $(dpkg-query -W '*temporalcoherence*')"
  say "Purged without a trace"
}

logged update apt update
test_python
test_command
test_development
test_explorer
test_pages
test_wrong_version
test_purge
