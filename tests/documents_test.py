#!/usr/bin/env python3
"""The documents name files that exist, in lines of at most 120 characters.

A row of a table cannot be broken, and so may be longer.
"""
import re
import subprocess
import sys
import unittest
from pathlib import Path

TREE = Path(__file__).resolve().parents[1]
DOCUMENTS = sorted([*TREE.glob("*.md"), *TREE.glob("docs/*.md")])
COLUMNS = 120
# A path of the code, as documents write it: with or without the ending of its files.
PATH = re.compile(r"(?<![\w/.$~-])((?:base|analyzer|player|bench|tests|config|systemd|packaging|docs)/[\w./-]*\w)")


def exists(name):
    path = TREE / name
    return path.exists() or any(path.with_name(path.name + end).exists() for end in (".hpp", ".cpp", ".py", ".md"))


class Documents(unittest.TestCase):
    def test_lines_are_short(self):
        long = [f"{d.name}:{number}" for d in DOCUMENTS for number, line in enumerate(d.read_text().split("\n"), 1)
                if len(line) > COLUMNS and not line.startswith("|")]
        self.assertEqual(long, [])

    def test_what_they_name_is_there(self):
        missing = [f"{d.name}: {name}" for d in DOCUMENTS for name in PATH.findall(d.read_text())
                   if not exists(name) and not name.startswith("docs/operating")]
        self.assertEqual(missing, [])

    def test_links_lead_somewhere(self):
        broken = [f"{d.name}: {target}" for d in DOCUMENTS
                  for target in re.findall(r"\]\((?!https?:|#)([^)#]+)", d.read_text()) if not (d.parent / target).exists()]
        self.assertEqual(broken, [])

    def test_installed_guides_link_to_what_is_installed(self):
        installed = set(re.findall(r"docs/([\w/.]+)", "".join(
            re.findall(r"install\(FILES ([^)]*)\)", (TREE / "CMakeLists.txt").read_text()))))
        guides = [TREE / "docs" / name for name in sorted(installed) if name.endswith(".md")]
        self.assertIn(TREE / "docs/technician.md", guides)
        missing = [f"{guide.name}: {target}" for guide in guides
                   for target in re.findall(r"\]\((?!https?:|#)([^)#]+)", guide.read_text()) if target not in installed]
        self.assertEqual(missing, [])

    def test_no_name_of_a_guide_that_is_gone(self):
        found = subprocess.run(["git", "-C", str(TREE), "grep", "-l", "docs/operating.md", "--", ".", ":!CHANGELOG.md",
                                ":!tests/documents_test.py"], capture_output=True, text=True)
        self.assertEqual(found.stdout, "")


if __name__ == "__main__":
    sys.exit(unittest.main())
