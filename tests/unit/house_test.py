"""The rooms: what may stand at the top level, and which room may include which. Usage: house_test.py PROJECT_FOLDER"""

import pathlib
import re
import sys
import unittest

PROJECT = pathlib.Path(sys.argv.pop(1)).resolve()

TOP_LEVEL = {"CMakeLists.txt", "README.md", "LICENSE", "CHANGELOG.md", "CMakePresets.json", "plugin", "nodes", "visitors",
             "shaders", "examples", "tests"}

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
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.MULTILINE)


def includes_of(room):
    for source in sorted((PROJECT / room).rglob("*")):
        if source.suffix in (".h", ".cxx"):
            for kind, name in INCLUDE.findall(source.read_text()):
                yield source.name, kind, name


class House(unittest.TestCase):
    def test_top_level(self):
        names = {entry.name for entry in PROJECT.iterdir()
                 if not entry.name.startswith((".", "build")) or entry.name == "CMakePresets.json"}
        self.assertLessEqual(names, TOP_LEVEL)

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
                self.assertNotRegex(source.read_text(), r"gl_Position|#version \d", str(source))


if __name__ == "__main__":
    unittest.main()
