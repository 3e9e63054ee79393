"""What the tests of the programs' command lines share: running a program in a folder of its own, and reading the
pictures that come back without VTK's help or ours.
"""

import os
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import shadow_render_files as files

PROGRAM = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else "shadow_render"

SILHOUETTES = ["auto", "brute-force", "edge-buffer", "triangular", "visible-nonvisible", "hybrid",
               "hierarchical", "topology-aware-mesh", "facing-texture", "facing-texture-resident", "vertex-texture",
               "vertex-extrusion", "geometry-shader", "compute"]

# From straight above, the x axis to the right and the z axis down; 15 pixels are one unit of the scene.
FROM_ABOVE = ["--size", "120x90", "--camera", "0,10,0,0,0,0,0,0,-1,30", "--parallel", "3"]


class Picture:
    """An 8-bit PNG without interlacing; row 0 is the top one."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
        position, body, kinds = 8, b"", []
        while position < len(data):
            size, kind = struct.unpack(">I4s", data[position:position + 8])
            content = data[position + 8:position + 8 + size]
            kinds.append(kind)
            if kind == b"IHDR":
                self.width, self.height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", content)
                assert depth == 8 and interlaced == 0
                self.channels = {0: 1, 2: 3, 6: 4}[colour]
            elif kind == b"IDAT":
                body += content
            position += size + 12
        assert kinds[-1] == b"IEND", "the file is cut off"
        self.rows = self._unfilter(zlib.decompress(body))

    def _unfilter(self, data):
        rows, stride = [], self.width * self.channels
        previous = bytearray(stride)
        for y in range(self.height):
            start = y * (stride + 1)
            kind, row = data[start], bytearray(data[start + 1:start + 1 + stride])
            for x in range(stride):
                left = row[x - self.channels] if x >= self.channels else 0
                corner = previous[x - self.channels] if x >= self.channels else 0
                row[x] = (row[x] + self._predict(kind, left, previous[x], corner)) & 255
            rows.append(bytes(row))
            previous = row
        return rows

    @staticmethod
    def _predict(kind, left, above, corner):
        if kind == 4:
            distances = [abs(above - corner), abs(left - corner), abs(left + above - 2 * corner)]
            return (left, above, corner)[distances.index(min(distances))]
        return (0, left, above, (left + above) // 2)[kind]

    def having(self, wanted):
        """The pixels of a mask, (x, y) from the top left, that have a value."""
        assert self.channels == 1
        return {(x, y) for y, row in enumerate(self.rows) for x, value in enumerate(row) if value == wanted}

    def shadow(self):
        return self.having(0)

    def pixel(self, x, y):
        return tuple(self.rows[y][self.channels * x:self.channels * (x + 1)])


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
        return Picture(self.path(name))

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
            self.assertRegex(text, r"\A" + os.path.basename(PROGRAM) + r": [ -~]+\n\Z")
            self.assertIn(part, text)
            self.assertEqual(result.stdout, b"")
            self.assertEqual(sorted(os.listdir(self.folder.name)), before)
