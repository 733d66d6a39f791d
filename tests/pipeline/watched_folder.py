"""vitrine-analyzer watch over a folder, and what its catalogue says."""
import json
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

PATIENCE = 120  # seconds until something that must come is given up


def records_in(catalogue):
    """path -> record. Each is whole whenever it is read."""
    found = {}
    for file in Path(catalogue).glob("*.json"):
        try:
            text = file.read_text()
        except FileNotFoundError:
            continue  # removed just now
        record = json.loads(text)
        found[record["path"]] = record
    return found


class WatchedFolder(unittest.TestCase):
    """With an empty media folder for each test."""

    analyzer = None  # the program: for subclasses to say

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="vitrine-watch-")
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name) / "media"
        self.state = Path(self.folder.name) / "state"
        self.root.mkdir()

    def settings(self):
        return ["--media.root", str(self.root), "--state.directory", str(self.state),
                "--analyzer.quiet_milliseconds", "300", "--tapestry.max_bytes", "0"]

    def start(self, *options):
        watcher = subprocess.Popen([self.analyzer, "watch", *self.settings(), *options])
        self.addCleanup(watcher.wait)
        self.addCleanup(watcher.kill)
        return watcher

    def records(self):
        return records_in(self.state / "catalogue")

    def until(self, what, condition):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if condition(self.records()):
                return self.records()
            time.sleep(0.05)
        self.fail(f"{what} never came true: {self.records()}")

    def until_ready(self, path, width):
        return self.until(f"{path} is ready at {width} px", lambda records: path in records
                          and records[path]["state"] == "ready" and records[path]["width"] == width)
