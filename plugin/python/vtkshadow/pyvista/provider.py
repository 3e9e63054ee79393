"""Exact shadows and outlines for pyvista-render-passes, beside all of its passes but shadow maps."""

import weakref

from .chain import camera_with
from .effects import Effects
from .settings import DEFAULTS


class ExactShadowsProvider:
    """A provider of the stage 'base', off until its state says otherwise.

    >>> plotter.render_passes.set_state({"providers": {"exact_shadows": {"enabled": True}}})
    """

    name = "exact_shadows"
    stages = ("base",)

    def __init__(self, effects=None):
        self.effects = Effects() if effects is None else effects
        self.remarks = []
        self._invalidate = None
        self._chain = None
        self._observed = None  # renderer and observer

    def bind(self, invalidate):
        """Takes over how to have the chain built anew."""
        self._invalidate = invalidate
        if invalidate is None and self._observed is not None:
            renderer, observer = self._observed
            renderer.RemoveObserver(observer)
            self._observed = None

    def build_pass(self, stage, renderer, chain, delegate):
        """The scene with our passes where the delegate draws what is opaque; None to leave it as it is."""
        self.remarks = []
        if not self.effects.active:
            return None
        built = camera_with(self.effects, delegate)
        if built is None:
            self.remarks = ["not drawn: another provider has changed the base of the scene"]
        self._chain = chain
        if self._observed is None:
            self._observe(renderer)
        return built

    def _observe(self, renderer):
        # How much is supersampled may change without the chain being built anew.
        itself = weakref.ref(self)

        def scale_lines(*_):
            provider = itself()
            if provider is not None:
                supersampling = provider._chain.GetSsaaPass()
                provider.effects.scale_lines(supersampling.GetSupersampleFactor() if supersampling else 1)

        self._observed = renderer, renderer.AddObserver("StartEvent", scale_lines)

    def default_state(self):
        """Off."""
        return dict(DEFAULTS)

    def get_state(self):
        """What is set, as plain data."""
        return dict(self.effects.settings)

    def set_state(self, state):
        """Takes over what the state has; a bad value is an error, and nothing is changed."""
        self.effects.update(state)
        if self._invalidate is not None:
            self._invalidate()

    def adopt(self, effects, settings):
        """Draws with passes and settings that somebody else has, if they go together with the component's."""
        before, self.effects = self.effects, effects
        if reason := self.veto(settings):
            self.effects = before
            raise ValueError(reason)
        self._invalidate()

    def veto(self, settings):
        """Two kinds of shadows would darken each other."""
        if self.effects.settings["enabled"] and settings.get("shadows"):
            return "exact shadows take the place of shadow maps: disable one of them"
        return None
