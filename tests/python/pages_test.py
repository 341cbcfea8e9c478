"""What a notebook shows of results: the verdict first, every text escaped, long tables cut short."""
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

import keiko
from keiko import _pages

ROOT = Path(__file__).resolve().parents[2]
SEAM = ROOT / "surfaces/seam-g1-angle.step"
TUNNEL = ROOT / "lightrigs/tunnel-12.toml"


class Page(HTMLParser):
    """The text of a page, its rows of cells, and the elements that it leaves open."""

    def __init__(self, page: str):
        super().__init__()
        self.words, self.rows, self.open = [], [], []
        self.feed(page)
        self.text = " ".join(self.words)

    def handle_starttag(self, tag, attrs):
        self.open.append(tag)
        if tag == "tr":
            self.rows.append([])

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        self.words.append(data)
        if self.open[-1] in ("td", "th"):
            self.rows[-1].append(data)


def shown(result) -> Page:
    page = Page(result._repr_html_())
    assert not page.open, page.open
    return page


class PagesTest(unittest.TestCase):
    def test_bodies_show_name_size_and_faces(self):
        for body, name in ((keiko.load(SEAM), str(SEAM)), (keiko.open_scene(SEAM), SEAM.name)):
            page = shown(body)
            self.assertEqual(page.words[0], name)
            sides = body.bounds[1] - body.bounds[0]
            self.assertIn(f"2 faces, {sides[0]:.6g} x {sides[1]:.6g} x {sides[2]:.6g} mm, 0 lost faces", page.text)
            self.assertEqual([row[:2] for row in page.rows[1:]], [["1", "left"], ["2", "right"]])

    def test_nameless_faces_have_no_rows(self):
        page = shown(keiko.load(ROOT / "surfaces/dome.bpt"))
        self.assertIn("4 faces, ", page.text)
        self.assertEqual(page.rows, [])

    def test_names_are_escaped(self):
        body = keiko.load(SEAM.read_bytes(), name="<b>&\"fender\"</b>")
        self.assertIn("&lt;b&gt;&amp;", body._repr_html_())
        self.assertEqual(shown(body).words[0], "<b>&\"fender\"</b>")

    def test_long_tables_are_cut_and_say_so(self):
        page = Page(_pages.table(["a", "b"], ([i, "<"] for i in range(_pages.MOST_ROWS + 3))))
        self.assertEqual(len(page.rows), 1 + _pages.MOST_ROWS)
        self.assertEqual(page.words[-1], "and 3 more")
        self.assertEqual(_pages.table(["a"], []), "")

    def test_placements_show_coverage_and_rig(self):
        placed = keiko.place(SEAM, views="top")
        page = shown(placed)
        self.assertEqual(page.words[0], f"{placed.coverage:.1%} covered")
        self.assertIn(placed.rig.text, page.words)

    def test_lines_show_the_worst_crossings_first(self):
        lines = keiko.lines(SEAM, TUNNEL, views=["high-left"])
        page = shown(lines)
        self.assertEqual(page.words[0], lines.verdict)
        crossings = lines.to_dict()["crossings"]
        self.assertEqual(len(page.rows), 1 + len(crossings))
        self.assertGreater(len(crossings), 1)
        worst = max(crossings, key=lambda crossing: crossing["severity"])
        self.assertEqual(page.rows[1][-1], ", ".join(f"{x:.1f}" for x in worst["place"]))

    def test_comparisons_show_each_check_and_what_changed(self):
        compared = keiko.compare(ROOT / "surfaces/seam-g0-gap.step", SEAM)
        page = shown(compared)
        self.assertEqual(page.words[0], "different")
        for check in compared.to_dict()["checks"]:
            self.assertIn(["within" if check["within"] else "beyond", check["name"], check["message"]], page.rows)
        self.assertEqual([row[0] for row in page.rows[-2:]], ["new", "fixed"])

    def test_meshes_show_their_error_and_their_fields(self):
        mesh = keiko.mesh(ROOT / "surfaces/rational-sphere.step", ["mean"], deviation=0.5)
        page = shown(mesh)
        self.assertEqual(page.words[0], f"{len(mesh.triangles)} triangles")
        self.assertIn(f"within {mesh.deviation:.3g} mm", page.text)
        self.assertEqual(page.rows[1], ["mean", "-0.01", "-0.01"])

    def test_regressions_show_their_fixtures(self):
        with tempfile.TemporaryDirectory() as folder:
            found = keiko.regress(ROOT / "surfaces", folder, only=["seam-g0-gap"])
        page = shown(found)
        self.assertEqual(page.words[0], found.state)
        self.assertEqual(page.rows[1], [found.state, "seam-g0-gap"])


if __name__ == "__main__":
    unittest.main()
