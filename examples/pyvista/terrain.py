"""Mountains in the evening: the sun is a directional light, and each ridge darkens the valley behind it."""

import without_display  # noqa: F401
import numpy as np
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401


def mountains(size=260):
    """Noise of several frequencies; where it changes sign there are ridges."""
    x, y = np.meshgrid(np.linspace(-5, 5, size), np.linspace(-5, 5, size))
    flat = pv.StructuredGrid(x, y, 0 * x)
    height = np.zeros(flat.n_points)
    for octave in range(5):
        noise = pv.perlin_noise(1, (0.33 * 2**octave, 0.33 * 2**octave, 1), (0.4 + octave, 0.7, 0.3))
        values = np.array([noise.EvaluateFunction(point) for point in flat.points])
        height += (0.55 - np.abs(values)) * 0.5**octave
    flat["height"] = 1.3 * np.clip(height - 0.55, 0, None) ** 1.3
    return flat.warp_by_scalar("height").extract_surface()


def build(**options):
    plotter = pv.Plotter(lighting="none", **options)
    plotter.set_background("#f6d9bd", top="#7ea6cf")
    plotter.add_mesh(mountains(), scalars="height", cmap="gist_earth", clim=(-0.4, 1.3), smooth_shading=True,
                     show_scalar_bar=False)
    sun = pv.Light(position=(6, 4, 3), color="#ffe3b8", light_type="scene light", intensity=0.9)
    sky = pv.Light(light_type="headlight", color="#b8d0ff", intensity=0.3)
    plotter.add_light(sun)
    plotter.add_light(sky)
    plotter.camera_position = [(-2.5, -8.5, 5), (0, -0.4, 0.2), (0, 0, 1)]

    plotter.exact_shadows.enable()
    return plotter


if __name__ == "__main__":
    build().show()
