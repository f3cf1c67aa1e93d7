#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The main job from nothing: set up, build, install, build the example, run it.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Show a volume's isosurface: pictures of an orbit and of a sweep of its isovalue, and what each took.

usage: Examples/run.sh [VOLUME [ISOVALUE]] [OPTIONS]
       Examples/run.sh --command [VOLUME [ISOVALUE]] [OPTIONS] [-o PICTURE.png]
       Examples/run.sh [VOLUME [ISOVALUE]] --share FILE.html [OPTIONS]

VOLUME is an image (.vti .vtk .mhd .mha .nii .nii.gz .nrrd .nhdr .slc), a stack of slices (.tif .png),
a grid (.vtu .vts .vtr .vtm .vth .vtk, Exodus .ex2 .exo .e, .cgns, PLOT3D .xyz or xyz.bin), a list of
time steps (.pvd .series), a directory with a DICOM series or with slices, or, with --raw, a file of
bare samples. A volume may be larger than memory: a folder of OME-Zarr, a file of HDF5 (.ims .h5), and
raw samples without compression are read as they are needed. Without VOLUME: a magnetic resonance
image of a head from Debian's package mricron-data, or four generated spheres where that cannot be
had.

What is missing is installed with apt (see Module/setup.sh --help), for --explore VTK's Qt widgets
(package libvtk9-qt-dev), for DICOM GDCM (libgdcm-dev), too. vtkTemporalCoherence is built and
installed into build/install, and Examples/OrbitAndSweep (with --explore: Examples/Explorer) is built
against what is installed there.

  --no-packages          install no packages
  --size WxH | N         pixels of a picture; default 1024
  --frames N             frames of the orbit; default 30
  --output DIR           where the pictures go; default ./pictures
  --threshold            a solid, capped where the volume ends, instead of a surface
  --from AXIS, --up AXIS where the viewer stands and which way is up, for example +y and +z
  --array NAME           which array of a file with several; default: the first one with ISOVALUE in it
  --time-step N          which time step of a file with several; default 1
  --raw NX,NY,NZ,TYPE[,SX,SY,SZ], --big-endian
                         what a file of bare samples holds, for example 256,256,110,uchar,1,1,2
  --large                reads raw samples and stacks of slices as they are needed, whatever their size
  --quick                small pictures, few frames
  --explore              a window to look around in instead of pictures; needs a display
  --command              one picture or film, by Examples/Command, whose options follow; --command
                         --help lists them
  --share FILE.html      a page for browsers, in which the isovalue can be dragged without the volume;
                         by Examples/Command, too
  --help                 show this text; that of build/examples/OrbitAndSweep/OrbitAndSweep and
                         build/examples/Explorer/Explorer tells all options
TEXT
}

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# Not relative: CMake looks for packages below other directories.
TEMPORAL_COHERENCE_BUILD=$(realpath -m "${TEMPORAL_COHERENCE_BUILD:-$repository/build}")
export TEMPORAL_COHERENCE_BUILD
build=$TEMPORAL_COHERENCE_BUILD
head_volume=/usr/share/mricron/templates/ch2.nii.gz
head_isovalue=45 # skin

# Options of the program that a value follows: the value is not the name of a volume.
takes_value()
{
  [[ $1 =~ ^(-o|--(size|frames|output|isovalue|from|up|array|time-step|raw|spheres|session|screenshot))$ ]] ||
    [[ $1 =~ ^--(resolution|channel|memory)$ ]] ||
    [[ $1 =~ ^--(iso|opacity|color|palette|material|light|preset|shift|window|level|draw|azimuth)$ ]] ||
    [[ $1 =~ ^--(elevation|zoom|clip|cut|background|samples|film|rate|share|title|caption)$ ]] ||
    [[ $1 =~ ^--(citation|units|range|tolerance|views|color-by|color-map)$ ]]
}

program=OrbitAndSweep
setup_options=()
arguments=()
volume=
isovalue_given=no
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h)
      if [ "$program" = Command ]; then
        arguments+=("$1")
      else
        usage
        exit 0
      fi
      ;;
    --command) program=Command ;;
    --share) program=Command; arguments+=("$1") ;;
    --no-packages) setup_options+=("$1") ;;
    --explore | --interactive) program=Explorer; setup_options+=(--with-explorer) ;;
    --session) volume=of_session; arguments+=("$1") ;;
    --spheres) volume=generated; arguments+=("$1") ;;
    --isovalue | --iso | --preset | --maximum | --draw) isovalue_given=yes; arguments+=("$1") ;;
    -?*) arguments+=("$1") ;;
    *) [ -n "$volume" ] || volume=$1; arguments+=("$1") ;;
  esac
  if takes_value "$1" && [ $# -gt 1 ]; then
    arguments+=("$2")
    shift
  fi
  shift
done
if [ -z "$volume" ]; then
  setup_options+=(--with-example-data)
elif [[ $volume != generated && $volume != of_session && ! -e $volume ]]; then
  printf "[example] There is no file '%s'; check the path.\n" "$volume" >&2
  exit 1
fi

is_zarr()
{
  [ -e "$1/.zattrs" ] || [ -e "$1/.zgroup" ] || [ -e "$1/.zarray" ] || [ -e "$1/zarr.json" ]
}
[ ! -d "$volume" ] || is_zarr "$volume" || setup_options+=(--with-dicom)

"$repository/Module/setup.sh" "${setup_options[@]}"

# With its output in a file, whose end is shown if the command fails.
logged()
{
  if ! "$@" >>"$build/example.log" 2>&1; then
    tail -n 40 "$build/example.log" >&2
    printf '[example] Failed: %s; all that was said is in %s\n' "$1 $2" "$build/example.log" >&2
    exit 1
  fi
}

: >"$build/example.log"
directory=$build/examples/$program
binary=$directory/$program
[ "$program" != Command ] || binary=$directory/temporal-coherence
printf '[example] Installing into %s and building %s against it\n' "$build/install" "$program"
logged cmake --install "$build" --prefix "$build/install"
logged cmake -S "$repository/Examples/$program" -B "$directory" -G Ninja \
  -DCMAKE_PREFIX_PATH="$build/install" -DCMAKE_BUILD_TYPE=Release
logged cmake --build "$directory" --parallel

if [ -z "$volume" ]; then
  [ "$isovalue_given" = yes ] || arguments+=(--isovalue)
  if [ -r "$head_volume" ]; then
    arguments=("$head_volume" "${arguments[@]}")
    [ "$isovalue_given" = yes ] || arguments+=("$head_isovalue")
  else
    printf '[example] %s is not there (Debian package mricron-data): four generated spheres instead\n' \
      "$head_volume"
    [ "$isovalue_given" = yes ] || arguments+=(100)
  fi
fi
exec "$binary" "${arguments[@]}"
