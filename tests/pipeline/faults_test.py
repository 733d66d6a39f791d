#!/usr/bin/env python3
"""The analyzer killed again and again, and a disk that is full, while files arrive.

    faults_test.py BUILD_DIRECTORY [--kills N] [unittest arguments]
"""
import json
import os
import random
import resource
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from drawn_media import png

BUILD = Path(sys.argv[1]).resolve()
KILLS = int(sys.argv[3]) if sys.argv[2:3] == ["--kills"] else 10
REST = sys.argv[4:] if sys.argv[2:3] == ["--kills"] else sys.argv[2:]
ANALYZER = BUILD / "analyzer" / "vitrine-analyzer"
PATIENCE = 300  # seconds until something that must come is given up


def make_film(path):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-f", "lavfi", "-i",
                    "testsrc2=size=96x64:rate=10:duration=2,format=yuv420p", "-c:v", "mpeg4", str(path)], check=True)


class Faults(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="vitrine-faults-")
        self.addCleanup(self.folder.cleanup)
        self.home = Path(self.folder.name)
        self.root = self.home / "media"
        self.root.mkdir()
        self.state = self.home / "state"
        self.catalogue = self.state / "catalogue"
        self.journal = self.home / "journal"

    def start(self, most_bytes=None):
        """@param most_bytes  of any file it writes: beyond, writing fails as on a full disk"""
        def limit():
            if most_bytes is not None:
                resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, resource.RLIM_INFINITY))

        with open(self.journal, "ab") as journal:  # by another process, whose files have no limit
            writer = subprocess.Popen(["cat"], stdin=subprocess.PIPE, stdout=journal)
        self.addCleanup(writer.wait)
        watcher = subprocess.Popen([ANALYZER, "watch", "--media.root", str(self.root), "--state.directory", str(self.state),
                                    "--analyzer.quiet_milliseconds", "100", "--analyzer.rescan_seconds", "1"],
                                   stderr=writer.stdin, preexec_fn=limit, restore_signals=False)
        writer.stdin.close()
        self.addCleanup(watcher.wait)
        self.addCleanup(watcher.kill)
        return watcher

    def records(self):
        """path -> record. Each must be whole whenever it is read."""
        found = {}
        for file in self.catalogue.glob("*.json"):
            try:
                text = file.read_text()
            except FileNotFoundError:
                continue  # removed just now
            record = json.loads(text)
            found[record["path"]] = record
        return found

    def wait(self, condition, watcher=None):
        end = time.monotonic() + PATIENCE
        while not condition():
            self.assertLess(time.monotonic(), end, f"{self.records().keys()}\n{self.journal.read_text()[-3000:]}")
            if watcher:
                self.assertIsNone(watcher.poll(), self.journal.read_text()[-3000:])
            time.sleep(0.05)

    def are_all_ready(self):
        records = self.records()
        files = {p.name for p in self.root.iterdir()}
        return files == records.keys() and all(r["state"] == "ready" and r["complete"] for r in records.values())

    def test_killed_at_any_moment_no_record_is_half_and_all_are_ready_in_the_end(self):
        rng = random.Random(7)
        source = self.home / "film.avi"
        make_film(source)
        for kill in range(KILLS):
            watcher = self.start()
            if kill % 3 == 0:
                (self.root / f"film {kill}.avi").write_bytes(source.read_bytes())
            else:
                png(self.root / f"photo {kill}.png", 64, 48, lambda x, y: (kill % 256, x, y))
            end = time.monotonic() + rng.uniform(0.02, 1.5)
            while time.monotonic() < end:
                self.records()
                time.sleep(0.01)
            watcher.kill()
            watcher.wait()
            self.records()
        watcher = self.start()
        self.wait(self.are_all_ready, watcher)
        self.assertNotIn("unreadable", self.journal.read_text())
        # What the killed left half written is gone once it has been looked for.
        self.wait(lambda: not list(self.catalogue.glob("*.new")) and not list((self.state / "store").rglob("*.new")), watcher)
        print(f"{KILLS} kills, {len(self.records())} files ready", file=sys.stderr)

    def test_a_full_disk_is_told_outlived_and_made_up_for(self):
        make_film(self.root / "film.avi")
        png(self.root / "photo.png", 64, 48, lambda x, y: (200, x, y))
        for most_bytes in (0, 100, 1000):  # the record; the half of it; clips and copies
            with self.subTest(most_bytes):
                for file in self.catalogue.glob("*"):
                    file.unlink()
                self.journal.unlink(missing_ok=True)
                watcher = self.start(most_bytes)
                if most_bytes < 1000:
                    self.wait(lambda: self.journal.read_text().count("ready: ") >= 2, watcher)
                    self.assertEqual(self.records(), {})
                    time.sleep(3)  # of rescans, each of which tries again
                    self.assertEqual(self.journal.read_text().count("records cannot be stored, trying again"), 1)
                else:
                    self.wait(lambda: len(self.records()) == 2, watcher)
                # There is room again: the one that runs makes up for it.
                resource.prlimit(watcher.pid, resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
                self.wait(self.are_all_ready, watcher)
                self.wait(lambda: most_bytes >= 1000 or "all records are stored again" in self.journal.read_text(), watcher)
                watcher.terminate()
                self.assertEqual(watcher.wait(PATIENCE), 0)
                self.assertEqual([], list(self.catalogue.glob("*.new")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + REST)
