#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# From a fresh Debian machine to a built library: see usage() below.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Install what is missing and build vtkTemporalCoherence in Release mode.

usage: Module/setup.sh [OPTIONS] [-- CMAKE_ARGUMENTS]

  --with-tests         build the tests too, and install what they need
  --with-packaging     install what Module/package.sh needs
  --with-explorer      install what Examples/Explorer needs: VTK's Qt widgets; so do the tests
  --with-dicom         install what the examples read DICOM with (GDCM), going without is no error; so do
                       the tests and --with-explorer
  --with-example-data  install the MR head that Examples/run.sh shows; going without is no error
  --packages-only      install packages, build nothing
  --no-packages        build with what is there, install nothing
  --help               show this text

CMAKE_ARGUMENTS, for example -DVTK_DIR=..., are given to CMake when the build is configured.

environment:
  TEMPORAL_COHERENCE_BUILD        the build directory; default: build, in the repository
  TEMPORAL_COHERENCE_CMAKE_FLAGS  further arguments for CMake, separated by spaces

Packages are looked for and installed with Debian's apt, as root or through sudo, and only
where some are missing. A build directory that is there already keeps its settings.
TEXT
}

build_packages=(g++ cmake ninja-build libvtk9-dev libglm-dev libhwy-dev
  libpython3-dev python3-vtk9 python3-numpy
  libblosc-dev libzstd-dev zlib1g-dev nlohmann-json3-dev libhdf5-dev)
test_packages=(libbenchmark-dev libgtest-dev xvfb xauth libgl1-mesa-dri python3-pil xdotool)
packaging_packages=(dpkg-dev file)
explorer_packages=(libvtk9-qt-dev) # with the Qt that this VTK was built with
dicom_packages=(libgdcm-dev)
example_packages=(mricron-data)
client_packages=(python3-pyvista python3-imageio) # not in every Debian; a test of theirs is skipped then

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${TEMPORAL_COHERENCE_BUILD:-$repository/build}
log=$build/setup.log

say() { printf '[set-up] %s\n' "$*"; }
fail() { printf '[set-up] %s\n' "$*" >&2; exit 1; }

# Names those of its arguments that Debian does not have installed.
missing_packages()
{
  local package
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' ||
      printf '%s ' "$package"
  done
}

# Names those of its arguments that this Debian has.
known_packages()
{
  local package
  for package in "$@"; do
    if apt-cache show "$package" >/dev/null 2>&1; then
      printf '%s ' "$package"
    fi
  done
}

logged() { "$@" >>"$log" 2>&1; }

fail_with_log()
{
  tail -n 40 "$log" >&2
  fail "$*; all that was said is in $log"
}

# Says in one sentence why packages cannot be installed here; silent where they can.
why_no_install()
{
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    printf 'This is not a Debian system'
  elif [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    printf 'You are not root and there is no sudo'
  fi
}

install_packages() # NAMES...
{
  local apt_get=(env DEBIAN_FRONTEND=noninteractive apt-get)
  if [ "$(id -u)" -ne 0 ]; then
    apt_get=(sudo "${apt_get[@]}")
  fi
  say "Installing with apt-get, with all that they need: $*"
  # Lists that cannot be brought up to date may still hold the packages.
  logged "${apt_get[@]}" update || say "apt-get update failed; trying with the lists there are."
  logged "${apt_get[@]}" install -y --no-install-recommends "$@"
}

ensure_packages()
{
  local needed=("${build_packages[@]}") missing known why
  if [ "$with_tests" = yes ]; then
    needed+=("${test_packages[@]}")
  fi
  # One of the tests makes packages.
  if [ "$with_tests" = yes ] || [ "$with_packaging" = yes ]; then
    needed+=("${packaging_packages[@]}")
  fi
  if [ "$with_tests" = yes ] || [ "$with_explorer" = yes ]; then
    needed+=("${explorer_packages[@]}")
  fi
  why=$(why_no_install)
  if ! command -v dpkg-query >/dev/null; then
    fail "$why: install a C++17 compiler, CMake 3.16 or later, Ninja, VTK 9.1 or later with its" \
      "headers, GLM and Highway (for Python also its headers, VTK's modules and NumPy, for tests" \
      "GoogleTest, Google Benchmark, Xvfb and xdotool, for the Explorer VTK's module GUISupportQt, for" \
      "DICOM GDCM)," \
      "then give --no-packages."
  fi

  read -ra missing <<<"$(missing_packages "${needed[@]}")"
  if [ "${#missing[@]}" -gt 0 ]; then
    [ -z "$why" ] || fail "$why: have these packages installed: ${missing[*]}"
    install_packages "${missing[@]}" || fail_with_log "Could not install ${missing[*]}"
  fi

  if [ "$with_tests$with_explorer$with_dicom" != nonono ]; then
    install_if_possible "$why" "${dicom_packages[@]}"
  fi
  if [ "$with_example_data" = yes ]; then
    install_if_possible "$why" "${example_packages[@]}"
  fi
  if [ "$with_tests" = yes ] && command -v apt-cache >/dev/null; then
    read -ra known <<<"$(known_packages "${client_packages[@]}")"
    install_if_possible "$why" "${known[@]}"
  fi
}

# Going without these is no error.
install_if_possible() # WHY_NO_INSTALL PACKAGES...
{
  local why=$1 missing
  read -ra missing <<<"$(missing_packages "${@:2}")"
  [ "${#missing[@]}" -gt 0 ] || return 0
  if [ -n "$why" ] || ! install_packages "${missing[@]}"; then
    say "Going on without ${missing[*]}${why:+ ($why)}."
  fi
}

# The arguments a build directory was configured with are kept in it, to configure again only
# when other ones are asked for.
configure()
{
  local wanted=() record=$build/setup.arguments testing=OFF
  if [ "$with_tests" = yes ]; then
    testing=ON
  fi
  if [ "$with_tests" = yes ] || [ ! -f "$build/build.ninja" ]; then
    wanted+=("-DBUILD_TESTING=$testing" "-DTEMPORAL_COHERENCE_BUILD_BENCHMARKS=$testing")
  fi
  # shellcheck disable=SC2206 # the flags are to be split at spaces
  wanted+=(${TEMPORAL_COHERENCE_CMAKE_FLAGS:-} "$@")

  if [ ! -f "$build/build.ninja" ]; then
    wanted=(-G Ninja -DCMAKE_BUILD_TYPE=Release "${wanted[@]}")
  elif [ "${#wanted[@]}" -eq 0 ] || [ "${wanted[*]}" = "$(cat "$record" 2>/dev/null)" ]; then
    return 0
  fi
  say "Configuring in $build"
  logged cmake -S "$repository" -B "$build" "${wanted[@]}" || fail_with_log "CMake could not configure"
  printf '%s\n' "${wanted[*]}" | sed 's/^-G Ninja -DCMAKE_BUILD_TYPE=Release //' >"$record"
}

build_library()
{
  say "Building with $(nproc 2>/dev/null || echo 2) jobs (log: $log)"
  local begin=$SECONDS
  logged cmake --build "$build" --parallel || fail_with_log "The build failed"
  say "Built in $((SECONDS - begin)) s: $build"
}

with_tests=no
with_packaging=no
with_explorer=no
with_dicom=no
with_example_data=no
packages=yes
building=yes
while [ $# -gt 0 ]; do
  case $1 in
    --with-tests) with_tests=yes ;;
    --with-packaging) with_packaging=yes ;;
    --with-explorer) with_explorer=yes ;;
    --with-dicom) with_dicom=yes ;;
    --with-example-data) with_example_data=yes ;;
    --packages-only) building=no ;;
    --no-packages) packages=no ;;
    --help | -h) usage; exit 0 ;;
    --) shift; break ;;
    *) fail "There is no option $1; --help lists those there are." ;;
  esac
  shift
done

if ! mkdir -p "$build" 2>/dev/null || ! : 2>/dev/null >"$log"; then
  fail "Cannot write in $build; set TEMPORAL_COHERENCE_BUILD to a directory that you may write in."
fi
[ "$packages" = no ] || ensure_packages
if [ "$building" = yes ]; then
  configure "$@"
  build_library
fi
