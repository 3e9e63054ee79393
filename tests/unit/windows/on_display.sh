#!/bin/sh
# Runs a command on an X server of its own where there is one (Debian: xvfb), else on the user's display.
command -v Xvfb >/dev/null || exec "$@"
folder=$(mktemp -d)
# The server finds a number itself that nobody has, not in another root folder either: it tries the sockets. And it does
# not start anew, refusing others meanwhile, whenever its last window goes.
Xvfb -displayfd 3 -noreset -screen 0 1280x1024x24 -nolisten tcp 3>"$folder/number" >"$folder/messages" 2>&1 &
server=$!
trap 'kill "$server" 2>/dev/null; rm -rf "$folder"' EXIT
trap 'exit 1' HUP INT TERM
while [ ! -s "$folder/number" ]; do
  kill -0 "$server" 2>/dev/null || { cat "$folder/messages" >&2; exit 1; }
  sleep 0.05
done
DISPLAY=:$(cat "$folder/number") "$@"
