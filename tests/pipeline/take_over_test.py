#!/usr/bin/env python3
"""A reader that a hostile file has taken over reaches nothing: no file but its own, no socket, no process, no program.

    take_over_test.py BUILD_DIRECTORY SYSTEM_PLUGINS [unittest arguments]

What takes it over is a library of the tests (take_over/library.cpp): the decoder of a film, and libjpeg for photos.
SYSTEM_PLUGINS is where GStreamer's own lie.
"""
import ctypes
import os
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

BUILD = Path(sys.argv[1]).resolve()
PLUGINS = sys.argv[2]
ANALYZER = BUILD / "analyzer" / "vitrine-analyzer"
LIBRARY = BUILD / "tests" / "take_over" / "libgstvitrinetakeover.so"
PATIENCE = 60  # seconds until something that must come is given up


def has_landlock():
    create_ruleset, only_version = 444, 1
    return ctypes.CDLL(None).syscall(create_ruleset, None, ctypes.c_size_t(0), only_version) > 0


def drawn(path, *coding):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-f", "lavfi", "-i", "testsrc=size=320x180:rate=10:duration=1",
                    *coding, str(path)], check=True)


class TakeOver(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not has_landlock():
            print("this kernel has no Landlock: FILES ARE NOT TESTED, but all else is", file=sys.stderr)

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="vitrine-take-over-")
        self.addCleanup(self.folder.cleanup)
        self.home = Path(self.folder.name)
        self.root, self.state = self.home / "media", self.home / "state"
        self.root.mkdir()
        self.record = self.state / "other"
        self.record.parent.mkdir(parents=True)
        self.record.write_text("{}")
        self.listening = socket.socket(socket.AF_UNIX)
        self.addCleanup(self.listening.close)
        self.listening.bind(str(self.home / "socket"))
        self.listening.listen()
        drawn(self.root / "film.mkv", "-c:v", "libaom-av1", "-cpu-used", "8")
        drawn(self.root / "photo.jpg", "-frames:v", "1")

    def environment(self, name):
        hostile = {"ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":verify_asan_link_order=0", "PREY_MEDIA": str(self.root / name), "PREY_RECORD": str(self.record), "PREY_SOCKET": str(self.home / "socket")}
        if name == "photo.jpg":
            return os.environ | hostile | {"LD_PRELOAD": str(LIBRARY)}
        return os.environ | hostile | {
            "GST_PLUGIN_PATH": f"{PLUGINS}:{LIBRARY.parent}",  # the last of a name is taken
            "GST_PLUGIN_SYSTEM_PATH": str(self.home / "none"), "GST_REGISTRY": str(self.home / "registry")}

    def command(self, name, *words):
        return [ANALYZER, *words, "--media.root", str(self.root), "--state.directory", str(self.state)]

    def assert_nothing_is_reached(self, said):
        lines = said.splitlines()
        self.assertIn("taken over", lines, "it was not even tried")
        self.assertIn("the end", lines, said)
        files = [line for line in lines if line.startswith("reached file: ")]
        calls = [line for line in lines if line.startswith("reached call: ")]
        print(f"{len(files)} files and {len(calls)} calls reached")
        self.assertEqual(calls, [])
        if has_landlock():
            self.assertEqual(files, [])
            self.assertEqual(self.record.read_text(), "{}")

    def test_a_reader_by_hand(self):
        for name in ("film.mkv", "photo.jpg"):
            for outputs in ((), ("--grow", "--keep", "--thumbnail", "--frames")):
                with self.subTest(name, outputs=outputs):
                    done = subprocess.run(self.command(name, "analyze", *outputs, str(self.root / name)), env=self.environment(name),
                                          text=True, capture_output=True, timeout=PATIENCE)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assert_nothing_is_reached(done.stderr)

    def test_an_explanation(self):
        for name in ("film.mkv", "photo.jpg"):
            with self.subTest(name):
                sheet = self.home / f"{name}.png"
                done = subprocess.run(self.command(name, "explain", f"--output={sheet}", str(self.root / name)), env=self.environment(name),
                                      text=True, capture_output=True, timeout=PATIENCE)
                self.assert_nothing_is_reached(done.stderr)
                if name == "photo.jpg":  # the film's decoder gives no picture
                    self.assertEqual(sheet.read_bytes()[:4], b"\x89PNG", done.stderr)

    def test_a_weaver(self):
        done = subprocess.run(self.command("film.mkv", "weave", f"--output={self.state / 'tapestry' / 'x'}", str(self.root / "film.mkv")),
                              env=self.environment("film.mkv"), text=True, capture_output=True, timeout=PATIENCE)
        self.assert_nothing_is_reached(done.stderr)

    def test_a_child_of_the_daemon(self):
        (self.root / "photo.jpg").unlink()
        with open(self.home / "journal", "w") as journal:
            daemon = subprocess.Popen(self.command("film.mkv", "watch", "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "100"),
                                      env=self.environment("film.mkv"), stderr=journal)
        self.addCleanup(daemon.wait)
        self.addCleanup(daemon.kill)
        end = time.monotonic() + PATIENCE
        said = ""
        while "the end" not in said:
            self.assertLess(time.monotonic(), end, said + (self.home / "journal").read_text())
            time.sleep(0.1)
            said = "".join(left.read_text() for left in self.state.glob("store/*/reached"))
        self.assert_nothing_is_reached(said)
        self.assertIn("readers are in", (self.home / "journal").read_text())
        self.assertIsNone(daemon.poll())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
