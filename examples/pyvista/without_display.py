"""Where there is no display, everything is drawn in memory. To be imported before PyVista."""

import os

if not os.environ.get("DISPLAY"):
    import vtkshadow.headless  # noqa: F401
