"""PLY files, whole, damaged and far from the origin: shadow_render_ply.py PROGRAM.

Each damaged file is drawn or refused in one line with a place, never by way of a crash: the program's last words
after one are "the file is damaged", which no PLY may bring about.
"""

import random
import struct
import unittest

from shadow_render_case import CommandLine
import shadow_render_files as files

VARIANTS = 120
LINES = [b"element vertex 9999999999", b"element face 77", b"element vertex 8", b"property list uchar float x",
         b"property double x", b"property list int int vertex_indices", b"property uchar vertex_indices",
         b"property list float int vertex_indices", b"format binary_big_endian 1.0", b"-2", b"200 1 2", b"end_header"]


def ply(form, points, kind="double"):
    header = files.ply_header(form).replace("float", kind)
    if form == "ascii":
        return (header + files.lines_of(points) + files.lines_of([(4,) + q for q in files.QUADS])).encode()
    order, code = "<" if "little" in form else ">", "d" if kind == "double" else "f"
    return (header.encode() + b"".join(struct.pack(order + "3" + code, *p) for p in points)
            + b"".join(struct.pack(order + "B4i", 4, *q) for q in files.QUADS))


def damage(data, chance):
    kind = chance.randrange(5)
    lines = data.split(b"\n")
    if kind == 0:
        return data[:chance.randrange(1, len(data))]
    if kind == 1:
        place = chance.randrange(len(data))
        return data[:place] + bytes([chance.randrange(256)]) + data[place + 1:]
    place = chance.randrange(len(lines))
    if kind == 2:
        del lines[place]
    elif kind == 3:
        lines.insert(place, lines[chance.randrange(len(lines))])
    else:
        lines[place] = chance.choice(LINES)
    return b"\n".join(lines)


class Ply(CommandLine):
    def mask(self, name, *options):
        result = self.call(name, "--size", "160x120", "--mask", "mask.png", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(self.path("mask.png"), "rb") as file:
            return file.read(), result.stderr.decode()

    def test_damaged_files(self):
        chance = random.Random(11)
        for number in range(VARIANTS):
            form = ("ascii", "binary_little_endian", "binary_big_endian")[number % 3]
            self.write("damaged.ply", damage(ply(form, files.POINTS, "float"), chance))
            result = self.call("damaged.ply", "--size", "16x12")
            text = result.stderr.decode()
            with self.subTest(number=number):
                self.assertIn(result.returncode, (0, 1), text)
                self.assertNotIn("the file is damaged", text)
                self.assertLessEqual(len(text.splitlines()), 1)

    def test_reasons(self):
        text = files.ply_text()
        for old, new, reason in (
                ("list uchar int vertex_indices", "int vertex_indices", "line 8: vertex_indices is no list"),
                ("float x", "list uchar float x", "line 4: x is a list"),
                ("float y", "float x", "line 5: a property that is there already"),
                ("element face", "element vertex", "line 7: an element that is there already, since line 3"),
                ("element vertex 8", "element vertex 800000000", "line 3: the file is too short"),
                ("list uchar", "list float", "line 8: the length of a list is no whole number"),
                ("vertex_indices", "corners", "line 7: face without vertex_indices"),
                ("float z", "quad z", "line 6: an unknown type"),
                ("\n4 ", "\n-1 ", "line 18: a list cannot be of this length"),
                ("\n4 0", "\n4 8", "line 18: a face uses a point that does not exist")):
            self.write("wrong.ply", text.replace(old, new, 1))
            self.refuse(reason, "wrong.ply")
        self.write("short.ply", text[:-12])
        self.refuse("line 22: too few numbers", "short.ply")

    def test_map_coordinates(self):
        """Where single precision has steps of half a metre: the mask of the mesh at the origin."""
        east, north, up = 448123.375, 5411987.4375, 310.125
        far = [(x + east, y + north, z + up) for x, y, z in files.POINTS]
        near, _ = self.mask("cube.obj", "--camera=3,4,5,0,0.5,0,0,1,0,30", "--light", "point:-3,5,4")
        view = [f"--camera={3 + east},{4 + north},{5 + up},{east},{0.5 + north},{up},0,1,0,30",
                "--light", f"point:{east - 3},{north + 5},{up + 4}"]
        for form in ("ascii", "binary_little_endian", "binary_big_endian"):
            self.write("far.ply", ply(form, far))
            self.assertEqual(self.mask("far.ply", *view), (near, ""), form)
        facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex %r %r %r\n" % far[i] for i in t)
                         + "endloop\nendfacet\n" for t in files.TRIANGLES)
        self.write("far.stl", "solid far\n" + facets + "endsolid far\n")
        self.assertEqual(self.mask("far.stl", *view), (near, ""))
        self.write("rounded.ply", ply("binary_little_endian", far, "float"))
        self.assertIn("single precision, which has steps of 0.5", self.mask("rounded.ply", *view)[1])


if __name__ == "__main__":
    unittest.main()
