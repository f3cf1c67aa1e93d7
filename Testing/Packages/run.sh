#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The Debian packages work in a Debian that has nothing else, and leave nothing when they are purged.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Make the Debian packages of vtkTemporalCoherence and test them in a bare Debian of the same suite.

usage: Testing/Packages/run.sh [bookworm|trixie|sid] [--fresh] [--packages DIRECTORY]

  bookworm, ...         which suite; default: that of this machine
  --fresh               make the systems anew, even if there are some of an earlier run
  --packages DIRECTORY  test the packages that are there instead of making them
  --help                show this text

Run it as root, on a Debian machine of any version. Module/package.sh makes the packages in the system
of Testing/Systems/run.sh. Every run tests them in a copy of a bare system, made with debootstrap from
the mirror that this machine's apt uses, and installs with apt, without recommended packages:
  the Python package   it is imported, every program of Examples/Python runs, and so do the tests of
                       Testing/Python that need no display
  the -dev package, g++, cmake and ninja-build
                       Examples/DropIn and Examples/OrbitAndSweep are built and run; a program that wants
                       another version is told so
  the command          it draws pictures and a film, and has a manual page
  the Explorer         it says that there is no display; the desktop knows it and its types of files
  the pages            the examples beside them are built as they lie there
Nothing has a display. At last the packages are purged, and nothing of them may be left.

environment: that of Testing/Systems/run.sh
TEXT
}

# shellcheck source=Testing/Systems/system.sh
. "$(dirname "${BASH_SOURCE[0]}")/../Systems/system.sh"

name=$(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-}")
fresh=no
packages=
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --fresh) fresh=yes ;;
    --packages)
      [ $# -gt 1 ] || fail "--packages needs a directory"
      packages=$2
      shift
      ;;
    -*) fail "there is no option $1; --help lists those there are" ;;
    *) name=$1 ;;
  esac
  shift
done
choose_suite "$name"

make_packages()
{
  local system=$systems/$suite epoch settings=() variable
  ensure_system "$fresh"
  copy_tree "$system"
  # The copy does not know its last commit.
  epoch=$(git -c safe.directory="$repository" -C "$repository" log -1 --format=%ct 2>/dev/null) ||
    epoch=$(date +%s)
  settings=(TEMPORAL_COHERENCE_BUILD=/build-packages SOURCE_DATE_EPOCH="$epoch")
  for variable in TEMPORAL_COHERENCE_CMAKE_FLAGS DEBFULLNAME DEBEMAIL; do
    [ -z "${!variable:-}" ] || settings+=("$variable=${!variable}")
  done
  in_system "$system" "${settings[@]}" /source/Module/package.sh || fail "there are no packages to test"
  packages=$system/build-packages/packages
}

copy_what_is_tested()
{
  local name debs
  for name in 'libvtktemporalcoherence[0-9]*' libvtktemporalcoherence-dev python3-vtktemporalcoherence \
    vtktemporalcoherence-bin vtktemporalcoherence-explorer vtktemporalcoherence-doc; do
    mapfile -t debs < <(find "$packages" -maxdepth 1 -name "${name}_*.deb")
    [ "${#debs[@]}" -eq 1 ] ||
      fail "there has to be one package $name in $packages, and there are ${#debs[@]}"
    install -D -m 644 -t "$used/test/packages" "${debs[0]}"
  done
  mkdir -p "$used/test/Testing"
  cp -r "$repository/Examples" "$used/test"
  cp -r "$repository"/Testing/{Packages,Python,Files} "$used/test/Testing"
}

begin=$SECONDS
used=$systems/$suite-used
[ -n "$packages" ] || make_packages
prepare_used_system "$fresh"
copy_what_is_tested

in_system "$used" bash /test/Testing/Packages/inside.sh ||
  fail "packages on Debian $suite, after $((SECONDS - begin)) s; logs are in $used/test/logs"
say "PASSED: packages on Debian $suite, in $((SECONDS - begin)) s"
