"""Where the body data are."""
from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Optional, Union

from loosefit._errors import InputError

PathLike = Union[str, "os.PathLike[str]"]

_lock = threading.Lock()
_in_use: Optional[str] = None


@contextmanager
def body_data(data_dir: Optional[PathLike]) -> Iterator[None]:
    """Work that may load the body data: from `data_dir`, else as LOOSEFIT_DATA or the build says.

    They are loaded once per process, so another folder later on is an InputError.
    """
    global _in_use
    with _lock:
        before, told = _in_use, os.environ.get("LOOSEFIT_DATA")
        wanted = told or ""
        if data_dir is not None:
            wanted = os.path.abspath(data_dir)
            if before is not None and wanted != before:
                expected = f'"{before}"' if before else "none, as before"
                raise InputError(f'data_dir: found "{wanted}", expected {expected}',
                                 hint="the body data are loaded once per process",
                                 place="data_dir", key="data_dir", found=f'"{wanted}"',
                                 expected=expected)
            os.environ["LOOSEFIT_DATA"] = wanted
        _in_use = wanted
    try:
        yield
    except OSError:
        with _lock:
            if before is None:  # perhaps they are not there: the next call may say where
                _in_use = None
                if data_dir is not None:
                    os.environ.pop("LOOSEFIT_DATA")
                    if told is not None:
                        os.environ["LOOSEFIT_DATA"] = told
        raise
