#!/usr/bin/python3
"""Kills the command at random moments, and looks at what it leaves.

Usage: kills.py PROGRAM [--kills 300] [--verbs label,train,...] [--seed 2020]

Half of the kills hit a run that goes on from where the one before was killed, the others one that
starts from nothing; each that is not followed by another kill is run to its end, and compared with
an undisturbed run. Prints a table; exit status 1 where a file under an output's name is not whole,
a file that was there is lost, or a rerun does not make the bytes of an undisturbed run.
"""
import argparse
import random
import subprocess
import time

from verbs import ENVIRONMENT, Trial, contents, leftovers, not_whole


def kill_at(command, moment):
    """True where it was at work still."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               stdin=subprocess.DEVNULL, env=ENVIRONMENT)
    time.sleep(moment)
    process.kill()
    return process.wait() != 0


def seconds_of(trial, verb):
    start = time.monotonic()
    trial.result_of(verb)
    return time.monotonic() - start


def kill_often(trial, verb, kills, chance):
    """Row of the table."""
    whole = trial.undisturbed[verb.name]
    duration = seconds_of(trial, verb)
    hits = reruns = partial = with_outputs = 0
    out, before = trial.fresh("out"), {}
    while hits < kills:
        if not kill_at(verb.command(trial.program, out), chance.uniform(0, duration)):
            duration *= 0.97  # the machine has become faster
            out, before = trial.fresh("out"), {}
            continue
        hits += 1
        where = f"{verb.name}, kill {hits}"
        found = contents(out)
        with_outputs += bool(found)
        partial += leftovers(out) > 0
        for name in not_whole(found, whole):
            trial.fault(f"{where}: {name} is not whole")
        for name in sorted(before.keys() - found.keys()):
            trial.fault(f"{where}: {name} is lost")
        before = found
        if chance.random() < 0.5:
            trial.check_rerun(verb, out, where, whole)
            reruns += 1
            out, before = trial.fresh("out"), {}
    return f"| {verb.name} | {hits} | {with_outputs} | {partial} | {reruns} |"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=300)
    parser.add_argument("--verbs", default="label,train,classify,simulate,audit,picture")
    parser.add_argument("--seed", type=int, default=2020)
    options = parser.parse_args()
    trial = Trial(options.program, options.verbs.split(","))
    chance = random.Random(options.seed)
    print("| verb | kills | with outputs there | with a partial file left | reruns to the end |\n"
          "|---|---|---|---|---|", flush=True)
    for verb in trial.verbs:
        print(kill_often(trial, verb, options.kills, chance), flush=True)
    trial.end()


main()
