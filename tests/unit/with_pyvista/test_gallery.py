"""What the gallery in examples/pyvista promises: pictures in which shadows darken, and nothing else.

Usage: test_gallery.py FOLDER [-v]      FOLDER: where the gallery is drawn to, without a display
"""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest
import warnings

EXAMPLES = pathlib.Path(__file__).resolve().parents[3] / "examples" / "pyvista"
FOLDER = pathlib.Path(sys.argv.pop(1)).resolve()

os.environ["DISPLAY"] = ""  # as on a server; the other tests are about displays
sys.path.insert(0, str(EXAMPLES))
try:
    import without_display  # noqa: F401  before PyVista
except ImportError as error:
    if "cannot draw" not in str(error):
        raise
    print(f"there is no drawing without a display: {error}")
    sys.exit(0)

from scenes import differing, np, pv

import gallery

SMALL = (320, 240)


def read(file):
    image = pv.read(file)
    width, height, _ = image.dimensions
    return image.active_scalars.reshape(height, width, -1)[::-1, :, :3].astype(int)


class TestScenes(unittest.TestCase):
    """Each scene: as it is, with shadows alone, and plain."""

    @classmethod
    def setUpClass(cls):
        cls.drawn, cls.kept = {}, []
        for name in gallery.SCENES:
            with warnings.catch_warnings():
                warnings.simplefilter("error")  # nothing in a script that PyVista will take away
                plotter = gallery.build(name, SMALL)
            cls.kept.append(plotter)
            pictures = {"ours": gallery.picture(plotter), "status": plotter.exact_shadows.all.status,
                        "lights": len(plotter.renderer.lights)}
            plotter.exact_shadows.all.outlines(None)
            pictures["shadows"] = gallery.picture(plotter)
            gallery.turn_off(plotter)
            pictures["plain"] = gallery.picture(plotter)
            cls.drawn[name] = {key: value.astype(int) if isinstance(value, np.ndarray) else value
                               for key, value in pictures.items()}

    @classmethod
    def tearDownClass(cls):
        for plotter in cls.kept:
            plotter.close()

    def each(self, judge):
        for name, pictures in self.drawn.items():
            with self.subTest(name):
                judge(pictures)

    def test_there_are_twelve_and_all_scripts_are_among_them(self):
        scripts = {file.stem for file in EXAMPLES.glob("*.py")} - {"gallery", "without_display"}
        self.assertEqual(scripts, set(gallery.SCENES))
        self.assertEqual(len(gallery.SCENES), 12)

    def test_shadows_only_darken(self):
        self.each(lambda pictures: self.assertEqual(
            int((pictures["shadows"] > pictures["plain"]).any(axis=2).sum()), 0))

    def test_something_is_in_shadow(self):
        def judge(pictures):
            darker = (pictures["plain"] - pictures["shadows"]).max(axis=2) > 10
            self.assertTrue(0.02 < darker.mean() < 0.6, f"{darker.mean():.1%}")
        self.each(judge)

    def test_much_is_as_it_was(self):
        self.each(lambda pictures: self.assertLess(
            float(differing(pictures["plain"], pictures["shadows"]).mean()), 0.6))

    def test_outlines_are_what_else_there_is(self):
        def judge(pictures):
            lines = differing(pictures["ours"], pictures["shadows"])
            self.assertEqual("outlines on" in pictures["status"], bool(lines.any()))
            self.assertLess(float(lines.mean()), 0.2)
        self.each(judge)

    def test_nothing_is_left_out(self):
        for name, pictures in self.drawn.items():
            remarks = [line for line in pictures["status"].splitlines() if not line.startswith("shadows o")]
            # A bulb shines, and no light falls on it.
            self.assertEqual(bool(remarks), name == "point_light", remarks)

    def test_the_gltf_file_brings_its_lights(self):
        self.assertEqual(self.drawn["gltf"]["lights"], 3, "two of the file's, and a headlight")


class TestCommand(unittest.TestCase):
    """One command draws all of it."""

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        cls.run_ = subprocess.run([sys.executable, "-B", str(EXAMPLES / "gallery.py"), str(FOLDER)],
                                  capture_output=True, text=True)

    def test_it_ends_well(self):
        self.assertEqual(self.run_.returncode, 0, self.run_.stderr)
        self.assertEqual(self.run_.stdout.splitlines()[-1], str(FOLDER / "index.html"))

    def test_it_writes_the_page_and_the_pictures_and_nothing_else(self):
        pictures = [f"{name}{kind}.png" for name in gallery.SCENES for kind in ("", "-plain")]
        self.assertEqual(sorted(file.name for file in FOLDER.iterdir()), sorted([*pictures, "index.html"]))

    def test_pictures_show_something(self):
        for name in gallery.SCENES:
            with self.subTest(name):
                ours, plain = read(FOLDER / f"{name}.png"), read(FOLDER / f"{name}-plain.png")
                for picture in (ours, plain):
                    self.assertEqual(picture.shape, (gallery.SIZE[1], gallery.SIZE[0], 3))
                    self.assertGreater(len(np.unique(picture.reshape(-1, 3), axis=0)), 50)
                self.assertGreater(float(differing(ours, plain).mean()), 0.02)

    def test_a_script_runs_by_itself(self):
        for name in gallery.SCENES:
            with self.subTest(name):
                alone = subprocess.run([sys.executable, "-B", str(EXAMPLES / f"{name}.py")], capture_output=True, text=True)
                self.assertEqual(alone.returncode, 0, alone.stderr)
                # VTK from 9.4 on warns that it looked for a display.
                self.assertNotRegex(alone.stderr, r"Traceback|[A-Za-z]Warning|ERR\|")


if __name__ == "__main__":
    unittest.main()
