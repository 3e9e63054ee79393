"""What the installed wheel holds, and what it refuses. Usage: wheel_contents.py, in tests/wheel.sh's environment"""

import importlib.metadata
import subprocess
import sys
import unittest

WHEEL = importlib.metadata.distribution("vtkshadow")


def run(code):
    done = subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True)
    return done.returncode, done.stderr.strip()


class Wheel(unittest.TestCase):
    def test_nothing_lies_beside_the_package(self):
        folders = {file.parts[0] for file in WHEEL.files}
        self.assertEqual(folders, {"vtkshadow", f"vtkshadow-{WHEEL.version}.dist-info"})

    def test_nothing_is_for_building(self):
        self.assertEqual(
            [str(file) for file in WHEEL.files if file.suffix in (".h", ".cmake", ".a", ".cxx")], []
        )

    def test_licences_of_what_is_built_in(self):
        licences = {file.name: file.read_text() for file in WHEEL.files if "licenses" in file.parts}
        for name, words in {"LICENSE": "Redistribution", "OpenMesh.txt": "RWTH", "GLM.txt": "G-Truc"}.items():
            self.assertIn(words, licences[name])

    def test_version(self):
        import vtkshadow

        self.assertEqual(vtkshadow.__version__, WHEEL.version)

    def test_headless_import_does_nothing(self):
        code = "import vtkshadow.headless; from vtkshadow import vtkShadowVolumePass; vtkShadowVolumePass()"
        self.assertEqual(run(code), (0, ""))

    def test_stock_vtk_is_refused(self):
        """PyVista brings the `vtk` of PyPI along."""
        status, error = run(
            "import vtkmodules.vtkRenderingOpenGL2; from vtkshadow import vtkShadowVolumePass"
        )
        self.assertEqual(status, 1, error)
        self.assertIn("ImportError", error)
        self.assertIn(importlib.metadata.version("cvista"), error)
        self.assertIn(importlib.metadata.version("vtk"), error)


if __name__ == "__main__":
    unittest.main()
