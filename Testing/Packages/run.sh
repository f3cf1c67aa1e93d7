#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Make the Debian packages and use them in a Debian 12 that has nothing else.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Make the Debian packages of vtkTemporalCoherence and test them in a Debian 12 (bookworm) of its own.

usage: Testing/Packages/run.sh [--fresh] [--no-packages] [--packages DIRECTORY]

  --fresh               make the bare Debian 12 anew, even if there is one of an earlier run
  --no-packages         install nothing of what making the packages needs
  --packages DIRECTORY  test the packages that are there instead of making them
  --help                show this text

Run it as root; packages are made on Debian 12 only (Module/package.sh). Every run begins with a copy of
a bare Debian 12, made with debootstrap from the mirror that this machine's apt uses, and installs with
apt, without recommended packages:
  the Python package   it is imported, every program of Examples/Python runs, and so do the tests of
                       Testing/Python that need no display
  the -dev package, g++, cmake and ninja-build
                       Examples/DropIn and Examples/OrbitAndSweep are built and run; a program that wants
                       another version is told so
Nothing has a display. At last the packages are purged, and nothing of them may be left.

environment:
  TEMPORAL_COHERENCE_DEBIAN12  where the system and what apt downloads are kept (about 5 GB);
                               default: /var/tmp/vtkTemporalCoherence-debian12
  and those of Module/package.sh
TEXT
}

directory=${TEMPORAL_COHERENCE_DEBIAN12:-/var/tmp/vtkTemporalCoherence-debian12}
system_label=packages
system_name="Debian 12"
suite=bookworm
system=$directory/bare
system_variable=TEMPORAL_COHERENCE_DEBIAN12
# shellcheck source=Testing/Systems/system.sh
. "$(dirname "${BASH_SOURCE[0]}")/../Systems/system.sh"

fresh=no
packages=
package_options=()
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --fresh) fresh=yes ;;
    --no-packages) package_options+=("$1") ;;
    --packages)
      [ $# -gt 1 ] || fail "--packages needs a directory"
      packages=$2
      shift
      ;;
    *) fail "there is no option $1; --help lists those there are" ;;
  esac
  shift
done

make_packages()
{
  local version_id
  version_id=$(. /etc/os-release && printf '%s' "${VERSION_ID:-}")
  [ "$version_id" = 12 ] ||
    fail "packages for Debian 12 are made on Debian 12; give those made there with --packages DIRECTORY"
  TEMPORAL_COHERENCE_BUILD=${TEMPORAL_COHERENCE_BUILD:-$repository/build-packages}
  export TEMPORAL_COHERENCE_BUILD
  "$repository/Module/package.sh" "${package_options[@]}" || fail "there are no packages to test"
  packages=$TEMPORAL_COHERENCE_BUILD/packages
}

# A copy, as what is installed in it is to be gone at the next run; only downloads are kept.
copy_system()
{
  local bare=$system
  system=$directory/used
  empty_system
  cp -a "$bare/." "$system"
  mkdir -p "$system.archives/partial"
}

copy_what_is_tested()
{
  local name debs
  for name in 'libvtktemporalcoherence[0-9]*' libvtktemporalcoherence-dev python3-vtktemporalcoherence; do
    mapfile -t debs < <(find "$packages" -maxdepth 1 -name "${name}_*.deb")
    [ "${#debs[@]}" -eq 1 ] ||
      fail "there has to be one package $name in $packages, and there are ${#debs[@]}"
    install -D -m 644 -t "$system/test/packages" "${debs[0]}"
  done
  mkdir -p "$system/test/Testing"
  cp -r "$repository/Examples" "$system/test"
  cp -r "$repository/Testing/Packages" "$repository/Testing/Python" "$system/test/Testing"
}

require_root_on_debian
begin=$SECONDS
[ -n "$packages" ] || make_packages
mkdir -p "$directory"
ensure_system "$fresh"
copy_system
copy_network_settings
copy_what_is_tested

in_system bash /test/Testing/Packages/inside.sh ||
  fail "on Debian 12, after $((SECONDS - begin)) s; logs are in $system/test/logs"
say "PASSED: on Debian 12, in $((SECONDS - begin)) s"
