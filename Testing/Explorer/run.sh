#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The Explorer does what its keys and the mouse say, at 96 and 192 dpi, and a session gives the same
# picture, byte for byte.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Use the Explorer by mouse and keys, and check what it says of each frame and what it writes.

usage: Testing/Explorer/run.sh EXPLORER CHECK_PICTURE DROP_FILE SCRATCH [DPI]

  EXPLORER         the program, Examples/Explorer; beside it lies ScriptedExplorer, the same one
                   with options for tests (EXPLORER_TESTS=ON)
  CHECK_PICTURE    the program that fails for pictures that show nothing
  DROP_FILE        the program that drops a file on a window
  SCRATCH          a directory that is emptied and written in
  DPI              of the display; default 96. With 192 only the main ways are tried
  --help           show this text

Needs Xvfb, xdotool and perl; nothing is installed. With TEMPORAL_COHERENCE_DATA the drag is over
engine.vti of that directory, else over generated spheres. What a frame took is printed, not
checked. Takes half a minute.
TEXT
}

case ${1:-} in --help | -h) usage; exit 0 ;; esac
if [ $# -lt 4 ]; then
  usage >&2
  exit 1
fi
explorer=$(realpath "$1")
scripted=$(dirname "$explorer")/ScriptedExplorer
check_picture=$(realpath "$2")
drop_file=$(realpath "$3")
mkdir -p "$4"
scratch=$(realpath "$4")
dpi=${5:-96}
scale=$((dpi / 96))
# Neither the settings of whoever tests, nor the scale of their screen.
export XDG_CONFIG_HOME=$scratch/settings XDG_RUNTIME_DIR=$scratch/runtime LC_ALL=C.UTF-8
unset QT_SCALE_FACTOR QT_QPA_PLATFORM WAYLAND_DISPLAY
patience=${PATIENCE:-120} # seconds until something that has not happened is a failure; nothing takes that long

say() { printf '[explorer] %s\n' "$*"; }
fail()
{
  say "FAILED: $*"
  for file in "$scratch"/*.log "$scratch"/*.out; do
    [ ! -e "$file" ] || { printf -- '--- %s, its end:\n' "$file"; tail -n 15 "$file"; }
  done
  exit 1
}
for tool in Xvfb xdotool perl; do
  command -v "$tool" >/dev/null || fail "there is no $tool; Module/setup.sh --with-tests installs it"
done

# --- A display, and a program on it -------------------------------------------------------------

server=
program=
stop_all()
{
  [ -z "$program" ] || kill "$program" 2>/dev/null || true
  [ -z "$server" ] || kill "$server" 2>/dev/null || true
}
trap stop_all EXIT

# A number that nobody has: in a container, servers of the machine around it may not be seen, but
# clients would connect to them.
start_display()
{
  local attempt number
  for attempt in 1 2 3 4 5; do
    number=$((1000 + RANDOM % 8000))
    rm -f "$scratch/display"
    Xvfb ":$number" -screen 0 $((1280 * scale))x$((1024 * scale))x24 -dpi "$dpi" -noreset -displayfd 3 3>"$scratch/display" 2>/dev/null &
    server=$!
    for _ in $(seq $((patience * 10))); do
      if [ -s "$scratch/display" ]; then
        export DISPLAY=:$number
        return 0
      fi
      kill -0 "$server" 2>/dev/null || break
      sleep 0.1
    done
    kill "$server" 2>/dev/null || true
    say "No X server at display $number (attempt $attempt of 5)"
  done
  fail "no X server could be started"
}

log=
# Starts the program with these arguments; its log has the first one's name.
start() # NAME ARGUMENTS...
{
  log=$scratch/$1.log
  local output=$scratch/$1.out
  shift
  : >"$log"
  rm -rf "${XDG_CONFIG_HOME:?}" # each begins with the same window
  (cd "$scratch/files" && exec "$scripted" --log "$log" --size $((900 * scale))x$((700 * scale)) "$@") >"$output" 2>&1 &
  program=$!
  expect '^frame 1 '
  # The keyboard follows the pointer into the window.
  xdotool mousemove $((1200 * scale)) $((1000 * scale)) mousemove $((300 * scale)) $((250 * scale))
  settle
}

expect_end()
{
  local status=0
  wait "$program" || status=$?
  program=
  [ "$status" -eq 0 ] || fail "the program ended with status $status"
}

# --- Looking at the log -------------------------------------------------------------------------

lines() { wc -l <"$log"; }

# Waits for a line after the first FROM ones.
expect() # PATTERN [FROM]
{
  local from=${2:-0} waited=0
  until tail -n "+$((from + 1))" "$log" | grep -qE "$1"; do
    kill -0 "$program" 2>/dev/null || fail "the program ended; '$1' was expected"
    [ "$waited" -lt $((patience * 20)) ] || fail "'$1' was expected and did not come"
    sleep 0.05
    waited=$((waited + 1))
  done
}

# Waits until all that was done by hand before has been dealt with. Shift alone does nothing, but the
# log tells of it, and hands are looked at in their order.
settle()
{
  local from
  while true; do
    from=$(lines)
    xdotool key Shift_L
    expect '^key(-while-busy)? Shift_L' "$from"
    ! tail -n "+$((from + 1))" "$log" | grep -q '^key Shift_L' || return 0
  done
}

last_frame() { grep '^frame' "$log" | tail -n 1; }
field() { sed -E "s/.* $1 ([^ ]+).*/\\1/"; } # of a frame's line
place() { grep -F "place $1 " "$log" | tail -n 1 | sed -E 's/.* ([0-9]+) ([0-9]+)$/\1 \2/'; }

# --- Hands --------------------------------------------------------------------------------------

# A key; then the log has such a line that it had not before.
key() # KEY PATTERN
{
  local from
  from=$(lines)
  xdotool key "$1"
  expect "$2" "$from"
}

click() # NAME PATTERN [BUTTON]
{
  local from x y
  from=$(lines)
  read -r x y <<<"$(place "$1")"
  [ -n "$x" ] || fail "$1 has no place in the window"
  xdotool mousemove "$x" "$y" click "${3:-1}"
  expect "$2" "$from"
}

# Gives the keys back to the view: there is no window manager that would do it.
to_view()
{
  xdotool mousemove $((300 * scale)) $((250 * scale)) click 1
  settle
}

# Another value of a box of values.
choose() # NAME KEY PATTERN
{
  local from x y
  from=$(lines)
  read -r x y <<<"$(place "$1")"
  xdotool mousemove "$x" "$y" click 1 sleep 0.2 key "$2" Return
  expect "$3" "$from"
  to_view
}

# Turns the view, waiting for each frame.
orbit() # STEPS
{
  local step from x=$((300 * scale)) y=$((250 * scale))
  xdotool mousemove "$x" "$y" mousedown 1
  for step in $(seq "$1"); do
    from=$(lines)
    xdotool mousemove $((x + 4 * step)) $((y + step))
    expect '^frame' "$from"
  done
  xdotool mouseup 1
  settle
}

saved() { grep '^said Saved .*png$' "$log" | tail -n 1 | sed 's/^said Saved //'; }
width_of() { od -An -tu1 -j16 -N4 "$1" | awk '{ print (($1 * 256 + $2) * 256 + $3) * 256 + $4 }'; }

# A picture of what is seen: $picture.
take_picture()
{
  key s '^said Saved .*png$'
  picture=$scratch/files/$(saved)
  "$check_picture" "$picture" >/dev/null || fail "the picture $picture shows nothing"
  settle
}

# --- What is checked ----------------------------------------------------------------------------

make_files()
{
  rm -rf "${scratch:?}"/*
  mkdir -p "$scratch/files" "$XDG_RUNTIME_DIR"
  chmod 700 "$XDG_RUNTIME_DIR"
  # A ball of 24^3 samples.
  perl -e 'for $k (0..23) { for $j (0..23) { for $i (0..23) {
    $d = sqrt(($i-11.5)**2 + ($j-11.5)**2 + ($k-11.5)**2);
    print pack("C", $d > 12 ? 0 : 240 - 20 * $d); } } }' >"$scratch/files/ball.raw"
  printf 'ObjectType = Image\nNDims = 3\nDimSize = 24 24 24\nElementType = MET_UCHAR\nElementDataFile = ball.raw\n' \
    >"$scratch/files/ball.mhd"
  cp "$scratch/files/ball.mhd" "$scratch/files/球 كرة.mhd"
  # A tetrahedron whose values rise with time.
  perl -e 'print qq(<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid TimeValues="0 1 2">
      <Piece NumberOfPoints="4" NumberOfCells="1"><PointData Scalars="value">);
    for $t (0..2) { $v = 10 * $t; $w = $v + 100;
      print qq(<DataArray type="Float32" Name="value" format="ascii" TimeStep="$t">$v $v $v $w</DataArray>); }
    print qq(</PointData><Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">
      0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>
      <DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3</DataArray>
      <DataArray type="Int32" Name="offsets" format="ascii">4</DataArray>
      <DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells></Piece>
      </UnstructuredGrid></VTKFile>);' >"$scratch/files/series.vtu"
  printf 'This is no XML.' >"$scratch/files/broken.vti"
  # Half of a coarse ball, of hexahedra: a mesh.
  perl -e '$n = 9; print "# vtk DataFile Version 3.0\nball\nASCII\nDATASET STRUCTURED_GRID\n";
    print "DIMENSIONS $n $n $n\nPOINTS ", $n**3, " float\n";
    for $k (0..$n-1) { for $j (0..$n-1) { for $i (0..$n-1) { print "$i $j ", $k + 0.1 * $i, "\n"; } } }
    print "POINT_DATA ", $n**3, "\nSCALARS distance float 1\nLOOKUP_TABLE default\n";
    for $k (0..$n-1) { for $j (0..$n-1) { for $i (0..$n-1) {
      print sqrt($i**2 + ($j-4)**2 + ($k-4)**2), "\n"; } } }' >"$scratch/files/half.vtk"
}

check_refusals()
{
  local said
  refused() # WORDS ARGUMENTS...
  {
    local words=$1 status=0
    shift
    said=$("$explorer" "$@" 2>&1 >/dev/null) || status=$?
    if [ "$status" -ne 1 ] || [ "$(wc -l <<<"$said")" -ne 1 ] || ! grep -qF -e "$words" <<<"$said"; then
      fail "$*: one line with '$words' and status 1 were expected, not $status and: $said"
    fi
  }
  refused 'There is no file' "$scratch/missing.vti"
  refused 'could not be read' "$scratch/files/broken.vti"
  refused 'outside the values of' --spheres 16 --isovalue 900
  refused 'No such file or directory' --spheres 16 --screenshot "$scratch/no/picture.png"
  printf '# vtkTemporalCoherence Explorer session 1\nspheres = 16\naccuracy = perfect\n' >"$scratch/bad.session"
  refused 'Line 3' --session "$scratch/bad.session"
  DISPLAY=:99999 refused 'cannot be opened' --spheres 16
  say "Wrong use is refused in one sentence"
}

check_help()
{
  key question '^help on'
  # F1 by its code: with the keymaps of Debian sid, xdotool takes the name for Alt+F1.
  key 67 '^help off'
}

# A hundred steps, a pixel or more each; every one shows another isovalue, looked up.
check_drag()
{
  local x0 x1 y step from begin
  read -r x0 y <<<"$(place isovalue-least)"
  read -r x1 y <<<"$(place isovalue-greatest)"
  begin=$((x0 + (x1 - x0) / 4))
  from=$(lines)
  xdotool mousemove "$begin" "$y" mousedown 1
  expect '^frame' "$from"
  settle
  local first
  first=$(lines)
  for step in $(seq 100); do
    from=$(lines)
    xdotool mousemove $((begin + step * (x1 - x0) / 200)) "$y"
    expect '^frame' "$from"
  done
  xdotool mouseup 1
  settle
  tail -n "+$((first + 1))" "$log" | grep '^frame' | head -n 100 >"$scratch/drag"
  local values looked_up median
  values=$(field isovalue <"$scratch/drag" | sort -gu | wc -l)
  looked_up=$(grep -c 'route IsomapLookup' "$scratch/drag") || true
  median=$(field ms <"$scratch/drag" | sort -g | sed -n 50p)
  [ "$values" -eq 100 ] || fail "100 steps of the slider showed $values isovalues"
  field isovalue <"$scratch/drag" | sort -gc || fail "the isovalues do not follow the slider"
  [ "$looked_up" -eq 100 ] || fail "only $looked_up of 100 isovalues were looked up"
  say "Slider: 100 steps, 100 isovalues, all looked up; median frame $median ms (not checked)"
}

check_arrows()
{
  local before after
  before=$(last_frame | field isovalue)
  key Right '^frame'
  key shift+Right '^frame'
  after=$(last_frame | field isovalue)
  # 11 of 256 steps over the range of the values.
  awk -v a="$before" -v b="$after" 'BEGIN { exit !(b > a) }' ||
    fail "the arrow keys moved the isovalue from $before to $after"
  key Left '^frame'
}

check_orbit()
{
  local from cached
  from=$(lines)
  orbit 3
  tail -n "+$((from + 1))" "$log" | grep -q 'route ImageCache' &&
    fail "exact pictures of an orbit came from the image cache"
  key a '^accuracy paper'
  settle
  from=$(lines)
  orbit 20
  cached=$(tail -n "+$((from + 1))" "$log" | grep -c 'route ImageCache') || true
  # A frame is completed by a cold one where the hand rests, and steps may be joined. But no turned
  # view is cold at once.
  [ "$cached" -ge 10 ] || fail "only $cached frames of an orbit came from the image cache"
  ! tail -n "+$((from + 1))" "$log" | sed -n 's/^frame .* route \([^ ]*\) .*/\1/p' | uniq -d | grep -q Cold ||
    fail "a turned view did not come from the image cache"
  key a '^accuracy exact'
  settle
  say "Orbit: cold frames; as in the paper $cached from the image cache, then completed"
}

# Every value of a choice by key, and back to the first.
turn_all() # KEY NAME VALUES...
{
  local k=$1 name=$2 value
  shift 2
  for value in "${@:2}" "$1"; do
    key "$k" "^$name $value"
    settle
  done
}

check_choices()
{
  turn_all p palette tissue ivory steel ember viridis cool-warm
  [ "$(last_frame | field route)" = Reshade ] || fail "new colours cast rays: $(last_frame)"
  turn_all m material satin matt glossy flat
  turn_all l light studio head side rim
  turn_all v surface open solid
  turn_all a accuracy exact paper
  turn_all c image-cache on off
  turn_all i isomap on off
  turn_all j leaping on off
  turn_all k map-ahead on off
  turn_all x scale 1 2 4
  turn_all f film png ogv
  key l '^light head'
  key shift+l '^light studio'
  choose palette Down '^palette ivory'
  choose palette Up '^palette tissue'
  # Its panel lies behind others at first.
  local x y
  read -r x y <<<"$(place tab-Re-use)"
  xdotool mousemove "$x" "$y" click 1
  settle
  click image-cache '^image-cache off'
  click image-cache '^image-cache on'
  # Without the image cache an orbit is cold.
  local from
  key c '^image-cache off'
  from=$(lines)
  orbit 3
  tail -n "+$((from + 1))" "$log" | grep -q 'route Cold' ||
    fail "with the image cache off a new view was not cold"
  key c '^image-cache on'
  say "All choices turn by key, those tried by mouse"
}

# Yellow is seen in pictures that the image cache helped with.
check_yellow()
{
  key a '^accuracy paper'
  orbit 2
  key y '^answers on'
  orbit 3
  take_picture
  cp "$picture" "$scratch/yellow.png"
  key y '^answers off'
  settle
  take_picture
  ! cmp -s "$picture" "$scratch/yellow.png" || fail "the yellow overlay cannot be seen"
  key a '^accuracy exact'
  settle
}

check_pictures()
{
  local width upright
  take_picture
  upright=$picture
  key u '^frame'
  take_picture
  ! cmp -s "$picture" "$upright" || fail "the picture was not turned upside down"
  key u '^frame'
  take_picture
  width=$(width_of "$picture")
  key x '^scale 2'
  take_picture
  [ "$(width_of "$picture")" -eq $((2 * width)) ] || fail "a picture of scale 2 is not twice as wide"
  key shift+x '^scale 1'
  # The window itself, with the panels.
  key S '^said Saved .*png$'
  [ "$(width_of "$scratch/files/$(saved)")" -eq 900 ] || fail "a picture of the window has another size"
  settle
}

check_recording()
{
  local count from
  key r '^said Recording'
  orbit 8
  key r '^said Recorded'
  count=$(find "$scratch/files/recording-0001" -name 'frame-*.png' | wc -l)
  [ "$count" -ge 8 ] || fail "a recording of 8 frames has $count"
  "$check_picture" "$scratch"/files/recording-0001/*.png >/dev/null || fail "recorded pictures show nothing"
  key f '^film ogv'
  from=$(lines)
  key r '^said (Recording|This VTK cannot)'
  if ! tail -n "+$((from + 1))" "$log" | grep -q 'This VTK cannot'; then
    orbit 8
    key r '^said Recorded'
    [ "$(head -c 4 "$scratch/files/recording-0001.ogv")" = OggS ] || fail "the film is no Ogg file"
  fi
  key f '^film png'
  say "Recorded $count pictures and a film"
}

check_map()
{
  local from
  orbit 2
  from=$(lines)
  key b '^said The isomap'
  tail -n "+$((from + 1))" "$log" | grep -q 'is built' || fail "the isomap was not built"
  # The program stands still while both keys are pressed. So Escape waits when the build asks for
  # it, which it does at least once before its end, however fast it is.
  orbit 2
  from=$(lines)
  kill -STOP "$program"
  # The place of the mouse is asked for, because the answer follows what the server had to tell.
  xdotool key b key Escape getmouselocation >/dev/null
  kill -CONT "$program"
  expect '^said The isomap' "$from"
  tail -n "+$((from + 1))" "$log" | grep -q 'was stopped' || fail "Escape did not stop the isomap"
  settle
  say "An isomap is built ahead, and stopped by Escape"
}

# Waits for a dialog, types a path into it and ends it.
answer() # TITLE PATH
{
  local waited=0
  until xdotool search --onlyvisible --name "$1" >/dev/null 2>&1; do
    [ "$waited" -lt $((patience * 20)) ] || fail "there is no dialog '$1'"
    sleep 0.05
    waited=$((waited + 1))
  done
  # Keys go to it once it has the focus, and are lost before.
  local from
  from=$(lines)
  until tail -n "+$((from + 1))" "$log" | grep -q '^key'; do
    [ "$waited" -lt $((patience * 20)) ] || fail "the dialog '$1' takes no keys"
    xdotool key Shift_L sleep 0.05
    waited=$((waited + 1))
  done
  xdotool type "$2"
  xdotool key Return
}

check_opening()
{
  local from
  from=$(lines)
  xdotool key o
  answer 'Open a volume' "$scratch/files/ball.mhd"
  expect '^opened ball.mhd' "$from"
  to_view
  from=$(lines)
  xdotool key ctrl+o
  answer 'Open a volume' "$scratch/files/broken.vti"
  expect "^said '.*broken.vti' could not be read" "$from"
  to_view
  from=$(lines)
  orbit 2
  tail -n "+$((from + 1))" "$log" | grep -q '^frame' || fail "after a bad file nothing is drawn any more"
  from=$(lines)
  "$drop_file" "$scratch/files/球 كرة.mhd" $((300 * scale)) $((250 * scale)) ||
    fail "a file could not be dropped"
  expect '^opened 球 كرة.mhd' "$from"
  settle
  say "Files open by dialog and by dropping, with names of all scripts; a bad one leaves what was shown"
}

# For pictures that are compared: the grain of ambient occlusion depends on the frames before.
without_occlusion()
{
  xdotool key 1
  settle
}

# Everything in a state of its own, kept, and found again by another process.
check_session()
{
  without_occlusion
  key p '^palette ivory'
  key l '^light head'
  key v '^surface solid'
  orbit 5
  key w '^said Saved explorer.session'
  settle
  take_picture
  cp "$picture" "$scratch/before.png"
  cp "$scratch/files/explorer.session" "$scratch/before.session"
  key h '^frame'
  key z '^opened'
  key q '^quit'
  expect_end

  start second --session explorer.session
  take_picture
  cmp "$picture" "$scratch/before.png" || fail "a restored session shows another picture"
  key w '^said Saved explorer.session'
  cmp "$scratch/files/explorer.session" "$scratch/before.session" ||
    fail "a restored session is saved as another one"
  key q '^quit'
  expect_end
  say "A session restored in another process shows the same picture, byte for byte"
}

# Normals of meshes: a switch that only meshes have.
check_mesh()
{
  start mesh half.vtk 3.5
  without_occlusion
  take_picture
  cp "$picture" "$scratch/smooth.png"
  key g '^gradients facets'
  settle
  take_picture
  ! cmp -s "$picture" "$scratch/smooth.png" || fail "smooth normals of a mesh cannot be seen"
  key g '^gradients smooth'
  settle
  take_picture
  cmp "$picture" "$scratch/smooth.png" || fail "the smooth normals did not come back"
  key q '^quit'
  expect_end
  say "Meshes have a switch for smooth normals"
}

# A file with three time steps is played; a press stops it.
check_time()
{
  local from
  start time series.vtu
  from=$(lines)
  key period '^shown .*step 2 of 3'
  settle
  key comma '^shown .*step 1 of 3'
  settle
  key space '^shown .*step 2 of 3'
  expect '^shown .*step 3 of 3' "$from"
  xdotool key space
  settle
  key q '^quit'
  expect_end
  say "Time steps are turned and played"
}

# The plane's arrow is dragged in the view.
check_clipping()
{
  local x y from before after
  start clip --spheres 64
  without_occlusion
  take_picture
  cp "$picture" "$scratch/whole.png"
  key t '^frame'
  settle
  take_picture
  ! cmp -s "$picture" "$scratch/whole.png" || fail "nothing is clipped"
  cp "$picture" "$scratch/clipped.png"
  # The plane goes through the middle of the view; there it has a handle of another kind.
  read -r x y <<<"$(place view-middle)"
  x=$((x + 60 * scale))
  y=$((y + 60 * scale))
  from=$(lines)
  xdotool mousemove "$x" "$y" mousedown 1 mousemove $((x - 20 * scale)) "$y" \
    mousemove $((x - 40 * scale)) "$y" mouseup 1
  expect '^frame' "$from"
  settle
  take_picture
  ! cmp -s "$picture" "$scratch/clipped.png" || fail "the plane was not dragged"
  key ctrl+z '^frame'
  settle
  take_picture
  cmp "$picture" "$scratch/clipped.png" || fail "the plane's drag was not undone"
  key t '^frame'
  settle
  take_picture
  cmp "$picture" "$scratch/whole.png" || fail "without the plane not all is seen"
  key e '^frame'
  key e '^frame'
  key ctrl+n '^frame'
  key ctrl+d '^frame'
  turn_all d drawing surfaces composite maximum minimum average additive labels
  key q '^quit'
  expect_end
  say "The volume is clipped by a plane that is dragged, blended, and all is undone"
}

make_files
start_display
check_refusals
volume=(--spheres 128)
if [ -r "${TEMPORAL_COHERENCE_DATA:-}/engine.vti" ]; then
  volume=("$TEMPORAL_COHERENCE_DATA/engine.vti")
fi
start first "${volume[@]}"
if [ "$dpi" -gt 96 ]; then
  # The main ways: drag, turn, open, save, restore, play, clip.
  check_drag
  check_opening
  check_session
  check_time
  check_clipping
  say "PASSED at $dpi dpi in $SECONDS s"
  exit 0
fi
check_help
check_drag
check_arrows
check_orbit
check_choices
check_yellow
check_pictures
check_recording
check_map
check_opening
check_session
check_mesh
check_time
check_clipping
"$scripted" "${volume[@]}" --measure-drag 100 || fail "the drag could not be measured"
say "PASSED in $SECONDS s"
