"""Rendering without a display. Import this before anything of VTK:

    import vtkshadow.headless

From then on vtkRenderWindow() needs no display, whether it is made by hand or by PyVista, nor does
vtkRenderWindowInteractor(), whose Start() returns at once. It means headless: with a display as well no window is shown.
vtkshadow.vtkHeadlessRenderWindow is the same window by its name. ImportError, which says why, where nothing can draw
without a display; asked again, it says the same.

The environment variable VTKSHADOW_HEADLESS chooses what draws: `osmesa`, a renderer in software, or `egl`, a GPU where
there is one. Not set: the first of these that draws.

VTK's own windows need no display from VTK 9.4 on, and show themselves where there is one. There this leaves them as they
are, even if VTKSHADOW_HEADLESS is not set and ours cannot draw, and only without a display gives them such an interactor; it may be imported at any
time; and ours draws by EGL, as they do, where VTKSHADOW_HEADLESS is not set and EGL draws. Without a display `osmesa` goes for theirs as well, if this is
imported before the first of them.
"""

import os

from . import _gl
from ._build import HAS_WINDOW
from ._location import GL_BY_SYMBOL


def _vtk_shows_its_own():
    """Nothing of ours is needed, and none is asked for."""
    displays = os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    return bool(displays) and not GL_BY_SYMBOL and not os.environ.get("VTKSHADOW_HEADLESS")


def _draw_without_display():
    from . import vtkHeadlessRenderWindow  # and with it VTK

    window = vtkHeadlessRenderWindow()
    if not window.IsUsable() and not _vtk_shows_its_own():
        raise ImportError("vtkshadow.headless cannot draw: " + window.GetStatusMessage())
    vtkHeadlessRenderWindow.OverrideRenderWindow()
    # PyVista looks for an X server, and warns with each plotter that it will likely crash, where this does not say yes.
    os.environ.setdefault("ALLOW_PLOTTING", "true")


# Without a window of ours VTK's own draws without a display.
if HAS_WINDOW:
    if GL_BY_SYMBOL:
        _gl.stand_in_front()
    _draw_without_display()
