#!/usr/bin/env python3
"""What is very large costs no more memory than a small machine has, and what goes on for long no more than at its begin.

    endurance_test.py BUILD_DIRECTORY [--seconds N] [unittest arguments]

--seconds: how long the wall rotates, by its own clock.
"""
import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

parser = argparse.ArgumentParser()
parser.add_argument("build", type=Path)
parser.add_argument("--seconds", type=int, default=400)
OPTIONS, REST = parser.parse_known_args()
ANALYZER, PLAYER = (OPTIONS.build.resolve() / name for name in ("analyzer/vitrine-analyzer", "player/vitrine-player"))
PATIENCE = 600  # seconds until something that must come is given up
MAX_ANALYSING, MAX_PLAYING = 500 << 20, 700 << 20  # bytes resident
MAX_ANALYSING_8K = 900 << 20  # a frame has 50 MB there, and a decoder holds a dozen
MAX_GROWTH = 4 << 20  # between the third and the last quarter of the rotation
PAGE = os.sysconf("SC_PAGE_SIZE")


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-f", "lavfi", "-i", *map(str, arguments)], check=True)


class Endurance(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="vitrine-endurance-")
        self.addCleanup(folder.cleanup)
        self.media, self.state = Path(folder.name) / "media", Path(folder.name) / "state"
        self.media.mkdir()
        self.settings = ["--media.root", self.media, "--state.directory", self.state, "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "0"]

    def cost(self, *command):
        """-> (words on the standard output, bytes resident at most)"""
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as complaint:
            process = subprocess.Popen([str(word) for word in command], stdout=out, stderr=complaint)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            out.seek(0)
            complaint.seek(0)
            self.assertEqual(process.returncode, 0, complaint.read()[-2000:])
            return out.read(), usage.ru_maxrss * 1024

    def analyse_all(self):
        """Every file must be ready."""
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings], check=True, timeout=PATIENCE, stderr=subprocess.DEVNULL)
        records = [json.loads(file.read_text()) for file in (self.state / "catalogue").glob("*.json")]
        self.assertEqual({record["path"] for record in records}, {file.name for file in self.media.iterdir() if file.is_file()})
        self.assertEqual({record["path"]: (record["state"], record["reason"]) for record in records if record["state"] != "ready"}, {})

    def test_huge_pictures_and_films_are_shown_within_bounds(self):
        ffmpeg("testsrc2=size=2500x2500:rate=1", "-frames:v", 1, "-vf", "scale=10000:10000:flags=neighbor", "-q:v", 5, self.media / "100 MP.jpg")
        ffmpeg("testsrc2=size=2000x50:rate=1", "-frames:v", 1, "-vf", "scale=20000:500:flags=neighbor", self.media / "panorama.png")
        ffmpeg("testsrc2=size=1920x1080:rate=5:duration=1", "-vf", "scale=7680:4320:flags=neighbor", "-c:v", "libx264", "-preset", "ultrafast",
               "-pix_fmt", "yuv420p", self.media / "8K.mp4")
        for file in sorted(self.media.iterdir()):
            with self.subTest(file.name):
                said, memory = self.cost(ANALYZER, "analyze", file, *self.settings)
                print(f"{file.name}: analysed within {memory >> 20} MiB", file=sys.stderr)
                self.assertEqual(json.loads(said)["state"], "ready")
                self.assertLess(memory, MAX_ANALYSING_8K if file.name == "8K.mp4" else MAX_ANALYSING)
        self.analyse_all()
        log = self.state / "log"
        _, memory = self.cost("sh", "-c", 'exec "$@" 2>"$0"', log, PLAYER, *self.settings, "--screen", "offscreen:320x180",
                              "--output.frame_rate", 5, "--duration", "4s", "--slots", 3, "--log.level", "debug")
        print(f"played within {memory >> 20} MiB", file=sys.stderr)
        self.assertLess(memory, MAX_PLAYING)
        self.assertGreaterEqual(len(set(re.findall(r"source (\d+) appears", log.read_text()))), 3, log.read_text()[-2000:])

    def test_a_very_wide_picture_is_judged_the_same_each_time(self):
        panorama = self.media / "panorama.png"
        ffmpeg("testsrc2=size=2000x50:rate=1", "-frames:v", 1, "-vf", "scale=20000:500:flags=neighbor", panorama)
        self.assertEqual(len({self.cost(ANALYZER, "analyze", panorama, *self.settings)[0] for _ in range(25)}), 1)

    def test_a_wall_that_rotates_for_long_grows_by_nothing(self):
        for i in range(8):
            ffmpeg(f"color=0x{37 * i % 200 + 40:02x}{91 * i % 200 + 40:02x}80:size=96x64,drawbox=x={6 * i}:y=20:w=24:h=24:c=white:t=fill",
                   "-frames:v", 1, self.media / f"photo {i}.png")
        for i in range(4):
            ffmpeg(f"color=navy:size=96x64:rate=5:duration=2,drawbox=x='t*{10 + 5 * i}':y=20:w=20:h=20:c=white:t=fill",
                   "-c:v", "mpeg4", self.media / f"film {i}.avi")
        self.analyse_all()
        log = self.state / "log"
        seen = []  # (bytes resident, files open)
        with open(log, "w") as said:
            player = subprocess.Popen([str(word) for word in (
                PLAYER, *self.settings, "--screen", "offscreen:96x54", "--output.frame_rate", 2, "--slots", 4, "--duration",
                f"{OPTIONS.seconds}s", "--show.dwell_seconds", 1, "--show.motion_milliseconds", 0,
                "--log.level", "debug")], stderr=said)
            self.addCleanup(player.wait)
            self.addCleanup(player.kill)
            end = time.monotonic() + PATIENCE
            while player.poll() is None:
                self.assertLess(time.monotonic(), end, log.read_text()[-2000:])
                try:
                    pages = int(Path(f"/proc/{player.pid}/statm").read_text().split()[1])
                    seen.append((pages * PAGE, len(os.listdir(f"/proc/{player.pid}/fd"))))
                except OSError:
                    break  # it is ending
                time.sleep(0.05)
        self.assertEqual(player.wait(PATIENCE), 0, log.read_text()[-2000:])
        turns = log.read_text().count("appears")
        quarter = len(seen) // 4
        memory = [statistics.median(bytes for bytes, _ in seen[i * quarter:(i + 1) * quarter]) for i in range(4)]
        files = [max(count for _, count in seen[i * quarter:(i + 1) * quarter]) for i in range(4)]
        print(f"{turns} shots; MiB by quarters: {[f'{m / 2**20:.1f}' for m in memory]}; files: {files}", file=sys.stderr)
        self.assertGreater(turns, OPTIONS.seconds / 5)
        self.assertGreater(len(seen), 40)
        self.assertLess(memory[3] - memory[2], MAX_GROWTH)
        self.assertLessEqual(files[3], max(files[:3]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + REST)
