#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# From a fresh Debian machine to packages for machines like it: see usage() below.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Make Debian packages of vtkTemporalCoherence: the library, its development files, its Python package, the
command temporal-coherence, the Explorer, and the pages with examples.

usage: Module/package.sh [--no-packages] [-- CMAKE_ARGUMENTS]

  --no-packages    install nothing of what making them needs (see Module/setup.sh --help)
  --help           show this text

Sets up, builds in Release mode for the prefix /usr, and makes the packages with cpack. They are for
the Debian that they are made on, and its VTK; install them with

  apt install BUILD/packages/*.deb

environment:
  TEMPORAL_COHERENCE_BUILD        the build directory; default: build-packages, in the repository
  TEMPORAL_COHERENCE_CMAKE_FLAGS  further arguments for CMake, separated by spaces
  DEBFULLNAME, DEBEMAIL           who answers for the packages
  SOURCE_DATE_EPOCH               the time that is written into them; default: that of the last commit
TEXT
}

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export TEMPORAL_COHERENCE_BUILD=${TEMPORAL_COHERENCE_BUILD:-$repository/build-packages}
build=$(realpath -m "$TEMPORAL_COHERENCE_BUILD")
log=$build/package.log

say() { printf '[package] %s\n' "$*"; }
fail() { printf '[package] FAILED: %s\n' "$*" >&2; exit 1; }

setup_options=(--with-packaging --with-explorer)
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --no-packages) setup_options+=("$1") ;;
    --) shift; break ;;
    *) fail "There is no option $1; --help lists those there are." ;;
  esac
  shift
done

if [ -z "${SOURCE_DATE_EPOCH:-}" ]; then
  SOURCE_DATE_EPOCH=$(git -c safe.directory="$repository" -C "$repository" log -1 --format=%ct \
    2>/dev/null) || SOURCE_DATE_EPOCH=$(date +%s)
fi
export SOURCE_DATE_EPOCH

# Where the Python package goes follows from the prefix, also in a build that had another one.
"$repository/Module/setup.sh" "${setup_options[@]}" -- -DCMAKE_INSTALL_PREFIX=/usr \
  -UTEMPORAL_COHERENCE_PYTHON_DIRECTORY -DTEMPORAL_COHERENCE_WRAP_PYTHON=ON \
  -DTEMPORAL_COHERENCE_BUILD_PROGRAMS=ON "$@" ||
  fail "there is nothing to make packages of"

rm -f "$build/packages"/*.deb
(cd "$build" && cpack -G DEB) >"$log" 2>&1 ||
  { tail -n 20 "$log" >&2; fail "cpack made no packages; all that was said is in $log"; }
for package in "$build/packages"/*.deb; do
  say "$(du -k "$package" | cut -f 1) kB: $package"
done
say "PASSED"
