#!/usr/bin/python3
"""Makes one call of the system or the C library after another fail, and looks at what is left.

Usage: failed_calls.py PROGRAM LIBRARY C_HOST [--most 60] [--verbs label,...] [--calls memory,...]

LIBRARY is failing_calls.c, which does it: allocations, opening, reading, writing, flushing and
renaming, looking at files, starting threads and processes. Each fails alone, and then together with
all that come after it. Where a verb makes more calls of a kind than --most, so many are taken, at
equal distances; --most 0 takes all. C_HOST is a program that calls each function of the C interface
(every_c_call.c), whose allocations and starts of threads fail likewise.

HDF5 itself crashes at some allocations that fail; where it reads, that is the end of a child, which
looks like a damaged file. libgomp ends any program that it cannot start threads in; the command makes
status 3 of it, a host of the C interface is ended (meniscus.h). The last column counts those. Prints a table; exit status 1 where a verb is ended by a signal, waits for ever, succeeds with other
outputs than undisturbed, fails other than with status 3 and one line, or leaves a file under an
output's name that is not whole.
"""
import argparse
import re
import struct
import subprocess
from pathlib import Path

from verbs import ENVIRONMENT, Trial, contents, not_whole, run

KINDS = ("memory", "open", "read", "write", "sync", "status", "process", "thread")
HDF5_CRASHED = 98  # failing_calls.c


class Failing:
    """Runs commands under the library."""

    def __init__(self, library, count_file):
        self.library, self.count_file = library, count_file

    def run(self, command, kind, number, goes_on):
        """Outcome, None where it had to be ended, and how many calls of the kind it made."""
        self.count_file.write_bytes(bytes(8))
        environment = {**ENVIRONMENT, "LD_PRELOAD": self.library, "MENISCUS_FAILING_CALLS": kind,
                       "MENISCUS_FAILING_COUNT": str(self.count_file),
                       "MENISCUS_FAILING_NUMBER": str(number)}
        if goes_on:
            environment["MENISCUS_FAILING_ON"] = "1"
        try:
            outcome = run(command, env=environment)
        except subprocess.TimeoutExpired:
            outcome = None
        return outcome, struct.unpack("Q", self.count_file.read_bytes())[0]

    def count(self, command, kind):
        return self.run(command, kind, 2**63, False)[1]


def numbers(count, most):
    """Which of so many calls fail."""
    if not most or count <= most:
        return range(count)
    return sorted({i * count // most for i in range(most)})


def is_end_of_hdf5(outcome, kind):
    """HDF5's own crash for want of memory, or its end in a child, which may be a file's fault."""
    if outcome is None or kind != "memory":
        return False
    status, _, errors = outcome
    damaged = re.search(r": damaged: .*(Segmentation fault|Aborted|MiB of memory)", errors)
    return status == HDF5_CRASHED or (status == 2 and damaged is not None)


def what_is_wrong(outcome):
    """None where a command ended as it may."""
    if outcome is None:
        return "waits for ever"
    status, _, errors = outcome
    if status == 0:
        return None
    # libgomp ends the program itself, and HDF5 cannot be kept from printing before it has started.
    errors = re.sub(r"\nlibgomp: .*\n|HDF5-DIAG: .*\n(  .*\n)*", "", errors)
    if status != 3:
        return f"status {status}: {errors}"
    if errors.count("\n") != 1:
        return f"not one line: {errors}"
    return None


def command_for(trial, verb, kind, out):
    """With two threads where starting them is to fail."""
    command = verb.command(trial.program, out)
    if kind == "thread":
        command = ["2" if before == "--threads" else word
                   for before, word in zip(["", *command], command)]
    return command


def fail_verb(trial, failing, verb, kind, most):
    """How many calls there are, failed, did no harm (status 0), and ended HDF5."""
    whole = trial.undisturbed[verb.name]
    count = failing.count(command_for(trial, verb, kind, trial.fresh("out")), kind)
    failed = survived = ends_of_hdf5 = 0
    for goes_on in (False, True):
        for number in numbers(count, most):
            out = trial.fresh("out")
            outcome, _ = failing.run(command_for(trial, verb, kind, out), kind, number, goes_on)
            where = f"{verb.name}, {kind} {number} of {count}{' and all after' * goes_on}"
            failed += 1
            if is_end_of_hdf5(outcome, kind):
                ends_of_hdf5 += 1
                continue
            wrong = what_is_wrong(outcome)
            if wrong:
                trial.fault(f"{where}: {wrong}")
                continue
            found = contents(out)
            survived += outcome[0] == 0
            for name in not_whole(found, whole):
                trial.fault(f"{where}: {name} is not whole")
            missing = sorted(whole.keys() ^ found.keys())
            if outcome[0] != 0 or not missing:
                continue
            if kind == "memory" and all(name.endswith(".series") for name in missing):
                ends_of_hdf5 += 1  # it lists no frame that HDF5 calls damaged
            else:
                trial.fault(f"{where}: succeeds without {missing}")
    return count, failed, survived, ends_of_hdf5


def fail_c_host(trial, failing, host, kind):
    """Each call at most once: they are few. The host says itself what came back wrong."""
    count = failing.count([host], kind)
    failed = survived = ended = 0
    for goes_on in (False, True):
        for number in range(count):
            outcome, _ = failing.run([host], kind, number, goes_on)
            failed += 1
            if outcome is not None and outcome[2].startswith("\nlibgomp: "):
                ended += 1
            elif outcome is None or outcome[0] not in (0, 3):
                trial.fault(f"C interface, {kind} {number} of {count}"
                            f"{' and all after' * goes_on}: {outcome}")
            else:
                survived += outcome[0] == 0
    return count, failed, survived, ended


def main():
    parser = argparse.ArgumentParser()
    for name in ("program", "library", "c_host"):
        parser.add_argument(name)
    parser.add_argument("--most", type=int, default=60)
    parser.add_argument("--verbs", default="")
    parser.add_argument("--calls", default=",".join(KINDS))
    options = parser.parse_args()
    trial = Trial(options.program, list(filter(None, options.verbs.split(","))))
    failing = Failing(str(Path(options.library).resolve()), trial.folder / "count")
    kinds = options.calls.split(",")
    print("| verb | calls | made | failed | without harm | end by HDF5 or libgomp |\n"
          "|---|---|---|---|---|---|", flush=True)
    for verb in trial.verbs:
        for kind in kinds:
            row = fail_verb(trial, failing, verb, kind, options.most)
            print(f"| {verb.name} | {kind} | {' | '.join(map(str, row))} |", flush=True)
    for kind in {"memory", "thread"} & set(kinds):
        row = fail_c_host(trial, failing, options.c_host, kind)
        print(f"| C interface | {kind} | {' | '.join(map(str, row))} |", flush=True)
    trial.end()


main()
