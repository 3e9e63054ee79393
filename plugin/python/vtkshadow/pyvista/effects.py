"""The two passes of one renderer, set up by its settings."""

from pyvista import Color, ImageData

from vtkshadow import vtkShadowVolumePass, vtkSilhouettePass

from .settings import DEFAULTS, METHODS, changed

_TITLES = {vtkShadowVolumePass.STATUS_OK: "on", vtkShadowVolumePass.STATUS_PARTIAL: "partly drawn",
           vtkShadowVolumePass.STATUS_NOT_SUPPORTED: "not possible here",
           vtkShadowVolumePass.STATUS_NOT_RENDERED: "on, not drawn yet"}


class Effects:
    """They live as long as the renderer's component, so that whatever else is set on them stays."""

    def __init__(self):
        self.settings = dict(DEFAULTS)
        self.shadow_pass = vtkShadowVolumePass()
        self.outline_pass = vtkSilhouettePass()

    @property
    def active(self):
        return self.settings["enabled"] or self.settings["outlines"] is not None

    def update(self, changes):
        """Takes over all changes, or raises and takes over none."""
        self.settings = changed(self.settings, changes)
        shadows, lines = self.shadow_pass, self.settings["outlines"]
        shadows.SetShadowIntensity(self.settings["intensity"])
        shadows.SetSamples(self.settings["samples"] or 0)
        shadows.SetSilhouetteMethod(METHODS.index(self.settings["method"]))
        if lines is not None:
            self.outline_pass.SetColor(*Color(lines["color"]).float_rgb)
            self.outline_pass.SetCreaseEdges(lines["creases"] is not None)
            if lines["creases"] is not None:
                self.outline_pass.SetFeatureAngle(lines["creases"])

    def scale_lines(self, factor):
        """Keeps lines as wide as they are set, where a pass above draws more pixels than the window has."""
        if self.settings["outlines"] is not None:
            self.outline_pass.SetLineWidth(self.settings["outlines"]["width"] * factor)

    def complete(self):
        """A pass that draws all of the renderer."""
        self.shadow_pass.SetScope(vtkShadowVolumePass.SCOPE_COMPLETE)
        return self._lined(None)

    def opaque(self, plain):
        """A pass to stand in place of the plain one, which draws what is opaque."""
        self.shadow_pass.SetScope(vtkShadowVolumePass.SCOPE_OPAQUE)
        return self._lined(plain)

    def _lined(self, plain):
        scene = self.shadow_pass if self.settings["enabled"] else plain
        if self.settings["outlines"] is None:
            return scene
        self.outline_pass.SetDelegatePass(scene)
        return self.outline_pass

    def mask(self, index):
        """The shadow mask of a light as an array, rows from the top."""
        image = ImageData()
        if not self.shadow_pass.GetShadowMask(index, image):
            raise RuntimeError("there is no shadow mask: " + "\n".join(self.describe()))
        width, height, _ = image.GetDimensions()
        return image.active_scalars.reshape(height, width)[::-1].copy()

    def release(self, window):
        for each in (self.outline_pass, self.shadow_pass):
            each.ReleaseGraphicsResources(window)

    def describe(self):
        """Lines of text: first what is on, then what the passes have to say."""
        shown = (("shadows", self.shadow_pass, self.settings["enabled"]),
                 ("outlines", self.outline_pass, self.settings["outlines"] is not None))
        titles = [f"{name} {_TITLES[drawn.GetStatus()] if on else 'off'}" for name, drawn, on in shown]
        found = [line for _, drawn, on in shown if on for line in drawn.GetStatusMessage().splitlines()]
        if self.settings["enabled"]:
            found += self._hints()
        return ["; ".join(titles), *found]

    def _hints(self):
        shadows = self.shadow_pass
        if shadows.GetStatus() in (shadows.STATUS_NOT_RENDERED, shadows.STATUS_NOT_SUPPORTED):
            return []
        hints = []
        if shadows.GetNumberOfShadowLights() == 0:
            hints.append("no light casts a shadow: each is a headlight or switched off")
        if "lighting" in shadows.GetStatusMessage():
            hints.append("add_mesh() and add_floor() draw with light by lighting=True")
        return hints
