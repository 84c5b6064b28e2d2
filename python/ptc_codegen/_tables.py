"""Results as tables of pandas, with the units of their columns."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from ptc_codegen._extras import needed

if TYPE_CHECKING:
    import pandas as pd


def frame(columns: Mapping[str, Any], units: Mapping[str, str], labelled: bool) -> pd.DataFrame:
    """The columns as a table. ``attrs["units"]`` holds their units; where they are ``labelled`` the names have them too."""
    pandas = needed("pandas", "a table")
    names = {name: f"{name} [{units[name]}]" if labelled and name in units else name for name in columns}
    table: pd.DataFrame = pandas.DataFrame({names[name]: column for name, column in columns.items()})
    table.attrs["units"] = {names[name]: unit for name, unit in units.items() if name in names}
    return table


def beside(names: tuple[str, ...], values: Any) -> dict[str, Any]:
    """The columns of an array of one axis, or of two, by their names."""
    if values.ndim == 1:
        return {names[0]: values}
    return {name: values[:, place] for place, name in enumerate(names)}
