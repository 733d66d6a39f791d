#!/usr/bin/env python3
"""tidy.py in small trees: it finds what is wrong in any source of a batch, and forgets nothing that has passed."""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEADER = "#pragma once\n#include <string>\nnamespace vitrine {\nstd::string twice(std::string text);\nint length();\n}  // namespace vitrine\n"
TWICE = """#include "base/twice.hpp"
#include <utility>
namespace vitrine {
namespace {
constexpr int times = 2;
}  // namespace
std::string twice(std::string text) {
    std::string kept = std::move(text);
    return kept + std::to_string(times);
}
}  // namespace vitrine
"""
LENGTH = """#include "base/twice.hpp"
namespace vitrine {
int length() { return static_cast<int>(twice("a").size()); }
}  // namespace vitrine
"""


class Tidy(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="vitrine-tidy-")
        self.addCleanup(self.folder.cleanup)
        self.tree = Path(self.folder.name).resolve() / "tree"
        for file in ("tests/tidy.py", "cmake/batches.py", ".clang-tidy", "packaging/dependencies"):
            (self.tree / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(HERE.parent / file, self.tree / file)
        self.write("base/twice.hpp", HEADER)
        self.write("base/twice.cpp", TWICE)
        self.write("base/length.cpp", LENGTH)

    def write(self, name, text):
        (self.tree / name).parent.mkdir(exist_ok=True)
        (self.tree / name).write_text(text)

    def run_tidy(self):
        """Returns the status and the output, over all sources of the tree."""
        sources = sorted(self.tree.glob("base/*.cpp"))
        command = f"c++ -I{self.tree} -std=c++20 -Winvalid-pch -include {self.tree}/cmake_pch.hxx -o x.o -c "
        (self.tree / "compile_commands.json").write_text(json.dumps(
            [{"directory": str(self.tree), "file": str(source), "command": command + str(source)} for source in sources]))
        done = subprocess.run([sys.executable, self.tree / "tests/tidy.py", self.tree], capture_output=True, text=True,
                              env=os.environ | {"XDG_CACHE_HOME": f"{self.folder.name}/cache"})
        return done.returncode, done.stdout + done.stderr

    def test_sources_that_have_passed_are_looked_at_again_when_a_header_of_theirs_changed(self):
        status, said = self.run_tidy()
        self.assertEqual(status, 0, said)
        self.assertIn("2 of 2 sources in 1 batches", said)
        self.assertIn("0 of 2 sources", self.run_tidy()[1])
        self.write("base/twice.hpp", HEADER + "// changed\n")
        self.assertIn("2 of 2 sources", self.run_tidy()[1])

    def test_a_defect_in_any_source_is_found_each_time(self):
        self.write("base/twice.cpp", TWICE.replace("return kept", "return text + kept"))
        for _ in range(2):
            status, said = self.run_tidy()
            self.assertEqual(status, 1, said)
            self.assertIn("bugprone-use-after-move", said)
            self.assertIn("base/twice.cpp:9", said)

    def test_a_defect_in_a_header_is_found(self):
        self.write("base/twice.hpp", HEADER.replace("int length();", "int Length();\nint length();"))
        status, said = self.run_tidy()
        self.assertEqual(status, 1, said)
        self.assertIn("base/twice.hpp:5", said)

    def test_sources_that_cannot_be_read_together_are_read_apart(self):
        # A macro is no name of an unnamed namespace: only the compiler sees the clash.
        self.write("base/clash.cpp", LENGTH.replace("namespace vitrine {", "#define times (2)\nnamespace vitrine {").replace("length", "size_of"))
        self.write("base/clash.hpp", "")
        status, said = self.run_tidy()
        self.assertIn("looked at one by one", said)
        self.assertEqual(status, 0, said)


if __name__ == "__main__":
    unittest.main()
