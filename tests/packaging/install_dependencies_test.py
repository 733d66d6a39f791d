#!/usr/bin/env python3
"""packaging/install-dependencies on machines that are made up: apt and dpkg are replaced by scripts on the PATH."""

import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def groups_of(text):
    """{group: its packages} of packaging/dependencies."""
    groups = {}
    for line in (line.split("#")[0].strip() for line in text.splitlines()):
        if line.startswith("["):
            groups[line.strip("[]")] = packages = []
        elif line:
            packages.append(line)
    return groups


GROUPS = groups_of((ROOT / "packaging/dependencies").read_text())
WANTED = sorted(package for packages in GROUPS.values() for package in packages)


class InstallDependencies(unittest.TestCase):
    def run_on_machine(self, installed, *groups):
        """Runs the script where `installed` packages are there. Returns its status and the packages that apt-get got."""
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            calls = folder / "calls"
            calls.write_text("")
            lines = "\\n".join(f"ii  {name}" for name in installed)
            # Like the real one: a package that is not known is an error, told after those that are known.
            status = 0 if set(WANTED) <= set(installed) else 1
            self.write(folder / "dpkg-query", f"printf '{lines}\\n'; echo 'no packages found' >&2; exit {status}")
            self.write(folder / "apt-get", f'echo "$@" >> {calls}')
            self.write(folder / "sudo", 'exec "$@"')
            path = f"{folder}:{os.environ['PATH']}"
            result = subprocess.run([ROOT / "packaging/install-dependencies", *groups], env={**os.environ, "PATH": path},
                                    capture_output=True)
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

    def test_a_group_brings_its_packages_alone(self):
        status, installed = self.run_on_machine([], "build", "run")
        self.assertEqual(status, 0)
        self.assertEqual(sorted(installed), sorted(GROUPS["build"] + GROUPS["run"]))

    def test_a_group_that_is_not_there_is_an_error(self):
        status, installed = self.run_on_machine([], "build", "biuld")
        self.assertEqual((status, installed), (2, []))

    def test_only_missing_packages_are_installed(self):
        status, installed = self.run_on_machine(WANTED[1:])
        self.assertEqual(status, 0)
        self.assertEqual(installed, WANTED[:1])

    def test_apt_is_not_called_where_nothing_is_missing(self):
        status, installed = self.run_on_machine(WANTED)
        self.assertEqual((status, installed), (0, []))

    def test_no_package_is_in_two_groups(self):
        self.assertEqual(WANTED, sorted(set(WANTED)))


if __name__ == "__main__":
    unittest.main()
