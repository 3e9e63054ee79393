"""The package beside a VTK that it was not built for: an ImportError that names both, before anything could crash.

Usage: python_vtk.py, with the package in Python's path. Stand-ins of VTK lie in front of the right one.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

import vtkshadow
from vtkshadow import _build, _vtk_packages

OTHER = _vtk_packages.others(_build.VTK_PACKAGE)[0]
CLASS = "from vtkshadow import vtkShadowVolumePass"


def run(code, *path):
    """What a fresh interpreter says last, and what it ended with. Folders of @p path come first in its own."""
    here = str(pathlib.Path(vtkshadow.__file__).parent.parent)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([*map(str, path), here])}
    done = subprocess.run([sys.executable, "-B", "-c", code], env=environment, capture_output=True, text=True)
    return done.returncode, (done.stderr.strip().splitlines() or [""])[-1]


class StandIn(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def add_vtk(self, package, version):
        (self.folder / package).mkdir()
        (self.folder / package / "__init__.py").touch()
        for module in ("vtkRenderingCore", "vtkRenderingOpenGL2"):
            (self.folder / package / f"{module}.py").touch()
        (self.folder / package / "vtkCommonCore.py").write_text(textwrap.dedent(f"""
            class vtkVersion:
                @staticmethod
                def GetVTKVersion():
                    return "{version}"
            """))

    def add_record(self, package, version):
        """What pip leaves."""
        name = _vtk_packages.PACKAGES[package]
        record = self.folder / f"{name}-{version}.dist-info"
        record.mkdir()
        (record / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n")

    def expect_refusal(self, code, *words):
        status, line = run(code, self.folder)
        self.assertEqual((status, line.partition(":")[0]), (1, "ImportError"), line)
        for word in (
            _build.VERSION,
            _build.VTK_DISTRIBUTION or _build.VTK_VERSION,
            _build.VTK_PACKAGE,
            *words,
        ):
            self.assertIn(word, line)

    def test_other_version(self):
        self.add_vtk(_build.VTK_PACKAGE, "9.99.1")
        self.expect_refusal(CLASS, "9.99.1", str(self.folder))

    def test_other_version_that_is_loaded(self):
        self.add_vtk(_build.VTK_PACKAGE, "9.99.1")
        self.expect_refusal(f"import {_build.VTK_PACKAGE}.vtkCommonCore, vtkshadow", "9.99.1")

    def test_other_version_that_pip_installed(self):
        self.add_vtk(_build.VTK_PACKAGE, "9.99.1")
        self.add_record(_build.VTK_PACKAGE, "9.99.1")
        self.expect_refusal("import vtkshadow", "9.99.1")

    def test_other_build_of_the_version(self):
        self.add_vtk(_build.VTK_PACKAGE, _build.VTK_VERSION)
        self.expect_refusal(CLASS, "another build", *_build.VTK_LIBRARIES)

    def test_other_package_in_use(self):
        self.add_vtk(OTHER, _build.VTK_VERSION)
        self.expect_refusal(f"import {OTHER}.vtkCommonCore, vtkshadow", OTHER, _build.VTK_VERSION)

    def test_other_package_alone(self):
        self.add_vtk(OTHER, "9.99.1")
        self.expect_refusal(
            f"import sys; sys.modules['{_build.VTK_PACKAGE}'] = None; import vtkshadow", OTHER, "9.99.1"
        )

    def test_no_vtk(self):
        hidden = "; ".join(f"sys.modules['{package}'] = None" for package in _vtk_packages.PACKAGES)
        self.expect_refusal(f"import sys; {hidden}; import vtkshadow", "no other VTK")

    def test_right_vtk(self):
        self.assertEqual(run(CLASS), (0, ""))

    def test_other_package_beside_the_right_one(self):
        self.add_vtk(OTHER, "9.99.1")
        self.assertEqual(run(CLASS, self.folder), (0, ""))


if __name__ == "__main__":
    unittest.main()
