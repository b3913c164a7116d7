#!/usr/bin/python3
"""Gives the command options that nobody means, and looks at how it ends.

Usage: command_lines.py PROGRAM [--lines 2000] [--seed 2020]

Each line is a verb with words of its own, some left out, some twice, some with a value of the wrong
kind: empty, too large, not a number, with escape sequences, nested brackets, the names of folders,
devices and files of another kind. What a verb takes is read off its help. What is at work after 20
seconds, such as a run to the end of time, is interrupted. Prints how many lines ended with which
status; exit status 1 where one is ended by a signal, does not hear the interrupt, has another status
than 0 to 3, or fails with other than one line (with --keep-going, one for each file) or with control characters.
"""
import argparse
import collections
import random
import re
import signal
import subprocess

from verbs import ENVIRONMENT, Trial, succeed

VALUES = ["", "0", "-1", "1e308", "-1e999", "nan", "inf", "0x10", "18446744073709551616", "1,2", "x=0:1",
          "3:1", "Type=3", "{}", "[" * 3000, '{"a":' * 150, "a" * 5000, "\x1b[31mred", "line\nbreak", "\udcff",
          "--", "-", "/dev/null", "/dev/full", "/proc/self/mem", "*", "{0..99}", "%s%n",
          "all", "exact", "csv", "2", "3", "0.5", "true", "null"]


def options_of(program, verb):
    """Names of a verb's options, those that run for long left out."""
    text = succeed([program, verb, "--help"]).decode()
    return sorted(set(re.findall(r"^\s+(?:-\w,)?(--[a-z-]+)", text, re.MULTILINE)) - {"--help"})


def line_of(chance, trial, verb, options, files):
    """A command line."""
    words = [str(word).replace("OUT", str(trial.folder / "out")) for word in verb.words]
    if chance.random() < 0.3:
        del words[chance.randrange(1, len(words))]
    for _ in range(chance.choice([1, 1, 2])):
        place, option = chance.randrange(1, len(words) + 1), chance.choice(options)
        value = chance.choice(VALUES + files)
        words[place:place] = chance.choice([[option, value], [f"{option}={value}"], [option], [value]])
    return [trial.program, *words]


def run(line, folder):
    """Status, None where it does not end, and errors."""
    process = subprocess.Popen(line, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, cwd=folder,
                               stderr=subprocess.PIPE, env=ENVIRONMENT, encoding="utf-8",
                               errors="replace")
    for end in (process.send_signal, lambda _: process.kill()):
        try:
            errors = process.communicate(timeout=20)[1]
            return process.returncode, errors
        except subprocess.TimeoutExpired:
            end(signal.SIGINT)
    process.communicate()
    return None, ""


def what_is_wrong(status, errors, goes_on):
    if status is None:
        return "does not end"
    if status not in (0, 1, 2, 3, 130):
        return f"status {status}"
    lines = [line for line in errors.split("\n") if line and not line.startswith("meniscus: warning")]
    if status in (2, 3) and (len(lines) != 1 and not (goes_on and lines) or
                             any(not line.startswith("meniscus: ") for line in lines)):
        return f"{len(lines)} lines: {errors[:300]!r}"
    if any(ord(c) < 32 and c != "\n" or c == "\x7f" for c in errors):
        return f"control characters: {errors[:300]!r}"
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--lines", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=2020)
    given = parser.parse_args()
    trial = Trial(given.program)
    chance = random.Random(given.seed)
    options = {verb.name: options_of(given.program, verb.name) for verb in trial.verbs}
    files = [str(file) for file in sorted((trial.folder / "inputs").rglob("*"))]
    ended = collections.Counter()
    for number in range(given.lines):
        verb = chance.choice(trial.verbs)
        line = line_of(chance, trial, verb, options[verb.name], files)
        trial.fresh("out")
        status, errors = run(line, trial.fresh("here"))
        ended[verb.name, status] += 1
        wrong = what_is_wrong(status, errors, any(word.startswith("--keep-going") for word in line))
        if wrong:
            trial.fault(f"line {number}: {wrong}: {[word[:60] for word in line[1:]]}")
    statuses = sorted({status for _, status in ended}, key=str)
    print("| verb |" + "".join(f" status {status} |" for status in statuses))
    print("|---|" + "---|" * len(statuses))
    for verb in trial.verbs:
        print(f"| {verb.name} |" + "".join(f" {ended[verb.name, status]} |" for status in statuses))
    trial.end()


main()
