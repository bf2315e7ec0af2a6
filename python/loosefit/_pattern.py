"""Sewing patterns."""
from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Optional, Union

from loosefit import _core
from loosefit._body import Floats, Progress
from loosefit._data import body_data
from loosefit._scenario import ScenarioLike, read_scenario


@dataclass(frozen=True, eq=False)
class Panel:
    """A flat piece: u along the weft, v along the warp, seen from the outside of the cloth."""

    name: str
    #: What it is in the draft: "front", "sleeve_L_back"; empty for pieces of a file.
    part: str
    #: m2
    area_m2: float
    #: (k, 2) closed outline, counter-clockwise, first point once, m.
    outline: Floats
    #: Hole name to (k, 2) its rim, counter-clockwise, first point once, m.
    holes: dict[str, Floats]
    #: Edge name to (65, 2) points along it, even in arc length, ends included, m.
    edges: dict[str, Floats]
    #: (3,) where the pattern places the origin of the piece, world frame, m.
    translation: Floats
    #: (3, 3) turns (u, v, outwards) of the piece into the world frame.
    rotation: Floats


@dataclass(frozen=True, eq=False)
class Seam:
    """Two edges that are sewn together: `first[i]` meets `second[i]`."""

    name: str
    first_panel: str
    first_edge: str
    second_panel: str
    second_edge: str
    #: (65, 2) points along the first edge in the frame of its panel, even in arc length, m.
    first: Floats
    #: (65, 2) points along the second edge, in that of its own.
    second: Floats
    first_length_m: float
    second_length_m: float


class Pattern:
    """Flat pieces, their seams, and how they fit the body that they were made for."""

    def __init__(self, core: _core.Pattern) -> None:
        self._core = core

    def __repr__(self) -> str:
        return (f"<loosefit.Pattern {self.name!r} of {len(self.panels)} panels, "
                f"{len(self.seams)} seams>")

    @property
    def name(self) -> str:
        """As the draft or the file calls it."""
        return self._core.name()

    @property
    def kind(self) -> str:
        """Kind of garment: "long-sleeve-shirt", "t-shirt", "trousers", …; "pattern-file" if none."""
        return self._core.kind()

    @cached_property
    def panels(self) -> dict[str, Panel]:
        """By name, in the order of the pattern."""
        return {panel["name"]: Panel(**panel) for panel in self._core.panels()}

    @cached_property
    def seams(self) -> tuple[Seam, ...]:
        """In the order of the pattern."""
        return tuple(Seam(**seam) for seam in self._core.seams())

    @cached_property
    def fit(self) -> list[dict[str, Any]]:
        """Records of level, garment_m, body_m, mobility (garment girth / body girth - 1).

        The last two are None at levels of which the body's girth is not known.
        """
        return self._core.fit()

    @property
    def warnings(self) -> list[str]:
        """Of reading a file, or of what gave way in the draft."""
        return self._core.warnings()

    def write(self, folder: Union[str, os.PathLike[str]]) -> None:
        """Adds pattern.json (GarmentCode) and pattern.svg (1:1) to a folder, or makes it.

        Raises InputError when something foreign is in the way, IoError.
        """
        self._core.write(os.fspath(folder))


def pattern(scenario: Optional[ScenarioLike] = None, /, *, body: Optional[Mapping[str, Any]] = None,
            progress: Optional[Progress] = None, cancel: Optional[_core.CancelToken] = None,
            data_dir: Optional[Union[str, os.PathLike[str]]] = None, **keys: Any) -> Pattern:
    """The pattern of a scenario, or of the keys of its section [garment]:

        loosefit.pattern(pattern="t-shirt", fit={"chest": 0.2}, body={"sex": "male"})
        loosefit.pattern(pattern="long-sleeve-shirt", size="women-38")
        loosefit.pattern(pattern="dress.json")

    body: keys of [body] of the wearer it is drafted for, or compared with; None: the default woman.
    `progress`, `cancel`, `data_dir` as for `run`. Raises InputError, GeometryError for what cannot be
    drafted or sewn; IoError; Cancelled.
    """
    if scenario is not None and (keys or body is not None):
        raise TypeError("pattern() takes a scenario or keys of [garment] and a body, not both")
    if scenario is None:
        scenario = {"garment": keys} if body is None else {"body": body, "garment": keys}
    read = read_scenario(scenario)
    with body_data(data_dir):
        return Pattern(_core.make_pattern(read, progress, cancel))
