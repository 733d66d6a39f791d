"""vitrine-analyzer watch over a folder, and what its catalogue says."""
import json
import os
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

PATIENCE = 120  # seconds until something that must come is given up
# The errors of a share, a disk or a machine.
ERRORS = ["EIO", "ESTALE", "EACCES", "ENOTCONN", "EHOSTDOWN", "ETIMEDOUT", "ENAMETOOLONG", "ELOOP", "ENOMEM", "EMFILE"]


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
    patience = PATIENCE
    saliency = "plain"  # the setting; the network takes a second for each photo

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="vitrine-watch-")
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name) / "media"
        self.state = Path(self.folder.name) / "state"
        self.root.mkdir()

    def settings(self):
        return ["--media.root", str(self.root), "--state.directory", str(self.state),
                "--analyzer.saliency", self.saliency, "--analyzer.quiet_milliseconds", "300", "--tapestry.max_bytes", "0"]

    def start(self, *options):
        watcher = subprocess.Popen([self.analyzer, "watch", *self.settings(), *options])
        self.addCleanup(watcher.wait)
        self.addCleanup(watcher.kill)
        return watcher

    def records(self):
        return records_in(self.state / "catalogue")

    def until(self, what, condition):
        end = time.monotonic() + self.patience
        while time.monotonic() < end:
            if condition(self.records()):
                return self.records()
            time.sleep(0.05)
        self.fail(f"{what} never came true: {self.records()}")

    def until_ready(self, path, width):
        return self.until(f"{path} is ready at {width} px", lambda records: path in records
                          and records[path]["state"] == "ready" and records[path]["width"] == width)


class FaultyFolder(WatchedFolder):
    """With a media folder that fails. The analyzer looks at it each second, and writes a journal."""

    def setUp(self):
        super().setUp()
        self.journal = Path(self.folder.name) / "journal"

    def environment(self):
        """The environment of the analyzer."""
        return dict(os.environ)

    def start(self, *options):
        with open(self.journal, "ab") as journal:
            watcher = subprocess.Popen([self.analyzer, "watch", *self.settings(), "--analyzer.rescan_seconds", "1", "--status.folder", "",
                                        "--analyzer.face_model", "", "--analyzer.children", "2", *options],
                                       stderr=journal, env=self.environment())
        self.addCleanup(watcher.wait)
        self.addCleanup(watcher.kill)
        return watcher

    def require_alive(self, watcher):
        self.assertIsNone(watcher.poll(), f"the daemon has ended:\n{self.journal.read_text()[-2000:]}")

    def until_all_ready(self, watcher, names):
        def ready(records):
            self.require_alive(watcher)
            return all(records.get(name, {}).get("state") == "ready" for name in names)

        self.until(f"{sorted(names)} are ready", ready)
