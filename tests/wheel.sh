#!/usr/bin/env bash
# Tests a wheel in an empty environment, beside PyVista and without a display:  tests/wheel.sh WHEEL
#
# plugin/python/wheel/build.sh makes the wheel. Needs the Python that it is for: PYTHON, or one in PATH.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
wheel="$(realpath "${1:?usage: wheel.sh WHEEL}")"
source "$here/../plugin/python/wheel/find_python.sh"

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
"$python" -m venv "$work/environment"
"$work/environment/bin/python" -m pip --disable-pip-version-check install --quiet "$wheel" pyvista==0.49.1 'cvista[rendering]'
unset DISPLAY WAYLAND_DISPLAY PYTHONPATH
for each in wheel_contents python_vtk python_stubs wheel_scene; do
  echo "== $each"
  (cd "$work" && "$work/environment/bin/python" -B "$here/unit/package/$each.py")
done
