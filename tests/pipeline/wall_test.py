#!/usr/bin/env python3
"""The two programs together, as a stranger uses them: a folder in, a wall out.

    wall_test.py BUILD_DIRECTORY [unittest arguments]

Draws its own photos and films. Pictures that come out are read back through ffmpeg.
"""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import seen_pictures  # noqa: E402
from drawn_media import png  # noqa: E402
from seen_pictures import share_near  # noqa: E402

BUILD = Path(sys.argv[1]).resolve()
ANALYZER = BUILD / "analyzer" / "vitrine-analyzer"
PLAYER = BUILD / "player" / "vitrine-player"
WIDTH, HEIGHT, RATE = 640, 360, 10
PATIENCE = 120  # seconds until something that must come is given up
COLOURS = {"red": (230, 30, 30), "green": (30, 200, 30), "blue": (40, 60, 240), "yellow": (240, 220, 30)}


def disc_photo(path, colour, width=240, height=180):
    """A disc of one colour on grey: what must be seen is known."""
    cx, cy, r = width * 0.5, height * 0.45, height * 0.22
    png(path, width, height, lambda x, y: colour if (x - cx) ** 2 + (y - cy) ** 2 < r * r else (128, 128, 128))


def disc_film(path, seconds=2):
    """A white disc that moves to the right over dark blue, H.264."""
    width, height, rate = 320, 180, 25
    frames = bytearray()
    for f in range(seconds * rate):
        cx = 60 + f * 2
        for y in range(height):
            row = bytearray((20, 20, 90) * width)
            inside = 35 ** 2 - (y - 90) ** 2
            if inside > 0:
                half = int(inside ** 0.5)
                left, right = max(0, cx - half), min(width, cx + half)
                row[left * 3:right * 3] = bytes((250, 250, 250)) * (right - left)
            frames += row
    subprocess.run(["ffmpeg", "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}",
                    "-r", str(rate), "-i", "-", "-pix_fmt", "yuv420p", "-c:v", "libx264", str(path)],
                   input=bytes(frames), check=True)


def pictures_of(path, width=WIDTH, height=HEIGHT):
    return seen_pictures.pictures_of(path, width, height)


def cross(a, b, p):
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def are_apart(a, b):
    """Whether an edge of one of two convex polygons separates them."""
    for polygon, other in ((a, b), (b, a)):
        for i, p in enumerate(polygon):
            q = polygon[(i + 1) % len(polygon)]
            if all(cross(p, q, r) <= 1e-6 for r in other):
                return True
    return False


def area(polygon):
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(polygon, polygon[1:] + polygon[:1])) / 2


def centroid_and_height(region):
    """Of a polygon, in its unit."""
    twice = mx = my = 0
    for (ax, ay), (bx, by) in zip(region, region[1:] + region[:1]):
        c = ax * by - ay * bx
        twice, mx, my = twice + c, mx + (ax + bx) * c, my + (ay + by) * c
    ys = [y for _, y in region]
    return (mx / (3 * twice), my / (3 * twice)), max(ys) - min(ys)


class Wall(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="vitrine-wall-")
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name) / "media"
        self.state = Path(self.folder.name) / "state"
        self.root.mkdir()

    def settings(self):
        return ["--media.root", str(self.root), "--state.directory", str(self.state), "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "200",
                "--tapestry.max_bytes", "0"]

    def analyse(self):
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *self.settings()], check=True, timeout=PATIENCE)

    def play(self, *options, screen=f"{WIDTH}x{HEIGHT}"):
        film, snapshot = self.state / "wall.mp4", self.state / "wall.png"
        done = subprocess.run([PLAYER, *self.settings(), "--screen", f"offscreen:{screen}",
                               "--output.frame_rate", str(RATE), "--film", film, "--snapshot", snapshot, *options],
                              timeout=PATIENCE, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return pictures_of(film), pictures_of(snapshot)[0]

    def plan(self, *options):
        out = Path(self.folder.name) / "plan.json"
        subprocess.run([PLAYER, "plan", "--catalogue", self.state / "catalogue", "--size", "1280x720", "--json", out, *options],
                       check=True, timeout=PATIENCE)
        return json.loads(out.read_text())

    def test_photos_and_a_film_play_on_one_canvas(self):
        for name, colour in COLOURS.items():
            disc_photo(self.root / f"{name}.png", colour)
        disc_film(self.root / "moving.mp4")
        self.analyse()

        pictures, snapshot = self.play("--duration", "3s")

        self.assertEqual(len(pictures), 3 * RATE)
        for name, colour in COLOURS.items():
            self.assertGreater(share_near(snapshot, colour), 0.01, f"the {name} disc is on the wall")
        self.assertGreater(share_near(snapshot, (250, 250, 250)), 0.005, "the film's disc is on the wall")
        late = pictures[2 * RATE:]
        self.assertTrue(any(a != b for a, b in zip(late, late[1:])), "the film moves")
        for picture in pictures:
            self.assertLess(share_near(picture, (0, 0, 0), 12), 0.02, "no frame has a black hole")

    def test_several_screens_show_the_wall_or_their_own_folder(self):
        (self.root / "lobby").mkdir()
        disc_photo(self.root / "lobby" / "red.png", COLOURS["red"])
        disc_photo(self.root / "green.png", COLOURS["green"])
        self.analyse()

        pictures, first = self.play("--duration", "2s", "--output.folders", "offscreen-3=lobby", "--output.margins", "0,0,10%,0",
                                    screen=f"{WIDTH}x{HEIGHT}+320x320+320x180")

        self.assertEqual(len(pictures), 2 * RATE)
        second = pictures_of(self.state / "wall-2.png", 320, 320)[0]
        own = pictures_of(self.state / "wall-3.png", 320, 180)[0]
        self.assertEqual(len(pictures_of(self.state / "wall-3.mp4", 320, 180)), 2 * RATE)
        for picture in (first, second):
            for name in ("red", "green"):
                self.assertGreater(share_near(picture, COLOURS[name]), 0.005, f"the {name} disc is on the wall")
        self.assertGreater(share_near(own, COLOURS["red"]), 0.02, "what is in the folder is on its screen")
        self.assertLess(share_near(own, COLOURS["green"]), 0.001, "and nothing else")
        for picture, width, height in ((first, WIDTH, HEIGHT), (own, 320, 180)):
            edge = b"".join(picture[(y * width + width * 9 // 10) * 3:(y + 1) * width * 3] for y in range(height))
            self.assertEqual(set(edge), {0}, "the margin is black")
        self.assertEqual(set(second[:320 * 3 * 60]), {0}, "a black bar above what is as wide as the screen")

    def test_if_each_screen_has_its_own_folder_the_first_is_touched_and_drawn_for_the_status_page(self):
        for folder, names in (("hall", ["blue"]), ("lobby", ["red", "green"])):
            (self.root / folder).mkdir()
            for name in names:
                disc_photo(self.root / folder / f"{name}.png", COLOURS[name])
        self.analyse()
        each = ("--output.folders", "offscreen-1=lobby, offscreen-2=hall")
        screens = f"{WIDTH}x{HEIGHT}+320x180"

        self.play("--duration", "5s", *each, screen=screens)

        page = seen_pictures.pictures_of(self.state / "wall.jpg", 960, 540)[0]
        self.assertGreater(share_near(page, COLOURS["red"]), 0.01, "the wall of the first screen")
        self.assertLess(share_near(page, COLOURS["blue"]), 0.001)

        script = Path(self.folder.name) / "touches.txt"
        script.write_text("2 tap 320 180\n")
        pictures, last = self.play("--duration", "4s", "--rehearse", script, *each, screen=screens)
        before = [share_near(pictures[15], COLOURS[name]) for name in ("red", "green")]
        after = [share_near(last, COLOURS[name]) for name in ("red", "green")]
        self.assertTrue(any(a > 1.5 * b for a, b in zip(after, before)), "the photo that was tapped is large")

    def test_a_plan_covers_the_canvas_and_cuts_no_region(self):
        for i, (name, colour) in enumerate(COLOURS.items()):
            disc_photo(self.root / f"{name}.png", colour, 200 + 40 * i, 180)
        self.analyse()

        plan = self.plan("--slots", "4", "--seed", "3")

        self.assertEqual(plan["size"], [1280, 720])
        self.assertEqual(len(plan["items"]), 4)
        self.assertGreater(plan["region_visible"], 0.9999)
        regions = [item["region"] for item in plan["items"]]
        for i, region in enumerate(regions):
            self.assertGreater(area(region), 0)
            for x, y in region:
                self.assertTrue(-0.01 <= x <= 1280.01 and -0.01 <= y <= 720.01)
            for other in regions[:i]:
                self.assertTrue(are_apart(region, other), "two regions overlap")
        self.assertEqual(plan, self.plan("--slots", "4", "--seed", "3"), "the same seed gives the same plan")

    def test_a_plan_in_reading_order_has_no_inversions(self):
        for i, (name, colour) in enumerate(COLOURS.items()):
            disc_photo(self.root / f"{name}.png", colour, 180 + 60 * i, 240 - 20 * i)
        self.analyse()

        plan = self.plan("--layout.order", "reading", "--show.order", "name")

        paths = [item["path"] for item in plan["items"]]
        self.assertEqual(paths, sorted(paths))
        middles, heights = [], []
        for item in plan["items"]:
            (x, y), height = centroid_and_height(item["region"])
            middles.append((x, y))
            heights.append(height)
        half_line = sum(heights) / len(heights) / 2
        for i, (x, y) in enumerate(middles):
            for x_later, y_later in middles[i + 1:]:
                below = y_later - y
                self.assertTrue(below >= half_line or (abs(below) < half_line and x <= x_later), plan["items"])

    def test_an_empty_folder_shows_the_idle_picture(self):
        self.analyse()
        pictures, snapshot = self.play("--duration", "1s")
        self.assertEqual(len(pictures), RATE)
        self.assertLess(share_near(snapshot, (0, 0, 0), 12), 0.2, "the idle picture is not black")

    def test_the_wall_follows_the_folder_while_it_plays(self):
        disc_photo(self.root / "red.png", COLOURS["red"])
        self.analyse()
        log = open(Path(self.folder.name) / "player.log", "w+")
        self.addCleanup(log.close)
        film = self.state / "wall.mp4"
        watcher = subprocess.Popen([ANALYZER, "watch", *self.settings()])
        self.addCleanup(watcher.wait)
        self.addCleanup(watcher.terminate)
        player = subprocess.Popen([PLAYER, *self.settings(), "--screen", f"offscreen:{WIDTH}x{HEIGHT}", "--pace", "realtime",
                                   "--output.frame_rate", str(RATE), "--film", film], stderr=log)

        def wait_for(text):
            end = time.monotonic() + PATIENCE
            while time.monotonic() < end:
                if text in Path(log.name).read_text():
                    return
                self.assertIsNone(player.poll(), Path(log.name).read_text())
                time.sleep(0.1)
            self.fail(f"'{text}' never came:\n{Path(log.name).read_text()}")

        try:
            wait_for("wall of 1 item")
            disc_photo(self.root / "new.tmp", COLOURS["green"])
            os.rename(self.root / "new.tmp", self.root / "green.png")
            arrived = time.monotonic()
            wait_for("wall of 2 items")
            needed = time.monotonic() - arrived  # by a machine as busy as this one
            disc_photo(self.root / "green.png", COLOURS["blue"])
            wait_for("replaced: 'green.png'")
            (self.root / "red.png").unlink()
            wait_for("gone: 'red.png'")
            time.sleep(3 + needed)  # let the crossfade end: what is wanted of the film are its last pictures
        finally:
            player.send_signal(signal.SIGTERM)
        self.assertEqual(player.wait(PATIENCE), 0, Path(log.name).read_text())
        last = pictures_of(film)[-1]
        self.assertGreater(share_near(last, COLOURS["blue"]), 0.01)
        self.assertLess(share_near(last, COLOURS["red"]), 0.001)
        self.assertLess(share_near(last, COLOURS["green"]), 0.001)

    def test_a_wrong_setting_stops_both_programs_with_file_line_and_what_is_allowed(self):
        config = Path(self.folder.name) / "wall.toml"
        config.write_text("[layout]\nslots = 0\n")
        for program in ([ANALYZER, "watch", "--once", "--without-tapestries"], [PLAYER]):
            done = subprocess.run([*program, "--config", config], capture_output=True, text=True, timeout=PATIENCE)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(f"{config}:2: the value of 'layout.slots' is not allowed", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[2:]])
