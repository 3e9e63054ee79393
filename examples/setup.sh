# Installs what the build needs, and builds. Sourced by examples/run.sh and tests/run.sh; it leaves two functions,
# `install_missing` and `build`, and the folder that is built into, `build_folder`.

project_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_folder=$project_folder/build

# What is needed: Debian's package, and how to see that it is there. A library that was installed in another way counts.
# Of alternatives the first is taken that this system has packages of, or has already.
needs=(
  "g++                command c++"
  "cmake              command cmake"
  "ninja-build        command ninja"
  "libvtk9-dev        header vtk-9*/vtkVersion.h"
  "python3-vtk9       python vtkmodules"
  "libopenmesh-dev    header OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh"
  "libglm-dev         header glm/glm.hpp"
  "libosmesa6|libegl1 library libOSMesa.so.|libEGL.so.1"
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

# A package that a list of packages knows.
has_package() { # package
  command -v apt-cache >/dev/null && [ -n "$(apt-cache madison "$1" 2>/dev/null)" ]
}

is_there() { # kind what
  local folder
  case $1 in
    library) PATH=$PATH:/sbin:/usr/sbin ldconfig -p | grep -qF "$2" ;;
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
  local need package kind what packages names i
  for need in "${needs[@]}"; do
    read -r package kind what <<<"$need"
    IFS='|' read -r -a packages <<<"$package"
    IFS='|' read -r -a names <<<"$what"
    for i in "${!packages[@]}"; do
      is_there "$kind" "${names[i]}" && break
      if has_package "${packages[i]}" || [ "$i" -eq $((${#packages[@]} - 1)) ]; then
        printf '%s ' "${packages[i]}"
        break
      fi
    done
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
  read -r -a missing <<<"$(list_missing)" # now that it is known which packages there are
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
