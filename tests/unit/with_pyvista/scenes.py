"""What the tests of vtkshadow.pyvista draw, and how they compare pictures."""

import sys
import unittest

try:
    import numpy as np
    import pyvista as pv
except ImportError as error:
    print(f"there is no PyVista: {error}")
    sys.exit(0)

from pyvista.plotting.render_passes import _vtk as vtk  # noqa: F401  whatever its package is called

import vtkshadow.pyvista  # noqa: F401  every plotter has exact_shadows from here on

SIZE = (200, 150)

# Each pass of PyVista's: how it is switched on, and off.
PASSES = {
    "ssao": (lambda p: p.enable_ssao(radius=0.3, kernel_size=16), lambda p: p.disable_ssao()),
    "edl": (lambda p: p.enable_eye_dome_lighting(), lambda p: p.disable_eye_dome_lighting()),
    "ssaa": (lambda p: p.enable_anti_aliasing("ssaa"), lambda p: p.disable_anti_aliasing()),
    "fxaa": (lambda p: p.enable_anti_aliasing("fxaa"), lambda p: p.disable_anti_aliasing()),
    "msaa": (lambda p: p.enable_anti_aliasing("msaa", multi_samples=4), lambda p: p.disable_anti_aliasing()),
    "dof": (lambda p: p.enable_depth_of_field(), lambda p: p.disable_depth_of_field()),
    "blur": (lambda p: p.add_blurring(), lambda p: p.remove_blurring()),
}


def fill(plotter, glass=True):
    """A ball and a glass box over a table, below one lamp that casts."""
    plotter.remove_all_lights()
    plotter.add_light(pv.Light(position=(2, 1, 5), light_type="scene light", intensity=0.6))
    plotter.add_light(pv.Light(light_type="headlight", intensity=0.3))
    plotter.add_mesh(pv.Sphere(radius=0.5, theta_resolution=24, phi_resolution=20), color="tan", smooth_shading=True)
    plotter.add_mesh(pv.Plane(center=(0, 0, -0.7), i_size=4, j_size=4), color="lightblue")
    if glass:
        plotter.add_mesh(pv.Cube(center=(0.9, -0.9, -0.2), x_length=0.4, y_length=0.4), color="green", opacity=0.4)
    plotter.add_text("a text", font_size=6)
    # Nothing is at the window's edge, where VTK's supersampling takes what is at the opposite one.
    plotter.camera_position = [(5.6, -7, 4.9), (0, 0, 0), (0, 0, 1)]
    plotter.camera.clipping_range = (0.1, 30)


def make_plotter(glass=True, **arguments):
    # No multisampling but what a test asks for: enable_anti_aliasing() takes it off for good.
    plotter = pv.Plotter(off_screen=True, window_size=SIZE, **arguments)
    plotter.render_window.SetMultiSamples(0)
    for index in reversed(range(len(plotter.renderers))):
        plotter.subplot(*plotter.renderers.index_to_loc(index))
        fill(plotter, glass)
    return plotter


def picture(plotter):
    plotter.screenshot(None, return_img=True)  # the first one only prepares the window
    plotter.render_window.Render()
    return np.array(plotter.screenshot(None, return_img=True)).astype(int)


def drawn(*steps, **arguments):
    """The picture after the steps, which take the plotter."""
    plotter = make_plotter(**arguments)
    for step in steps:
        step(plotter)
    found = picture(plotter)
    plotter.close()
    return found


def shadows(plotter):
    plotter.exact_shadows.enable()


def off(plotter):
    plotter.exact_shadows.disable()
    plotter.exact_shadows.outlines(None)


def lines(plotter):
    plotter.exact_shadows.outlines(2, "red")


def differing(one, other):
    return (one != other).any(axis=2)


def grown(pixels, by):
    """The pixels, and those up to so many rows and columns beside them."""
    for axis in (0, 1):
        for _ in range(by):
            ahead, behind = np.zeros_like(pixels), np.zeros_like(pixels)
            rows = [slice(None)] * axis
            ahead[(*rows, slice(1, None))] = pixels[(*rows, slice(None, -1))]
            behind[(*rows, slice(None, -1))] = pixels[(*rows, slice(1, None))]
            pixels = pixels | ahead | behind
    return pixels


class PyVistaTest(unittest.TestCase):
    """Pictures are compared of one plotter where VTK's passes keep what an earlier window's left in memory."""

    @classmethod
    def setUpClass(cls):
        # An X server may start anew when its last window goes, and refuse the next one meanwhile.
        cls.window_that_stays = pv.Plotter(off_screen=True, window_size=(20, 20))
        cls.window_that_stays.screenshot(None, return_img=True)
        cls.plain = drawn()
        cls.shadowed = differing(drawn(shadows), cls.plain)
        cls.lined = differing(drawn(lines), cls.plain)

    @classmethod
    def tearDownClass(cls):
        cls.window_that_stays.close()

    def assert_same(self, one, other, message=None):
        self.assertEqual(one.shape, other.shape, message)
        self.assertEqual(int(differing(one, other).sum()), 0, message)

    def assert_both(self, ours, plotter, touched, reach=12):
        """What ours, which is on, has touched differs from the picture without, and nothing does out of its reach."""
        with_ours = picture(plotter)
        off(plotter)
        without = picture(plotter)
        changed = differing(with_ours, without)
        self.assertGreater(int(touched.sum()), 200)
        self.assertGreater(float(changed[touched].mean()), 0.9, f"{ours} is missing")
        if reach is not None:
            self.assertEqual(int((changed & ~grown(touched, reach)).sum()), 0, "theirs differs")
        self.assert_other(without, self.plain, "theirs is missing")

    def assert_other(self, one, other, message=None):
        self.assertGreater(int(differing(one, other).sum()), 50, message)
