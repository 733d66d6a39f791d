#!/usr/bin/env python3
"""The analyzer killed again and again while files arrive, and both programs on a disk that is full.

    faults_test.py BUILD_DIRECTORY [--kills N] [--points N] [unittest arguments]

--kills: how often it is killed. --points: at how many of all the points where room is needed the disk becomes full,
spread evenly; 0: at each.
"""
import argparse
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from drawn_media import pattern, png
from watched_folder import records_in

parser = argparse.ArgumentParser()
parser.add_argument("build", type=Path)
parser.add_argument("--kills", type=int, default=10)
parser.add_argument("--points", type=int, default=5)
OPTIONS, REST = parser.parse_known_args()
BUILD = OPTIONS.build.resolve()
KILLS = OPTIONS.kills
ANALYZER, PLAYER = BUILD / "analyzer" / "vitrine-analyzer", BUILD / "player" / "vitrine-player"
FULL_DISK = BUILD / "tests" / "pipeline" / "libfull_disk.so"
PATIENCE = 120  # seconds until something that must come is given up


def make_film(path):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-f", "lavfi", "-i",
                    "testsrc2=size=96x64:rate=10:duration=2,format=yuv420p", "-c:v", "mpeg4", str(path)], check=True)


class Faults(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="vitrine-faults-")
        self.addCleanup(self.folder.cleanup)
        self.home = Path(self.folder.name)
        self.root, self.state = self.home / "disk" / "media", self.home / "disk" / "state"
        self.root.mkdir(parents=True)
        self.catalogue = self.state / "catalogue"
        self.journal = self.home / "journal"
        self.counter = self.home / "counter"

    def full_disk(self, first_to_fail):
        """The environment of a process with a disk of its own. @param first_to_fail  of its calls for room; 0: none"""
        self.counter.write_bytes(bytes(8) + first_to_fail.to_bytes(8, "little"))
        return os.environ | {"LD_PRELOAD": str(FULL_DISK), "FULL_DISK_FOLDER": str(self.home / "disk"), "FULL_DISK_COUNTER": str(self.counter)}

    def make_room(self):
        with open(self.counter, "r+b") as counter:
            counter.write(bytes(16))

    def start(self, environment=None):
        with open(self.journal, "ab") as journal:
            watcher = subprocess.Popen([ANALYZER, "watch", "--media.root", str(self.root), "--state.directory", str(self.state),
                                        "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "100", "--analyzer.rescan_seconds", "1", "--tapestry.max_bytes", "0"],
                                       stderr=journal, env=environment)
        self.addCleanup(watcher.wait)
        self.addCleanup(watcher.kill)
        return watcher

    def records(self):
        return records_in(self.catalogue)

    def wait(self, condition, watcher=None, patience=PATIENCE):
        end = time.monotonic() + patience
        while not condition():
            self.assertLess(time.monotonic(), end, f"{self.records().keys()}\n{self.journal.read_text()[-3000:]}")
            if watcher:
                self.assertIsNone(watcher.poll(), self.journal.read_text()[-3000:])
            time.sleep(0.05)

    def are_all_ready(self):
        records = self.records()
        files = {p.name for p in self.root.iterdir() if p.is_file()}
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
                png(self.root / f"photo {kill}.png", 64, 48, pattern(kill))
            ready = self.journal.read_text().count("ready: ") if kill % 2 else None  # killed about when a record is written
            end = time.monotonic() + (PATIENCE if kill % 2 else rng.uniform(0.02, 1.5))
            while time.monotonic() < end and ready in (None, self.journal.read_text().count("ready: ")):
                self.records()
                time.sleep(rng.uniform(0.001, 0.02))
            watcher.kill()
            watcher.wait()
            self.records()
        watcher = self.start()
        self.wait(self.are_all_ready, watcher, PATIENCE + 10 * KILLS)
        self.assertNotIn("unreadable", self.journal.read_text())
        # What the killed left half written is gone once it has been looked for.
        self.wait(lambda: not list(self.catalogue.glob("*.new")) and not list((self.state / "store").rglob("*.new")), watcher)
        print(f"{KILLS} kills, {len(self.records())} files ready", file=sys.stderr)

    def test_a_full_disk_is_told_once_and_made_up_for_when_there_is_room(self):
        make_film(self.root / "film.avi")
        png(self.root / "photo.png", 64, 48, lambda x, y: (200, x, y))
        self.catalogue.mkdir(parents=True)
        (self.catalogue / "writer.lock").touch()  # of an earlier run
        watcher = self.start(self.full_disk(1))
        self.wait(lambda: self.journal.exists() and self.journal.read_text().count("ready: ") >= 2, watcher)
        self.assertEqual(self.records(), {})
        begin = time.monotonic()
        self.wait(lambda: time.monotonic() > begin + 3, watcher)  # of rescans, each of which tries again
        self.assertEqual(self.journal.read_text().count("records cannot be stored, trying again"), 1)
        self.make_room()
        self.wait(self.are_all_ready, watcher)
        self.wait(lambda: "all records are stored again" in self.journal.read_text(), watcher)
        watcher.terminate()
        self.assertEqual(watcher.wait(PATIENCE), 0)
        self.assertEqual([], list(self.catalogue.glob("*.new")))

    def once(self, full_from):
        """Until the catalogue is up to date. @param full_from  the call for room that is the first to fail; 0: none
        -> (exit status, calls for room)"""
        with open(self.journal, "wb") as journal:
            done = subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", "--media.root", str(self.root), "--state.directory", str(self.state),
                                   "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "50"], env=self.full_disk(full_from), stderr=journal, timeout=PATIENCE)
        return done.returncode, int.from_bytes(self.counter.read_bytes()[:8], "little")

    def found(self):
        """path -> what was found out, and the bytes of what is stored of it, which must be there"""
        found = {}
        for path, record in self.records().items():
            stored = [self.state / "store" / shot["stored"]["file"] for shot in record["shots"] if "stored" in shot
                      and not shot["stored"].get("dropped")]
            found[path] = (record["state"], record["complete"], len(record["shots"]), [file.stat().st_size for file in stored])
        return found

    def test_a_disk_that_becomes_full_at_any_point_leaves_nothing_half_and_the_next_start_makes_up_for_it(self):
        make_film(self.root / "film.avi")
        (self.root / "08-18 day").mkdir()
        (self.root / "08-18 day" / ".vitrine.toml").write_text("seconds = 20\n")
        png(self.root / "08-18 day" / "photo.png", 64, 48, lambda x, y: (200, x, y))
        code, points = self.once(0)
        self.assertEqual(code, 0, self.journal.read_text())
        whole = self.found()
        self.assertEqual([state for state, *_ in whole.values()], ["ready", "ready"])
        self.assertGreater(points, 20)
        step = max(1, points // OPTIONS.points) if OPTIONS.points else 1
        tried = range(1, points + 1, step)
        for point in tried:
            with self.subTest(point=point, of=points):
                shutil.rmtree(self.state)
                shutil.rmtree(self.root / "_STATUS", ignore_errors=True)
                code, _ = self.once(point)
                self.assertIn(code, (0, 1), self.journal.read_text())
                for path, (state, _, _, stored) in self.found().items():
                    self.assertEqual(state, "ready", self.journal.read_text())
                    self.assertIn(stored, ([], whole[path][3]))
                self.assertEqual([], list(self.home.rglob("*.new")))
                code, _ = self.once(0)
                self.assertEqual(code, 0, self.journal.read_text())
                self.assertEqual(self.found(), whole)
                for name in ("index.html", "status.txt"):
                    self.assertTrue((self.root / "_STATUS" / name).stat().st_size > 0, name)
        print(f"full at {len(tried)} of {points} points", file=sys.stderr)

    def play(self, full_from):
        """Until all is on the wall and what the player writes now and then was due. -> calls for room"""
        with open(self.journal, "wb") as journal:
            player = subprocess.Popen([PLAYER, "--pace", "realtime", "--media.root", str(self.root), "--state.directory", str(self.state),
                                       "--metrics.file", str(self.state / "vitrine.prom"), "--output.screen", "offscreen:160x90",
                                       "--output.frame_rate", "5"], env=self.full_disk(full_from), stderr=journal, stdout=subprocess.DEVNULL)
        self.addCleanup(player.wait)
        self.addCleanup(player.kill)
        self.wait(lambda: "wall of 2 items" in self.journal.read_text(), player)
        begin = time.monotonic()
        self.wait(lambda: time.monotonic() > begin + 7, player)
        player.terminate()
        self.assertEqual(player.wait(PATIENCE), 0, self.journal.read_text())
        return int.from_bytes(self.counter.read_bytes()[:8], "little")

    def test_a_player_whose_disk_is_full_shows_what_there_is(self):
        make_film(self.root / "film.avi")
        png(self.root / "photo.png", 64, 48, lambda x, y: (200, x, y))
        self.assertEqual(self.once(0)[0], 0, self.journal.read_text())
        points = self.play(0)
        self.assertGreater(points, 3)
        for name in ("wall.jpg", "screen", "vitrine.prom"):
            self.assertTrue((self.state / name).exists(), f"{name}: {self.journal.read_text()}")
            (self.state / name).unlink()
        for point in sorted({1, points // 2, points}):
            with self.subTest(point=point, of=points):
                self.play(point)
                for line in set(self.journal.read_text().splitlines()):
                    self.assertLessEqual(self.journal.read_text().count(line), 3, "said again and again")
                self.assertEqual([], [file for file in self.state.rglob("*.new")] + list(self.state.glob("playing*")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + REST)
