"""The command ``ptc-codegen``, in this process."""

import os
import signal
import sys

from ptc_codegen._ptc import command


def main() -> int:
    """Runs the command line of the process, and gives the exit code.

    What the interpreter set up for itself is put back, so that signals, pipes and closed streams do
    what they do to a program.
    """
    for stream in range(3):
        try:
            os.fstat(stream)
        except OSError:
            # Or the first file that is opened would be taken for it.
            os.open(os.devnull, os.O_RDWR)
    for name in ("SIGINT", "SIGXFSZ"):
        number = getattr(signal, name, None)
        # One that the caller ignores stays ignored.
        if number is not None and signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, signal.SIG_DFL)
    return command(["ptc-codegen", *sys.argv[1:]])
