#!/usr/bin/env python3
"""The player decodes no file of the media folder itself: readers do, and what happens to them does not happen to it.

    readers_test.py BUILD_DIRECTORY [unittest arguments]

The tests on a share need root, FUSE and python3-fusepy; they are left out, and told, where these are not.
"""
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from mounted_share import MountedShare, can_mount

BUILD = Path(sys.argv[1]).resolve()
ANALYZER, PLAYER = BUILD / "analyzer" / "vitrine-analyzer", BUILD / "player" / "vitrine-player"
PATIENCE = 120  # seconds until something that must come is given up
STOP_PATIENCE = 2  # seconds in which a player must end, whatever its share does
UNIT_PATIENCE = 10  # seconds in which a player must end beside readers that are busy; TimeoutStopSec= of the unit
MAX_MEMORY = 250 << 20  # bytes of the player and all readers


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", *map(str, arguments)], check=True)


def avi_of(jpegs, width, height):
    """A film of JPEG pictures, one of each: their sizes are their own business."""
    def chunk(name, data):
        return name + len(data).to_bytes(4, "little") + data + b"\0" * (len(data) % 2)

    def numbers(*values):
        return b"".join(value.to_bytes(4, "little") for value in values)

    count = len(jpegs)
    main = chunk(b"avih", numbers(100_000, 0, 0, 0x10, count, 0, 1, 0, width, height, 0, 0, 0, 0))
    stream = chunk(b"strh", b"vidsMJPG" + numbers(0, 0, 0, 1, 10, 0, count, 0, 0xffffffff, 0, 0, 0))
    form = chunk(b"strf", numbers(40, width, height, 24 << 16 | 1) + b"MJPG" + numbers(width * height * 3, 0, 0, 0, 0))
    header = chunk(b"LIST", b"hdrl" + main + chunk(b"LIST", b"strl" + stream + form))
    pictures, index, at = b"", b"", 4
    for jpeg in jpegs:
        one = chunk(b"00dc", jpeg)
        index += b"00dc" + numbers(0x10, at, len(jpeg))
        pictures, at = pictures + one, at + len(one)
    return chunk(b"RIFF", b"AVI " + header + chunk(b"LIST", b"movi" + pictures) + chunk(b"idx1", index))


def children_of(process):
    return [int(child) for task in Path(f"/proc/{process}/task").glob("*") for child in (task / "children").read_text().split()]


def family_of(process):
    family = [process]
    for member in family:
        try:
            family += children_of(member)
        except OSError:
            continue
    return family


def memory_of(process):
    """Bytes: what is shared counts once."""
    try:
        text = Path(f"/proc/{process}/smaps_rollup").read_text()
    except OSError:
        return 0
    return sum(int(line.split()[1]) << 10 for line in text.splitlines() if line.startswith("Pss:"))


class Playing(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="vitrine-readers-")
        self.addCleanup(folder.cleanup)
        self.home = Path(folder.name)
        self.media, self.state, self.log = self.home / "media", self.home / "state", self.home / "log"
        self.media.mkdir()
        self.log.touch()

    def settings(self):
        return ["--media.root", str(self.media), "--state.directory", str(self.state), "--store.max_bytes", "0"]

    def make_media(self):
        for i, colour in enumerate(("navy", "maroon")):
            ffmpeg("-f", "lavfi", "-i", f"color={colour}:size=320x240:rate=10:duration=2,drawbox=x='20*t':y=30:w=40:h=40:c=white:t=fill",
                   "-c:v", "mjpeg", self.media / f"film{i}.avi")
        ffmpeg("-f", "lavfi", "-i", "color=gray:size=160x120,drawbox=x=50:y=30:w=50:h=50:c=red:t=fill", "-frames:v", 1,
               self.media / "photo.png")

    def analyse(self):
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "0", *self.settings()], check=True,
                       timeout=PATIENCE, stderr=subprocess.DEVNULL)

    def play(self, *options):
        with open(self.log, "wb") as log:
            player = subprocess.Popen([PLAYER, *self.settings(), "--pace", "realtime", "--screen", "offscreen:320x180",
                                       "--output.frame_rate", "10", "--slots", "3", "--log.level", "debug", *options], stderr=log)
        self.addCleanup(player.wait)
        self.addCleanup(player.kill)
        return player

    def until(self, what, condition):
        end = time.monotonic() + PATIENCE
        while not condition():
            self.assertLess(time.monotonic(), end, f"{what} never came true:\n{self.log.read_text()[-3000:]}")
            time.sleep(0.02)

    def until_all_appear(self, count=3):
        self.until(f"{count} sources appear", lambda: self.log.read_text().count(" appears") >= count)

    def stop(self, player, patience=STOP_PATIENCE):
        begin = time.monotonic()
        player.terminate()
        player.wait(PATIENCE)
        took = time.monotonic() - begin
        print(f"ended after {took:.1f} s", file=sys.stderr)
        self.assertLess(took, patience)
        self.assertEqual(player.returncode, 0, self.log.read_text()[-3000:])


class Readers(Playing):
    def test_readers_end_with_the_player_however_it_ends(self):
        self.make_media()
        self.analyse()
        for how in (signal.SIGTERM, signal.SIGKILL):
            with self.subTest(how.name):
                player = self.play()
                self.until_all_appear()
                family = family_of(player.pid)[1:]
                self.assertGreaterEqual(len(family), 3, "a host and two films' readers")
                player.send_signal(how)
                player.wait(PATIENCE)
                self.until("all are gone", lambda family=family: not any(Path(f"/proc/{one}/exe").is_symlink() and
                           Path(f"/proc/{one}/stat").read_text().split()[2] != "Z" for one in family))

    def test_a_host_and_readers_that_are_killed_do_not_end_the_wall(self):
        self.make_media()
        self.analyse()
        player = self.play("--show.dwell_seconds", "1")
        self.until_all_appear()
        os.kill(children_of(player.pid)[0], signal.SIGKILL)
        self.until("it is told", lambda: "not shown for now: its reader" in self.log.read_text())
        before = self.log.read_text().count(" appears")
        self.until("the photo is shown again", lambda: self.log.read_text().count(" appears") > before)
        self.assertNotIn("its reader crashed", self.log.read_text())
        self.stop(player)

    def test_a_film_that_changes_its_size_costs_no_more_memory_than_others(self):
        self.make_media()
        self.analyse()
        for size, name in (("320x240", "small"), ("16000x16000", "large")):
            ffmpeg("-f", "lavfi", "-i", f"color=gray:size={size}", "-frames:v", 1, "-pix_fmt", "yuvj420p", "-f", "mjpeg", self.home / name)
        small, large = (self.home / "small").read_bytes(), (self.home / "large").read_bytes()
        for film in self.media.glob("*.avi"):
            film.write_bytes(avi_of([small] * 8 + [large] * 4 + [small] * 8, 320, 240))
        max_memory = 0
        player = self.play()
        end = time.monotonic() + PATIENCE
        while self.log.read_text().count("far larger") + self.log.read_text().count("too large") < 2:
            self.assertLess(time.monotonic(), end, self.log.read_text()[-3000:])
            max_memory = max(max_memory, sum(memory_of(one) for one in family_of(player.pid)))
            time.sleep(0.02)
        self.stop(player, UNIT_PATIENCE)
        print(f"player and readers within {max_memory >> 20} MiB", file=sys.stderr)
        self.assertLess(max_memory, MAX_MEMORY)


@unittest.skipUnless(can_mount(), "a share needs root, /dev/fuse and python3-fusepy")
class OnAShare(Playing):
    def setUp(self):
        super().setUp()
        self.mounted, self.callers = self.home / "mounted", self.home / "callers"
        self.mounted.mkdir()
        self.callers.touch()
        self.share = MountedShare(self.media, self.mounted, self.home / "faults.json", self.callers)
        self.addCleanup(self.share.unmount)

    def settings(self):
        return ["--media.root", str(self.mounted), "--state.directory", str(self.state), "--store.max_bytes", "0"]

    def hang(self, *calls):
        self.share.fail_with(*({"path": "/*", "call": call, "hang": True} for call in calls))

    def test_the_players_own_process_opens_and_reads_no_file_of_the_media_folder(self):
        self.make_media()
        self.analyse()
        self.callers.write_text("")
        player = self.play("--show.dwell_seconds", "1")
        self.until_all_appear()
        self.stop(player)
        callers = [line.split() for line in self.callers.read_text().splitlines()]
        self.assertGreaterEqual(sum(call == "open" for _, call in callers), 3)
        self.assertNotIn(str(player.pid), {process for process, _ in callers})

    def test_a_player_whose_share_hangs_ends_at_once(self):
        self.make_media()
        self.analyse()
        for calls in (["read"], ["open"], ["open", "read", "stat"]):
            with self.subTest(calls=calls):
                player = self.play("--show.dwell_seconds", "1")
                self.until_all_appear()
                self.hang(*calls)
                time.sleep(2)  # until readers hang
                self.stop(player)
                self.hang()


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[2:]])
