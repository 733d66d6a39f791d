#!/usr/bin/env python3
"""Writes files into a C++ source, so that the program holds them: the definition of page_files().

    embed.py SOURCE.cpp FILE...
"""
import sys
from pathlib import Path

HEAD = """// Made by cmake/embed.py.
#include "analyzer/tapestry/export/page_folder.hpp"

#include <array>

namespace vitrine::analyzer {

std::span<const PageFile> page_files() {
    static constexpr std::array files{
"""
TAIL = """    };
    return files;
}

}  // namespace vitrine::analyzer
"""
DELIMITER = "vitrine"  # of raw strings


def literal(text):
    if f"){DELIMITER}\"" in text:
        raise ValueError("a file holds the end of a raw string")
    return f'R"{DELIMITER}({text}){DELIMITER}"'


if __name__ == "__main__":
    entries = [f'        PageFile{{"{Path(name).name}", {literal(Path(name).read_text())}}},\n' for name in sys.argv[2:]]
    Path(sys.argv[1]).write_text(HEAD + "".join(entries) + TAIL)
