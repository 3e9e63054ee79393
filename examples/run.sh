#!/usr/bin/env bash
# Installs what is missing, builds, draws, and says where the picture is.
#
#   examples/run.sh [MODEL...] [OPTION...]    options are shadow_render's, see examples/run.sh --help
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

install_missing
build shadow_render >&2

output=shadow.png
arguments=("$@")
for ((i = 0; i < $#; ++i)); do
  case ${arguments[i]} in
    --help) exec "$build_folder/bin/shadow_render" --help ;;
    --output) output=${arguments[i + 1]-} ;;
    --output=*) output=${arguments[i]#--output=} ;;
    --frames | --frames=*) numbered=yes ;;
  esac
done

"$build_folder/bin/shadow_render" "$@"
if [ -n "${numbered-}" ]; then
  echo "The pictures: $(realpath "${output%.*}-0000.${output##*.}") and on"
else
  echo "The picture: $(realpath "$output")"
fi
