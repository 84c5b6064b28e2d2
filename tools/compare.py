"""Figures of the controllers that `ptc-codegen compare` sets beside examples/encoder.toml, for
ptc-codegen/tests/lab/compare.rs.

Another formulation than the library's: gains by pole placement (Ackermann) in place of Riccati equations,
the jerk-limited profile as seven segments in place of Ruckig, and modulus margin and noise by the
transfer functions of controller and plant. Run with: python3 tools/compare.py (needs numpy).
"""

import cmath
import math

import numpy as np

H, N, DELAY, GAIN, STEP, LIMIT, START = 1e-3, 800, 1, 1 / 1.5, 1e-6, 6.0, 0.1
PHI = np.array([[1.0, H], [0.0, 1.0]])
GAMMA = np.array([[GAIN * H * H / 2], [GAIN * H]])
WITH_FORCE = np.block([[PHI, GAMMA], [np.zeros((1, 2)), np.ones((1, 1))]])


def placed(phi, gamma, pole, scale):
    """K with all eigenvalues of phi - gamma K at a pole, in states multiplied by `scale`."""
    to, back = np.diag(scale), np.diag(1 / np.array(scale))
    phi, gamma, n = to @ phi @ back, to @ gamma, len(scale)
    reached = np.hstack([np.linalg.matrix_power(phi, i) @ gamma for i in range(n)])
    wanted = np.linalg.matrix_power(phi - pole * np.eye(n), n)
    return np.linalg.solve(reached.T, np.eye(n)[n - 1]) @ wanted @ to


def feedback(bandwidth):
    return placed(PHI, GAMMA, math.exp(-bandwidth * H), [1, H])


def observer(bandwidth):
    """Gain of the estimates of x1, x2 and the force for the difference of a measurement."""
    seen = np.array([[1.0], [0.0], [0.0]])
    ahead = placed(WITH_FORCE.T, seen, math.exp(-3 * bandwidth * H), [1, 1 / H, 1 / H**2])
    return np.linalg.solve(WITH_FORCE, ahead)


def horizon(bandwidth):
    """Gains by samples to go; the terminal weight is 1000 times the cost that leads to the feedback."""
    alpha = math.exp(bandwidth * H / 2)

    def before(cost, phi, gamma):
        gains = gamma.T @ cost @ phi / (1 + gamma.T @ cost @ gamma)
        return phi.T @ cost @ (phi - gamma @ gains), gains

    cost = np.eye(2)
    for _ in range(5000):
        cost, _ = before(cost, alpha * PHI, alpha * GAMMA)
        cost = (cost + cost.T) / 2
    cost, found = 1000 * cost, []
    for _ in range(N - DELAY):
        cost, gains = before(cost, PHI, GAMMA)
        cost = (cost + cost.T) / 2
        found.append(gains.ravel())
    return found


def quintic(start, length):
    """x, x' and x'' of the minimum-jerk profile from rest."""

    def at(t):
        s = min(max(t / length, 0.0), 1.0)
        x = 1 - s**3 * (10 - 15 * s + 6 * s**2)
        v = -30 * s**2 * (1 - s) ** 2
        a = -60 * s * (1 - s) * (1 - 2 * s)
        return start * x, start * v / length, start * a / length**2

    return at


def jerk_limited(start, length):
    """The same of seven segments: a third of the time each to accelerate, coast and brake."""
    ramp = length / 15
    flat, third = length / 3 - 2 * ramp, length / 3
    jerk = -1.5 * start / length / (third - ramp) / ramp
    segments = [(ramp, jerk), (flat, 0), (ramp, -jerk), (third, 0), (ramp, -jerk), (flat, 0), (ramp, jerk)]

    def at(t):
        t, x, v, a = max(t, 0.0), start, 0.0, 0.0
        if t >= length:
            return 0.0, 0.0, 0.0
        for time, j in segments:
            dt = min(t, time)
            x, v, a = x + dt * (v + dt * (a / 2 + dt * j / 6)), v + dt * (a + dt * j / 2), a + dt * j
            t -= dt
            if t <= 0:
                break
        return x, v, a

    return at


def quantised(x):
    """The nearest multiple of the encoder's step, halves away from 0."""
    return math.copysign(math.floor(abs(x) / STEP + 0.5) * STEP, x)


class Pid:
    def __init__(self, bandwidth, start):
        self.profile = quintic(start, (N - DELAY) * H)
        w = bandwidth
        self.gains = [3 * w**2 / GAIN, w**3 / GAIN, 3 * w / GAIN]
        self.filter, self.sum, self.last, self.slope = math.exp(-10 * w * H), 0.0, 0.0, 0.0

    def step(self, k, y):
        error = y - self.profile((k - DELAY) * H)[0]
        self.slope = self.filter * self.slope + (1 - self.filter) * (error - self.last) / H
        self.last, more = error, self.sum + H * error
        kp, ki, kd = self.gains
        wanted = self.profile((k + 0.5) * H)[2] / GAIN - kp * error - ki * more - kd * self.slope
        u = min(max(wanted, -LIMIT), LIMIT)
        self.sum = more if u == wanted else self.sum
        return u


class Observed:
    def __init__(self, bandwidth, start, profile=None, gains=()):
        self.estimate, self.under_way = np.array([start, 0.0, 0.0]), [0.0] * DELAY
        self.profile = profile and profile(start, (N - DELAY) * H)
        self.observer, self.feedback, self.gains = observer(bandwidth), feedback(bandwidth), gains

    def step(self, k, y):
        self.estimate = self.estimate + self.observer * (y - self.estimate[0])
        force, x = self.estimate[2], self.estimate[:2]
        for u in self.under_way:
            x = PHI @ x + GAMMA.ravel() * (u + force)
        target, ahead = np.zeros(2), 0.0
        if self.profile:
            target, ahead = np.array(self.profile(k * H)[:2]), self.profile((k + 0.5) * H)[2] / GAIN
        left = N - DELAY - k
        gains = self.gains[left - 1] if 1 <= left <= len(self.gains) else self.feedback
        u = min(max(float(ahead - gains @ (x - target) - force), -LIMIT), LIMIT)
        self.under_way.append(u)
        self.estimate = WITH_FORCE @ self.estimate
        self.estimate[:2] += GAMMA.ravel() * self.under_way.pop(0)
        return u


def figures(controller, force):
    """Error at the deadline, peak, energy, ripple, settling time."""
    x, under_way, states, inputs = np.array([START, 0.0]), [0.0] * DELAY, [], []
    for k in range(round(1.1 * N) + 1):
        under_way.append(controller.step(k, quantised(x[0])))
        u = under_way.pop(0)
        states.append(abs(x[0]))
        inputs.append(u)
        x = PHI @ x + GAMMA.ravel() * (u + force)
    states, inputs = np.array(states), np.array(inputs)
    settled = np.nonzero(states > 0.01 * states.max())[0][-1] + 1
    after = inputs[N:]
    return states[N], abs(inputs).max(), H * (inputs[:N] ** 2).sum(), after.max() - after.min(), H * settled


def responses(make, bandwidth):
    """Angles in rad per sample, 1 + L and the transfer function of the controller there."""
    controller = make(bandwidth)
    size = 3 if isinstance(controller, Pid) else 3 + DELAY

    def state(value):
        if isinstance(controller, Pid):
            controller.sum, controller.last, controller.slope = value
        else:
            controller.estimate, controller.under_way = np.array(value[:3]), list(value[3:])

    def kept():
        if isinstance(controller, Pid):
            return np.array([controller.sum, controller.last, controller.slope])
        return np.concatenate([controller.estimate, controller.under_way])

    # The profile is at rest behind the deadline.
    a, c = np.zeros((size, size)), np.zeros(size)
    for i in range(size):
        state(np.eye(size)[i] * 1e-6)
        c[i], a[:, i] = controller.step(2 * N, 0.0) * 1e6, kept() * 1e6
    state(np.zeros(size))
    through, b = controller.step(2 * N, 1e-6) * 1e6, kept() * 1e6
    angles = np.concatenate([np.geomspace(1e-5, 1e-2, 2000), np.arange(1e-2, math.pi, 5e-4)])
    differences, own = [], []
    for angle in angles:
        z = cmath.exp(1j * angle)
        own.append(through + c @ np.linalg.solve(z * np.eye(size) - a, b))
        plant = np.linalg.solve(z * np.eye(2) - PHI, GAMMA.ravel().astype(complex))[0]
        differences.append(1 - own[-1] * plant * z**-DELAY)
    return angles, np.array(differences), np.array(own)


def modulus(make, bandwidth):
    """The least |1 + L|."""
    return abs(responses(make, bandwidth)[1]).min()


def noise(make, bandwidth, step):
    """Standard deviation of u from a quantisation step as white noise, by the integral over all frequencies."""
    angles, differences, own = responses(make, bandwidth)
    power = abs(own / differences) ** 2
    return math.sqrt(np.trapezoid(power, angles) / math.pi * step**2 / 12)


def largest(keeps):
    low, high = 5.0, 400.0
    while high - low > 1e-2:
        middle = (low + high) / 2
        low, high = (middle, high) if keeps(middle) else (low, middle)
    return low


def main():
    start = quantised(START)
    rivals = [
        ("polynomial + PID", lambda w: Pid(w, start)),
        ("polynomial + observer", lambda w: Observed(w, start, quintic)),
        ("jerk-limited + observer", lambda w: Observed(w, start, jerk_limited)),
        ("finite-horizon LQR", lambda w: Observed(w, start, None, horizon(w))),
    ]
    for force in (0.0, 0.3):
        print(f"bandwidth 80 rad/s, force {force} N")
        for name, make in rivals:
            found = ", ".join(f"{value:.4e}" for value in figures(make(80.0), force))
            print(f'    ("{name}", [{found}]),')
    print("largest bandwidth with a modulus margin of 0.5; with a step of 20 um, with at most 0.12 N as noise")
    for name, make in rivals[:2]:
        margin = largest(lambda w: modulus(make, w) >= 0.5)
        calm = largest(lambda w: noise(make, w, 20e-6) <= 0.02 * LIMIT)
        print(f"    {name}: {margin:.2f}; {calm:.2f} rad/s")


if __name__ == "__main__":
    main()
