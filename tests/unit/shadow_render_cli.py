#!/usr/bin/env python3
"""The command line of shadow_render from the outside: what it writes, and how it refuses.

    shadow_render_cli.py PROGRAM [UNITTEST-OPTION...]
"""

import json
import os
import pty
import resource
import subprocess
import sys
import tempfile
import unittest

import shadow_render_files as files

PROGRAM = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else "shadow_render"

# From straight above, the x axis to the right and the z axis down; 15 pixels are one unit of the scene.
FROM_ABOVE = ["--size", "120x90", "--camera", "0,10,0,0,0,0,0,0,-1,30", "--parallel", "3"]


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.write("cube.obj", files.obj())

    def write(self, name, content):
        with open(os.path.join(self.folder.name, name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def call(self, *arguments, **options):
        return subprocess.run([PROGRAM, *arguments], cwd=self.folder.name, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=120, **options)

    def draw(self, *arguments):
        result = self.call(*arguments)
        self.assertEqual((result.returncode, result.stderr), (0, b""), arguments)

    def picture(self, name):
        return files.Picture(self.path(name))

    def shadow(self, name):
        mask = self.picture(name)
        self.assertEqual((mask.width, mask.height, mask.channels), (120, 90, 1))
        return mask.shadow()

    def refuse(self, part, *arguments, **options):
        """One line that says why, a non-zero exit, and no file more than before."""
        before = sorted(os.listdir(self.folder.name))
        result = self.call(*arguments, **options)
        with self.subTest(arguments=arguments):
            text = result.stderr.decode()
            self.assertGreater(result.returncode, 0, text)
            self.assertRegex(text, r"\Ashadow_render: [ -~]+\n\Z")
            self.assertIn(part, text)
            self.assertEqual(result.stdout, b"")
            self.assertEqual(sorted(os.listdir(self.folder.name)), before)


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
                                     ["--compositing", "additive"], ["--silhouette", "brute-force"])):
            self.draw("cube.obj", "--mask", f"{i}.png", "--light", "point:-2,4,1", *options, *FROM_ABOVE)
            masks.append(self.shadow(f"{i}.png"))
        self.assertTrue(masks[0])
        self.assertTrue(all(mask == masks[0] for mask in masks))

    def test_floor_off(self):
        self.draw("cube.obj", "--floor", "off", "--mask", "mask.png", "--light", "directional:1,-1,1", *FROM_ABOVE)
        self.assertFalse(self.shadow("mask.png"))

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
        self.assertEqual(report["settings"], {"stencil": "zfail", "silhouette": "brute-force",
                                              "compositing": "additive", "samples": 1})
        self.assertEqual(report["camera"]["projection"], "perspective")
        (frame,) = report["frames"]
        self.assertEqual(frame["picture"], "shadow.png")
        self.assertEqual(frame["lights"], [{"kind": "point", "position": [3, 5, 3]}])
        self.assertEqual((frame["status"], frame["message"]), ("ok", ""))
        self.assertEqual(frame["shadowLights"], 1)
        self.assertEqual(frame["casters"]["drawn"] + len(frame["casters"]["skipped"]), 1)
        triangles = frame["triangles"]
        self.assertEqual(triangles["total"],
                         triangles["ambient"] + triangles["sides"] + triangles["caps"] + triangles["lighting"])
        self.assertEqual(set(frame["milliseconds"]),
                         {"scene", "silhouette", "prePass", "stencil", "lighting", "frame"})
        self.assertGreater(frame["memoryBytes"], 0)
        self.assertGreater(frame["silhouetteEdges"], 0)

    def test_report_has_an_entry_for_each_frame(self):
        report = self.report("cube.obj", "--frames", "3", "--mask", "mask.png")
        self.assertEqual([frame["picture"] for frame in report["frames"]],
                         ["shadow-0000.png", "shadow-0001.png", "shadow-0002.png"])
        self.assertEqual(report["frames"][2]["masks"], ["mask-0002.png"])

    def test_progress_on_a_terminal_only(self):
        ours, theirs = pty.openpty()
        subprocess.run([PROGRAM, "cube.obj", "--frames", "2", "--size", "64x48"], cwd=self.folder.name,
                       stderr=theirs, check=True, timeout=120)
        os.close(theirs)
        text = os.read(ours, 65536).decode()
        os.close(ours)
        self.assertIn("frame 2 of 2", text)
        self.assertTrue(text.endswith("\r\x1b[K"), "the line is cleared at the end")


class Refusing(CommandLine):
    def test_unknown_options_and_values(self):
        self.refuse("allowed: --help, --output", "--colour", "red")
        self.refuse("allowed: auto, zpass, zfail", "--stencil", "both")
        self.refuse("allowed: brute-force", "--silhouette", "gpu")
        self.refuse("allowed: mask, additive", "--compositing", "both")
        self.refuse("allowed: off, on", "--floor", "perhaps")
        self.refuse("--samples", "--samples", "0")
        self.refuse("--frames", "--frames", "0")
        self.refuse("--parallel", "--parallel", "0")
        self.refuse("--output", "--output")

    def test_sizes(self):
        self.refuse("1 or more", "--size", "0x90")
        self.refuse("1 or more", "--size", "120x-1")
        self.refuse("over the limit of this GL", "cube.obj", "--size", "1000000x90")
        self.refuse("over the limit of this GL", "cube.obj", "--size", "90x1000000")

    def test_lights(self):
        self.refuse("no direction", "--light", "directional:0,0,0")
        self.refuse("same", "--light", "spot:1,1,1,1,1,1,30")
        self.refuse("cone", "--light", "spot:0,5,0,0,0,0,0")
        self.refuse("not finite", "--light", "point:nan,0,0")
        self.refuse("allowed: point, directional, spot", "--light", "lamp:1,2,3")
        self.refuse("reaches nothing", "cube.obj", "--light", "spot:0,5,0,0,9,0,30")
        self.refuse("reaches nothing", "cube.obj", "--floor", "off", "--light", "spot:0,5,0,9,0,9,5")

    def test_cameras(self):
        self.refuse("view direction", "--camera", "1,1,1,1,1,1,0,1,0,30")
        self.refuse("view-up", "--camera", "0,5,0,0,0,0,0,1,0,30")
        self.refuse("view angle", "--camera", "0,5,9,0,0,0,0,1,0,180")

    def test_targets(self):
        os.mkdir(self.path("folder.png"))
        self.refuse("no folder", "cube.obj", "--output", "missing/a.png")
        self.refuse("no folder", "cube.obj", "--report", "missing/r.json")
        self.refuse("is a folder", "cube.obj", "--output", "folder.png")
        self.refuse("does not end in .png", "cube.obj", "--output", "a.jpg")
        self.refuse("does not end in .png", "cube.obj", "--mask", "mask.tif")
        self.refuse("two outputs", "cube.obj", "--mask", "./shadow.png")
        self.refuse("take the place of a model", "cube.obj", "--report", "cube.obj")

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_folder_without_permission(self):
        os.mkdir(self.path("closed"), 0o555)
        self.refuse("may not be written to", "cube.obj", "--output", "closed/a.png")

    def test_disk_that_is_full_leaves_no_part_of_a_file(self):
        def few_bytes():
            resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512))
        self.refuse("cannot be written", "cube.obj", "--size", "640x480", preexec_fn=few_bytes)

    def test_failed_second_output_keeps_the_first(self):
        # the picture is small enough, the report is not
        def few_bytes():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1024, 1024))
        result = self.call("cube.obj", "--size", "4x4", "--report", "r.json", preexec_fn=few_bytes)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["cube.obj", "shadow.png"])

    def test_models_that_are_no_models(self):
        os.mkdir(self.path("folder.obj"))
        self.write("noise.xyz", "0 0 0")
        self.refuse("no such file", "missing.obj")
        self.refuse("is not a file", "folder.obj")
        self.refuse("known: obj, ply, stl, vtp, vtk, gltf, glb", "noise.xyz")
        self.refuse("known: obj", "cube")
        self.refuse("no such file", "cube.obj", "missing.obj")

    def test_damaged_models(self):
        noise = bytes((i * i * 31 + 7 * i) % 251 for i in range(3000))
        for extension in ("obj", "ply", "stl", "vtp", "vtk", "gltf", "glb"):
            self.write("noise." + extension, noise)
            self.refuse("noise." + extension, "noise." + extension)
            self.write("empty." + extension, "")
            self.refuse("is empty", "empty." + extension)
        self.write("text.obj", "this is\nno mesh\n")
        self.refuse("no triangles", "text.obj")
        # each of these makes a reader of VTK 9.1 crash, hang or read foreign memory
        self.write("short.ply", files.ply_text()[:-30])
        self.write("short-binary.ply", files.ply_binary()[:-30])
        self.write("short.stl", files.stl_text()[:-90])
        self.write("short-binary.stl", files.stl_binary()[:-30])
        self.write("short.vtp", files.vtp()[:-60])
        self.write("short.vtk", files.vtk_polydata()[:-30])
        self.write("short.gltf", files.gltf()[:-30])
        self.write("short.glb", files.glb()[:-30])
        self.write("normals.obj", files.obj() + "f 1//50000000 2//50000000 3//50000000\n")
        self.write("buffer.gltf", json.dumps(files.gltf_document(uri="missing.bin")[0]))
        for name in sorted(os.listdir(self.folder.name)):
            if name.startswith(("short", "normals", "buffer")):
                self.refuse(name, name)

    def test_glTF_node_that_is_its_own_child(self):
        document = files.gltf_document()[0]
        document["nodes"][1]["children"] = [1]
        self.write("cycle.gltf", json.dumps(document))
        self.refuse("damaged", "cycle.gltf")

    def test_points_that_are_missing_or_not_finite(self):
        self.write("index.obj", files.obj(faces=[(0, 1, 99)]))
        self.write("index.vtk", files.vtk_polydata().replace("4 0 1 3 2", "4 0 1 3 77"))
        self.write("index.vtp", files.vtp().replace(">0 1 3 2", ">0 1 3 77"))
        self.write("index-grid.vtk", files.vtk_grid().replace("8 0 4", "8 99 4"))
        for name in ("index.obj", "index.vtk", "index.vtp", "index-grid.vtk"):
            self.refuse("does not exist", name)
        for value in ("nan", "inf", "1e999"):
            self.write("value.obj", files.obj([(value, 0, 0)] + files.POINTS[1:]))
            self.refuse("point 1 is not finite", "value.obj")
        self.write("far.obj", files.obj([("1e30", 0, 0)] + files.POINTS[1:]))
        self.refuse("too far away", "far.obj")

    def test_models_without_triangles_or_area(self):
        self.write("points.obj", files.obj(faces=[]))
        self.refuse("no triangles", "points.obj")
        self.write("line.vtk", files.vtk_header("POLYDATA") + "LINES 1 3\n2 0 1\n")
        self.refuse("no triangles", "line.vtk")
        self.write("flat.obj", files.obj([(i, 0, 0) for i in range(8)]))
        self.refuse("no triangle that has an area", "flat.obj")


if __name__ == "__main__":
    unittest.main()
