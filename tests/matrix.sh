#!/usr/bin/env bash
# Builds and tests the project on other Debians, each in a root folder of its own, as a new user would: with the
# README's two commands.
#
#   tests/matrix.sh [12|13|testing]...      which; default: all three
#   tests/matrix.sh --only REGEX 13         those tests only, as ctest -R
#
# The roots stay for the next run, with their packages, in the folder that VTKSHADOW_ROOTS names (default
# ~/.cache/vtkshadow-roots; some 5 GB each). DEBIAN_MIRROR is where packages come from; default: debootstrap's own.
# Needs root and debootstrap. Each takes some 15 minutes on two cores, and a few more the first time.
set -euo pipefail

project_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
roots=${VTKSHADOW_ROOTS:-$HOME/.cache/vtkshadow-roots}
only=()
systems=()

stop() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

while [ $# -gt 0 ]; do
  case $1 in
    12 | 13 | testing) systems+=("$1") ;;
    --only)
      [ $# -gt 1 ] || stop "--only needs a regular expression"
      only=(-R "$2")
      shift
      ;;
    *) stop "$1: not one of 12, 13, testing, --only REGEX" ;;
  esac
  shift
done
[ ${#systems[@]} -gt 0 ] || systems=(12 13 testing)
[ "$(id -u)" -eq 0 ] || stop "needs root, to make a root folder and change into it"
command -v debootstrap >/dev/null || stop "needs debootstrap (Debian: apt-get install debootstrap)"

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

# What the repository holds, with changes that are not committed yet; build folders of the run before stay.
copy_project() { # root
  mkdir -p "$1/vtkshadow/project"
  (cd "$project_folder" && git ls-files -z --cached --others --exclude-standard) |
    tar -C "$project_folder" --null --files-from=- --ignore-failed-read -cf - |
    tar -C "$1/vtkshadow/project" -xf -
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

table=""
failed=0
for system in "${systems[@]}"; do
  root=$roots/$system
  log=$roots/$system.log
  mkdir -p "$roots"
  echo "Debian $system: making the root ..."
  make_root "$system" "$root" >"$log" 2>&1 || stop "no root for Debian $system could be made; see $log"
  enter "$root"
  copy_project "$root"
  started=$SECONDS
  echo "Debian $system: examples/run.sh, tests/run.sh ... (log: $log)"
  result=passed
  run_in "$root" examples/run.sh >>"$log" 2>&1 || result="examples/run.sh failed"
  if [ "$result" = passed ]; then
    run_in "$root" tests/run.sh "${only[@]}" >>"$log" 2>&1 || result="tests failed"
  fi
  version=$(run_in "$root" dpkg-query -W -f '${Version}' libvtk9-dev 2>/dev/null || echo "-")
  counts=$(grep -E "tests passed|No tests were found" "$log" | tail -1 || true)
  skipped=$(grep -cE "\*\*\*Skipped|\(Skipped\)" "$log" || true)
  warnings=$(grep -cE "warning:" "$log" || true)
  unmount_all
  [ "$result" = passed ] || failed=1
  table+=$(printf '%-8s %-22s %-24s %s; %s skipped, %s warnings, %d min' "$system" "$version" "$result" \
    "${counts:-no tests}" "$skipped" "$warnings" $(((SECONDS - started) / 60)))$'\n'
done
printf '%-8s %-22s %-24s %s\n%s' Debian VTK result tests "$table"
exit $failed
