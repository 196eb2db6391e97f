# SPDX-License-Identifier: Apache-2.0
"""Runs a program under limits of processor time, memory and wall time, and measures it."""

import os
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass


@dataclass
class Outcome:
    """How a run ended and what it took."""

    status: int  # exit code, or minus the signal
    cpu_seconds: float  # user and system time of the program
    wall_seconds: float
    peak_bytes: int  # of resident memory, sampled
    output: str  # what it wrote to standard output and error
    timed_out: bool


def run(command, cwd=None, cpu_seconds=60, wall_seconds=None, address_space=None, stdin=None,
        environment=None, interrupt_after=None):
    """Runs a command; a limit that is reached ends it with a signal.

    The processor limit sends SIGXCPU, the wall limit kills. `interrupt_after` sends SIGINT after so
    many seconds. Setting limits costs the program about a millisecond: without processor limit
    (None) and address space none are set but the wall limit.
    """
    if wall_seconds is None:
        wall_seconds = 4 * (cpu_seconds or 60) + 30
    limits = []
    if cpu_seconds or address_space:
        limits = ["prlimit", "--core=0:0"]
    if cpu_seconds:
        limits.append(f"--cpu={int(cpu_seconds)}:{int(cpu_seconds) + 2}")
    if address_space:
        limits.append(f"--as={address_space}")
    with tempfile.TemporaryFile() as log:
        started = time.monotonic()
        process = subprocess.Popen(limits + list(command), cwd=cwd, env=environment,
                                   stdin=stdin or subprocess.DEVNULL, stdout=log,
                                   stderr=subprocess.STDOUT, start_new_session=True)
        peak, killed, interrupted, pause = 0, False, False, 0.002
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            peak = max(peak, _resident_peak(process.pid))
            elapsed = time.monotonic() - started
            if interrupt_after and not interrupted and elapsed > interrupt_after:
                os.kill(process.pid, signal.SIGINT)
                interrupted = True
            if elapsed > wall_seconds and not killed:
                os.killpg(process.pid, signal.SIGKILL)
                killed = True
            time.sleep(pause)
            pause = min(0.05, pause * 1.5)
        elapsed = time.monotonic() - started
        process.returncode = os.waitstatus_to_exitcode(status)
        log.seek(0)
        text = log.read(1 << 22).decode("utf-8", "replace")
    used = usage.ru_utime + usage.ru_stime
    timed_out = killed or process.returncode == -signal.SIGXCPU
    return Outcome(process.returncode, used, elapsed, peak, text, timed_out)


def _resident_peak(pid):
    try:
        with open(f"/proc/{pid}/status") as file:
            for line in file:
                if line.startswith("VmHWM:"):
                    return int(line.split()[1]) * 1024
    except OSError:
        pass
    return 0


def describe(status):
    """An exit status in words."""
    if status >= 0:
        return f"exit {status}"
    try:
        return signal.Signals(-status).name
    except ValueError:
        return f"signal {-status}"
