"""The emitted NumPy controller in closed loop, as a NonlinearIOSystem of python-control.

Make the controller, then run this with the folder that holds it:

    ptc-codegen emit --lang python --n 2 --mu "exp(a=1)" --gains 12,7 --tau 0.8 --eps 0.01 \\
        --u-max 40 --name stage -o out
    pip install control
    python examples/python_control.py out

It prints the state at the deadline; the plant is a double integrator that starts 0.1 m off.
"""

from __future__ import annotations

import sys
from typing import Any

import control
import numpy as np

sys.path.insert(0, sys.argv[1] if len(sys.argv) > 1 else "out")
import stage  # noqa: E402

TAU = 0.8


def main() -> None:
    law = stage.Stage(stage.Params(t0=0.0))

    def command(t: float, _: Any, x: Any, __: Any) -> Any:
        # The solver may look a rounding before the start.
        u, status = law.step(max(t, 0.0), x)
        if status < 0:
            raise RuntimeError(f"{stage.Status(int(status)).name} at t = {t}, x = {x}")
        return u

    controller = control.NonlinearIOSystem(
        None, command, inputs=["x[0]", "x[1]"], outputs=["u"], name="controller"
    )
    plant = control.ss(
        [[0.0, 1.0], [0.0, 0.0]], [[0.0], [1.0]], np.eye(2), 0,
        inputs=["u"], outputs=["x[0]", "x[1]"], name="plant",
    )
    loop = control.interconnect(
        [plant, controller], inputs=None, outputs=["x[0]", "x[1]", "u"], check_unused=False
    )
    times = np.linspace(0.0, TAU, 801)
    response = control.input_output_response(
        loop, times, X0=[0.1, 0.0], solve_ivp_kwargs={"max_step": 1e-3, "rtol": 1e-9}
    )
    position, velocity, u = response.outputs
    # The same calls at once, as a batch of times and states.
    batch = law.step(times, np.stack([position, velocity], axis=-1))
    assert np.array_equal(batch.u, u), "a batch gives what the calls one by one gave"
    print(f"at {TAU} s: off by {position[-1]:.1e} m, moving at {velocity[-1]:.1e} m/s, u = {u[-1]:.1e}")
    assert abs(position[-1]) < 1e-5 and abs(velocity[-1]) < 1e-3


if __name__ == "__main__":
    main()
