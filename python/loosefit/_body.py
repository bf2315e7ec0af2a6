"""Bodies."""
from __future__ import annotations

import os
from collections.abc import Callable
from functools import cached_property
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from loosefit import _core
from loosefit._data import body_data
from loosefit._scenario import ScenarioLike, read_scenario

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int32]
#: Called as progress(stage, fraction); returning False asks the work to stop.
Progress = Callable[[str, float], Any]

#: Names to the numbers of `Body.segment`.
SEGMENTS = ("head", "neck", "torso", "upper_arm", "forearm", "hand", "thigh", "shank", "foot")


class Body:
    """A closed body surface in one posture, world frame."""

    def __init__(self, core: _core.Body) -> None:
        self._core = core

    def __repr__(self) -> str:
        return (f"<loosefit.Body of {len(self.vertices)} vertices, "
                f"{self.measured.get('height', float('nan')):.2f} m tall>")

    @property
    def vertices(self) -> Floats:
        """(n, 3) surface points, m."""
        return self._core.vertices()

    @property
    def triangles(self) -> Ints:
        """(m, 3) corners, counter-clockwise seen from outside."""
        return self._core.triangles()

    @cached_property
    def normals(self) -> Floats:
        """(n, 3) smooth unit normals, outwards."""
        return self._core.normals()

    @property
    def segment(self) -> Ints:
        """(n,) body part of each vertex: index into `segment_names`."""
        return self._core.segment()

    @property
    def segment_names(self) -> tuple[str, ...]:
        """Names to the numbers of `segment`."""
        return SEGMENTS

    @property
    def side(self) -> Ints:
        """(n,) +1 the wearer's left, -1 right, 0 trunk and head."""
        return self._core.side()

    @cached_property
    def measured(self) -> dict[str, float]:
        """Tape measures taken on this person in the rest posture: m, slopes rad, volume m3, mass kg."""
        return self._core.measured()

    @property
    def girths(self) -> dict[str, float]:
        """Those of `measured` that go round the body, m."""
        names = ("chest", "underbust", "waist", "hip", "neck", "upper_arm", "elbow", "forearm",
                 "wrist", "thigh", "knee", "calf", "ankle", "head")
        return {name: self.measured[name] for name in names if name in self.measured}

    @cached_property
    def landmarks(self) -> dict[str, Floats]:
        """Name to (3,) place on the skin, m."""
        return self._core.landmarks()

    @cached_property
    def joints(self) -> dict[str, Floats]:
        """Name to (3,) centre, m."""
        return self._core.joints()

    @cached_property
    def asked(self) -> list[dict[str, Any]]:
        """Records of wished against measured: name, asked_m, measured_m."""
        return self._core.asked()

    @property
    def warnings(self) -> list[str]:
        """Of the fit to the wishes, or of the check of a scan."""
        return self._core.warnings()

    def write(self, folder: Union[str, os.PathLike[str]]) -> None:
        """Adds body.obj, body.vtp and body.json to a folder, or makes it, as `loosefit body -o`.

        Raises InputError when something foreign is in the way, IoError.
        """
        self._core.write(os.fspath(folder))


def body(scenario: Optional[ScenarioLike] = None, /, *, progress: Optional[Progress] = None,
         cancel: Optional[_core.CancelToken] = None,
         data_dir: Optional[Union[str, os.PathLike[str]]] = None, **keys: Any) -> Body:
    """The body of a scenario, or of the keys of its section [body], lengths in m:

        loosefit.body(sex="male", height=1.80, measurements={"chest": 1.0}, posture="sitting")
        loosefit.body(file="scan.obj", units="mm")

    Without either the default woman. `progress`, `cancel`, `data_dir` as for `run`.
    Raises InputError for impossible wishes or a broken scan; IoError without body data; Cancelled.
    """
    if scenario is not None and keys:
        raise TypeError("body() takes a scenario or keys of [body], not both")
    read = read_scenario({"body": keys} if scenario is None else scenario)
    with body_data(data_dir):
        return Body(_core.make_body(read, progress, cancel))
