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
"$work/environment/bin/python" -m pip --disable-pip-version-check install --quiet "$wheel" 'cvista[rendering]' \
  pyvista==0.49.1 pyvista-render-passes==0.2.0
unset DISPLAY WAYLAND_DISPLAY PYTHONPATH
passed=0
scripts=0
run_scripts() {
  for script in "$@"; do
    echo "== $script"
    scripts=$((scripts + 1))
    # Scripts that lack what they test say so, and end well.
    if (cd "$work" && "$work/environment/bin/python" -B "$here/unit/$script") >"$work/output" 2>&1 &&
      ! grep -q "^there is no" "$work/output"; then
      passed=$((passed + 1))
    else
      echo "FAILED: $script"
    fi
    cat "$work/output"
  done
}
run_scripts package/{wheel_contents,python_vtk,python_stubs,wheel_scene}.py
# PyVista reads some scenes' pictures.
"$work/environment/bin/python" -m pip --disable-pip-version-check install --quiet 'cvista[io]'
run_scripts drop_in/drop_in_pyvista.py with_pyvista/test_{component,chains,render_passes}.py
echo "wheel: $passed of $scripts scripts passed"
[ "$passed" -eq "$scripts" ]
