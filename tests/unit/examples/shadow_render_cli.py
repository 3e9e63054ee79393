#!/usr/bin/env python3
"""What shadow_render draws and reports.

    shadow_render_cli.py PROGRAM [UNITTEST-OPTION...]
"""

import json
import os
import pty
import subprocess
import unittest

import shadow_render_files as files
from shadow_render_case import FROM_ABOVE, PROGRAM, SILHOUETTES, CommandLine


class Drawing(CommandLine):
    def test_no_arguments_draw_the_built_in_scene(self):
        self.draw()
        self.assertEqual(os.listdir(self.folder.name).count("shadow.png"), 1)
        picture = self.picture("shadow.png")
        self.assertEqual((picture.width, picture.height, picture.channels), (1280, 720, 3))

    def test_help_goes_to_stdout(self):
        result = self.call("--help")
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertIn(b"--compositing", result.stdout)

    def test_only_asked_for_files_are_written(self):
        self.draw("cube.obj", "--output", "a.png", "--size", "64x48")
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["a.png", "cube.obj"])

    def test_mask_has_its_top_row_first(self):
        # The light travels to the right and, in the picture, down: the cube's shadow lies there.
        self.draw("cube.obj", "--mask", "mask.png", "--light", "directional:1,-1,1", *FROM_ABOVE)
        shadow = self.shadow("mask.png")
        self.assertIn((60 + 15, 45 + 15), shadow)
        self.assertFalse([p for p in shadow if p[0] < 52 or p[1] < 37], "shadow on the light's side")
        self.assertTrue(all(53 <= x < 83 and 38 <= y < 68 for x, y in shadow))

    def test_picture_and_mask_agree(self):
        self.draw("cube.obj", "--mask", "mask.png", "--light", "directional:1,-1,1", *FROM_ABOVE)
        picture = self.picture("shadow.png")
        dark, bright = picture.rows[60][3 * 75], picture.rows[30][3 * 45]
        self.assertLess(dark, 0.7 * bright)

    def test_several_lights_give_numbered_masks(self):
        self.draw("cube.obj", "--mask", "mask.png", "--light", "directional:1,-1,1",
                  "--light", "directional:-1,-1,-1", *FROM_ABOVE)
        self.assertFalse(os.path.exists(self.path("mask.png")))
        self.assertIn((75, 60), self.shadow("mask-0.png"))
        self.assertIn((45, 30), self.shadow("mask-1.png"))
        self.assertNotIn((45, 30), self.shadow("mask-0.png"))

    def test_frames_turn_the_light_once_round(self):
        self.draw("cube.obj", "--mask", "mask.png", "--frames", "4", "--light", "directional:1,-1,1", *FROM_ABOVE)
        corners = [(75, 60), (75, 30), (45, 30), (45, 60)]
        for frame, corner in enumerate(corners):
            self.assertEqual(self.picture(f"shadow-{frame:04}.png").width, 120)
            shadow = self.shadow(f"mask-{frame:04}.png")
            self.assertEqual([c for c in corners if c in shadow], [corner])
        self.assertFalse(os.path.exists(self.path("shadow-0004.png")))

    def test_frames_and_lights_together(self):
        self.draw("cube.obj", "--mask", "m.png", "--frames", "2", "--light", "point:3,5,3",
                  "--light", "spot:0,5,0,0,0,0,30", *FROM_ABOVE)
        for name in ("m-0000-0.png", "m-0000-1.png", "m-0001-0.png", "m-0001-1.png"):
            self.shadow(name)

    def test_methods_give_the_same_mask(self):
        masks = []
        for i, options in enumerate((["--stencil", "zpass"], ["--stencil", "zfail"], ["--stencil", "auto"],
                                     ["--compositing", "additive"],
                                     *(["--silhouette", name] for name in SILHOUETTES))):
            self.draw("cube.obj", "--mask", f"{i}.png", "--light", "point:-2,4,1", *options, *FROM_ABOVE)
            masks.append(self.shadow(f"{i}.png"))
        self.assertTrue(masks[0])
        self.assertTrue(all(mask == masks[0] for mask in masks))

    def test_floor_off(self):
        self.draw("cube.obj", "--floor", "off", "--mask", "mask.png", "--light", "directional:1,-1,1", *FROM_ABOVE)
        self.assertEqual(len(self.shadow("mask.png")), 0)

    def test_samples(self):
        self.draw("cube.obj", "--samples", "4", "--mask", "mask.png", "--light", "point:3,5,1", *FROM_ABOVE)
        values = {value for row in self.picture("mask.png").rows for value in row}
        self.assertTrue({0, 255} < values)

    def test_every_format_gives_the_same_shadow(self):
        contents = {"text.ply": files.ply_text(), "binary.ply": files.ply_binary(), "text.stl": files.stl_text(),
                    "binary.stl": files.stl_binary(), "a.vtp": files.vtp(), "poly.vtk": files.vtk_polydata(),
                    "grid.vtk": files.vtk_grid(), "a.gltf": files.gltf(), "a.glb": files.glb(), "UP.OBJ": files.obj()}
        options = ["--light", "point:-2,4,1", *FROM_ABOVE]
        self.draw("cube.obj", "--mask", "expected.png", *options)
        expected = self.shadow("expected.png")
        self.assertTrue(expected)
        for name, content in contents.items():
            with self.subTest(name):
                self.write(name, content)
                self.draw(name, "--mask", "mask.png", *options)
                self.assertEqual(self.shadow("mask.png"), expected)

    def test_models_are_shown_together(self):
        self.write("other.obj", files.obj([(x - 2, y, z) for x, y, z in files.POINTS]))
        self.draw("cube.obj", "other.obj", "--mask", "mask.png", "--light", "directional:0,-1,1", *FROM_ABOVE)
        shadow = self.shadow("mask.png")
        self.assertIn((60, 60), shadow)
        self.assertIn((30, 60), shadow)
        self.assertNotIn((45, 60), shadow)


class Reporting(CommandLine):
    def report(self, *arguments):
        self.draw(*arguments, "--report", "report.json", "--size", "120x90")
        with open(self.path("report.json"), encoding="utf-8") as file:
            return json.load(file)

    def test_report_holds_scene_and_statistics(self):
        report = self.report("cube.obj", "--light", "point:3,5,3", "--floor", "off", "--stencil", "zfail",
                             "--compositing", "additive")
        self.assertEqual(report["program"], "shadow_render")
        self.assertRegex(report["version"], r"^\d+\.\d+\.\d+$")
        for key in ("vtk", "glVendor", "glRenderer", "glVersion"):
            self.assertTrue(report["system"][key], key)
        self.assertEqual(report["size"], [120, 90])
        self.assertEqual(report["models"], [{"file": "cube.obj", "triangles": 12}])
        self.assertIs(report["floor"], False)
        self.assertEqual(report["settings"], {"stencil": "zfail", "silhouette": "auto",
                                              "compositing": "additive", "samples": 1})
        self.assertEqual(report["camera"]["projection"], "perspective")
        (frame,) = report["frames"]
        self.assertEqual(frame["picture"], "shadow.png")
        self.assertEqual(frame["lights"], [{"kind": "point", "position": [3, 5, 3]}])
        self.assertEqual((frame["status"], frame["message"]), ("ok", ""))
        self.assertEqual(frame["shadowLights"], 1)
        self.assertEqual(frame["casters"]["drawn"] + len(frame["casters"]["skipped"]), 1)
        self.assertEqual(frame["casters"]["foundBy"], {"brute-force": frame["casters"]["drawn"]})
        triangles = frame["triangles"]
        self.assertEqual(triangles["total"],
                         triangles["ambient"] + triangles["sides"] + triangles["caps"] + triangles["lighting"])
        self.assertEqual(set(frame["milliseconds"]),
                         {"scene", "silhouette", "prePass", "stencil", "lighting", "frame"})
        self.assertGreater(frame["memoryBytes"], 0)
        self.assertGreater(frame["silhouetteEdges"], 0)

    def test_report_names_the_silhouette_method(self):
        for name in SILHOUETTES:
            report = self.report("cube.obj", "--silhouette", name)
            self.assertEqual(report["settings"]["silhouette"], name)
            self.assertEqual(report["frames"][0]["status"], "ok")
            self.assertGreater(report["frames"][0]["triangles"]["sides"], 0)

    def test_report_has_an_entry_for_each_frame(self):
        report = self.report("cube.obj", "--frames", "3", "--mask", "mask.png")
        self.assertEqual([frame["picture"] for frame in report["frames"]],
                         ["shadow-0000.png", "shadow-0001.png", "shadow-0002.png"])
        self.assertEqual(report["frames"][2]["masks"], ["mask-0002.png"])

    def test_progress_on_a_terminal_only(self):
        try:
            ours, theirs = pty.openpty()
        except OSError as error:
            self.skipTest(f"no terminal: {error}")
        subprocess.run([PROGRAM, "cube.obj", "--frames", "2", "--size", "64x48"], cwd=self.folder.name,
                       stderr=theirs, check=True, timeout=120)
        os.close(theirs)
        text = os.read(ours, 65536).decode()
        os.close(ours)
        self.assertIn("frame 2 of 2", text)
        self.assertTrue(text.endswith("\r\x1b[K"), "the line is cleared at the end")


if __name__ == "__main__":
    unittest.main()
