"""FMUs in fmpy: validation, single calls and closed loops. Called by fmu.rs.

samples LIST       each line of LIST: FMU of a clock in samples, loop (file names), n, delay, whether
                   u is read after the step
inputs LIST        each line of LIST: FMU of several inputs, calls, outcomes (file names), period of a
                   clock in samples, or 0
run LIST           each line of LIST: FMU, records, outcomes, loop (file names), number of parameters, n
pack FOLDER FMU    compiles the sources in a folder as an importer does, and packs it
"""

import pathlib
import shutil
import struct
import sys
import tempfile

import fmpy
from fmpy.build import build_platform_binary
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu

STEPS = 1000


def hexed(number):
    return struct.pack("<d", number).hex()


class Instance:
    """One interface for both versions of FMI."""

    def __init__(self, path):
        self.folder = tempfile.mkdtemp()
        self.model = fmpy.read_model_description(path)
        fmpy.extract(path, self.folder)
        self.second = self.model.fmiVersion == "2.0"
        self.messages = []
        named = {v.name: v for v in self.model.modelVariables}
        self.references = {name: v.valueReference for name, v in named.items()}
        self.parameters = [
            v.valueReference for v in self.model.modelVariables if v.causality == "parameter"
        ]
        self.states = [v.valueReference for v in self.model.modelVariables if v.causality == "input"]
        controls = [v for v in self.model.modelVariables if v.name.rstrip("0123456789") == "u"]
        single = controls[0].type == "Float32"
        self.controls = [v.valueReference for v in controls]
        self.statuses = [
            v.valueReference for v in self.model.modelVariables if v.name.rstrip("0123456789") == "status"
        ]
        kind = FMU2Slave if self.second else FMU3Slave
        self.fmu = kind(
            guid=self.model.guid,
            unzipDirectory=self.folder,
            modelIdentifier=self.model.coSimulation.modelIdentifier,
            instanceName="instance",
        )
        if self.second:
            callbacks = fmi2CallbackFunctions()
            callbacks.logger = fmi2CallbackLoggerTYPE(
                lambda environment, instance, status, category, message: self.messages.append(
                    message.decode()
                )
            )
            self.fmu.instantiate(callbacks=callbacks)
            self.get, self.set, self.integer = self.fmu.getReal, self.fmu.setReal, self.fmu.getInteger
        else:
            self.fmu.instantiate(
                logMessage=lambda environment, status, category, message: self.messages.append(
                    message.decode()
                )
            )
            width = "32" if single else "64"
            self.get = getattr(self.fmu, "getFloat" + width)
            self.set = getattr(self.fmu, "setFloat" + width)
            self.integer = self.fmu.getInt32

    def start(self, time, parameters, x):
        """Initializes the instance at a time."""
        if self.second:
            self.fmu.setupExperiment(startTime=time)
            self.fmu.enterInitializationMode()
        else:
            self.fmu.enterInitializationMode(startTime=time)
        if parameters:
            self.set(self.parameters, parameters)
        self.set(self.states, x)
        self.fmu.exitInitializationMode()

    def tune(self, time, parameters, x):
        """Sets everything anew while the instance runs."""
        if parameters:
            self.set(self.parameters, parameters)
        self.set(self.states, x)
        self.step(time, 0.0)

    def step(self, time, by):
        self.fmu.doStep(currentCommunicationPoint=time, communicationStepSize=by)

    def outputs(self):
        u, to_go = self.get([self.references["u"], self.references["time_to_go"]])
        return u, to_go, self.integer([self.references["status"]])[0]

    def close(self):
        self.fmu.freeInstance()
        shutil.rmtree(self.folder, ignore_errors=True)


def calls(instance, records, count, n):
    """One line per record: its result, or the error message."""
    lines = []
    for index, record in enumerate(struct.iter_unpack(f"<{count + 1 + n}d", records)):
        instance.messages.clear()
        parameters, time, x = list(record[:count]), record[count], list(record[count + 1 :])
        try:
            if index % 2 == 0:
                instance.fmu.reset()
                instance.start(time, parameters, x)
            else:
                instance.tune(time, parameters, x)
            u, to_go, status = instance.outputs()
            lines.append(f"ok {status} {hexed(u)} {hexed(to_go)}")
        except FMICallException:
            lines.append("error " + " | ".join(instance.messages))
    return lines


def loop(instance, n):
    """The closed loop with the chain of integrators from x1 = 1, with the start values of the FMU."""
    instance.fmu.reset()
    start = instance.model.defaultExperiment
    begin, end = float(start.startTime), float(start.stopTime)
    h = (end - begin) / STEPS
    x = [1.0] + [0.0] * (n - 1)
    instance.start(begin, [], x)
    lines = [" ".join(hexed(v) for v in instance.get(instance.parameters))]
    time = begin
    for index in range(STEPS + 1):
        instance.set(instance.states, x)
        u, to_go, status = instance.outputs()
        lines.append(" ".join([str(status), *(hexed(v) for v in [time, *x, u])]))
        if index == STEPS:
            break
        for i in range(n):
            total = u
            for k in range(n - i, 0, -1):
                total = x[i + k - 1] + h * total / k
            x[i] = total
        instance.step(time, h)
        time += h
    return lines


def run(listed):
    for line in pathlib.Path(listed).read_text().splitlines():
        fmu, records, outcomes, looped, count, n = line.split("\t")
        problems = validate_fmu(fmu)
        if problems:
            pathlib.Path(outcomes).write_text("invalid " + " | ".join(problems).replace("\n", " "))
            continue
        instance = Instance(fmu)
        data = pathlib.Path(records).read_bytes()
        pathlib.Path(outcomes).write_text("\n".join(calls(instance, data, int(count), int(n))))
        try:
            lines = loop(instance, int(n))
        except FMICallException as error:
            lines = [f"error {error}: " + " | ".join(instance.messages)]
        pathlib.Path(looped).write_text("\n".join(lines))
        instance.close()


def samples(listed):
    """Closed loops of clocks in samples with a chain of integrators; u is read any number of times.
    A u that is read after the step acts from the next sample on."""
    for line in pathlib.Path(listed).read_text().splitlines():
        fmu, looped, n, delay, explicit = line.split("\t")
        problems = validate_fmu(fmu)
        if problems:
            pathlib.Path(looped).write_text("invalid " + " | ".join(problems).replace("\n", " "))
            continue
        instance, n = Instance(fmu), int(n)
        start = instance.model.defaultExperiment
        h, end = float(start.stepSize), float(start.stopTime)
        x, late = [1.0] + [0.0] * (n - 1), [0.0] * int(delay)
        shown = len(instance.states)
        instance.start(0.0, [], x[:shown])
        given = [v for v in instance.model.modelVariables if v.causality == "parameter"]
        counts = ("Integer", "Int32")
        outputs = [v for v in instance.model.modelVariables if v.causality == "output"]
        estimates = [v.valueReference for v in outputs if v.name == "d" or v.name.startswith("xhat")]
        read = lambda v: (instance.integer if v.type in counts else instance.get)([v.valueReference])[0]
        lines = [" ".join(hexed(read(v)) for v in given)]
        for k in range(round(end / h) + 1):
            instance.set(instance.states, x[:shown])
            if explicit == "1":
                instance.step(k * h, h)
            for _ in range(k % 3):
                instance.outputs()
            u, _, status = instance.outputs()
            behind = instance.get(estimates) if estimates else []
            lines.append(" ".join([str(status), *(hexed(v) for v in [*x, u, *behind])]))
            late.append(u)
            acting = late.pop(0)
            for i in range(n):
                total = acting
                for j in range(n - i, 0, -1):
                    total = x[i + j - 1] + h * total / j
                x[i] = total
            if explicit == "0":
                instance.step(k * h, h)
        try:
            instance.step(0.0, 2 * h)
            lines.append("error a step of two periods is taken")
        except FMICallException:
            pass
        pathlib.Path(looped).write_text("\n".join(lines))
        instance.close()


def inputs(listed):
    """Calls of controllers of several inputs, in the order of their times: every u and every status."""
    for line in pathlib.Path(listed).read_text().splitlines():
        fmu, calls, outcomes, period = line.split("\t")
        problems = validate_fmu(fmu)
        if problems:
            pathlib.Path(outcomes).write_text("invalid " + " | ".join(problems).replace("\n", " "))
            continue
        instance, h = Instance(fmu), float(period)
        given = len(instance.states)
        count = ("Integer", "Int32")
        parameters = [v for v in instance.model.modelVariables if v.causality == "parameter"]
        instance.start(0.0, [], [0.0] * given)
        read = lambda v: (instance.integer if v.type in count else instance.get)([v.valueReference])[0]
        lines = [" ".join(hexed(read(v)) for v in parameters)]
        now = 0.0
        for time, *numbers in struct.iter_unpack(f"<{1 + given}d", pathlib.Path(calls).read_bytes()):
            instance.messages.clear()
            try:
                instance.set(instance.states, numbers)
                if h == 0.0:
                    instance.step(now, time - now)
                    now = time
                u, statuses = instance.get(instance.controls), instance.integer(instance.statuses)
                lines.append("ok " + " ".join([*map(str, statuses), *map(hexed, u)]))
                if h > 0.0:
                    instance.step(now, h)
                    now += h
            except FMICallException:
                now = time if h == 0.0 else now
                lines.append("error " + " | ".join(instance.messages))
        pathlib.Path(outcomes).write_text("\n".join(lines))
        instance.close()


def pack(folder, fmu):
    build_platform_binary(folder)
    shutil.move(shutil.make_archive(fmu, "zip", folder), fmu)


if __name__ == "__main__":
    {"run": run, "pack": pack, "samples": samples, "inputs": inputs}[sys.argv[1]](*sys.argv[2:])
