"""The manifest of runtime.rs, its records and outcomes."""

from __future__ import annotations

from dataclasses import dataclass
from multiprocessing import Pool
from typing import Any, Callable

import numpy as np


@dataclass
class Controller:
    """A line of the manifest."""

    folder: str
    name: str
    type_name: str
    n: int
    real: Any
    layout: list[tuple[str, int]]
    latches: bool
    law: bool
    after: bool
    has_axis: bool
    is_rate: bool
    in_flight: bool
    references: int

    def records(self) -> Any:
        """One row of numbers for each record."""
        numbers = self.count + self.latches * self.n + 1 + self.n + self.references
        return np.fromfile(f"{self.folder}/records.bin", self.real).reshape(-1, numbers)

    @property
    def count(self) -> int:
        """Numbers of the parameters."""
        return sum(max(1, length) for _, length in self.layout)

    def outcomes(self, count: int) -> Any:
        """Outcomes that no call has overwritten."""
        kind = np.dtype([("status", "<i4", 4), ("u", self.real, 3)])
        outcomes = np.zeros(count, kind)
        outcomes["u"] = 12345
        return outcomes

    def params(self, row: Any) -> dict[str, Any]:
        """The parameters by name."""
        values, at = {}, 0
        for key, length in self.layout:
            values[key] = list(row[at : at + length]) if length else row[at]
            at += max(1, length)
        return values


def of_line(line: str) -> Controller:
    folder, name, type_name, n, real, layout, *flags, references = line.rstrip("\n").split("\t")
    fields = [field.split(":") for field in layout.split(",") if field]
    return Controller(
        folder,
        name,
        type_name,
        int(n),
        {"f64": np.float64, "f32": np.float32}[real],
        [(key, int(length)) for key, length in fields],
        *(flag == "1" for flag in flags),
        int(references),
    )


def run(path: str, work: Callable[[Controller], Any]) -> None:
    """Leaves what `work` gives for each controller, two at a time."""
    with open(path, encoding="utf-8") as lines:
        controllers = [of_line(line) for line in lines]
    with Pool(2) as pool:
        for controller, outcomes in zip(controllers, pool.imap(work, controllers)):
            outcomes.tofile(f"{controller.folder}/outcomes.bin")
