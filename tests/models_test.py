#!/usr/bin/env python3
"""The models of the tree are what their table says: file, size, hash, and licences that the tree names."""
import hashlib
import re
import sys
import unittest
from pathlib import Path

TREE = Path(__file__).resolve().parents[1]
MODELS = TREE / "analyzer/models"
ROW = re.compile(r"^\| `([\w.]+)` \|.*\| ([\w.-]+) \| ([\d,]+) \| `([0-9a-f]{64})` \|$", re.M)


class Models(unittest.TestCase):
    def test_each_model_is_what_its_row_says(self):
        rows = {name: rest for name, *rest in ROW.findall((MODELS / "README.md").read_text())}
        self.assertEqual(sorted(rows), sorted(file.name for file in MODELS.glob("*.onnx")))
        for name, (licence, size, digest) in rows.items():
            content = (MODELS / name).read_bytes()
            self.assertEqual(len(content), int(size.replace(",", "")), name)
            self.assertEqual(hashlib.sha256(content).hexdigest(), digest, name)
            for terms in (TREE / ".reuse/dep5", TREE / "packaging/debian/copyright"):
                self.assertRegex(terms.read_text(), f"Files: analyzer/models/{name}\nCopyright: .*\nLicense: {licence}\n")


if __name__ == "__main__":
    sys.exit(unittest.main())
