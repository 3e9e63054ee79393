#!/bin/sh
# Runs a command on an X server of its own where there is one (Debian: xvfb and xauth), else on the user's display.
if command -v xvfb-run >/dev/null && command -v xauth >/dev/null; then
  exec xvfb-run --auto-servernum "$@"
fi
exec "$@"
