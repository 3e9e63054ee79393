"""Scenes as PyVista's users make them look the same with our passes, where these have nothing to add.

Where they have, nothing gets brighter, nothing changes out of the shadows, and the status says what is left
out.

Needs PyVista and a display. Usage: drop_in_pyvista.py [-v] [TestPyVista.test_NAME]
"""

import sys
import unittest

try:
    import numpy as np
    import pyvista as pv
except ImportError as error:
    print(f"there is no PyVista: {error}")
    sys.exit(0)

import vtkshadow.pyvista  # noqa: F401  every plotter has exact_shadows from here on

import pyvista_surfaces
import pyvista_views

SIZE = (240, 180)
SCENES = {**pyvista_surfaces.ROWS, **pyvista_views.ROWS}

# Where no shadow falls, since there is nothing that casts: points, lines, what is translucent, or no light.
CASTS_NOTHING = {"wireframe", "wireframe_of_tubes", "points", "square_points", "gaussian_points",
                 "gaussian_spheres", "opacity_array", "opacity_of_scalars", "cloud", "contours",
                 "extracted_edges", "headlight", "no_light", "light_off", "glass", "depth_peeling",
                 "hidden_lines"}

# What the status has to say, but for that all is drawn.
REMARKS = {"unlit": "lighting is off", "floor": "lighting is off", "headlight": "no light casts a shadow",
           "no_light": "no light casts a shadow", "light_off": "no light casts a shadow"}


def make_plotter(name):
    plotter = pv.Plotter(off_screen=True, window_size=SIZE, shape=(1, 2) if name == "subplots" else (1, 1))
    SCENES[name](plotter)
    for renderer in plotter.renderers:
        if not renderer.camera_set:
            renderer.camera_position = [(4, -5, 3.5), (0, 0, 0), (0, 0, 1)]
            renderer.camera.clipping_range = (0.1, 30)
    plotter.render()
    pictures(plotter)  # the first ones only prepare the window
    lay_out_again(plotter)
    pictures(plotter)
    return plotter


def lay_out_again(plotter):
    """VTK's render passes mark props as modified, once, and its legends then choose another size of text."""
    for renderer in plotter.renderers:
        for prop in renderer.GetViewProps():
            prop.Modified()


def pictures(plotter):
    """Two pictures of a scene: RGB, and one with a transparent background."""
    plotter.render()
    return [np.array(plotter.screenshot(None, transparent_background=each, return_img=True))
            for each in (False, True)]


def off(component):
    component.disable()
    component.outlines(None)


def shadows_of_nothing(component):
    component.enable(intensity=0)


def shadows(component):
    component.enable(intensity=1)


def no_lines(component):
    component.outlines()
    component.outline_pass.SilhouetteEdgesOff()
    component.outline_pass.BorderEdgesOff()


def lines(component):
    component.outlines()
    component.outline_pass.SilhouetteEdgesOn()
    component.outline_pass.BorderEdgesOn()


def each_of(plotter, change):
    for component in plotter.exact_shadows.components:
        change(component)


def is_as_drawn(plotter):
    """Whether a mask is of the picture's pixels: nothing of PyVista's or VTK's changes these later."""
    renderer = plotter.renderer
    return (len(plotter.renderers) == 1 and renderer.GetPass().IsA("vtkShadowVolumePass") and
            not renderer.GetUseFXAA() and not plotter.render_window.GetStereoRender())


def lit(plotter):
    """The pixels that are in no light's shadow."""
    component = plotter.exact_shadows
    count = sum(1 for light in plotter.renderer.GetLights() if light.GetSwitch())
    found = np.full(SIZE[::-1], True)
    for index in range(count):
        found &= component.mask(index) == 255
    return found


def differing(one, other):
    return (one != other).any(axis=2)


class TestPyVista(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # An X server may start anew when its last window goes, and refuse the next one meanwhile.
        cls.window_that_stays = pv.Plotter(off_screen=True, window_size=(20, 20))
        cls.window_that_stays.render()

    @classmethod
    def tearDownClass(cls):
        cls.window_that_stays.close()

    def assert_same(self, ours, theirs, message):
        for one, other in zip(ours, theirs):
            self.assertEqual(one.shape, other.shape, message)
            self.assertEqual(int(differing(one, other).sum()), 0, message)

    def check(self, name):
        plotter = make_plotter(name)
        try:
            self.check_drawn(name, plotter)
        finally:
            plotter.close()

    def check_drawn(self, name, plotter):
        plain = pictures(plotter)
        seen = differing(plain[0], plain[0][:1, :1]).sum()
        self.assertGreater(int(seen), 1000, "there is nothing to see")
        lay_out_again(plotter)
        if any(differing(*pair).any() for pair in zip(pictures(plotter), plain)):
            self.skipTest("PyVista draws it differently each time")
        for change in (shadows_of_nothing, no_lines):
            each_of(plotter, change)
            self.assert_same(pictures(plotter), plain, change.__name__)
            each_of(plotter, off)
            self.assert_same(pictures(plotter), plain, f"off after {change.__name__}")
        each_of(plotter, shadows)
        shadowed = pictures(plotter)[0]
        self.check_shadows(name, plotter, shadowed, plain[0])
        each_of(plotter, lines)
        pictures(plotter)
        self.check_status(name, plotter)
        each_of(plotter, off)
        self.assert_same(pictures(plotter), plain, "off")

    def check_shadows(self, name, plotter, shadowed, plain):
        changed = differing(shadowed, plain)
        if name not in CASTS_NOTHING:
            self.assertGreater(int(changed.sum()), 100, "there is no shadow")
        if is_as_drawn(plotter):
            self.assertFalse((shadowed > plain).any(), "something is brighter in shadow")
            self.assertFalse((changed & lit(plotter)).any(), "something changes out of the shadows")

    def check_status(self, name, plotter):
        for component in plotter.exact_shadows.components:
            first, *remarks = component.status.splitlines()
            self.assertEqual(first, "shadows on; outlines on", remarks)
            if name in REMARKS:
                self.assertIn(REMARKS[name], "\n".join(remarks))
            else:
                self.assertEqual(remarks, [])


for name in SCENES:
    setattr(TestPyVista, f"test_{name}", lambda self, name=name: self.check(name))


if __name__ == "__main__":
    unittest.main()
