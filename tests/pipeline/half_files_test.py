#!/usr/bin/env python3
"""The first half and nine tenths of a file of every format are never ready, all of it is.

    half_files_test.py BUILD_DIRECTORY [unittest arguments]
"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from drawn_media import png
from mutated_media import draw_films, draw_seeds, drawn

BUILD = Path(sys.argv[1]).resolve()
ANALYZER = BUILD / "analyzer" / "vitrine-analyzer"
PATIENCE = 120  # seconds until something that must come is given up
PARTS = (0.5, 0.9, 0.99)
# What else is taken though docs/operator.md does not name it, or names it apart.
OTHERS = {
    "mpeg1.ts": ["-c:v", "mpeg1video", "-r", "25"],
    "vp8.mkv": ["-c:v", "libvpx", "-deadline", "realtime"],
    "h264.m2ts": ["-c:v", "libx264", "-preset", "ultrafast", "-mpegts_m2ts_mode", "1"],
    "ffv1.mkv": ["-c:v", "ffv1"], "h265.mov": ["-c:v", "libx265", "-preset", "ultrafast", "-x265-params", "log-level=none"],
}
ANIMATIONS = {"moving.gif": ["-pix_fmt", "rgb8"], "moving.webp": ["-c:v", "libwebp_anim"], "moving.apng": ["-f", "apng", "-plays", "0"]}
NOISE = "testsrc2=size=96x64:rate=5:duration=1,noise=alls=40:allf=t"
# Formats that this machine's decoders may lack; the half of one is not ready all the same.
MAY_BE_UNREADABLE = {"moving.webp"}


class HalfFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="vitrine-half-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def analysed(self, path, *options):
        done = subprocess.run([ANALYZER, "analyze", "--grow", path, "--state.directory", self.folder / "state", *options],
                              capture_output=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        return [json.loads(line) for line in done.stdout.splitlines() if line]

    def seeds(self):
        seeds = draw_seeds(self.folder) | draw_films(self.folder, OTHERS) | drawn(self.folder, ANIMATIONS, NOISE, [])
        big = self.folder / "big.png"  # many rows are missing of its half
        png(big, 300, 300, lambda x, y: (x * y % 251, x * 7 % 256, y * 13 % 256))
        return seeds | {"big.png": big}

    def test_a_part_of_a_file_is_never_ready_and_all_of_it_is(self):
        seeds = self.seeds()
        self.assertLessEqual({"jpg", "png", "gif", "mpeg4.mp4", "mpeg4.avi", "mpeg2.ts"}, seeds.keys())
        table = []
        for name, seed in seeds.items():
            data = seed.read_bytes()
            whole = self.analysed(seed)[-1]["state"]
            if name not in MAY_BE_UNREADABLE:
                with self.subTest(name):
                    self.assertEqual(whole, "ready")
            states = []
            for share in PARTS:
                part = self.folder / f"part.{name}"
                # Between two packets a stream without a length can be cut unseen: those are of an even length.
                part.write_bytes(data[:int(len(data) * share) | 1])
                said = self.analysed(part)
                states.append(said[-1]["state"])
                part.unlink()
                with self.subTest(name, share=share):
                    self.assertEqual([line["reason"] for line in said if line["state"] == "ready"], [])
                    if whole == "ready":
                        self.assertEqual(said[-1]["state"], "waiting", said[-1]["reason"])
            table.append(f"{name:16}{len(data):8} {'  '.join(f'{state:12}' for state in (whole, *states))}")
        print("format             bytes whole         " + "".join(f"{share:<14.0%}" for share in PARTS), *table, sep="\n", file=sys.stderr)

    def test_a_recording_that_was_cut_off_for_good_is_taken_after_its_last_wait(self):
        seeds = draw_films(self.folder, {"mpeg2.ts": ["-c:v", "mpeg2video"]})
        part = self.folder / "part.ts"
        data = seeds["mpeg2.ts"].read_bytes()
        part.write_bytes(data[:len(data) * 3 // 4 // 188 * 188 + 100])
        self.assertEqual(self.analysed(part)[-1]["state"], "waiting")
        self.assertEqual(self.analysed(part, "--as-it-is")[-1]["state"], "ready")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
