#!/usr/bin/env python3
"""Films that crash, hang or eat the memory of whoever decodes them, in the folder of `vitrine-analyzer watch` and on the wall.

    poison_test.py BUILD_DIRECTORY SYSTEM_PLUGINS [unittest arguments]

The decoder that does it is a plugin of the tests (poison/plugin.cpp); SYSTEM_PLUGINS is where GStreamer's own lie.
"""
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from drawn_media import png
from poisoned_media import KINDS, make_film, poisoned_environment
from watched_folder import records_in

BUILD = Path(sys.argv[1]).resolve()
PLUGINS = sys.argv[2]
ANALYZER, PLAYER = BUILD / "analyzer" / "vitrine-analyzer", BUILD / "player" / "vitrine-player"
PATIENCE = 300  # seconds until something that must come is given up
DEADLINE = 10  # seconds of processor time of a child that reads poison
STALL_DEADLINE = 60  # longer than a child itself waits for a picture


class Poison(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="vitrine-poison-")
        self.addCleanup(self.folder.cleanup)
        self.home = Path(self.folder.name)
        self.root = self.home / "media"
        self.root.mkdir()
        self.journal = self.home / "journal"

    def run_poisoned(self, *command, is_limited_by_sanitizer=False):
        environment = poisoned_environment(BUILD, PLUGINS, self.home)
        options = environment.get("ASAN_OPTIONS", "") + ":abort_on_error=1"
        if is_limited_by_sanitizer:
            options += ":hard_rss_limit_mb=1500"
        environment["ASAN_OPTIONS"] = options
        with open(self.journal, "ab") as journal:
            process = subprocess.Popen([*command, "--media.root", str(self.root), "--state.directory", str(self.home / "state")],
                                       env=environment, stdout=subprocess.DEVNULL, stderr=journal)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def start(self, deadline=PATIENCE, kind=None):
        # An address sanitizer reserves more than any limit, so it stops the film that allocates itself. Its thread that looks at
        # the memory computes for more than a millisecond a second: a film that only sleeps would not count as one that does nothing.
        return self.run_poisoned(ANALYZER, "watch", "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "100", "--analyzer.deadline_seconds", str(deadline),
                                 "--analyzer.memory_mebibytes", "1024", "--tapestry.max_bytes", "0", is_limited_by_sanitizer=kind == "allocates")

    def stop(self, watcher):
        watcher.terminate()
        self.assertEqual(watcher.wait(PATIENCE), 0)

    def analyse_in_health(self):
        with open(self.journal, "ab") as journal:
            subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", "--media.root", str(self.root), "--state.directory", str(self.home / "state"),
                            "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "0", "--store.max_bytes", "0"], check=True, stderr=journal)

    def records(self):
        return records_in(self.home / "state" / "catalogue")

    def wait(self, condition):
        end = time.monotonic() + PATIENCE
        while not condition(self.records()):
            self.assertLess(time.monotonic(), end, f"{self.records()}\n{self.journal.read_text()}")
            time.sleep(0.1)

    def lines(self, word):
        return [line for line in self.journal.read_text().splitlines() if word in line]

    def check_poison(self, kind):
        self.wait(lambda r: r.get(f"{kind}.avi", {}).get("state", "waiting") != "waiting")
        record = self.records()[f"{kind}.avi"]
        if kind == "sleeps":
            self.assertEqual((record["state"], record["reason"]), ("failed", "the film does not start: no picture comes"))
        else:
            self.assertEqual(record["state"], "quarantined")
            self.assertTrue(record["reason"].startswith("twice "), record["reason"])
            self.assertEqual(record["fault"]["until_s"] - record["fault"]["since_s"], 24 * 3600)
            self.assertEqual(len(self.lines(f"will be tried again: '{kind}.avi'")), 1)
            self.wait(lambda _: self.lines(f"quarantined: '{kind}.avi'"))  # the record comes first
            self.assertEqual(len(self.lines(f"quarantined: '{kind}.avi'")), 1)
        self.assertEqual(self.records()["good.png"]["state"], "ready")

    def test_poison_is_tried_once_more_then_quarantined_and_hurts_nothing_else(self):
        png(self.root / "good.png", 64, 48, lambda x, y: (200, 100, 50))
        watcher = self.start()
        self.wait(lambda r: r.get("good.png", {}).get("state") == "ready")
        self.stop(watcher)

        for kind, width in KINDS.items():
            with self.subTest(kind):
                make_film(self.root / f"{kind}.avi", width)
                watcher = self.start(STALL_DEADLINE if kind == "sleeps" else DEADLINE, kind)  # which knows of no other crash
                try:
                    self.check_poison(kind)
                finally:
                    self.stop(watcher)

        # Neither a touch of its permissions nor another start tries it again.
        (self.root / "aborts.avi").chmod(0o640)
        self.start()
        png(self.root / "later.png", 64, 48, lambda x, y: (20, 100, 50))
        self.wait(lambda r: r.get("later.png", {}).get("state") == "ready")
        self.assertEqual(len(self.lines("will be tried again: 'aborts.avi'")), 1)

        # Once it is another content, it is.
        png(self.root / "aborts.avi", 32, 32, lambda x, y: (20, 200, 50))
        self.wait(lambda r: r["aborts.avi"]["state"] == "ready")

    def test_what_crashes_its_reader_twice_is_quarantined_and_the_player_plays_on(self):
        for name in ("a", "b", "z"):
            png(self.root / f"{name}.png", 64, 48, lambda x, y: (200, 100, 50))
        make_film(self.root / "film.avi", KINDS["aborts"])
        self.analyse_in_health()  # so that nobody knows until it is shown
        self.assertEqual({record["state"] for record in self.records().values()}, {"ready"})

        def play():
            return self.run_poisoned(PLAYER, "--pace", "realtime", "--output.screen", "offscreen:160x90", "--output.frame_rate", "5")

        for crashes in (1, 2):
            player = play()
            self.wait(lambda _, crashes=crashes: len(self.lines("its reader crashed: 'film.avi'")) == crashes)
            if crashes == 2:
                self.wait(lambda _: self.lines("quarantined: 'film.avi'"))
                self.wait(lambda _: all(self.lines(f"played from the media folder: '{name}.png'") for name in "abz"))
            player.terminate()
            self.assertEqual(player.wait(PATIENCE), 0, self.journal.read_text())
        self.analyse_in_health()
        self.assertEqual({path: record["state"] for path, record in self.records().items()},
                         {"a.png": "ready", "b.png": "ready", "film.avi": "quarantined", "z.png": "ready"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
