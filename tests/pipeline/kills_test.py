#!/usr/bin/env python3
"""Both programs are killed from outside, stopped and continued, again and again: no good file is condemned.

    kills_test.py BUILD_DIRECTORY SYSTEM_PLUGINS [--kills N] [--photos N] [--film-seconds N] [--seed N] [unittest arguments]

--kills: of each program (30); beside a poison film there are no more than 30. --photos: beside that film (200).
--film-seconds: of the film whose reader is slow (300). The seed is printed.
"""
import argparse
import os
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

from drawn_media import pattern, png
from poisoned_media import KINDS, make_film, poisoned_environment
from watched_folder import records_in

parser = argparse.ArgumentParser()
parser.add_argument("build", type=Path)
parser.add_argument("plugins")
parser.add_argument("--kills", type=int, default=30)
parser.add_argument("--photos", type=int, default=200)
parser.add_argument("--film-seconds", type=int, default=300)
parser.add_argument("--seed", type=int, default=random.randrange(1 << 32))
OPTIONS, REST = parser.parse_known_args()
BUILD = OPTIONS.build.resolve()
ANALYZER, PLAYER = BUILD / "analyzer" / "vitrine-analyzer", BUILD / "player" / "vitrine-player"
PATIENCE = 900  # seconds until something that must come is given up
SHARE_OF_A_CORE = 20  # a slow reader runs for one part of so many
MAX_POISON_KILLS = 30


class Kills(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="vitrine-kills-", ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.home = Path(folder.name)
        self.media, self.state, self.journal = self.home / "media", self.home / "state", self.home / "journal"
        self.media.mkdir()
        print(f"seed {OPTIONS.seed}", file=sys.stderr)
        self.random = random.Random(OPTIONS.seed)

    def start(self, *command, poisoned=False):
        environment = poisoned_environment(BUILD, OPTIONS.plugins, self.home) if poisoned else None
        with open(self.journal, "ab") as journal:
            process = subprocess.Popen([*command, "--media.root", str(self.media), "--state.directory", str(self.state)],
                                       env=environment, stdout=subprocess.DEVNULL, stderr=journal)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def start_analyzer(self, *options, **environment):
        return self.start(ANALYZER, "watch", "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "100", "--analyzer.face_model", "", "--tapestry.max_bytes", "0",
                          *options, **environment)

    def start_player(self):
        return self.start(PLAYER, "--pace", "realtime", "--output.screen", "offscreen:160x90", "--output.frame_rate", "10",
                          "--show.dwell_seconds", "1")

    def draw(self, photos, films=0):
        for number in range(photos):
            png(self.media / f"{number}.png", 64, 48, pattern(number))
        for number in range(films):
            subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-f", "lavfi", "-i", f"testsrc2=size=160x120:rate=10:duration={3 + number}",
                            str(self.media / f"film {number}.mp4")], check=True)

    def states(self):
        counts = {}
        for record in records_in(self.state / "catalogue").values():
            counts.setdefault(record["state"], []).append(record["path"])
        return counts

    def kill(self, *processes):
        for process in self.random.sample(processes, len(processes)):
            process.kill()
            process.wait()

    def until_all_ready(self, *good):
        end = time.monotonic() + PATIENCE
        while not set(good) <= set(self.states().get("ready", [])):
            self.assertLess(time.monotonic(), end, f"{self.states()}\n{self.journal.read_text()[-3000:]}")
            time.sleep(0.2)

    def good_files(self):
        return [file.name for file in self.media.iterdir() if file.is_file() and file.name != "poison.avi"]

    def test_good_files_only(self):
        self.draw(photos=20, films=3)
        for kill in range(OPTIONS.kills):
            processes = self.start_analyzer(), self.start_player()
            png(self.media / f"new {kill}.png", 64, 48, pattern(-kill - 1))
            time.sleep(self.random.uniform(0.2, 2.5))
            self.kill(*processes)
        self.start_analyzer()
        self.until_all_ready(*self.good_files())
        self.assertEqual(set(self.states()), {"ready"}, self.states())
        blamed = self.state / "blamed"
        self.assertEqual(blamed.read_text() if blamed.exists() else "", "")

    def test_one_poison_film_among_good_files(self):
        self.draw(photos=OPTIONS.photos)
        make_film(self.media / "poison.avi", KINDS["aborts"])
        for _ in range(min(OPTIONS.kills, MAX_POISON_KILLS)):
            analyzer = self.start_analyzer(poisoned=True)
            time.sleep(self.random.uniform(0.2, 2.5))
            for child in self.children_of(analyzer):
                if self.random.random() < 0.5:
                    os.kill(child, signal.SIGKILL)
            time.sleep(0.1)
            self.kill(analyzer)
        self.start_analyzer(poisoned=True)
        end = time.monotonic() + PATIENCE
        while "quarantined" not in self.states():
            self.assertLess(time.monotonic(), end, f"{self.journal.read_text()[-3000:]}")
            time.sleep(0.2)
        self.until_all_ready(*self.good_files())
        self.assertEqual(self.states()["quarantined"], ["poison.avi"])

    @staticmethod
    def children_of(process):
        try:
            return [int(word) for word in Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()]
        except OSError:
            return []

    def is_ready_to_its_end(self, name):
        """Its clips may come later: at such a pace they take hours."""
        record = records_in(self.state / "catalogue").get(name, {})
        return record.get("state") == "ready" and record["shots"][-1]["ends_with"] == "end" and not record.get("reason")

    def slow_down(self, analyzer, is_over):
        """Lets each reader run for a twentieth of the time."""
        turn = 0.1
        while not is_over.is_set():
            children = self.children_of(analyzer)
            for wanted, pause in ((signal.SIGSTOP, turn * (SHARE_OF_A_CORE - 1)), (signal.SIGCONT, turn)):
                for child in children:
                    try:
                        os.kill(child, wanted)
                    except ProcessLookupError:
                        pass
                is_over.wait(pause)

    def test_a_long_film_whose_reader_has_a_twentieth_of_a_core(self):
        subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-f", "lavfi", "-i",
                        f"testsrc2=size=1920x1080:rate=25:duration={OPTIONS.film_seconds}", "-preset", "ultrafast",
                        str(self.media / "long.mp4")], check=True)
        analyzer = self.start_analyzer("--analyzer.deadline_seconds", "10")
        is_over = threading.Event()
        slowing = threading.Thread(target=self.slow_down, args=(analyzer, is_over))
        slowing.start()
        try:
            end = time.monotonic() + max(PATIENCE, 100 * OPTIONS.film_seconds)
            while not self.is_ready_to_its_end("long.mp4"):
                self.assertIsNone(analyzer.poll())
                self.assertNotIn("quarantined", self.states())
                self.assertLess(time.monotonic(), end, self.journal.read_text()[-3000:])
                time.sleep(0.5)
            self.assertNotIn("tried again", self.journal.read_text())
        finally:
            is_over.set()
            slowing.join()

    def test_deletions_beside_folders_that_are_too_deep(self):
        self.draw(photos=2)
        deep = self.media
        for _ in range(33):
            deep = deep / "d"
        deep.mkdir(parents=True)
        self.start_analyzer("--analyzer.rescan_seconds", "1")
        self.until_all_ready("0.png", "1.png")
        (self.media / "0.png").unlink()
        end = time.monotonic() + 60
        while "0.png" in self.states().get("ready", []):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.1)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *REST])
