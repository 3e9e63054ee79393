"""Translucent in front of opaque: through the outer surface of a field its core is seen, with shadows on it."""

import without_display  # noqa: F401
import numpy as np
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401

CENTERS = [(-0.9, 0, 0.1), (0.55, 0.5, 0.35), (0.5, -0.6, -0.25)]


def field(size=70):
    """The sum of three bells."""
    axis = np.linspace(-2.6, 2.6, size)
    x, y, z = np.meshgrid(axis, axis, axis, indexing="ij")
    grid = pv.StructuredGrid(x, y, z)
    grid["value"] = sum(np.exp(-1.7 * ((x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2)).ravel("F") for a, b, c in CENTERS)
    return grid


def build(**options):
    plotter = pv.Plotter(lighting="none", **options)
    plotter.set_background("#f4f1ea", top="#d9e2ec")
    values = field()
    plotter.add_mesh(values.contour([0.85], "value"), color="#d1495b", smooth_shading=True, specular=0.4)
    plotter.add_mesh(values.contour([0.3], "value"), color="#66a3c7", opacity=0.35, smooth_shading=True, specular=0.6,
                     specular_power=30)
    for angle in (0, 120, 240):
        ring = pv.ParametricTorus(ringradius=1.9, crosssectionradius=0.06).rotate_x(65).rotate_z(angle)
        plotter.add_mesh(ring, color="#edae49", smooth_shading=True)
    plotter.add_mesh(pv.Plane(center=(0, 0, -2), i_size=60, j_size=60), color="#f4f1ea")
    plotter.add_light(pv.Light(position=(-3, -3, 7), light_type="scene light", intensity=0.8))
    plotter.add_light(pv.Light(light_type="headlight", intensity=0.45))
    plotter.camera_position = [(3, -8, 4.5), (0, 0, -0.45), (0, 0, 1)]

    plotter.exact_shadows.enable(intensity=0.85)
    return plotter


if __name__ == "__main__":
    build().show()
