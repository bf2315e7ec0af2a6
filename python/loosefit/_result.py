"""What a run yields."""
from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Optional, Union

from loosefit import _core
from loosefit._body import Body, Floats, Ints, Progress
from loosefit._errors import Error, NotSettled
from loosefit._pattern import Pattern
from loosefit._records import site_records

if TYPE_CHECKING:
    from loosefit._ranking import Ranking


@dataclass(frozen=True)
class Certificate:
    """Proof that a drape is at rest and worn, or why it is not (docs/outputs.md)."""

    #: Grade A or B, and no intersection.
    settled: bool
    #: Limbs go through their openings, and these lie where they were made for.
    worn: bool
    #: What speaks against it, a sentence each.
    worn_reasons: list[str]
    #: Every opening lets pass what has to, without a fastening; None: not judged. `worn` does not
    #: ask for it, since patterns do not tell fastenings.
    can_be_put_on: Optional[bool]
    #: Why not, or why it is not judged, a sentence each.
    can_be_put_on_reasons: list[str]
    #: Norm of the net forces over that of the weights.
    residual: float
    #: Largest net force over the mean weight of a particle.
    residual_max: float
    #: Triangle pairs by an exact test; -1: not tested.
    intersections_body: int
    intersections_self: int
    #: Of those with itself, between two garments, and edges folded flat.
    intersections_layers: int
    folded_edges: int
    #: Whether the balance is a minimum of the energy; None: not tested.
    stable: Optional[bool]
    #: Why the solver stopped.
    stop_reason: str

    @property
    def holds(self) -> bool:
        """Settled and worn: what maps ask for."""
        return self.settled and self.worn


@dataclass(frozen=True, eq=False)
class Map:
    """One quantity on a garment."""

    #: As in drape.vtp, unit in the name: "distance_mm".
    name: str
    title: str
    #: Of `values`: "mm", "deg", "kPa", "1" (dimensionless).
    unit: str
    #: (n,) one value per vertex; NaN where it is not defined.
    values: Floats
    #: Colour range that is fixed for this quantity, so that pictures can be compared.
    range: tuple[float, float]
    #: Signed: colours split at zero.
    diverging: bool
    #: What it is, in words, and its formula (docs/maps.md).
    meaning: str
    formula: str
    #: Area-weighted over the garment: min, p5, median, p95, max, area_mean, undefined_vertices.
    statistics: dict[str, Any]
    #: The same per body region that has a value.
    regions: dict[str, dict[str, Any]]


class Maps(Mapping[str, Map]):
    """Maps by name; a name that is not there is told which are."""

    def __init__(self, maps: dict[str, Map]) -> None:
        self._maps = maps

    def __getitem__(self, name: str) -> Map:
        if name not in self._maps:
            raise KeyError(f"{name}: the maps made are {', '.join(self._maps) or 'none'}; others are "
                           "asked for by [output] maps of the scenario, or by Result.remapped")
        return self._maps[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._maps)

    def __len__(self) -> int:
        return len(self._maps)

    def __repr__(self) -> str:
        return f"<loosefit.Maps {', '.join(self._maps)}>"


def _maps_of(core: _core.Worn, summary: Mapping[str, Any]) -> Maps:
    maps = {}
    for row in core.maps():
        told = dict(summary.get(row["name"], {}))
        regions = told.pop("regions", {})
        unit = "1" if row["unit"] == "\N{EN DASH}" else row["unit"]
        maps[row["name"]] = Map(**{**row, "unit": unit}, statistics=told, regions=regions)
    return Maps(maps)


class Garment:
    """One garment as worn in one posture after one donning."""

    def __init__(self, core: _core.Worn, summary: Mapping[str, Any], sealed: str = "") -> None:
        self._core = core
        self._summary = summary
        self._sealed = sealed

    def __repr__(self) -> str:
        return f"<loosefit.Garment of {len(self.vertices)} vertices>"

    @property
    def vertices(self) -> Floats:
        """(n, 3) where the cloth is, world frame, m."""
        return self._core.vertices()

    @property
    def triangles(self) -> Ints:
        """(m, 3) corners, counter-clockwise seen from outside."""
        return self._core.triangles()

    @cached_property
    def normals(self) -> Floats:
        """(n, 3) unit normals, outwards."""
        return self._core.normals()

    @property
    def pattern_uv(self) -> Floats:
        """(n, 2) place of each vertex in the flat pattern, in the panel `panel_id`, m.

        A vertex on a seam lies in several panels: `corner_uv` has all of them.
        """
        return self._core.pattern_uv()

    @property
    def panel_id(self) -> Ints:
        """(n,) panel of each vertex (of those that meet in a seam the first): index into
        `panel_names`."""
        return self._core.panel_id()

    @property
    def panel_names(self) -> list[str]:
        """Names to the numbers of `panel_id`."""
        return self._core.panel_names()

    @property
    def triangle_panel_id(self) -> Ints:
        """(m,) panel of each triangle: index into `panel_names`."""
        return self._core.triangle_panel_id()

    @property
    def corner_uv(self) -> Floats:
        """(m, 3, 2) place of each corner of each triangle in the triangle's panel, m."""
        return self._core.corner_uv()

    @property
    def mass_kg(self) -> Floats:
        """(n,) lumped mass of cloth, seams and attachments, kg."""
        return self._core.mass_kg()

    @property
    def body_normal_force_N(self) -> Floats:
        """(n,) size of the normal force of the body on each vertex, N; (0,) where not known."""
        return self._core.body_normal_force_N()

    @cached_property
    def _maps(self) -> Maps:
        return _maps_of(self._core, self._summary)

    @property
    def maps(self) -> Maps:
        """Name to Map. Raises NotSettled while they are sealed (`Result.remapped`)."""
        if self._sealed:
            raise NotSettled(self._sealed,
                             hint="allow_unsettled=True of run, load or Result.remapped makes maps "
                             "all the same")
        return self._maps

    @cached_property
    def pattern(self) -> Pattern:
        """The flat pieces."""
        return Pattern(self._core.pattern())


class State:
    """The garments in one more posture, or after one more donning."""

    def __init__(self, core: _core.Case, index: int, row: dict[str, Any],
                 summary: Mapping[str, Any]) -> None:
        self._core = core
        self._index = index
        self._summary = summary
        self._draped: bool = row.pop("draped")
        #: Name of the posture.
        self.posture: str = row.pop("posture")
        #: From 1; the first is undisturbed unless the scenario says that it is drawn too.
        self.donning: int = row.pop("donning")
        #: False: left out of every statistic.
        self.counts: bool = row.pop("counts")
        #: Why there is no drape to speak of; else empty.
        self.left_out: str = row.pop("left_out")
        self.certificate = Certificate(**row)

    def __repr__(self) -> str:
        return f"<loosefit.State {self.posture!r}, donning {self.donning}>"

    @cached_property
    def garments(self) -> tuple[Garment, ...]:
        """The innermost first, the studied one, which alone has maps, last; none without a drape.

        In the reference posture its maps are those of the case, in others its slip.
        """
        if not self._draped:
            return ()
        count = self._core.garment_count()
        refused = "" if self.counts else f"posture {self.posture}: {self._why()}"
        return tuple(
            Garment(self._core.worn_in_state(self._index, g), self._summary.get("maps", {}), refused)
            for g in range(count))

    def _why(self) -> str:
        return self.left_out or "not settled or not worn: " + self.certificate.stop_reason

    @property
    def garment(self) -> Garment:
        """The studied one. Raises Error when there is no drape."""
        if not self._draped:
            raise Error(f"posture {self.posture}, donning {self.donning}: no drape: {self.left_out}")
        return self.garments[-1]

    @property
    def maps(self) -> Maps:
        """Of the studied garment."""
        return self.garment.maps

    @cached_property
    def body(self) -> Body:
        """The wearer in this posture."""
        return Body(self._core.body_of_state(self._index))

    @cached_property
    def sites(self) -> list[dict[str, Any]]:
        """As Result.sites, of this state alone: turn and slip are those since the reference posture."""
        return site_records(self._summary.get("sites", {}), {})


class Result:
    """Everything that one case yields.

    `vertices`, `maps` and the like are those of the studied garment in the reference posture after
    the first donning; `garments` has those under it, `states` other postures and donnings.
    """

    def __init__(self, core: _core.Case, name: str = "run") -> None:
        self._core = core
        self._name = name

    def __repr__(self) -> str:
        c = self.certificate
        state = "settled and worn" if c.holds else "not worn" if c.settled else "not settled"
        return f"<loosefit.Result: {len(self.vertices)} vertices, {state}>"

    # Whether it counts.

    @cached_property
    def certificate(self) -> Certificate:
        """Of all garments together."""
        return Certificate(**self._core.certificate())

    @property
    def sealed(self) -> bool:
        """Not settled or not worn, and maps were not asked for all the same."""
        return self._core.sealed()

    @property
    def warnings(self) -> list[str]:
        """What the report warns of, a sentence each."""
        return self._core.warnings()

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The content of summary.json (docs/outputs.md)."""
        return json.loads(self._core.summary())

    @cached_property
    def scenario(self) -> str:
        """The resolved scenario as TOML, every default written out."""
        return self._core.scenario()

    # What is worn, by whom.

    @cached_property
    def garments(self) -> tuple[Garment, ...]:
        """The innermost first; the last one is studied."""
        count = self._core.garment_count()
        sealed = self._sealed_message()
        told = [garment.get("maps", {}) for garment in self.summary.get("garments", [{}] * count)]
        told[-1] = self.summary.get("maps", {})
        return tuple(Garment(self._core.worn(g), told[g], sealed) for g in range(count))

    def _sealed_message(self) -> str:
        if not self.sealed:
            return ""
        c = self.certificate
        if c.settled:
            return "the garment is not worn: " + "; ".join(c.worn_reasons)
        why, _ = self._core.why()
        return "the drape is not settled: " + (why or c.stop_reason)

    @property
    def garment(self) -> Garment:
        """The studied one."""
        return self.garments[-1]

    @cached_property
    def body(self) -> Body:
        """The wearer in the posture of the maps."""
        return Body(self._core.body())

    @cached_property
    def states(self) -> tuple[State, ...]:
        """Every posture and donning but the reference."""
        rows = self._core.states()
        told = self.summary.get("states", [])
        return tuple(State(self._core, i, row, told[i]) for i, row in enumerate(rows))

    # The studied garment.

    @property
    def vertices(self) -> Floats:
        """(n, 3) where the cloth is, world frame, m."""
        return self.garment.vertices

    @property
    def triangles(self) -> Ints:
        """(m, 3) corners, counter-clockwise seen from outside."""
        return self.garment.triangles

    @property
    def normals(self) -> Floats:
        """(n, 3) unit normals, outwards."""
        return self.garment.normals

    @property
    def pattern_uv(self) -> Floats:
        """(n, 2) place in the flat pattern, m; see Garment.pattern_uv."""
        return self.garment.pattern_uv

    @property
    def panel_id(self) -> Ints:
        """(n,) panel of each vertex: index into `panel_names`."""
        return self.garment.panel_id

    @property
    def panel_names(self) -> list[str]:
        """Names to the numbers of `panel_id`."""
        return self.garment.panel_names

    @property
    def maps(self) -> Maps:
        """Name to Map. Raises NotSettled for a sealed drape."""
        return self.garment.maps

    @property
    def pattern(self) -> Pattern:
        """The flat pieces."""
        return self.garment.pattern

    @cached_property
    def sites(self) -> list[dict[str, Any]]:
        """A record per place of a sensor, as the rows of sites.csv; pandas.DataFrame takes it.

        A metric of scorecards is that of the site's sensor, the median over the donnings;
        `<array>_map` is the mean of a map's points in the footprint.

        Of a wished site that the garment does not cover only the name is known. Raises NotSettled
        for a sealed drape.
        """
        if self.sealed:
            raise NotSettled(self._sealed_message())
        return site_records(self.summary.get("sites", {}), self.summary.get("uncovered_sites", {}))

    @property
    def answers(self) -> list[dict[str, Any]]:
        """What to sew where and what to expect, a record per sensor, as on the first screen of the
        page; `text` has it in words. Empty for a sealed drape."""
        return self.summary.get("answers", [])

    @cached_property
    def ranking(self) -> Optional[Ranking]:
        """As section [ranking] of the scenario asks; None without one. See also loosefit.rank."""
        from loosefit._ranking import Ranking
        core = _core.ranking_of_case(self._core)
        return None if core is None else Ranking(core)

    # What can be made of it.

    def remapped(self, maps: Optional[Sequence[str]] = None, *, allow_unsettled: bool = False,
                 progress: Optional[Progress] = None,
                 cancel: Optional[_core.CancelToken] = None) -> Result:
        """The same drape with its maps and sites made again, as `loosefit map`.

        maps: words of [output] maps (docs/maps.md); None: those of the scenario. allow_unsettled:
        make them even of a drape that is not settled or not worn. Raises NotSettled, InputError for
        an unknown map, Cancelled.
        """
        if not allow_unsettled and not self.certificate.holds:
            raise NotSettled(self._sealed_message() or "the drape is not settled and worn",
                             hint="allow_unsettled=True makes maps all the same")
        if isinstance(maps, str):
            maps = [maps]
        return Result(self._core.remapped(list(maps or []), allow_unsettled, progress, cancel),
                      self._name)

    def write(self, folder: Union[str, os.PathLike[str]], *, pictures: bool = False,
              progress: Optional[Progress] = None,
              cancel: Optional[_core.CancelToken] = None) -> None:
        """Writes what `loosefit run` writes, but for log.jsonl, all of it or nothing.

        folder: a new or empty one, or an earlier output, of which only unchanged files of Loosefit
        are replaced. pictures: also draw the maps, on a screen of its own where there is
        none; without one there are no pictures, and a warning. Raises InputError when something
        foreign is in the way, IoError, Cancelled.
        """
        self._core.write(os.fspath(folder), pictures, progress, cancel)
