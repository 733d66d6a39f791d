#!/usr/bin/env python3
"""Holds the tree against docs/architecture.md: who may include whom, no cycles, no file too long.

Reads the #include lines of base, analyzer and player. Prints each offence with the rule it breaks and
exits 1 where there is one.
"""
import re
import sys
from pathlib import Path

FILE_LINES = 320

# Folders that know no clock, no files, no GL, no GStreamer and no log; and what stands outside that rule.
PURE = ("base/geometry", "base/hints", "player/layout", "player/input", "player/scene", "analyzer/saliency",
        "analyzer/tapestry/synthesis/synthesis")
IMPURE_ON_PURPOSE = {
    "player/layout/plan/planner": "runs plan() in a thread of its own",
    "player/input/touch": "reads devices",
    "player/input/input_devices": "reads devices",
}
IMPURE_INCLUDE = re.compile(
    r"^(gst/|GLES|EGL|vips/|fstream|filesystem|thread|sys/|unistd|fcntl|systemd/|base/system/|base/media/)")
CLOCK = re.compile(r"\b(steady_clock|system_clock|high_resolution_clock|random_device|getenv)\b")


def sources(root):
    return sorted(p for top in ("base", "analyzer", "player") for p in (root / top).rglob("*.[ch]pp"))


def includes(text):
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', text, re.M)


def is_ours(include):
    return include.split("/")[0] in ("base", "analyzer", "player", "tests")


def allowed_tops(top):
    return {"base": {"base"}, "analyzer": {"base", "analyzer"}, "player": {"base", "player"}}[top]


def check_may_use(name, include):
    top, folder = name.split("/")[0], str(Path(name).parent)
    other, other_folder = include.split("/")[0], str(Path(include).parent)
    if other not in allowed_tops(top):
        return f"{top}/ may use {' and '.join(sorted(allowed_tops(top)))} only"
    if folder != top and other_folder == top:
        return "a sub-folder never includes its program's root"
    return None


def check_pure(name, text, found):
    if not name.startswith(PURE) or name.rsplit(".", 1)[0] in IMPURE_ON_PURPOSE:
        return
    for include in includes(text):
        if IMPURE_INCLUDE.match(include):
            yield f"{name}: includes '{include}': this folder is pure"
    for word in CLOCK.findall(text):
        yield f"{name}: uses {word}: this folder is pure, time and chance are passed in"


def check_file(root, path):
    name, text = str(path.relative_to(root)), path.read_text()
    if text.count("\n") > FILE_LINES:
        yield f"{name}: {text.count(chr(10))} lines, at most {FILE_LINES}"
    for include in includes(text):
        if ".." in include:
            yield f"{name}: includes '{include}': includes start at the root of the tree"
        if is_ours(include):
            if not (root / include).exists():
                yield f"{name}: includes '{include}', which is not there"
            rule = check_may_use(name, include)
            if rule:
                yield f"{name}: includes '{include}': {rule}"
    own = name.replace(".cpp", ".hpp")
    if path.suffix == ".cpp" and (root / own).exists() and includes(text)[:1] != [own]:
        yield f"{name}: its own header comes first"
    yield from check_pure(name, text, includes(text))


def cycle(graph):
    """One cycle of a graph {node: set of nodes} as a list, or nothing."""
    done, path = set(), []

    def visit(node):
        if node in path:
            return path[path.index(node):] + [node]
        if node in done:
            return None
        path.append(node)
        for after in sorted(graph.get(node, ())):
            found = visit(after)
            if found:
                return found
        path.pop()
        done.add(node)
        return None

    for start in sorted(graph):
        found = visit(start)
        if found:
            return found
    return None


def check_cycles(root, files):
    by_file, by_module, by_folder = {}, {}, {}
    for path in files:
        name = str(path.relative_to(root))
        module, folder = name.rsplit(".", 1)[0], str(Path(name).parent)
        for include in filter(is_ours, includes(path.read_text())):
            other, other_folder = include.rsplit(".", 1)[0], str(Path(include).parent)
            by_file.setdefault(name, set()).add(include)
            if other != module:
                by_module.setdefault(module, set()).add(other)
            if other_folder != folder:
                by_folder.setdefault(folder, set()).add(other_folder)
    for what, graph in (("files", by_file), ("modules", by_module), ("folders", by_folder)):
        found = cycle(graph)
        if found:
            yield f"a cycle of {what}: {' -> '.join(found)}"


def offences(root):
    files = sources(root)
    if not files:
        yield f"no sources under '{root}'"
    for path in files:
        yield from check_file(root, path)
    yield from check_cycles(root, files)


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent)
    found = list(offences(root))
    for offence in found:
        print(offence)
    print(f"{len(sources(root))} files, {len(found)} offences")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
