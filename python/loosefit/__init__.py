"""Loosefit: drape a sewn garment on a body and map how well sensors in it would measure.

    import loosefit

    result = loosefit.run({"garment": {"pattern": "t-shirt"}, "simulation": {"edge_length": 0.02}})
    result.certificate.settled          # does the drape count?
    result.maps["distance_mm"].values   # (n,) gap to the skin at each vertex, mm
    result.vertices                     # (n, 3) where the cloth is, m

Functions: `run` and `load` give a `Result`, `body` a `Body`, `pattern` a `Pattern`, `rank` a
`Ranking`, `study` a `Study`. A scenario is a dict with the keys of a scenario file, a TOML text, or a path.

SI units unless a name says otherwise (`distance_mm`). World frame: right-handed, z up, the wearer
faces -y, +x is the wearer's left, the floor is z = 0. Pattern frame: u along the weft, v along the
warp (the grain). Arrays are read-only NumPy arrays over the memory of the result, which they keep
alive; `.copy()` cuts one free.
"""
from loosefit._errors import (Cancelled, Error, GeometryError, InputError, IoError, NotSettled,
                              SolverFailure)
from loosefit._core import CancelToken
from loosefit._body import Body, body
from loosefit._pattern import Panel, Pattern, Seam, pattern
from loosefit._result import Certificate, Garment, Map, Maps, Result, State
from loosefit._run import load, run
from loosefit._ranking import Ranking, rank
from loosefit._study import Study, study
from loosefit._core import version as _version
from loosefit._core import versions

__version__ = _version()

__all__ = [
    "Body", "CancelToken", "Cancelled", "Certificate", "Error", "Garment", "GeometryError",
    "InputError", "IoError", "Map", "Maps", "NotSettled", "Panel", "Pattern", "Ranking", "Result",
    "Seam", "SolverFailure", "State", "Study", "body", "load", "pattern", "rank", "run", "study",
    "versions",
]
