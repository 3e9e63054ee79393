"""Rendering without a display. Import this before anything of VTK:

    import vtkshadow.headless

It stands in front of the system's GL for the whole process; the window to use is then vtkshadow.vtkHeadlessRenderWindow.
The environment variable VTKSHADOW_HEADLESS chooses what draws: `osmesa`, a renderer in software, or `egl`, a GPU where
there is one. Not set: the first of these that is there.
"""

import ctypes
import os
import sys

from ._build import HAS_WINDOW, VTK_PACKAGE
from ._location import LIBRARIES

# What the window will load, and Debian's package of it.
_BACKENDS = {
    "osmesa": (["libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"], "OSMesa", "libosmesa6"),
    "egl": (["libEGL.so.1", "libEGL.so"], "EGL", "libegl1"),
}


def _load(names, missing, mode):
    """Loads the first library that there is."""
    reasons = []
    for name in names:
        try:
            return ctypes.CDLL(name, mode=mode)
        except OSError as error:
            reasons.append(str(error))
    raise ImportError(missing + ": " + "; ".join(reasons))


def _load_backend(choices):
    """Loads the first that there is. The window will look for them in the same order."""
    reasons = []
    for choice in choices:
        names, title, package = _BACKENDS[choice]
        missing = f"vtkshadow.headless needs {title}, which was not found (Debian: {package})"
        try:
            return _load(names, missing, ctypes.RTLD_LOCAL)
        except ImportError as error:
            reasons.append(str(error))
    raise ImportError("; or ".join(reasons))


def _stand_in_front_of_gl():
    if VTK_PACKAGE in sys.modules:
        raise ImportError(
            f"vtkshadow.headless has to be imported before {VTK_PACKAGE} (or vtk, or pyvista): "
            "VTK has already loaded the GL of the system"
        )
    choice = os.environ.get("VTKSHADOW_HEADLESS", "")
    if choice and choice not in _BACKENDS:
        raise ImportError(f"VTKSHADOW_HEADLESS is {choice}, and not osmesa or egl")
    backend = _load_backend([choice] if choice else list(_BACKENDS))
    folder = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), LIBRARIES))
    # Globally, so that its symbols come before those of libraries loaded later.
    shim = _load(
        [os.path.join(folder, "libvtkShadowGLX.so"), "libvtkShadowGLX.so"],
        "vtkshadow.headless did not find libvtkShadowGLX.so, a part of vtkShadow",
        ctypes.RTLD_GLOBAL,
    )
    return backend, shim


# Without a window of ours VTK's own draws without a display.
_libraries = _stand_in_front_of_gl() if HAS_WINDOW else ()
