#!/usr/bin/python3
"""Lets a disk of a few kilobytes be full at every write of the command, and looks at what is left.

Usage: full_disk.py PROGRAM [--verbs label,train,...]

Each verb writes to a file system in memory, which has room for a page more, or a file more, each time
(from 16 on, for an eighth more) until the verb succeeds: once to an empty one, and once over earlier
outputs of its own. Needs the right to mount, or user namespaces; exit status 77 without. Prints a table;
exit status 1 where a verb ends other than with 3 and one line, an output is neither the earlier one nor
the new one, a partial file stays, or a rerun with room does not make the bytes of an undisturbed run.
"""
import argparse
import os
import subprocess
import sys

from verbs import Trial, contents, leftovers, not_whole, run, succeed

PAGE = 4096


def enter_namespace():
    """The script once more where it may mount; 77 where that is not to be had."""
    if os.environ.get("MENISCUS_MAY_MOUNT"):
        return
    own = ["unshare", "--user", "--map-root-user", "--mount"]
    tried = subprocess.run([*own, "mount", "-t", "tmpfs", "none", "/mnt"], check=False,
                           stderr=subprocess.PIPE, text=True)
    if tried.returncode:
        print(f"skipped: mounting is not permitted here ({tried.stderr.strip()})")
        sys.exit(77)
    os.environ["MENISCUS_MAY_MOUNT"] = "1"
    os.execvp(own[0], [*own, sys.executable, *sys.argv])


class SmallDisk:
    """Mounted at a folder while it is there."""

    def __init__(self, folder):
        self.folder = folder

    def __enter__(self):
        subprocess.run(["mount", "-t", "tmpfs", "none", self.folder], check=True)
        return self

    def __exit__(self, *_):
        subprocess.run(["umount", self.folder], check=True)

    def limit(self, limit):
        subprocess.run(["mount", "-o", f"remount,{limit}", self.folder], check=True)

    def used(self):
        status = os.statvfs(self.folder)
        return (status.f_blocks - status.f_bfree) * status.f_frsize, status.f_files - status.f_ffree


def try_with(trial, verb, resource, room, over_earlier, expected):
    """True where there was room enough."""
    where = f"{verb.name}, room for {room} {resource}{' over earlier outputs' * over_earlier}"
    with SmallDisk(trial.fresh("disk")) as disk:
        if over_earlier:
            succeed(verb.command(trial.program, disk.folder, earlier=True))
        before = contents(disk.folder)
        taken_bytes, taken_files = disk.used()
        if resource == "pages":
            disk.limit(f"size={taken_bytes + room * PAGE}")
        else:
            disk.limit(f"nr_inodes={taken_files + room}")
        status, _, errors = run(verb.command(trial.program, disk.folder))
        found = contents(disk.folder)
        if status == 0:
            if found != expected:
                trial.fault(f"{where}: succeeds with other outputs")
            return True
        if status != 3 or errors.count("\n") != 1 or not errors.startswith("meniscus: "):
            trial.fault(f"{where}: status {status}: {errors}")
        for name in sorted(before.keys() - found.keys()):
            trial.fault(f"{where}: {name} is lost")
        for name in not_whole(found, before, expected):
            trial.fault(f"{where}: {name} is not whole")
        if leftovers(disk.folder):
            trial.fault(f"{where}: a partial file stays")
        disk.limit("size=100m,nr_inodes=1000")
        trial.check_rerun(verb, disk.folder, where, expected)
        return False


def fill(trial, verb, resource, over_earlier):
    """How often there was no room: from none on by one more each, where there is much by an eighth."""
    expected = trial.result_of(verb, over_earlier)
    room, tries = 0 if over_earlier else 1, 0
    while not try_with(trial, verb, resource, room, over_earlier, expected):
        room += max(1, room // 8)
        tries += 1
        if room > 10000:
            trial.fault(f"{verb.name}: never has enough {resource}")
            break
    return tries


def main():
    enter_namespace()
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--verbs", default="")
    options = parser.parse_args()
    trial = Trial(options.program, list(filter(None, options.verbs.split(","))))
    print("| verb | too few pages | too few files | the same over earlier outputs | |\n"
          "|---|---|---|---|---|", flush=True)
    for verb in trial.verbs:
        counts = [fill(trial, verb, resource, over_earlier)
                  for over_earlier in (False, True) for resource in ("pages", "files")]
        print(f"| {verb.name} | {' | '.join(map(str, counts))} |", flush=True)
    trial.end()


main()
