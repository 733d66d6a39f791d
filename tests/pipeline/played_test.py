#!/usr/bin/env python3
"""Proof of play: for how long each file was seen, against what was on the wall.

    played_test.py BUILD_DIRECTORY [unittest arguments]

Plays drawn photos, kills the player, and sums up the tables in the status folder.
"""
import csv
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from drawn_media import png  # noqa: E402

BUILD = Path(sys.argv[1]).resolve()
ANALYZER, PLAYER = BUILD / "analyzer" / "vitrine-analyzer", BUILD / "player" / "vitrine-player"
PATIENCE = 300  # seconds until something that must end is given up
SLOTS = 2


class Played(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="vitrine-played-")
        self.addCleanup(folder.cleanup)
        self.root, self.state = Path(folder.name) / "media", Path(folder.name) / "state"
        self.root.mkdir()
        for i, name in enumerate("abcd"):
            png(self.root / f"{name}.png", 120, 90, lambda x, y, i=i: (200, 40 * i, 60) if (x // 20 + y // 10 * (i + 1)) % (3 + i) == 0 else (128, 128, 128))
        self.analyse()

    def settings(self):
        return ["--media.root", self.root, "--state.directory", self.state, "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "100"]

    def analyse(self):
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings()], check=True, timeout=PATIENCE, capture_output=True)

    def player(self, *options, dwell=5):
        return [PLAYER, *self.settings(), "--screen", "offscreen:160x90", "--output.frame_rate", "10", "--slots", str(SLOTS),
                "--show.dwell_seconds", str(dwell), "--show.motion_milliseconds", "500", *options]

    def seconds(self):
        """path -> seconds, over all days."""
        self.analyse()  # which copies the tables
        sums = {}
        for table in (self.root / "_STATUS" / "played").glob("*.csv"):
            for row in csv.DictReader(table.read_text().splitlines()):
                sums[row["file"]] = sums.get(row["file"], 0) + float(row["seconds"])
        return sums

    def test_the_seconds_of_all_files_are_those_of_all_places(self):
        subprocess.run([*map(str, self.player("--duration", "120s"))], check=True, timeout=PATIENCE, capture_output=True)
        seconds = self.seconds()
        self.assertEqual(set(seconds), {f"/{name}.png" for name in "abcd"})
        # While one photo gives way to another, both are seen for half a second at most: 120 s have 24 changes.
        self.assertGreater(sum(seconds.values()), SLOTS * 120 * 0.99)
        self.assertLess(sum(seconds.values()), SLOTS * 120 + 24 * 0.5)
        self.assertLess(max(seconds.values()), 1.4 * min(seconds.values()))

        subprocess.run([*map(str, self.player("--duration", "60s", "--status.played", "false"))], check=True, timeout=PATIENCE, capture_output=True)
        self.assertEqual(self.seconds(), seconds, "nobody counts")

    def play_and_kill(self):
        """For how many seconds the files were seen until the player was killed."""
        begin = None
        now = self.state / "played" / "now"
        shutil.rmtree(now.parent, ignore_errors=True)
        player = subprocess.Popen([*map(str, self.player("--pace", "realtime", dwell=3600))], stderr=subprocess.DEVNULL)
        while begin is None and player.poll() is None:
            begin = time.monotonic() if now.exists() and now.stat().st_size > 0 else None
            time.sleep(0.02)
        time.sleep(8)
        player.kill()
        player.wait()
        return time.monotonic() - begin

    def test_a_kill_loses_about_a_second(self):
        lost = []
        for _ in range(3):  # a busy machine may not let the player run for seconds
            seen = self.play_and_kill()
            counted = self.seconds().values()
            self.assertEqual(len(counted), SLOTS)
            lost.append(max(abs(seen - seconds) for seconds in counted))
            if lost[-1] < 2:
                return
        self.fail(f"a kill loses so many seconds: {lost}")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
