"""Many cases: the database of a study as tables of columns."""
from __future__ import annotations

import difflib
import hashlib
import json
import os
import pathlib
import sqlite3
from collections.abc import Mapping
from typing import Any, Optional, Union

from loosefit._errors import InputError, IoError


class Study:
    """A study that was run, read from its database; nothing is changed.

    Tables are those of docs/studies.md: study, axes, cases, levels, inputs, body, fit, garment, maps, sites,
    samples, metrics, notes, versions, execution.
    """

    def __init__(self, folder: Union[str, os.PathLike[str]]) -> None:
        if not os.fspath(folder).strip():  # Path would take it for the folder at hand
            raise InputError("folder: found an empty name, expected the folder of a study")
        self.folder = pathlib.Path(folder)
        self._file = self.folder / "study.sqlite"
        if not self._file.is_file():
            raise InputError(f"{self.folder}: found no study.sqlite, expected the folder of a study")

    def __repr__(self) -> str:
        return f"<loosefit.Study {self.facts.get('name')!r} of {len(self.table('cases')['number'])} cases>"

    def query(self, sql: str, values: Union[tuple[Any, ...], Mapping[str, Any]] = ()) -> dict[str, list[Any]]:
        """The columns that a SELECT gives, by name; None where there is no value.

        pandas.DataFrame takes them as they are. Raises IoError when the database cannot be read so.
        """
        try:
            connection = sqlite3.connect(f"{self._file.absolute().as_uri()}?mode=ro", uri=True, timeout=60)
            try:
                cursor = connection.execute(sql, values)
                names = [column[0] for column in cursor.description or ()]
                rows = cursor.fetchall()
            finally:
                connection.close()
        except sqlite3.Error as error:
            raise IoError(f"{self._file}: {error}") from None
        return {name: [row[i] for row in rows] for i, name in enumerate(names)}

    @property
    def tables(self) -> list[str]:
        """Names of the tables."""
        return self.query("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name")["name"]

    def table(self, name: str) -> dict[str, list[Any]]:
        """A whole table as columns. Raises InputError for an unknown name."""
        if name not in self.tables:
            raise InputError(f"table: found {name!r}, expected one of {', '.join(self.tables)}")
        return self.query(f'SELECT * FROM "{name}"')

    @property
    def facts(self) -> dict[str, str]:
        """What the table study says: name, version, seed, design, scorecards, …"""
        rows = self.query("SELECT key, value FROM study")
        return dict(zip(rows["key"], rows["value"]))

    def scores(self, modality: Optional[str] = None, site: Optional[str] = None) -> dict[str, list[Any]]:
        """One row per case, modality, site and donning: score and what limits it, with the label of every axis.

        An axis that is called as one of these columns ("site") is the column "axis site". Cases without scores (failed, sealed, not run) have no row.
        Raises InputError for a modality or site that the study does not have scores of; where no case has scores, none is known and nothing is refused.
        """
        self._check_name("modality", modality)
        self._check_name("site", site)
        axes = self.query("SELECT axis FROM axes ORDER BY position")["axis"]
        columns = self.query(
            "SELECT s.*, c.status FROM samples s JOIN cases c USING (number) "
            "WHERE (:modality IS NULL OR modality = :modality) AND (:site IS NULL OR site = :site) "
            "ORDER BY number, modality, site, donning", {"modality": modality, "site": site})
        for axis in axes:
            rows = self.query("SELECT number, label FROM levels WHERE axis = ?", (axis,))
            label = dict(zip(rows["number"], rows["label"]))
            columns[f"axis {axis}" if axis in columns else axis] = [label[number] for number in columns["number"]]
        return columns

    def _check_name(self, key: str, asked: Optional[str]) -> None:
        """A name that the study does not know would silently select nothing. A study without any scores knows none."""
        known = self.query(f"SELECT DISTINCT {key} FROM sites ORDER BY 1")[key]
        if asked is None or not known or asked in known:
            return
        near = difflib.get_close_matches(asked, known, 1)
        raise InputError(f"{key}: found {asked!r}, expected one of {', '.join(known)}"
                         + (f"; did you mean {near[0]!r}?" if near else ""))

    @property
    def report(self) -> dict[str, Any]:
        """The statistics, as the page shows them (study-report.json).

        Raises IoError without them, and where they are of another plan than the database: a run of the changed study
        was interrupted.
        """
        try:
            report = json.loads((self.folder / "study-report.json").read_text(encoding="utf-8"))
        except OSError as error:
            raise IoError(f"{self.folder}: {error.strerror}: study-report.json; "
                          "loosefit study report DIR makes it") from None
        except ValueError as error:
            raise IoError(f"{self.folder / 'study-report.json'}: {error}; "
                          "loosefit study report DIR makes it anew") from None
        planned = self._plan_sha256()
        if report.get("plan_sha256", planned) != planned:
            raise IoError(f"{self.folder / 'study-report.json'}: found the report of another plan of the study than "
                          "the database; loosefit study report DIR makes it anew")
        return report

    def _plan_sha256(self) -> str:
        """As the program reckons it: of the study file and the addresses of all cases."""
        lines = [self.facts["file_sha256"], *self.query("SELECT address FROM cases ORDER BY number")["address"]]
        return hashlib.sha256("".join(f"{line}\n" for line in lines).encode()).hexdigest()

    @property
    def headlines(self) -> list[str]:
        """A sentence per kind of sensor: how loose it may be, or where it works."""
        return self.report["headlines"]


def study(folder: Union[str, os.PathLike[str]]) -> Study:
    """Opens the folder of `loosefit study run`. Raises InputError when it is none."""
    return Study(folder)
