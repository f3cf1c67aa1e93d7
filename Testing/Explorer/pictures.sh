#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The pictures of the Explorer in Documentation/Pictures, from real volumes.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Make pictures of the Explorer at work: an isovalue being dragged, an orbit with the yellow overlay,
the list of keys.

usage: Testing/Explorer/pictures.sh EXPLORER ENGINE HEAD DIRECTORY

  EXPLORER    the program, Examples/Explorer
  ENGINE      the engine block's volume file, for the drag
  HEAD        a head's volume file, for the overlay (isovalue 62: ch2better.nii.gz of mricron-data)
  DIRECTORY   where explorer.png, explorer-yellow.png and explorer-keys.png go
  --help      show this text

Needs xdotool and a display that nobody else uses: put xvfb-run -s "-screen 0 1280x1024x24" in front.
The times in the pictures are those of this machine.
TEXT
}

case ${1:-} in --help | -h) usage; exit 0 ;; esac
if [ $# -ne 4 ]; then
  usage >&2
  exit 1
fi
explorer=$(realpath "$1")
directory=$(realpath "$4")
scratch=$(mktemp -d)
program=
stop() { [ -z "$program" ] || kill "$program" 2>/dev/null || true; rm -rf "$scratch"; }
trap stop EXIT

start() # VOLUME [ISOVALUE]
{
  : >"$scratch/log"
  "$explorer" "$@" --size 1280x800 --output "$scratch" --log "$scratch/log" >/dev/null &
  program=$!
  until grep -q '^frame 1 ' "$scratch/log"; do
    kill -0 "$program" # ends the script where the program has ended
    sleep 0.1
  done
  # The keyboard follows the pointer into the window.
  xdotool mousemove 1279 1023 mousemove 300 300 sleep 0.5
}

# The window with panels, taken while the button is held.
keep() # NAME
{
  xdotool sleep 1 key S sleep 1
  mv "$scratch/explorer-0001.png" "$directory/$1"
}

drag() # X Y STEPS DX DY SECONDS   leaves the button down
{
  local step
  xdotool mousemove "$1" "$2" mousedown 1 sleep 2
  for ((step = 1; step <= $3; ++step)); do
    xdotool mousemove $(($1 + $4 * step)) $(($2 + $5 * step)) sleep "$6"
  done
}

finish() { xdotool mouseup 1 key q; wait "$program" || true; program=; }

start "$2"
drag 450 300 30 5 3 0.05
xdotool mouseup 1 sleep 1
drag 300 740 40 4 0 0.1
keep explorer.png
xdotool mouseup 1 key question
keep explorer-keys.png
finish

start "$3" 62
# With the paper's own accuracy, as its figure 8.
xdotool key p key p key a key a key y sleep 0.5
drag 350 300 60 2 0 0.1
keep explorer-yellow.png
finish
printf '[pictures] PASSED: pictures are in %s\n' "$directory"
