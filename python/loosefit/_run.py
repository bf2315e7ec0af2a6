"""Running cases, and taking earlier ones up again."""
from __future__ import annotations

import os
from typing import Optional, Union

from loosefit import _core
from loosefit._body import Progress
from loosefit._data import body_data
from loosefit._result import Result
from loosefit._scenario import ScenarioLike, read_scenario

PathLike = Union[str, "os.PathLike[str]"]


def run(scenario: ScenarioLike, *, out: Optional[PathLike] = None, pictures: bool = False,
        allow_unsettled: bool = False, progress: Optional[Progress] = None,
        cancel: Optional[_core.CancelToken] = None,
        data_dir: Optional[PathLike] = None) -> Result:
    """The whole pipeline: body, pattern, garment, dress, settle, maps, placement.

    scenario: a dict with the keys of a scenario file (docs/scenario.md), a TOML text, or a path. A
        str is a path when it ends in .toml and has no line break.
    out: folder to write, as `loosefit run -o`; None: nothing is written.
    pictures: draw the maps into `out`, on a screen of its own where there is none.
    allow_unsettled: make maps even of a drape that did not settle or is not worn.
    progress: called as progress(stage, fraction in 0..1) from this thread, about twenty times a
        second; `print` will do. Returning False asks the run to stop.
    cancel: a CancelToken by which another thread can ask the run to stop.
    data_dir: folder of the baked body data; None: as LOOSEFIT_DATA or the build says.

    Other Python threads go on meanwhile. Ctrl-C in the main thread stops the run and leaves no files;
    so do `cancel` and `progress`. A drape that does not settle is no error: see Result.certificate.

    Raises InputError (GeometryError) for a scenario that cannot be used, IoError, SolverFailure,
    Cancelled, KeyboardInterrupt, and whatever `progress` raises.
    """
    read = read_scenario(scenario)
    if pictures and out is None:
        raise TypeError("run() draws pictures only into a folder: out=")
    with body_data(data_dir):
        folder = None if out is None else os.fspath(out)
        core = _core.run(read, folder, pictures, allow_unsettled, progress, cancel)
    return Result(core, "run" if folder is None else os.path.basename(os.path.abspath(folder)))


def load(folder: PathLike, *, allow_unsettled: bool = False, progress: Optional[Progress] = None,
         cancel: Optional[_core.CancelToken] = None,
         data_dir: Optional[PathLike] = None) -> Result:
    """An earlier output of `loosefit run` or `drape`, with its maps and sites made again.

    The drape is read, not simulated; body, pattern and mesh are made anew and checked against the
    files. Arguments as of `run`. Raises InputError for what is no output, or does not belong
    together; IoError; Cancelled.
    """
    with body_data(data_dir):
        core = _core.load(os.fspath(folder), allow_unsettled, progress, cancel)
    return Result(core, os.path.basename(os.path.abspath(folder)))
