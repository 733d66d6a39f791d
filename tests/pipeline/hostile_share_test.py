#!/usr/bin/env python3
"""vitrine-analyzer on a share that answers wrongly: it lives on, nothing good is lost, all files are ready in the end.

    hostile_share_test.py BUILD_DIRECTORY [--all] [unittest arguments]

Without --all a seeded sample of the errors is tried. Needs FUSE and python3-fusepy; ends with 77 where they are not.
"""
import errno
import json
import os
import random
import subprocess
import sys
import time
import unittest
from pathlib import Path

from drawn_media import png
from watched_folder import WatchedFolder

BUILD = Path(sys.argv[1]).resolve()
ALL = "--all" in sys.argv
SHARE = Path(__file__).resolve().parents[1] / "share" / "hostile_share.py"
SKIPPED = 77
ERRORS = ["EIO", "ESTALE", "EACCES", "ENOTCONN", "EHOSTDOWN", "ETIMEDOUT", "ENAMETOOLONG", "ELOOP", "ENOMEM", "EMFILE"]
PLACES = [("file", "open"), ("file", "read"), ("file", "stat"), ("folder", "stat"), ("folder", "list")]
OUTAGE = 6  # seconds; the analyzer looks at a new file of a share for the second time after two or three


class HostileShare(WatchedFolder):
    analyzer = BUILD / "analyzer" / "vitrine-analyzer"

    def setUp(self):
        super().setUp()
        self.backing = Path(self.folder.name) / "backing"
        self.backing.mkdir()
        self.faults = Path(self.folder.name) / "faults.json"
        self.journal = Path(self.folder.name) / "journal"
        self.fail_with()
        self.mount()

    def mount(self):
        self.share = subprocess.Popen(["/usr/bin/python3", SHARE, self.backing, self.root, self.faults], stderr=subprocess.DEVNULL)
        self.addCleanup(self.unmount)
        end = time.monotonic() + 30
        while not os.path.ismount(self.root):
            self.assertIsNone(self.share.poll(), "the share cannot be mounted")
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)

    def unmount(self):
        self.fail_with()
        self.share.kill()
        self.share.wait()
        subprocess.run(["umount", "-l", self.root], stderr=subprocess.DEVNULL, check=False)

    def fail_with(self, *faults):
        beside = self.faults.with_suffix(".new")
        beside.write_text(json.dumps(faults))
        beside.rename(self.faults)

    def start(self, *options):
        with open(self.journal, "ab") as journal:
            watcher = subprocess.Popen([self.analyzer, "watch", *self.settings(), "--analyzer.rescan_seconds", "1", "--status.folder", "",
                                        "--analyzer.face_model", "", "--analyzer.children", "2", *options], stderr=journal)
        self.addCleanup(watcher.wait)
        self.addCleanup(watcher.kill)
        return watcher

    def drop(self, name, colour=(200, 100, 50)):
        file = self.backing / name
        file.parent.mkdir(parents=True, exist_ok=True)
        png(file, 48, 32, lambda x, y: colour)

    def until_all_ready(self, watcher, names):
        def ready(records):
            self.assertIsNone(watcher.poll(), f"the daemon has ended:\n{self.journal.read_text()[-2000:]}")
            return all(records.get(name, {}).get("state") == "ready" for name in names)

        self.until(f"{sorted(names)} are ready", ready)

    def test_errors_condemn_no_file_and_end_nothing(self):
        cases = [(name, level, call) for name in ERRORS for level, call in PLACES]
        if not ALL:
            cases = random.Random(15).sample(cases, 10)
        for number, _ in enumerate(cases):
            self.drop(f"{number}/before.png")
        watcher = self.start()
        files = {f"{number}/before.png" for number, _ in enumerate(cases)}
        self.until_all_ready(watcher, files)

        self.fail_with(*({"path": f"/{number}/*" if level == "file" else f"/{number}", "call": call, "errno": getattr(errno, name)}
                         for number, (name, level, call) in enumerate(cases)))
        for number, _ in enumerate(cases):
            self.drop(f"{number}/meanwhile.png", (20, 100, 50))
        time.sleep(OUTAGE)
        self.assertTrue(files <= set(self.records()), "a file was lost")
        self.fail_with()
        self.until_all_ready(watcher, files | {f"{number}/meanwhile.png" for number, _ in enumerate(cases)})

    def test_a_root_that_fails_ends_nothing(self):
        errors = ERRORS if ALL else random.Random(15).sample(ERRORS, 3)
        self.drop("a.png")
        watcher = self.start()
        names = {"a.png"}
        self.until_all_ready(watcher, names)
        for name in errors:
            for call in ("stat", "list"):
                with self.subTest(error=name, call=call):
                    self.fail_with({"path": "/", "call": call, "errno": getattr(errno, name)})
                    time.sleep(1.5)
                    self.assertTrue(names <= set(self.records()), "a file was lost")
                    self.fail_with()
                    names.add(f"{name}-{call}.png")
                    self.drop(f"{name}-{call}.png")
                    self.until_all_ready(watcher, names)

    def test_an_error_at_the_start_is_no_end_and_one_while_a_photo_is_read_is_told_as_the_shares(self):
        self.drop("a.png")
        self.fail_with({"path": "/a.png", "call": "read", "errno": errno.EIO})
        watcher = self.start()
        record = self.until("a.png waits", lambda records: records.get("a.png", {}).get("state") == "waiting")["a.png"]
        self.assertEqual(record["fault"]["owner"], "transport")
        self.assertIn("Input/output error", record["reason"])
        watcher.kill()
        watcher.wait()
        self.fail_with()
        self.until_all_ready(self.start(), {"a.png"})

    def test_half_a_listing_loses_no_file_and_what_is_deleted_is_gone(self):
        names = {f"{number}.png" for number in range(6)}
        for name in names:
            self.drop(name)
        watcher = self.start()
        self.until_all_ready(watcher, names)
        self.fail_with({"path": "/", "call": "list", "half": True})
        time.sleep(OUTAGE)
        self.assertEqual(set(self.records()), names)
        self.assertNotIn("gone:", self.journal.read_text())
        self.fail_with({"path": "/private", "call": "list", "errno": errno.EACCES})
        (self.backing / "private").mkdir()
        (self.backing / "0.png").unlink()
        self.until("0.png is gone beside a folder that cannot be read", lambda records: "0.png" not in records)
        self.assertEqual(set(self.records()), names - {"0.png"})
        self.assertIsNone(watcher.poll())

    def test_a_share_that_dies_and_comes_back_loses_nothing(self):
        names = {"a.png", "b.png"}
        for name in names:
            self.drop(name)
        watcher = self.start()
        self.until_all_ready(watcher, names)
        self.share.kill()  # "Transport endpoint is not connected"
        self.share.wait()
        time.sleep(OUTAGE)
        self.assertIsNone(watcher.poll(), self.journal.read_text()[-2000:])
        self.assertEqual(set(self.records()), names)
        self.state, kept = Path(self.folder.name) / "other", self.state
        again = self.start()  # a start meanwhile
        self.state = kept
        time.sleep(OUTAGE)
        self.assertIsNone(again.poll(), self.journal.read_text()[-2000:])
        subprocess.run(["umount", "-l", self.root], check=True)
        self.drop("c.png")
        self.mount()
        self.until_all_ready(watcher, names | {"c.png"})

    def test_reads_that_are_short_give_the_same_pictures(self):
        self.drop("a.png")
        self.fail_with({"path": "/a.png", "call": "read", "short": 7})
        self.until_all_ready(self.start(), {"a.png"})


def can_mount():
    try:
        subprocess.run(["/usr/bin/python3", "-c", "import fusepy"], check=True, stderr=subprocess.DEVNULL)
        return os.access("/dev/fuse", os.W_OK) and os.geteuid() == 0
    except subprocess.CalledProcessError:
        return False


if __name__ == "__main__":
    if not can_mount():
        print("NOT RUN: a hostile share needs root, /dev/fuse and python3-fusepy", file=sys.stderr)
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], "-v", *(word for word in sys.argv[2:] if word != "--all")])
