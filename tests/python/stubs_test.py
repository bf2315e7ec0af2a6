"""Type stubs and module say the same; every public name is documented."""
import ast
import dataclasses
import inspect
import os
import pathlib
import unittest

import loosefit
from loosefit import _core

PACKAGE = pathlib.Path(loosefit.__file__).parent


def stub_names():
    """Name → set of members of a class, or list of parameters of a function, of _core.pyi."""
    found = {}
    for node in ast.parse((PACKAGE / "_core.pyi").read_text()).body:
        if isinstance(node, ast.ClassDef):
            found[node.name] = {item.name: parameters(item) for item in node.body
                                if isinstance(item, ast.FunctionDef)}
        elif isinstance(node, ast.FunctionDef):
            found[node.name] = parameters(node)
    return found


def parameters(function):
    """Names of the arguments but self."""
    names = [a.arg for a in function.args.args + function.args.kwonlyargs]
    return [name for name in names if name != "self"]


def told_parameters(function):
    """The same from the first line of what pybind11 documents: "name(self: X, a: int) -> ..."."""
    line = (function.__doc__ or "").splitlines()[0]
    inner = line[line.index("(") + 1:line.rindex(") ->")]
    names, depth, word = [], 0, ""
    for c in inner + ",":
        depth += (c in "[(") - (c in "])")
        if c == "," and depth == 0:
            names.append(word.split(":")[0].strip())
            word = ""
        else:
            word += c
    return [name for name in names if name not in ("", "self", "arg0", "*")]


def public(thing):
    return [name for name in vars(thing) if not name.startswith("_")]


class Stubs(unittest.TestCase):
    def test_names_of_the_compiled_part(self):
        stubs = stub_names()
        self.assertEqual(sorted(public(_core)), sorted(stubs))
        for name, told in stubs.items():
            real = getattr(_core, name)
            if not inspect.isclass(real):
                self.assertEqual(told_parameters(real), told, name)
                continue
            self.assertEqual(sorted(public(real)), sorted(n for n in told if n != "__init__"), name)
            for member, arguments in told.items():
                function = getattr(real, member)
                if callable(function):
                    self.assertEqual(told_parameters(function), arguments, f"{name}.{member}")

    def test_package_is_typed(self):
        self.assertTrue((PACKAGE / "py.typed").exists())
        for name in loosefit.__all__:
            thing = getattr(loosefit, name)
            if inspect.isfunction(thing):
                hints = inspect.get_annotations(thing)
                self.assertEqual(set(hints), set(inspect.signature(thing).parameters) | {"return"})

    def test_every_public_name_is_documented(self):
        for name in loosefit.__all__:
            thing = getattr(loosefit, name)
            self.assertTrue(thing.__doc__, name)
            if not inspect.isclass(thing) or dataclasses.is_dataclass(thing):
                continue
            for member in public(thing):
                self.assertTrue(inspect.getdoc(getattr(thing, member)), f"{name}.{member}")

    def test_names_are_those_of_the_page(self):
        page = (pathlib.Path(os.environ["LOOSEFIT_SOURCE_DIR"]) / "docs" / "python.md").read_text()
        for name in loosefit.__all__:
            self.assertIn(f"`{name}", page, name)
        for kind in (loosefit.Result, loosefit.Body, loosefit.Pattern, loosefit.Map):
            members = ([field.name for field in dataclasses.fields(kind)]
                       if dataclasses.is_dataclass(kind) else public(kind))
            for member in members:
                self.assertIn(f"`{member}", page, f"{kind.__name__}.{member}")


if __name__ == "__main__":
    unittest.main()
