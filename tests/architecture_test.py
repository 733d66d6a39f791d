#!/usr/bin/env python3
"""The architecture check finds each kind of offence in a tree made for it."""
import json
import os
import tempfile
import unittest
from pathlib import Path

import architecture


def found_in(files, compiled=()):
    """The offences of a tree of these files; `compiled`: the sources whose classes and functions are looked at."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder).resolve()
        os.environ["XDG_CACHE_HOME"] = str(root / "cache")
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        commands = [{"directory": str(root), "file": name, "command": f"c++ -std=c++20 -I{root} -c {name}"} for name in compiled]
        (root / "compile_commands.json").write_text(json.dumps(commands))
        return "\n".join(architecture.offences(root, root if compiled else None))


def found_in_class(header, source=""):
    own = '#include "base/a.hpp"\n'
    return found_in({"base/a.hpp": "#pragma once\n" + header, "base/a.cpp": own + source}, ["base/a.cpp"])


def members(count):
    return " ".join(f"int m{i}_ = 0;" for i in range(count))


class ArchitectureTest(unittest.TestCase):
    def test_a_clean_tree_has_no_offence(self):
        self.assertEqual(found_in({"base/geometry/a.hpp": "", "player/layout/b.hpp": '#include "base/geometry/a.hpp"\n'}), "")

    def test_a_program_may_not_use_the_other(self):
        self.assertIn("may use base", found_in({"player/a.hpp": '#include "analyzer/b.hpp"\n', "analyzer/b.hpp": ""}))

    def test_base_uses_only_base(self):
        self.assertIn("base/ may use base only", found_in({"base/a.hpp": '#include "player/b.hpp"\n', "player/b.hpp": ""}))

    def test_a_sub_folder_never_includes_its_root(self):
        self.assertIn("program's root", found_in({"player/x/a.hpp": '#include "player/b.hpp"\n', "player/b.hpp": ""}))

    def test_a_root_header_that_pulls_in_too_many_is_found(self):
        def found(count):
            chain = {f"base/a/h{i}.hpp": f'#include "base/a/h{i + 1}.hpp"\n' for i in range(count - 1)}
            return found_in({"player/player.hpp": '#include "base/a/h0.hpp"\n', f"base/a/h{count - 1}.hpp": "", **chain})

        self.assertIn("pulls in 41 headers of the tree, at most 40", found(41))
        self.assertNotIn("pulls in", found(40))

    def test_a_cycle_of_folders_is_found(self):
        self.assertIn("a cycle of folders", found_in({
            "base/a/one.hpp": '#include "base/b/two.hpp"\n', "base/b/two.hpp": "",
            "base/b/three.hpp": '#include "base/a/four.hpp"\n', "base/a/four.hpp": ""}))

    def test_a_pure_folder_knows_no_clock_and_no_files(self):
        self.assertIn("is pure", found_in({"player/layout/a.cpp": "#include <fstream>\n"}))
        self.assertIn("is pure", found_in({"player/scene/a.cpp": "auto t = std::chrono::steady_clock::now();\n"}))

    def test_a_source_without_a_header_of_its_own_is_found(self):
        self.assertIn("no header of its own", found_in({"base/a.cpp": ""}))
        self.assertEqual(found_in({"player/main.cpp": ""}), "")

    def test_a_folder_of_many_modules_is_found(self):
        self.assertIn("26 modules", found_in({f"base/a/m{i}.hpp": "" for i in range(26)}))


class SizesTest(unittest.TestCase):
    def test_a_class_of_many_members_is_found(self):
        self.assertEqual(found_in_class(f"class A {{ public: void f(); private: {members(15)} }};"), "")
        self.assertIn("A: 16 data members", found_in_class(f"class A {{ public: void f(); private: {members(16)} }};"))

    def test_members_that_hide_in_a_struct_count(self):
        self.assertIn("A: 18 data members", found_in_class(
            f"class A {{ public: void f(); private: struct State {{ {members(10)} }}; State state_; {members(8)} }};"))

    def test_members_that_hide_behind_a_pointer_count(self):
        self.assertIn("A: 16 data members", found_in_class(
            "#include <memory>\nclass A { public: A(); ~A(); private: struct Work; std::unique_ptr<Work> work_; };",
            f"struct A::Work {{ {members(16)} }};\nA::A() = default;\nA::~A() = default;\n"))

    def test_a_record_may_have_many_members(self):
        self.assertEqual(found_in_class(f"struct Record {{ {members(30)} }};"), "")

    def test_a_struct_that_others_know_is_one_member(self):
        self.assertEqual(found_in({
            "base/r.hpp": f"#pragma once\nstruct Record {{ {members(20)} }};",
            "base/a.hpp": '#pragma once\n#include "base/r.hpp"\nclass A { public: void f(); private: Record record_; };',
            "base/a.cpp": '#include "base/a.hpp"\n'}, ["base/a.cpp"]), "")

    def test_a_class_of_many_methods_is_found(self):
        methods = " ".join(f"void f{i}();" for i in range(21))
        self.assertIn("A: 21 methods", found_in_class(f"class A {{ public: {methods} private: int a_ = 0; }};"))

    def test_functions_that_take_a_private_struct_count_as_methods(self):
        methods = " ".join(f"void f{i}();" for i in range(19))
        header = f"class A {{ public: {methods} struct State {{ int a; }}; private: State state_; }};"
        source = "".join(f"static void g{i}(A::State& s) {{ s.a = {i}; }}\n" for i in range(2))
        self.assertIn("A: 21 methods", found_in_class(header, source))

    def test_a_friend_is_found(self):
        self.assertIn("friends", found_in_class("class B;\nclass A { friend class B; int a_ = 0; };"))

    def test_a_function_of_many_parameters_is_found(self):
        self.assertIn("6 parameters", found_in_class("void f(int, int, int, int, int, int);"))

    def test_a_long_function_is_found_with_its_lambdas(self):
        body = "    auto g = [] {\n" + "        ;\n" * 38 + "    };\n    g();\n"
        self.assertIn("f: 43 lines", found_in_class("void f();", "void f() {\n" + body + "}\n"))

    def test_names_of_unnamed_namespaces_do_not_hide_each_other(self):
        long = "namespace {\nint help() {\n" + "    ;\n" * 40 + "    return 1;\n}\n}\n"
        files = {"base/a.hpp": "", "base/b.hpp": "", "base/a.cpp": '#include "base/a.hpp"\nnamespace { int help() { return 2; } }\n',
                 "base/b.cpp": '#include "base/b.hpp"\n' + long}
        self.assertIn("help: 43 lines", found_in(files, ["base/a.cpp", "base/b.cpp"]))

    def test_a_file_that_cannot_be_read_is_an_offence(self):
        self.assertIn("cannot be read", found_in_class("void f();", "void f() { no_such_thing(); }"))


if __name__ == "__main__":
    unittest.main()
