"""Rendering without a display. Import this before anything of VTK:

    import vtkshadow.headless

It puts OSMesa, a renderer in software, in front of the system's GL for the whole process; the window to use is then
vtkshadow.vtkHeadlessRenderWindow.
"""

import ctypes
import ctypes.util
import os
import sys

from ._location import LIBRARIES


def _load(names, missing):
    """Loads the first library that there is, so that its symbols come before those of libraries loaded later."""
    reasons = []
    for name in names:
        try:
            return ctypes.CDLL(name, mode=ctypes.RTLD_GLOBAL)
        except OSError as error:
            reasons.append(str(error))
    raise ImportError(missing + ": " + "; ".join(reasons))


def _put_osmesa_first():
    if "vtkmodules" in sys.modules:
        raise ImportError(
            "vtkshadow.headless has to be imported before vtkmodules (or vtk, or pyvista): "
            "VTK has already loaded the GL of the system"
        )
    other_name = ctypes.util.find_library("OSMesa")
    osmesa = _load(
        ["libOSMesa.so.8"] + ([other_name] if other_name else []),
        "vtkshadow.headless needs OSMesa, which was not found (Debian: libosmesa6)",
    )
    folder = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), LIBRARIES))
    shim = _load(
        [os.path.join(folder, "libvtkShadowGLX.so"), "libvtkShadowGLX.so"],
        "vtkshadow.headless did not find libvtkShadowGLX.so, a part of vtkShadow",
    )
    return osmesa, shim


_libraries = _put_osmesa_first()
