"""Rendering without a display. Import this before anything of VTK:

    import vtkshadow.headless

From then on vtkRenderWindow() needs no display, whether it is made by hand or by PyVista, nor does
vtkRenderWindowInteractor(), whose Start() returns at once. It means headless: with a display as well no window is shown.
vtkshadow.vtkHeadlessRenderWindow is the same window by its name. ImportError, which says why, where nothing can draw.

The environment variable VTKSHADOW_HEADLESS chooses what draws: `osmesa`, a renderer in software, or `egl`, a GPU where
there is one. Not set: the first of these that draws.

VTK's own windows need no display from VTK 9.4 on, and show themselves where there is one. There this leaves them as they
are, and only without a display gives them such an interactor; it may be imported at any time; and ours draws by EGL, as
they do, where VTKSHADOW_HEADLESS is not set and EGL draws. Without a display `osmesa` goes for theirs as well, if this is
imported before the first of them.
"""

import ctypes
import os
import sys

from ._build import HAS_WINDOW, VTK_PACKAGE
from ._location import GL_BY_SYMBOL, LIBRARIES


def _stand_in_front_of_gl():
    """Loads our GL globally, so that its symbols come before those of libraries loaded later."""
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


def _draw_without_display():
    from . import vtkHeadlessRenderWindow  # and with it VTK

    window = vtkHeadlessRenderWindow()
    if not window.IsUsable():
        raise ImportError("vtkshadow.headless cannot draw: " + window.GetStatusMessage())
    vtkHeadlessRenderWindow.OverrideRenderWindow()
    # PyVista looks for an X server, and warns with each plotter that it will likely crash, where this does not say yes.
    os.environ.setdefault("ALLOW_PLOTTING", "true")


# Without a window of ours VTK's own draws without a display.
if HAS_WINDOW:
    if GL_BY_SYMBOL:
        _stand_in_front_of_gl()
    _draw_without_display()
