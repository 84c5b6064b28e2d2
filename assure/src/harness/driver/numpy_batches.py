"""Runs emitted NumPy modules on the records of a manifest, those of the same parameters in one batch.

Warnings are errors here.
"""

import importlib.util
import sys
import warnings
from functools import partial
from typing import Any

import manifest
import numpy as np


def user_law(xi: Any, t: Any) -> Any:
    """-1.5 (xi_1 + ... + xi_n) + t/8, in the order of glue.c."""
    total = np.zeros(xi.shape[:-1], xi.dtype)
    for one in np.moveaxis(xi, -1, 0):
        total = total + xi.dtype.type(-1.5) * one
    return total + xi.dtype.type(0.125) * t


def given(x: Any, references: int) -> list[Any]:
    """The state, and the reference behind it."""
    return [x[..., :-references], x[..., -references:]] if references else [x]


def plain_step(self: Any, t: Any, x: Any, references: int, laws: dict[str, Any]) -> Any:
    return self.step(t, *given(x, references), **laws)


def last_rate(self: Any, t: Any, x: Any, laws: dict[str, Any]) -> Any:
    rate = self.rate(t, x, 0.25, **laws)
    return rate.xi_dot[..., -1], rate.status


def batch(controller: manifest.Controller) -> Any:
    path = f"{controller.folder}/{controller.name}.py"
    spec = importlib.util.spec_from_file_location(controller.name, path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[controller.name] = module
    spec.loader.exec_module(module)
    laws = {}
    if controller.law:
        laws["pi0"] = user_law
    if controller.after:
        laws["after"] = lambda x, t: -x[..., 0]
    records = controller.records()
    outcomes = controller.outcomes(len(records))
    fixed = controller.count + controller.latches * controller.n
    # Equal bits, for a NaN is a parameter too.
    words = np.ascontiguousarray(records[:, :fixed]).view(f"u{records.itemsize}")
    _, group = np.unique(words, axis=0, return_inverse=True)
    for index in range(group.max() + 1):
        rows = np.nonzero(group.reshape(-1) == index)[0]
        first = records[rows[0]]
        start = [first[controller.count : fixed]] if controller.latches else []
        params = module.Params(**controller.params(first))
        try:
            self = getattr(module, controller.type_name)(params, *start)
        except ValueError:
            outcomes["status"][rows, 0] = -1
            continue
        t, x = records[rows, fixed], records[rows, fixed + 1 :]
        plain = partial(plain_step, references=controller.references, laws=laws)
        call = partial(last_rate, laws=laws) if controller.is_rate else plain
        u, status = call(self, t, x)
        assert u.dtype == controller.real and u.shape == t.shape, (controller.name, u)
        outcomes["status"][rows, 1], outcomes["u"][rows, 0] = status, u
        if controller.has_axis:
            axis = self.tick(t).axis(*given(x, controller.references))
            assert axis.u.dtype == controller.real, (controller.name, axis.u.dtype)
            outcomes["status"][rows, 2], outcomes["u"][rows, 1] = axis.status, axis.u
        for row, start, state in zip(rows, t, x):
            try:
                latched = [state[: controller.n]] * controller.latches
                if controller.in_flight:
                    self.arm_for(start, controller.real(0.75) * first[0], *latched)
                else:
                    self.arm(start, *latched)
            except ValueError:
                outcomes["status"][row, 3] = -1
                continue
            outcomes["u"][row, 2], outcomes["status"][row, 3] = call(self, start, state)
    return outcomes


if __name__ == "__main__":
    warnings.simplefilter("error")
    manifest.run(sys.argv[1], batch)
