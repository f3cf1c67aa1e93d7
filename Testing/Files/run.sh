#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Broken files of all formats end in a picture, or in one sentence that names the file, in C++ and in
# Python.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Break small volumes of all formats that the examples open, and expect a picture, or one sentence that
names the file, from each: no crash, no end that does not come (20 s), no gigabytes.

usage: Testing/Files/run.sh [--no-packages] [COUNT [FIRST [FILES...]]]

  COUNT            broken files of each format; default: 500
  FIRST            the number of the first of them; the same number makes the same file; default: 1
  FILES            volumes to break instead of the small ones
  --no-packages    install no packages (see Module/setup.sh --help)
  --help           show this text

Files are opened as the Explorer, OrbitAndSweep and the examples in Python open them, without a
window. What is found stays in Testing/Files/found-... of the build directory; put its format and
number into Testing/Files/seeds.txt. The default takes some 20 minutes on two cores.
TEXT
}

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
export TEMPORAL_COHERENCE_BUILD=${TEMPORAL_COHERENCE_BUILD:-$repository/build}
build=$TEMPORAL_COHERENCE_BUILD

setup_options=(--with-tests)
positionals=()
for argument in "$@"; do
  case $argument in
    --help | -h) usage; exit 0 ;;
    --no-packages) setup_options+=("$argument") ;;
    -*) usage >&2; exit 1 ;;
    *) positionals+=("$argument") ;;
  esac
done
count=${positionals[0]:-500}
first=${positionals[1]:-1}
files=("${positionals[@]:2}")
for number in "$count" "$first"; do
  if ! [[ $number =~ ^[0-9]+$ ]]; then
    usage >&2
    exit 1
  fi
done

"$repository/Module/setup.sh" "${setup_options[@]}"

status=0
campaign() # NAME OPENER WAYS
{
  local arguments=(--opener "$2" --ways "$3" --count "$count" --first "$first"
    --scratch "$build/Testing/Files/found-$1")
  if [ "${#files[@]}" -gt 0 ]; then
    arguments+=(--files "${files[@]}")
  fi
  printf '[files] %s\n' "$1"
  PYTHONPATH=$build/python${PYTHONPATH:+:$PYTHONPATH} OPENBLAS_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1 \
    /usr/bin/python3 "$repository/Testing/Files/fuzz_files.py" "${arguments[@]}" || status=1
}
campaign cxx "$build/bin/OpenFiles" explorer,orbit
if [ -d "$build/python" ]; then
  campaign python "/usr/bin/python3 $repository/Testing/Files/open_files.py" python
else
  printf '[files] SKIPPED: the Python package was not built\n'
fi
if [ "$status" -eq 0 ]; then
  printf '[files] PASSED: every file is drawn, or refused in one sentence\n'
else
  printf '[files] FAILED: see above; the files are in %s\n' "$build/Testing/Files"
fi
exit "$status"
