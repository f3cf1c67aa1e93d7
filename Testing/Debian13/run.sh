#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build and run the tests on Debian 13, whose VTK is 9.3, whatever Debian this machine has.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Build vtkTemporalCoherence and run its tests in a Debian 13 (trixie) of its own, with VTK 9.3.

usage: Testing/Debian13/run.sh [--fresh] [CTEST_ARGUMENTS]

  --fresh          begin with an empty system, even if there is one of an earlier run
  --help           show this text

Run it as root, on a Debian machine of any version. The system is made with debootstrap from the
mirror that this machine's apt uses; it and the build are kept, so that a second run takes up what
is there. The tree is copied as it is, with what is not committed. CTEST_ARGUMENTS go to ctest, for
example -R Mapper. The exit status is 0 only if tests ran and none failed.

environment:
  TEMPORAL_COHERENCE_DEBIAN13     where the system is kept (about 4 GB);
                                  default: /var/tmp/vtkTemporalCoherence-debian13
  TEMPORAL_COHERENCE_CMAKE_FLAGS  further arguments for CMake, separated by spaces
TEXT
}

system_label=debian13
system_name="Debian 13"
suite=trixie
system=${TEMPORAL_COHERENCE_DEBIAN13:-/var/tmp/vtkTemporalCoherence-debian13}
system_variable=TEMPORAL_COHERENCE_DEBIAN13
# shellcheck source=Testing/Systems/system.sh
. "$(dirname "${BASH_SOURCE[0]}")/../Systems/system.sh"

# What is the same keeps its time, so that it is not built again; what changed is newer than all that
# was built, even if it was written while that was going on.
copy_tree()
{
  local tree=$system/source copied=$system/source.new file
  rm -rf "$copied"
  mkdir -p "$tree" "$copied"
  tar -C "$repository" --exclude=./.git --exclude='./build*' --exclude=./install \
    --exclude=./pictures -cf - . | tar -C "$copied" --no-same-owner --touch -xf -
  while IFS= read -r -d '' file; do
    if cmp --silent "$tree/$file" "$copied/$file"; then
      touch --reference="$tree/$file" "$copied/$file"
    fi
  done < <(cd "$copied" && find . -type f -print0)
  rm -rf "$tree"
  mv "$copied" "$tree"
}

fresh=no
ctest_arguments=()
for argument in "$@"; do
  case $argument in
    --help | -h) usage; exit 0 ;;
    --fresh) fresh=yes ;;
    *) ctest_arguments+=("$argument") ;;
  esac
done

require_root_on_debian
ensure_system "$fresh"
copy_network_settings
copy_tree
status=0
in_system TEMPORAL_COHERENCE_BUILD=/build \
  TEMPORAL_COHERENCE_CMAKE_FLAGS="${TEMPORAL_COHERENCE_CMAKE_FLAGS:-}" \
  /source/Testing/run.sh "${ctest_arguments[@]}" || status=$?

# shellcheck disable=SC2016 # expanded by dpkg
version=$(chroot "$system" dpkg-query -W -f '${Version}' libvtk9-dev 2>/dev/null || true)
[ "$status" -eq 0 ] || fail "on Debian 13, VTK ${version:-not installed}; logs are in $system/build"
say "PASSED: on Debian 13, VTK $version"
