"""tests/check_layers.py finds each kind of fault in a small tree that has it, and nothing without."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from check_layers import headers_of_one, includable, name_faults, option_faults, options_named, violations
from include_cycles import cycle_faults


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="keiko-layers-")
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name) / "keiko"

    def plant(self, **files: str):
        """Writes base__job_h="..." as base/job.h."""
        for name, text in files.items():
            *folders, stem, suffix = name.replace("__", "/").replace("_", "/").split("/")
            path = self.root.joinpath(*folders, f"{stem}.{suffix}")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)

    def assert_faults(self, found, *parts):
        """One fault for each of `parts`, which it contains."""
        found = list(found)
        self.assertEqual(len(found), len(parts), found)
        for fault, part in zip(found, parts):
            self.assertIn(part, fault)


class Rooms(Tree):
    def test_a_room_includes_lower_ones_alone(self):
        self.plant(math__a_h='#include "keiko/base/b.h"\n', base__b_h='#include "keiko/math/c.h"\n')
        self.assert_faults(violations(self.root), "base may not include math")

    def test_libraries_stay_where_they_are_adapted(self):
        self.plant(base__a_cpp="#include <fmt/core.h>\n", math__b_cpp="#include <fmt/core.h>\n")
        self.assert_faults(violations(self.root), "<fmt/core.h> belongs in ['base']")


    def test_chambers_include_lower_ones_alone(self):
        self.plant(light__fog__a_h='#include "keiko/light/tubes/b.h"\n#include "keiko/light/luminance/c.h"\n',
                   light__tubes__d_h='#include "keiko/light/e.h"\n', light__e_h='#include "keiko/light/fog/a.h"\n')
        self.assert_faults(violations(self.root), "light/fog may not include light/tubes",
                           "light/tubes may not include light (keiko/light/e.h)")

    def test_front_ends_see_the_interface_alone(self):
        self.plant(cli__a_cpp='#include "keiko/api/b.h"\n#include "keiko/workflow/c.h"\n#include "keiko/base/d.h"\n')
        self.assert_faults(violations(self.root), "cli may not include workflow")

    def test_folders_that_the_house_does_not_have(self):
        self.plant(base__deep__a_h="", attic__b_h="", main_cpp="")
        self.assert_faults(violations(self.root), "unknown room attic", "unknown chamber base/deep", "unknown room main.cpp")

    def test_a_library_stays_in_its_chamber(self):
        self.plant(files__toml__a_cpp="#include <toml++/toml.h>\n", files__scene__b_cpp="#include <toml++/toml.h>\n")
        self.assert_faults(violations(self.root), "<toml++/toml.h> belongs in ['files/toml']")


class Names(Tree):
    def test_a_name_in_two_headers(self):
        self.plant(base__a_h="namespace keiko {\nstruct Face {\n};\n}\n",
                   math__b_h="namespace KEIKO_API keiko {\nclass Face : public A {\n};\n}\n")
        self.assert_faults(name_faults(self.root), "keiko::Face is also defined in")

    def test_declarations_members_and_other_namespaces_are_none(self):
        self.plant(base__a_h="namespace keiko {\nstruct Face {\n    struct Edge {\n    };\n};\n}\n",
                   math__b_h="namespace keiko {\nstruct Face;\nstruct Edge {\n};\n}\n",
                   math__c_h="namespace keiko::cad {\nenum class Face {\n};\n}\n")
        self.assert_faults(name_faults(self.root))


class Cycles(Tree):
    def test_files_that_include_each_other_through_a_third(self):
        self.plant(base__a_h='#include "keiko/base/b.h"\n', base__b_cpp='#include "keiko/math/c.h"\n',
                   math__c_h='#include "keiko/base/a.h"\n', math__d_h='#include "keiko/math/c.h"\n')
        self.assert_faults(cycle_faults(self.root, []), "include each other: base/a, base/b, math/c")
        self.assert_faults(cycle_faults(self.root, ["a b c"]))

    def test_a_file_that_includes_its_own_header_is_none(self):
        self.plant(base__a_h="", base__a_cpp='#include "keiko/base/a.h"\n#include "keiko/base/b.h"\n',
                   base__b_h='#include <vector>\n')
        self.assert_faults(cycle_faults(self.root, []))

    def test_known_ones_may_only_shrink(self):
        self.plant(base__a_h='#include "keiko/base/b.h"\n', base__b_h='#include "keiko/base/a.h"\n')
        self.assert_faults(cycle_faults(self.root, ["a b c"]), "'a b c' is smaller now: 'a b'")
        self.assert_faults(cycle_faults(self.root, ["a b", "e f"]), "'e f' is gone")
        self.plant(base__b_h='#include "keiko/base/a.h"\n#include "keiko/base/c.h"\n',
                   base__c_h='#include "keiko/base/a.h"\n')
        self.assert_faults(cycle_faults(self.root, ["a b"]), "base/a, base/b, base/c", "'a b' is gone")


class Options(Tree):
    def test_strings_of_the_library_name_none(self):
        self.plant(base__a_cpp='throw Error("", "--view", "x");\n', main_cpp='f("see --json, --csv");\n',
                   cli__b_cpp='add_option("--view");\n')
        self.assert_faults(option_faults(self.root), "--view", "--json", "--csv")

    def test_what_is_no_option(self):
        for text in ('// throw "--view"\n', '/* "--view" */', "--i;", 'f("a--b", "----", "<!--x-->");',
                     "f('\"', --i, '\\'', \"x\");", 'R"(a { left: var(--cut) })"; f("\'--cut\'");'):
            self.assertEqual(options_named(text), [], text)

    def test_raw_strings_and_escapes_are_read(self):
        self.assertEqual(options_named('R"x(say "--a")x" "\\"--b" 1\'000 "--c-d"'), ["--a", "--b", "--c-d"])


class Headers(Tree):
    def test_of_a_single_includer(self):
        self.plant(base__a_h="", base__a_cpp='#include "keiko/base/a.h"\n',
                   base__b_cpp='#include "keiko/base/a.h"\n#include "keiko/base/c.h"\n',
                   base__c_h="", base__d_cpp='#include "keiko/base/c.h"\n')
        self.assert_faults(headers_of_one(self.root), "a.h: only base/b includes it")


class Includable(unittest.TestCase):
    def test_of_a_chamber(self):
        self.assertEqual([used for used in includable("light/tubes") if used.startswith("light")],
                         ["light/luminance", "light/penumbra", "light/tubes"])
        self.assertIn("geometry/rays", includable("light/tubes"))
        self.assertNotIn("intersect", includable("light/tubes"))


if __name__ == "__main__":
    unittest.main()
