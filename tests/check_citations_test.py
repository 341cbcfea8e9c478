"""What tests/check_citations.py finds, planted in a tree of a few files."""
import tempfile
import unittest
from pathlib import Path

import check_citations

REFERENCES = """# References

- [Igehy1999] H. Igehy: Tracing Ray Differentials.
- [LM-63] LM-63, Standard File Format.

## Further reading

- [Whitted1980] T. Whitted: An Improved Illumination Model.
"""
PAGE = """# Theory

## Rays, and *their* footprints

As in [Igehy1999, section 3]; files are those of [LM-63].
"""


class Citations(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.write("docs/references.md", REFERENCES)
        self.write("docs/theory.md", PAGE)
        self.write("README.md", "[Theory](docs/theory.md)\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def faults(self):
        return check_citations.all_faults(self.root)

    def finds(self, name, text, *faults):
        self.write(name, text)
        self.assertEqual(self.faults(), list(faults), text)

    def test_all_hold_where_none_is_planted(self):
        self.assertEqual(self.faults(), [])
        self.finds("src/a.h", "/// Ray [Igehy1999,\n/// eq. 7] (docs/theory.md#rays-and-their-footprints).\n"
                              "int a; ///< mm [LM-63]\n")

    def test_a_key_that_dangles_is_found_in_every_kind_of_file(self):
        for name, text in {
            "src/a.h": "\n/// Ray of [Igehi1999].\n",
            "src/b.cpp": "\nint b; ///< of [Igehi1999, eq. 2]\n",
            "tests/c.py": '\n"""Rays\nof [Igehi1999]."""\n',
            "tests/d.py": "\nrays = 1  # [Igehi1999]\n",
            "docs/e.md": "\nRays [Igehi1999].\n",
            "lightrigs/f.toml": "\nlamps = 1 # [Igehi1999]\n",
        }.items():
            line = 3 if name == "tests/c.py" else 2
            self.finds(name, text, f"{name}:{line}: no source in docs/references.md: [Igehi1999]")
            (self.root / name).unlink()

    def test_what_is_no_citation_is_left_alone(self):
        self.finds("src/a.cpp", '// p[Index], [0, 1], [begin, end]\nauto b = a[Igehi1999]; // "[Igehi1999]"\n'
                                'const char* text = "// [Igehi1999]"; [[nodiscard]] int c;\n')
        self.finds("tests/b.py", '"""Runs.\n\nusage: b.py [KEIKO]\n"""\nc = d[Igehi1999]\n'
                                 'e = """[Igehi1999]"""\nf = (\n    "[Igehi1999]",\n)\n')
        self.finds("docs/c.md", "[Igehi1999](theory.md) `[Igehi1999]`\n```\n[Igehi1999]\n```\n")

    def test_a_page_or_heading_that_is_not_there_is_found(self):
        self.finds("src/a.h", "// docs/theory/rays.md\n\n// docs/theory.md#rays\n",
                   "src/a.h:1: no such page: docs/theory/rays.md",
                   "src/a.h:3: no such heading: docs/theory.md#rays")

    def test_an_equation_of_no_source_is_found(self):
        self.finds("src/a.h", "/// By eq. (2.5).\n/// By [Igehy1999, eq. 2].\n",
                   "src/a.h:1: an equation of no source: eq. (2")

    def test_notes_that_are_not_published_are_found(self):
        self.finds("src/a.h", "/// Nearest ray (physics\n/// 4.1).\n", "src/a.h:1: not published: physics 4")
        self.finds("src/a.h", "/// As in [003].\n", "src/a.h:1: not published: [003]")

    def test_a_source_that_nothing_cites_is_found(self):
        self.finds("docs/theory.md", PAGE.replace("[LM-63]", "LM-63"),
                   'docs/references.md: LM-63 is cited nowhere: "Further reading"?')

    def test_further_reading_that_is_cited_is_found(self):
        self.finds("src/a.h", "/// Rays [Whitted1980].\n",
                   'docs/references.md: Whitted1980 is cited: not "Further reading"')

    def test_two_sources_of_one_key_are_found(self):
        self.finds("docs/references.md", REFERENCES + "- [Igehy1999] H. Igehy: another.\n",
                   "docs/references.md: two sources are called Igehy1999",
                   'docs/references.md: Igehy1999 is cited: not "Further reading"')


if __name__ == "__main__":
    unittest.main()
