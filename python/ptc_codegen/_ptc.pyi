"""The extension module; `ptc` has its documentation."""

from collections.abc import Callable, Sequence
from os import PathLike
from typing import TypedDict, final

from typing_extensions import Self, TypeAlias

__all__ = ["Design", "card", "check", "command", "draw", "emit", "merge", "part", "signals", "simulate", "verify"]

_Given: TypeAlias = Sequence[tuple[str, str]]
_Progress: TypeAlias = Callable[[int, int], object] | None

class _Run(TypedDict):
    tau: float
    t0: float
    states: list[str]
    inputs: list[str]
    units: list[str | None]
    t: bytearray
    stretched: bytearray
    x: bytearray
    u: bytearray
    y: bytearray | None
    status: list[int] | None
    error: list[float] | None
    warnings: list[str]

class _Drawn(TypedDict):
    design: Design
    label: str | None
    tau: float
    t0: float
    held: bool
    t: bytes
    stretched: bytes
    x: bytes
    u: bytes

class _Objective(TypedDict):
    text: str
    holds: bool | None
    verdict: str
    excess: float
    worst: str
    details: list[str]

class _Trajectory(TypedDict):
    scenario: str
    t: bytearray
    time_to_go: bytearray
    x: bytearray
    u: bytearray
    excess: bytearray
    states: int
    ended: str | None

class _Verdict(TypedDict):
    holds: bool | None
    objectives: list[_Objective]
    text: str
    columns: list[str]
    units: list[str | None]
    rows: bytearray | None
    states: list[str]
    inputs: list[str]
    units_of_run: list[str | None]
    worst: _Trajectory | None

@final
class Design:
    def __new__(cls, text: str, given: _Given) -> Self: ...
    @staticmethod
    def load(path: str | PathLike[str], given: _Given) -> Design: ...
    @property
    def text(self) -> str: ...
    @property
    def given(self) -> list[tuple[str, str]]: ...
    def replace(self, given: _Given) -> Self: ...
    def number(self, key: str) -> float | None: ...
    def start(self) -> list[float]: ...
    @property
    def name(self) -> str: ...
    @property
    def command(self) -> str: ...
    @property
    def states(self) -> list[str]: ...
    def fingerprint(self) -> str: ...
    def chosen(self) -> list[tuple[str, str, str]]: ...

def card(design: Design, picture: tuple[str, str] | None, problem: str) -> str: ...
def command(line: Sequence[str]) -> int: ...
def draw(runs: Sequence[_Drawn], by_decades: bool, format: str) -> bytes: ...
def emit(design: Design, lang: str, selftest: bool) -> list[tuple[str, str]]: ...
def check(
    design: Design,
) -> tuple[list[tuple[str, str, str, list[str], str | None]], list[str], list[str], str, str]: ...
def signals() -> list[str]: ...
def simulate(
    design: Design,
    x0: Sequence[float],
    at: Sequence[float] | None,
    seed: int,
    until: float | None,
    arm_at: Sequence[float],
    progress: _Progress,
) -> _Run: ...
def verify(design: Design, given: _Given, rows: bool, progress: _Progress) -> _Verdict: ...
def part(
    design: Design, given: _Given, place: tuple[int, int], progress: _Progress
) -> tuple[int, int, str, bytearray]: ...
def merge(
    design: Design,
    given: _Given,
    parts: Sequence[tuple[int, int, str, bytes]],
    rows: bool,
    progress: _Progress,
) -> _Verdict: ...
