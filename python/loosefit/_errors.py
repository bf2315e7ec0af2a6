"""What Loosefit raises on purpose."""
from __future__ import annotations


class Error(Exception):
    """Base of everything that Loosefit raises on purpose.

    message: one line; hint: what to try, may be empty. `str()` shows both.
    """

    def __init__(self, message: str, *, hint: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.hint = hint

    def __str__(self) -> str:
        return f"{self.message}\nhint: {self.hint}" if self.hint else self.message


class InputError(Error, ValueError):
    """The caller gave something that cannot be used.

    place: where it stands, "case.toml:3: garment.fit.chest"; file, line (0: not known) and key: its
    parts; found and expected: what stands there and what should (empty where the message is one
    sentence).
    """

    def __init__(self, message: str, *, hint: str = "", place: str = "", file: str = "",
                 line: int = 0, key: str = "", found: str = "", expected: str = "") -> None:
        super().__init__(message, hint=hint)
        self.place = place
        self.file = file
        self.line = line
        self.key = key
        self.found = found
        self.expected = expected


class GeometryError(InputError):
    """Geometry that cannot be processed: an open mesh, a seam that cannot close."""


class IoError(Error, OSError):
    """A file could not be read or written, or the body data are missing."""


class SolverFailure(Error, RuntimeError):
    """A numerical method gave up; the message says which and why."""


class NotSettled(Error, RuntimeError):
    """Maps were asked of a drape that is not settled and worn, without saying so by name."""


class Cancelled(Error):
    """The work was stopped by a CancelToken or by a progress that returned False.

    Nothing was written. Ctrl-C raises KeyboardInterrupt instead.
    """
