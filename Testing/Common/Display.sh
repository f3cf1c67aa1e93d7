# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sourced by scripts whose programs draw in windows.

# Run a command on a display of its own.
on_own_display() # COMMAND...
{
  local started attempt display
  if ! command -v xvfb-run >/dev/null; then
    printf 'There is no display to draw on: install xvfb, or set DISPLAY.\n' >&2
    return 1
  fi
  started=$(mktemp -u)
  # A number far from 99, where everybody begins: in a container, xvfb-run does not see a server
  # of the machine around it, but clients of the same number would connect to that one.
  for attempt in 1 2 3 4 5; do
    display=$((200 + RANDOM % 700))
    # shellcheck disable=SC2016 # expanded by the inner shell
    xvfb-run --server-num="$display" --auto-servernum --server-args="-screen 0 1280x1024x24 -noreset" \
      bash -c 'touch "$0" && exec "$@"' "$started" "$@" && rm -f "$started" && return 0
    # What failed was the program, not the display.
    if [ -f "$started" ]; then
      rm -f "$started"
      return 1
    fi
    printf 'No X server at display %s (attempt %s of 5)\n' "$display" "$attempt" >&2
  done
  return 1
}

# Run a command on the display there is, or on one of its own.
with_display() # COMMAND...
{
  if [ -n "${DISPLAY:-}" ]; then
    "$@"
  else
    on_own_display "$@"
  fi
}
