#!/usr/bin/env python3
"""The daemon weaves the tapestry of each film, in its own time, and goes on where it was stopped. A film that a visitor
opens before it is woven has a first view of it at once.

    tapestry_test.py BUILD_DIRECTORY [unittest arguments]

Draws its own film: tall and short, so that there are two levels of few tiles.
"""
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

BUILD = Path(sys.argv[1]).resolve()
ANALYZER = BUILD / "analyzer" / "vitrine-analyzer"
PLAYER = BUILD / "player" / "vitrine-player"
WIDTH, HEIGHT = 320, 180  # of the screen
PATIENCE = 900  # seconds until something that must come is given up: what is waited for lets all others go first


SECONDS = 42  # of the film, unless a test says otherwise


def make_film(path, seconds=SECONDS):
    """A new colour every second and a bar that moves."""
    colours = ["red", "navy", "gray", "olive", "teal", "maroon"] * 7
    takes = [f"color={colour}:size=40x100:rate=10:duration=1,drawbox=x='mod(t*20\\,30)':y={10 + 2 * i}:w=10:h=20:c=white:t=fill[v{i}]"
             for i, colour in enumerate(colours[:seconds])]
    joined = "".join(f"[v{i}]" for i in range(len(takes))) + f"concat=n={len(takes)}"
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-filter_complex", ";".join([*takes, joined]), "-c:v", "mpeg4", "-g", "10",
                    str(path)], check=True)


class Tapestry(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="vitrine-tapestry-")
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name) / "media"
        self.state = Path(self.folder.name) / "state"
        self.root.mkdir()

    def start(self, *more):
        journal = open(self.state.parent / "journal", "ab")
        watcher = subprocess.Popen([ANALYZER, "watch", "--media.root", str(self.root), "--state.directory", str(self.state),
                                    "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "100", "--store.max_bytes", "0", "--analyzer.rescan_seconds", "1",
                                    "--log.level", "debug", *more], stderr=journal)
        journal.close()
        self.addCleanup(watcher.wait)
        self.addCleanup(watcher.kill)
        return watcher

    def once(self, *more):
        subprocess.run([ANALYZER, "watch", "--once", "--media.root", str(self.root), "--state.directory", str(self.state),
                        "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "100", "--store.max_bytes", "0", *more],
                       check=True, timeout=PATIENCE)

    def folder_of(self, path):
        for file in (self.state / "catalogue").glob("*.json"):
            if json.loads(file.read_text())["path"] == path:
                return self.state / "tapestry" / file.stem
        return None

    def index(self, path):
        folder = self.folder_of(path)
        try:
            return json.loads((folder / "index.json").read_text()) if folder else None
        except FileNotFoundError:
            return None

    def wait_for(self, condition):
        end = time.monotonic() + PATIENCE
        while not condition():
            journal = (self.state.parent / "journal").read_text() if (self.state.parent / "journal").exists() else ""
            self.assertNotIn("not woven", journal)
            self.assertLess(time.monotonic(), end, journal)
            time.sleep(0.05)

    def levels(self, path):
        return len((self.index(path) or {"levels": []})["levels"])

    def woven(self, path):
        return (self.index(path) or {"complete": False})["complete"]

    def tiles(self, path):
        folder = self.folder_of(path)
        return {file.relative_to(folder): file for file in folder.rglob("*.jpg")}

    def weaver(self, daemon):
        """The daemon's weaving child, or None."""
        children = subprocess.run(["ps", "-o", "pid=,ni=,args=", "--ppid", str(daemon.pid)], capture_output=True, text=True, check=False).stdout
        for line in children.splitlines():
            pid, niceness, args = line.split(None, 2)
            if " weave " in args:
                return int(pid), int(niceness)
        return None

    def test_a_film_is_woven_over_a_kill_and_its_tapestry_goes_with_it(self):
        make_film(self.root / "film.mp4")
        daemon = self.start()
        self.wait_for(lambda: self.levels("film.mp4") == 1 and self.index("film.mp4")["folder"] == "tiles-1")
        self.assertFalse(self.woven("film.mp4"))
        before = {name: (file.stat().st_ino, file.stat().st_mtime_ns) for name, file in self.tiles("film.mp4").items() if name.parts[:2] == ("tiles-1", "0")}
        self.assertTrue((self.folder_of("film.mp4") / "frames").is_file())
        pid, niceness = self.weaver(daemon)
        self.assertEqual(niceness, os.getpriority(os.PRIO_PROCESS, 0) + 19 if os.getpriority(os.PRIO_PROCESS, 0) <= 0 else 19)
        daemon.send_signal(signal.SIGKILL)
        daemon.wait()
        self.wait_for(lambda: not Path(f"/proc/{pid}").exists() or "Z" in Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1][:3])

        daemon = self.start()
        self.wait_for(lambda: self.woven("film.mp4"))
        self.wait_for(lambda: self.weaver(daemon) is None)
        index = self.index("film.mp4")
        self.assertEqual(index["path"], "film.mp4")
        self.assertGreaterEqual(len(index["levels"]), 2)
        self.assertEqual(index["folder"], "tiles-1")
        self.assertEqual(len(index["frames"]["times_ns"]), 2 * SECONDS)  # the film's frames, two a second, for a finger that looks for a moment
        self.assertTrue(all((self.folder_of("film.mp4") / f"tiles-1/frames/{sheet:06}.jpg").is_file() for sheet in range(2 * SECONDS // 16 + 1)))
        self.assertTrue((self.folder_of("film.mp4") / "tiles-1/digits.png").is_file())  # its fonts can be read in the sandbox
        for level, its in enumerate(index["levels"]):
            self.assertTrue(all(after > time for time, after in zip(its["keyframes_ns"], its["keyframes_ns"][1:])))
            for tile in range((its["width"] + index["tile_width"] - 1) // index["tile_width"]):
                self.assertIn(Path(f"tiles-1/{level}/{tile:06}.jpg"), self.tiles("film.mp4"))
        for name, was in before.items():
            file = self.folder_of("film.mp4") / name
            self.assertEqual((file.stat().st_ino, file.stat().st_mtime_ns), was, "a level that was there was woven again")
        self.assertEqual(sorted(file.name for file in self.folder_of("film.mp4").iterdir()), ["index.json", "tiles-1"])
        self.assertNotIn("not woven", (self.state.parent / "journal").read_text())

        folder = self.folder_of("film.mp4")
        (self.root / "film.mp4").unlink()
        self.wait_for(lambda: not folder.exists())

    def test_a_film_that_is_opened_before_it_is_woven_has_a_strip_as_soon_as_its_frames_are_laid_out(self):
        make_film(self.root / "film.mp4")
        self.once("--without-tapestries")
        self.assertIsNone(self.index("film.mp4"))
        script = self.state.parent / "script.txt"
        # Again and again, as the wall may not stand yet; on a tapestry it does nothing but zoom.
        # Both fingers come down on one shot.
        x, y = 0.42 * WIDTH, 0.7 * HEIGHT
        script.write_text("".join(f"{at} down 0 {x - 10} {y}\n{at} down 1 {x + 10} {y}\n{at}.2 move 0 {x - 40} {y}\n{at}.2 move 1 {x + 40} {y}\n"
                                  f"{at}.4 up 0\n{at}.4 up 1\n" for at in range(3, PATIENCE, 4)))
        film = self.state.parent / "wall.mp4"
        said = self.state.parent / "player"
        with open(said, "wb") as log:
            player = subprocess.Popen([PLAYER, "--media.root", str(self.root), "--state.directory", str(self.state), "--pace", "realtime",
                                       "--screen", f"offscreen:{WIDTH}x{HEIGHT}", "--output.frame_rate", "10", "--rehearse", str(script),
                                       "--film", str(film), "--log.level", "debug"], stderr=log)
        self.addCleanup(player.wait)
        self.addCleanup(player.kill)
        self.wait_for(lambda: "tapestry of 'film.mp4', as soon as it is woven" in said.read_text())
        self.assertEqual(json.loads((self.state / "wanted_tapestry.json").read_text())["path"], "film.mp4")

        self.start()  # the analyzer
        self.wait_for(lambda: re.search("first view of the tapestry of 'film.mp4'|no tapestry of 'film.mp4' within", said.read_text()))
        if "within" in said.read_text():
            self.skipTest("this machine needs longer than a visitor waits")
        self.wait_for(lambda: self.woven("film.mp4"))
        self.assertIn("weaving 'film.mp4', as a visitor waits for it", (self.state.parent / "journal").read_text())
        self.wait_for(lambda: not (self.state / "wanted_tapestry.json").exists())  # nothing is waited for any more
        time.sleep(2)  # until the last strip has faded in
        player.send_signal(signal.SIGTERM)
        player.wait(PATIENCE)

        raw = subprocess.run(["ffmpeg", "-v", "error", "-i", str(film), "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], capture_output=True, check=True).stdout
        last = raw[-WIDTH * HEIGHT * 3:]
        row = [tuple(last[(140 * WIDTH + x) * 3:][:3]) for x in range(0, WIDTH, 4)]
        coloured = [colour for colour in row if max(colour) - min(colour) > 60]
        self.assertGreater(len(coloured), len(row) // 3, f"the strip shows the film's colours: {row}")

    def test_once_weaves_before_it_ends_unless_it_is_told_not_to(self):
        make_film(self.root / "film.mp4", 3)
        self.once("--without-tapestries")
        self.assertIsNotNone(self.folder_of("film.mp4"))
        self.assertFalse(self.woven("film.mp4"))
        self.once()
        self.assertTrue(self.woven("film.mp4"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[2:]])
