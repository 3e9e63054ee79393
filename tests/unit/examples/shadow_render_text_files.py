"""Text meshes that are right, but not as VTK's readers want them: shadow_render_text_files.py PROGRAM.

Each has to give the mask of the same mesh written plainly.
"""

import base64
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)

POINTS = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
FACES = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"]


def obj(vertex="v {} {} {}\n", face="f {}\n", corner="{}", head=""):
    faces = (" ".join(corner.format(index) for index in line.split()) for line in FACES)
    return head + "".join(vertex.format(*point) for point in POINTS) + "".join(face.format(line) for line in faces)


def stl(head="solid cube\n", tail="endsolid cube\n"):
    facets = []
    for line in FACES:
        a, b, c, d = (POINTS[int(index) - 1] for index in line.split())
        for corners in ((a, b, c), (a, c, d)):
            vertices = "".join("      vertex {} {} {}\n".format(*point) for point in corners)
            facets.append(f"  facet normal 0 0 0\n    outer loop\n{vertices}    endloop\n  endfacet\n")
    return head + "".join(facets) + tail


class TextFiles(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def draw(self, text, *options, name="mesh.obj"):
        folder = pathlib.Path(self.folder.name)
        (folder / name).write_bytes(text.encode())
        run = subprocess.run([PROGRAM, name, "--size", "160x120", "--mask", "mask.png", *options],
                             cwd=folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return (folder / "mask.png").read_bytes()

    def test_same_mask(self):
        plain = self.draw(obj())
        variants = {
            "byte order mark before a point": "\ufeff" + obj(),
            "comment that ends in a backslash": obj(head="# C:\\models\\\n"),
            "comments after points": obj(vertex="v {} {} {} # a point\n"),
            "comments after faces": obj(face="f {} # a face\n"),
            "comments after faces, in backslashes": obj(face="f {} # a face \\\n"),
            "points that go on": obj(vertex="v {} \\\n{} {}\n"),
            "points that go on, with CRLF": obj(vertex="v {} \\\r\n{} \\\r\n{}\r\n"),
            "faces that go on": obj(face="f \\\n{}\n"),
            "corners with an empty normal": obj(corner="{}//"),
            "corners with an empty texture coordinate": obj(corner="{}/"),
            "a name that holds the sign": obj(head="o part#1\n"),
        }
        for name, text in variants.items():
            with self.subTest(name):
                self.assertEqual(self.draw(text), plain)

    def test_stl_same_mask(self):
        plain = self.draw(stl(), name="mesh.stl")
        variants = {
            "byte order mark": stl(head="\ufeffsolid cube\n"),
            "comments and empty lines before": stl(head="# made by hand\n\n; and so on\nsolid cube\n"),
            "a long name": stl(head="solid " + "n" * 400 + "\n"),
            "a long name at the end": stl(tail="endsolid " + "n" * 4000 + "\n"),
            "CRLF": stl().replace("\n", "\r\n"),
            "upper case": stl(head="SOLID CUBE\n", tail="ENDSOLID CUBE\n"),
            "upper case all over": stl().upper(),
            "spaces before": stl(head="  solid cube\n"),
            "comments in between": stl().replace("outer", "# a face\n    outer"),
            "two solids": stl(tail="endsolid cube\n\nsolid none\nendsolid none\n"),
        }
        for name, text in variants.items():
            with self.subTest(name):
                self.assertEqual(self.draw(text, name="mesh.stl"), plain)

    def refuse(self, data, name, *words):
        folder = pathlib.Path(self.folder.name)
        (folder / name).write_bytes(data)
        run = subprocess.run([PROGRAM, name, "--size", "64x48"], cwd=folder, capture_output=True, text=True, timeout=20)
        self.assertEqual(run.returncode, 1)
        self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
        for word in words:
            self.assertIn(word, run.stderr)

    def test_ply_strips(self):
        """Two strips in one list, parted by -1, and faces that say the same."""
        head = ("ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                "element {}\nproperty list int int vertex_indices\nend_header\n"
                "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 1\n{}")
        faces = self.draw(head.format("face 3", "3 0 1 2\n3 1 3 2\n3 2 3 4\n"), name="mesh.ply")
        strips = self.draw(head.format("tristrips 1", "8 0 1 2 3 -1 2 3 4\n"), name="mesh.ply")
        self.assertEqual(strips, faces)

    def test_small_file_that_asks_for_all_memory(self):
        """A block of compressed data whose header claims to be of four terabytes."""
        header = struct.pack("<4Q", 1, 1 << 42, 0, 64)
        block = base64.b64encode(header).decode() + base64.b64encode(bytes(64)).decode()
        array = '<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="binary">' + block + "</DataArray>"
        text = ('<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64" '
                'compressor="vtkZLibDataCompressor"><PolyData><Piece NumberOfPoints="366503875925" NumberOfVerts="0" '
                'NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="1"><Points>' + array.format("Float32", "Points", 3)
                + "</Points><Polys>" + array.format("Int64", "connectivity", 1) + array.format("Int64", "offsets", 1)
                + "</Polys></Piece></PolyData></VTKFile>")
        self.refuse(text.encode(), "mesh.vtp", "mesh.vtp: ")

    def test_map_coordinates(self):
        """Far from the origin, where single precision has steps of half a metre: the mask of the mesh at the origin."""
        east, north, up = 448123.37, 5411987.41, 310.13
        camera = "--camera={},{},{},{},{},{},0,0,1,30".format
        far = "v {:.2f} {:.2f} {:.2f}\n"
        text = "".join(far.format(x + east, y + north, z + up) for x, y, z in POINTS)
        near = self.draw(obj(), camera(6, 7, 5, 0, 0, 0), "--light", "point:-3,5,4")
        moved = self.draw(text + "".join(f"f {line}\n" for line in FACES),
                          camera(6 + east, 7 + north, 5 + up, east, north, up),
                          "--light", f"point:{east - 3},{north + 5},{up + 4}")
        self.assertEqual(moved, near)


if __name__ == "__main__":
    unittest.main()
