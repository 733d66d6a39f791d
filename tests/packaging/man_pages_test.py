#!/usr/bin/env python3
"""The manual pages say what the programs do: every option and command of theirs, and no other.

    man_pages_test.py PROGRAM…
"""
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = [Path(word).resolve() for word in sys.argv[1:]]
PLACEHOLDER = "section.key"  # of the pages, for all settings


def help_of(program, *command):
    return subprocess.run([program, *command, "--help"], text=True, capture_output=True, check=True).stdout


def commands_of(program):
    said = help_of(program).partition("Subcommands:")[2]
    return re.findall(r"^  ([a-z]+) ", said, flags=re.M)


def options_of(program):
    """Long names, settings apart."""
    said = "\n".join([help_of(program), *(help_of(program, command) for command in commands_of(program))])
    names = set(re.findall(r"^  (?:-\w,)?--([\w.-]+)", said, flags=re.M))
    return {name for name in names if "." not in name}, {name for name in names if "." in name}


def text_of(page):
    return page.replace(r"\-", "-").replace(r"\fR", "")


def options_in(page):
    """The long names that have a description in a page."""
    lines = text_of(page).splitlines()
    described = [line for above, line in zip(lines, lines[1:]) if above == ".TP"]
    return {name for line in described for name in re.findall(r"--([\w.-]+)", line)} - {PLACEHOLDER}


class ManPages(unittest.TestCase):
    def test_every_option_is_described_and_no_other(self):
        for program in PROGRAMS:
            page = (ROOT / f"packaging/man/{program.name}.1").read_text()
            self.assertEqual(options_in(page), options_of(program)[0], program.name)

    def test_every_command_is_described(self):
        for program in PROGRAMS:
            page = text_of((ROOT / f"packaging/man/{program.name}.1").read_text())
            for command in commands_of(program):
                self.assertRegex(page, rf"\.TP\n\.B {command}\n", program.name)

    def test_the_page_of_settings_has_every_setting(self):
        page = subprocess.run([ROOT / "packaging/man/settings-page", ROOT / "config/vitrine.toml"],
                              text=True, capture_output=True, check=True).stdout
        section, found = None, set()
        for line in text_of(page).splitlines():
            if match := re.fullmatch(r"\.SH \[(\w+)\]", line):
                section = match[1]
            elif section and (match := re.fullmatch(r"\.B (\w+) = .*", line)):
                found.add(f"{section}.{match[1]}")
        for program in PROGRAMS:
            self.assertEqual(found, options_of(program)[1])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
