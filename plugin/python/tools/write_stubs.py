"""Writes type stubs (.pyi) of the package's classes into it. Usage: write_stubs.py FOLDER/vtkshadow MODULE...

VTK's wrappers tell a method's types in the first lines of its docstring. VTK has a generator of its own, which some
versions come without.
"""

import ast
import builtins
import importlib
import inspect
import pathlib
import re
import sys
import textwrap

PACKAGE = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(PACKAGE.parent))
from vtkshadow import _vtk
from vtkshadow._build import VTK_PACKAGE

PLAIN = {"Any", "Callback", "None", "Pointer", *vars(builtins)}


def is_enum(value):
    return inspect.isclass(value) and issubclass(value, int)


class Stub:
    """Of one module. Collects which of VTK's modules its types come from."""

    def __init__(self, module):
        self.module = module
        self.imports = set()

    def text(self):
        classes = [value for value in vars(self.module).values() if inspect.isclass(value)]
        body = "\n\n".join(self.class_text(each) for each in classes)
        lines = ["from typing import Any, Callable, Sequence, overload", ""]
        lines += [f"import {name}" for name in sorted(self.imports)]
        return "\n".join(lines) + "\n\n" + body

    def class_text(self, each):
        bases = [self.type_name(base) for base in each.__bases__ if base is not object]
        head = f"class {each.__name__}({', '.join(bases)}):" if bases else f"class {each.__name__}:"
        members = [documented(each.__doc__)]
        for name, value in vars(each).items():
            if name.startswith("__"):
                continue
            if is_enum(value):
                members.append(f"class {name}(int): ...")
            elif isinstance(value, int):
                members.append(f"{name}: {type(value).__name__}")
            elif inspect.isroutine(value):
                members.append(self.method_text(name, value))
            elif inspect.isdatadescriptor(value):
                members.append(self.property_text(name, each))
        return head + "\n" + textwrap.indent("\n".join(filter(None, members)) or "...", "    ") + "\n"

    def property_text(self, name, each):
        """From VTK 9.4 on methods GetLineWidth and SetLineWidth make a property line_width."""
        methods = {key.lower(): (key, value) for key, value in vars(each).items() if inspect.isroutine(value)}
        result, stem = "Any", name.replace("_", "")
        if "get" + stem in methods:
            signatures, _ = split(*methods["get" + stem])
            returns = [ast.parse(f"def {signature}: ...").body[0].returns for signature in signatures]
            result = self.annotation(returns[0], False) if returns else "Any"
        text = f"@property\ndef {name}(self) -> {result}: ..."
        if "set" + stem in methods:
            text += f"\n@{name}.setter\ndef {name}(self, value: {result}) -> None: ..."
        return text

    def method_text(self, name, method):
        signatures, comment = split(name, method)
        if not signatures:
            return f"def {name}(self, *arguments: Any) -> Any: ..."
        texts = []
        for signature in signatures:
            definition = ast.parse(f"def {signature}: ...").body[0]
            self.annotate(definition)
            if definition.args.args[:1] == [] or definition.args.args[0].arg != "self":
                definition.decorator_list.append(ast.Name("staticmethod"))
            if len(signatures) > 1:
                definition.decorator_list.insert(0, ast.Name("overload"))
            if comment and not texts:
                definition.body = [ast.Expr(ast.Constant(comment))]
            texts.append(ast.unparse(definition).replace(":\n    ...", ": ..."))
        return "\n".join(texts)

    def annotate(self, definition):
        for argument in definition.args.args:
            if argument.annotation:
                argument.annotation = ast.parse(self.annotation(argument.annotation, True), mode="eval").body
        if definition.returns:
            definition.returns = ast.parse(self.annotation(definition.returns, False), mode="eval").body

    def annotation(self, node, is_argument):
        """VTK writes (float, float) for a sequence."""
        if isinstance(node, (ast.Tuple, ast.List)):
            types = [self.annotation(element, is_argument) for element in node.elts] or ["Any"]
            return f"Sequence[{types[0]}]" if is_argument else f"tuple[{', '.join(types)}]"
        text = ast.unparse(node)
        if isinstance(node, ast.Name) and node.id not in PLAIN:
            return self.type_name(self.find(node.id))
        return {"Callback": "Callable[..., Any]", "Pointer": "Any"}.get(text, text)

    def find(self, name):
        """The class of this name in the module or in those of VTK that are loaded; None if there is none."""
        modules = [
            self.module,
            *(module for key, module in list(sys.modules.items()) if key.startswith(VTK_PACKAGE + ".vtk")),
        ]
        return next((vars(module)[name] for module in modules if name in vars(module)), None)

    def type_name(self, each):
        if not inspect.isclass(each):
            return "Any"
        if each.__module__ in (self.module.__name__, "builtins"):
            return each.__qualname__
        self.imports.add(each.__module__)
        return f"{each.__module__}.{each.__qualname__}"


def split(name, method):
    """The signatures in a method's docstring, and what is said of it."""
    head, _, comment = (method.__doc__ or "").partition("\n\n")
    lines = re.sub(r"\n[ \t]+", " ", head).split("\n")
    return [line for line in lines if line.startswith(name + "(")], comment.strip()


def documented(doc):
    text = (doc or "").strip().replace("\\", "\\\\").replace('"', '\\"')
    return f'"""{text}"""' if text else ""


def main(names):
    _vtk.load()
    lines = ["__version__: str"]
    for name in names:
        module = importlib.import_module("vtkshadow." + name)
        (PACKAGE / f"{name}.pyi").write_text(Stub(module).text())
        classes = [key for key, value in vars(module).items() if inspect.isclass(value)]
        lines += [f"from .{name} import {each} as {each}" for each in classes]
    (PACKAGE / "__init__.pyi").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(sys.argv[2:])
