"""Mountains in the evening: the sun is a directional light, and each ridge darkens the valley behind it."""

import without_display  # noqa: F401
import numpy as np
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401


def mountains(size=400):
    """Noise of several frequencies, steeper the higher it is."""
    x, y = np.meshgrid(np.linspace(-5, 5, size), np.linspace(-5, 5, size))
    flat = pv.StructuredGrid(x, y, 0 * x)
    height = np.zeros(flat.n_points)
    for octave in range(5):
        noise = pv.perlin_noise(0.4**octave, (0.35 * 2**octave, 0.35 * 2**octave, 1), (0.6 + octave, 0.2, 0.3))
        height += [noise.EvaluateFunction(point) for point in flat.points]
    flat["height"] = 0.9 * np.exp(height) - 0.9
    return flat.warp_by_scalar("height")


def build(**options):
    plotter = pv.Plotter(lighting="none", **options)
    plotter.set_background("#f6d9bd", top="#7ea6cf")
    colors = ["#c9bf94", "#7f9a63", "#8da06a", "#a39a74", "#b39b78", "#c9b9a4", "#f4f1ec", "#f4f1ec"]  # sand to snow
    plotter.add_mesh(mountains(), scalars="height", cmap=colors, clim=(-0.3, 1.3), smooth_shading=True,
                     show_scalar_bar=False)
    plotter.add_mesh(pv.Plane(center=(0, 0, -0.27), i_size=10, j_size=10), color="#5f94b5", specular=0.3)
    sun = pv.Light(position=(6, 1.5, 2.3), color="#ffe3b8", light_type="scene light", intensity=1.2)
    sky = pv.Light(light_type="headlight", color="#b8d0ff", intensity=0.5)
    plotter.add_light(sun)
    plotter.add_light(sky)
    plotter.camera_position = [(-2, -7, 5.8), (-0.1, -0.4, 0), (0, 0, 1)]

    plotter.exact_shadows.enable()
    return plotter


if __name__ == "__main__":
    build().show()
