#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes Gallery.md again: all pictures, plots and tables.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Make all pictures, plots and tables of Documentation/Gallery.md again, from nothing: set up, build,
draw every route and feature and the paper's figures (Testing/Benchmarks/run.sh), run VTK's examples
before and after the drop-in (Testing/DropIn/run.sh), and put it all into the page.

usage: Documentation/gallery.sh [--quick | --view] [--output FOLDER] [--no-packages] [--built]

  --quick          small pictures of generated volumes and few frames, to see that all works
  --view           only the page that can be dragged, and its picture
  --output FOLDER  make a copy of the page and its folder Pictures there; default: Documentation
                   itself, with --quick the folder gallery-quick in the build directory
  --no-packages    install and download no packages (see Module/setup.sh --help)
  --built          build nothing: the build directory is up to date
  --help           show this text

Volumes are looked for in the folder that TEMPORAL_COHERENCE_DATA names (Documentation/Gallery.md
lists them); for those that are not there heads of Debian's package mricron-data or generated volumes
are shown, and the page says so. Nothing else should run meanwhile: times are measured. It takes
less than ten minutes once all is built. Without DISPLAY it draws on a display of its own.
TEXT
}

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
repository=$(cd "$here/.." && pwd)
export TEMPORAL_COHERENCE_BUILD=${TEMPORAL_COHERENCE_BUILD:-$repository/build}
build=$TEMPORAL_COHERENCE_BUILD
output=
quick=()
options=(--built)
setup_options=(--with-tests --with-example-data)
built=no
only_view=no

say() { printf '[gallery] %s\n' "$*"; }
fail() { printf '[gallery] FAILED: %s\n' "$*" >&2; exit 1; }

while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --quick) quick=("$1") ;;
    --view) only_view=yes ;;
    --no-packages) options+=("$1"); setup_options+=("$1") ;;
    --built) built=yes ;;
    --output)
      [ $# -gt 1 ] || fail "--output needs a folder behind it."
      output=$2
      shift ;;
    *) fail "There is no option $1; --help lists those there are." ;;
  esac
  shift
done
work=$build/gallery${quick:+-quick}
output=${output:-$([ -n "${quick[*]}" ] && printf %s "$work/page" || printf %s "$here")}

# What all times depend on.
describe_machine()
{
  local processor system vtk windows
  processor=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo 2>/dev/null | head -n 1)
  system=$(sed -n 's/^PRETTY_NAME="\(.*\)"/\1/p' /etc/os-release 2>/dev/null)
  vtk=$(sed -n 's/.*VTK_VERSION "\(.*\)"/\1/p' "$(find /usr/include /usr/local/include -name \
    vtkVersionMacros.h 2>/dev/null | head -n 1)" 2>/dev/null)
  windows=$(sed -n 's/.*"windowsBy": "\(.*\)".*/\1/p' "$work/gallery.json")
  printf '<!-- made: machine -->\n\n%s, %s threads; %s; VTK %s; windows are drawn by %s.\n\n<!-- end -->\n' \
    "${processor:-a processor that does not tell its name}" "$(nproc 2>/dev/null || echo ?)" \
    "${system:-$(uname -s)}" "${vtk:-?}" "${windows:-OpenGL}"
}

# Replace each part of the page that has been made by what was made. Parts that were not stay.
fill_page() # PARTS... <PAGE
{
  awk '
    FILENAME != "-" && /^<!-- made: / { name = $3; made[name] = ""; next }
    FILENAME != "-" && /^<!-- end -->/ { name = ""; next }
    FILENAME != "-" { if (name != "") made[name] = made[name] $0 "\n"; next }
    /^<!-- made: / { print; if ($3 in made) { printf "%s", made[$3]; skipping = 1 }; next }
    /^<!-- end -->/ { skipping = 0 }
    !skipping
  ' "$@" -
}

# Every picture that the page shows has to be there.
check_page()
{
  local picture
  pictures=0
  while read -r picture; do
    [ -s "$output/$picture" ] || fail "The page shows $picture, which was not made."
    pictures=$((pictures + 1))
  done < <(grep -o 'Pictures/[A-Za-z0-9.-]*\.png' "$output/Gallery.md" | sort -u)
}

# The page that can be dragged, and its picture. It lies in the repository, and has to be small.
share_view()
{
  local volume=/usr/share/mricron/templates/ch2.nii.gz page=$output/Pictures/view.html
  local picture=$output/Pictures/gallery-view.png most=500000 status=0
  if [ -n "${quick[*]}" ] || [ ! -r "$volume" ]; then
    say "The page that can be dragged is left as it is."
    [ "$output" = "$here" ] || cp "$here/Pictures/view.html" "$here/Pictures/gallery-view.png" "$output/Pictures"
    return
  fi
  "$repository/Examples/run.sh" --no-packages "$volume" 50 --from +y --azimuth 25 --elevation 5 \
    --background white --size 192 --range 30,100 --tolerance 1 --share "$page" --title "A head in MR" \
    --caption "Drag in the bars below the picture: skin, then bone and brain, at every value from 30 to 100." \
    --citation "Holmes et al. 1998 (Colin 27), as in Debian's package mricron-data"
  [ "$(stat -c %s "$page")" -le "$most" ] || fail "$page has more than $most bytes; ask for a smaller size or range."
  "$here/page_picture.py" "$page" "$picture" || status=$?
  case $status in
    0) ;;
    77) say "The picture of the page that can be dragged is left as it is." ;;
    *) fail "There is no picture of $page, as told above." ;;
  esac
}

[ "$built" = yes ] || "$repository/Module/setup.sh" "${setup_options[@]}"
mkdir -p "$work" "$output/Pictures" 2>/dev/null ||
  fail "Cannot make folders in $output; name one that can be written in with --output."
output=$(cd "$output" && pwd)
begin=$SECONDS
if [ "$only_view" = yes ]; then
  share_view
  say "PASSED: $output/Pictures/view.html, in $((SECONDS - begin)) s"
  exit 0
fi

"$repository/Testing/Benchmarks/run.sh" --only figures,pictures "${options[@]}" "${quick[@]}" --output "$work"
[ -s "$work/pictures.md" ] || fail "This VTK has no charts, without which there is no gallery."
describe_machine >"$work/machine.md"
parts=("$work/machine.md" "$work/figures.md" "$work/pictures.md")

# Nothing is downloaded for a quick look.
status=0
"$repository/Testing/DropIn/run.sh" "${options[@]}" "${quick[@]}" ${quick:+--no-packages} \
  --output "$work" || status=$?
case $status in
  0) parts+=("$work/dropin.md") ;;
  2) say "The drop-in is left out; the page keeps what it says of it." ;;
  *) fail "The drop-in has failed, as told above." ;;
esac

# Parts that are kept need their pictures.
if [ "$output" != "$here" ]; then
  find "$here/Pictures" -name 'gallery-*.png' -exec cp {} "$output/Pictures" \;
fi
cp "$work"/gallery-*.png "$output/Pictures"
for figure in 5 6 7 8 9; do
  name=$work/figure$figure.png
  [ "$figure" != 6 ] || name=$work/figure6-paper.png
  cp "$name" "$output/Pictures/gallery-figure$figure.png"
done
share_view
fill_page "${parts[@]}" <"$here/Gallery.md" >"$work/Gallery.md"
cp "$work/Gallery.md" "$output/Gallery.md"
check_page
say "PASSED: $output/Gallery.md with $pictures pictures, in $((SECONDS - begin)) s"
