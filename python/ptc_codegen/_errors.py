"""The exceptions and the warning of the package."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple


class Mistake(NamedTuple):
    """One mistake in a design."""

    line: int | None
    """Number of its line in the text, from 1; None for what is missing, for checks, and for arguments."""
    code: str
    """Stable short name of the kind of mistake; ``ptc-codegen explain CODE`` explains it."""
    key: str
    """The key that is wrong, for example ``mu.a``; empty if it is no key's."""
    message: str
    """What is wrong, with the bad value."""
    help: str
    """What is legal, and the likely fix."""

    def __str__(self) -> str:
        line = "" if self.line is None else f"line {self.line}: "
        key = f"{self.key}: " if self.key else ""
        return f"{line}{key}{self.message}; {self.help}"


class DesignError(ValueError):
    """Mistakes in a design, or checks that refuse it: all of them at once."""

    mistakes: tuple[Mistake, ...]
    """At least one, in the order of the keys."""

    def __init__(self, mistakes: Sequence[tuple[int | None, str, str, str, str]]) -> None:
        self.mistakes = tuple(Mistake(*mistake) for mistake in mistakes)
        super().__init__(list(self.mistakes))

    def __str__(self) -> str:
        return "\n".join(map(str, self.mistakes))


def mistake(key: str, message: str, help: str) -> DesignError:
    """One mistake in an argument."""
    return DesignError([(None, "bad-value", key, message, help)])


class RunError(ArithmeticError):
    """A simulation that ended early."""

    def __init__(self, message: str, help: str, at: float | None, undecided: bool) -> None:
        super().__init__(message, help, at, undecided)
        self.message = message
        """What happened, and when."""
        self.help = help
        """What may help."""
        self.at = at
        """Time t in s that the run reached; None if it did not begin."""
        self.undecided = undecided
        """Whether the integration could not be finished, which says nothing of the loop; otherwise the
        loop leaves the range of numbers."""

    def __str__(self) -> str:
        return f"{self.message}; {self.help}"


class DesignWarning(UserWarning):
    """A check that refuses the design of a simulation, or a call that its controller refuses."""
