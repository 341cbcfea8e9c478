"""`keiko info` of the fixtures, for people and for programs."""
import json
import shutil
import subprocess
import unittest
from pathlib import Path
from xml.etree import ElementTree

from keiko_process import ASLANT, BINARY, SMALL, SOURCE, KeikoTest, luminaire, surface
from step_text import StepText

FACES = {"concept-car.step": 185, "dent.step": 1, "dome.bpt": 4, "hood.step": 3, "pole.step": 4,
         "saddle.bpt": 4, "seam-g0-gap.step": 2, "rational-sphere.step": 8, "trimmed-hole.step": 1,
         "trimmed-island.step": 2, "trimmed-two-holes.step": 1}


class Info(KeikoTest):
    def facts(self, name: str) -> dict:
        return json.loads(self.succeed("info", surface(name), "--json", "-q"))

    def test_faces_are_counted(self):
        for name, faces in FACES.items():
            facts = self.facts(name)
            self.assertEqual((facts["faces"], facts["placed_faces"]), (faces, faces), name)
            self.assertEqual((facts["lost_faces"], facts["repairs"], facts["diagnostics"]),
                             ([], [], []), name)

    def test_the_text_tells_the_same(self):
        text = self.succeed("info", surface("hood.step"), "-q")
        facts = self.facts("hood.step")
        self.assertRegex(text, rf"(?m)^faces\s+{facts['faces']}\b")
        self.assertRegex(text, rf"(?m)^patches\s+{facts['patches']}\b")

    def test_info_and_check_count_the_same_seams(self):
        for name in ("hood.step", "trimmed-hole.step", "seam-g1-angle.step", "concept-car.step"):
            self.keiko("check", surface(name), "--json", "c.json", "-q")
            check = json.loads((self.folder / "c.json").read_text())
            self.assertEqual(self.facts(name)["seams"], check["model"]["seams"], name)
            self.assertEqual(max((s["line"] for s in check["seams"]), default=0),
                             check["model"]["seams"], name)

    def test_the_json_lists_parts_and_faces(self):
        facts = self.facts("hood.step")
        self.assertEqual((facts["format"], facts["file_format"]), ("keiko-model-facts/1", "STEP"))
        self.assertEqual((facts["millimetres_per_unit"], facts["join"], facts["seams"]), (1, 0.5, 2))
        parts, faces = facts["part_list"], facts["face_list"]
        self.assertEqual((len(parts), len(faces)), (facts["parts"], facts["faces"]))
        self.assertEqual(sum(p["patches"] for p in parts), facts["patches"])
        self.assertEqual(sum(f["patches"] for f in faces), facts["patches"])
        self.assertEqual(sum(p["instances"] for p in parts), facts["instances"])
        self.assertEqual([f["id"] for f in faces], [1, 2, 3])
        self.assertEqual({tuple(f["degree"]) for f in faces}, {(5, 5)})
        self.assertEqual(len({f["name"] for f in faces}), 3)
        self.assertEqual((facts["edges"], facts["degenerate_edges"]), (12, 0))
        self.assertEqual(facts["remarks"], {"notes": 0, "warnings": 0, "errors": 0})

    def test_a_face_beyond_all_measure_is_lost_alone(self):
        def reasons(point: int, x: str) -> list:
            step.entities[point] = f"CARTESIAN_POINT('',({x},0.,700.))"
            step.write(self.folder / "far.step")
            facts = json.loads(self.keiko("info", "far.step", "--json", "-q").stdout)
            self.assertEqual(facts["faces"], 2)
            return [lost["reason"] for lost in facts["lost_faces"]]

        for x in "1.E16", "1.E300":
            step = StepText(surface("hood.step"))
            inside = step.net(step.surface_of(step.faces()[1]))[2][2]
            self.assertEqual(reasons(inside, x), ["it reaches beyond 1e15 mm"])
        step = StepText(surface("hood.step"))
        on_edge = step.references(step.of_type("B_SPLINE_CURVE_WITH_KNOTS")[0])[2]
        self.assertEqual(reasons(on_edge, "1.E300"), ["its edges are infinitely far apart"])

    def test_what_was_done_to_the_file_is_listed_and_counted(self):
        run = self.keiko("info", surface("saddle.bpt"), "--json", "-q", "--unit", "in")
        facts = json.loads(run.stdout)
        self.assertEqual((facts["unit"], facts["millimetres_per_unit"]), ("in", 25.4))
        self.assertEqual(facts["remarks"]["notes"], 1)
        self.assertEqual([d["severity"] for d in facts["diagnostics"]], ["note"])

    def test_verbose_tells_what_ray_tracing_takes(self):
        plain = self.keiko("info", surface("hood.step"))
        self.assertNotIn("tracing", plain.stdout)
        self.assertNotIn("keiko: build\n", plain.stderr)
        self.assertIsNone(self.facts("hood.step")["tracing"])
        text = self.keiko("info", surface("hood.step"), "--verbose").stdout
        self.assertRegex(text, r"(?m)^tracing +\d+ sub-patches, \d+ cut by trims, \d+ trimmed away, "
                               r"\d+ bytes, built in [\d.e-]+ ms$")
        tracing = json.loads(self.keiko("info", surface("trimmed-hole.step"), "--json",
                                        "--verbose").stdout)["tracing"]
        self.assertGreater(tracing["build_milliseconds"], 0)
        self.assertTrue(0 < tracing["mixed_sub_patches"] <= tracing["sub_patches"])
        self.assertGreater(tracing["bytes"], tracing["sub_patches"])

    def test_a_model_kept_in_the_cache_comes_back_the_same(self):
        first = self.keiko("info", surface("hood.step"), "--json", "--cache", "kept/models")
        self.assertEqual(first.returncode, 0, first.stderr)
        kept = list((self.folder / "kept" / "models").iterdir())
        self.assertEqual([entry.suffix for entry in kept], [".keiko-model"])
        second = self.keiko("info", surface("hood.step"), "--json", "--cache", "kept/models")
        self.assertEqual(second.stdout, first.stdout)
        kept[0].write_bytes(b"damaged")
        third = self.keiko("info", surface("hood.step"), "--json", "--cache", "kept/models")
        self.assertEqual(third.stdout, first.stdout)
        self.assertGreater(kept[0].stat().st_size, 100)

    def test_processes_that_fill_the_cache_at_once_do_not_meet(self):
        command = [BINARY, "info", surface("hood.step"), "--json", "-q", "--cache", "kept"]
        expected = self.succeed("info", surface("hood.step"), "--json", "-q")
        for _ in range(3):
            together = [subprocess.Popen(command, cwd=self.folder, text=True, stdout=subprocess.PIPE,
                                         stderr=subprocess.PIPE) for _ in range(2)]
            for process in together:
                self.assertEqual(process.communicate(timeout=self.patience), (expected, ""))
                self.assertEqual(process.returncode, 0)
            entry, = (self.folder / "kept").iterdir()
            self.assertEqual(self.succeed(*command[1:]), expected)
            entry.unlink()

    def test_a_cache_entry_that_is_a_link_is_not_written_through(self):
        self.succeed("info", surface("hood.step"), "-q", "--cache", "kept")
        entry, = (self.folder / "kept").iterdir()
        entry.unlink()
        entry.symlink_to(self.folder / self.write("victim", "precious"))
        self.succeed("info", surface("hood.step"), "-q", "--cache", "kept")
        self.assertEqual((self.folder / "victim").read_text(), "precious")
        self.assertFalse(entry.is_symlink())

    def test_the_cache_holds_no_more_than_its_limit(self):
        limit = 0.001 * 2**30
        for number in range(3):
            copy = shutil.copy(surface("concept-car.step"), self.folder / f"car-{number}.step")
            self.succeed("info", str(copy), "-q", "--cache", "kept", "--cache-limit", "0.001")
        sizes = [entry.stat().st_size for entry in (self.folder / "kept").iterdir()]
        self.assertEqual(len(sizes), 2)
        self.assertTrue(sum(sizes) <= limit < 1.5 * sum(sizes), sizes)

    def test_a_luminaire_is_told_and_drawn(self):
        file = luminaire("sym4.ldt")
        text = self.succeed("info", file, "--svg", "polar.svg", "-q")
        self.assertRegex(text, r"(?m)^type +C, symmetry about planes 0-180 and 90-270$")
        facts = json.loads(self.succeed("info", file, "--json", "-q"))
        self.assertEqual((facts["format"], facts["name"], facts["planes"]["count"]),
                         ("keiko-luminaire-facts/1", "lum", 7))
        self.assertEqual(facts["lamp_flux"], 5090)
        self.assertRegex(text, rf"(?m)^flux +{facts['luminous_flux']:.6g} lm")
        self.assertEqual(self.content(), ["polar.svg"])
        drawing = ElementTree.parse(self.folder / "polar.svg").getroot()
        self.assertEqual(drawing.tag, "{http://www.w3.org/2000/svg}svg")

    def test_json_of_luminaires_keeps_to_its_schema(self):
        try:
            import jsonschema
        except ImportError:
            self.skipTest("no python3-jsonschema")
        schema = json.loads((SOURCE / "docs" / "schema" / "keiko-luminaire-facts.schema.json").read_text())
        files = sorted(Path(luminaire("sym4.ldt")).parent.glob("*.*"))
        self.assertGreater(len(files), 10)
        for file in files:
            with self.subTest(file=file.name):
                jsonschema.validate(json.loads(self.succeed("info", str(file), "--json", "-q")), schema)

    def test_a_header_that_its_table_contradicts_is_remarked(self):
        text = Path(luminaire("sym4.ldt")).read_text(encoding="latin-1").splitlines()
        flux = json.loads(self.succeed("info", luminaire("sym4.ldt"), "--json", "-q"))["light_output_ratio"]
        for share, remarks in ((1.0, 0), (1.02, 1)):
            text[21], text[22] = "", f"{100 * share * flux:.6f}"
            name = self.write("lamp.ldt", "\n".join(text) + "\n")
            facts = json.loads(self.succeed("info", name, "--json", "-q"))
            ratios = [remark for remark in facts["diagnostics"] if "light output ratio" in remark["message"]]
            self.assertEqual(len(ratios), remarks)
        rig = self.write("rig.toml", 'format = "keiko-rig/1"\n[[luminaire]]\nfile = "lamp.ldt"\nposition = [0, 0, 3000]\n')
        run = self.keiko("render", surface("dome.bpt"), "--rig", rig, "-o", "a.png", *SMALL, "-q")
        self.assertEqual(run.returncode, 0)
        self.assertIn("warning: lamp.ldt: the header states a light output ratio of", run.stderr)

    def test_axes_that_are_no_vehicles_are_remarked(self):
        # A table, y up and z across.
        upright = self.write("table.bpt", "1\n1 1\n-300 500 -200\n-300 500 200\n900 520 -200\n900 520 200\n")
        self.assertRegex(self.succeed("info", upright, "-q"), r"(?m)^note +axes: the body lies evenly about z = 0")
        view = ("render", upright, "--rig", self.write("rig.toml", ASLANT), "-o", "a.png", *SMALL, "-q", "--view")
        self.assertIn("warning: --axes: the body lies evenly about z = 0", self.keiko(*view, "left").stderr)
        self.assertEqual(self.keiko(*view, "auto").stderr, "")
        self.assertEqual(self.keiko(*view, "left", "--axes", "x,-z,y").stderr, "")

    def test_a_bad_luminaire_costs_one_line_and_draws_nothing(self):
        bad = self.write("bad.ies", "IESNA91\nTILT=NONE\n1 -1 1 2 1 7\n")
        run = self.keiko("info", bad, "--svg", "polar.svg", "-q")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertEqual(run.stderr.strip().splitlines()[-1].split(": ", 1)[-1],
                         "bad.ies:3: the photometric type must be from 1 to 3")
        self.assertEqual(self.content(), ["bad.ies"])
        run = self.keiko("info", surface("dome.bpt"), "--svg", "polar.svg", "-q")
        self.assertEqual(run.returncode, 2)
        self.assertIn("--svg draws luminaires alone", run.stderr)

    def test_a_unit_given_by_hand_scales_the_model(self):
        plain = self.facts("saddle.bpt")["bounds"]["upper"]
        inches = json.loads(self.succeed("info", surface("saddle.bpt"), "--json", "-q", "--unit",
                                         "in"))["bounds"]["upper"]
        for a, b in zip(plain, inches):
            self.assertAlmostEqual(b, 25.4 * a, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
