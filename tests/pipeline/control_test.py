#!/usr/bin/env python3
"""vitrinectl and the player on a bus of their own: what is asked, what is changed, what settings that change do.

    control_test.py BUILD_DIRECTORY [unittest arguments]
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

sys.path[:0] = [str(folder) for folder in Path(__file__).resolve().parents[:2]]
from drawn_media import png  # noqa: E402
from private_bus import start_bus  # noqa: E402

BUILD = Path(sys.argv[1]).resolve()
ANALYZER, PLAYER, CTL = (BUILD / name for name in ("analyzer/vitrine-analyzer", "player/vitrine-player", "player/control/vitrinectl"))
PATIENCE = 300  # seconds until something that must come is given up
UNKNOWN_FILE, NOT_RUNNING = 2, 4
BUS_NAME, BUS_PATH = "org.vitrine.Player1", "/org/vitrine/Player1"
COLOURS = {"red": (230, 30, 30), "green": (30, 200, 30), "blue": (40, 60, 240), "yellow": (240, 220, 30)}


def wait_for(what, look):
    deadline = time.monotonic() + PATIENCE
    while not (seen := look()):
        if time.monotonic() > deadline:
            raise AssertionError(f"waited {PATIENCE} s in vain for {what}")
        time.sleep(0.1)
    return seen


class Control(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory(prefix="vitrine-ctl-")
        self.addCleanup(kept.cleanup)
        self.folder = Path(kept.name)
        self.media, self.state, self.settings = (self.folder / name for name in ("media", "state", "settings.toml"))
        (self.media / "trips").mkdir(parents=True)
        self.environment = os.environ | {"DBUS_SYSTEM_BUS_ADDRESS": f"unix:path={self.folder / 'bus'}"}
        self.log = self.folder / "log"

    def start(self, *command):
        with self.log.open("a") as log:
            child = subprocess.Popen([str(word) for word in command], env=self.environment, stdin=subprocess.DEVNULL,
                                     stdout=subprocess.DEVNULL, stderr=log)
        self.addCleanup(self.end, child)
        return child

    def start_bus(self):
        self.addCleanup(self.end, start_bus(self.folder / "bus", stderr=subprocess.DEVNULL))

    def end(self, child):
        child.terminate()
        child.wait(PATIENCE)

    def set(self, slots):
        self.settings.write_text(f"""
[media]
root = "{self.media}"
[state]
directory = "{self.state}"
[metrics]
file = "{self.folder / 'vitrine.prom'}"
[layout]
slots = {slots}
[show]
order = "name"
dwell_seconds = 3600
motion_milliseconds = 0
[output]
screen = "offscreen:160x90"
frame_rate = 5
""")

    def start_player(self):
        return self.start(PLAYER, "--config", self.settings, "--pace", "realtime")

    def ctl(self, *words, cwd=None):
        return subprocess.run([CTL, *map(str, words)], env=self.environment, cwd=cwd or self.folder, capture_output=True, text=True,
                              timeout=PATIENCE)

    def call(self, method, *arguments):
        """A method of the player on the bus, past vitrinectl."""
        return subprocess.run(["gdbus", "call", "--address", self.environment["DBUS_SYSTEM_BUS_ADDRESS"], "--dest", BUS_NAME, "--object-path",
                               BUS_PATH, "--method", f"{BUS_NAME}.{method}", *map(str, arguments)], capture_output=True, text=True, timeout=PATIENCE)

    def status(self):
        said = self.ctl("status", "--json")
        return json.loads(said.stdout) if said.returncode == 0 else {"cells": [], "files": 0, "removed": []}

    def wall(self):
        return sorted(cell["file"] for cell in self.status()["cells"])

    def test_the_wall_is_asked_and_changed(self):
        for name, colour in COLOURS.items():
            png(self.media / "trips" / f"{name}.png", 64, 48, lambda x, y: colour)
        (self.media / "broken.png").write_bytes((self.media / "trips" / "red.png").read_bytes()[:60] + b"nothing" * 50)
        self.set(slots=2)
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", "--config", self.settings, "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "100"],
                       timeout=PATIENCE, capture_output=True)
        self.start_bus()
        self.assertEqual(self.ctl("status").returncode, NOT_RUNNING)
        player = self.start_player()
        first = wait_for("two on the wall", lambda: len(self.wall()) == 2 and self.wall())
        self.assertEqual(first, ["trips/blue.png", "trips/green.png"])

        with self.subTest("status"):
            status = wait_for("pictures", lambda: (said := self.status())["state"] == "showing" and said)
            self.assertEqual((status["files"], status["outputs"][0]["width"], status["paused"]), (4, 160, False))
            self.assertIn("slot 0", self.ctl("status").stdout)
        with self.subTest("why"):
            for name, cwd in (("trips/blue.png", None), (self.media / "trips/blue.png", None), ("blue.png", self.media / "trips"),
                              ("\\\\box\\media\\trips\\blue.png", None), ("smb://box/media/trips/blue.png", None)):
                said = self.ctl("why", name, cwd=cwd)
                self.assertEqual((said.returncode, said.stdout.splitlines()[0]), (0, "trips/blue.png: ready"), said.stderr)
                self.assertIn("on the wall", said.stdout)
            broken = self.ctl("why", "--json", "broken.png")
            self.assertEqual(broken.returncode, 0, broken.stderr)
            self.assertNotEqual(json.loads(broken.stdout)["state"], "ready")
            self.assertEqual(self.ctl("why", "nothing.png").returncode, UNKNOWN_FILE)
            (self.media / "fresh.png").touch()
            self.assertIn("not been looked at", self.ctl("why", "fresh.png").stdout)
        with self.subTest("screenshot"):
            self.assertEqual(self.ctl("screenshot", "shot.png").returncode, 0)
            raw = subprocess.run(["ffmpeg", "-v", "error", "-i", self.folder / "shot.png", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                                 check=True, capture_output=True).stdout
            self.assertEqual(len(raw), 160 * 90 * 3)
            seen = {raw[i:i + 3] for i in range(0, len(raw), 3)}
            for name in ("blue", "green"):
                self.assertTrue(any(all(abs(a - b) < 25 for a, b in zip(pixel, COLOURS[name])) for pixel in seen), name)
        with self.subTest("next, while it is paused"):
            self.assertEqual(self.ctl("pause").returncode, 0)
            self.assertTrue(self.status()["paused"])
            self.assertEqual(self.ctl("next").returncode, 0)
            second = wait_for("another wall", lambda: (wall := self.wall()) != first and len(wall) == 2 and wall)
            self.assertEqual(len(set(first) & set(second)), 1)
            self.assertEqual(self.ctl("resume").returncode, 0)
        with self.subTest("pin and remove"):
            hidden = next(f"trips/{name}.png" for name in COLOURS if f"trips/{name}.png" not in self.wall())
            self.assertEqual(self.ctl("pin", self.media / hidden).returncode, 0)
            wait_for("the pinned file", lambda: hidden in self.wall())
            self.assertEqual(self.ctl("pin", hidden, "off").returncode, 0)
            self.assertEqual(self.ctl("remove", hidden).returncode, 0)
            wait_for("the removed file to go", lambda: hidden not in self.wall() and len(self.wall()) == 2)
            self.assertIn("vitrinectl", self.ctl("why", hidden).stdout)
            self.assertTrue((self.media / hidden).exists())
            self.assertNotEqual(self.ctl("pin", "nothing.png").returncode, 0)
        with self.subTest("pin a slot"):
            self.assertEqual(self.ctl("pin", 1).returncode, 0)
            wait_for("the pinned slot", lambda: [cell["slot"] for cell in self.status()["cells"] if cell["pinned"]] == [1])
            self.assertEqual(self.ctl("pin", 1, "off").returncode, 0)
            refused = self.ctl("pin", 2)
            self.assertEqual((refused.returncode, "there is no slot 2" in refused.stderr), (1, True), refused.stderr)
            for slot in (2, 2**31, 2**32 - 1):  # vitrinectl takes three digits
                self.assertIn("there is no slot", self.call("PinSlot", slot, "true").stderr)
            self.assertFalse(any(cell["pinned"] for cell in self.status()["cells"]))
        with self.subTest("metrics"):
            text = (self.folder / "vitrine.prom").read_text()
            self.assertIn('vitrine_files{state="ready"} 4\n', text)
            self.assertIn("# TYPE vitrine_frames_shown_total counter\n", text)
        with self.subTest("settings"):
            self.settings.write_text("[layout]\nslots = many\n")
            refused = self.ctl("reload")
            self.assertEqual(refused.returncode, 1)
            self.assertIn("settings.toml:2", refused.stderr)
            player.send_signal(signal.SIGHUP)
            wait_for("the fault in the log", lambda: "the old ones stay" in self.log.read_text())
            self.assertEqual(len(self.wall()), 2)
            self.set(slots=3)
            self.assertEqual(self.ctl("reload").returncode, 0)
            wait_for("a wall of three", lambda: len(self.wall()) == 3)
            far = (time.localtime().tm_hour + 12) % 24
            self.settings.write_text(self.settings.read_text() + f'on = "{far:02}:00-{far:02}:59"\n')  # of [output]
            self.assertEqual(self.ctl("reload").returncode, 0)
            wait_for("the panels to be off", lambda: "panels off, outside of output.on" in self.log.read_text())
        self.assertIsNone(player.poll())

    def test_a_file_out_of_its_hours_is_told_its_hours(self):
        hour = (time.localtime().tm_hour + 3) % 24
        late = f"{hour:02}-{(hour + 1) % 24 or 24:02} Later/late.png"
        (self.media / late).parent.mkdir()
        for name in ("trips/red.png", late):
            png(self.media / name, 64, 48, lambda x, y: COLOURS["red"])
        self.set(slots=2)
        subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", "--config", self.settings, "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "100"],
                       timeout=PATIENCE, capture_output=True)
        self.start_bus()
        player = self.start_player()
        wait_for("one on the wall", lambda: self.wall() == ["trips/red.png"])
        said = json.loads(self.ctl("why", "--json", late).stdout)
        self.assertEqual((said["state"], said["wall"]), ("ready", "out_of_hours"))
        self.assertIn(f"It is out of its hours: it is shown from {hour:02}:00 to", said["says"])
        self.assertIn("files: 1 of 2 may be shown now, 1 out of hours", self.log.read_text())

        note = self.state / "visible.json"
        states = wait_for("the note", lambda: note.exists() and {
            file["path"]: file["state"] for file in json.loads(note.read_text())["files"]})
        self.assertEqual(states[late], "out_of_hours")
        player.terminate()
        player.wait(PATIENCE)
        self.assertFalse(note.exists())

    def test_without_a_bus_the_player_plays_and_says_so_once(self):
        self.set(slots=2)
        player = self.start_player()
        wait_for("the player to miss the bus", lambda: "cannot reach the player" in self.log.read_text())
        wait_for("it to play", lambda: (self.folder / "vitrine.prom").exists())
        self.assertIsNone(player.poll())
        self.assertEqual(self.log.read_text().count("cannot reach the player"), 1)
        self.assertEqual(self.ctl("status").returncode, NOT_RUNNING)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
