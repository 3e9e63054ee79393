"""A window to try things out: sliders for the light, the shadows and the outlines. Needs a display, and PyVista.

Usage: viewer.py [MESH]      MESH: any file that PyVista reads, z upwards; without, a built-in scene
"""

import sys

import numpy as np
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401  every plotter has exact_shadows from here on

SAMPLES = (1, 2, 4, 8, 16)


def built_in():
    """A mast with a ring and a ball, which throw shadows on each other."""
    parts = [pv.ParametricTorus(ringradius=0.7, crosssectionradius=0.16).rotate_x(90).translate((0, 0, 1.5)),
             pv.Cylinder(center=(0, 0, 0.4), direction=(0, 0, 1), radius=0.12, height=0.8, resolution=48).triangulate(),
             pv.Sphere(center=(1.5, 0.2, 0.35), radius=0.35, theta_resolution=48, phi_resolution=48),
             pv.Cube(center=(-1.2, -0.5, 0.3), x_length=0.6, y_length=0.6, z_length=0.6)]
    return pv.merge(parts)


class Viewer:
    """A mesh on a floor below one lamp, and what the sliders have set."""

    def __init__(self, mesh, **options):
        self.plotter = pv.Plotter(lighting="none", title="vtkShadow", **options)
        self.middle, self.size = np.array(mesh.center), mesh.length
        self.values = {"azimuth": 215.0, "height": 50.0, "intensity": 0.85, "samples": 4, "outlines": 1.5}
        self.sliders = {}  # what they look like, by name
        self.complete = False
        self._add_scene(mesh)
        self._add_slider("azimuth", (0, 360), 0.93)
        self._add_slider("height", (10, 90), 0.80)
        self._add_slider("intensity", (0, 1), 0.67)
        self._add_slider("samples", (0, len(SAMPLES) - 1), 0.54, SAMPLES.index(self.values["samples"]))
        self._add_slider("outlines", (0, 6), 0.41)
        self.complete = True
        self._apply()

    def _add_scene(self, mesh):
        plotter = self.plotter
        plotter.set_background("#e9edf1")
        plotter.add_mesh(mesh, color="#4f8a8b", smooth_shading=True, split_sharp_edges=True, specular=0.3)
        floor = pv.Plane(center=(*self.middle[:2], mesh.bounds[4]), i_size=20 * self.size, j_size=20 * self.size)
        plotter.add_mesh(floor, color="#e9edf1")
        self.lamp = pv.Light(light_type="scene light", intensity=0.8)
        self.lamp.positional = True
        self.lamp.cone_angle = 180  # a point light
        plotter.add_light(self.lamp)
        plotter.add_light(pv.Light(light_type="headlight", intensity=0.45))
        plotter.camera_position = [self.middle + self.size * np.array([0.45, -1.6, 0.9]), self.middle, (0, 0, 1)]

    def _add_slider(self, name, limits, y, start=None):
        def moved(value):
            self.values[name] = SAMPLES[round(value)] if name == "samples" else value
            if self.complete:
                self._apply()

        slider = self.plotter.add_slider_widget(
            moved, limits, value=self.values[name] if start is None else start, title=name, color="#30363d",
            pointa=(0.03, y), pointb=(0.27, y), style="modern", title_height=0.02, interaction_event="always")
        self.sliders[name] = slider.GetRepresentation()
        if name == "samples":
            self.sliders[name].ShowSliderLabelOff()  # it would show where in the list

    def _apply(self):
        values, shadows = self.values, self.plotter.exact_shadows
        around, up = np.radians([values["azimuth"], values["height"]])
        towards = np.array([np.cos(around) * np.cos(up), np.sin(around) * np.cos(up), np.sin(up)])
        self.lamp.position = self.middle + 1.5 * self.size * towards
        self.lamp.focal_point = self.middle
        shadows.enable(intensity=values["intensity"], samples=values["samples"])
        self.sliders["samples"].SetTitleText(f"samples: {values['samples']}")
        shadows.outlines(values["outlines"] if values["outlines"] >= 0.5 else None, creases=40)


def main():
    mesh = pv.read(sys.argv[1]) if len(sys.argv) > 1 else built_in()
    if isinstance(mesh, pv.MultiBlock):
        mesh = mesh.combine()
    viewer = Viewer(mesh, window_size=(1000, 700))
    viewer.plotter.show()


if __name__ == "__main__":
    main()
