#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build and run the tests, from nothing if need be.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Build vtkTemporalCoherence with its tests and run them on a display of their own.

usage: Testing/run.sh [--no-packages] [CTEST_ARGUMENTS]

  --no-packages    install no packages (see Module/setup.sh --help)
  --help           show this text

CTEST_ARGUMENTS go to ctest, for example -R Mapper, -j 2 or -V. The exit status is 0 only if
tests ran and none failed.
TEXT
}

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export TEMPORAL_COHERENCE_BUILD=${TEMPORAL_COHERENCE_BUILD:-$repository/build}
build=$TEMPORAL_COHERENCE_BUILD
log=$build/ctest.log
# shellcheck source-path=SCRIPTDIR source=Common/Display.sh
. "$repository/Testing/Common/Display.sh"

setup_options=(--with-tests)
ctest_arguments=()
for argument in "$@"; do
  case $argument in
    --help | -h) usage; exit 0 ;;
    --no-packages) setup_options+=("$argument") ;;
    *) ctest_arguments+=("$argument") ;;
  esac
done

"$repository/Module/setup.sh" "${setup_options[@]}"

begin=$SECONDS
status=0
on_own_display ctest --test-dir "$build" --output-on-failure --no-tests=error \
  "${ctest_arguments[@]}" 2>&1 | tee "$log" || status=1

summary=$(grep -E '^[0-9]+% tests passed' "$log" | tail -n 1 || true)
skipped=$(grep -c '\*\*\*Skipped' "$log" || true)
if [ "$status" -eq 0 ] && [ -n "$summary" ]; then
  printf '[tests] PASSED: %s; %s SKIPPED, in %s s\n' "$summary" "$skipped" "$((SECONDS - begin))"
else
  printf '[tests] FAILED: %s, in %s s; all output is in %s\n' "${summary:-no test ran}" \
    "$((SECONDS - begin))" "$log"
  exit 1
fi
