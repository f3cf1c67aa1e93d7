#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes pages of the public headers: see usage() below.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Make pages of the public classes from the comments of their headers, by Doxygen.

usage: Documentation/api.sh [--no-packages]

  --no-packages  do not install Doxygen if it is missing
  --help         show this text

The pages lie in api/html of the build directory. It is an error if something public has no comment.

environment:
  TEMPORAL_COHERENCE_BUILD  the build directory; default: build, in the repository
TEXT
}

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
output=$(realpath -m "${TEMPORAL_COHERENCE_BUILD:-$repository/build}")/api
packages=yes

say() { printf '[api] %s\n' "$*"; }
fail() { printf '[api] FAILED: %s\n' "$*" >&2; exit 1; }

ensure_doxygen()
{
  local apt_get=(env DEBIAN_FRONTEND=noninteractive apt-get -qq)
  ! command -v doxygen >/dev/null || return 0
  [ "$packages" = yes ] || fail "There is no Doxygen."
  command -v apt-get >/dev/null || fail "This is not a Debian system: install Doxygen, and run this again."
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "You are not root and there is no sudo: have doxygen installed."
    apt_get=(sudo "${apt_get[@]}")
  fi
  say "Installing doxygen"
  "${apt_get[@]}" update || say "apt-get update failed; trying with the lists there are."
  "${apt_get[@]}" install -y --no-install-recommends doxygen >/dev/null || fail "Could not install doxygen."
}

# The headers that are installed, as the module's list names them, in the folder of the repository.
public_headers()
{
  sed -n '/^  HEADERS$/,/)$/p' "$repository/vtkTemporalCoherence/vtkTemporalCoherence.cmake" |
    grep -o 'vtk[A-Za-z]*\.h' | sed 's|^|vtkTemporalCoherence/|'
}

while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --no-packages) packages=no ;;
    *) fail "There is no option $1; --help lists those there are." ;;
  esac
  shift
done

ensure_doxygen
mkdir -p "$output" 2>/dev/null || fail "Cannot write in $output; set TEMPORAL_COHERENCE_BUILD."
rm -rf "$output/html"
cd "$repository"
read -ra headers <<<"$(public_headers | tr '\n' ' ')"
[ "${#headers[@]}" -gt 0 ] || fail "The list of public headers is empty."
version=$(sed -n 's/.*project(vtkTemporalCoherence VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
{
  cat Documentation/Doxyfile
  printf '%s\n' "PROJECT_NUMBER = $version" "OUTPUT_DIRECTORY = \"$output\"" "INPUT = ${headers[*]}"
} | doxygen - || fail "Doxygen complains, as told above."
say "PASSED: pages of ${#headers[@]} headers in $output/html/annotated.html"
