#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Debian 12, 13 and sid pass everything that is tested there, whatever Debian this machine has.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Build and test vtkTemporalCoherence in a Debian of its own: all tests, packages, examples, the plugin.

usage: Testing/Systems/run.sh bookworm|trixie|sid [--fresh] [--only PART]... [CTEST_ARGUMENTS]

  bookworm         Debian 12, with VTK 9.1
  trixie           Debian 13, with VTK 9.3
  sid              what Debian works on, with VTK 9.6
  --fresh          begin with an empty system, even if there is one of an earlier run
  --only PART      do this part only; may be repeated. Parts are, in this order:
                     suite      Testing/run.sh: all tests, or those of CTEST_ARGUMENTS
                     packages   Testing/Packages/run.sh: Debian packages, tried in a bare system
                     wheel      Testing/Wheel/run.sh: a Python wheel, tried in a bare system
                     examples   Examples/run.sh
                     paraview   Testing/ParaView/run.sh: the plugin for the suite's ParaView
                                (SKIPPED on trixie)
  --help           show this text

Run it as root, on a Debian machine of any version. The system is made with debootstrap from the
mirror that this machine's apt uses; it and the build are kept, so that a second run takes up what
is there. The tree is copied as it is, with what is not committed. CTEST_ARGUMENTS go to ctest, for
example -R Mapper. A part that fails does not stop the others. The exit status is 0 only if all parts
passed.

environment:
  TEMPORAL_COHERENCE_SYSTEMS      where the systems of all suites are kept (about 11 GB each);
                                  default: /var/tmp/vtkTemporalCoherence-systems
  TEMPORAL_COHERENCE_CMAKE_FLAGS  further arguments for CMake, separated by spaces
TEXT
}

# shellcheck source=Testing/Systems/system.sh
. "$(dirname "${BASH_SOURCE[0]}")/system.sh"

all_parts="suite packages wheel examples paraview"
name=
fresh=no
parts=()
ctest_arguments=()
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --fresh) fresh=yes ;;
    --only)
      [[ $# -gt 1 && " $all_parts " == *" $2 "* ]] || fail "--only needs one of $all_parts"
      parts+=("$2")
      shift
      ;;
    *)
      if [ -z "$name" ]; then
        name=$1
      else
        ctest_arguments+=("$1")
      fi
      ;;
  esac
  shift
done
[ -n "$name" ] || fail "which one? Choose one of $suites"
[ "${#parts[@]}" -gt 0 ] || read -ra parts <<<"$all_parts"
choose_suite "$name"

part_suite()
{
  in_system "$system" TEMPORAL_COHERENCE_BUILD=/build \
    TEMPORAL_COHERENCE_CMAKE_FLAGS="${TEMPORAL_COHERENCE_CMAKE_FLAGS:-}" \
    /source/Testing/run.sh "${ctest_arguments[@]}"
}

part_packages() { "$repository/Testing/Packages/run.sh" "$suite"; }
part_wheel() { "$repository/Testing/Wheel/run.sh" "$suite"; }

part_examples()
{
  in_system "$system" TEMPORAL_COHERENCE_BUILD=/build \
    TEMPORAL_COHERENCE_CMAKE_FLAGS="${TEMPORAL_COHERENCE_CMAKE_FLAGS:-}" \
    /source/Examples/run.sh --output /pictures
}

# ParaView has a system of its own: what it brings must not hide that a package of the library's own
# set-up is missing, nor the other way round.
part_paraview()
{
  local own=$systems/$suite-paraview flags
  if [ "$suite" = trixie ]; then
    say "Nothing can be built against Debian 13's ParaView 5.13: its CMake files link libraries that" \
      "they do not look for"
    return 77
  fi
  read -ra flags <<<"${TEMPORAL_COHERENCE_CMAKE_FLAGS:-}"
  ensure_system "$fresh" "$own"
  copy_tree "$own"
  in_system "$own" TEMPORAL_COHERENCE_PARAVIEW_BUILD=/build \
    /source/Testing/ParaView/run.sh -- "${flags[@]}"
}

system=$systems/$suite
if [ "${parts[*]}" != paraview ]; then
  ensure_system "$fresh"
  copy_tree "$system"
fi
results=()
failed=()
for part in $all_parts; do
  [[ " ${parts[*]} " == *" $part "* ]] || continue
  begin=$SECONDS
  say "Part $part"
  status=0
  "part_$part" || status=$?
  case $status in
    0) results+=("$part: passed, $((SECONDS - begin)) s") ;;
    77) results+=("$part: SKIPPED") ;;
    *)
      results+=("$part: FAILED, $((SECONDS - begin)) s")
      failed+=("$part")
      ;;
  esac
done

for result in "${results[@]}"; do
  say "$result"
done
tested="${parts[*]} on Debian $suite"
[ "${parts[*]}" = paraview ] || tested+=", VTK $(vtk_version "$system")"
[ "${#failed[@]}" -eq 0 ] ||
  fail "${failed[*]} of $tested; logs are in $system/build, $system-paraview/build and $system-used/test/logs"
say "PASSED: $tested"
