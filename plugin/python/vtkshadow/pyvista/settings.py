"""What a user sets, as plain data, and what of it is allowed."""

import numbers
import operator

from pyvista import Color

# As the command line names them.
METHODS = ("auto", "brute-force", "edge-buffer", "triangular", "visible-nonvisible", "hybrid", "hierarchical",
           "topology-aware-mesh", "facing-texture", "facing-texture-resident", "vertex-texture", "vertex-extrusion",
           "geometry-shader", "compute")

DEFAULTS = {"enabled": False, "intensity": 1.0, "samples": None, "method": "auto", "outlines": None}

LINE_DEFAULTS = {"width": 2.0, "color": "black", "creases": None}


def _number(name, value, low, high):
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name} has to be a number from {low} to {high}, not {value!r}")
    if not low <= value <= high:  # nor NaN
        raise ValueError(f"{name} has to be from {low} to {high}, not {value!r}")
    return float(value)


def _samples(value):
    if value is None:
        return None
    try:
        number = 0 if isinstance(value, bool) else operator.index(value)
    except TypeError:
        raise TypeError(f"samples has to be None or a whole number, not {value!r}") from None
    if number not in (1, 2, 4, 8, 16, 32):
        raise ValueError(f"samples has to be None, 1, 2, 4, 8, 16 or 32, not {value!r}")
    return number


def _method(value):
    if not isinstance(value, str):
        raise TypeError(f"method has to be a name, not {value!r}")
    name = value.lower().replace("_", "-")
    if name not in METHODS:
        raise ValueError(f"method has to be one of {', '.join(METHODS)}, not {value!r}")
    return name


def _enabled(value):
    if not isinstance(value, bool):
        raise TypeError(f"enabled has to be True or False, not {value!r}")
    return value


def _outlines(value):
    if value is None:
        return None
    try:
        lines = {**LINE_DEFAULTS, **value}
    except TypeError:
        raise TypeError(f"outlines has to be None or have width, color and creases, not {value!r}") from None
    try:
        color = Color(lines["color"]).hex_rgb
    except (TypeError, ValueError):
        raise ValueError(f"color has to be a colour as elsewhere in PyVista, not {lines['color']!r}") from None
    creases = lines["creases"]
    return {"width": _number("width of outlines", lines["width"], 0.5, 64), "color": color,
            "creases": None if creases is None else _number("creases", creases, 0, 180)}


_CHECKS = {"enabled": _enabled, "intensity": lambda value: _number("intensity", value, 0, 1), "samples": _samples,
           "method": _method, "outlines": _outlines}


def changed(settings, changes):
    """The settings with changes, all of them checked; what is not known is left out."""
    return {**settings, **{name: _CHECKS[name](value) for name, value in changes.items() if name in _CHECKS}}
