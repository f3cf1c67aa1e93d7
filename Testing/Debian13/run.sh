#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build and run the tests on Debian 13, whose VTK is 9.3, whatever Debian this machine has.
set -euo pipefail

usage()
{
  cat <<'TEXT'
Build vtkTemporalCoherence and run its tests in a Debian 13 (trixie) of its own, with VTK 9.3.

usage: Testing/Debian13/run.sh [--fresh] [CTEST_ARGUMENTS]

  --fresh          begin with an empty system, even if there is one of an earlier run
  --help           show this text

Run it as root, on a Debian machine of any version. The system is made with debootstrap from the
mirror that this machine's apt uses; it and the build are kept, so that a second run takes up what
is there. The tree is copied as it is, with what is not committed. CTEST_ARGUMENTS go to ctest, for
example -R Mapper. The exit status is 0 only if tests ran and none failed.

environment:
  TEMPORAL_COHERENCE_DEBIAN13     where the system is kept (about 4 GB);
                                  default: /var/tmp/vtkTemporalCoherence-debian13
  TEMPORAL_COHERENCE_CMAKE_FLAGS  further arguments for CMake, separated by spaces
TEXT
}

suite=trixie
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
system=${TEMPORAL_COHERENCE_DEBIAN13:-/var/tmp/vtkTemporalCoherence-debian13}
keyring=/usr/share/keyrings/debian-archive-keyring.gpg

say() { printf '[debian13] %s\n' "$*"; }
fail() { printf '[debian13] FAILED: %s\n' "$*" >&2; exit 1; }

# The first of this machine's repositories that has such a label.
# shellcheck disable=SC2016 # expanded by apt
repository_of() # LABEL
{
  apt-get indextargets --format '$(LABEL) $(REPO_URI)' 'Created-By: Packages' |
    sed -n "s/^$1 //p" | head -n 1
}

# A directory is only emptied if a run of this script made it.
empty_system()
{
  if [ -e "$system" ] && [ ! -e "$system.made" ] && [ -n "$(ls -A "$system")" ]; then
    fail "$system is not of this script's making; set TEMPORAL_COHERENCE_DEBIAN13 to another directory"
  fi
  mkdir -p "$system"
  touch "$system.made"
  rm -rf --one-file-system "${system:?}"
  mkdir -p "$system"
}

make_system()
{
  local mirror security log=$system.log
  if ! command -v debootstrap >/dev/null; then
    say "Installing debootstrap"
    apt-get install -y --no-install-recommends debootstrap >/dev/null ||
      fail "there is no debootstrap, and it could not be installed"
  fi
  mirror=$(repository_of Debian)
  if [ -z "$mirror" ]; then
    apt-get update >/dev/null || true
    mirror=$(repository_of Debian)
  fi
  [ -n "$mirror" ] || fail "this machine's apt knows no mirror of Debian"
  [ -r "$keyring" ] || fail "there is no $keyring; install debian-archive-keyring"
  security=$(repository_of Debian-Security)

  empty_system
  say "Making a Debian 13 in $system (log: $log)"
  debootstrap --variant=minbase --keyring="$keyring" "$suite" "$system" "$mirror" >"$log" 2>&1 ||
    { tail -n 20 "$log" >&2; fail "debootstrap could not make a system; its log is $log"; }
  {
    printf 'deb %s %s main\n' "$mirror" "$suite" "$mirror" "$suite-updates"
    [ -z "$security" ] || printf 'deb %s %s main\n' "$security" "$suite-security"
  } >"$system/etc/apt/sources.list"
  # Nothing is started when a package with a daemon is installed.
  printf '#!/bin/sh\nexit 101\n' >"$system/usr/sbin/policy-rc.d"
  chmod +x "$system/usr/sbin/policy-rc.d"
  touch "$system/.complete"
}

# Ways to the network may have changed since the system was made.
copy_network_settings()
{
  local file
  for file in /etc/resolv.conf /etc/hosts; do
    [ ! -r "$file" ] || cp --dereference "$file" "$system$file"
  done
  apt-config dump | grep '^Acquire::' >"$system/etc/apt/apt.conf.d/90machine" || true
}

# What is the same keeps its time, so that it is not built again; what changed is newer than all that
# was built, even if it was written while that was going on.
copy_tree()
{
  local tree=$system/source copied=$system/source.new file
  rm -rf "$copied"
  mkdir -p "$tree" "$copied"
  tar -C "$repository" --exclude=./.git --exclude='./build*' --exclude=./install \
    --exclude=./pictures -cf - . | tar -C "$copied" --no-same-owner --touch -xf -
  while IFS= read -r -d '' file; do
    if cmp --silent "$tree/$file" "$copied/$file"; then
      touch --reference="$tree/$file" "$copied/$file"
    fi
  done < <(cd "$copied" && find . -type f -print0)
  rm -rf "$tree"
  mv "$copied" "$tree"
}

# Mounts are made in a namespace that ends with the tests, and their processes with it.
run_tests() # CTEST_ARGUMENTS
{
  local settings=(HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8
    TEMPORAL_COHERENCE_BUILD=/build
    TEMPORAL_COHERENCE_CMAKE_FLAGS="${TEMPORAL_COHERENCE_CMAKE_FLAGS:-}") name
  for name in http_proxy https_proxy no_proxy; do
    [ -z "${!name:-}" ] || settings+=("$name=${!name}")
  done
  # shellcheck disable=SC2016 # expanded by the inner shell
  unshare --mount --propagation private --pid --fork --kill-child bash -c '
    set -e
    system=$1
    shift
    mount -t proc proc "$system/proc"
    mount --rbind /sys "$system/sys"
    mount --rbind /dev "$system/dev"
    mount -t tmpfs tmpfs "$system/dev/shm"
    exec chroot "$system" env -i "$@"' \
    bash "$system" "${settings[@]}" /source/Testing/run.sh "$@"
}

fresh=no
ctest_arguments=()
for argument in "$@"; do
  case $argument in
    --help | -h) usage; exit 0 ;;
    --fresh) fresh=yes ;;
    *) ctest_arguments+=("$argument") ;;
  esac
done

[ "$(id -u)" -eq 0 ] || fail "a system can only be entered by root: run this with sudo"
command -v apt-get >/dev/null || fail "this is not a Debian machine"
case $(realpath -m "$system")/ in
  "$(realpath "$repository")"/*) fail "the system must not be in the repository: $system" ;;
esac

if [ "$fresh" = yes ] || [ ! -e "$system/.complete" ]; then
  make_system
else
  say "Using the Debian 13 in $system; --fresh makes a new one"
fi
copy_network_settings
copy_tree
status=0
run_tests "${ctest_arguments[@]}" || status=$?

# shellcheck disable=SC2016 # expanded by dpkg
version=$(chroot "$system" dpkg-query -W -f '${Version}' libvtk9-dev 2>/dev/null || true)
[ "$status" -eq 0 ] || fail "on Debian 13, VTK ${version:-not installed}; logs are in $system/build"
say "PASSED: on Debian 13, VTK $version"
