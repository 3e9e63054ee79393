"""Both on one renderer: plotter.exact_shadows, and plotter.render_passes of pyvista-render-passes.

That one builds the renderer's whole chain anew whenever a setting of its own changes. So where it is in use its
provider draws, with the passes and settings of the component.
"""


class SharedChain:
    def __init__(self, plotter, renderer):
        self._plotter = plotter
        self._renderer = renderer
        self.remarks = []

    @property
    def _host(self):
        """The component of pyvista-render-passes for this renderer, if somebody has asked for it."""
        passes = self._plotter.__dict__.get("render_passes")
        hosts = [host for host in getattr(passes, "components", ()) if host.renderer is self._renderer]
        return hosts[0] if hosts else None

    @property
    def draws(self):
        """Whether the provider draws, so that nobody else has to."""
        host = self._host
        return host is not None and "exact_shadows" in host.providers

    def joined(self, effects, chain):
        """The effects that both have from now on; ours, where ours were on before the other one was asked for."""
        self.remarks = []
        host = self._host
        if host is None:
            return effects
        provider = host.providers.get("exact_shadows")
        if provider is not None and provider.effects is effects:
            self.remarks = provider.remarks
            return effects
        if provider is not None and not effects.active:
            return provider.effects
        return self._hand_over(effects, chain, host, provider)

    def _hand_over(self, effects, chain, host, provider):
        from .provider import ExactShadowsProvider

        chain.restore()
        try:
            if provider is None:
                host.add_provider(ExactShadowsProvider(effects))
            else:
                provider.adopt(effects, host.get_state())
        except ValueError as refusal:
            self.remarks = [f"not drawn: {refusal}"]
        return effects

    def update(self, effects, changes):
        """Changes settings, by the other one where it draws, so that others can refuse."""
        if self.draws:
            self._host.set_state({"providers": {"exact_shadows": changes}})
        else:
            effects.update(changes)
