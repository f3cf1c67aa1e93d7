#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The pictures of the Explorer in Documentation/Pictures, from real volumes.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Make pictures of the Explorer at work: an isovalue being dragged, skin that is see-through and a
plane that opens it, a blended volume, an orbit with the yellow overlay.

usage: Testing/Explorer/pictures.sh EXPLORER DATA DIRECTORY

  EXPLORER    the program ScriptedExplorer, which is built with Examples/Explorer (EXPLORER_TESTS=ON)
  DATA        a directory with engine.vti, cthead.vti and brain.vti
  DIRECTORY   where explorer.png, explorer-clip.png, explorer-volume.png and explorer-yellow.png go
  --help      show this text

Needs xdotool and a display that nobody else uses: put xvfb-run -s "-screen 0 1280x1024x24" in front.
The times in the pictures are those of this machine.
TEXT
}

case ${1:-} in --help | -h) usage; exit 0 ;; esac
if [ $# -ne 3 ]; then
  usage >&2
  exit 1
fi
explorer=$(realpath "$1")
data=$(realpath "$2")
directory=$(realpath "$3")
scratch=$(mktemp -d)
export XDG_CONFIG_HOME=$scratch
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
  xdotool mousemove 1279 1023 mousemove 400 300 sleep 0.5 key Shift_L sleep 0.5
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

place() { grep -F "place $1 " "$scratch/log" | tail -n 1 | sed -E 's/.* ([0-9]+) ([0-9]+)$/\1 \2/'; }
# Raises a panel that lies behind others.
raise() # NAME
{
  local x y
  read -r x y <<<"$(place "tab-$1")"
  xdotool mousemove "$x" "$y" click 1 sleep 0.3
}
finish() { xdotool mouseup 1 key q; wait "$program" || true; program=; }

start "$data/engine.vti"
raise Re-use
drag 450 300 30 5 3 0.05
xdotool mouseup 1 sleep 1
read -r x y <<<"$(place histogram)"
drag $((x + 250)) "$y" 40 4 0 0.1
keep explorer.png
finish

cat >"$scratch/head.session" <<TEXT
# vtkTemporalCoherence Explorer session 1
volume = $data/cthead.vti
surfaces = 500 0.35 1 0.9 0.65 0.5 ; 1150 1 1 0.97 0.94 0.86
camera-position = 560 -420 60
camera-focal-point = 127 127 112
camera-view-up = 0 0 -1
clip = 127 100 112 -0.45 0.89 0
TEXT
start "$scratch/head.session"
xdotool mousemove 60 500
keep explorer-clip.png
finish

cat >"$scratch/volume.session" <<TEXT
# vtkTemporalCoherence Explorer session 1
volume = $data/cthead.vti
camera-position = 560 -420 60
camera-focal-point = 127 127 112
camera-view-up = 0 0 -1
drawing = composite
opacity = 0 0 ; 480 0 0.8 0.45 0.35 ; 620 0.07 0.9 0.6 0.45 ; 1050 0.02 0.95 0.8 0.7 ; 1250 0.7 1 0.97 0.9 ; 3272 0.9 1 1 1
density = 4
TEXT
start "$scratch/volume.session"
keep explorer-volume.png
finish

start "$data/brain.vti"
# With the paper's own accuracy, as its figure 8.
raise Re-use
xdotool key p key p key a key y sleep 0.5
drag 350 300 60 2 0 0.1
keep explorer-yellow.png
finish
printf '[pictures] PASSED: pictures are in %s\n' "$directory"
