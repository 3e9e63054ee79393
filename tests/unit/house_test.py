"""The rooms: what may stand at the top level, and which room may include which. Usage: house_test.py PROJECT_FOLDER

What the repository holds is judged, not what else lies in the folder: pictures, meshes and build folders of a user's.
"""

import collections
import pathlib
import re
import subprocess
import sys
import unittest

PROJECT = pathlib.Path(sys.argv.pop(1)).resolve()

TOP_LEVEL = {"CMakeLists.txt", "README.md", "LICENSE", "CHANGELOG.md", "CMakePresets.json", "pyproject.toml", "plugin",
             "nodes", "visitors", "shaders", "examples", "tests"}

# room -> rooms it may include, itself always
ROOMS = {
    "nodes/geometry": [],
    "nodes/silhouette": ["nodes/geometry"],
    "nodes/scene": ["nodes/geometry", "nodes/silhouette"],
    "nodes/drawable": ["nodes/geometry", "nodes/silhouette", "nodes/scene"],
    "visitors": ["nodes/geometry", "nodes/silhouette", "nodes/scene", "nodes/drawable"],
    "nodes/effect": ["nodes/geometry", "nodes/silhouette", "nodes/scene", "nodes/drawable", "visitors"],
}
WITHOUT_VTK = ["nodes/geometry", "nodes/silhouette", "nodes/scene"]
MOST_FILES = 34  # of a room; more are in rooms of their own
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.MULTILINE)


def held_files():
    """Paths of what the repository holds, relative to it; nothing in a folder that is none, as from an archive."""
    try:
        top = subprocess.run(["git", "-C", str(PROJECT), "rev-parse", "--show-toplevel"], capture_output=True, text=True)
        listed = subprocess.run(["git", "-C", str(PROJECT), "ls-files", "-z"], capture_output=True, text=True)
    except FileNotFoundError:
        return []
    if top.returncode != 0 or listed.returncode != 0 or pathlib.Path(top.stdout.strip()).resolve() != PROJECT:
        return []
    return [pathlib.PurePosixPath(name) for name in listed.stdout.split("\0") if name]


def includes_of(room):
    for source in sorted((PROJECT / room).rglob("*")):
        if source.suffix in (".h", ".cxx"):
            for kind, name in INCLUDE.findall(source.read_text()):
                yield source.name, kind, name


class House(unittest.TestCase):
    def test_top_level(self):
        names = {path.parts[0] for path in held_files()}
        self.assertLessEqual({name for name in names if not name.startswith(".")}, TOP_LEVEL)

    def test_no_room_is_crowded(self):
        files = collections.Counter(path.parent for path in held_files())
        self.assertEqual({str(room): count for room, count in files.items() if count > MOST_FILES}, {})

    def test_rooms_include_only_what_they_may(self):
        room_of = {header.name: room for room in ROOMS for header in (PROJECT / room).rglob("*.h")}
        checked = 0
        for room, allowed in ROOMS.items():
            for source, kind, name in includes_of(room):
                if kind == '"' and name in room_of:
                    checked += 1
                    self.assertIn(room_of[name], [room, *allowed], f"{room}/{source} includes {name}")
        self.assertGreater(checked, 50)

    def test_plain_rooms_know_neither_vtk_nor_gl(self):
        for room in WITHOUT_VTK:
            for source, _, name in includes_of(room):
                self.assertFalse(name.startswith(("vtk", "GL/")), f"{room}/{source} includes {name}")

    def test_shaders_are_files(self):
        for room in [*ROOMS, "plugin/passes", "plugin/headless"]:
            for source in (PROJECT / room).rglob("*.cxx"):
                self.assertNotRegex(source.read_text(), r"gl_Position\s*[=.]|#version \d", str(source))

    def test_a_uniform_is_set_in_one_way(self):
        """From 9.7 on VTK does not set again what it has set last, and knows nothing of what GL was told beside it."""
        sources = [source.read_text() for room in [*ROOMS, "plugin/passes"] for source in (PROJECT / room).rglob("*.cxx")]
        by_vtk, by_gl = (
            {name for source in sources for call in re.findall(calls, source) for name in re.findall(r'"(\w+)"', call)}
            for calls in (r"\b(?:[sS]etUniform\w*|setDepthBias|drawReading)(\([^;]*);", r"\b(?:glGetUniformLocation|bind)(\([^;]*);")
        )
        self.assertGreater(min(len(by_vtk), len(by_gl)), 15)
        self.assertEqual(by_vtk & by_gl, set())

    def test_the_wheel_is_for_one_vtk(self):
        versions = re.findall(r'"cvista[^"=]*==([^"]*)"', (PROJECT / "pyproject.toml").read_text())
        self.assertEqual((len(versions), len(set(versions))), (3, 1), "what it is built for is what it asks for")


if __name__ == "__main__":
    unittest.main()
