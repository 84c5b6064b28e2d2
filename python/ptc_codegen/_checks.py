"""Code of a design, and its checks."""

from __future__ import annotations

from ptc_codegen import _ptc
from ptc_codegen._design import Design, held, readable
from ptc_codegen._results import Check, Report


def emit(design: Design, lang: str = "c", *, selftest: bool = False) -> dict[str, str]:
    """The source files of a controller: their texts by their names.

    ``lang`` is ``c``, ``rust``, ``cpp``, ``matlab``, ``python``, ``st`` or ``plcopen``. With ``selftest``
    its self-test in C is among them.

    Raises `DesignError` for checks that refuse the design, and for what the language cannot express.
    """
    return dict(_ptc.emit(held(design), readable("lang", lang), selftest))


def check(design: Design) -> Report:
    """What every check says of a design. A design that is refused is no error here."""
    checks, refused, undecided, verdict, margins = _ptc.check(held(design))
    return Report(
        name=design.name,
        accepted=not refused,
        verdict=verdict,
        undecided=tuple(undecided),
        margins=margins,
        checks=tuple(
            Check(name, verdict, summary, tuple(details), fix, name in refused)
            for name, verdict, summary, details, fix in checks
        ),
    )
