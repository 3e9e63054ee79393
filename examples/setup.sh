# Installs what the build needs, and builds. Sourced by examples/run.sh and tests/run.sh; it leaves two functions,
# `install_missing` and `build`, and the folder that is built into, `build_folder`.

project_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_folder=$project_folder/build

# What is needed: Debian's package, and how to see that it is there. A library that was installed in another way counts.
needs=(
  "g++                command c++"
  "cmake              command cmake"
  "ninja-build        command ninja"
  "libvtk9-dev        header vtk-9*/vtkVersion.h"
  "python3-vtk9       python vtkmodules"
  "libopenmesh-dev    header OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh"
  "libglm-dev         header glm/glm.hpp"
  "libosmesa6-dev     header GL/osmesa.h"
  "libcli11-dev       header CLI/CLI.hpp"
  "nlohmann-json3-dev header nlohmann/json.hpp"
  "libgtest-dev       header gtest/gtest.h"
  "libbenchmark-dev   header benchmark/benchmark.h"
)

stop() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# The interpreter that has VTK's modules: another python3 may stand first in PATH.
find_python() {
  local candidate
  for candidate in python3 /usr/bin/python3; do
    if "$candidate" -c "import vtkmodules" 2>/dev/null; then
      command -v "$candidate"
      return
    fi
  done
  return 1
}

is_there() { # kind what
  local folder
  case $1 in
    command) command -v "$2" >/dev/null ;;
    python) find_python >/dev/null ;;
    header)
      for folder in /usr/include /usr/local/include ${CMAKE_PREFIX_PATH:+"${CMAKE_PREFIX_PATH%%[:;]*}/include"}; do
        compgen -G "$folder/$2" >/dev/null && return
      done
      return 1
      ;;
  esac
}

list_missing() {
  local need package kind what
  for need in "${needs[@]}"; do
    read -r package kind what <<<"$need"
    is_there "$kind" "$what" || printf '%s ' "$package"
  done
}

# Runs a command with its output in a file; the file's end is shown when the command fails.
quietly() {
  local log=$build_folder/setup.log
  if ! "$@" </dev/null >>"$log" 2>&1; then
    tail -n 30 "$log" >&2
    stop "this failed: $* (all of it: $log)"
  fi
}

install_missing() {
  local missing as_root=()
  read -r -a missing <<<"$(list_missing)"
  [ ${#missing[@]} -gt 0 ] || return 0
  command -v apt-get >/dev/null || stop "missing packages (Debian's names): ${missing[*]}"
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || stop "missing packages, and neither root nor sudo: ${missing[*]}"
    sudo -v || stop "missing packages: ${missing[*]}"
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]} ... (minutes, on a bare machine)"
  mkdir -p "$build_folder"
  : >"$build_folder/setup.log"
  as_root+=(env DEBIAN_FRONTEND=noninteractive)
  quietly "${as_root[@]}" apt-get update
  quietly "${as_root[@]}" apt-get install -y --no-install-recommends "${missing[@]}"
  read -r -a missing <<<"$(list_missing)"
  [ ${#missing[@]} -eq 0 ] || stop "still missing after the installation: ${missing[*]}"
}

# Configures once; from then on the build itself sees what has changed.
build() { # target...
  local log=$build_folder/setup.log
  mkdir -p "$build_folder"
  if [ ! -f "$build_folder/build.ninja" ]; then
    echo "Configuring ..."
    : >"$log"
    quietly cmake -S "$project_folder" -B "$build_folder" -G Ninja -DCMAKE_BUILD_TYPE=Release \
      -DPython3_EXECUTABLE="$(find_python)"
  fi
  echo "Building ..."
  cmake --build "$build_folder" --target "$@"
}
