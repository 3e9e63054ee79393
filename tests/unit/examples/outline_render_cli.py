#!/usr/bin/env python3
"""What outline_render draws and reports, and how it refuses what it cannot do.

    outline_render_cli.py PROGRAM [UNITTEST-OPTION...]
"""

import json
import os
import resource
import unittest

import shadow_render_files as files
from shadow_render_case import FROM_ABOVE, CommandLine

# Of the camera FROM_ABOVE: the top of the cube fills the pixels 52 to 67 across and 37 to 52 down, to half a pixel, so
# that a line narrower than two pixels covers one.
ALONE = ["--floor", "off", *FROM_ABOVE]
THIN = ["--width", "1.5", *ALONE]


def ring(left, top, right, bottom):
    across = {(x, y) for x in range(left, right + 1) for y in (top, bottom)}
    return across | {(x, y) for x in (left, right) for y in range(top, bottom + 1)}


class Outlines(CommandLine):
    def lines(self, name):
        mask = self.picture(name)
        self.assertEqual((mask.width, mask.height, mask.channels), (120, 90, 1))
        line = mask.having(255)
        self.assertEqual(len(line) + len(mask.having(0)), 120 * 90, "a mask knows line and no line")
        return line

    def draw_lines(self, *arguments):
        self.draw(*arguments, "--mask", "mask.png")
        return self.lines("mask.png")


class Drawing(Outlines):
    def test_no_arguments_draw_the_built_in_scene(self):
        self.draw()
        picture = self.picture("outline.png")
        self.assertEqual((picture.width, picture.height, picture.channels), (1280, 720, 3))
        black = sum(row[i:i + 3] == b"\0\0\0" for row in picture.rows for i in range(0, len(row), 3))
        self.assertGreater(black, 3000)

    def test_help_goes_to_stdout(self):
        result = self.call("--help")
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        for option in (b"--width", b"--colour", b"--crease", b"--hidden", b"--with-shadows", b"--mask", b"--camera"):
            self.assertIn(option, result.stdout)

    def test_only_asked_for_files_are_written(self):
        self.draw("cube.obj", "--output", "a.png", "--size", "64x48")
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["a.png", "cube.obj"])

    def test_mask_is_the_outline(self):
        self.assertEqual(self.draw_lines("cube.obj", *THIN), ring(52, 37, 67, 52))

    def test_mask_has_its_top_row_first(self):
        self.write("below.obj", files.obj([(x, y, z + 1) for x, y, z in files.POINTS]))
        self.assertEqual(self.draw_lines("below.obj", *THIN), ring(52, 52, 67, 67))

    def test_width(self):
        thin = self.draw_lines("cube.obj", *THIN)
        wide = self.draw_lines("cube.obj", *ALONE, "--width", "5")
        self.assertLess(thin, wide)
        self.assertIn((50, 45), wide)
        self.assertNotIn((49, 45), wide)
        self.assertIn((54, 45), wide)
        self.assertNotIn((55, 45), wide)

    def test_colour(self):
        self.draw("cube.obj", *ALONE, "--width", "3", "--colour", "1,0.2,0")
        picture = self.picture("outline.png")
        self.assertEqual(picture.pixel(52, 45), (255, 51, 0))
        self.assertNotEqual(picture.pixel(60, 45), (255, 51, 0))

    def test_creases_only_when_asked_for(self):
        # A roof, its ridge along z at x = 0.
        points = [(-1, 0, -1), (-1, 0, 1), (0, 0.5, -1), (0, 0.5, 1), (1, 0, -1), (1, 0, 1)]
        self.write("roof.obj", files.obj(points, [(0, 1, 3, 2), (2, 3, 5, 4)]))
        ridge = {(60, y) for y in range(32, 58)}
        self.assertFalse(ridge & self.draw_lines("roof.obj", *THIN))
        self.assertFalse(ridge & self.draw_lines("roof.obj", *THIN, "--crease", "60"))
        self.assertLess(ridge, self.draw_lines("roof.obj", *ALONE, "--width", "2.5", "--crease", "50"))

    def test_hidden_lines_are_in_the_picture_and_not_in_the_mask(self):
        # A sheet below the cube's top.
        sheet = [(-0.3, 0.5, -0.3), (-0.3, 0.5, 0.3), (0.3, 0.5, 0.3), (0.3, 0.5, -0.3)]
        self.write("sheet.obj", files.obj(sheet, [(0, 1, 2, 3)]))
        plain = self.draw_lines("cube.obj", "sheet.obj", *THIN)
        without = self.picture("outline.png")
        self.assertEqual(self.draw_lines("cube.obj", "sheet.obj", *THIN, "--hidden"), plain)
        hidden = self.picture("outline.png")
        inside = [(x, 45) for x in range(54, 60)]
        self.assertTrue(any(without.pixel(*p) != hidden.pixel(*p) for p in inside))
        self.assertEqual(without.pixel(60, 45), hidden.pixel(60, 45))

    def test_shadows_are_below_the_lines(self):
        options = ["cube.obj", *FROM_ABOVE, "--light", "directional:1,-1,1"]
        plain = self.draw_lines(*options)
        bright = self.picture("outline.png").pixel(75, 60)
        for more in ([], ["--compositing", "additive"], ["--silhouette", "topology-aware-mesh"],
                     ["--stencil", "zfail"]):
            self.assertEqual(self.draw_lines(*options, "--with-shadows", *more), plain)
            picture = self.picture("outline.png")
            self.assertLess(picture.pixel(75, 60)[0], 0.7 * bright[0])
            self.assertEqual(picture.pixel(52, 45), (0, 0, 0))

    def test_frames_turn_the_light_and_leave_the_lines(self):
        self.draw("cube.obj", *THIN, "--mask", "mask.png", "--frames", "3", "--with-shadows")
        for frame in range(3):
            self.assertEqual(self.picture(f"outline-{frame:04}.png").width, 120)
            self.assertEqual(self.lines(f"mask-{frame:04}.png"), ring(52, 37, 67, 52))

    def test_several_lights_have_one_mask(self):
        self.draw("cube.obj", *THIN, "--mask", "mask.png", "--light", "point:1,3,1", "--light", "point:-1,3,1")
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["cube.obj", "mask.png", "outline.png"])

    def test_every_format_gives_the_same_lines(self):
        contents = {"text.ply": files.ply_text(), "binary.ply": files.ply_binary(), "text.stl": files.stl_text(),
                    "binary.stl": files.stl_binary(), "a.vtp": files.vtp(), "poly.vtk": files.vtk_polydata(),
                    "grid.vtk": files.vtk_grid(), "a.gltf": files.gltf(), "a.glb": files.glb(), "UP.OBJ": files.obj()}
        for name, content in contents.items():
            with self.subTest(name):
                self.write(name, content)
                self.assertEqual(self.draw_lines(name, *THIN), ring(52, 37, 67, 52))


class Reporting(Outlines):
    def report(self, *arguments):
        self.draw(*arguments, "--report", "report.json", *THIN)
        with open(self.path("report.json"), encoding="utf-8") as file:
            return json.load(file)

    def test_report_holds_settings_and_statistics(self):
        report = self.report("cube.obj", "--crease", "30", "--mask", "mask.png")
        self.assertEqual(report["program"], "outline_render")
        self.assertEqual(report["models"], [{"file": "cube.obj", "triangles": 12}])
        self.assertEqual(report["settings"],
                         {"width": 1.5, "colour": [0, 0, 0], "crease": 30, "hidden": False, "shadows": None})
        (frame,) = report["frames"]
        self.assertEqual((frame["status"], frame["message"], frame["skipped"]), ("ok", "", []))
        self.assertEqual(frame["masks"], ["mask.png"])
        self.assertEqual(frame["edges"], 12)
        self.assertGreaterEqual(frame["triangles"]["depth"], 6)
        self.assertGreater(frame["triangles"]["lines"], 0)
        self.assertEqual(set(frame["milliseconds"]), {"scene", "edges", "depth", "lines", "blend", "frame"})
        self.assertNotIn("shadows", frame)

    def test_report_with_shadows(self):
        report = self.report("cube.obj", "--with-shadows", "--silhouette", "hybrid")
        self.assertIsNone(report["settings"]["crease"])
        self.assertEqual(report["settings"]["shadows"]["silhouette"], "hybrid")
        self.assertEqual(report["frames"][0]["shadows"]["status"], "ok")


class Refusing(CommandLine):
    def test_unknown_options_and_values(self):
        self.refuse("allowed: --help, --output", "--color", "red")
        self.refuse("from 0.5 to 64", "--width", "0")
        self.refuse("from 0.5 to 64", "--width", "65")
        self.refuse("--width", "--width", "nan")
        self.refuse("--width", "--width", "2px")
        self.refuse("--width", "--width")
        self.refuse("--colour", "--colour", "red")
        self.refuse("--colour", "--colour", "1,2")
        self.refuse("from 0 to 1", "--colour", "255,0,0")
        self.refuse("from 0 to 1", "--colour", "0,-0.1,0")
        self.refuse("from 0 to 180", "--crease", "-1")
        self.refuse("from 0 to 180", "--crease", "181")
        self.refuse("hidden", "--hidden=perhaps")
        self.refuse("--mask", "--mask", "--hidden")

    def test_options_of_shadows_need_shadows(self):
        for option in (["--stencil", "zfail"], ["--silhouette", "auto"], ["--compositing", "mask"], ["--samples", "4"]):
            self.refuse("needs --with-shadows", "cube.obj", *option)

    def test_targets_and_models(self):
        self.refuse("no folder", "cube.obj", "--output", "missing/a.png")
        self.refuse("does not end in .png", "cube.obj", "--mask", "mask.tif")
        self.refuse("two outputs", "cube.obj", "--mask", "./outline.png")
        self.refuse("take the place of a model", "cube.obj", "--report", "cube.obj")
        self.refuse("no such file", "missing.obj")
        self.write("short.ply", files.ply_text()[:-30])
        self.refuse("short.ply", "short.ply")
        self.refuse("over the limit of this GL", "cube.obj", "--size", "1000000x90")

    def test_disk_that_is_full_leaves_no_part_of_a_file(self):
        def few_bytes():
            resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512))
        self.refuse("cannot be written", "cube.obj", "--size", "640x480", preexec_fn=few_bytes)


if __name__ == "__main__":
    unittest.main()
