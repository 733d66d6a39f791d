#!/usr/bin/env python3
"""The page of a tapestry in a real browser, opened as a file: what is drawn, and what the mouse, fingers and keys do.

    browser_test.py BUILD_DIRECTORY [--film FILE] [--pictures DIRECTORY] [unittest arguments]

Draws its own film, unless FILE is given. Needs Chromium (Debian: chromium); ends with 77 where it is not.
--pictures keeps pictures of the window.
"""
import argparse
import base64
import json
import re
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from headless_browser import Browser, chromium

arguments = argparse.ArgumentParser()
arguments.add_argument("build", type=Path)
arguments.add_argument("--film", type=Path)
arguments.add_argument("--pictures", type=Path)
ARGUMENTS, REST = arguments.parse_known_args()
ANALYZER = ARGUMENTS.build.resolve() / "analyzer" / "vitrine-analyzer"
SKIPPED = 77
NAME = "\"It's\" <b>&amp; a film.mp4"
SECONDS = 42  # of the drawn film
STEPS = 24  # between two levels

# The pixels of the strip as it is drawn for a view, an average of `across` x `down` px each: a list of [red, green, blue].
PIXELS = """((view) => {
    const page = vitrine.page;
    if (view) page.show(page.places.bounded(view));
    page.draw();
    const small = document.createElement("canvas");
    [small.width, small.height] = [160, 20];
    const context = small.getContext("2d");
    context.drawImage(page.drawing.canvas, 0, 0, small.width, small.height);
    return Array.from(context.getImageData(0, 0, small.width, small.height).data).filter((_, i) => i % 4 < 3);
})"""

# The same of the tiles themselves, at a whole level, put side by side without the page's drawing.
TILES = """((level) => {
    const page = vitrine.page, places = page.places;
    const wide = document.createElement("canvas");
    [wide.width, wide.height] = [places.width, places.height];
    const context = wide.getContext("2d");
    for (let i = 0; i < places.tiles(level); ++i) {
        const tile = page.tiles.get(level, i);
        if (tile) context.drawImage(tile.image, places.windowX(page.view, 0) + tile.left * places.scale, 0, tile.width * places.scale, places.height);
    }
    const small = document.createElement("canvas");
    [small.width, small.height] = [160, 20];
    small.getContext("2d").drawImage(wide, 0, 0, small.width, small.height);
    return Array.from(small.getContext("2d").getImageData(0, 0, small.width, small.height).data).filter((_, i) => i % 4 < 3);
})"""

# Between levels 0 and 1: how far the strip as it is drawn is from the colours of the finer level's tiles, at their points
# on the way. @param aside  px of the strip: the same beside the points
STRAY = """((share, aside) => {
    const page = vitrine.page, places = page.places, scale = places.scale * page.ratio;
    const centre = places.stripX(page.view.level, page.view.centre);
    const picture = (source, width, height) => {
        const canvas = Object.assign(document.createElement("canvas"), {width, height});
        canvas.getContext("2d").drawImage(source, 0, 0, width, height);
        const data = canvas.getContext("2d").getImageData(0, 0, width, height).data;
        return (x, y) => {
            const at = 4 * (Math.min(height - 1, Math.max(0, Math.floor(y))) * width + Math.floor(x));
            return Array.from(data.slice(at, at + 3));
        };
    };
    page.draw();
    const drawn = picture(page.drawing.canvas, page.drawing.canvas.width, page.drawing.canvas.height);
    let sum = 0, count = 0;
    for (const number of places.tilesInView(page.view, 1)) {
        const tile = page.tiles.get(1, number), mesh = tile.coarser;
        const colour = picture(tile.image, tile.image.naturalWidth, tile.image.naturalHeight);
        for (let i = 0; i < mesh.points.length; i += 7) {
            const [coarseX, coarseY, fineX, fineY, u, v, growth] = mesh.points.slice(i, i + 7);
            const x = (places.width / 2) * page.ratio + scale * ((1 - share) * (mesh.coarseOrigin + coarseX) + share * (mesh.finerOrigin + fineX) + aside - centre);
            if (growth > 0.9 || u === 1 || v === 0 || v === 1 || x < 1 || x >= places.width * page.ratio - 1) continue;
            const [one, other] = [drawn(x, scale * ((1 - share) * coarseY + share * fineY)), colour(u * tile.width, v * tile.image.naturalHeight)];
            sum += one.reduce((all, value, k) => all + Math.abs(value - other[k]), 0) / 3;
            ++count;
        }
    }
    return [sum / count, count];
})"""


def make_film(path):
    """A new texture every second, and a bar that moves."""
    takes = [f"gradients=size=320x180:rate=25:duration=1:seed={i + 1}:n=5:speed=0.02,drawbox=x='mod(t*200\\,280)':y={4 * (i % 40)}:w=30:h=30:"
             f"c={['white', 'black'][i % 2]}:t=fill[v{i}]" for i in range(SECONDS)]
    joined = "".join(f"[v{i}]" for i in range(len(takes))) + f"concat=n={len(takes)}"
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-filter_complex", ";".join([*takes, joined]), "-c:v", "mpeg4", "-q:v", "2", path],
                   check=True)


def distance(one, other):
    return sum(abs(a - b) for a, b in zip(one, other)) / len(one)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.TemporaryDirectory(prefix="vitrine-browser-")
        cls.addClassCleanup(cls.home.cleanup)
        root = Path(cls.home.name)
        film = ARGUMENTS.film
        if film is None:
            film = root / NAME
            make_film(film)
        cls.page = root / "a page"
        subprocess.run([ANALYZER, "weave", film, "--html", cls.page, "--state.directory", root / "state", "--media.root", root / "media"], check=True)
        data = next(cls.page.glob("tapestry-*"))
        cls.index = json.loads(re.fullmatch(r"vitrine\.setTapestry\((.*)\);\n", (data / "tapestry.js").read_text("ascii"))[1])
        cls.name = film.name
        cls.browser = Browser()
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.open()

    def tearDown(self):
        self.assertEqual(self.browser.faults(), [])
        self.assertTrue(all(url.startswith(("file:", "data:", "about:")) for url in self.browser.requests()), self.browser.requests())

    def open(self, end="", **size):
        self.browser.size(**{"width": 1280, "height": 720, **size})
        self.browser.mouse("mouseMoved", 5, 5)
        self.browser.open("about:blank")
        self.browser.open((self.page / "index.html").as_uri() + end)
        self.browser.wait_for("vitrine.page?.isWhole && document.getElementById('film').readyState >= 2")
        self.left, self.top, self.width, self.height = self.browser.value(
            "(r => [r.left, r.top, r.width, r.height])(document.getElementById('strip').getBoundingClientRect())")

    def look(self, name):
        if ARGUMENTS.pictures:
            ARGUMENTS.pictures.mkdir(parents=True, exist_ok=True)
            self.browser.picture(ARGUMENTS.pictures / f"{name}.png")

    def page_value(self, words):
        return self.browser.value(f"vitrine.page.{words}")

    def pause(self):
        self.browser.value("document.getElementById('film').pause()")

    def go_to(self, level, seconds=None):
        """The page rests there, with all its tiles."""
        seconds = self.index["duration_ns"] / 2e9 if seconds is None else seconds
        self.pause()
        self.page_value(f"show(vitrine.page.places.bounded({{centre: {seconds}, level: {level}}}))")
        self.page_value("draw()")
        self.browser.wait_for("vitrine.page.isWhole")

    def middle(self):
        return self.top + self.height / 2

    def time_at(self, level, x):
        """The film's seconds at a place of a whole level, by the document's words. @param x  px of the strip"""
        its, brick = self.index["levels"][level], self.index["brick_width"]
        times = its["keyframes_ns"]
        end, piece = self.index["duration_ns"], min(1_000_000, self.index["duration_ns"] // 4)
        places = [0] + [(k + 1) * brick / 2 for k in range(len(times))] + [its["width"]]
        moments = [0] + [min(max(t, piece), end - piece) for t in times] + [end]
        for x0, x1, t0, t1 in zip(places, places[1:], moments, moments[1:]):
            if x <= x1:
                return (t0 + (t1 - t0) * (x - x0) / (x1 - x0)) / 1e9
        return end / 1e9

    def strip_x(self, x):
        """px of the strip at a place of the window, at the whole level of the view."""
        view = self.page_value("view")
        scale = self.height / self.index["height"]
        low, high = 0, self.index["levels"][round(view["level"])]["width"]
        for _ in range(60):  # where the view's middle lies
            half = (low + high) / 2
            low, high = (half, high) if self.time_at(round(view["level"]), half) < view["centre"] else (low, half)
        return low + (x - self.width / 2) / scale

    def test_tiles_are_drawn_where_they_belong(self):
        self.assertEqual(self.page_value("drawing.kind"), "webgl")
        self.assertEqual(self.browser.value("document.title"), self.name)
        for level in range(len(self.index["levels"])):
            self.go_to(level)
            drawn = self.browser.value(f"{PIXELS}(null)")
            self.assertGreater(distance(drawn, [0] * len(drawn)), 20)
            self.assertLess(distance(drawn, self.browser.value(f"{TILES}({level})")), 3, f"level {level}")
            self.look(f"level-{level}")

    def test_between_two_levels_the_strip_changes_steadily(self):
        self.assertGreaterEqual(len(self.index["levels"]), 2)
        centre = self.index["duration_ns"] / 2e9
        self.go_to(1)
        self.go_to(0.5)
        self.go_to(0)
        frames = [self.browser.value(f"{PIXELS}({{centre: {centre}, level: {step / STEPS}}})") for step in range(STEPS + 1)]
        for step in (0, 0.25, 0.5, 0.75, 1):
            self.go_to(step)
            self.look(f"zoom-{round(100 * step)}")
        steps = [distance(one, other) for one, other in zip(frames, frames[1:])]
        whole = distance(frames[0], frames[-1])
        print(f"from level to level {whole:.1f} grey levels; in {STEPS} steps of {min(steps):.1f} to {max(steps):.1f}")
        self.assertGreater(min(steps), 0)
        self.assertLess(max(steps), 3 * sorted(steps)[STEPS // 2])
        self.assertLess(max(steps), whole / 2)

    def test_zoom_fields_are_what_the_documents_say(self):
        self.go_to(0)
        self.go_to(1)
        for level, way in ((0, "finer"), (1, "coarser")):
            for tile in self.page_value(f"places.tilesInView(vitrine.page.view, {level})"):
                script = next(self.page.glob(f"tapestry-*/{level}/{tile:06}.js")).read_text("ascii")
                field = base64.b64decode(re.findall(r'"(.*?)"', script)[2 if way == "coarser" else 1])
                width, height, origin = struct.unpack("<HHq", field[8:20])
                columns, left = -(-width // 16) + 1, tile * self.index["tile_width"]
                points = [struct.unpack("<iHB", field[at:at + 7]) for at in range(20, len(field), 7)]
                self.assertEqual(len(points), 11 * columns)
                mesh = self.page_value(f"tiles.get({level}, {tile}).{way}")
                numbers = list(mesh["points"].values())
                for i, (x, y, growth) in enumerate(points):
                    own = (left + min(16 * (i % columns), width), i // columns * height / 10)
                    other = (origin + x / 16, y / 16)
                    coarse, fine = (own, other) if way == "finer" else (other, own)
                    wanted = [coarse[0], coarse[1], fine[0], fine[1], (own[0] - left) / width, own[1] / height,
                              -1 if way == "finer" else max(0.02, growth / 32)]
                    got = numbers[7 * i:7 * i + 7]
                    got[0] += mesh["coarseOrigin"]
                    got[2] += mesh["finerOrigin"]
                    for one, another in zip(got, wanted):
                        self.assertAlmostEqual(one, another, delta=0.01)

    def test_between_two_levels_each_point_is_on_its_way(self):
        self.go_to(1)
        for share in (0.6, 0.8):
            self.go_to(share)
            (there, count), *beside = [self.browser.value(f"{STRAY}({share}, {aside})") for aside in (0, -24, 24)]
            print(f"at {share}: {there:.1f} grey levels from the tiles at {count} points, beside them {beside[0][0]:.1f} and {beside[1][0]:.1f}")
            self.assertGreater(count, 100)
            self.assertLess(there, 0.7 * min(one for one, _ in beside))

    def test_a_drag_takes_the_strip_along_exactly(self):
        level = len(self.index["levels"]) - 1
        self.go_to(level)
        x = self.left + self.width / 2
        held = self.page_value(f"places.timeAt(vitrine.page.view, {x})")
        self.browser.mouse("mouseMoved", x, self.middle())
        self.browser.mouse("mousePressed", x, self.middle(), button="left", buttons=1, clickCount=1)
        for by in (3, 10, -40, -155):
            self.browser.mouse("mouseMoved", x + by, self.middle(), button="left", buttons=1)
            if abs(by) > 4:
                self.assertAlmostEqual(self.page_value(f"places.windowX(vitrine.page.view, {held})"), x + by, delta=0.1)
        self.assertAlmostEqual(self.page_value("film.time"), held, delta=0.01)
        self.look("dragged")
        self.browser.mouse("mouseReleased", x - 155, self.middle(), button="left", clickCount=1)
        self.browser.wait_for("vitrine.page.film.isPlaying")
        self.assertAlmostEqual(self.page_value("film.time"), held, delta=1)

    def test_the_film_shows_the_moment_below_the_mouse_and_a_click_plays_from_there(self):
        level = len(self.index["levels"]) - 1
        self.go_to(level)
        before = self.page_value("film.time")
        for share in (0.13, 0.5, 0.77):
            x = self.left + round(share * self.width)
            self.browser.mouse("mouseMoved", x, self.middle())
            wanted = self.time_at(level, self.strip_x(x - self.left))
            self.assertAlmostEqual(self.page_value("film.time"), wanted, delta=0.01)
            self.browser.wait_for("!document.getElementById('film').seeking")
            self.assertAlmostEqual(self.browser.value("document.getElementById('film').currentTime"), wanted, delta=0.5)
            self.browser.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
            words = [f"{int(time) // 60}:{int(time) % 60:02}" for time in (wanted - 0.001, wanted + 0.001)]  # a keyframe may be at a whole second
            self.assertIn(self.browser.value("document.getElementById('time').textContent"), words)
            line = self.browser.value("document.getElementById('line').getBoundingClientRect().left") + 1
            self.assertAlmostEqual(line, x, delta=1)
        self.look("hovered")
        self.browser.mouse("mouseMoved", self.left + 10, 10)
        self.assertAlmostEqual(self.page_value("film.time"), before, delta=0.5)  # back to what was before
        x = self.left + round(0.9 * self.width)
        self.browser.mouse("mouseMoved", x, self.middle())
        wanted = self.page_value("film.time")
        self.browser.mouse("mousePressed", x, self.middle(), button="left", buttons=1, clickCount=1)
        self.browser.mouse("mouseReleased", x, self.middle(), button="left", clickCount=1)
        self.browser.wait_for("vitrine.page.film.isPlaying && document.getElementById('film').currentTime > 0.1")
        self.assertAlmostEqual(self.page_value("film.time"), wanted, delta=1)
        for _ in range(6):  # the strip goes along
            time.sleep(0.5)
            where = self.page_value("places.windowX(vitrine.page.view, vitrine.page.film.time)")
            self.assertTrue(0 <= where <= self.width, where)
        self.assertGreater(self.page_value("film.time"), wanted + 1)

    def test_the_wheel_zooms_around_the_mouse_and_settles_on_a_whole_level(self):
        self.go_to(0)
        x = self.left + round(0.4 * self.width)
        self.browser.mouse("mouseMoved", x, self.middle())
        kept = self.page_value("film.time")
        levels = []
        for _ in range(3):
            self.browser.mouse("mouseWheel", x, self.middle(), deltaX=0, deltaY=-60)
            levels.append(self.page_value("view.level"))
        end = time.monotonic() + 30
        while self.page_value("view.level") != 1 and time.monotonic() < end:
            levels.append(self.page_value("view.level"))
            self.assertAlmostEqual(self.page_value(f"places.windowX(vitrine.page.view, {kept})"), x, delta=0.5)
        self.assertEqual(self.page_value("view.level"), 1)
        self.assertEqual(levels, sorted(levels))
        self.assertTrue(any(0 < level < 1 for level in levels), levels)
        self.browser.mouse("mouseWheel", x, self.middle(), deltaX=0, deltaY=60)
        self.browser.wait_for("vitrine.page.view.level === 0")

    def test_two_fingers_zoom_and_one_drags(self):
        self.browser.size(1280, 720, touch=True)
        self.go_to(0)
        x, y = self.left + self.width / 2, self.middle()
        kept = self.page_value(f"places.timeAt(vitrine.page.view, {x})")
        self.browser.touch("touchStart", (x - 60, y))
        self.browser.touch("touchStart", (x - 60, y), (x + 60, y))
        for spread in range(60, 150, 6):
            self.browser.touch("touchMove", (x - spread, y), (x + spread, y))
        self.browser.wait_for("vitrine.page.view.level > 0.5")
        self.assertAlmostEqual(self.page_value(f"places.windowX(vitrine.page.view, {kept})"), x, delta=1)
        self.look("pinched")
        self.browser.touch("touchEnd")
        self.browser.wait_for("vitrine.page.view.level % 1 === 0 && vitrine.page.view.level > 0")

        self.go_to(len(self.index["levels"]) - 1)
        held = self.page_value(f"places.timeAt(vitrine.page.view, {x})")
        self.browser.touch("touchStart", (x, y))
        for by in (-5, -30, -90):
            self.browser.touch("touchMove", (x + by, y))
        self.browser.wait_for(f"Math.abs(vitrine.page.places.windowX(vitrine.page.view, {held}) - {x - 90}) < 0.1")
        self.browser.touch("touchEnd")
        self.browser.wait_for("vitrine.page.film.isPlaying")

    def test_keys(self):
        self.go_to(0)
        self.browser.key("ArrowUp")
        self.browser.wait_for("vitrine.page.view.level === 1")
        before = self.page_value("view.centre")
        self.browser.key("ArrowRight")
        self.browser.wait_for(f"vitrine.page.pan === 0 && vitrine.page.view.centre > {before}")
        self.browser.key("ArrowDown")
        self.browser.wait_for("vitrine.page.view.level === 0")
        self.browser.key(" ")
        self.browser.wait_for("vitrine.page.film.isPlaying")
        self.browser.key(" ")
        self.browser.wait_for("!vitrine.page.film.isPlaying")

    def test_any_window_and_any_screen(self):
        for width, height, ratio in ((400, 800, 3), (1920, 1080, 1), (900, 300, 2)):
            self.open(width=width, height=height, ratio=ratio)
            self.go_to(0)
            self.assertEqual(self.browser.value("[vitrine.page.drawing.canvas.width, vitrine.page.drawing.canvas.height]"),
                             [round(self.width * ratio), round(self.height * ratio)])
            drawn = self.browser.value(f"{PIXELS}(null)")
            self.assertLess(distance(drawn, self.browser.value(f"{TILES}(0)")), 4)
            self.look(f"window-{width}x{height}")

    def test_without_webgl_levels_fade(self):
        self.open("#plain")
        self.assertEqual(self.page_value("drawing.kind"), "plain")
        self.go_to(1)
        self.assertLess(distance(self.browser.value(f"{PIXELS}(null)"), self.browser.value(f"{TILES}(1)")), 3)
        self.go_to(0.5)
        self.look("plain-50")


if __name__ == "__main__":
    if chromium() is None:
        print("not run: there is no Chromium (Debian: chromium)")
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], "-v", *REST])
