#!/usr/bin/env python3
"""What the whole player shows over time: walls that pan, folders that stand together, shots that change.

    show_test.py BUILD_DIRECTORY [unittest arguments]

Draws its own photos and films and writes their records itself, so that every pixel expected is known. Nothing depends on
how fast the machine is: off screen the player's clock waits for every picture.
"""
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import seen_pictures  # noqa: E402
from drawn_media import png  # noqa: E402
from seen_pictures import share_near  # noqa: E402

BUILD = Path(sys.argv[1]).resolve()
ANALYZER, PLAYER = BUILD / "analyzer" / "vitrine-analyzer", BUILD / "player" / "vitrine-player"
WIDTH, HEIGHT, RATE = 320, 180, 10
PATIENCE = 300  # seconds until something that must end is given up
COLOURS = [(230, 30, 30), (30, 200, 30), (40, 60, 240), (240, 220, 30), (30, 210, 210), (220, 40, 220), (240, 130, 20), (130, 70, 20)]


def disc(path, colour, width=120, height=90, number=0):
    """A disc before grey fields, which are others for each number: equal pictures would be one."""
    cx, cy, r = width * 0.5, height * 0.5, height * 0.3
    chance = random.Random(number)
    fields = [128 if number == 0 else 128 + chance.randrange(-24, 25) for _ in range(64)]

    def shade(x, y):
        return (fields[8 * (8 * y // height) + 8 * x // width],) * 3

    png(path, width, height, lambda x, y: colour if (x - cx) ** 2 + (y - cy) ** 2 < r * r else shade(x, y))


def counting_film(path, channel, pictures):
    """One colour a picture, whose level in one channel counts the pictures: 40, 45, 50, ..."""
    frames = bytearray()
    for f in range(pictures):
        colour = [0, 0, 0]
        colour[channel] = 40 + 5 * f
        frames += bytes(colour) * (64 * 48)
    subprocess.run(["ffmpeg", "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", "64x48", "-r", str(RATE),
                    "-i", "-", "-c:v", "ffv1", "-pix_fmt", "bgr0", str(path)], input=bytes(frames), check=True)


def middle_of(picture, colour, tolerance=70):
    return seen_pictures.middle_of(picture, WIDTH, colour, tolerance)


class Show(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="vitrine-show-")
        self.addCleanup(self.folder.cleanup)
        self.root, self.state = Path(self.folder.name) / "media", Path(self.folder.name) / "state"
        self.root.mkdir()

    def settings(self):
        return ["--media.root", str(self.root), "--state.directory", str(self.state), "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "100"]

    def analyse(self, *options):
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings(), *options],
                       check=True, timeout=PATIENCE, capture_output=True)

    def play(self, *options):
        film = Path(self.folder.name) / "wall.mp4"
        done = subprocess.run([PLAYER, *self.settings(), "--screen", f"offscreen:{WIDTH}x{HEIGHT}", "--output.frame_rate", str(RATE),
                               "--film", film, *options], timeout=PATIENCE, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return seen_pictures.pictures_of(film, WIDTH, HEIGHT)

    def plan(self, *options):
        out = Path(self.folder.name) / "plan.json"
        subprocess.run([PLAYER, "plan", "--catalogue", self.state / "catalogue", "--size", "1280x720", "--json", out, *options],
                       check=True, timeout=PATIENCE)
        return json.loads(out.read_text())

    def test_a_wall_that_pans_moves_left_at_its_speed_and_what_is_new_comes_in_from_the_right(self):
        for i, colour in enumerate(COLOURS):
            disc(self.root / f"{i}.png", colour)
        self.analyse()

        pictures = self.play("--duration", "12s", "--layout.mode", "pan", "--slots", "3", "--show.pan_pixels_per_second", "40",
                             "--show.order", "name")

        self.assertEqual(len(pictures), 12 * RATE)
        steps, entries = [], []
        tracks = [[middle_of(picture, colour) for picture in pictures] for colour in COLOURS]
        begin = min(k for track in tracks for k, (_, _, count) in enumerate(track) if count > 10)
        for track in tracks:
            whole = max(count for _, _, count in track)
            for before, after in zip(track, track[1:]):
                if min(before[2], after[2]) > 0.95 * whole and 40 < before[0] < WIDTH - 40:
                    steps.append((before[0] - after[0], before[1] - after[1]))
            seen = [k for k, (_, _, count) in enumerate(track) if count > 10]
            for k in seen:
                is_new = not set(seen) & set(range(k - RATE // 2, k))  # it may have been there before
                if is_new and k > begin + RATE:  # the first ones have faded in
                    entries.append(track[k][0])
        self.assertGreater(len(steps), 100)
        along, across = ([step[axis] for step in steps] for axis in (0, 1))
        self.assertAlmostEqual(sorted(along)[len(along) // 2], 40 / RATE, delta=0.2)
        self.assertGreater(sum(abs(y) < 1 for y in across), 0.95 * len(across), "nothing moves up or down")
        self.assertGreaterEqual(len(entries), 2, "shots that were not there come")
        for x in entries:
            self.assertGreater(x, WIDTH - 40, "what is new comes in at the right edge")

    def test_files_of_a_folder_stand_together(self):
        for i in range(8):
            folder = self.root / ("left" if i % 2 else "right")
            folder.mkdir(exist_ok=True)
            disc(folder / f"{i}.png", COLOURS[0] if i % 2 else COLOURS[2], number=i)
        self.analyse()

        plan = self.plan("--layout.folders", "nested", "--slots", "8")
        self.assertEqual(len(plan["items"]), 8)
        boxes = {}
        for item in plan["items"]:
            boxes.setdefault(item["path"].split("/")[0], []).extend(item["region"])
        red, blue = ([f(p[axis] for p in boxes[name]) for axis in (0, 1) for f in (min, max)] for name in ("left", "right"))
        apart = red[1] <= blue[0] or blue[1] <= red[0] or red[3] <= blue[2] or blue[3] <= red[2]
        self.assertTrue(apart, f"the two folders' regions lie in two boxes apart: {red} {blue}")

        last = self.play("--duration", "3s", "--layout.folders", "nested", "--slots", "8")[-1]
        red, blue = middle_of(last, COLOURS[0]), middle_of(last, COLOURS[2])
        self.assertGreater(min(red[2], blue[2]), 100)
        self.assertGreater(max(abs(red[0] - blue[0]) / WIDTH, abs(red[1] - blue[1]) / HEIGHT), 0.3, "they stand apart on the wall")

    def test_a_folder_opens_by_a_touch_and_closes_into_its_place(self):
        for i in range(6):
            folder = self.root / ("left" if i % 2 else "right")
            folder.mkdir(exist_ok=True)
            disc(folder / f"{i}.png", COLOURS[0] if i % 2 else COLOURS[2], 320, 240, number=i)
        self.analyse()
        before = self.play("--duration", "3s", "--layout.folders", "nested")[-1]
        red = [at for at in range(WIDTH * HEIGHT) if all(abs(before[3 * at + c] - COLOURS[0][c]) < 40 for c in range(3))]
        y, x = divmod(red[len(red) // 2], WIDTH)
        script = Path(self.folder.name) / "script.txt"
        script.write_text(f"3 tap {x} {y}\n7 key back\n")

        pictures = self.play("--duration", "11s", "--layout.folders", "nested", "--rehearse", script)

        opened, after = pictures[6 * RATE], pictures[-1]
        self.assertGreater(middle_of(opened, COLOURS[0])[2], 1.2 * middle_of(before, COLOURS[0])[2])
        self.assertLess(middle_of(opened, COLOURS[2])[2], 0.2 * middle_of(before, COLOURS[2])[2], "only in the small picture")
        self.assertLess(sum(abs(a - b) > 24 for a, b in zip(before, after)), len(before) // 500, "all is where it was")
        for picture in pictures[2 * RATE:]:
            dark = sum(max(picture[at:at + 3]) < 60 for at in range(0, len(picture), 3 * 7))
            self.assertLess(dark, len(picture) // (3 * 7) // 10, "nothing becomes dark on the way")

    def test_a_caption_stands_where_nothing_matters_and_the_status_tells_what_is_wrong(self):
        disc(self.root / "a.png", COLOURS[0])
        (self.root / "a.png.txt").write_text("Lake\n")
        (self.root / "b.png.txt").write_text("nothing beside it")
        disc(self.root / "c.png", COLOURS[1], number=1)
        (self.root / "c.png.txt").write_bytes(b"x" * 1_000_000)
        self.analyse()

        status = (self.root / "_STATUS" / "status.txt").read_text()
        self.assertIn("b.png.txt: there is no such photo or film beside it", status)
        self.assertIn("c.png.txt: it is longer than 500 bytes", status)
        self.assertIn("a.png: ready, with the caption 'Lake'", status)
        self.assertIn("2 files: 2 ready", status)
        (self.root / "c.png").unlink()
        self.analyse()

        def disc_is_bright(raw, _):
            return share_near(raw, COLOURS[0], 24) > 0.01

        def letters_are_white(raw, _):
            return disc_is_bright(raw, _) and any(min(raw[i:i + 3]) > 200 for i in range(0, len(raw), 3))

        at_once = ("--show.motion_milliseconds", "0")  # so that the photo is the same in both
        bare, _ = self.snapshot("none", "--show.captions", "none", *at_once, side=2, is_complete=disc_is_bright)
        written, _ = self.snapshot("written", "--show.captions", "written", *at_once, side=2, is_complete=letters_are_white)
        differ = [i for i in range(0, len(bare), 3) if bare[i:i + 3] != written[i:i + 3]]
        self.assertGreater(len(differ), 100)
        self.assertGreater(max(written[i] for i in differ), 200, "letters are white")
        for i in differ:
            red, green, blue = bare[i:i + 3]
            self.assertFalse(red > 180 and green < 100 and blue < 100, "the disc is covered")

    def snapshot(self, name, *arguments, side=3, is_complete=lambda raw, codes: codes):
        """A picture of the wall as it stands after some seconds, and what the reader of QR codes finds on it.

        is_complete: tells of both if all has come; a busy machine needs longer.
        """
        file = Path(self.folder.name) / f"{name}.png"
        for seconds in (4, 8, 16, 32):
            subprocess.run([PLAYER, *self.settings(), "--screen", f"offscreen:{side * WIDTH}x{side * HEIGHT}", "--pace", "realtime",
                            "--duration", f"{seconds}s", "--show.photo_drift", "false", "--snapshot", file, *arguments],
                           check=True, timeout=PATIENCE, capture_output=True)
            raw = seen_pictures.pictures_of(file, side * WIDTH, side * HEIGHT)[0]
            codes = subprocess.run([BUILD / "tests" / "pipeline" / "read_codes", str(side * WIDTH), str(side * HEIGHT)], input=raw,
                                   capture_output=True, check=True).stdout.decode().splitlines()
            if is_complete(raw, codes):
                break
        return raw, codes

    def test_qr_codes_on_the_wall_can_be_read(self):
        count = int(os.environ.get("VITRINE_CODES", "4"))
        chance = random.Random(21)
        for i, colour in enumerate(COLOURS[:2]):
            disc(self.root / f"{i}.png", colour, 480, 270, number=i)
        read = 0
        for k in range(count):
            text = "https://example.org/" + "".join(chance.choice("abcdefghij0123456789/-") for _ in range(chance.randrange(40)))
            for old in self.root.glob("*.url.txt"):
                old.unlink()
            (self.root / f"{chance.randrange(2)}.png.url.txt").write_text(text + "\n")
            self.analyse()
            _, codes = self.snapshot(f"code{k}", "--seed", str(k + 1))
            if codes == [text]:
                read += 1
            else:
                print(f"seed {k + 1}: {text} read as {codes}", file=sys.stderr)
        print(f"{read} of {count} QR codes were read", file=sys.stderr)
        self.assertGreaterEqual(read, 0.99 * count)

    def test_the_walls_own_qr_code_stands_on_it_and_on_the_idle_picture_and_faults_are_told(self):
        wish = ("--show.qr", "https://example.org/wall")
        for i, colour in enumerate(COLOURS[:3]):
            disc(self.root / f"{i}.png", colour, 480, 270, number=i)
        (self.root / "0.png.url.txt").write_bytes(b"x" * 1_000_000)
        (self.root / "1.png.url.txt").write_text(" \n")
        (self.root / "2.png.url.txt").write_bytes(b"\xff\xfe")
        (self.root / "gone.png.url.txt").write_text("https://example.org")
        self.analyse(*wish)
        status = (self.root / "_STATUS" / "status.txt").read_text()
        for told in ("0.png.url.txt: it is longer than 250 bytes", "1.png.url.txt: it is empty",
                     "2.png.url.txt: it is not UTF-8", "gone.png.url.txt: there is no such photo or film beside it",
                     "3 files: 3 ready"):
            self.assertIn(told, status)

        def discs_are_bright(raw, _):
            return all(share_near(raw, colour, 24) > 0.01 for colour in COLOURS[:3])

        bare, none = self.snapshot("bare", is_complete=discs_are_bright)
        shown, codes = self.snapshot("wall", *wish)
        self.assertEqual((none, codes), ([], ["https://example.org/wall"]))
        for at in range(0, len(bare), 3):
            if bare[at:at + 3] != shown[at:at + 3]:
                self.assertLess(max(bare[at:at + 3]) - min(bare[at:at + 3]), 60, "a disc is covered")
        shutil.rmtree(self.state / "catalogue")
        plain, codes = self.snapshot("idle", *wish)
        self.assertEqual(codes, ["https://example.org/wall"])

        # An address tells where to drop files: white letters at the lower left of the idle picture.
        address = ("--show.share_address", "\\\\{host}\\media")
        self.analyse(*wish, *address)
        shutil.rmtree(self.state / "catalogue")
        told, codes = self.snapshot("address", *wish, *address)
        self.assertEqual(codes, ["https://example.org/wall"])

        def letters(picture):
            width, height = 3 * WIDTH, 3 * HEIGHT
            return sum(min(picture[(y * width + x) * 3:][:3]) > 200
                       for y in range(height * 7 // 8, height, 2) for x in range(0, width // 2, 2))

        self.assertEqual(letters(plain), 0)
        self.assertGreater(letters(told), 100)

    def test_a_plans_film_shows_how_the_packing_became_denser(self):
        for i, colour in enumerate(COLOURS):
            disc(self.root / f"{i}.png", colour, 120 + 15 * i, 150 - 8 * i)
        self.analyse()
        film = Path(self.folder.name) / "packing.mp4"
        subprocess.run([PLAYER, "plan", "--catalogue", self.state / "catalogue", "--size", f"{WIDTH}x{HEIGHT}", "--slots", "8",
                        "--film", film], check=True, timeout=PATIENCE)
        pictures = seen_pictures.pictures_of(film, WIDTH, HEIGHT)
        self.assertGreater(len(pictures), 25, "some steps and the end held for a while")
        differing = [k for k, (a, b) in enumerate(zip(pictures, pictures[1:]))
                     if sum(abs(x - y) for x, y in zip(a[::97], b[::97])) > 2 * len(a[::97])]
        self.assertGreater(len(differing), 0, "the packing changes")
        self.assertLess(differing[-1], len(pictures) - 20, "the end stands still")

    def test_between_two_shots_lies_one_picture_and_none_is_lost_black_or_shown_twice(self):
        counting_film(self.root / "a.mkv", 0, 40)
        counting_film(self.root / "b.mkv", 1, 40)
        self.write_records(["a.mkv", "b.mkv"], 40)

        pictures = self.play("--duration", "18s", "--slots", "1", "--show.dwell_seconds", "4",
                             "--show.motion_milliseconds", "0", "--show.order", "name")

        at = (HEIGHT // 2 * WIDTH + WIDTH // 2) * 3
        shown = []
        for picture in pictures[2:]:
            level, channel = max((picture[at + c], c) for c in range(2))
            shown.append((channel, (level - 40) / 5))
        changes = 0
        for (channel, number), (next_channel, next_number) in zip(shown, shown[1:]):
            if channel != next_channel:
                changes += 1
                self.assertGreater(number, 37.7, "a shot plays to its last picture")
                self.assertLess(abs(next_number), 0.7, "the next one begins with its first")
            else:
                self.assertLess(abs((next_number - number - 1 + 20) % 40 - 20), 0.8, f"one picture on: {number} {next_number}")
        self.assertGreaterEqual(changes, 3)

    def test_a_file_that_cannot_be_opened_leaves_the_wall_whole(self):
        for i, colour in enumerate(COLOURS[:5]):
            disc(self.root / f"{i}.png", colour)
        self.analyse()
        (self.root / "3.png").write_bytes(b"not a picture any more")
        shutil.rmtree(self.state / "store", ignore_errors=True)

        pictures = self.play("--duration", "15s", "--slots", "3", "--show.dwell_seconds", "2", "--show.order", "name")

        for picture in pictures[2 * RATE:]:
            standing = [colour for colour in COLOURS[:5] if middle_of(picture, colour)[2] > 60]
            self.assertGreaterEqual(len(standing), 2, "a change has at most one shot between two")
        seen = {i for picture in pictures for i, colour in enumerate(COLOURS[:5]) if middle_of(picture, colour)[2] > 60}
        self.assertEqual(seen, {0, 1, 2, 4})

    def test_files_come_and_go_at_the_hours_of_their_folders_and_at_none_the_idle_picture_is_shown(self):
        red, green, blue = COLOURS[0], COLOURS[1], COLOURS[2]
        for folder, colour in (("08-18 day", red), ("06-24 open", green), ("18.00-24.00 night", blue)):
            (self.root / folder).mkdir()
            disc(self.root / folder / "a.png", colour)
        self.analyse()
        script = Path(self.folder.name) / "script.txt"
        script.write_text("0 clock 2026-12-24 17:59:55\n12 clock 2026-12-25 03:00:00\n")

        pictures = self.play("--duration", "18s", "--slots", "3", "--rehearse", script)

        def standing(picture):
            return [colour for colour in (red, green, blue) if middle_of(picture, colour)[2] > 60]

        for picture in pictures[RATE:5 * RATE]:
            self.assertEqual(standing(picture), [red, green])
        for picture in pictures[9 * RATE:12 * RATE]:
            self.assertEqual(standing(picture), [green, blue])
        for picture in pictures[5 * RATE:9 * RATE]:
            self.assertIn(green, standing(picture), "what stays is on the wall all the time")
        grounds = [middle_of(picture, (128, 128, 128), 16)[2] for picture in pictures]
        self.assertGreater(min(grounds[RATE:12 * RATE]), 1000, "pictures fill the wall")
        self.assertLess(max(grounds[15 * RATE:]), 500, "the idle picture, which has many colours and hardly any grey")

    def test_panels_are_dark_outside_their_hours_and_show_the_wall_soon_after(self):
        for number in range(3):
            disc(self.root / f"{number}.png", COLOURS[number], number=number)
        self.analyse()
        script = Path(self.folder.name) / "script.txt"
        script.write_text("0 clock 2026-12-24 17:59:56\n20 clock 2026-12-25 07:59:58\n")  # off at 4 s, on at 22 s

        self.play("--duration", "27s", "--slots", "3", "--output.on", "08:00-18:00", "--rehearse", script)

        told = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "frame=pts_time", "-of", "csv=p=0",
                               Path(self.folder.name) / "wall.mp4"], capture_output=True, check=True, text=True).stdout
        times = [float(line.strip(",")) for line in told.split()]
        evening, morning = [time for time in times if time < 15], [time for time in times if time >= 15]
        self.assertTrue(2 < evening[-1] <= 4 + 5, f"the last picture of the evening at {evening[-1]} s")
        self.assertTrue(22 <= morning[0] <= 22 + 2, f"the first picture of the morning at {morning[0]} s")

    def write_records(self, names, pictures):
        """Films of one shot each, whose I-Region is their middle."""
        length = pictures * 1_000_000_000 // RATE
        catalogue = self.state / "catalogue"
        self.analyse()
        for file in catalogue.glob("*.json"):
            record = json.loads(file.read_text())
            if record.get("path") not in names:
                continue
            self.assertEqual(record["state"], "ready")
            whole = dict(record["shots"][0], begin_ns=0, end_ns=length)
            whole.pop("stored", None)
            record["shots"] = [whole]
            file.write_text(json.dumps(record))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[2:]])
