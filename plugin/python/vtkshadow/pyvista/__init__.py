"""Exact shadows and outlines for every plotter of PyVista.

    import vtkshadow.pyvista

    plotter.exact_shadows.enable()
    plotter.exact_shadows.outlines(width=3, creases=40)

Where the package was installed with its entry points PyVista (0.48 and later) finds the component by itself, and
pyvista-render-passes finds ExactShadowsProvider.
"""

import pyvista as _pyvista

from .component import ExactShadows, RendererShadows
from .provider import ExactShadowsProvider

__all__ = ["ExactShadows", "ExactShadowsProvider", "RendererShadows"]


class _Component:
    """What PyVista's registry of components does, for versions without one: made at first use, then an attribute."""

    def __get__(self, plotter, owner=None):
        if plotter is None:
            return ExactShadows
        return plotter.__dict__.setdefault("exact_shadows", ExactShadows(plotter))


if hasattr(_pyvista, "register_plotter_component"):
    _pyvista.register_plotter_component("exact_shadows")(ExactShadows)
else:
    from pyvista.plotting.plotter import BasePlotter as _BasePlotter

    _BasePlotter.exact_shadows = _Component()
