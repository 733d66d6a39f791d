#!/usr/bin/env python3
"""A tapestry that leaves the house: a page that any browser shows, and a poster, as the analyzer's command makes them.

    export_test.py BUILD_DIRECTORY [unittest arguments]

Draws its own film. What a browser makes of the page is browser_test.py's to say.
"""
import base64
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD = Path(sys.argv[1]).resolve()
ANALYZER = BUILD / "analyzer" / "vitrine-analyzer"
PATIENCE = 600  # seconds
SECONDS = 12  # of the film
WIDTH, HEIGHT = 800, 600
ODD_NAME = b"\"It's\" <b> & \\ caf\xe9 \xff.mp4"


def make_film(path):
    """A new texture every two seconds, with a tone that a page's film shall not have."""
    takes = [f"gradients=size={WIDTH}x{HEIGHT}:rate=10:duration=2:seed={i + 1}:n=4,drawbox=x='mod(t*80\\,600)':y={60 * i}:w=90:h=90:c=white:t=fill[v{i}]"
             for i in range(SECONDS // 2)]
    joined = "".join(f"[v{i}]" for i in range(len(takes))) + f"concat=n={len(takes)}[v]"
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-filter_complex", ";".join([*takes, joined, f"sine=d={SECONDS}[a]"]),
                    "-map", "[v]", "-map", "[a]", "-c:v", "mpeg4", "-q:v", "3", "-c:a", "aac", path], check=True)


def png_size(path):
    head = path.read_bytes()[:24]
    return struct.unpack(">II", head[16:24]) if head.startswith(b"\x89PNG") else None


class Export(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.TemporaryDirectory(prefix="vitrine-export-")
        cls.addClassCleanup(cls.home.cleanup)
        cls.root = Path(cls.home.name)
        cls.film = os.path.join(os.fsencode(cls.root), ODD_NAME)
        make_film(cls.film)

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="out-", dir=self.root)
        self.addCleanup(self.folder.cleanup)
        self.out = Path(self.folder.name)

    def weave(self, *options, film=None):
        return subprocess.run([ANALYZER, "weave", film or self.film, "--state.directory", self.root / "state", "--media.root", self.root / "media",
                               "--tapestry.height", "150", *options], capture_output=True, text=True, errors="replace", timeout=PATIENCE, check=False)

    def page(self, *options):
        done = self.weave("--html", self.out / "page", "--levels", "2", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.out / "page"

    def files_in(self, folder):
        return {str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file()}

    def index_of(self, data):
        text = (data / "tapestry.js").read_text("ascii")
        return json.loads(re.fullmatch(r"vitrine\.setTapestry\((.*)\);\n", text)[1])

    def test_a_page_holds_what_the_documents_say_and_a_new_one_takes_its_place(self):
        pyramid = self.out / "pyramid"
        page = self.page("-o", pyramid)
        data = page / "tapestry-1"
        index, woven = self.index_of(data), json.loads((pyramid / "index.json").read_text())
        for key in ("duration_ns", "height", "tile_width", "brick_width", "levels"):
            self.assertEqual(index[key], woven[key])
        self.assertGreaterEqual(len(index["levels"]), 1)
        tiles = {(level, tile) for level, its in enumerate(index["levels"]) for tile in range(-(-its["width"] // index["tile_width"]))}
        own = {"page.css", "page.js", "places.js", "tiles.js", "drawing.js", "film.js", "tapestry.js", "film.mp4"}
        self.assertEqual(self.files_in(page), {"index.html"} | {f"tapestry-1/{name}" for name in own} |
                         {f"tapestry-1/{level}/{tile:06}.js" for level, tile in tiles})
        for level, tile in tiles:
            script = (data / f"{level}/{tile:06}.js").read_text("ascii")
            texts = re.fullmatch(rf'vitrine\.addTile\({level}, {tile}, "(.*)", "(.*)", "(.*)"\);\n', script).groups()
            beside = pyramid / woven["folder"] / str(level)
            self.assertEqual(base64.b64decode(texts[0]), (beside / f"{tile:06}.jpg").read_bytes())
            for text, way in zip(texts[1:], ("finer", "coarser")):
                field = beside / f"{tile:06}-{way}.zoom"
                self.assertEqual(base64.b64decode(text), field.read_bytes() if field.exists() else b"")
        self.assertEqual(index["name"], ODD_NAME.decode("utf-8", "replace"))
        self.assertNotIn("caf", (page / "index.html").read_text())
        self.assertTrue(all(file.stat().st_mode & 0o444 == 0o444 for file in page.rglob("*") if file.is_file()), "a web server could not read it")

        self.page()
        self.assertEqual({file.name for file in page.iterdir()}, {"index.html", "tapestry-2"})

    def test_the_film_of_a_page_is_small_silent_and_has_key_pictures_everywhere(self):
        film = self.page("--uniform") / "tapestry-1/film.mp4"
        said = json.loads(subprocess.run(["ffprobe", "-v", "error", "-show_streams", "-show_entries", "packet=pts_time,flags", "-of", "json", film],
                                         capture_output=True, text=True, check=True).stdout)
        self.assertEqual([(s["codec_name"], s["width"], s["height"], s["pix_fmt"]) for s in said["streams"]], [("h264", 640, 480, "yuv420p")])
        times = sorted(float(packet["pts_time"]) for packet in said["packets"])
        keys = sorted(float(packet["pts_time"]) for packet in said["packets"] if packet["flags"].startswith("K"))
        self.assertEqual(len(times), 10 * SECONDS)
        self.assertAlmostEqual(times[0], 0, delta=0.001)
        self.assertLessEqual(max(b - a for a, b in zip(keys, keys[1:] + [times[-1]])), 1.001)

    def test_nobodys_files_are_written_over(self):
        page = self.out / "page"
        page.mkdir()
        (page / "thesis.odt").write_text("years of work")
        done = self.weave("--html", page)
        self.assertEqual(done.returncode, 1)
        self.assertIn(str(page), done.stderr)
        self.assertIn("thesis.odt", done.stderr)
        self.assertEqual(self.files_in(page), {"thesis.odt"})

    def test_errors_name_the_file_and_leave_no_page(self):
        text = self.out / "notes.txt"
        text.write_text("no film at all")
        done = self.weave("--html", self.out / "page", film=text)
        self.assertEqual(done.returncode, 1)
        self.assertIn("notes.txt", done.stderr)
        self.assertEqual(self.files_in(self.out / "page") if (self.out / "page").exists() else set(), set())
        done = self.weave("--poster", self.out / "poster.png", film=text)
        self.assertEqual(done.returncode, 1)
        self.assertIn("notes.txt", done.stderr)
        self.assertEqual(self.weave("--height", "400").returncode, 107)  # without a poster

    def test_a_poster_is_as_tall_as_asked_and_tells_how_much_the_film_is_enlarged(self):
        times = self.out / "times"
        times.write_text("1\n5\n")
        poster = self.out / "poster.png"
        done = self.weave("--poster", poster, "--height", "301", "--levels", "1", "--times", times)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(png_size(poster)[1], 301)
        self.assertNotIn("enlarged", done.stderr)
        small = self.root / "small.mp4"
        subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-i", self.film, "-vf", "scale=160:120", "-c:v", "mpeg4", small], check=True)
        done = self.weave("--poster", poster, "--height", "450", "--levels", "1", "--times", times, film=small)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(png_size(poster)[1], 450)
        self.assertIn("is 120 px tall, so it is enlarged 2.50 times", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[2:]])
