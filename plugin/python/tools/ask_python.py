"""What an interpreter and its VTK are, asked by find_python.cmake. Usage: ask_python.py PACKAGE_OF_VTK

Prints interpreter's version;name of the folder of packages;interpreter;VTK's version;what pip calls it
"""

import importlib
import os
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.append(str(pathlib.Path(__file__).parent.parent / "vtkshadow"))
import _vtk_packages

PACKAGE = sys.argv[1]


def version_of(package):
    return importlib.import_module(package + ".vtkCommonCore").vtkVersion.GetVTKVersion()


if not _vtk_packages.is_there(PACKAGE):
    there = [
        f"{other} {version_of(other)}"
        for other in _vtk_packages.others(PACKAGE)
        if _vtk_packages.is_there(other)
    ]
    sys.exit(f"cannot import {PACKAGE}" + (f" but has {' and '.join(there)}" if there else ""))

folder = os.path.basename(os.path.dirname(os.path.dirname(importlib.import_module(PACKAGE).__file__)))
print(
    "%d.%d" % sys.version_info[:2],
    folder,
    sys.executable,
    version_of(PACKAGE),
    _vtk_packages.installed_version(PACKAGE),
    sep=";",
)
