#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What run.sh does inside of the bare system: everything below /test, which run.sh put there.
set -euo pipefail

logs=/test/logs
mkdir -p "$logs" /test/results
unset DISPLAY WAYLAND_DISPLAY
export PYTHONDONTWRITEBYTECODE=1

say() { printf '[wheel] %s\n' "$*"; }
fail() { printf '[wheel] %s\n' "$*" >&2; exit 1; }

# Runs a command that has to succeed, with its output in a log of that name.
logged() # NAME COMMAND...
{
  local log=$logs/$1.log
  shift
  "$@" >"$log" 2>&1 </dev/null || { tail -n 30 "$log" >&2; fail "failed: $*"; }
}

logged update apt-get update
logged install env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
  python3-vtk9 python3-numpy python3-pip python3-pil

# Some packages of VTK do not tell pip that they are there.
options=(--break-system-packages --no-index)
if ! python3 -c 'from importlib.metadata import version; version("vtk")' 2>/dev/null; then
  options+=(--no-deps)
fi
logged pip-install pip install "${options[@]}" /test/wheel/*.whl
say "Installed by pip: $(du -k /test/wheel/*.whl | cut -f 1) kB"

cd /test/results
cat >five_lines.py <<'TEXT'
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkTemporalCoherence import isosurface, render, write_png
source = vtkRTAnalyticSource()
source.Update()
write_png("five_lines.png", render(isosurface(source.GetOutput(), 150.0, color="tan")).color)
TEXT
logged five-lines python3 five_lines.py
logged picture python3 /test/Testing/Packages/check_pictures.py 1 five_lines.png
say "Five lines draw a picture"

directory=$(python3 -c 'import os, vtkTemporalCoherence; print(os.path.dirname(vtkTemporalCoherence.__file__))')
for file in py.typed vtkTemporalCoherence.pyi Documentation/Mapper.md autoload/vtkTemporalCoherenceAutoload.so; do
  [ -e "$directory/$file" ] || fail "there is no $file in $directory"
done
[ "$(find "$directory" -name 'libvtkTemporalCoherence*' | wc -l)" -eq 1 ] || fail "the library is there twice"
logged types python3 -c "
import ast, sys
names = {node.name for node in ast.parse(open(sys.argv[1]).read()).body if isinstance(node, ast.ClassDef)}
assert 'vtkTemporalCoherenceVolumeMapper' in names, names" "$directory/vtkTemporalCoherence.pyi"
logged autoload env VTK_AUTOLOAD_PATH="$directory/autoload" python3 -c '
from vtkmodules.all import vtkGPUVolumeRayCastMapper
name = vtkGPUVolumeRayCastMapper().GetClassName()
assert name == "vtkTemporalCoherenceGPUVolumeRayCastMapper", name'
say "It holds types, and what VTK loads by itself"

# The tests put directories before those of PYTHONPATH; here it has to name none of ours.
for test in Arrays Examples Frames Isosurface Names; do
  logged "Test$test" env PYTHONPATH=/nowhere python3 "/test/Testing/Python/Test$test.py"
  say "Testing/Python/Test$test.py: $(tail -n 1 "$logs/Test$test.log")"
done

logged pip-uninstall pip uninstall --break-system-packages -y vtkTemporalCoherence
left=$(find / -xdev -ipath '*temporalcoherence*' -not -path '/test/*' -not -path '/proc/*')
[ -z "$left" ] || fail "left after uninstalling: $left"
say "Uninstalled without a trace"
