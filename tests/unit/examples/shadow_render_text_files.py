"""Text meshes that are right, but not as VTK's readers want them: shadow_render_text_files.py PROGRAM.

Each has to give the mask of the same mesh written plainly.
"""

import pathlib
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


class TextFiles(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def draw(self, text, *options):
        folder = pathlib.Path(self.folder.name)
        (folder / "mesh.obj").write_bytes(text.encode())
        run = subprocess.run([PROGRAM, "mesh.obj", "--size", "160x120", "--mask", "mask.png", *options],
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
