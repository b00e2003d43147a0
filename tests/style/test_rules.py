# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every check of style must be able to fail: each is shown something good and something bad."""

import json
import tempfile
import unittest
from pathlib import Path

import documentation
import plans
import rules
import style
import tidy

ROOMS = {"source/rooms.txt": "# a list\nutilities\ndrive\nelement contact\nbodies\n"}


def header(*names):
    return "".join(f"#include <{name}>\n" for name in names)


class Layering(unittest.TestCase):
    def violations(self, **files):
        tree = {f"include/chaindrive/{name.replace('__', '/')}.h": text for name, text in files.items()}
        return rules.layering({**ROOMS, **tree})

    def test_rooms_to_the_left_are_allowed(self):
        self.assertEqual(self.violations(contact__a=header("chaindrive/drive/b.h", "chaindrive/contact/c.h")), [])

    def test_rooms_to_the_right_and_on_the_same_line_are_not(self):
        self.assertEqual(len(self.violations(drive__a=header("chaindrive/contact/b.h"))), 1)
        self.assertEqual(len(self.violations(element__a=header("chaindrive/contact/b.h"))), 1)

    def test_unknown_rooms_and_quoted_includes_are_not(self):
        self.assertEqual(len(self.violations(attic__a="")), 1)
        self.assertEqual(len(self.violations(drive__a='#include "b.h"\n')), 1)

    def test_drive_knows_no_mpi_not_even_through_another_header(self):
        self.assertEqual(len(self.violations(drive__a=header("deal.II/dofs/dof_handler.h"))), 1)
        self.assertEqual(
            len(self.violations(drive__a=header("chaindrive/utilities/b.h"), utilities__b=header("deal.II/base/mpi.h"))), 1
        )
        self.assertEqual(self.violations(contact__a=header("deal.II/base/mpi.h")), [])

    def test_rules_of_rooms_that_are_gone_are_not(self):
        self.assertEqual(len(rules.layering({"source/rooms.txt": ROOMS["source/rooms.txt"].replace("drive", "attic")})), 1)


class Files(unittest.TestCase):
    def assert_rule(self, rule, good, bad):
        self.assertEqual(rule(good), [])
        for path, text in bad.items():
            self.assertTrue(rule({**good, path: text}), f"{path} was accepted")

    def test_licence(self):
        self.assert_rule(
            rules.licence,
            {
                "a.cc": f"// {rules.LICENCE}\nint a;\n",
                "b.prm": f"# {rules.LICENCE}\n",
                "run": f"#!/bin/sh\n# {rules.LICENCE}\n",
                "c.md": "no licence\n",
            },
            {"a.h": "int a;\n", "d.prm": "", "tool": "#!/bin/sh\nls\n", "e.cc": f"# {rules.LICENCE}\n"},
        )

    def test_imports(self):
        self.assert_rule(
            rules.imports,
            {"a.py": "import sys\nsys.argv\nos.path.join()\n", "b.cc": "// sys." + "path\n"},
            {"c.py": "sys." + "path.insert(0, '')\n", "Snakefile": "sys." + "path[:0] = ['']\n",
             "d.py": "from sys " + "import path\n", "e.md": "    sys." + "path.append('python')\n"},
        )

    def test_halves(self):
        doubled = "mass *= part.half ? 2. : 1.;"
        self.assert_rule(
            rules.halves,
            {
                "source/mesh/a.cc": "force = symmetry.whole_force(force);\npower += part.half ? 2 : 1;\nx = 0.5 * half;",
                "include/chaindrive/utilities/mirror_symmetry.h": doubled,
                "tests/mesh/b.cc": doubled,
            },
            {
                "source/mesh/c.cc": doubled,
                "source/mesh/d.cc": "x = s.is_half() ? 0.5 : 1.;",
                "include/chaindrive/scene/e.h": "if (scene.half)\n  stiffness *= 0.5;",
            },
        )

    def test_length(self):
        self.assert_rule(
            rules.length,
            {"a.cc": "\n" * rules.MAX_LINES, "a.output": "\n" * 2 * rules.MAX_LINES},
            {"b.cc": "\n" * (rules.MAX_LINES + 1), "b.output": "0" * (rules.MAX_BYTES + 1)},
        )

    def test_words(self):
        self.assert_rule(
            rules.words,
            {"a.md": "see https://www.dealii.org/ and prm/tmp/a.prm, $ROOT/work/b\n"},
            {
                "b.cc": '"/ho' + 'me/somebody/a.prm"',
                "c.md": "cd /wo" + "rk/here",
                "d.cc": "// TO" + "DO: later",
                "e.md": "http" + "://registry.example/x",
                "f.cc": "int a; \n",
                "g.cc": "<<<<" + "<<< ours\n",
                "h.prm": "# takes @TI" + "ME@ s\n",
            },
        )

    def test_links(self):
        self.assert_rule(
            rules.links,
            {"doc/a.md": "[b](b.md#part) [up](../README.md) [folder](../prm/) [web](https://www.dealii.org)", "doc/b.md": "",
             "README.md": "[a](doc/a.md)", "prm/paper/a.prm": ""},
            {"doc/c.md": "[gone](gone.md)"},
        )

    def test_prose(self):
        long = "word " * 20 + "end"
        self.assert_rule(
            rules.prose,
            {
                "a.md": f"# {long}\n\n{long[:100]}\n\n| {long} |\n\n```\n{long}\n```\n{'x' * 101}\n",
                "doc/parameters.md": long,
                "a.cc": f"// {long}\n",
            },
            {"b.md": long, "c.md": f"```\na\n```\n{long}\n", "d.md": f"- item\n  {long}\n"},
        )

    def test_results_documented(self):
        schema = {"histories": {"links/force": {}, "links/force_peak": {}}, "summary": {"events/*/time": {}, "steps": {}}}
        self.assert_rule(
            rules.results_documented,
            {"doc/output.md": "`force` and `..._peak`\n\n```python\n`\n```\n\n`time`, `steps`\n", "python/chaindrive/schema.json": json.dumps(schema)},
            {"doc/output.md": "`force`, `time` and `..._peak`, ```steps```, steps\n"},
        )

    def test_prm_listed(self):
        self.assert_rule(
            rules.prm_listed,
            {"README.md": "| `prm/paper/a.prm` |", "prm/paper/a.prm": "", "tests/runs/b.prm": ""},
            {"prm/paper/c.prm": ""},
        )

    def test_packages(self):
        listed = "# a list\nbuild   libone-dev  # why\nstudy   python3-two\nreport  python3-two\n"
        good = {"packaging/packages.txt": listed, "CMakeLists.txt": "Debian's libone-dev has it.", "source/a.cc": '"python3-two"', "scripts/b.py": "python3-vtk9"}
        self.assert_rule(rules.packages, good, {"source/a.cc": "python3-three"})
        self.assert_rule(rules.packages, good, {"packaging/packages.txt": listed + "study   python3-two   # twice\n"})
        self.assert_rule(rules.packages, good, {"packaging/packages.txt": listed + "study: snakemake\n"})
        self.assert_rule(rules.packages, good, {"packaging/packages.txt": listed + "study   four  # a list; of CMake\n"})

    def test_field_words(self):
        self.assert_rule(
            rules.field_words,
            {
                "source/a.cc": "/// The part deflects by its modes.\ncritical_time_step(); // a table of shape functions\nvalues.take_all();\n",
                "source/parameters/old_names.cc": '{"Model/Half model", "Model/Symmetry model"}, {"stable_step"}',
                "python/b.py": "numbers.take(1)  # a sound drive\n",
                "tests/c.cc": "// parts give way\n",
            },
            {
                "include/d.h": "/// The part gives\n/// way a little.\n",
                "source/e.cc": "bool is_dealt_out();",
                "source/f.cc": "double x = stable_step();",
                "source/g.cc": "force.take(node);",
                "source/h.cc": "// of a half model",
                "source/i.cc": "bool there_ = false;",
                "python/j.py": "# what sound runs stay below\n",
                "scripts/k.py": "largest = summary['overlap_max']\n",
            },
        )

    def test_formatting(self):
        with tempfile.TemporaryDirectory() as folder:
            good, bad = Path(folder, "good.cc"), Path(folder, "bad.cc")
            good.write_text("int a = 1;\n")
            bad.write_text("int   a=1;\n")
            self.assertEqual(style.clang_format([good]), [])
            self.assertTrue(style.clang_format([bad]))


class Python(unittest.TestCase):
    GOOD = '"""A module."""\n\n\ndef twice(a: float) -> float:\n    """Twice a number."""\n    return 2 * a\n'

    def assert_checker(self, check, *bad):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "module.py")
            file.write_text(self.GOOD)
            self.assertEqual(check([file]), [])
            for old, new in bad:
                file.write_text(self.GOOD.replace(old, new))
                self.assertTrue(check([file]), f"{new} was accepted")

    def test_names(self):
        self.assert_checker(style.pyflakes, ("\n\n\ndef", "\nimport os\n\n\ndef"), ("2 * a", "2 * b"))

    def test_docstrings(self):
        self.assert_checker(style.pydocstyle, ('    """Twice a number."""\n', ""), ("a number.", "a number"),
                            ("a number.", "a number.\n    Of any kind.\n    "))

    def test_types(self):
        self.assert_checker(style.mypy, ("a: float", "a"), ("2 * a", "str(a)"))


class Repository(unittest.TestCase):
    def test_both_ways_of_listing_see_the_sources(self):
        walked = style.found_by_walking()
        self.assertIn("source/rooms.txt", walked)
        self.assertFalse([name for name in walked if name.startswith((".git/", "build/"))])
        listed = style.listed_by_git()
        self.assertTrue(not listed or "source/rooms.txt" in listed)


class Documentation(unittest.TestCase):
    def test_a_missing_line_is_noticed(self):
        self.assertEqual(documentation.difference("a\nb\n", "a\nb\n"), [])
        self.assertTrue(documentation.difference("a\n", "a\nb\n"))


class Plans(unittest.TestCase):
    def test_a_program_that_refuses_is_noticed(self):
        drive = "prm/paper/simple.prm"
        self.assertEqual(plans.refused("true", [drive], "parts"), {})
        self.assertEqual(plans.refused("false", [drive], "parts"), {f"plan {drive}": ""})
        study = "prm/studies/fidelity.prm"
        self.assertEqual(len(plans.refused("false", [study], "parts")), 2)  # and its quick form


class Tidy(unittest.TestCase):
    def lint(self, text):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "a.cc")
            file.write_text(text)
            return tidy.lint(file, ["-std=c++17"]), tidy.compiles(file, ["-std=c++17"])

    def test_a_clean_file_passes(self):
        self.assertEqual(self.lint("int twice(int a) { return 2 * a; }\n"), ("", ""))

    def test_a_suspicious_one_does_not(self):
        complaint, error = self.lint("double half(int a) { return a / 2; }\n")
        self.assertIn("bugprone", complaint)
        self.assertEqual(error, "")

    def test_nor_one_that_does_not_include_what_it_needs(self):
        _, error = self.lint("std::vector<int> a;\n")
        self.assertIn("error", error)

    def test_a_file_that_changed_is_looked_at_again(self):
        with tempfile.TemporaryDirectory() as folder:
            record = Path(folder, "passed")
            self.assertEqual(tidy.recorded(record), set())
            tidy.write_record(record, {"b.h": tidy.digest("checks", "b.h", "int b;"), "a.cc": tidy.digest("checks", "a.cc", "")})
            passed = tidy.recorded(record)
            self.assertEqual(record.read_text().split()[1::2], ["a.cc", "b.h"])
        self.assertIn(tidy.digest("checks", "b.h", "int b;"), passed)
        for change in (("checks", "b.h", "int c;"), ("no checks", "b.h", "int b;"), ("checks", "c.h", "int b;")):
            self.assertNotIn(tidy.digest(*change), passed)


if __name__ == "__main__":
    unittest.main()
