# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Systems to test in, each a Debian in a directory: sourced by the scripts that use them. They call
# choose_suite first. A suite has four directories in $systems:
#   SUITE-bare      what debootstrap makes, and nothing else
#   SUITE           a copy of it in which the library is built, with all packages that this needs
#   SUITE-paraview  a copy of it in which the plugin is built, with ParaView and what that needs
#   SUITE-used      a copy of it in which packages are tried, made anew for each trial

suites="bookworm trixie sid"
keyring=/usr/share/keyrings/debian-archive-keyring.gpg
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
systems=$(realpath -m "${TEMPORAL_COHERENCE_SYSTEMS:-/var/tmp/vtkTemporalCoherence-systems}")
suite=systems

say() { printf '[%s] %s\n' "$suite" "$*"; }
fail() { printf '[%s] FAILED: %s\n' "$suite" "$*" >&2; exit 1; }

choose_suite() # NAME
{
  [[ " $suites " == *" $1 "* ]] || fail "there is no suite '$1'; choose one of $suites"
  suite=$1
  [ "$(id -u)" -eq 0 ] || fail "a system can only be entered by root: run this with sudo"
  command -v apt-get >/dev/null || fail "this is not a Debian machine"
  case $systems/ in
    "$(realpath "$repository")"/*) fail "systems must not be in the repository: $systems" ;;
  esac
  mkdir -p "$systems"
}

# The first of this machine's repositories that has such a label.
# shellcheck disable=SC2016 # expanded by apt
repository_of() # LABEL
{
  apt-get indextargets --format '$(LABEL) $(REPO_URI)' 'Created-By: Packages' |
    sed -n "s/^$1 //p" | head -n 1
}

# A directory is only emptied if a run of these scripts made it.
empty_system() # DIRECTORY
{
  if [ -e "$1" ] && [ ! -e "$1.made" ] && [ -n "$(ls -A "$1")" ]; then
    fail "$1 is not of this script's making; set TEMPORAL_COHERENCE_SYSTEMS to another directory"
  fi
  touch "$1.made"
  rm -rf --one-file-system "${1:?}"
  mkdir -p "$1"
}

ensure_debootstrap()
{
  command -v debootstrap >/dev/null && return
  say "Installing debootstrap"
  apt-get install -y --no-install-recommends debootstrap >/dev/null ||
    fail "there is no debootstrap, and it could not be installed"
}

# sid is what Debian works on: nothing is added to it later.
write_sources() # MIRROR FILE
{
  local security
  printf 'deb %s %s main\n' "$1" "$suite" >"$2"
  [ "$suite" != sid ] || return 0
  printf 'deb %s %s main\n' "$1" "$suite-updates" >>"$2"
  security=$(repository_of Debian-Security)
  [ -z "$security" ] || printf 'deb %s %s main\n' "$security" "$suite-security" >>"$2"
}

make_bare_system()
{
  local mirror bare=$systems/$suite-bare log=$systems/$suite-bare.log
  ensure_debootstrap
  mirror=$(repository_of Debian)
  if [ -z "$mirror" ]; then
    apt-get update >/dev/null || true
    mirror=$(repository_of Debian)
  fi
  [ -n "$mirror" ] || fail "this machine's apt knows no mirror of Debian"
  [ -r "$keyring" ] || fail "there is no $keyring; install debian-archive-keyring"

  empty_system "$bare"
  say "Making a Debian $suite in $bare (log: $log)"
  debootstrap --variant=minbase --keyring="$keyring" "$suite" "$bare" "$mirror" >"$log" 2>&1 ||
    { tail -n 20 "$log" >&2; fail "debootstrap could not make a system; its log is $log"; }
  write_sources "$mirror" "$bare/etc/apt/sources.list"
  # Nothing is started when a package with a daemon is installed.
  printf '#!/bin/sh\nexit 101\n' >"$bare/usr/sbin/policy-rc.d"
  chmod +x "$bare/usr/sbin/policy-rc.d"
  # Nor does it have to survive a loss of power.
  printf 'force-unsafe-io\n' >"$bare/etc/dpkg/dpkg.cfg.d/unsafe-io"
  touch "$bare/.complete"
}

# One that this script has made is fresh enough for all systems that it copies it to.
bare_is_new=no
ensure_bare_system() # FRESH
{
  if [ "$1$bare_is_new" = yesno ] || [ ! -e "$systems/$suite-bare/.complete" ]; then
    make_bare_system
    bare_is_new=yes
  fi
}

copy_bare_system() # DIRECTORY
{
  empty_system "$1"
  cp -a --reflink=auto "$systems/$suite-bare/." "$1"
  touch "$1/.copied"
}

# A system that is kept, to build in.
ensure_system() # FRESH [DIRECTORY]
{
  local system=${2:-$systems/$suite}
  if [ "$1" = no ] && [ -e "$system/.copied" ]; then
    say "Using the system in $system; --fresh makes a new one"
  else
    ensure_bare_system "$1"
    copy_bare_system "$system"
  fi
  copy_network_settings "$system"
}

# A bare system to try packages in. What is installed in it is gone at the next run; only downloads are
# kept.
prepare_used_system() # FRESH
{
  ensure_bare_system "$1"
  copy_bare_system "$systems/$suite-used"
  mkdir -p "$systems/$suite-used.archives/partial"
  copy_network_settings "$systems/$suite-used"
}

# Ways to the network may have changed since the system was made.
copy_network_settings() # DIRECTORY
{
  local file
  for file in /etc/resolv.conf /etc/hosts; do
    [ ! -r "$file" ] || cp --dereference "$file" "$1$file"
  done
  apt-config dump | grep '^Acquire::' >"$1/etc/apt/apt.conf.d/90machine" || true
}

# The repository as it is, with what is not committed, becomes /source. A file that did not change
# keeps its time, so that it is not built again. A changed one is newer than all that was built.
copy_tree() # DIRECTORY
{
  local tree=$1/source copied=$1/source.new file
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

# Runs a command in a system, with the given variables and hardly any others. Mounts are made in a
# namespace that ends with the command, and its processes with it. What apt downloads is kept in a
# directory DIRECTORY.archives, if there is one.
in_system() # DIRECTORY [NAME=VALUE...] COMMAND...
{
  local system=$1 settings=(HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8) name
  shift
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
    if [ -d "$system.archives" ]; then
      mount --bind "$system.archives" "$system/var/cache/apt/archives"
    fi
    exec chroot "$system" env -i "$@"' \
    bash "$system" "${settings[@]}" "$@"
}

# shellcheck disable=SC2016 # expanded by dpkg
vtk_version() # DIRECTORY
{
  chroot "$1" dpkg-query -W -f '${Version}' libvtk9-dev 2>/dev/null || printf 'not installed'
}
