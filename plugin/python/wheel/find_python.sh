# Sets $python: PYTHON, or the first in PATH or of pyenv's that is 3.12 or later. Sourced.
pyenv=("${PYENV_ROOT:-$HOME/.pyenv}"/versions/3.1[2-9]*/bin/python3)
for python in ${PYTHON:-python3 python3.14 python3.13 python3.12 "${pyenv[@]}"}; do
  "$python" -c 'import sys; sys.exit(sys.version_info < (3, 12))' 2> /dev/null && break
  python=""
done
[ -n "$python" ] || { echo "No Python from 3.12 on; name one by PYTHON=..." >&2; exit 1; }
