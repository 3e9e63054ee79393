#!/usr/bin/env bash
# Installs what is missing, builds everything, and runs all tests.
#
#   tests/run.sh [OPTION...]    options are ctest's, as in tests/run.sh -L unit
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../examples/setup.sh"

# For windows on a display.
needs+=("xvfb command Xvfb")
install_missing
build all
exec ctest --test-dir "$build_folder" --output-on-failure -j2 "$@"
