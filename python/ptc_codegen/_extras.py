"""Packages that are used where they are installed."""

from __future__ import annotations

from importlib import import_module
from typing import Any

_EXTRAS = {
    "anywidget": "notebook",
    "pandas": "notebook",
    "traitlets": "notebook",
}


def needed(name: str, what: str) -> Any:
    """The module ``name``, without which there is no ``what``.

    Raises `ModuleNotFoundError`, which says what to install.
    """
    try:
        return import_module(name)
    except ModuleNotFoundError as error:
        if error.name != name:
            raise
        extra = _EXTRAS.get(name)
        package = name if extra is None else f'"ptc_codegen[{extra}]"'
        message = f"{what} needs {name}, which is not installed: pip install {package}"
        raise ModuleNotFoundError(message, name=name) from None


def wanted(name: str) -> Any | None:
    """The module ``name``; None where it is not installed."""
    try:
        return import_module(name)
    except ModuleNotFoundError:
        return None
