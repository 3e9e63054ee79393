"""What plotter.exact_shadows is."""

import weakref

import numpy as np

from .chain import Chain
from .effects import Effects
from .settings import LINE_DEFAULTS
from .shared_chain import SharedChain


class RendererShadows:
    """Exact shadows and outlines of one renderer, which is one subplot."""

    def __init__(self, plotter, renderer):
        self._plotter = plotter
        self._renderer = renderer
        self._effects = Effects()
        self._chain = Chain(renderer)
        self._shared = SharedChain(plotter, renderer)
        self._observer = None

    def enable(self, intensity=1.0, samples=None, method="auto"):
        """Has surfaces cast shadows on each other.

        Parameters
        ----------
        intensity : float
            How much of a light its shadow takes away, from 0 to 1.
        samples : int, optional
            Samples a pixel of the shadow mask, for smooth edges; None: as many as the window has.
        method : str
            How silhouettes are found. All methods give the same picture.
        """
        self._change({"enabled": True, "intensity": intensity, "samples": samples, "method": method})

    def disable(self):
        """Takes the shadows away; lines stay."""
        self._change({"enabled": False})

    def outlines(self, width=2, color="black", creases=None):
        """Draws lines along silhouettes and borders, in pixels; outlines(None) and outlines(False) take them away.

        Parameters
        ----------
        width : float, None or False
            In pixels, 0.5 to 64.
        color : ColorLike
            As everywhere in PyVista.
        creases : float, optional
            Also along edges whose faces' normals differ by more than this, in degrees.
        """
        off = width is None or width is False
        lines = {"width": LINE_DEFAULTS["width"] if off else width, "color": color, "creases": creases}
        self._change({"outlines": None if off else lines})

    def mask(self, light):
        """Draws, and returns the shadow mask of a light.

        Parameters
        ----------
        light : int or pyvista.Light
            The light, or its number among those of the subplot that are switched on.

        Returns
        -------
        numpy.ndarray
            One number a pixel, rows from the top as in a screenshot: 255 where the light reaches the surface, and
            where there is none, 0 in shadow. Below SSAA these are the pixels that it makes the picture's of.
        """
        index = self._index_of(light)
        self._check_open()
        if not self.settings["enabled"]:
            raise RuntimeError("exact shadows are off: there is no mask")
        if self._plotter.render_window.GetNeverRendered():
            self._plotter.screenshot(None, return_img=False)
        else:
            self._plotter.render_window.Render()
        return self._effects.mask(index)

    @property
    def status(self):
        """What is on, and, a line for each, what was left out in the last picture and why."""
        self._compose()
        return "\n".join([*self._effects.describe(), *self._chain.remarks, *self._shared.remarks])

    @property
    def settings(self):
        """What is set, as plain data."""
        self._effects = self._shared.joined(self._effects, self._chain)
        return dict(self._effects.settings)

    @property
    def shadow_pass(self):
        """The vtkShadowVolumePass, for settings beyond those of enable()."""
        return self._effects.shadow_pass

    @property
    def outline_pass(self):
        """The vtkSilhouettePass, for settings beyond those of outlines()."""
        return self._effects.outline_pass

    def _check_open(self):
        if self._plotter.render_window is None:
            raise RuntimeError("the plotter has been closed")

    def _change(self, changes):
        self._check_open()
        self._effects = self._shared.joined(self._effects, self._chain)
        self._shared.update(self._effects, changes)
        if self._observer is None and self._effects.active:
            self._observe()
        self._compose()
        self._renderer.Modified()

    def _observe(self):
        itself = weakref.ref(self)

        def compose(*_):
            shadows = itself()
            if shadows is not None:
                shadows._compose()

        self._observer = self._renderer.AddObserver("StartEvent", compose, 1.0)  # before pyvista-render-passes

    def _compose(self):
        self._effects = self._shared.joined(self._effects, self._chain)
        if not self._shared.draws:
            self._chain.compose(self._effects)

    def _index_of(self, light):
        lights = [each for each in self._renderer.GetLights() if each.GetSwitch()]
        for index, each in enumerate(lights):
            if each is light:
                return index
        if isinstance(light, bool) or not isinstance(light, (int, np.integer)):
            raise TypeError(f"light has to be a light of this subplot that is on, or its number, not {light!r}")
        if not 0 <= light < len(lights):
            raise ValueError(f"light has to be from 0 to {len(lights) - 1}, not {light!r}")
        return int(light)

    def _close(self):
        if self._observer is not None:
            self._renderer.RemoveObserver(self._observer)
            self._observer = None
        self._chain.restore()
        if self._plotter.render_window is not None:
            self._effects.release(self._plotter.render_window)


class ExactShadows:
    """plotter.exact_shadows: that of the active subplot, and `all` for all subplots.

    >>> plotter.exact_shadows.enable()
    >>> plotter.exact_shadows.all.outlines(width=3)
    """

    def __init__(self, plotter):
        self._plotter = plotter
        self._of_renderer = {}

    @property
    def active(self):
        """Of the active subplot."""
        if self._plotter.render_window is None:
            raise RuntimeError("the plotter has been closed")
        return self._of(self._plotter.renderer)

    @property
    def components(self):
        """One for each subplot."""
        return tuple(self._of(renderer) for renderer in self._plotter.renderers)

    @property
    def all(self):
        """All subplots at once: enable(), disable(), outlines() and status."""
        return AllShadows(self.components)

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self.active, name)

    def __dir__(self):
        return sorted({*super().__dir__(), *(name for name in dir(RendererShadows) if not name.startswith("_"))})

    def _of(self, renderer):
        if renderer not in self._of_renderer:
            self._of_renderer[renderer] = RendererShadows(self._plotter, renderer)
        return self._of_renderer[renderer]

    def __plotter_close__(self):
        for shadows in self._of_renderer.values():
            shadows._close()
        self._of_renderer.clear()


class AllShadows:
    """The same for several subplots: for all of them, or, where one refuses, for none."""

    def __init__(self, components):
        self._components = components

    def enable(self, *args, **kwargs):
        """As RendererShadows.enable()."""
        self._each("enable", args, kwargs)

    def disable(self):
        """As RendererShadows.disable()."""
        self._each("disable", (), {})

    def outlines(self, *args, **kwargs):
        """As RendererShadows.outlines()."""
        self._each("outlines", args, kwargs)

    @property
    def status(self):
        """That of each subplot."""
        return "\n".join(shadows.status for shadows in self._components)

    def _each(self, name, args, kwargs):
        before = []
        try:
            for shadows in self._components:
                before.append((shadows, shadows.settings))
                getattr(shadows, name)(*args, **kwargs)
        except Exception:
            for shadows, settings in before:
                shadows._change(settings)
            raise
