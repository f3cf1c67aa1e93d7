#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The Python wheel works in a Debian that has nothing else, and leaves nothing when it is uninstalled.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Make the Python wheel of vtkTemporalCoherence for a suite's own VTK, and install it in a bare Debian.

usage: Testing/Wheel/run.sh [bookworm|trixie|sid] [--fresh] [--wheel FILE]

  bookworm, ...    which suite; default: that of this machine
  --fresh          make the systems anew, even if there are some of an earlier run
  --wheel FILE     test this wheel instead of making one
  --help           show this text

Run it as root, on a Debian machine of any version. The wheel is made with scikit-build-core in the
system of Testing/Systems/run.sh, as pyproject.toml says, but for the suite's own VTK, without PyPI. It
is installed by pip in a copy of a bare system that has the suite's packages of VTK and NumPy. There it
draws a picture, shows VTK's programs what VTK_AUTOLOAD_PATH names, and passes the tests of
Testing/Python that need no display. At last it is uninstalled, and nothing of it may be left. Where
there is no scikit-build-core, as in bookworm, all this is skipped; the exit status is 77 then.

environment: that of Testing/Systems/run.sh
TEXT
}

# shellcheck source=Testing/Systems/system.sh
. "$(dirname "${BASH_SOURCE[0]}")/../Systems/system.sh"

name=$(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-}")
fresh=no
wheel=
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --fresh) fresh=yes ;;
    --wheel)
      [ $# -gt 1 ] || fail "--wheel needs a file"
      wheel=$2
      shift
      ;;
    -*) fail "there is no option $1; --help lists those there are" ;;
    *) name=$1 ;;
  esac
  shift
done
choose_suite "$name"

make_wheel()
{
  local system=$systems/$suite settings=() status=0
  ensure_system "$fresh"
  copy_tree "$system"
  if [ -n "${TEMPORAL_COHERENCE_CMAKE_FLAGS:-}" ]; then
    settings=("CMAKE_ARGS=$TEMPORAL_COHERENCE_CMAKE_FLAGS")
  fi
  rm -rf "$system/wheel"
  in_system "$system" "${settings[@]}" bash /source/Testing/Wheel/make.sh || status=$?
  if [ "$status" -eq 3 ]; then
    say "SKIPPED: no wheel, as Debian $suite has no scikit-build-core"
    exit 77
  fi
  [ "$status" -eq 0 ] || fail "there is no wheel to test; the log is $system/wheel/make.log"
  wheel=$(find "$system/wheel" -name '*.whl')
}

begin=$SECONDS
[ -n "$wheel" ] || make_wheel
used=$systems/$suite-used
prepare_used_system "$fresh"
install -D -m 644 -t "$used/test/wheel" "$wheel"
mkdir -p "$used/test/Testing"
cp -r "$repository/Examples" "$used/test"
cp -r "$repository"/Testing/{Wheel,Packages,Python,Files} "$used/test/Testing"

in_system "$used" bash /test/Testing/Wheel/inside.sh ||
  fail "the wheel on Debian $suite, after $((SECONDS - begin)) s; logs are in $used/test/logs"
say "PASSED: the wheel on Debian $suite, in $((SECONDS - begin)) s"
