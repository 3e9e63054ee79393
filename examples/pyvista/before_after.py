"""Before and after: the same scene without shadows and with them. They show where things are, and what touches what."""

import without_display  # noqa: F401
import numpy as np
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401


def knot():
    t = np.linspace(0, 2 * np.pi, 300)
    points = np.column_stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)])
    return pv.Spline(points, 600).tube(radius=0.38, n_sides=40)


def build(**options):
    plotter = pv.Plotter(shape=(1, 2), lighting="none", border=False, **options)
    for column in (0, 1):
        plotter.subplot(0, column)
        plotter.set_background("#f3ede4", all_renderers=False)
        plotter.add_mesh(knot(), color="#2f7f79", smooth_shading=True, specular=0.5, specular_power=40)
        plotter.add_mesh(pv.Plane(center=(0, 0, -1.8), i_size=80, j_size=80), color="#f3ede4")
        for x, y, radius in [(-2.6, -2.9, 0.5), (2.5, -3.2, 0.7), (0, 0, 0.6)]:
            ball = pv.Sphere(center=(x, y, radius - 1.8), radius=radius, theta_resolution=60, phi_resolution=60)
            plotter.add_mesh(ball, color="#e07a3f", smooth_shading=True)
        plotter.add_light(pv.Light(position=(-3, -4, 9), light_type="scene light", intensity=0.8), only_active=True)
        plotter.add_light(pv.Light(light_type="headlight", intensity=0.45), only_active=True)
        plotter.add_text("enable()" if column else "plain", font_size=10, color="black")
        plotter.camera_position = [(1, -19, 15), (0.4, -0.2, -0.8), (0, 0, 1)]

    plotter.subplot(0, 1)
    plotter.exact_shadows.enable(intensity=0.85)
    return plotter


if __name__ == "__main__":
    build().show()
