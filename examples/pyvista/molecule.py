"""A piece of DNA, balls and sticks: shadows tell which strand is in front."""

import without_display  # noqa: F401
import numpy as np
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401


def strand(start, pairs, step=0.34, turn=36.0):
    """Points of one backbone."""
    angles = np.radians(start + turn * np.arange(pairs))
    return np.column_stack([step * np.arange(pairs), np.cos(angles), np.sin(angles)])


def balls(points, radius):
    ball = pv.Sphere(radius=radius, theta_resolution=32, phi_resolution=24)
    return pv.PolyData(points).glyph(geom=ball, scale=False, orient=False)


def build(pairs=22, **options):
    plotter = pv.Plotter(lighting="none", **options)
    plotter.set_background("white", top="#d5deea")
    first, second = strand(0, pairs), strand(140, pairs)
    for points, color in ((first, "#c8553d"), (second, "#3d6fc8")):
        plotter.add_mesh(balls(points, 0.2), color=color, smooth_shading=True, specular=0.4, specular_power=30)
        plotter.add_mesh(pv.Spline(points, 400).tube(radius=0.07, n_sides=24), color=color, smooth_shading=True)
    colors = ["#e9c46a", "#2a9d8f", "#f4a261", "#8ab17d"]
    for number, (one, other) in enumerate(zip(first, second)):
        middle = (one + other) / 2
        for end, color in ((one, colors[number * 7 % 4]), (other, colors[(number * 7 + 2) % 4])):
            stick = pv.Line(end, middle).tube(radius=0.09, n_sides=24)
            plotter.add_mesh(stick, color=color, smooth_shading=True)
    plotter.add_mesh(pv.Plane(center=(3.5, 0, -1.7), i_size=60, j_size=60), color="white")
    plotter.add_light(pv.Light(position=(2, -2, 9), focal_point=(3.5, 0, 0), light_type="scene light", intensity=0.8))
    plotter.add_light(pv.Light(light_type="headlight", intensity=0.45))
    plotter.camera_position = [(0.8, -10, 6.2), (3.75, 0, -0.5), (0, 0, 1)]

    plotter.exact_shadows.enable(intensity=0.85)
    return plotter


if __name__ == "__main__":
    build().show()
