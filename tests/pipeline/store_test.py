#!/usr/bin/env python3
"""The wall does not depend on the media folder once it plays: whatever happens there, the same pictures come.

    store_test.py BUILD_DIRECTORY [unittest arguments]
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

BUILD = Path(sys.argv[1]).resolve()
ANALYZER = BUILD / "analyzer" / "vitrine-analyzer"
PLAYER = BUILD / "player" / "vitrine-player"
PATIENCE = 240  # seconds until something that must come is given up
WIDTH, HEIGHT, RATE = 320, 180, 10


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", *map(str, arguments)], check=True)


def make_media(root):
    for i, (colour, motion) in enumerate((("navy", "20*t"), ("maroon", "100-20*t"))):
        ffmpeg("-f", "lavfi", "-i", f"color={colour}:size=192x108:rate=10:duration=3,drawbox=x='{motion}':y=30:w=40:h=40:c=white:t=fill",
               "-c:v", "mpeg4", "-g", 10, root / f"film{i}.mp4")
    ffmpeg("-f", "lavfi", "-i", "color=gray:size=160x120,drawbox=x=50:y=30:w=50:h=50:c=red:t=fill", "-frames:v", 1, root / "photo.png")


def overwrite(root):
    """As a file server does it: the same files, other content."""
    for file in filter(Path.is_file, root.iterdir()):
        with open(file, "r+b") as open_file:
            open_file.write(os.urandom(file.stat().st_size))


def truncate(root):
    for file in filter(Path.is_file, root.iterdir()):
        os.truncate(file, 0)


def unmount(root):
    shutil.rmtree(root)


class Store(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="vitrine-store-")
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name) / "media"
        self.state = Path(self.folder.name) / "state"
        self.root.mkdir()
        make_media(self.root)
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings()], check=True, timeout=PATIENCE)

    def settings(self, *more):
        return ["--media.root", str(self.root), "--state.directory", str(self.state), "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "0",
                "--show.dwell_seconds", "2", *more]

    def records(self):
        return [json.loads(file.read_text()) for file in (self.state / "catalogue").glob("*.json")]

    def play(self, name, disturb=None):
        """The wall's pictures, six seconds of them, each exact. `disturb` happens to the folder in the midst."""
        film, log = self.state / f"{name}.mp4", self.state / f"{name}.log"
        with open(log, "w") as said:
            player = subprocess.Popen([PLAYER, *self.settings("--log.level", "debug"), "--screen", f"offscreen:{WIDTH}x{HEIGHT}",
                                       "--output.frame_rate", str(RATE), "--slots", "2", "--duration", "6s", "--film", film], stderr=said)
            try:
                end = time.monotonic() + PATIENCE
                while disturb and "appears" not in log.read_text() and player.poll() is None and time.monotonic() < end:
                    time.sleep(0.02)
                if disturb:
                    disturb(self.root)
            finally:
                self.assertEqual(player.wait(PATIENCE), 0, log.read_text())
        self.assertNotIn("played from the media folder", log.read_text())
        return subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-i", film, "-f", "framemd5", "-"], check=True, capture_output=True).stdout

    def test_every_shot_is_stored_and_its_file_is_there(self):
        records = self.records()
        self.assertEqual(len(records), 3)
        for record in records:
            for shot in record["shots"]:
                self.assertTrue((self.state / "store" / shot["stored"]["file"]).is_file(), record)
                self.assertFalse(shot["stored"]["dropped"])

    def test_every_file_of_the_store_can_be_read_by_its_owner_and_group(self):
        for path in (self.state / "store").rglob("*"):
            if path.is_file():
                self.assertEqual(path.stat().st_mode & 0o440, 0o440, path)

    def test_overwriting_truncating_and_removing_the_media_changes_no_picture(self):
        undisturbed = self.play("undisturbed")
        self.assertGreater(undisturbed.count(b"\n"), 6 * RATE)
        for disturb in (overwrite, truncate, unmount):
            with self.subTest(disturb.__name__):
                self.assertEqual(self.play(disturb.__name__, disturb), undisturbed)
        self.assertFalse(self.root.exists())

    def test_a_store_that_is_deleted_is_made_again_and_one_that_is_off_is_emptied(self):
        shutil.rmtree(self.state / "store")
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings()], check=True, timeout=PATIENCE)
        self.test_every_shot_is_stored_and_its_file_is_there()
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings("--store.max_bytes", "0")], check=True, timeout=PATIENCE)
        self.assertEqual([file for file in (self.state / "store").rglob("*") if file.is_file()], [])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[2:]])
