"""What tests/prose_rules.py finds, planted rule by rule."""
import tempfile
import unittest
from pathlib import Path

import prose_rules

LONG = " ".join(["it"] * 36)


def rules(name, text):
    return [(number, rule) for number, rule, _ in prose_rules.findings(name, text)]


class ProseRules(unittest.TestCase):
    def test_plain_prose_has_no_finding(self):
        self.assertEqual(rules("a.h", "/// Luminance along a ray, in cd/m² [Igehy1999].\nint a; ///< pixels\n"), [])
        self.assertEqual(rules("a.md", "# Rays\n\nA ray meets a patch.\n\n- one\n- two\n"), [])

    def test_a_docstring_without_a_subject_is_found(self):
        for first in ("Of what", "The same", "What", "Where", "Those", "That", "As", "But", "Nothing"):
            self.assertEqual(rules("a.h", f"\n/// {first} is there.\nint a;\n"), [(2, "subject")], first)
        self.assertEqual(rules("a.cpp", "// What a comment inside says is free.\n"), [])

    def test_private_idiom_is_found_in_sources_and_pages(self):
        for idiom in ("told", "tells of", "amid", "asked for", "looked at", "of which", "but for", "so many",
                      "as it has it", "what of", "takes it that", "hang lamps", "seen past", "is off by"):
            for name, text in {"a.h": f"/// A hit\n/// {idiom} here.\n", "b.cpp": f"int a; ///< {idiom} here\n",
                               "c.md": f"A hit {idiom} here.\n"}.items():
                self.assertEqual([rule for _, rule in rules(name, text)], ["idiom"], (name, idiom))

    def test_a_sentence_of_more_than_35_words_is_found(self):
        self.assertEqual(rules("a.md", f"\n{LONG}.\n"), [(2, "sentence")])
        self.assertEqual(rules("a.h", f"/// {LONG[:60]}\n/// {LONG[60:]}.\n"), [(1, "sentence")])
        self.assertEqual(rules("a.md", f"{LONG[3:]}.\nIt {LONG[6:]}.\n"), [])

    def test_a_paragraph_of_more_than_110_words_is_found(self):
        block = "\n".join(["One two three four five six seven eight nine ten."] * 11)
        self.assertEqual(rules("a.md", block + "\n"), [])
        self.assertEqual(rules("a.md", block + "\nEleven.\n"), [(1, "paragraph")])
        self.assertEqual(rules("a.md", block + "\n- Eleven.\n"), [])

    def test_a_line_of_more_than_120_characters_is_found(self):
        self.assertEqual(rules("a.md", "```\n" + "x" * 121 + "\n```\n"), [(2, "line")])
        for line in ("x" * 120, "| " + "x" * 121, "[a](" + "x" * 121 + ")"):
            self.assertEqual(rules("a.md", line + "\n"), [], line)

    def test_a_source_that_cannot_be_looked_up_is_found(self):
        self.assertEqual(rules("a.cpp", "// By physics 4.1.\n"), [(1, "citation")])
        self.assertEqual(rules("a.md", "As in [003].\n"), [(1, "citation")])

    def test_code_and_tables_of_pages_are_left_alone(self):
        self.assertEqual(rules("a.md", f"```\n{LONG}\n```\n\n| {LONG} |\n\n    told\n"), [])

    def test_faults_name_file_and_line(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "src").mkdir()
            (root / "README.md").write_text("Told.\n", encoding="utf-8")
            (root / "src/a.h").write_text("\n/// Where it is.\n", encoding="utf-8")
            (root / "src/b.txt").write_text("/// Where it is.\n", encoding="utf-8")
            self.assertEqual(prose_rules.faults(root),
                             ["README.md:1: idiom: Told", "src/a.h:2: subject: Where it is."])


if __name__ == "__main__":
    unittest.main()
