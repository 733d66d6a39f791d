#!/usr/bin/env python3
"""packaging/install-dependencies on machines that are made up: apt and dpkg are replaced by scripts on the PATH."""

import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
WANTED = sorted(
    line.split("#")[0].strip()
    for line in (ROOT / "packaging/dependencies").read_text().splitlines()
    if line.split("#")[0].strip())


class InstallDependencies(unittest.TestCase):
    def run_on_machine(self, installed):
        """Runs the script where `installed` packages are there. Returns its status and what apt-get was told to install."""
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            calls = folder / "calls"
            calls.write_text("")
            lines = "\\n".join(f"ii  {name}" for name in installed)
            # Like the real one: what is not known is an error, said after what is known.
            status = 0 if set(WANTED) <= set(installed) else 1
            self.write(folder / "dpkg-query", f"printf '{lines}\\n'; echo 'no packages found' >&2; exit {status}")
            self.write(folder / "apt-get", f'echo "$@" >> {calls}')
            self.write(folder / "sudo", 'exec "$@"')
            path = f"{folder}:{os.environ['PATH']}"
            result = subprocess.run(
                [ROOT / "packaging/install-dependencies"], env={**os.environ, "PATH": path}, capture_output=True)
            installs = [line.split() for line in calls.read_text().splitlines() if " install " in f" {line} "]
            return result.returncode, [word for line in installs for word in line if word in WANTED]

    @staticmethod
    def write(path, body):
        path.write_text(f"#!/bin/sh\n{body}\n")
        path.chmod(0o755)

    def test_a_fresh_machine_gets_every_package(self):
        status, installed = self.run_on_machine([])
        self.assertEqual(status, 0)
        self.assertEqual(sorted(installed), WANTED)

    def test_only_what_is_missing_is_installed(self):
        status, installed = self.run_on_machine(WANTED[1:])
        self.assertEqual(status, 0)
        self.assertEqual(installed, WANTED[:1])

    def test_nothing_is_asked_of_apt_where_all_is_there(self):
        status, installed = self.run_on_machine(WANTED)
        self.assertEqual((status, installed), (0, []))


if __name__ == "__main__":
    unittest.main()
