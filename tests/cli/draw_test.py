"""`keiko draw`: line drawings as SVG, DXF and PDF."""
import re
import unittest
import xml.etree.ElementTree

from keiko_process import KeikoTest, surface

SVG = "{http://www.w3.org/2000/svg}"
BLOCK = surface("bored-block.step")
VIEWS = [f"{high}{side}" for high in ("", "high-", "standing-")
         for side in ("front", "rear", "left", "right", "three-quarter-front", "three-quarter-rear",
                      "three-quarter-front-left")]
MANY = [word for view in VIEWS for word in ("--view", view)]


class Draw(KeikoTest):
    def svg(self, *arguments: str) -> xml.etree.ElementTree.Element:
        self.succeed("draw", *arguments, "-o", "sheet.svg", "-q")
        return xml.etree.ElementTree.parse(self.folder / "sheet.svg").getroot()

    def layers(self, *arguments: str) -> dict:
        """Number of lines of each layer."""
        groups = self.svg(*arguments).iter(SVG + "g")
        return {group.get("id"): group.find(SVG + "path").get("d").count("M")
                for group in groups if group.find(SVG + "path") is not None}

    def texts(self, *arguments: str) -> list:
        return [text.text for text in self.svg(*arguments).iter(SVG + "text")]

    def test_three_views_have_dimensions_scale_and_title(self):
        texts = self.texts(BLOCK, "--title", "a block & its bore")
        for text in ("left", "front", "top", "a block & its bore", "first-angle projection"):
            self.assertIn(text, texts)
        self.assertTrue(any(re.fullmatch(r"scale (\d+:1|1:\d+), dimensions in mm", text) for text in texts), texts)

    def test_the_title_is_the_name_of_the_file(self):
        self.assertIn("bored-block.step", self.texts(BLOCK))

    def test_hidden_lines_are_removed_dashed_or_drawn(self):
        view = (BLOCK, "--view", "three-quarter-front")
        removed, dashed, wires = (self.layers(*view, *hidden)
                                  for hidden in ((), ("--hidden", "dash"), ("--wireframe",)))
        self.assertNotIn("outlines hidden", removed)
        self.assertIn("outlines hidden", dashed)
        self.assertEqual({name: dashed[name] for name in removed}, removed)
        self.assertFalse([name for name in wires if name.endswith("hidden")])

    def test_layers_are_added_and_left_out(self):
        more = self.layers(BLOCK, "--iso-curves", "3", "--section", "z=12", "--view", "top")
        self.assertIn("sections", more)
        self.assertIn("iso-curves", more)
        self.assertNotIn("seams", self.layers(BLOCK, "--without", "seams"))

    def test_what_is_left_out_takes_no_room(self):
        """Dimensions and the other layers stay where they are."""
        def layers(*without):
            return {group.get("id"): xml.etree.ElementTree.tostring(group)
                    for group in self.svg(BLOCK, *without).iter(SVG + "g") if group.get("id")}
        whole, rest = layers(), layers("--without", "outlines")
        self.assertEqual(set(whole) - set(rest), {"outlines"})
        for name, lines in rest.items():
            self.assertEqual(lines, whole[name], name)

    def test_reflection_lines_are_a_layer(self):
        rig = self.write("rig.toml", """format = "keiko-rig/1"
name = "above"
[[c_plane]]
origin = [-1000, -1000, 1500]
u = [2000, 0, 0]
v = [0, 2000, 0]
lamps = 20
diameter = 20
luminance = 9000
""")
        layers = self.layers(surface("dome.bpt"), "--rig", rig, "--view", "high-front", "--perspective")
        self.assertGreater(layers["lines"], 3)
        self.write("rig.svg", (self.folder / "rig.toml").read_text())
        run = self.keiko("draw", surface("dome.bpt"), "--rig", "rig.svg", "-o", "rig.svg", "-q")
        self.assertEqual((run.returncode, run.stderr), (2, "keiko: rig.svg: is an input as well\n"))

    def test_findings_are_numbered_and_listed(self):
        texts = self.texts(surface("seam-g0-gap.step"), "--findings", "--view", "top")
        self.assertIn("1", texts)
        self.assertTrue([text for text in texts if text.startswith("1  ") and "limit" in text], texts)

    def test_perspective_has_no_scale(self):
        texts = self.texts(BLOCK, "--perspective")
        self.assertFalse([t for t in texts if "scale 1" in t or ":1" in t or "first-angle" in t or t.endswith(" mm")])

    def test_long_lists_say_what_they_leave_out(self):
        texts = self.texts(BLOCK, "--findings", "--view", "top")
        marks = 0
        while str(marks + 1) in texts:
            marks += 1
        listed = [t for t in texts if re.match(r"\d+  \w", t)]
        more, = [t for t in texts if t.startswith("and ")]
        self.assertEqual((marks, len(listed) + int(more.split()[1])), (48, 48), texts)

    def test_the_rim_of_a_bore_seen_across_is_an_outline_all_along(self):
        """One of its faces is seen edge-on there."""
        layers = self.layers(BLOCK, "--view", "left", "--hidden", "dash")
        self.assertNotIn("creases", layers)

    def test_dxf_and_pdf_have_the_same_lines(self):
        for name in ("sheet.svg", "sheet.dxf", "sheet.pdf"):
            self.succeed("draw", BLOCK, "-o", name, "-q")
        dxf = (self.folder / "sheet.dxf").read_text("ascii").split("\n")
        pdf = (self.folder / "sheet.pdf").read_bytes()
        lines = re.sub(r"[^M]", "", "".join(re.findall(r' d="([^"]*)"', (self.folder / "sheet.svg").read_text())))
        self.assertEqual(dxf[1::2].count("POLYLINE"), len(lines))
        self.assertEqual(pdf.count(b" m\n"), len(lines))
        self.assertTrue(pdf.startswith(b"%PDF-1.5") and pdf.endswith(b"%%EOF\n"))

    def test_the_bytes_are_the_same_for_any_number_of_threads(self):
        for threads in ("1", "3"):
            self.succeed("draw", BLOCK, "-o", f"{threads}.svg", "--threads", threads, "--hidden", "dash", "-q")
        self.assertEqual((self.folder / "1.svg").read_bytes(), (self.folder / "3.svg").read_bytes())

    def test_errors_are_one_line(self):
        for arguments, reason in (
                ((BLOCK, "-o", "sheet.png"), "sheet.png: is no drawing: its name does not end in .svg, .dxf or .pdf"),
                ((BLOCK, "-o", "a.svg", "--view", "sideways"), "sideways"),
                ((BLOCK, "-o", "a.svg", "--section", "w=3"), "w=3"),
                ((BLOCK, "-o", "a.svg", "--without", "everything"), "--without"),
                ((BLOCK, "-o", "a.svg", "--preset", "class-a-outer"), "--preset"),
                ((BLOCK, "-o", "a.svg", "--rig", surface("../lightrigs/one-globe.toml")), "no lamps whose lines"),
                ((BLOCK, "-o", "a.svg", "--wireframe", "--hidden", "dash"), "--hidden"),
                ((BLOCK, "-o", "a.svg", "--paper", "A4", *MANY), "paper: has no room for 21 views"),
                ((BLOCK, "-o", "a.svg", "--paper", "A9"), "--paper")):
            run = self.keiko("draw", *arguments)
            self.assertEqual(run.returncode, 2, arguments)
            self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
            self.assertIn(reason, run.stderr)


if __name__ == "__main__":
    unittest.main()
