"""Analyses that keiko view saves: read by its commands, followed to another revision, refused where they are wrong."""
import json
import unittest
from pathlib import Path

from keiko_process import KeikoTest, SOURCE, surface
from view_test import Server

try:
    import jsonschema
except ImportError:
    jsonschema = None

SCHEMA = SOURCE / "docs/schema/keiko-analysis.schema.json"
HOOD = surface("hood.step")
RIG = """format = "keiko-rig/1"
name = "one row"

[[c_plane]]
origin = [-3000, -2000, 3000]
u = [6000, 0, 0]
v = [0, 4000, 0]
lamps = 10
diameter = 60
luminance = 9000
"""


def camera(eye: list, **more) -> dict:
    return {"projection": "perspective", "eye": eye, "target": [560, 0, 720], "up": [0, 0, 1], "vertical_fov": 28,
            "orthographic_height": 0, "width": 96, "height": 54, **more}


def analysis(**more) -> dict:
    return {"format": "keiko-analysis/1",
            "views": [{"name": "slant", "look": "zebra", "camera": camera([-2000, -1500, 1800])},
                      {"name": "high", "look": "lamps", "camera": camera([-900, 700, 2500])}],
            "sections": ["y=120"], "rig": RIG.splitlines(), **more}


class AnalysisTest(KeikoTest):
    def setUp(self):
        super().setUp()
        self.write("rig.toml", RIG)
        self.save(analysis())

    def save(self, value: dict, name: str = "a.json"):
        if jsonschema:
            jsonschema.validate(value, json.loads(SCHEMA.read_text()))
        self.write(name, json.dumps(value))

    def view_file(self, view: dict, name: str) -> str:
        seen = view["camera"]
        return self.write(name, 'format = "keiko-view/1"\n' + "".join(
            f"{key} = {json.dumps(seen[key])}\n" for key in ("eye", "target", "up", "vertical_fov")))

    def bytes_of(self, name: str) -> bytes:
        return (self.folder / name).read_bytes()

    def revised(self, *changes: tuple) -> str:
        """The hood with other texts in its file."""
        text = Path(HOOD).read_text()
        for before, after in changes:
            self.assertIn(before, text)
            text = text.replace(before, after)
        return self.write("revised.step", text)

    def faces_seen(self, model: str, *arguments: str) -> dict:
        """Names of the faces that a server's analysis hides, by their numbers; and its remarks."""
        server = Server(self.folder, model, "--analysis", "a.json", *arguments)
        self.addCleanup(server.close)
        shown = json.loads(server.ask("GET", "/analysis")[2])
        return {face["face"]: face.get("name", "") for face in shown["analysis"]["hidden"]}, shown["remarks"]


class Commands(AnalysisTest):
    def test_render_shows_the_first_view_in_its_look_and_others_by_name(self):
        slant, high = analysis()["views"]
        self.succeed("render", HOOD, "--analysis", "a.json", "-o", "a.png")
        self.succeed("render", HOOD, "--view", self.view_file(slant, "slant.toml"), "--look", "zebra", "--size", "96x54",
                     "-o", "b.png")
        self.assertEqual(self.bytes_of("a.png"), self.bytes_of("b.png"))
        self.succeed("render", HOOD, "--analysis", "a.json", "--view", "high", "-o", "a.png")
        self.succeed("render", HOOD, "--view", self.view_file(high, "high.toml"), "--rig", "rig.toml", "--size", "96x54",
                     "-o", "b.png")
        self.assertEqual(self.bytes_of("a.png"), self.bytes_of("b.png"))
        self.succeed("render", HOOD, "--analysis", "a.json", "--look", "draft", "--size", "48x27", "-o", "a.png")
        self.succeed("render", HOOD, "--view", "slant.toml", "--look", "draft", "--size", "48x27", "-o", "b.png")
        self.assertEqual(self.bytes_of("a.png"), self.bytes_of("b.png"))

    def test_render_colours_sections_along_the_direction_of_the_view(self):
        value = analysis()
        value["views"][0].update(look="curvature:section=0.01", across=[1, 2, 0.5])
        self.save(value)
        self.succeed("render", HOOD, "--analysis", "a.json", "-o", "a.png")
        slant = self.view_file(value["views"][0], "slant.toml")
        look = ("render", HOOD, "--view", slant, "--look", "curvature:section=0.01", "--size", "96x54")
        self.succeed(*look, "--section", "1,2,0.5", "-o", "b.png")
        self.succeed(*look, "-o", "c.png")
        self.assertEqual(self.bytes_of("a.png"), self.bytes_of("b.png"))
        self.assertNotEqual(self.bytes_of("a.png"), self.bytes_of("c.png"))
        self.succeed("render", HOOD, "--analysis", "a.json", "--section", "0,1,0", "-o", "a.png")
        self.assertEqual(self.bytes_of("a.png"), self.bytes_of("c.png"))

    def test_render_leaves_out_hidden_faces_as_the_viewer_does(self):
        self.save(analysis(hidden=[{"face": 2, "name": "dome"}]))
        self.succeed("render", HOOD, "--analysis", "a.json", "--view", "high", "-o", "a.png")
        server = Server(self.folder, HOOD, "--analysis", "a.json", "--view", "high")
        self.addCleanup(server.close)
        self.assertEqual(server.ask("POST", "/still", "hidden = [2]")[2], self.bytes_of("a.png"))
        self.assertNotEqual(server.ask("POST", "/still")[2], self.bytes_of("a.png"))

    def test_frames_are_made_anew_after_the_analysis_has_changed(self):
        arguments = ("render", surface("turning-dots-scene.toml"), "--analysis", "a.json", "--view", "high", "--frames",
                     "0:0", "--resume", "-o", "f.png", "-q")
        self.save(analysis(rig=[*RIG.splitlines(), "ambient = 0"][:1] + RIG.splitlines()[1:]))
        self.succeed(*arguments)
        before = self.bytes_of("f-0000.png")
        changed = analysis()
        changed["views"][1]["camera"]["eye"][0] = -1500
        self.save(changed)
        self.succeed(*arguments)
        self.assertNotEqual(self.bytes_of("f-0000.png"), before)

    def test_inspect_has_its_views_lamps_sections_and_notes_and_writes_it_on(self):
        self.save(analysis(notes=[{"text": "look here", "place": [560, 0, 812]}], hidden=[{"face": 1, "name": "wing-left"}]))
        run = self.keiko("inspect", HOOD, "--analysis", "a.json", "-o", "out", "-q")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertRegex(run.stdout, r"note on face 2 at 560\.\d\d, -?0\.00, 809\.\d\d mm: look here\n$")
        report = json.loads(self.bytes_of("out/report.json"))
        self.assertEqual([view["name"] for view in report["views"]], ["slant", "high"])
        self.assertEqual(report["views"][1]["camera"], analysis()["views"][1]["camera"])
        self.assertIn("a.json", [file["path"] for file in report["inputs"]])
        self.assertEqual([(note["text"], note["face"]) for note in report["notes"]], [("look here", 2)])
        self.assertIn("look here", self.bytes_of("out/report.html").decode())
        self.assertEqual(json.loads(self.bytes_of("out/combs.json"))["curves"][0]["name"], "y=120")
        self.succeed("render", HOOD, "--analysis", "a.json", "--view", "high", "--rig", "out/rig.toml", "-o", "high.png")
        self.keiko("inspect", HOOD, "--analysis", "out/analysis.json", "-o", "again", "-q")
        for name in ("analysis.json", "rig.toml", "slant.png", "high.png"):
            self.assertEqual(self.bytes_of(f"out/{name}"), self.bytes_of(f"again/{name}"), name)
        written = json.loads(self.bytes_of("out/analysis.json"))
        self.save(written, "written.json")
        self.assertEqual(written["views"], analysis()["views"])
        self.assertEqual(written["notes"][0]["face"], 2)

    def test_an_inspected_folder_opens_with_its_analysis(self):
        self.save(analysis(hidden=[{"face": 2, "name": "dome"}]))
        self.keiko("inspect", HOOD, "--analysis", "a.json", "-o", "out", "-q")
        server = Server(self.folder, "out")
        self.addCleanup(server.close)
        shown = json.loads(server.ask("GET", "/analysis")[2])
        self.assertEqual([face["face"] for face in shown["analysis"]["hidden"]], [2])
        scene = json.loads(server.ask("GET", "/scene")[2])
        self.assertEqual((scene["view"], scene["rig"]["name"]), ("slant", "one row"))

    def test_compare_shows_both_bodies_in_its_views_and_tells_of_each_what_is_gone(self):
        self.save(analysis(hidden=[{"face": 2, "name": "dome", "place": [0, 0, 9000]}]))
        revised = self.revised(("'dome'", "'roof'"))
        run = self.keiko("compare", HOOD, revised, "--analysis", "a.json", "-o", "out", "-q")
        # The pictures differ by the dome, which is hidden in one of them.
        self.assertEqual((run.returncode, run.stderr.count("\n")), (1, 1), run.stderr)
        self.assertIn(f"{revised}: hidden face 2 (dome): is not hidden", run.stderr)
        found = json.loads(self.bytes_of("out/compare.json"))
        self.assertEqual([view["view"] for view in found["views"]], ["slant", "high"])
        self.assertIn('name = "one row"', (self.folder / "out/rig.toml").read_text())


class Following(AnalysisTest):
    """What hidden faces and notes of an analysis are on another revision."""

    def place_on(self, name: str) -> list:
        """A place inside a face of the hood, as the server saves it."""
        server = Server(self.folder, HOOD)
        self.addCleanup(server.close)
        number = {"wing-left": 1, "dome": 2, "wing-right": 3}[name]
        saved = json.loads(server.ask("POST", "/analysis", f"hidden = [{number}]")[2])
        self.assertEqual([(face["face"], face["name"]) for face in saved["hidden"]], [(number, name)])
        return saved["hidden"][0]["place"]

    def test_a_face_is_followed_by_its_name_even_if_numbers_change(self):
        self.save(analysis(hidden=[{"face": 7, "name": "wing-right"}]))
        self.assertEqual(self.faces_seen(HOOD), ({3: "wing-right"}, []))

    def test_a_face_that_lost_its_name_is_followed_by_its_place(self):
        place = self.place_on("wing-right")
        self.save(analysis(hidden=[{"face": 7, "name": "wing-right", "place": place}]))
        self.assertEqual(self.faces_seen(self.revised(("'wing-right'", "'side'"))), ({3: "side"}, []))

    def test_of_faces_that_share_a_name_the_one_at_the_place_is_meant(self):
        place = self.place_on("wing-right")
        self.save(analysis(hidden=[{"face": 1, "name": "wing", "place": place}]))
        revised = self.revised(("'wing-right'", "'wing'"), ("'wing-left'", "'wing'"))
        self.assertEqual(self.faces_seen(revised), ({3: "wing"}, []))

    def test_what_is_gone_is_told_in_one_line_each(self):
        far = [0, 0, 9000]
        self.save(analysis(hidden=[{"face": 1, "name": "door"}, {"face": 2, "place": far}],
                           notes=[{"text": "mind this", "place": far}]))
        hidden, remarks = self.faces_seen(HOOD)
        self.assertEqual(hidden, {})
        self.assertEqual([remark["entity"] for remark in remarks],
                         ["hidden face 1 (door)", "hidden face 2", 'note "mind this"'])
        run = self.keiko("render", HOOD, "--analysis", "a.json", "-o", "a.png", "-q")
        self.assertEqual((run.returncode, run.stderr.count("\n")), (0, 3), run.stderr)

    def test_notes_lie_on_the_surface_nearby(self):
        self.save(analysis(notes=[{"text": "mind this", "place": [560, 0, 812], "face": 99}]))
        server = Server(self.folder, HOOD, "--analysis", "a.json")
        self.addCleanup(server.close)
        note, = json.loads(server.ask("GET", "/analysis")[2])["analysis"]["notes"]
        eye = [560.0, 0.0, 2000.0]
        ray = ",".join(map(str, (*eye, *(p - e for p, e in zip(note["place"], eye))))) + "\n"
        run = self.keiko("trace", HOOD, "--out", "t,face", input=ray)
        t, face = run.stdout.splitlines()[1].split(",")
        self.assertAlmostEqual(float(t), 1, delta=1e-6)
        self.assertEqual((int(face), note["face"], note["text"]), (2, 2, "mind this"))


class Errors(AnalysisTest):
    def test_what_is_wrong_is_told_with_its_field(self):
        def changed(change) -> str:
            value = analysis(hidden=[{"face": 1, "name": "a"}], notes=[{"text": "t", "place": [0, 0, 0]}])
            change(value)
            return json.dumps(value)
        for text, reason in (
                ("{", "no JSON at line 1, column 2"),
                ('{"format": "keiko-analysis/1",\n "views": [}', "no JSON at line 2, column 12"),
                ("{}", "is not of the format keiko-analysis/1"),
                (changed(lambda a: a.update(looks=[])), 'unknown key "looks"'),
                (changed(lambda a: a.update(views={})), "views: is no array"),
                (changed(lambda a: a["views"][1].pop("name")), "views 2, name: is missing"),
                (changed(lambda a: a["views"][1].update(name="a/b")), 'views 2, name: "a/b" is not 1 to 64 letters'),
                (changed(lambda a: a["views"][1].update(name="slant")), 'views 2, name: "slant" is that of view 1'),
                (changed(lambda a: a["views"][1].update(name="auto")), 'views 2, name: "auto" has another meaning'),
                (changed(lambda a: a["views"][0].update(look="zebras")), "views 1, look: no look is called 'zebras'"),
                (changed(lambda a: a["views"][0].update(look="below-radius")), "views 1, look: \"below-radius\" needs a radius"),
                (changed(lambda a: a["views"][0].update(across=[0, 1, 0])), "views 1, across: is for the look curvature:section"),
                (changed(lambda a: a["views"][0].update(look="curvature:section", across=[0, 0, 0])), "views 1, across: is no direction"),
                (changed(lambda a: a["views"][0].update(across=[0, 1])), "views 1, across: is no place [x, y, z]"),
                (changed(lambda a: a["views"][0]["camera"].update(width=0)), "views 1, camera, width: and height must be"),
                (changed(lambda a: a["views"][0]["camera"].pop("eye")), "views 1, camera: a key is missing"),
                (changed(lambda a: a.update(sections=["q=1"])), "sections 1, section: 'q=1' is not x=MM"),
                (changed(lambda a: a.update(sections=["y=1", "y=1"])), 'sections 1: "y=1" stands there twice'),
                (changed(lambda a: a.update(rig=["format = 1"])), "rig, line 1"),
                (changed(lambda a: a["rig"].__setitem__(7, "lamps = -1")), "rig, line 8"),
                (changed(lambda a: a.update(rig=[1])), "rig: is no list of lines of text"),
                (changed(lambda a: a["hidden"][0].update(face=-1)), 'hidden 1, face: "-1" is no count'),
                (changed(lambda a: a["hidden"][0].pop("name")), "hidden 1: has neither name nor place"),
                (changed(lambda a: a["notes"][0].update(place=[0, 0])), "notes 1, place: is no place [x, y, z]"),
                (changed(lambda a: a["notes"][0].update(text="")), "notes 1, text: is empty"),
                (changed(lambda a: a["notes"][0].update(text="t" * 1001)), "notes 1: needs a text of 1 to 1000 bytes")):
            self.write("bad.json", text)
            run = self.keiko("render", HOOD, "--analysis", "bad.json", "-o", "a.png", "-q")
            self.assertEqual((run.returncode, run.stdout, run.stderr.count("\n")), (2, "", 1), run.stderr)
            self.assertTrue(run.stderr.startswith(f"keiko: bad.json:{reason}") or
                            run.stderr.startswith(f"keiko: bad.json: {reason}"), (run.stderr, reason))

    def test_every_command_refuses_it_before_the_long_work(self):
        self.write("bad.json", "{")
        for arguments in (("view", HOOD, "--no-browser"), ("inspect", HOOD), ("render", HOOD, "-o", "a.png"),
                          ("compare", HOOD, HOOD)):
            run = self.keiko(*arguments, "--analysis", "bad.json", "-q")
            self.assertEqual((run.returncode, run.stderr), (2, "keiko: bad.json: no JSON at line 1, column 2\n"))
            run = self.keiko(*arguments, "--analysis", "none.json", "-q")
            self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)
            self.assertIn("none.json", run.stderr)
        self.assertEqual(self.content(), ["a.json", "bad.json", "rig.toml"])

    def test_a_body_that_is_hidden_as_a_whole_is_refused(self):
        names = "wing-left", "dome", "wing-right"
        self.save(analysis(hidden=[{"face": number, "name": name} for number, name in enumerate(names, 1)]))
        run = self.keiko("inspect", HOOD, "--analysis", "a.json", "-q")
        self.assertEqual((run.returncode, run.stderr), (2, "keiko: --analysis: hides every face of the body\n"))

    def test_a_look_of_the_page_alone_cannot_be_rendered(self):
        value = analysis()
        value["views"][0]["look"] = "faces"
        self.save(value)
        run = self.keiko("render", HOOD, "--analysis", "a.json", "-o", "a.png", "-q")
        self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)
        self.assertIn("view slant: shows faces by colour", run.stderr)
        self.succeed("render", HOOD, "--analysis", "a.json", "--look", "lamps", "-o", "a.png", "-q")


class OnTheServer(AnalysisTest):
    REQUEST = """hidden = [2]
sections = ["z=800"]
[[view]]
name = "shown"
look = "curvature:gauss=0.002"
[view.camera]
eye = [-2000, -1500, 1800]
target = [560, 0, 720]
vertical_fov = 28
size = [96, 54]
[[note]]
text = "mind \\"this\\""
place = [560, 0, 812]
[[c_plane]]
origin = [-3000, -2000, 3000]
u = [6000, 0, 0]
v = [0, 4000, 0]
lamps = 7
diameter = 60
"""

    def setUp(self):
        super().setUp()
        self.server = Server(self.folder, HOOD, "--rig", "rig.toml", "--size", "96x54")
        self.addCleanup(self.server.close)

    def test_what_is_shown_becomes_a_file_that_reads_back_as_the_same(self):
        self.assertIsNone(json.loads(self.server.ask("GET", "/analysis")[2])["analysis"])
        status, _, text = self.server.ask("POST", "/analysis", self.REQUEST)
        self.assertEqual(status, 200, text)
        saved = json.loads(text)
        self.save(saved, "saved.json")
        self.assertEqual([view["name"] for view in saved["views"]], ["shown"])
        self.assertEqual((saved["sections"], saved["hidden"][0]["name"]), (["z=800"], "dome"))
        self.assertEqual((saved["notes"][0]["text"], saved["notes"][0]["face"]), ('mind "this"', 2))
        self.assertIn("lamps = 7", saved["rig"])
        rig = self.server.ask("GET", "/rig")[2]
        self.assertIn(b"lamps = 10", rig)
        answer = json.loads(self.server.ask("PUT", "/analysis", text.decode())[2])
        self.assertEqual(answer["analysis"], saved)
        self.assertEqual((answer["remarks"], answer["rig"]["planes"][0]["lamps"]), ([], 7))
        self.assertIn(b"lamps = 7", self.server.ask("GET", "/rig")[2])
        if jsonschema:
            jsonschema.validate(answer, json.loads((SOURCE / "docs/schema/keiko-view.schema.json").read_text()))

    def test_what_makes_no_sense_is_refused(self):
        for method, body, reason in (
                ("PUT", "{", "no JSON at line 1"),
                ("PUT", json.dumps(analysis(rig=[*RIG.splitlines(), '[[luminaire]]', 'file = "/etc/passwd"'])), "may not name a file"),
                ("POST", self.REQUEST.replace("shown", "a b"), "views 1, name"),
                ("POST", self.REQUEST.replace("curvature:gauss", "curvature:guess"), "views 1, look"),
                ("POST", self.REQUEST.replace("[2]", "[99]"), "there is no face 99"),
                ("POST", self.REQUEST.replace("place = [560, 0, 812]", ""), "place")):
            status, _, text = self.server.ask(method, "/analysis", body)
            self.assertEqual(status, 400, text)
            self.assertIn(reason, json.loads(text)["error"])


if __name__ == "__main__":
    unittest.main()
