"""examples/viewer.py on a display: every slider, dragged with the mouse, changes the picture.

Usage: test_viewer.py [-v] [TestViewer.test_NAME]
"""

import os
import pathlib
import sys
import tempfile
import unittest

from scenes import differing, np, pv

if not os.environ.get("DISPLAY"):
    print("there is no display to test the viewer on")
    sys.exit(0)

EXAMPLES = pathlib.Path(__file__).resolve().parents[3] / "examples"
sys.path.insert(0, str(EXAMPLES))

import viewer

SIZE = (500, 350)
SLIDERS = ("azimuth", "height", "intensity", "samples", "outlines")


class TestViewer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.window_that_stays = pv.Plotter(off_screen=True, window_size=(20, 20))
        cls.window_that_stays.screenshot(None, return_img=True)

    @classmethod
    def tearDownClass(cls):
        cls.window_that_stays.close()

    def setUp(self):
        self.viewer = viewer.Viewer(viewer.built_in(), window_size=SIZE)
        self.plotter = self.viewer.plotter
        self.plotter.show(interactive=False, auto_close=False)

    def tearDown(self):
        self.plotter.close()

    def picture(self):
        """Right of the sliders."""
        self.plotter.render()
        return np.array(self.plotter.screenshot(None, return_img=True)).astype(int)[:, int(SIZE[0] * 0.3):]

    def drag(self, name, to):
        """Takes the slider's handle, and lets go of it at a share of the way."""
        look = self.viewer.sliders[name]
        first, last = (np.array(point.GetValue()[:2]) * SIZE
                       for point in (look.GetPoint1Coordinate(), look.GetPoint2Coordinate()))
        inset = np.array([look.GetSliderLength() * SIZE[0] / 2, 0])  # the handle is within the bar
        share = (look.GetValue() - look.GetMinimumValue()) / (look.GetMaximumValue() - look.GetMinimumValue())
        interactor = self.plotter.iren.interactor
        for event, at in (("MouseMove", share), ("LeftButtonPress", share), ("MouseMove", to), ("LeftButtonRelease", to)):
            x, y = first + inset + at * (last - first - 2 * inset)
            interactor.SetEventInformation(round(x), round(y), 0, 0, "\0", 0, None)
            interactor.InvokeEvent(event + "Event")

    def test_it_starts_with_shadows_and_outlines(self):
        picture = self.picture()
        self.assertEqual(self.plotter.exact_shadows.status, "shadows on; outlines on")
        self.plotter.exact_shadows.disable()
        self.assertGreater(int(differing(picture, self.picture()).sum()), 1000)

    def test_there_are_no_other_sliders(self):
        self.assertEqual(sorted(self.viewer.sliders), sorted(SLIDERS))

    def test_each_slider_changes_the_picture(self):
        for name in SLIDERS:
            with self.subTest(name):
                before, value, others = self.picture(), self.viewer.values[name], dict(self.viewer.values)
                self.drag(name, 0.05)  # more samples than there are at first not every GL has
                self.assertNotEqual(self.viewer.values[name], value)
                self.assertEqual({**others, name: self.viewer.values[name]}, self.viewer.values)
                self.assertGreater(int(differing(before, self.picture()).sum()), 50)

    def test_nothing_is_left_of_shadows_without_intensity(self):
        self.drag("intensity", 0)
        picture = self.picture()
        self.plotter.exact_shadows.disable()
        self.assertEqual(int(differing(picture, self.picture()).sum()), 0)

    def test_outlines_go_off_at_the_low_end(self):
        self.drag("outlines", 0)
        self.picture()
        self.assertEqual(self.plotter.exact_shadows.status, "shadows on; outlines off")

    def test_samples_are_those_of_the_list(self):
        for place, samples in enumerate(viewer.SAMPLES):
            self.drag("samples", place / (len(viewer.SAMPLES) - 1))
            self.assertEqual(self.plotter.exact_shadows.settings["samples"], samples)
            self.assertEqual(self.viewer.sliders["samples"].GetTitleText(), f"samples: {samples}")

    def test_it_shows_a_mesh_of_the_users(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "mesh.vtp")
            pv.Cone(resolution=40).scale(100).save(file)
            shown = viewer.Viewer(pv.read(file), window_size=SIZE)
        shown.plotter.show(interactive=False, auto_close=False)
        try:
            mask = shown.plotter.exact_shadows.mask(0)
            self.assertTrue(0.01 < (mask == 0).mean() < 0.5)
        finally:
            shown.plotter.close()


if __name__ == "__main__":
    unittest.main()
