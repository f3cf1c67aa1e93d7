#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Inside VTK the module builds and passes its tests.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Build the module as a part of VTK, with only the modules it needs, and run its tests there.

usage: Testing/InsideVTK/run.sh VTK_SOURCE [OPTIONS] [-- CMAKE_ARGUMENTS]

  --compile-only   compile the module and its tests, but neither the rest of VTK nor any library:
                   minutes instead of an hour, and all that tells whether a version's headers fit
  --only PATTERN   run only the tests whose names match
  --fresh          begin with an empty copy and build, even if there are some of an earlier run
  --no-packages    install no packages
  --help           show this text

VTK_SOURCE is VTK's source tree, 9.1.0 or later. It is copied, and nothing is changed in it. Into the
copy goes Module/temporalcoherence.remote.cmake; VTK fetches the module by it, as it fetches any remote
module, but from this tree (with what is not committed) in place of the network. CMAKE_ARGUMENTS are
given to CMake, for example -DCMAKE_CXX_FLAGS_RELEASE=-O1 for a faster build.

The copy and the build are kept, so that a second run takes up what is there. Tests run on an X display
of their own. The exit status is 0 only if all was compiled, tests ran and none failed.

environment:
  TEMPORAL_COHERENCE_INSIDE_VTK  where the copy and the build are (2 GB);
                                 default: /var/tmp/vtkTemporalCoherence-inside-vtk-VERSION
  CMAKE_BUILD_PARALLEL_LEVEL     how many compilers run at once; default: one for each core
TEXT
}

say() { printf '[inside-vtk] %s\n' "$*"; }
fail() { printf '[inside-vtk] FAILED: %s\n' "$*" >&2; exit 1; }

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
repository=$(cd "$here/../.." && pwd)
# shellcheck source-path=SCRIPTDIR source=../Common/Display.sh
. "$repository/Testing/Common/Display.sh"

# What the module needs, what VTK's rendering needs, and libraries that VTK would else compile. The
# latter by the names of their modules in VTK; a version that has no such module does not mind.
packages=(g++ cmake ninja-build git python3 libglm-dev libhwy-dev libgtest-dev xvfb xauth libgl1-mesa-dri
  libgl-dev libx11-dev libxt-dev libxcursor-dev
  libdouble-conversion-dev libeigen3-dev libexpat1-dev libfreetype-dev libglew-dev libhdf5-dev
  libjpeg-dev liblz4-dev liblzma-dev nlohmann-json3-dev libpng-dev libpugixml-dev libtiff-dev zlib1g-dev)
external_modules=(doubleconversion eigen expat freetype glew hdf5 jpeg lz4 lzma nlohmannjson png pugixml
  tiff zlib)
groups=(StandAlone Rendering Imaging MPI Qt Views Web)
test_targets=(vtkTemporalCoherenceCxxTests TemporalCoherenceEngineTests TemporalCoherenceVolumeFilesTests)
remote_file=$repository/Module/temporalcoherence.remote.cmake

logged()
{
  if ! "$@" >>"$log" 2>&1; then
    tail -n 40 "$log" >&2
    fail "$1 ended with an error; all that was said is in $log"
  fi
}

missing_packages()
{
  local package
  for package in "${packages[@]}"; do
    dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' ||
      printf '%s ' "$package"
  done
}

ensure_packages()
{
  local missing apt_get=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600)
  command -v dpkg-query >/dev/null ||
    fail "this is not a Debian system; have these packages installed, then give --no-packages: ${packages[*]}"
  read -ra missing <<<"$(missing_packages)"
  [ "${#missing[@]}" -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "you are not root; have these packages installed: ${missing[*]}"
    apt_get=(sudo "${apt_get[@]}")
  fi
  say "Installing with apt-get, with all that they need: ${missing[*]}"
  "${apt_get[@]}" update >>"$log" 2>&1 || say "apt-get update failed; trying with the lists there are."
  logged "${apt_get[@]}" install -y --no-install-recommends "${missing[@]}"
}

# A number of the version that a source tree says it is.
version_part() # MAJOR|MINOR|BUILD
{
  sed -n "s/^set(VTK_$1_VERSION \([0-9]*\).*/\1/p" "$vtk_source/CMake/vtkVersion.cmake" | head -n 1
}

# A value of a call in the remote file.
remote_value() # GIT_REPOSITORY|GIT_TAG
{
  sed -n "s/^ *$1 \(.*\)$/\1/p" "$remote_file"
}

# What is the same keeps its time, so that it is not built again.
copy_vtk()
{
  mkdir -p "$source"
  find "$vtk_source" -mindepth 1 -maxdepth 1 ! -name .git \
    -exec cp --archive --update --reflink=auto --target-directory="$source" {} +
  [ -d "$module/.git" ] || rm -rf "$module"
  cp "$remote_file" "$source/Remote/"
}

# A repository that holds this tree as it is, under the tag that VTK asks for.
take_snapshot()
{
  local git=(git --git-dir="$snapshot" --work-tree="$repository")
  [ -d "$snapshot" ] || logged git init --quiet --bare "$snapshot"
  logged "${git[@]}" add --all
  logged "${git[@]}" -c user.name=snapshot -c user.email=snapshot@localhost \
    commit --quiet --allow-empty --message "The tree that is tested"
  logged "${git[@]}" tag --force "$(remote_value GIT_TAG)"
}

# Where the module is published, git finds the snapshot instead.
fetch_from_snapshot()
{
  export GIT_CONFIG_COUNT=1
  GIT_CONFIG_KEY_0="url.$snapshot.insteadOf"
  GIT_CONFIG_VALUE_0=$(remote_value GIT_REPOSITORY)
  export GIT_CONFIG_KEY_0 GIT_CONFIG_VALUE_0
  # VTK takes a tag for the same as long as it has the name.
  if [ -d "$module/.git" ]; then
    logged git -C "$module" fetch --quiet --force --tags origin
    logged git -C "$module" checkout --quiet --force "$(remote_value GIT_TAG)"
  fi
}

# The modules that the tests need, by the description of ours.
test_modules()
{
  awk '/^[A-Z]/ { inside = $0 == "TEST_DEPENDS" } inside && /^ / { sub(".*::", ""); print }' \
    "$repository/vtk.module"
}

# Tests are those of modules whose needs are met (DEFAULT): with ON, VTK would build what the tests of
# all other modules need.
configure() # CMAKE_ARGUMENTS
{
  local arguments=(-DVTK_ENABLE_REMOTE_MODULES=ON
    -DVTK_BUILD_ALL_MODULES=OFF -DVTK_BUILD_TESTING=DEFAULT -DVTK_ENABLE_WRAPPING=OFF
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
    -DVTK_MODULE_ENABLE_VTK_TemporalCoherence=YES) name
  for name in "${groups[@]}"; do
    arguments+=("-DVTK_GROUP_ENABLE_$name=DONT_WANT")
  done
  for name in $(test_modules); do
    arguments+=("-DVTK_MODULE_ENABLE_VTK_$name=YES")
  done
  for name in "${external_modules[@]}"; do
    arguments+=("-DVTK_MODULE_USE_EXTERNAL_VTK_$name=ON")
  done
  [ -f "$build/build.ninja" ] || arguments+=(-DCMAKE_BUILD_TYPE=Release)
  say "Configuring VTK $version in $build"
  logged cmake -S "$source" -B "$build" -G Ninja -Wno-dev "${arguments[@]}" "$@"
  [ -d "$module/.git" ] || fail "VTK did not fetch the module by $(basename "$remote_file")"
}

compile_files()
{
  say "Compiling the files of the module and its tests with $jobs jobs (log: $log)"
  logged python3 "$here/compile_files.py" --jobs "$jobs" "$build" Remote/TemporalCoherence
  say "PASSED: the module and its tests compile inside VTK $version: $(tail -n 1 "$log")," \
    "in $((SECONDS - begin)) s"
}

build_tests()
{
  local program
  say "Building the module, its tests and what they need with $jobs jobs (log: $log)"
  logged cmake --build "$build" --parallel "$jobs" --target "${test_targets[@]}"
  # An installed VTK must not be what is tested.
  for program in "$build"/bin/*TemporalCoherence*Tests; do
    if ldd "$program" | grep 'libvtk' | grep -vF " $build/"; then
      fail "$(basename "$program") uses these libraries of another VTK"
    fi
  done
  say "Built in $((SECONDS - begin)) s"
}

run_tests()
{
  local ctest_log=$work/ctest.log status=0 summary
  on_own_display ctest --test-dir "$build/Remote/TemporalCoherence/Testing" --output-on-failure \
    --no-tests=error "$@" 2>&1 | tee "$ctest_log" || status=1
  summary=$(grep -E '^[0-9]+% tests passed' "$ctest_log" | tail -n 1 || true)
  if [ "$status" -ne 0 ] || [ -z "$summary" ]; then
    fail "inside VTK $version: ${summary:-no test ran}; all output is in $ctest_log"
  fi
  say "PASSED: inside VTK $version, $summary, in $((SECONDS - begin)) s"
}

vtk_source=
packages_wanted=yes
compile_only=no
fresh=no
ctest_arguments=()
while [ $# -gt 0 ]; do
  case $1 in
    --compile-only) compile_only=yes ;;
    --only) [ $# -gt 1 ] || fail "--only needs a pattern"; ctest_arguments=(-R "$2"); shift ;;
    --fresh) fresh=yes ;;
    --no-packages) packages_wanted=no ;;
    --help | -h) usage; exit 0 ;;
    --) shift; break ;;
    -*) fail "There is no option $1; --help lists those there are." ;;
    *) [ -z "$vtk_source" ] || fail "one source tree at a time: $vtk_source or $1"; vtk_source=$1 ;;
  esac
  shift
done

[ -n "$vtk_source" ] || fail "say where VTK's source tree is; --help tells more"
[ -f "$vtk_source/CMake/vtkVersion.cmake" ] || fail "$vtk_source is not VTK's source tree"
vtk_source=$(cd "$vtk_source" && pwd)
version=$(version_part MAJOR).$(version_part MINOR).$(version_part BUILD)
work=${TEMPORAL_COHERENCE_INSIDE_VTK:-/var/tmp/vtkTemporalCoherence-inside-vtk-$version}
# What is in a directory is only used, or removed, if a run of this script made it.
[ ! -d "$work" ] || [ -e "$work/.made" ] || [ -z "$(ls -A "$work")" ] ||
  fail "$work is not of this script's making; set TEMPORAL_COHERENCE_INSIDE_VTK to another directory"
mkdir -p "$work" || fail "cannot write in $work; set TEMPORAL_COHERENCE_INSIDE_VTK"
work=$(cd "$work" && pwd)
touch "$work/.made"
source=$work/source
module=$source/Remote/TemporalCoherence
build=$work/build
snapshot=$work/snapshot.git
log=$work/run.log
jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc 2>/dev/null || echo 2)}
begin=$SECONDS
case $work/ in
  "$repository"/* | "$vtk_source"/*) fail "the copy must be neither in this tree nor in VTK's: $work" ;;
esac

: >"$log"
[ "$packages_wanted" = no ] || ensure_packages
if [ "$fresh" = yes ]; then
  rm -rf "$source" "$build" "$snapshot"
fi
copy_vtk
take_snapshot
fetch_from_snapshot
configure "$@"
if [ "$compile_only" = yes ]; then
  compile_files
else
  build_tests
  run_tests "${ctest_arguments[@]}"
fi
