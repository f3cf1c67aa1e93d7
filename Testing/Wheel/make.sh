#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What run.sh does in the system that the library is built in: from /source to /wheel. Ends with 3
# where there is no scikit-build-core.
set -euo pipefail

mkdir -p /wheel
log=/wheel/make.log

say() { printf '[wheel] %s\n' "$*"; }
logged() { "$@" >>"$log" 2>&1 </dev/null || { tail -n 30 "$log" >&2; exit 1; }; }

TEMPORAL_COHERENCE_BUILD=/build-wheel/setup /source/Module/setup.sh --packages-only
apt-cache show python3-scikit-build-core >/dev/null 2>&1 || exit 3
logged env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
  python3-scikit-build-core python3-pip

# For the VTK that is there, which pip did not bring.
# shellcheck disable=SC2016 # expanded by dpkg
vtk=$(dpkg-query -W -f '${Version}' libvtk9-dev | grep -o '^[0-9.]*')
sed -i "s/\(vtk\(-sdk\)\?\) == [0-9.]*/\1 == $vtk/g" /source/pyproject.toml
begin=$SECONDS
logged pip wheel /source --no-build-isolation --no-deps --wheel-dir /wheel -C build-dir=/build-wheel/build
say "Made in $((SECONDS - begin)) s, for VTK $vtk: $(cd /wheel && du -k -- *.whl | tr '\t' ' ')"
