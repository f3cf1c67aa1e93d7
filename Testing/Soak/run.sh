#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Memory stays flat over 100000 frames, 2000 mappers and 300 windows.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Build vtkTemporalCoherence and soak it: 100000 small frames over all features, 2000 mappers, 300
windows. Resident memory is told at ten stages of each, and may grow by 5 % behind the first tenth.

usage: Testing/Soak/run.sh [--no-packages] [--built] [SOAK_ARGUMENTS]

  --no-packages    install no packages (see Module/setup.sh --help)
  --built          build nothing: the build directory is up to date
  --help           show this text, and the arguments that Soak takes

Windows are on a display of their own. The table goes into soak.md of the build directory, too. The
exit status is 0 if memory is flat, and not if this system does not tell (SKIPPED).
TEXT
}

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
export TEMPORAL_COHERENCE_BUILD=${TEMPORAL_COHERENCE_BUILD:-$repository/build}
build=$TEMPORAL_COHERENCE_BUILD
# shellcheck source-path=SCRIPTDIR source=../Common/Display.sh
. "$repository/Testing/Common/Display.sh"

setup_options=(--with-tests)
built=no
soak_arguments=()
for argument in "$@"; do
  case $argument in
    --help | -h)
      usage
      [ ! -x "$build/bin/Soak" ] || { printf '\n'; "$build/bin/Soak" --help; }
      exit 0 ;;
    --no-packages) setup_options+=("$argument") ;;
    --built) built=yes ;;
    *) soak_arguments+=("$argument") ;;
  esac
done

[ "$built" = yes ] || "$repository/Module/setup.sh" "${setup_options[@]}"
begin=$SECONDS
status=0
# The program's verdict comes last, once, and with what the script knows.
on_own_display "$build/bin/Soak" "${soak_arguments[@]}" | tee "$build/soak.md" | sed -u '/^\[soak\]/d' || status=1
verdict=$(grep '^\[soak\] ' "$build/soak.md" | tail -n 1) || verdict=
case $status$verdict in
  '0[soak] PASSED'* | '1[soak] FAILED'* | '1[soak] SKIPPED'*) ;;
  *) status=1; verdict='[soak] FAILED: the program did not end well' ;;
esac
printf '%s; %s s, the table is in %s\n' "$verdict" "$((SECONDS - begin))" "$build/soak.md"
exit "$status"
