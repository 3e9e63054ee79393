#!/usr/bin/env bash
# Builds and tests the project on other systems, each in a folder of its own: on Debians, each in a root folder, as a
# new user would, with the README's two commands; and with the newest VTK that PyPI has with its headers (cvista).
#
#   tests/matrix.sh [12|13|testing|pip]...  which; default: all four
#   tests/matrix.sh --only REGEX 13         those tests only, as ctest -R
#
# The folders stay for the next run, with their packages, where VTKSHADOW_ROOTS names (default
# ~/.cache/vtkshadow-roots; some 5 GB each). DEBIAN_MIRROR is where packages come from; default: debootstrap's own.
# Debians need root and debootstrap; pip a Python from 3.12 on (PYTHON, or one in PATH), and of this system g++, Mesa and
# the packages that examples/setup.sh names for all but VTK. Each takes some 15 minutes on two cores, and a few more the
# first time.
set -euo pipefail

project_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
roots=$(realpath -m "${VTKSHADOW_ROOTS:-$HOME/.cache/vtkshadow-roots}")
only=()
systems=()

stop() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

while [ $# -gt 0 ]; do
  case $1 in
    12 | 13 | testing | pip) systems+=("$1") ;;
    --only)
      [ $# -gt 1 ] || stop "--only needs a regular expression"
      only=(-R "$2")
      shift
      ;;
    *) stop "$1: not one of 12, 13, testing, pip, --only REGEX" ;;
  esac
  shift
done
[ ${#systems[@]} -gt 0 ] || systems=(12 13 testing pip)
if [ "${systems[*]}" != pip ]; then
  [ "$(id -u)" -eq 0 ] || stop "needs root, to make a root folder and change into it"
  command -v debootstrap >/dev/null || stop "needs debootstrap (Debian: apt-get install debootstrap)"
fi

suite_of() {
  case $1 in
    12) echo bookworm ;;
    13) echo trixie ;;
    testing) echo testing ;;
  esac
}

make_root() { # system root
  [ ! -e "$2/made" ] || return 0
  rm -rf "$2"
  mkdir -p "$2"
  debootstrap --variant=minbase "$(suite_of "$1")" "$2" ${DEBIAN_MIRROR:+"$DEBIAN_MIRROR"}
  # A mirror may lag behind what the release file of testing says of its age.
  echo 'Acquire::Check-Valid-Until "false";' >"$2/etc/apt/apt.conf.d/90matrix"
  touch "$2/made"
}

mounted=()
unmount_all() {
  local folder
  for folder in "${mounted[@]}"; do
    umount "$folder" || true
  done
  mounted=()
}
trap unmount_all EXIT

enter() { # root
  local folder
  for folder in proc sys dev; do
    mount --bind "/$folder" "$1/$folder"
    mounted=("$1/$folder" "${mounted[@]}")
  done
  [ ! -e /etc/resolv.conf ] || cp /etc/resolv.conf "$1/etc/resolv.conf"
}

# What the repository holds, with changes that are not committed yet; build folders of the run before stay. Only what
# differs is written, so that it is newer than what was built of it.
copy_project() { # root
  local target=$1/vtkshadow/project file
  mkdir -p "$target"
  (cd "$project_folder" && git ls-files -z --cached --others --exclude-standard) >"$target/.files"
  while IFS= read -r -d '' file; do
    if [ -f "$project_folder/$file" ] && ! cmp -s "$project_folder/$file" "$target/$file"; then
      mkdir -p "$(dirname "$target/$file")"
      cp --preserve=mode "$project_folder/$file" "$target/$file"
    fi
  done <"$target/.files"
  # What the repository holds no more.
  (cd "$target" && find . -path ./build -prune -o -type f -printf '%P\0' | LC_ALL=C sort -z |
    LC_ALL=C comm -z -23 - <({ printf ".files\0"; cat .files; } | LC_ALL=C sort -z) | xargs -0 -r rm -f)
  if [ -d "$project_folder/../shared/models" ]; then
    mkdir -p "$1/vtkshadow/shared"
    cp -ru "$project_folder/../shared/models" "$1/vtkshadow/shared/"
  fi
}

run_in() { # root command...
  local root=$1
  shift
  chroot "$root" env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    bash -c 'cd /vtkshadow/project && "$@"' bash "$@"
}

# This and test_pip leave in `result` what failed, and nothing where all passed.
test_debian() { # system root
  run_in "$2" examples/run.sh || { result="examples/run.sh failed"; return; }
  run_in "$2" tests/run.sh "${only[@]}" || result="tests failed"
}

# A subshell, as find_python.sh ends it where there is no Python.
make_environment() ( # system root
  version=$(sed -n 's/.*"cvista-sdk==\([^"]*\)".*/\1/p' "$project_folder/pyproject.toml")
  source "$project_folder/plugin/python/wheel/find_python.sh"
  [ -x "$2/environment/bin/python" ] || "$python" -m venv "$2/environment"
  "$2/environment/bin/python" -m pip --disable-pip-version-check install --quiet "cvista[rendering,io]==$version" \
    "cvista-sdk==$version" pyvista==0.49.1 pyvista-render-passes==0.2.0 cmake ninja
)

run_in_environment() { # root command...
  local environment
  environment=$(realpath "$1/environment")
  shift
  (cd "$environment/../vtkshadow/project" && PATH=$environment/bin:$PATH PYTHON=$environment/bin/python "$@")
}

configure_pip() {
  cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DPython3_EXECUTABLE="$PYTHON" \
    -DSHADOW_TEST_PYTHON="$PYTHON" \
    -DVTK_DIR="$("$PYTHON" -c 'import cvista_sdk; print(cvista_sdk.__path__[0])')/cmake"
}

# This system may have a VTK of its own, of which no program may load anything.
check_vtk() {
  local loaded
  loaded=$(find build/bin build/lib -type f \( -executable -o -name '*.so' \) -exec ldd {} + | grep 'libvtk.* =>')
  ! grep -vF -e "=> $(pwd -P)/build/" -e "=> $(dirname "$(dirname "$PYTHON")")/" <<<"$loaded" ||
    { echo "another VTK than the environment's would be loaded, or none"; return 1; }
}

test_pip() { # system root
  run_in_environment "$2" configure_pip || { result="no build folder"; return; }
  run_in_environment "$2" cmake --build build -j2 || { result="build failed"; return; }
  run_in_environment "$2" check_vtk || { result="another VTK"; return; }
  run_in_environment "$2" ctest --test-dir build --output-on-failure -j2 "${only[@]}" || result="tests failed"
  [ ${#only[@]} -eq 0 ] || return 0
  rm -rf "$2/wheel"
  run_in_environment "$2" plugin/python/wheel/build.sh "$2/wheel" || { result="no wheel"; return; }
  run_in_environment "$2" tests/wheel.sh "$2"/wheel/*.whl || result="tests failed"
}

version_of() { # system root
  if [ "$1" = pip ]; then
    "$2/environment/bin/python" -c 'import importlib.metadata as m; print("cvista", m.version("cvista"))'
  else
    run_in "$2" dpkg-query -W -f '${Version}' libvtk9-dev 2>/dev/null
  fi
}

table=""
failed=0
for system in "${systems[@]}"; do
  root=$roots/$system
  log=$roots/$system.log
  mkdir -p "$root"
  echo "$system: making the root ..."
  make=make_root test=test_debian
  [ "$system" != pip ] || make=make_environment test=test_pip
  "$make" "$system" "$root" >"$log" 2>&1 || stop "no root for $system could be made; see $log"
  [ "$system" = pip ] || enter "$root"
  copy_project "$root"
  started=$SECONDS
  echo "$system: building and testing ... (log: $log)"
  result=""
  "$test" "$system" "$root" >>"$log" 2>&1
  version=$(version_of "$system" "$root" || echo "-")
  counts=$(grep -E "tests passed|scripts passed|No tests were found" "$log" | paste -sd ';' | sed 's/;/; /g' || true)
  skipped=$(grep -cE "\*\*\*Skipped|\(Skipped\)" "$log" || true)
  warnings=$(grep -cE "warning:" "$log" || true)
  unmount_all
  [ -z "$result" ] || failed=1
  table+=$(printf '%-8s %-22s %-24s %s; %s skipped, %s warnings, %d min' "$system" "$version" "${result:-passed}" \
    "${counts:-no tests}" "$skipped" "$warnings" $(((SECONDS - started) / 60)))$'\n'
done
printf '%-8s %-22s %-24s %s\n%s' system VTK result tests "$table"
exit $failed
