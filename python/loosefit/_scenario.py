"""What callers may give as a scenario."""
from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, Union

from loosefit import _core
from loosefit._errors import InputError

#: A dict with the keys of a scenario file, a TOML text, or a path.
ScenarioLike = Union[Mapping[str, Any], str, "os.PathLike[str]"]


def read_scenario(scenario: ScenarioLike) -> _core.Scenario:
    """A str is a path when it ends in .toml and has no line break, else TOML text.

    Files named in a scenario file are relative to its folder, in a dict or text to the working
    directory. Raises InputError, IoError.
    """
    if isinstance(scenario, Mapping):
        return _core.Scenario.of_mapping(scenario)
    if isinstance(scenario, str):
        if scenario.endswith(".toml") and "\n" not in scenario:
            return _core.Scenario.of_file(scenario)
        return _core.Scenario.of_text(scenario)
    if isinstance(scenario, os.PathLike):
        return _core.Scenario.of_file(scenario)
    found = f"a {type(scenario).__name__}"
    expected = "a dict, a TOML text, or a path"
    raise InputError(f"scenario: found {found}, expected {expected}", place="scenario",
                     key="scenario", found=found, expected=expected)
