#!/usr/bin/env python3
"""vitrine-analyzer watch over a folder in which everything happens that happens to folders.

    watch_test.py BUILD_DIRECTORY HOSTILE_MEDIA [--files N] [--seed N] [unittest arguments]

Draws its own photos. HOSTILE_MEDIA is a folder of files that hurt readers; where it is missing, that part is passed over.
--files takes so many of them, chosen by the seed.
"""
import argparse
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import unittest
import zlib
from pathlib import Path

from watched_folder import PATIENCE, WatchedFolder

parser = argparse.ArgumentParser()
parser.add_argument("build", type=Path)
parser.add_argument("hostile", type=Path)
parser.add_argument("--files", type=int)
parser.add_argument("--seed", type=int, default=random.randrange(2**31))
OPTIONS, REST = parser.parse_known_args()
BUILD = OPTIONS.build.resolve()
HOSTILE = OPTIONS.hostile
ANALYZER = BUILD / "analyzer" / "vitrine-analyzer"
HOSTILE_PATIENCE = 900


def png(width=64, height=48, shade=200, ground=90, alpha=None):
    """A bright square on grey. `alpha` is that of the grey, of 255; the square hides what is behind it."""
    def chunk(name, data):
        body = name + data
        return len(data).to_bytes(4, "big") + body + zlib.crc32(body).to_bytes(4, "big")

    def pixel(x, y):
        is_inside = abs(x - width / 2) < 12 and abs(y - height / 2) < 12
        grey = [shade if is_inside else ground] * 3
        return grey if alpha is None else grey + [255 if is_inside else alpha]

    def row(y):
        return b"\0" + bytes(value for x in range(width) for value in pixel(x, y))

    header = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes([8, 2 if alpha is None else 6, 0, 0, 0])
    pixels = zlib.compress(b"".join(row(y) for y in range(height)))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")


def make_film(path, colours, seconds):
    """A film of plain takes, small enough to be drawn at once; a moving bar keeps each of them alive."""
    takes = [f"color={colour}:size=160x96:rate=25:duration={length},drawbox=x='mod(t*20\\,140)':y=30:w=20:h=30:c=white:t=fill[v{i}]"
             for i, (colour, length) in enumerate(zip(colours, seconds))]
    joined = "".join(f"[v{i}]" for i in range(len(takes))) + f"concat=n={len(takes)}"
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-filter_complex", ";".join([*takes, joined]), "-c:v", "mpeg4",
                    "-g", "25", str(path)], check=True)


def is_inside(polygon, place):
    """Of a convex polygon, counter-clockwise with y down."""
    following = polygon[1:] + polygon[:1]
    return all((b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0]) >= 0 for a, b in zip(polygon, following))


class Watch(WatchedFolder):
    analyzer = ANALYZER

    def test_the_catalogue_follows_everything_that_happens_in_the_folder(self):
        (self.root / "first.png").write_bytes(png(64))
        watcher = self.start()
        record = self.until_ready("first.png", 64)["first.png"]
        self.assertEqual(record["bytes"], (self.root / "first.png").stat().st_size)
        self.assertEqual(record["mtime_ns"], (self.root / "first.png").stat().st_mtime_ns)
        self.assertGreaterEqual(len(record["shots"][0]["region"]["polygon"]), 3)

        (self.root / "summer").mkdir()
        (self.root / "summer" / "second.png").write_bytes(png(80))
        self.until_ready("summer/second.png", 80)

        (self.root / "first.png").write_bytes(png(100))  # in place, as a file server does
        self.until_ready("first.png", 100)
        (self.root / "new.tmp").write_bytes(png(110))  # beside, as a browser does
        os.rename(self.root / "new.tmp", self.root / "first.png")
        self.until_ready("first.png", 110)

        os.rename(self.root / "first.png", self.root / "renamed.png")
        self.until("the rename", lambda records: set(records) == {"renamed.png", "summer/second.png"})
        os.rename(self.root / "summer", self.root / "winter")
        self.until("the folder's new name", lambda records: set(records) == {"renamed.png", "winter/second.png"})

        (self.root / "renamed.png").unlink()
        self.until("the deletion", lambda records: set(records) == {"winter/second.png"})
        shutil.rmtree(self.root / "winter")
        self.until("the folder's deletion", lambda records: not records)

        watcher.terminate()
        self.assertEqual(watcher.wait(PATIENCE), 0)

    def test_a_photo_is_ready_with_a_plain_region_and_later_has_that_of_the_network(self):
        self.saliency = "network"
        self.start()
        (self.root / "square.png").write_bytes(png(320, 240, 250, 60))
        plain = self.until_ready("square.png", 320)["square.png"]["shots"][0]
        self.assertNotIn("certainty", plain)
        refined = self.until("the network's region", lambda records: "certainty" in records["square.png"]["shots"][0])
        shot = refined["square.png"]["shots"][0]
        self.assertGreater(shot["certainty"], 0.5)
        self.assertNotEqual(shot["region"], plain["region"])
        for corner in ((148, 108), (172, 108), (172, 132), (148, 132)):
            self.assertTrue(is_inside(shot["region"]["polygon"], corner), (corner, shot))

    def test_the_network_is_not_asked_for_the_papers_regions(self):
        (self.root / "square.png").write_bytes(png(320, 240, 250, 60))
        self.saliency = "network"
        done = subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings(), "--analyzer.region", "hull"], check=True,
                              timeout=PATIENCE, capture_output=True, text=True)
        self.assertEqual(self.records()["square.png"]["state"], "ready")
        self.assertNotIn("plain region", done.stdout + done.stderr)

    def test_a_copy_under_way_is_never_ready_before_its_end(self):
        self.start()
        whole = png(200, 150)
        with open(self.root / "copy.png", "wb") as copy:
            for part in range(4):
                copy.write(whole[len(whole) * part // 4:len(whole) * (part + 1) // 4])
                copy.flush()
                os.fsync(copy.fileno())
                records = self.records()
                if "copy.png" in records and part < 3:
                    self.assertNotEqual(records["copy.png"]["state"], "ready")
        self.until_ready("copy.png", 200)

        half = whole[:len(whole) // 2]
        (self.root / "half.png").write_bytes(half)
        records = self.until("half a picture has a reason", lambda records: "half.png" in records)
        self.assertIn(records["half.png"]["state"], ("waiting", "failed"))
        self.assertTrue(records["half.png"]["reason"])
        with open(self.root / "half.png", "ab") as copy:
            copy.write(whole[len(half):])
        self.until_ready("half.png", 200)

    def test_what_is_no_medium_has_a_reason_and_hurts_no_other(self):
        (self.root / "noise.jpg").write_bytes(bytes((i * 7919) % 251 for i in range(100_000)))
        (self.root / "empty.jpg").write_bytes(b"")
        (self.root / "letter.txt").write_text("no picture")
        (self.root / "good.png").write_bytes(png(64))
        os.mkfifo(self.root / "pipe.jpg")
        (self.root / ".DS_Store").write_bytes(b"x")
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings()], check=True, timeout=PATIENCE)
        records = self.records()
        self.assertEqual(set(records), {"noise.jpg", "empty.jpg", "letter.txt", "good.png"})
        self.assertEqual(records["good.png"]["state"], "ready")
        for name in ("noise.jpg", "empty.jpg", "letter.txt"):
            self.assertNotEqual(records[name]["state"], "ready")
            self.assertTrue(records[name]["reason"], name)

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not here")
    def test_the_first_shot_of_a_film_is_in_the_catalogue_before_its_analysis_ends(self):
        make_film(self.root / "film.mp4", ["red", "blue", "green"], seconds=[2, 2, 40])
        watcher = self.start()
        records = self.until("a part of the film", lambda records: "film.mp4" in records)
        part = records["film.mp4"]
        self.assertEqual((part["state"], part["complete"]), ("ready", False))
        self.assertLess(part["shots"][-1]["end_ns"], 10 * 10**9)
        whole = self.until("all of the film", lambda records: records["film.mp4"]["complete"])["film.mp4"]
        self.assertEqual(len(whole["shots"]), 3)
        for shot, before in zip(whole["shots"], part["shots"]):  # where it is stored becomes known later
            self.assertEqual({**shot, "stored": None}, {**before, "stored": None})
            self.assertTrue((self.state / "store" / shot["stored"]["file"]).is_file())
        watcher.terminate()
        self.assertEqual(watcher.wait(PATIENCE), 0)

    def test_once_fails_where_a_record_cannot_be_written_and_where_it_is_stopped(self):
        (self.root / "a.png").write_bytes(png(64))
        once = [ANALYZER, "watch", "--once", "--without-tapestries", *self.settings()]
        self.assertEqual(subprocess.run(once, timeout=PATIENCE).returncode, 0)
        (record,) = (self.state / "catalogue").glob("*.json")
        record.unlink()
        (record / "in the way").mkdir(parents=True)  # as good as a full disk
        self.assertEqual(subprocess.run(once, timeout=PATIENCE).returncode, 1)

        shutil.rmtree(record)
        stopped = subprocess.Popen([*once[:-1], "100000"], stderr=subprocess.PIPE)  # waits for quiet
        os.utime(self.root / "a.png")
        self.assertIn(b"watching", stopped.stderr.readline())
        stopped.terminate()
        self.assertEqual(stopped.wait(PATIENCE), 1)
        stopped.stderr.close()

    def test_a_file_of_hints_is_told_to_the_player_without_a_new_analysis(self):
        (self.root / "summer").mkdir()
        (self.root / "summer" / "a.png").write_bytes(png(64))
        watcher = self.start()
        self.until_ready("summer/a.png", 64)
        times = [file.stat().st_mtime_ns for file in (self.state / "catalogue").glob("*.json")]

        def folders():
            return json.loads((self.state / "hints.json").read_text())["folders"]

        self.until("hints of none", lambda _: (self.state / "hints.json").exists() and folders() == [])
        hints = self.root / "summer" / ".vitrine.toml"
        hints.write_text('hours = "08-18"\nseconds = 20\nrepeat = "often"\n')
        self.until("hints", lambda _: folders() == [{"folder": "summer", "hours": "08:00-18:00", "seconds": 20}])
        hints.unlink()
        self.until("no hints", lambda _: folders() == [])
        self.assertEqual(times, [file.stat().st_mtime_ns for file in (self.state / "catalogue").glob("*.json")])
        watcher.terminate()
        self.assertEqual(watcher.wait(PATIENCE), 0)

    def test_words_of_the_wall_follow_the_settings_that_are_read_again(self):
        config = Path(self.folder.name) / "vitrine.toml"
        config.write_text('[show]\ncaptions = "none"\n')
        (self.root / "a.png").write_bytes(png(64))
        watcher = self.start("--config", config)
        self.until_ready("a.png", 64)
        words = self.state / "words"
        self.assertEqual(list(words.glob("*.png")), [])
        config.write_text('[show]\ncaptions = "names"\nqr = "https://example.org"\n')
        watcher.send_signal(signal.SIGHUP)
        self.until("three forms of a caption, and a code", lambda _: len(list(words.glob("*.png"))) == 4)
        config.write_text('[show]\ncaptions = "many"\n')
        watcher.send_signal(signal.SIGHUP)
        config.write_text('[show]\ncaptions = "none"\nqr = "https://example.org"\n')
        watcher.send_signal(signal.SIGHUP)
        self.until("a code alone", lambda _: len(list(words.glob("*.png"))) == 1)
        watcher.terminate()
        self.assertEqual(watcher.wait(PATIENCE), 0)

    def test_the_share_says_of_each_file_where_it_stands(self):
        (self.root / "summer").mkdir()
        (self.root / "summer" / "<b>a.png").write_bytes(png(64))
        (self.root / "letter.txt").write_text("no picture")
        watcher = self.start()
        status = self.root / "_STATUS"

        def lines(name="status.txt"):
            try:
                return (status / name).read_text().split("\n")
            except FileNotFoundError:
                return []

        self.until("both lines", lambda _: "summer/<b>a.png: ready" in lines()
                   and any(line.startswith("letter.txt: unsupported because ") for line in lines()))
        self.until("its thumbnail", lambda _: len(list((status / "thumbnails").glob("*.jpg"))) == 1)
        (thumbnail,) = (status / "thumbnails").glob("*.jpg")
        self.until("it on the page", lambda _: thumbnail.name in "".join(lines("index.html")))
        self.assertTrue(thumbnail.read_bytes().startswith(b"\xff\xd8\xff"))
        page = (status / "index.html").read_text()
        self.assertIn(f'src="thumbnails/{thumbnail.name}"', page)
        self.assertIn("&lt;b&gt;a.png", page)
        self.assertNotIn("<script", page)
        said = json.loads((self.state / "status.json").read_text())
        self.assertEqual([(file["path"], file["state"]) for file in said["files"]],
                         [("letter.txt", "unsupported"), ("summer/<b>a.png", "ready")])

        (self.root / "summer" / ".vitrine.toml").write_text('hours = "08-18"\nrepeat = "often"\n')
        self.until("the hint", lambda _: "summer/<b>a.png: ready, from 08:00 to 18:00" in lines())
        self.assertTrue(any(line.startswith("summer/.vitrine.toml:2: the value of 'repeat' is not allowed") for line in lines()))
        os.rename(self.root / "summer" / "<b>a.png", self.root / "b.png")
        (self.root / "letter.txt").unlink()
        self.until("the new name", lambda _: lines()[-2:-1] == ["b.png: ready"] and lines()[0] == "1 file: 1 ready")
        self.until("its thumbnail", lambda _: len(list((status / "thumbnails").glob("*.jpg"))) == 1
                   and list((status / "thumbnails").glob("*.jpg")) != [thumbnail])
        (self.state / "wall.jpg").write_bytes(b"the player's")
        (self.root / "b.png").unlink()
        self.until("the wall", lambda _: (status / "wall.jpg").exists() and "wall.jpg" in "".join(lines("index.html")))
        self.assertEqual(self.records(), {}, "what is in the status folder is never looked at")
        watcher.terminate()
        self.assertEqual(watcher.wait(PATIENCE), 0)

    def test_thumbnails_of_files_that_were_looked_at_before_there_was_a_status_folder_are_made(self):
        (self.root / "a.png").write_bytes(png(64))
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings(), "--status.folder", ""], check=True, timeout=PATIENCE)
        self.assertFalse((self.state / "thumbnails").exists())
        watcher = self.start("--analyzer.rescan_seconds", "1")
        self.until("its thumbnail", lambda _: len(list((self.root / "_STATUS" / "thumbnails").glob("*.jpg"))) == 1)
        watcher.terminate()
        self.assertEqual(watcher.wait(PATIENCE), 0)

    def test_a_share_that_cannot_be_written_has_no_status_and_everything_else(self):
        (self.root / "a.png").write_bytes(png(64))
        (self.root / "_STATUS").write_text("in the way")  # as good as a read-only share, for root too
        once = subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings()], check=True, timeout=PATIENCE, capture_output=True)
        self.assertEqual(once.stderr.count(b"the status folder in the media folder is missing"), 1)
        self.assertEqual(self.records()["a.png"]["state"], "ready")
        self.assertEqual(json.loads((self.state / "status.json").read_text())["files"][0]["state"], "ready")

    def test_an_empty_folder_is_no_reason_to_forget_what_was_in_it(self):
        (self.root / "a.png").write_bytes(png(64))
        once = [ANALYZER, "watch", "--once", "--without-tapestries", *self.settings()]
        self.assertEqual(subprocess.run(once, timeout=PATIENCE).returncode, 0)
        os.rename(self.root / "a.png", Path(self.folder.name) / "a.png")  # the share is not mounted
        self.assertEqual(subprocess.run(once, timeout=PATIENCE).returncode, 1)
        self.assertEqual(set(self.records()), {"a.png"})

    def test_a_second_start_changes_nothing(self):
        for i in range(3):
            (self.root / f"{i}.png").write_bytes(png(64 + i))
        for _ in range(2):
            subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings()], check=True, timeout=PATIENCE)
            times = {file.name: file.stat().st_mtime_ns for file in (self.state / "catalogue").glob("*.json")}
            self.assertEqual(len(times), 3)
            before = getattr(self, "times", times)
            self.assertEqual(times, before)
            self.times = times

    def test_films_of_any_shape_are_ready(self):
        for size in ("1920x150", "64x2160", "4096x16", "16x16", "2x2"):
            with self.subTest(size):
                film = self.root / f"{size}.avi"
                subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-f", "lavfi", "-i", f"testsrc2=size={size}:rate=10:duration=0.5",
                                "-pix_fmt", "yuvj420p", "-c:v", "mjpeg", str(film)], check=True)
                done = subprocess.run([ANALYZER, *self.settings(), "analyze", str(film)], capture_output=True, text=True, check=True)
                record = json.loads(done.stdout)
                self.assertEqual((record["state"], f"{record['width']}x{record['height']}"), ("ready", size), record["reason"])

    def test_one_record_of_a_file_inside_or_outside_of_the_folder(self):
        (self.root / "in.png").write_bytes(png(64))
        outside = Path(self.folder.name) / "out.png"
        outside.write_bytes(png(64))
        for file, path in ((self.root / "in.png", "in.png"), (outside, str(outside))):
            done = subprocess.run([ANALYZER, "analyze", str(file), *self.settings()], check=True, timeout=PATIENCE,
                                  capture_output=True)
            self.assertEqual(done.stdout.count(b"\n"), 1)
            self.assertEqual(json.loads(done.stdout)["path"], path)
        missing = subprocess.run([ANALYZER, "analyze", self.root / "none.png"], capture_output=True, timeout=PATIENCE)
        self.assertEqual(missing.returncode, 1)
        self.assertIn(b"none.png", missing.stderr)

    def test_a_transparent_photo_is_looked_at_over_the_background_of_the_show(self):
        def polygon(name, *options):
            done = subprocess.run([ANALYZER, "analyze", str(self.root / name), *self.settings(), *options], check=True,
                                  timeout=PATIENCE, capture_output=True)
            return json.loads(done.stdout)["shots"][0]["region"]["polygon"]

        (self.root / "cut_out.png").write_bytes(png(96, 72, 200, alpha=0))
        (self.root / "on_white.png").write_bytes(png(96, 72, 200, ground=255))
        (self.root / "on_light.png").write_bytes(png(96, 72, 200, ground=200))
        white = polygon("cut_out.png", "--show.background", "#ffffff")
        light = polygon("cut_out.png", "--show.background", "#c8c8c8")
        self.assertEqual(white, polygon("on_white.png"))
        self.assertEqual(light, polygon("on_light.png"))
        self.assertNotEqual(white, light)

    @unittest.skipUnless(HOSTILE.is_dir(), "the hostile media are not here")
    def test_hostile_files_end_in_a_record_each(self):
        files = sorted(file for file in HOSTILE.rglob("*") if file.is_symlink() or file.is_file())
        if OPTIONS.files is not None:
            print("seed", OPTIONS.seed)
            files = random.Random(OPTIONS.seed).sample(files, OPTIONS.files)
        for file in files:
            copy = self.root / "hostile" / file.relative_to(HOSTILE)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(file, copy, follow_symlinks=False)
        (self.root / "good.png").write_bytes(png(64))
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings(), "--analyzer.deadline_seconds", "60"], check=True,
                       timeout=HOSTILE_PATIENCE)
        records = self.records()
        self.assertEqual(records["good.png"]["state"], "ready")
        self.assertGreater(len(records), 10)
        for path, record in records.items():
            if record["state"] == "ready":
                self.assertTrue(record["shots"] and record["width"] > 0 and record["height"] > 0, path)
            else:
                self.assertTrue(record["reason"], path)
                self.assertFalse(record["shots"], path)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *REST])
