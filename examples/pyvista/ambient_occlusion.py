"""A city: shadows of the sun, and with enable_ssao() those of the sky, in corners and streets."""

import without_display  # noqa: F401
import numpy as np
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401


def city(blocks=9, seed=4):
    """Houses on a grid, higher in the middle."""
    random = np.random.default_rng(seed)
    for x, y in np.ndindex(blocks, blocks):
        x, y = x - blocks // 2, y - blocks // 2
        height = random.uniform(0.35, 0.8) + 2.6 * np.exp(-(x * x + y * y) / 5) * random.uniform(0.3, 1)
        width, depth = random.uniform(0.55, 0.75, 2)
        yield pv.Cube(center=(x, y, height / 2), x_length=width, y_length=depth, z_length=height)
        if height > 1.2:
            yield pv.Cube(center=(x, y, height + 0.2), x_length=width / 2, y_length=depth / 2, z_length=0.4)


def build(**options):
    plotter = pv.Plotter(lighting="none", **options)
    plotter.set_background("#e8edf2")
    for number, house in enumerate(city()):
        plotter.add_mesh(house, color=("#e9dcc9", "#d8c3a5", "#e5e3dc", "#c9a58b")[number * 5 % 4])
    plotter.add_mesh(pv.Plane(i_size=60, j_size=60), color="#cfd4d8")
    plotter.add_light(pv.Light(position=(-4, -4.5, 5), light_type="scene light", color="#fff0d8", intensity=0.85))
    plotter.add_light(pv.Light(light_type="headlight", intensity=0.55))
    plotter.camera_position = [(5.5, -10, 8.5), (0.2, 0, 0.3), (0, 0, 1)]
    plotter.enable_ssao(radius=0.7, bias=0.02, kernel_size=128)

    plotter.exact_shadows.enable(intensity=0.85)
    return plotter


if __name__ == "__main__":
    build().show()
