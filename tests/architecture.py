#!/usr/bin/env python3
"""Holds the tree against docs/architecture.md: who may include whom, no cycles, no class or function too large.

    architecture.py [ROOT [BUILD]]

Reads the #include lines of base, analyzer, player and link and, where BUILD holds compile_commands.json, their classes and
functions as the compiler sees them (tests/code_model.py). Prints each offence with the rule it breaks and exits 1
where there is one. Without BUILD the rules on classes and functions are not checked, and the last line says so.
"""
import re
import sys
from pathlib import Path

MODULES = 25  # flat in a folder
MEMBERS = 15  # data members of a class
METHODS = 20  # of a class; constructors and operators count, defaulted and deleted ones do not
PARAMETERS = 5  # of a function
FUNCTION_LINES = 40  # from its first line to its closing brace
HEADERS = 40  # of the tree that the header of a program's root class pulls in, directly or not
ROOT_HEADERS = ("player/player.hpp",)

# Classes and functions that may be larger, each with the reason. At most EXCEPTIONS of them; never one of NO_EXCEPTION.
EXCEPTIONS = 8
MAY_BE_LARGER = {
}
NO_EXCEPTION = ("Player", "Stage", "Daemon", "SourcePool", "Wall", "TapestryStrip", "TapestryShow", "FilmLoop")

# Folders that know no clock, no files, no GL, no GStreamer and no log; and what stands outside that rule.
PURE = ("base/geometry", "base/calendar", "base/hints", "player/layout", "player/input", "player/scene", "analyzer/saliency",
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
    return sorted(p for top in ("base", "analyzer", "player", "link") for p in (root / top).rglob("*.[ch]pp"))


def includes(text):
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', text, re.M)


def is_ours(include):
    return include.split("/")[0] in ("base", "analyzer", "player", "link", "tests")


def allowed_tops(top):
    return {"base": {"base"}, "analyzer": {"base", "analyzer"}, "player": {"base", "player"}, "link": {"base", "link"}}[top]


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
    if path.suffix == ".cpp" and path.name != "main.cpp":
        if not (root / own).exists():
            yield f"{name}: has no header of its own"
        elif includes(text)[:1] != [own]:
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


def reached(root, name, seen):
    """All headers of the tree that a file pulls in, directly or not; added to those seen."""
    for include in filter(is_ours, includes((root / name).read_text())):
        if include not in seen and (root / include).exists():
            seen.add(include)
            reached(root, include, seen)
    return seen


def check_reach(root):
    for name in ROOT_HEADERS:
        count = len(reached(root, name, set())) if (root / name).exists() else 0
        if count > HEADERS:
            yield f"{name}: pulls in {count} headers of the tree, at most {HEADERS}"


def check_folders(root, files):
    folders = {}
    for path in files:
        folders.setdefault(str(path.parent.relative_to(root)), set()).add(path.stem)
    for folder, modules in sorted(folders.items()):
        if len(modules) > MODULES:
            yield f"{folder}: {len(modules)} modules, at most {MODULES} in a folder"


class Classes:
    """The classes of a code model, and who belongs to whom."""

    def __init__(self, model):
        self.classes, self.functions = model["classes"], model["functions"]
        self.holders = {}  # class -> those that have a member of its type
        for usr, found in self.classes.items():
            for _, types in found["fields"]:
                for other in types:
                    self.holders.setdefault(other, set()).add(usr)
        self.known_in = {}  # class -> modules with functions that take or return it
        for function in self.functions.values():
            # Who calls a public function of the class hands the value over, wherever it stands.
            where = "anybody" if function["holder"] and function["is_public"] else module_of(function["file"])
            for other in function["types"] + function["returns"]:
                self.known_in.setdefault(other, set()).add(where)

    def is_private_to(self, inner, outer):
        """Whether only `outer` holds `inner`, and nobody beyond its module knows it: state of its own by another name."""
        if inner == outer or inner not in self.classes or self.holders.get(inner) != {outer}:
            return False
        module = module_of(self.classes[outer]["file"])
        return module_of(self.classes[inner]["file"]) == module and self.known_in.get(inner, set()) <= {module}

    def private_parts(self, usr):
        types = {other for _, types in self.classes[usr]["fields"] for other in types}
        return sorted(other for other in types if self.is_private_to(other, usr))

    def members(self, usr, seen=frozenset()):
        """Its own; in place of one that is a private struct, those of that struct."""
        parts = set(self.private_parts(usr)) - seen
        own = sum(1 for _, types in self.classes[usr]["fields"] if not parts & set(types))
        return own + sum(self.members(part, seen | {usr, part}) for part in parts)

    def methods(self, usr):
        """Its own, those of its private structs, and the functions that take one of these by name."""
        parts = self.private_parts(usr)
        functions = sum(1 for f in self.functions.values() if f["holder"] is None and set(parts) & set(f["types"]))
        return len(self.classes[usr]["methods"]) + functions + sum(len(self.classes[p]["methods"]) for p in parts)

    def is_plain(self, usr):
        return self.classes[usr]["is_record"]


def module_of(name):
    return name.rsplit(".", 1)[0]


def check_class(classes, usr):
    found = classes.classes[usr]
    if found["friends"]:
        yield found, f"has {found['friends']} friends: no class has one"
    if classes.is_plain(usr):
        return
    members, methods = classes.members(usr), classes.methods(usr)
    if members > MEMBERS:
        yield found, f"{members} data members, at most {MEMBERS}"
    if methods > METHODS:
        yield found, f"{methods} methods, at most {METHODS}"


def check_function(found):
    if found["parameters"] > PARAMETERS:
        yield found, f"{found['parameters']} parameters, at most {PARAMETERS}"
    if found["lines"] > FUNCTION_LINES:
        yield found, f"{found['lines']} lines, at most {FUNCTION_LINES}"


def check_code(model):
    """What is too large, but for the exceptions; and exceptions that are not needed or not allowed."""
    classes, used = Classes(model), set()
    found = [offence for usr in classes.classes for offence in check_class(classes, usr)]
    found += [offence for function in model["functions"].values() for offence in check_function(function)]
    for what, says in sorted(found, key=lambda f: (f[0]["file"], f[0]["line"])):
        name = what["name"].replace("vitrine::", "", 1)
        if name in MAY_BE_LARGER:
            used.add(name)
        else:
            yield f"{what['file']}:{what['line']}: {name}: {says}"
    for name in sorted(set(MAY_BE_LARGER) - used):
        yield f"{name}: is an exception that is not needed"
    for name in sorted(MAY_BE_LARGER):
        if set(name.split("::")) & set(NO_EXCEPTION):
            yield f"{name}: may not be an exception"
    if len(MAY_BE_LARGER) > EXCEPTIONS:
        yield f"{len(MAY_BE_LARGER)} exceptions, at most {EXCEPTIONS}"


def offences(root, build=None):
    files = sources(root)
    if not files:
        yield f"no sources under '{root}'"
    for path in files:
        yield from check_file(root, path)
    yield from check_cycles(root, files)
    yield from check_folders(root, files)
    yield from check_reach(root)
    if build:
        import code_model
        model = code_model.model(root, build)
        yield from (f"{name}: cannot be read: {error}" for name, error in sorted(model["errors"].items()))
        yield from check_code(model)


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    build = Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None
    found = list(offences(root, build))
    for offence in found:
        print(offence)
    print(f"{len(sources(root))} files, {len(found)} offences" + ("" if build else "; classes and functions NOT CHECKED"))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
