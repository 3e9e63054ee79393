"""Exact hard shadows and outlines for VTK, by render passes.

    from vtkshadow import vtkShadowVolumePass, vtkSilhouettePass
    renderer.SetPass(vtkShadowVolumePass())  # or vtkSilhouettePass()

Without a display, before anything of VTK:

    import vtkshadow.headless
    from vtkshadow import vtkHeadlessRenderWindow

From 9.4 on VTK's own window needs no display. A package that was built without ours, as wheels are, has no
vtkHeadlessRenderWindow, and the import of vtkshadow.headless does nothing.
"""

import importlib

from . import _vtk
from ._build import HAS_WINDOW, VERSION as __version__

# VTK is loaded with the first class that is asked for, so that `import vtkshadow.headless` comes before it.
_MODULES = {"vtkShadowVolumePass": "vtkShadowPasses", "vtkSilhouettePass": "vtkShadowPasses"}
__all__ = list(_MODULES)
if HAS_WINDOW:  # only for those who ask for it
    _MODULES["vtkHeadlessRenderWindow"] = "vtkShadowHeadless"

_vtk.find()


def __getattr__(name):
    if name not in _MODULES:
        raise AttributeError(f"module 'vtkshadow' has no attribute '{name}'")
    if name == "vtkHeadlessRenderWindow":
        importlib.import_module(".headless", __name__)
    _vtk.load()
    value = getattr(importlib.import_module("." + _MODULES[name], __name__), name)
    globals()[name] = value
    return value


def __dir__():
    return sorted([*globals(), *_MODULES])
