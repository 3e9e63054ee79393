"""Is the VTK that is here the one that the plugin was built for?

Beside another one its classes have other sizes, and loading the plugin would crash. So this is asked first.
"""

import ctypes
import importlib
import os
import sys

from . import _vtk_packages
from ._build import VERSION, VTK_DISTRIBUTION, VTK_LIBRARIES, VTK_PACKAGE, VTK_VERSION

_BUILT_FOR = (
    f"vtkshadow {VERSION} was built for VTK {VTK_DISTRIBUTION or VTK_VERSION} of the package {VTK_PACKAGE}"
)


def find():
    """Refuses what can be told without loading VTK, as that has to come after vtkshadow.headless."""
    others = _vtk_packages.others(VTK_PACKAGE)
    if _is_loaded(VTK_PACKAGE):
        _compare_version()
        return
    for other in filter(_is_loaded, others):
        raise ImportError(f"{_BUILT_FOR}, but this program uses {_told(other)}")
    if not _vtk_packages.is_there(VTK_PACKAGE):
        there = [_told(other) for other in others if _vtk_packages.is_there(other)]
        raise ImportError(
            f"{_BUILT_FOR}, which is not there; there is {' and '.join(there) or 'no other VTK'}"
        )
    installed = _vtk_packages.installed_version(VTK_PACKAGE)
    if installed and installed != (VTK_DISTRIBUTION or VTK_VERSION):
        raise ImportError(f"{_BUILT_FOR}, but there is {_told(VTK_PACKAGE)}")


def load():
    """Loads what our classes derive from, and compares version and libraries on the way."""
    find()
    _compare_version()
    importlib.import_module(VTK_PACKAGE + ".vtkRenderingCore")
    importlib.import_module(VTK_PACKAGE + ".vtkRenderingOpenGL2")  # VTK's object factories need it
    missing = [library for library in VTK_LIBRARIES if not _is_resident(library)]
    if missing:
        raise ImportError(
            f"{_BUILT_FOR}, but there is another build of {_told(VTK_PACKAGE)}: "
            f"it is without {', '.join(missing)}"
        )


def _is_loaded(package):
    return package + ".vtkCommonCore" in sys.modules


def _loaded_version(package):
    return importlib.import_module(package + ".vtkCommonCore").vtkVersion.GetVTKVersion()


def _compare_version():
    if _loaded_version(VTK_PACKAGE) != VTK_VERSION:
        raise ImportError(f"{_BUILT_FOR}, but there is {_told(VTK_PACKAGE)}")


def _told(package):
    version = _vtk_packages.installed_version(package)
    if not version and _vtk_packages.is_there(package):
        version = _loaded_version(package)
    folder = importlib.util.find_spec(package).submodule_search_locations[0]
    return f"VTK {version} of the package {package} ({folder})"


def _is_resident(library):
    """Has VTK loaded this library? One of another build has another name."""
    try:
        ctypes.CDLL(library, mode=os.RTLD_NOLOAD | os.RTLD_LAZY)
    except OSError:
        return False
    return True
