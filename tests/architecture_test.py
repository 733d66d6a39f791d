#!/usr/bin/env python3
"""The architecture check finds each kind of offence in a tree made for it."""
import tempfile
import unittest
from pathlib import Path

import architecture


def found_in(files):
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        return "\n".join(architecture.offences(root))


class ArchitectureTest(unittest.TestCase):
    def test_a_clean_tree_has_no_offence(self):
        self.assertEqual(found_in({"base/geometry/a.hpp": "", "player/layout/b.hpp": '#include "base/geometry/a.hpp"\n'}), "")

    def test_a_program_may_not_use_the_other(self):
        self.assertIn("may use base", found_in({"player/a.hpp": '#include "analyzer/b.hpp"\n', "analyzer/b.hpp": ""}))

    def test_base_uses_only_base(self):
        self.assertIn("base/ may use base only", found_in({"base/a.hpp": '#include "player/b.hpp"\n', "player/b.hpp": ""}))

    def test_a_sub_folder_never_includes_its_root(self):
        self.assertIn("program's root", found_in({"player/x/a.hpp": '#include "player/b.hpp"\n', "player/b.hpp": ""}))

    def test_a_cycle_of_folders_is_found(self):
        self.assertIn("a cycle of folders", found_in({
            "base/a/one.hpp": '#include "base/b/two.hpp"\n', "base/b/two.hpp": "",
            "base/b/three.hpp": '#include "base/a/four.hpp"\n', "base/a/four.hpp": ""}))

    def test_a_pure_folder_knows_no_clock_and_no_files(self):
        self.assertIn("is pure", found_in({"player/layout/a.cpp": "#include <fstream>\n"}))
        self.assertIn("is pure", found_in({"player/scene/a.cpp": "auto t = std::chrono::steady_clock::now();\n"}))

    def test_a_long_file_is_found(self):
        self.assertIn("lines, at most", found_in({"base/a.cpp": "\n" * 400}))


if __name__ == "__main__":
    unittest.main()
