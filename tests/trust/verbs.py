"""The verbs that write files, on inputs so small that each takes a moment, and what they must leave.

Kills, full disks and calls that fail (the scripts beside this one) end a verb somewhere. Whatever
does, files under the names of outputs are whole, and the same command once more makes what an
undisturbed run makes, byte for byte.
"""
import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

SCENE = {
    "name": "tank", "particle_spacing": 0.1, "duration": 0.04, "frame_interval": 0.01,
    "fluid": [{"lattice": {"first": [0, 0, 0], "count": [4, 4, 4]}}],
    "gravity": [0, -9.81, 0], "pressure": {"solver": "dfsph"}, "time_step": {"max": 0.005},
    "surface_tension": {"model": "meniscus", "coefficient": 0.07}}

# The command starts itself anew where this is not set (app/threads.cpp).
ENVIRONMENT = {**os.environ, "OMP_WAIT_POLICY": "passive"}

# What a run writes as it goes on, and a rerun brings to an end: whole at any time, but not the same.
GROWING = ("_log.csv", "_checkpoint.vtkhdf", "_files.txt", ".series")


class Verb:
    """A verb with the words that follow it, where OUT stands for the folder of its outputs, and what
    writes earlier outputs of the same names there."""

    def __init__(self, name, words, earlier):
        self.name, self.words, self.earlier = name, words, earlier

    def command(self, program, out, earlier=False):
        words = self.earlier if earlier else self.words
        return [program, *(str(word).replace("OUT", str(out)) for word in words)]


def run(command, **options):
    """Status (minus the signal where that ended it), output and errors."""
    ended = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
                           stdin=subprocess.DEVNULL, timeout=120, **{"env": ENVIRONMENT, **options})
    return ended.returncode, ended.stdout, ended.stderr.decode(errors="replace")


def succeed(command):
    status, output, errors = run(command)
    if status != 0 or errors:
        raise SystemExit(f"{' '.join(map(str, command))}: status {status}: {errors}")
    return output


def contents(folder):
    """Bytes of the files below a folder by their names, without what was never renamed."""
    return {str(file.relative_to(folder)): file.read_bytes() for file in sorted(folder.rglob("*"))
            if file.is_file() and not file.name.endswith(".partial")}


def leftovers(folder):
    return sum(1 for file in folder.rglob("*.partial"))


def not_whole(found, *allowed):
    """Names of outputs that are neither as one of these folders has them nor still growing."""
    return [name for name, data in found.items() if not name.endswith(GROWING) and
            all(known.get(name) != data for known in allowed)]


def make_verbs(program, inputs):
    """Fills the folder `inputs` by the command itself."""
    scene, frames, labelled = inputs / "tank.json", inputs / "frames", inputs / "labelled"
    model, other = inputs / "model.json", inputs / "other.json"
    scene.write_text(json.dumps(SCENE))
    one = ["--threads", "1"]
    succeed([program, "simulate", scene, "-o", frames, *one])
    states = sorted(frames.glob("tank_000[0-2].vtkhdf"))
    succeed([program, "label", *states, "-o", labelled, *one])
    succeed([program, "train", labelled, "-o", model])
    succeed([program, "train", labelled, "-o", other, "--label-threshold", "0.1"])
    state, log = labelled / "tank_0001.vtkhdf", frames / "tank_log.csv"
    label, simulate = ["label", *states, "-o", "OUT", *one], ["simulate", scene, "-o", "OUT", *one]
    classify = ["classify", *states, "-o", "OUT", *one, "--surface-tension"]
    picture = ["picture", state, "-o", "OUT/picture.png", "--size", "200,200"]
    audit = ["audit", labelled, *one, "--report", "OUT/page.html", "--quiet", "--model"]
    return [
        Verb("label", label, [*label, "--samples", "50"]),
        Verb("train", ["train", labelled, "-o", "OUT/model.json"],
             ["train", labelled, "-o", "OUT/model.json", "--label-threshold", "0.1"]),
        Verb("export", ["export", model, "-o", "OUT/header.hpp"],
             ["export", other, "-o", "OUT/header.hpp"]),
        Verb("classify", [*classify, "0.07", "--model", model], [*classify, "0.05", "--model", model]),
        Verb("simulate", simulate, [*simulate, "--duration", "0.02"]),
        Verb("audit", [*audit, model], [*audit, other]),
        Verb("picture", picture, [*picture, "--color", "uncovered_fraction"]),
        Verb("plot", ["plot", log, "-o", "OUT/plot.svg"], ["plot", log, "-o", "OUT/plot.svg", "--y", "steps"]),
    ]


class Trial:
    """Inputs, verbs and what undisturbed runs write, in a folder that is gone in the end."""

    def __init__(self, program, only=()):
        self.program = program
        self.folder = Path(tempfile.mkdtemp(prefix="meniscus_trust_"))
        inputs = self.fresh("inputs")
        verbs = make_verbs(program, inputs)
        unknown = set(only) - {verb.name for verb in verbs}
        if unknown:
            raise SystemExit(f"expected of {' '.join(verb.name for verb in verbs)}, found {unknown}")
        self.verbs = [verb for verb in verbs if not only or verb.name in only]
        self.undisturbed = {verb.name: self.result_of(verb) for verb in self.verbs}
        self.faults = []

    def fresh(self, name):
        folder = self.folder / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        return folder

    def result_of(self, verb, over_earlier=False):
        out = self.fresh("undisturbed")
        if over_earlier:
            succeed(verb.command(self.program, out, earlier=True))
        succeed(verb.command(self.program, out))
        return contents(out)

    def fault(self, text):
        """Something is wrong: said at once, and counted."""
        print(f"FAULT: {text}", flush=True)
        self.faults.append(text)

    def check_rerun(self, verb, out, where, expected):
        """The same command once more makes everything that is expected, and no more."""
        status, _, errors = run(verb.command(self.program, out))
        if status != 0:
            self.fault(f"{where}: rerun: status {status}: {errors}")
            return
        found = contents(out)
        for name in sorted(found.keys() | expected.keys()):
            if found.get(name) != expected.get(name):
                self.fault(f"{where}: rerun: {name} is not what an undisturbed run writes")
        if leftovers(out):
            self.fault(f"{where}: rerun leaves a partial file")

    def end(self):
        shutil.rmtree(self.folder)
        raise SystemExit(f"{len(self.faults)} faults" if self.faults else None)
