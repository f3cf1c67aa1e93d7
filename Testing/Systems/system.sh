# shellcheck shell=bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# A Debian of its own to test in: sourced by the scripts that do. They set
#   system_label     what messages begin with, for example debian13
#   system_name      what people call it, for example Debian 13
#   suite            its name in Debian's repositories, for example trixie
#   system           the directory that it is kept in
#   system_variable  the environment variable by which that directory is chosen

keyring=/usr/share/keyrings/debian-archive-keyring.gpg
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# shellcheck disable=SC2154 # set by the script that sources this
say() { printf '[%s] %s\n' "$system_label" "$*"; }
fail() { printf '[%s] FAILED: %s\n' "$system_label" "$*" >&2; exit 1; }

require_root_on_debian()
{
  [ "$(id -u)" -eq 0 ] || fail "a system can only be entered by root: run this with sudo"
  command -v apt-get >/dev/null || fail "this is not a Debian machine"
  case $(realpath -m "$system")/ in
    "$(realpath "$repository")"/*) fail "the system must not be in the repository: $system" ;;
  esac
}

# The first of this machine's repositories that has such a label.
# shellcheck disable=SC2016 # expanded by apt
repository_of() # LABEL
{
  apt-get indextargets --format '$(LABEL) $(REPO_URI)' 'Created-By: Packages' |
    sed -n "s/^$1 //p" | head -n 1
}

# A directory is only emptied if a run of these scripts made it.
empty_system()
{
  if [ -e "$system" ] && [ ! -e "$system.made" ] && [ -n "$(ls -A "$system")" ]; then
    # shellcheck disable=SC2154
    fail "$system is not of this script's making; set $system_variable to another directory"
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
  # shellcheck disable=SC2154
  say "Making a $system_name in $system (log: $log)"
  # shellcheck disable=SC2154
  debootstrap --variant=minbase --keyring="$keyring" "$suite" "$system" "$mirror" >"$log" 2>&1 ||
    { tail -n 20 "$log" >&2; fail "debootstrap could not make a system; its log is $log"; }
  {
    printf 'deb %s %s main\n' "$mirror" "$suite" "$mirror" "$suite-updates"
    [ -z "$security" ] || printf 'deb %s %s main\n' "$security" "$suite-security"
  } >"$system/etc/apt/sources.list"
  # Nothing is started when a package with a daemon is installed.
  printf '#!/bin/sh\nexit 101\n' >"$system/usr/sbin/policy-rc.d"
  chmod +x "$system/usr/sbin/policy-rc.d"
  # Nor does it have to survive a loss of power.
  printf 'force-unsafe-io\n' >"$system/etc/dpkg/dpkg.cfg.d/unsafe-io"
  touch "$system/.complete"
}

ensure_system() # FRESH
{
  if [ "$1" = yes ] || [ ! -e "$system/.complete" ]; then
    make_system
  else
    say "Using the $system_name in $system; --fresh makes a new one"
  fi
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

# Runs a command in the system, with the given variables and hardly any others. Mounts are made in a
# namespace that ends with the command, and its processes with it. What apt downloads is kept in
# a directory SYSTEM.archives, if there is one.
in_system() # [NAME=VALUE...] COMMAND...
{
  local settings=(HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8) name
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
