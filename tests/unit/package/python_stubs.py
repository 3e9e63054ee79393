"""The package's type stubs name all that the package has. Usage: python_stubs.py, with the package in Python's path."""

import ast
import importlib
import inspect
import pathlib
import re
import unittest

import vtkshadow
from vtkshadow import _build

PACKAGE = pathlib.Path(vtkshadow.__file__).parent
FEW = {
    "SetStencilMethodToAuto": "None",
    "GetShadowIntensity": "float",
    "GetCasting": "bool",
    "GetStatusMessage": "str",
}


def members(body):
    """Names that a stub's class or module defines."""
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.name
        elif isinstance(node, ast.AnnAssign):
            yield node.target.id


def annotations(tree):
    """All types that a stub tells."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef):
            yield from filter(None, [*(each.annotation for each in node.args.args), node.returns])
        elif isinstance(node, ast.ClassDef):
            yield from node.bases


def parsed(name):
    return ast.parse((PACKAGE / f"{name}.pyi").read_text())


def modules():
    vtkshadow.vtkShadowVolumePass  # VTK is loaded before
    return {path.stem: importlib.import_module("vtkshadow." + path.stem) for path in PACKAGE.glob("vtk*.pyi")}


def public(things):
    return {name for name in vars(things) if not name.startswith("_")}


class Stubs(unittest.TestCase):
    def test_package_is_marked_as_typed(self):
        self.assertTrue((PACKAGE / "py.typed").is_file())

    def test_every_module_has_one(self):
        built = {re.sub(r"\..*", "", path.name) for path in PACKAGE.glob("vtk*.so")}
        self.assertEqual(set(modules()), built)
        self.assertIn("vtkShadowPasses", built)

    def test_every_class_and_member_is_named(self):
        for name, module in modules().items():
            stubs = {node.name: node for node in parsed(name).body if isinstance(node, ast.ClassDef)}
            classes = {key: value for key, value in vars(module).items() if inspect.isclass(value)}
            self.assertEqual(set(stubs), set(classes))
            for key, value in classes.items():
                self.assertLessEqual(public(value), set(members(stubs[key].body)), key)

    def test_base_classes_are_those_of_the_modules(self):
        for name, module in modules().items():
            for node in parsed(name).body:
                if isinstance(node, ast.ClassDef):
                    base = vars(module)[node.name].__base__
                    self.assertEqual(
                        [ast.unparse(each) for each in node.bases], [f"{base.__module__}.{base.__qualname__}"]
                    )

    def test_all_types_are_defined(self):
        for name, module in modules().items():
            tree = parsed(name)
            imports = [node for node in tree.body if isinstance(node, (ast.Import, ast.ImportFrom))]
            space = dict(vars(module))
            exec(compile(ast.Module(imports, []), name, "exec"), space)
            for annotation in annotations(tree):
                eval(ast.unparse(annotation), space)

    def test_modules_of_all_types_are_imported(self):
        for name in modules():
            tree = parsed(name)
            imported = {
                each.name for node in tree.body if isinstance(node, ast.Import) for each in node.names
            }
            used = {
                ast.unparse(node.value)
                for each in annotations(tree)
                for node in ast.walk(each)
                if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Attribute)
            }
            self.assertEqual(used - imported, set())

    def test_types_of_some_results(self):
        body = next(
            node.body
            for node in parsed("vtkShadowPasses").body
            if getattr(node, "name", "") == "vtkShadowVolumePass"
        )
        results = {
            node.name: ast.unparse(node.returns)
            for node in body
            if isinstance(node, ast.FunctionDef) and node.returns
        }
        self.assertEqual({name: results[name] for name in FEW}, FEW)

    def test_package_s_own_names_all_it_offers(self):
        tree = parsed("__init__")
        imported = {
            each.asname for node in tree.body if isinstance(node, ast.ImportFrom) for each in node.names
        }
        self.assertLessEqual(set(vtkshadow.__all__), imported)
        self.assertIn("__version__", set(members(tree.body)))

    def test_version(self):
        self.assertEqual(vtkshadow.__version__, _build.VERSION)
        self.assertRegex(vtkshadow.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
