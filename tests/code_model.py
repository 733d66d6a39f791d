"""The classes and functions of the tree as the compiler sees them, read with libclang.

model(root, build) parses the source files, many as one unit, with the flags of BUILD/compile_commands.json. A unit's
answer is kept in the user's cache, under a key made of its files, of all files of the tree that they include, and of
the flags, so that a second run parses only what changed.
"""
import hashlib
import json
import os
import re
import shlex
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

# Debian's binding belongs to Debian's Python; another Python reads it from there, too.
sys.path.append("/usr/lib/python3/dist-packages")
from clang import cindex  # noqa: E402
from clang.cindex import AccessSpecifier, CursorKind  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cmake"))
sys.dont_write_bytecode = True
from batches import batches  # noqa: E402

UNIT = 4000  # lines of sources that are read as one
LIBRARY = "/usr/lib/llvm-14/lib/libclang.so.1"
TOPS = ("base", "analyzer", "player", "link")
CLASSES = (CursorKind.CLASS_DECL, CursorKind.STRUCT_DECL, CursorKind.CLASS_TEMPLATE)
FUNCTIONS = (CursorKind.FUNCTION_DECL, CursorKind.CXX_METHOD, CursorKind.CONSTRUCTOR, CursorKind.DESTRUCTOR,
             CursorKind.CONVERSION_FUNCTION, CursorKind.FUNCTION_TEMPLATE)
ONCE = cindex.TranslationUnit.PARSE_INCOMPLETE  # templates are read as they are written, not for each use
SPECIAL = (CursorKind.CONSTRUCTOR, CursorKind.DESTRUCTOR)


class Reader:
    """Reads one translation unit into plain lists and dictionaries."""

    def __init__(self, root):
        self.root = str(root) + os.sep
        self.classes = {}
        self.functions = {}
        self.names = {}  # of files, as the compiler names them, from the root
        self.texts = {}  # of files, in bytes

    def name_in_tree(self, location):
        """The file of a location as a path from the root, or None for what stands outside."""
        if location.file is None:
            return None
        name = location.file.name
        if name not in self.names:
            real = os.path.realpath(name)
            ours = real[len(self.root):] if real.startswith(self.root) else ""
            self.names[name] = ours if ours.split("/")[0] in TOPS else None
        return self.names[name]

    def types_of_tree(self, cursor):
        """The classes of the tree that a declaration's type names, its template arguments included."""
        return sorted({self.key_of(c.referenced) for c in cursor.walk_preorder()
                       if c.kind in (CursorKind.TYPE_REF, CursorKind.TEMPLATE_REF) and c.referenced is not None
                       and self.name_in_tree(c.referenced.location)})

    def read(self, cursor):
        for child in cursor.get_children():
            if child.kind in (CursorKind.NAMESPACE, CursorKind.LINKAGE_SPEC, CursorKind.UNEXPOSED_DECL):
                if child.kind != CursorKind.NAMESPACE or self.may_hold_ours(child):
                    self.read(child)
            elif child.kind in CLASSES or child.kind in FUNCTIONS:
                if self.name_in_tree(child.location):
                    self.read_class(child) if child.kind in CLASSES else self.read_function(child)

    def key_of(self, cursor):
        """Names of unnamed namespaces are told apart by their file."""
        usr = cursor.get_usr()
        return f"{usr}@{self.name_in_tree(cursor.location)}" if "@aN" in usr else usr

    def may_hold_ours(self, namespace):
        return self.name_in_tree(namespace.location) is not None

    def read_class(self, cursor):
        if not cursor.is_definition():
            return
        of_class = {"name": self.full_name(cursor), "file": self.name_in_tree(cursor.location),
                    "line": cursor.location.line, "fields": [], "methods": [], "friends": 0, "is_record": True}
        self.classes[self.key_of(cursor)] = of_class
        for child in cursor.get_children():
            self.read_member(child, of_class)

    def read_member(self, child, of_class):
        if child.kind in CLASSES:
            self.read_class(child)
        elif child.kind in (CursorKind.FIELD_DECL, CursorKind.VAR_DECL):
            is_member = child.kind == CursorKind.FIELD_DECL
            if is_member:
                of_class["fields"].append([child.spelling, self.types_of_tree(child)])
            if child.access_specifier != AccessSpecifier.PUBLIC:
                of_class["is_record"] = False
        elif child.kind == CursorKind.FRIEND_DECL:
            of_class["friends"] += 1
        elif child.kind in FUNCTIONS:
            self.read_method(child, of_class)
        elif child.kind == CursorKind.UNEXPOSED_DECL:
            for inner in child.get_children():
                self.read_member(inner, of_class)

    def read_method(self, child, of_class):
        is_defaulted = child.is_default_method() or self.is_deleted(child)
        if is_defaulted:
            return
        of_class["methods"].append(child.displayname)
        changes = child.kind in SPECIAL or not (child.is_const_method() or child.is_static_method())
        if changes or child.is_virtual_method():
            of_class["is_record"] = False
        self.read_function(child)

    @staticmethod
    def is_deleted(cursor):
        return cursor.availability == cindex.AvailabilityKind.NOT_AVAILABLE

    @staticmethod
    def full_name(cursor):
        names = []
        while cursor is not None and cursor.kind != CursorKind.TRANSLATION_UNIT:
            if cursor.spelling and cursor.kind != CursorKind.LINKAGE_SPEC:
                names.append(cursor.spelling)
            cursor = cursor.semantic_parent
        return "::".join(reversed(names))

    def holder_of(self, cursor):
        parent = cursor.semantic_parent
        return self.key_of(parent) if parent is not None and parent.kind in CLASSES else None

    def read_function(self, cursor):
        name = self.name_in_tree(cursor.location)
        if not cursor.is_definition():
            self.functions.setdefault(cursor.get_usr(), self.signature(cursor, name, 0))
            return
        lines = cursor.extent.end.line - cursor.extent.start.line + 1
        usr = cursor.get_usr() + ("" if self.holder_of(cursor) else "@" + name)
        self.functions[usr] = self.signature(cursor, name, lines)
        self.read_local_classes(cursor)

    def text_of(self, cursor):
        name = cursor.extent.start.file.name
        if name not in self.texts:
            self.texts[name] = Path(name).read_bytes()
        return self.texts[name][cursor.extent.start.offset:cursor.extent.end.offset]

    def read_local_classes(self, cursor):
        """Walking through a function takes long, so only those with such a word are walked through."""
        if not re.search(rb"\b(class|struct)\b", self.text_of(cursor)):
            return
        for child in cursor.walk_preorder():
            if child.kind in CLASSES and child != cursor and child.is_definition():
                self.read_class(child)

    def signature(self, cursor, name, lines):
        parameters = [c for c in cursor.get_children() if c.kind == CursorKind.PARM_DECL]
        types = sorted({usr for p in parameters for usr in self.types_of_tree(p)})
        returned = [usr for c in cursor.get_children() if c.kind == CursorKind.TYPE_REF and c.referenced is not None
                    and self.name_in_tree(c.referenced.location) for usr in [self.key_of(c.referenced)]]
        return {"name": self.full_name(cursor), "file": name, "line": cursor.extent.start.line, "lines": lines,
                "parameters": len(parameters), "types": types, "returns": returned,
                "holder": self.holder_of(cursor), "is_public": cursor.access_specifier == AccessSpecifier.PUBLIC}


def flags_of(command):
    """The flags of a compile command that decide what the code means."""
    words = shlex.split(command)
    kept = [word for word in words if word.startswith(("-I", "-D", "-std"))]
    return kept + ["-isystem" + after for word, after in zip(words, words[1:]) if word == "-isystem"]


def included(name, root, known):
    """The files of the tree that `name` includes, with those that they include."""
    if name not in known:
        known[name] = set()
        path = root / name
        text = path.read_text() if path.exists() else ""
        direct = [i for i in re.findall(r'^\s*#\s*include\s*"([^"]+)"', text, re.M) if i.split("/")[0] in TOPS]
        for other in direct:
            known[name] |= {other} | included(other, root, known)
    return known[name]


def key_of(names, root, flags, known, digests):
    """A key of what the model of some files depends on."""
    def digest(file):
        if file not in digests:
            path = root / file
            digests[file] = hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else ""
        return digests[file]

    relative = [flag.replace(str(root), ".") for flag in flags]
    files = set(names).union(*(included(name, root, known) for name in names))
    own = hashlib.sha256(Path(__file__).read_bytes()).hexdigest()
    return hashlib.sha256("\n".join([own, *names, *relative, *(digest(f) for f in sorted(files))]).encode()).hexdigest()


def load_library():
    if not cindex.Config.loaded:
        cindex.Config.set_library_file(LIBRARY)


def read_unit(root, unit):
    """What a unit declares, by file, and the files of the tree with errors."""
    reader = Reader(root)
    reader.read(unit.cursor)
    faulty = {reader.name_in_tree(d.location): str(d) for d in unit.diagnostics
              if d.severity >= cindex.Diagnostic.Error and reader.name_in_tree(d.location)}
    return {"classes": reader.classes, "functions": reader.functions, "errors": faulty}


def unit_of(root, names):
    """A path that does not exist and the text that includes all of `names`; libclang is handed both."""
    return str(root / "all_of_these.cpp"), "".join(f'#include "{root / name}"\n' for name in names)


def parse_headers(root, names, flags, precompiled):
    """Reads all headers of the tree as one unit and keeps it for the source files."""
    load_library()
    path, text = unit_of(root, names)
    unit = cindex.Index.create().parse(path, ["-x", "c++-header", *flags, "-w"], [(path, text)], ONCE)
    unit.save(precompiled)
    return read_unit(root, unit)


def parse_sources(task):
    """Reads what source files declare themselves; what they include is in `precompiled`, and was read with that.

    Loading that takes a second, so many files are one unit. Where names of unnamed namespaces clash in spite of
    cmake/batches.py, a file with an error is read again by itself.
    """
    root, names, flags, precompiled = task
    load_library()
    path, text = unit_of(root, names)
    arguments = [*flags, "-w", "-ferror-limit=0", "-include-pch", precompiled]
    try:
        unit = cindex.Index.create(excludeDecls=True).parse(path, arguments, [(path, text)], ONCE)
        found = read_unit(root, unit)
    except cindex.TranslationUnitLoadError:  # clang 14 ends on some files that read precompiled headers
        return read_alone(root, names, flags)
    if len(names) == 1:  # its names clash with those of a header that it does not include
        return read_alone(root, names, flags) if found["errors"] else found
    clashing = sorted(set(found["errors"]) & set(names))
    for kind in ("classes", "functions"):
        found[kind] = {usr: f for usr, f in found[kind].items() if f["file"] not in clashing}
    found["errors"] = {}
    for name in clashing:
        add(found, parse_sources((root, [name], flags, precompiled)))
    return found


def read_alone(root, names, flags):
    """Reads each file without precompiled headers: slower, and nothing clashes."""
    found = {"classes": {}, "functions": {}, "errors": {}}
    for name in names:
        unit = cindex.Index.create().parse(str(root / name), [*flags, "-w"], options=ONCE)
        alone = read_unit(root, unit)
        for kind in ("classes", "functions"):
            alone[kind] = {usr: f for usr, f in alone[kind].items() if f["file"] == name}
        add(found, alone)
    return found


def cache_folder():
    base = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    folder = Path(base) / "vitrine" / "code_model"
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def add(all_of, of_file):
    for usr, found in of_file["classes"].items():
        all_of["classes"].setdefault(usr, found)
    for usr, found in of_file["functions"].items():
        known = all_of["functions"].get(usr)
        if known is None or known["lines"] < found["lines"]:
            all_of["functions"][usr] = found
    all_of["errors"].update(of_file["errors"])


def sources_of(entry):
    """The sources that a command compiles: one, or those of a batch (VITRINE_UNITY)."""
    path = os.path.realpath(os.path.join(entry["directory"], entry["file"]))
    if os.sep + "Unity" + os.sep not in path:
        return [path]
    return re.findall(r'^#include "(.*)"$', Path(path).read_text(), re.M)


def commands_of(root, build):
    """The flags of each source file; the same for all, as all have to agree on what the headers mean."""
    names, flags = [], {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        for path in sources_of(entry):
            name = path[len(str(root)) + 1:]
            if path.startswith(str(root) + os.sep) and name.split("/")[0] in TOPS:
                names.append(name)
                flags |= dict.fromkeys(flags_of(entry["command"]))
    if not names:
        raise ValueError(f"{build}/compile_commands.json names no source of {root}")
    return sorted(set(names)), ["-pthread", *flags]


def model(root, build):
    """All classes and functions of base, analyzer and player; the errors of files that could not be parsed."""
    names, flags = commands_of(root, build)
    headers = sorted(str(p.relative_to(root)) for top in TOPS for p in (root / top).rglob("*.hpp"))
    units = [[str(Path(source).relative_to(root)) for source in batch]
             for batch in batches([str(root / name) for name in names], UNIT)]
    cache, known, digests = cache_folder(), {}, {}
    of_headers = cache / key_of(headers, root, flags, known, digests)
    kept = [cache / key_of(unit, root, flags, known, digests) for unit in units]
    waiting = [(unit, answer) for unit, answer in zip(units, kept) if not answer.exists()]
    with tempfile.TemporaryDirectory() as scratch:
        precompiled = str(Path(scratch) / "headers.pch")
        if waiting or not of_headers.exists():
            of_headers.write_text(json.dumps(parse_headers(root, headers, flags, precompiled)))
        with ProcessPoolExecutor(os.cpu_count()) as pool:
            tasks = [(root, unit, flags, precompiled) for unit, _ in waiting]
            for (_, answer), found in zip(waiting, pool.map(parse_sources, tasks)):
                answer.write_text(json.dumps(found))
    result = {"classes": {}, "functions": {}, "errors": {}}
    for path in (of_headers, *kept):
        add(result, json.loads(path.read_text()))
    return result
