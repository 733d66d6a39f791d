"""The power goes while files arrive, are written over and go, at 4 moments, or as many as VITRINE_RIG_CUTS says.

The machine's data are on a disk whose writes are kept, so that the disk can be had as a cut at any moment would have left it: with
all that was flushed, and any part of what was not. Of each the file system is in order again after its journal, every record
is whole, those that the analyzer had told of are there, and the analyzer starts with it.
"""
import json
import os
import random
import shutil
import subprocess
import time

from appliance import MEDIA
from image import run as tool
from machine import wait_for
from power import promised, start_arrivals
from write_log import Replay

STATE = "/var/lib/vitrine"
SIZE = 192 << 20  # bytes of the disk
LENGTH = float(os.environ.get("VITRINE_RIG_SECONDS", 10))
CUTS = int(os.environ.get("VITRINE_RIG_CUTS", 4))
STARTS = max(2, CUTS // 10)  # cuts after which the analyzer is started, too
PROMISES = 5 if CUTS > 4 else 2  # files told to be ready before the first cut; each takes a minute in an emulated machine


def run(box):
    folder = box.pictures
    disk, log = folder / "data.raw", folder / "writes.log"
    with disk.open("wb") as file:
        file.truncate(SIZE)
    tool("/sbin/mke2fs", "-q", "-t", "ext4", "-E", "lazy_itable_init=0,lazy_journal_init=0,nodiscard", disk)
    shutil.copy(disk, folder / "begin.raw")
    begin, promises = fill(box, disk, log)
    try:
        cut(folder, begin, promises)
    finally:
        for file in (disk, log, folder / "begin.raw", folder / "cut.raw"):
            file.unlink(missing_ok=True)


def fill(box, disk, log):
    """Lets files arrive; where the log stood when all was in place, and when each promise was heard: {name: bytes}."""
    box.machine.add_logged_disk(disk, log)
    wait_for("the disk", lambda: box.sh("test -b /dev/vdb && echo there", fails=True))
    box.sh(f"systemctl stop vitrine-player vitrine-analyzer; mount /dev/vdb /mnt; cp -a {STATE} /mnt/state; cp -a {MEDIA} /mnt/media; "
           f"mount --bind /mnt/state {STATE}; mount --bind /mnt/media {MEDIA}; sync; systemctl start vitrine-analyzer vitrine-player")
    begin, there = log.stat().st_size, box.sh(f"cd {MEDIA}; ls *.png *.mp4").split()
    start_arrivals(box)
    promises, end = {name: begin for name in there}, time.monotonic() + LENGTH
    while time.monotonic() < end or len(promises) < len(there) + PROMISES:
        for name in promised(box.machine.said()):
            promises.setdefault(name, log.stat().st_size)
        assert time.monotonic() < end + 600, f"next to nothing was analysed: {sorted(promises)}"
        time.sleep(0.02)
    box.look("when the power went")
    box.machine.cut()
    return begin, promises


def cut(folder, begin, promises):
    seed = int(os.environ.get("VITRINE_RIG_SEED", time.time()))
    chance = random.Random(seed)
    with (folder / "writes.log").open("rb") as log, (folder / "begin.raw").open("r+b") as whole:
        replay = Replay(log, whole)
        first = next(i for i, entry in enumerate(replay.entries) if entry.end > begin)
        moments = sorted(chance.randint(first, len(replay.entries)) for _ in range(CUTS))
        print(f"{len(replay.entries) - first} writes, {len(promises)} promises, {CUTS} cuts, VITRINE_RIG_SEED={seed}", flush=True)
        kept = []
        for number, moment in enumerate(moments):
            left = replay.go_to(moment, chance)
            shutil.copy(folder / "begin.raw", folder / "cut.raw")
            with (folder / "cut.raw").open("r+b") as disk:
                for entry in left:
                    replay.write(disk, entry)
            due = {name for name, place in promises.items() if moment > 0 and place <= replay.entries[moment - 1].end}
            starts = number % max(1, CUTS // STARTS) == 0
            kept.append(check(folder, due, f"cut after write {moment}", starts))
    print(f"every file system in order, {min(kept)} to {max(kept)} records kept, none lost, none half written; the analyzer started "
          f"after {len(range(0, CUTS, max(1, CUTS // STARTS)))} of the cuts")


def check(folder, due, what, starts):
    """How many records there are after a cut."""
    image = folder / "cut.raw"
    mended = subprocess.run(["/sbin/e2fsck", "-p", image], capture_output=True, text=True)
    assert mended.returncode in (0, 1), f"{what}: {mended.stdout}{mended.stderr}"
    looked = subprocess.run(["/sbin/e2fsck", "-f", "-n", image], capture_output=True, text=True)
    assert looked.returncode == 0, f"{what}: {looked.stdout}{looked.stderr}"
    found = folder / "found"
    shutil.rmtree(found, ignore_errors=True)
    found.mkdir()
    tool("/sbin/debugfs", "-R", f"rdump /state /media {found}", image)
    paths = set()
    for file in (found / "state/catalogue").glob("*.json"):
        try:
            record = json.loads(file.read_text())
        except ValueError as error:
            raise AssertionError(f"{what}: half a record, {file.name}: {error}") from error
        if record["state"] == "ready":
            paths.add(record["path"])
    assert not due - paths, f"{what}: lost {sorted(due - paths)}"
    if starts:
        start(folder, found, what)
    shutil.rmtree(found)
    return len(paths)


def start(folder, found, what):
    """The analyzer, here, with what the cut has left."""
    done = subprocess.run([folder.parent / "build/analyzer/vitrine-analyzer", "watch", "--once", "--without-tapestries", "--media.root", found / "media",
                           "--state.directory", found / "state", "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "0", "--analyzer.face_model", "",
                            "--analyzer.face_cascade", ""],
                          capture_output=True, text=True, timeout=600)
    said = done.stdout + done.stderr
    assert done.returncode == 0 and "unreadable" not in said and "no sense" not in said, f"{what}: {said[-3000:]}"
    left = [str(file) for folder in ("catalogue", "store") for file in (found / "state" / folder).rglob("*.new")]
    assert not left, f"{what}: left half written: {left}"
