"""The packages in which VTK comes."""

import importlib.metadata
import importlib.util
import os

# What each is installed as. PyVista's fork has its own name, so that both can be there.
PACKAGES = {"vtkmodules": "vtk", "cvista": "cvista"}


def others(package):
    return [other for other in PACKAGES if other != package]


def is_there(package):
    return importlib.util.find_spec(package) is not None


def installed_version(package):
    """What pip says of a package that is there, without loading it; empty where it came another way."""
    try:
        distribution = importlib.metadata.distribution(PACKAGES[package])
    except (KeyError, importlib.metadata.PackageNotFoundError):
        return ""
    listed = distribution.locate_file(os.path.join(package, "__init__.py"))
    found = importlib.util.find_spec(package).origin or ""
    return distribution.version if os.path.realpath(found) == os.path.realpath(listed) else ""
