"""Exact hard shadows and outlines for VTK, by render passes.

    from vtkshadow import vtkShadowVolumePass, vtkSilhouettePass
    renderer.SetPass(vtkShadowVolumePass())  # or vtkSilhouettePass()

Without a display, before anything of VTK:

    import vtkshadow.headless
    from vtkshadow import vtkHeadlessRenderWindow
"""

import importlib

# VTK is loaded with the first class that is asked for, so that `import vtkshadow.headless` comes before it.
_MODULES = {"vtkShadowVolumePass": "vtkShadowPasses", "vtkSilhouettePass": "vtkShadowPasses",
            "vtkHeadlessRenderWindow": "vtkShadowHeadless"}

__all__ = ["vtkShadowVolumePass", "vtkSilhouettePass"]  # the headless window only for those who ask for it


def __getattr__(name):
    if name not in _MODULES:
        raise AttributeError(f"module 'vtkshadow' has no attribute '{name}'")
    if name == "vtkHeadlessRenderWindow":
        importlib.import_module(".headless", __name__)
    # The wrapped classes' base classes; VTK's object factories need the second one.
    importlib.import_module("vtkmodules.vtkRenderingCore")
    importlib.import_module("vtkmodules.vtkRenderingOpenGL2")
    value = getattr(importlib.import_module("." + _MODULES[name], __name__), name)
    globals()[name] = value
    return value


def __dir__():
    return sorted([*globals(), *_MODULES])
