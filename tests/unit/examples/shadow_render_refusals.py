#!/usr/bin/env python3
"""How shadow_render refuses what it cannot do.

    shadow_render_refusals.py PROGRAM [UNITTEST-OPTION...]
"""

import json
import os
import resource
import unittest

import shadow_render_files as files
from shadow_render_case import CommandLine


class Refusing(CommandLine):
    def test_unknown_options_and_values(self):
        self.refuse("allowed: --help, --output", "--colour", "red")
        self.refuse("allowed: auto, zpass, zfail", "--stencil", "both")
        self.refuse("allowed: auto, brute-force, edge-buffer, ", "--silhouette", "gpu")
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

    def test_large_picture(self):
        """Told what it takes before it is drawn, or refused where the machine has not that much."""
        if os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") < 28e9:
            self.refuse("of memory, and this machine has", "cube.obj", "--size", "16384x16384", "--samples", "4")
        result = self.call("cube.obj", "--size", "8192x4096")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(b"--size: a picture of 8192x4096 takes about", result.stderr)
        self.assertEqual(self.call("cube.obj", "--size", "640x480").stderr, b"")

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
        self.write("relative.obj", files.obj() + "f -1 -2 -9\n")
        self.write("buffer.gltf", json.dumps(files.gltf_document(uri="missing.bin")[0]))
        for name in sorted(os.listdir(self.folder.name)):
            if name.startswith(("short", "normals", "relative", "buffer")):
                self.refuse(name, name)

    def test_text_STL_names_the_line(self):
        for before, after, words in (("outer loop", "outline", 'line 3: "outer" expected, not "outline"'),
                                     ("endloop", "vertex 0 0 0", 'line 7: "endloop" expected, not "vertex"'),
                                     ("endsolid cube", "", 'ends where "endsolid" is expected'),
                                     ("endfacet\nfacet", "facet", 'line 8: "endfacet" expected, not "facet"')):
            self.write("mesh.stl", files.stl_text().replace(before, after, 1))
            self.refuse(words, "mesh.stl")

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
            self.refuse("line 1: point 1 is not finite", "value.obj")
            self.write("value.ply", files.ply_text().replace("\n-0.5", "\n" + value, 1))
            self.refuse("point 1 is not finite", "value.ply")
            self.write("value.stl", files.stl_text().replace("vertex -0.5", "vertex " + value, 1))
            self.refuse("line 4: point 1 is not finite", "value.stl")
        # VTK's readers would take these for 0
        self.write("word.obj", files.obj([("zero", 0, 0)] + files.POINTS[1:]))
        self.refuse("line 1: a point needs three numbers", "word.obj")
        self.write("word.stl", files.stl_text().replace("vertex -0.5", "vertex zero", 1))
        self.refuse("line 4: a point needs three numbers", "word.stl")
        self.write("few.obj", files.obj([(0, 0)] + files.POINTS[1:]))
        self.refuse("line 1: a point needs three numbers", "few.obj")
        self.write("word.ply", files.ply_text().replace("\n-0.5", "\nzero", 1))
        self.refuse("line 10: not a number", "word.ply")
        self.write("far.obj", files.obj([("1e30", 0, 0)] + files.POINTS[1:]))
        self.refuse("too far away", "far.obj")

    def test_models_without_triangles_or_area(self):
        self.write("points.obj", files.obj(faces=[]))
        self.refuse("no triangles", "points.obj")
        self.write("line.vtk", files.vtk_header("POLYDATA") + "LINES 1 3\n2 0 1\n")
        self.refuse("no triangles", "line.vtk")
        self.write("flat.obj", files.obj([(i, 0, 0) for i in range(8)], files.TRIANGLES))
        self.refuse("no triangle that has an area", "flat.obj")


if __name__ == "__main__":
    unittest.main()
