#!/usr/bin/env python3
"""vitrine-analyzer while calls on the media folder fail: it lives on, loses nothing, and all files are ready in the end.

    failing_calls_test.py BUILD_DIRECTORY [--all] [unittest arguments]

The calls fail in the program itself, so that also those do which no server is asked for. Ten errors, five calls, and
three places: the root, a folder, a file. Without --all a seeded sample of the 150 is tried.
"""
import errno
import os
import random
import sys
import time
import unittest
from pathlib import Path

from drawn_media import png
from watched_folder import ERRORS, PATIENCE, FaultyFolder

BUILD = Path(sys.argv[1]).resolve()
ALL = "--all" in sys.argv
LIBRARY = BUILD / "tests" / "pipeline" / "libfailing_calls.so"
TABLE_BYTES = 64 << 10
CALLS = ["open", "read", "stat", "list", "watch"]
OUTAGE = 5  # seconds
AT_THE_ROOT = 1.5  # seconds


class FailingCalls(FaultyFolder):
    analyzer = BUILD / "analyzer" / "vitrine-analyzer"
    patience = 900 if ALL else PATIENCE  # a hundred files are analysed

    def setUp(self):
        super().setUp()
        self.table = Path(self.folder.name) / "table"
        self.table.write_bytes(bytes(TABLE_BYTES))

    def fail_with(self, *faults):
        """Faults are (call, name of the errno, pattern)."""
        text = "".join(f"{call} {getattr(errno, name)} {pattern}\n" for call, name, pattern in faults).encode()
        self.assertLess(len(text), TABLE_BYTES - 1)
        with open(self.table, "r+b") as table:
            table.write(b"0")
            table.flush()
            table.write(text + b"\0")
            table.flush()
            table.seek(0)
            table.write(b"1" if faults else b"0")

    def environment(self):
        return os.environ | {"LD_PRELOAD": str(LIBRARY), "FAILING_CALLS": str(self.table)}

    def drop(self, name):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        png(file, 48, 32, lambda x, y: (200, 100, 50))
        return name

    def test_errors_at_folders_and_files_condemn_nothing(self):
        cases = [(call, name, place) for name in ERRORS for call in CALLS for place in ("folder", "file")]
        if not ALL:
            cases = random.Random(15).sample(cases, 12)
        files = {self.drop(f"{number}/before.png") for number, _ in enumerate(cases)}
        watcher = self.start()
        self.until_all_ready(watcher, files)

        faults = []
        for number, (call, name, place) in enumerate(cases):
            for pattern in ("", "/new") if place == "folder" else ("/*.png", ):
                faults.append((call, name, f"{self.root}/{number}{pattern}"))
        self.fail_with(*faults)
        late = {self.drop(f"{number}/{name}") for number, _ in enumerate(cases) for name in ("meanwhile.png", "new/inside.png")}
        time.sleep(OUTAGE)
        self.assertTrue(files <= set(self.records()), "a file was lost")
        self.fail_with()
        self.until_all_ready(watcher, files | late)

    def test_errors_at_the_root_end_nothing(self):
        cases = [(call, name) for name in ERRORS for call in CALLS]
        if not ALL:
            cases = random.Random(15).sample(cases, 4)
        names = {self.drop("a.png")}
        watcher = self.start()
        self.until_all_ready(watcher, names)
        for call, name in cases:
            with self.subTest(call=call, error=name):
                self.fail_with((call, name, str(self.root)))
                names.add(self.drop(f"{call}-{name}.png"))
                time.sleep(AT_THE_ROOT)
                self.require_alive(watcher)
                self.fail_with()
                self.until_all_ready(watcher, names)

    def test_a_start_while_the_root_fails_is_no_end(self):
        names = {self.drop("a.png")}
        for call in CALLS:
            with self.subTest(call=call):
                self.fail_with((call, "ENOTCONN", str(self.root)))
                watcher = self.start()
                time.sleep(AT_THE_ROOT)
                self.require_alive(watcher)
                self.fail_with()
                self.until_all_ready(watcher, names)
                watcher.kill()
                watcher.wait()
                names.add(self.drop(f"{call}.png"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *(word for word in sys.argv[2:] if word != "--all")])
