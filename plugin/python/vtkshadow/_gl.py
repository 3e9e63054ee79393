"""The GL of ours, for a VTK that takes GL from whoever was loaded first."""

import ctypes
import os
import sys

from ._build import VTK_PACKAGE
from ._location import LIBRARIES

_library = None  # loaded once and for good, even where what comes after it fails


def stand_in_front():
    """Loads our GL globally, so that its symbols come before those of libraries loaded later."""
    global _library
    _library = _library or _load()


def _load():
    if VTK_PACKAGE in sys.modules:
        raise ImportError(
            f"vtkshadow.headless has to be imported before {VTK_PACKAGE} (or vtk, or pyvista): "
            "VTK has already loaded the GL of the system"
        )
    folder = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), LIBRARIES))
    reasons = []
    for name in os.path.join(folder, "libvtkShadowGLX.so"), "libvtkShadowGLX.so":
        try:
            return ctypes.CDLL(name, mode=ctypes.RTLD_GLOBAL)
        except OSError as error:
            reasons.append(str(error))
    raise ImportError(
        "vtkshadow.headless did not find libvtkShadowGLX.so, a part of vtkShadow: " + "; ".join(reasons)
    )
