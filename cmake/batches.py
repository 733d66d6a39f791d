#!/usr/bin/env python3
"""Sources that can be read by a compiler as one: none of them declares a file-local name that another one declares.

    batches.py LINES SOURCE...     prints batches of at most LINES lines as a list of CMake: SOURCE,SOURCE;SOURCE
"""
import re
import sys
from pathlib import Path

LOCAL_SCOPE = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.S | re.M)


def local_names(text):
    """The names in a source's unnamed namespaces, read from the layout of its text; a compilation tells of a miss."""
    names = set()
    for body in LOCAL_SCOPE.findall(text):
        for line in body.splitlines():
            if not line or line[0] in " }/#)" or line.startswith(("using namespace", "namespace ", "template")):
                continue
            if re.match(r"using \w+(::\w+)+;", line):
                continue  # the same name may be brought in twice
            head = re.split("[={]", re.sub(r"__attribute__\(\(.*?\)\)", "", line))[0]
            found = re.match(r"(?:struct|class|enum class|enum|using)\s+(\w+)", head) or re.search(r"(\w+)\(", head) \
                or re.search(r"(\w+)(?:\[.*\])*\s*[{;]?\s*$", head)
            if found:
                names.add(found[1])
    names.update(re.findall(r"^using (\w+) =", text, re.M))
    if re.search(r"^int main\(", text, re.M):
        names.add("main")
    return names


def batches(sources, max_lines):
    """[sources]: together at most max_lines lines, unless one has more, and no two with the same local name."""
    made = []
    for source in sources:
        text = Path(source).read_text()
        names, lines = local_names(text), text.count("\n")
        fitting = next((one for one in made if one["lines"] + lines <= max_lines and not one["names"] & names), None)
        if fitting is None:
            fitting = {"names": set(), "lines": 0, "sources": []}
            made.append(fitting)
        fitting["names"] |= names
        fitting["lines"] += lines
        fitting["sources"].append(source)
    return [one["sources"] for one in made]


if __name__ == "__main__":
    print(";".join(",".join(batch) for batch in batches(sys.argv[2:], int(sys.argv[1]))), end="")
