"""Runs emitted Structured Text on the records of a manifest, one call after the other.

Two functions of the user's are given in Structured Text too. With --parse it only reads each file
that it is given, and fails at the first that is no Structured Text.
"""

import sys
from pathlib import Path
from typing import Any

import manifest
import numpy as np
from structured_text import Library, parsed

USER = """
FUNCTION {name}_pi0 : {real}
VAR_INPUT xi : {name}_vector{n}; t : {real}; END_VAR
VAR i : DINT; sum : {real}; END_VAR
FOR i := 1 TO {n} DO sum := sum + ({real}#-1.5 * xi[i]); END_FOR;
{name}_pi0 := sum + ({real}#0.125 * t);
END_FUNCTION

FUNCTION {name}_after : {real}
VAR_INPUT x : {name}_vector{n}; t : {real}; END_VAR
{name}_after := -x[1];
END_FUNCTION
"""


def calls(controller: manifest.Controller) -> Any:
    text = Path(controller.folder, f"{controller.name}.st").read_text(encoding="utf-8")
    if controller.law or controller.after:
        real = "LREAL" if controller.real is np.float64 else "REAL"
        text += USER.format(name=controller.name, n=controller.n, real=real)
    block = Library(text).units[controller.name.lower()]
    records = controller.records()
    outcomes = controller.outcomes(len(records))
    with np.errstate(all="ignore"):
        for record, outcome in zip(records, outcomes):
            memory = block.memory()
            if controller.layout:
                params = controller.params(record)
                memory["params"] = {key.lower(): value for key, value in params.items()}
            rest = record[controller.count :]
            if controller.latches:
                memory["x0"], rest = list(rest[: controller.n]), rest[controller.n :]
            memory["init"] = True
            block.execute(memory)
            outcome["status"][0] = memory["status"]
            if memory["status"] == 0:
                memory["init"] = False
                n = controller.n
                memory["t"], memory["x"] = rest[0], list(rest[1 : 1 + n])
                if controller.references:
                    memory["r"] = list(rest[1 + n :])
                block.execute(memory)
                outcome["status"][1], outcome["u"][0] = memory["status"], memory["u"]
                flag = "arm_for" if controller.in_flight else "arm"
                memory[flag], memory["start_time"] = True, rest[0]
                if controller.in_flight:
                    memory["arm_for_tau"] = controller.real(0.75) * record[0]
                if controller.latches:
                    memory["x0"] = list(rest[1 : 1 + n])
                block.execute(memory)
                outcome["status"][3] = memory["status"]
                if memory["status"] == 0:
                    memory[flag] = False
                    block.execute(memory)
                    outcome["status"][3], outcome["u"][2] = memory["status"], memory["u"]
    return outcomes


if __name__ == "__main__":
    if sys.argv[1] == "--parse":
        for path in sys.argv[2:]:
            parsed(Path(path).read_text(encoding="utf-8"))
    else:
        manifest.run(sys.argv[1], calls)
