#!/usr/bin/env python3
"""Both programs for an hour on a share: a change each second, a fault each minute. No good file is lost, no frame is
black, and neither memory nor descriptors grow.

    long_run_test.py BUILD_DIRECTORY [--seconds N] [--seed N] [--warm-up N] [unittest arguments]

--seconds: of real time (3600). --warm-up: seconds that do not count for growth (600).
Needs FUSE and python3-fusepy; ends with 77 where they are not. Runs shorter than an hour print growth and do not judge it.
"""
import argparse
import errno
import os
import random
import re
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from drawn_media import pattern, png
from mounted_share import MountedShare, can_mount
from watched_folder import records_in

parser = argparse.ArgumentParser()
parser.add_argument("build", type=Path)
parser.add_argument("--seconds", type=int, default=3600)
parser.add_argument("--warm-up", type=int, default=600)
parser.add_argument("--seed", type=int, default=random.randrange(1 << 32))
OPTIONS, REST = parser.parse_known_args()
ANALYZER, PLAYER = (OPTIONS.build.resolve() / name for name in ("analyzer/vitrine-analyzer", "player/vitrine-player"))
SKIPPED = 77
PATIENCE = 300  # seconds until something that must come is given up
FULL = 3600  # seconds; growth of shorter runs is not judged
MAX_GROWTH, MAX_DESCRIPTORS = 1 << 20, 1  # an hour
BETWEEN_FAULTS = 60
BETWEEN_LOOKS = 5
PARTS = 10  # of the time, for the error of a growth
MAX_CHANGING = 60  # files
SHARE_OF_FILMS = 0.25  # of the files that change
ERRORS = ["EIO", "ESTALE", "EACCES", "ENOTCONN", "EHOSTDOWN", "ETIMEDOUT", "ENAMETOOLONG", "ELOOP", "ENOMEM", "EMFILE"]
CALLS = ["stat", "list", "open", "read"]
BACKGROUND = "#4060a0"  # so that black is a hole
DARK, HOLE = 24, 3  # of 255; per cent of a frame


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", *map(str, arguments)], check=True)


def family_of(process):
    family = [process]
    for member in family:
        try:
            for task in Path(f"/proc/{member}/task").glob("*"):
                family += [int(child) for child in (task / "children").read_text().split()]
        except OSError:
            continue  # it has ended
    return family


def costs_of(process):
    """-> bytes resident, bytes in proportion, bytes of no file and not shared, descriptors"""
    text = Path(f"/proc/{process}/smaps_rollup").read_text()
    sizes = {line.split()[0]: int(line.split()[1]) << 10 for line in text.splitlines()[1:]}
    return sizes["Rss:"], sizes["Pss:"], sizes["Anonymous:"], len(os.listdir(f"/proc/{process}/fd"))


def growth_an_hour(rows, column):
    """-> of a column of `rows` by least squares, and its standard error: how it varies where a tenth of the time is left out"""
    def growth(some):
        return 3600 * statistics.linear_regression([row[0] for row in some], [row[column] for row in some]).slope

    tenth = len(rows) // PARTS
    others = [growth(rows[:part * tenth] + rows[(part + 1) * tenth:]) for part in range(PARTS)]
    return growth(rows), (PARTS - 1) ** 0.5 * statistics.pstdev(others)


def descriptors_an_hour(rows):
    """-> growth of the least number, from the first third to the last: what stays while films come and go"""
    third = len(rows) // 3
    begin, end = rows[:third], rows[-third:]
    return (min(row[-1] for row in end) - min(row[-1] for row in begin)) / (end[0][0] - begin[0][0]) * 3600


class LongRun(unittest.TestCase):
    def setUp(self):
        print(f"seed {OPTIONS.seed}", file=sys.stderr)
        self.random = random.Random(OPTIONS.seed)
        folder = tempfile.TemporaryDirectory(prefix="vitrine-long-", ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.home = Path(folder.name)
        self.backing, self.media, self.state = (self.home / name for name in ("backing", "media", "state"))
        self.backing.mkdir()
        self.media.mkdir()
        self.journal, self.film = self.home / "journal", self.home / "wall.mp4"
        self.kept, self.changing, self.hurt = set(), set(), set()  # paths: of good files, of such that change, of broken ones
        self.number = 0
        self.draw()
        self.share = MountedShare(self.backing, self.media, self.home / "faults.json")
        self.addCleanup(self.share.unmount)

    def draw(self):
        for number in range(24):
            self.kept.add(self.photo(f"kept {number}.png"))
        for number in range(4):
            name = f"kept {number}.mp4"
            ffmpeg("-f", "lavfi", "-i", f"color=0x{90 + 40 * number:02x}8060:size=160x120:rate=10:duration={2 + number},"
                   "drawbox=x='20*t':y=30:w=40:h=40:c=white:t=fill", "-pix_fmt", "yuv420p", self.backing / name)
            self.kept.add(name)

    def photo(self, name):
        self.number += 1
        file = self.backing / name
        file.parent.mkdir(exist_ok=True)
        png(file, 64, 48, pattern(self.number))
        return name

    def start(self, program, *options):
        with open(self.journal, "ab") as journal:
            process = subprocess.Popen([program, *options, "--media.root", self.media, "--state.directory", self.state,
                                        "--store.max_bytes", "1000000", "--status.folder", ""], stderr=journal)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    # What happens each second

    def change(self):
        ways = [self.add, self.add, self.replace, self.overwrite, self.rename, self.remove]
        if len(self.changing) >= MAX_CHANGING:
            ways = [self.remove]
        elif len(self.changing) < MAX_CHANGING // 2:
            ways = [self.add]
        self.random.choice(ways)()

    def one_that_changes(self):
        return self.random.choice(sorted(self.changing))

    def new_name(self, ending):
        self.number += 1
        return f"{self.random.choice(['', 'hall/', 'lobby/'])}new {self.number}.{ending}"

    def write(self, name, ending):
        """A photo or a film, by its ending."""
        if ending == "png":
            self.photo(name)
        else:
            (self.backing / name).parent.mkdir(exist_ok=True)
            (self.backing / name).write_bytes((self.backing / f"kept {self.random.randrange(4)}.mp4").read_bytes())

    def add(self):
        """The share of films stays as it is: they cost another memory than photos."""
        films = sum(name.endswith("mp4") for name in self.changing)
        ending = "mp4" if films < SHARE_OF_FILMS * len(self.changing) else "png"
        name = self.new_name(ending)
        self.write(name, ending)
        self.changing.add(name)

    def replace(self):
        name = self.one_that_changes()
        self.write(name + ".new", name[-3:])
        (self.backing / (name + ".new")).rename(self.backing / name)

    def overwrite(self):
        name = self.one_that_changes()
        self.write(name, name[-3:])

    def rename(self):
        name = self.one_that_changes()
        new = self.new_name(name[-3:])
        (self.backing / new).parent.mkdir(exist_ok=True)
        (self.backing / name).rename(self.backing / new)
        self.changing ^= {name, new}

    def remove(self):
        name = self.one_that_changes()
        (self.backing / name).unlink()
        self.changing.remove(name)

    # What goes wrong each minute: each is a generator that goes on a second later, and is over when it ends.

    def an_error(self):
        fault = {"path": "*", "call": self.random.choice(CALLS), "errno": getattr(errno, self.random.choice(ERRORS))}
        self.share.fail_with(fault)
        yield from range(15)
        self.share.fail_with()

    def a_share_that_hangs(self):
        self.share.fail_with(*({"path": "*", "call": call, "hang": True} for call in CALLS))
        yield from range(20)
        self.share.fail_with()

    def half_a_listing(self):
        self.share.fail_with({"path": "*", "call": "list", "half": True})
        yield from range(15)
        self.share.fail_with()

    def short_reads(self):
        self.share.fail_with({"path": "*", "call": "read", "short": 100})
        yield from range(15)
        self.share.fail_with()

    def a_share_that_dies(self):
        self.share.kill()
        yield from range(10)
        subprocess.run(["umount", "-l", self.media], check=True)
        yield from range(5)
        self.share.mount()

    def kills(self):
        for _ in range(15):
            for child in [child for program in self.programs for child in family_of(program.pid)[1:]]:
                if self.random.random() < 0.5:
                    try:
                        os.kill(child, signal.SIGKILL)
                    except ProcessLookupError:
                        pass
            yield

    def broken_files(self):
        for number, kept in enumerate(["kept 0.png", "kept 0.mp4", "kept 1.mp4"]):
            whole = (self.backing / kept).read_bytes()
            name = f"broken {self.number} {number}{kept[-4:]}"
            (self.backing / name).write_bytes(whole[:len(whole) // 2] if number < 2 else whole[:64] + self.random.randbytes(5000))
            self.hurt.add(name)
            yield
        yield from range(30)
        for name in self.hurt:
            (self.backing / name).unlink()
        self.hurt.clear()

    def ways_to_fail(self):
        return [self.an_error, self.a_share_that_hangs, self.half_a_listing, self.short_reads, self.a_share_that_dies, self.kills,
                self.broken_files]

    # What must hold

    def look(self, costs, seconds):
        for program in self.programs:
            self.assertIsNone(program.poll(), self.words())
            costs.setdefault(program, []).append((seconds, *costs_of(program.pid)))
        records = records_in(self.state / "catalogue")
        lost = {name for name in self.kept if records.get(name, {}).get("state") != "ready"}
        self.assertFalse(lost, self.words())

    def words(self):
        return self.journal.read_text(errors="replace")[-4000:]

    def until_all_ready(self):
        end = time.monotonic() + PATIENCE
        wanted = {name: "ready" for name in self.kept | self.changing}
        while (states := {path: record["state"] for path, record in records_in(self.state / "catalogue").items()
                          if path not in self.hurt}) != wanted:
            self.assertLess(time.monotonic(), end, f"{set(states.items()) ^ set(wanted.items())}\n{self.words()}")
            time.sleep(0.5)

    def black_frames(self):
        """-> number of frames, lines of those that have a hole"""
        said = subprocess.run(["ffmpeg", "-nostdin", "-i", self.film, "-vf", f"blackframe=amount={HOLE}:threshold={DARK}", "-f", "null", "-"],
                              check=True, capture_output=True, text=True).stderr
        return int(re.findall(r"frame= *(\d+)", said)[-1]), [line for line in said.splitlines() if "pblack:" in line]

    def growth_of(self, costs, name):
        """-> bytes and descriptors an hour"""
        seen = [row for row in costs if row[0] >= OPTIONS.warm_up]
        self.assertGreater(len(seen), PARTS)
        (resident, error), (proportional, _), (own, _) = (growth_an_hour(seen, column) for column in (1, 2, 3))
        descriptors = descriptors_an_hour(seen)
        print(f"{name}: {statistics.median(row[1] for row in seen) / 2**20:.1f} MiB resident, {min(row[4] for row in seen)} to "
              f"{max(row[4] for row in seen)} descriptors; growth an hour: {resident / 2**20:+.2f} MiB resident (standard error "
              f"{error / 2**20:.2f}), {proportional / 2**20:+.2f} MiB in proportion, {own / 2**20:+.2f} MiB of its own, "
              f"{descriptors:+.1f} descriptors", file=sys.stderr)
        return resident, descriptors

    def test_an_hour_on_a_bad_share(self):
        analyzer = self.start(ANALYZER, "watch", "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "300", "--analyzer.rescan_seconds", "2",
                              "--analyzer.face_model", "", "--tapestry.max_bytes", "0", "--analyzer.children", "2")
        self.programs = [analyzer]
        self.until_all_ready()
        player = self.start(PLAYER, "--pace", "realtime", "--output.screen", "offscreen:160x90", "--output.frame_rate", "5", "--slots", "6",
                            "--show.dwell_seconds", "1", "--show.background", BACKGROUND, "--film", self.film)
        self.programs = [analyzer, player]
        ways, costs, faults, changes, fault = [], {}, {}, 0, iter(())
        begin = time.monotonic()
        while (seconds := int(time.monotonic() - begin)) < OPTIONS.seconds:
            if changes % BETWEEN_FAULTS == BETWEEN_FAULTS - 1:
                ways = ways or self.random.sample(self.ways_to_fail(), len(self.ways_to_fail()))
                way = ways.pop()
                faults[way.__name__] = faults.get(way.__name__, 0) + 1
                fault = way()
            next(fault, None)
            self.change()
            changes += 1
            if changes % BETWEEN_LOOKS == 0:
                self.look(costs, seconds)
            time.sleep(max(0, begin + changes - time.monotonic()))
        for _ in fault:
            time.sleep(1)
        self.until_all_ready()
        self.assertIn("libjemalloc", Path(f"/proc/{player.pid}/maps").read_text(), "the allocator whose memory does not grow for hours")
        player.send_signal(signal.SIGTERM)
        self.assertEqual(player.wait(PATIENCE), 0, self.words())
        analyzer.send_signal(signal.SIGTERM)
        self.assertEqual(analyzer.wait(PATIENCE), 0, self.words())

        print(f"{changes} changes in {OPTIONS.seconds} s; faults: {faults}", file=sys.stderr)
        frames, black = self.black_frames()
        print(f"{frames} frames, {len(black)} black", file=sys.stderr)
        growths = [self.growth_of(costs[program], name) for program, name in ((analyzer, "analyzer"), (player, "player"))]
        self.assertEqual(black, [])
        self.assertGreater(frames, OPTIONS.seconds)
        if OPTIONS.seconds >= FULL:
            for memory, descriptors in growths:
                self.assertLess(memory, MAX_GROWTH)
                self.assertLess(descriptors, MAX_DESCRIPTORS)


if __name__ == "__main__":
    if not can_mount():
        print("NOT RUN: a long run needs root, /dev/fuse and python3-fusepy", file=sys.stderr)
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], "-v", *REST])
