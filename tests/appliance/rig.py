#!/usr/bin/env python3
"""The rig: the appliance in a virtual machine, its panels looked at and pulled out.

    rig.py prepare BUILD WORK   makes the machine (image, boot, both services, media) and keeps it as a snapshot in WORK
    rig.py CASE WORK            runs cases/CASE.py from that snapshot; what the panels showed lies in WORK/CASE

Ends with 77 where the machine cannot be had here, saying why.
"""
import importlib
import shutil
import subprocess
import sys
import time
import traceback
from pathlib import Path

sys.dont_write_bytecode = True
import appliance
import image
from machine import Machine

SKIPPED = 77
SNAPSHOT = "wall"
# Name, state, and where in the kernel: who waits for whom in a player that stands still.
THREADS = """for task in /proc/$(pidof -s vitrine-player)/task/*; do
    echo "$(cat $task/comm) $(cut -d')' -f2 $task/stat | cut -d' ' -f2) $(head -n 2 $task/stack | tr '\\n' ' ')"
done 2>&1 || true"""


def skip(why):
    line = "#" * 100
    print(f"{line}\n# THE RIG IS NOT RUN, nothing is known of real displays: {why}\n{line}", flush=True)
    sys.exit(SKIPPED)


def told(what, since):
    print(f"{what}: {time.monotonic() - since:.1f} s", flush=True)
    return time.monotonic()


def guarded(machine, pictures, work):
    """Runs work(appliance); what there is to know of a failure is printed."""
    shutil.rmtree(pictures, ignore_errors=True)
    pictures.mkdir(parents=True)
    box = appliance.Appliance(machine, pictures)
    try:
        return work(box)
    except image.NotHere:
        raise
    except Exception:
        traceback.print_exc()
        if machine.qemu.poll() is not None:
            sys.exit(1)  # it was cut off, and there is nobody to ask
        for unit in ("vitrine-analyzer", "vitrine-player"):
            print(f"--- {unit}", *(f"{at:.3f} {line}" for at, line in box.journal(unit)[-60:]), sep="\n")
        print("--- the player's threads", machine.sh(THREADS), "--- kernel", machine.sh("dmesg | tail -20"), f"--- the panels: {pictures}", sep="\n")
        box.look("failed")
        sys.exit(1)
    finally:
        machine.stop()


def prepare(build, work):
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    begin = time.monotonic()
    made = image.ensure([build / "analyzer/vitrine-analyzer", build / "player/vitrine-player"])
    begin = told("image", begin)
    try:
        disk = appliance.booted(made)
    except (AssertionError, OSError, RuntimeError, subprocess.SubprocessError) as error:  # nothing of ours is in it yet
        raise image.NotHere(f"Debian does not boot in it: {error}") from error
    begin = told("boot", begin)
    shutil.copy(disk, work / "prepared.qcow2")

    def install(box):
        box.install(build)
        box.machine.save(SNAPSHOT)

    guarded(Machine(made, work / "prepared.qcow2", "booted"), work / "prepare", install)
    (work / "image").symlink_to(made)
    (work / "build").symlink_to(build)
    told("services and wall", begin)


def case(name, work):
    if not (work / "image").exists():
        skip("no machine was prepared")
    begin = time.monotonic()
    disk = work / f"{name}.qcow2"
    shutil.copy(work / "prepared.qcow2", disk)
    try:
        machine = Machine((work / "image").resolve(), disk, SNAPSHOT)
        guarded(machine, work / name, importlib.import_module(f"cases.{name}").run)
    except image.NotHere as why:
        skip(why)
    finally:
        disk.unlink()
    told(name, begin)


def main():
    try:
        if sys.argv[1] == "prepare":
            prepare(Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve())
        else:
            case(sys.argv[1], Path(sys.argv[2]).resolve())
    except image.NotHere as why:
        skip(why)


if __name__ == "__main__":
    main()
