"""Which places are best for a sensor."""
from __future__ import annotations

import json
import os
from collections.abc import Sequence
from functools import cached_property
from typing import Any, Optional, Union

from loosefit import _core
from loosefit._body import Progress
from loosefit._errors import InputError, NotSettled
from loosefit._records import ranking_records
from loosefit._result import Result
from loosefit._run import load


class Ranking:
    """Sites ranked for a kind of sensor, best first."""

    def __init__(self, core: _core.Ranking) -> None:
        self._core = core

    def __repr__(self) -> str:
        return f"<loosefit.Ranking of {len(self.records)} sites for {self.details['modality']!r}>"

    def __str__(self) -> str:
        return self._core.text()

    @cached_property
    def details(self) -> dict[str, Any]:
        """The content of ranking-NAME.json (docs/outputs.md): every sample of every metric."""
        return json.loads(self._core.json())

    @cached_property
    def records(self) -> list[dict[str, Any]]:
        """A record per site, as the rows of ranking-NAME.csv; pandas.DataFrame takes it.

        None where there is no value.
        """
        return ranking_records(self.details)

    @property
    def verdict(self) -> str:
        """One sentence where no site passes or none can be rated; else empty."""
        return self.details["verdict"]

    @property
    def notes(self) -> list[str]:
        """What the reader should know beside the rows."""
        return self.details["notes"]

    def write(self, folder: Union[str, os.PathLike[str]]) -> None:
        """Writes ranking-NAME.csv, .json and sewing-plan-NAME.svg into a folder, all or none.

        Raises InputError when something foreign is in the way, IoError.
        """
        self._core.write(os.fspath(folder))


RankedLike = Union[Result, str, "os.PathLike[str]"]


def rank(runs: Union[RankedLike, Sequence[RankedLike]], modality: Union[str, os.PathLike[str]], *,
         best: int = 0, sites: Optional[bool] = None, spacing_mm: float = 50, seam_mm: float = 10,
         edge_mm: float = 10, keep_out: Sequence[str] = (), regions: Sequence[str] = (),
         partial: bool = False, seed: int = 1, progress: Optional[Progress] = None,
         cancel: Optional[_core.CancelToken] = None) -> Ranking:
    """Ranks the sites of one or several runs for a kind of sensor, as `loosefit rank`.

    runs: results, or folders of earlier outputs; several are samples of one population.
    modality: name of a scorecard (docs/scorecards.md), or the path of one that ends in .toml.
    best: search for so many more places of the garment, called best_1, ...
    sites: rank the scenario's sites and the presets; None: unless there is a search.
    spacing_mm: between places found; seam_mm, edge_mm: from them to seams, and to hems and openings.
    keep_out: "PANEL:u,v,u,v" (rectangle) or "PANEL:u,v,radius" in m, or a region of the body.
    regions: search only over these parts of the body.
    partial: judge by what these drapes can tell; scores are then upper bounds.
    seed: of candidates and bootstrap.

    Raises NotSettled for a run without maps, InputError, IoError, Cancelled.
    """
    if isinstance(runs, (Result, str, os.PathLike)):
        runs = [runs]
    results = [run if isinstance(run, Result) else load(run) for run in runs]
    if not results:
        raise InputError("runs: found none, expected at least one", place="runs", key="runs",
                         found="none", expected="at least one")
    for result in results:
        if result.sealed:
            raise NotSettled(result._sealed_message(),
                             hint="allow_unsettled=True of run, load or Result.remapped makes maps "
                             "all the same")
    names = [result._name for result in results]
    if len(set(names)) < len(names):
        names = [f"{name} {i}" for i, name in enumerate(names, 1)]
    wish = _core.RankingWish(
        modality=os.fspath(modality), best=best, sites=best == 0 if sites is None else sites,
        spacing_mm=spacing_mm, seam_mm=seam_mm, edge_mm=edge_mm, keep_out=list(keep_out),
        regions=list(regions), partial=partial, seed=seed)
    return Ranking(_core.rank([result._core for result in results], names, wish, progress, cancel))
