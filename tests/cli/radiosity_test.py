"""`keiko radiosity`: the light that surfaces reflect onto each other, kept for other commands."""
import csv
import io
import re
import unittest

from keiko_process import KeikoTest

RADIUS, INTENSITY, RHO = 2000, 1000, 0.6
# A lamp in the middle of an integrating sphere.
SPHERE = f"""format = "keiko-scene/1"
[[primitive]]
kind = "sphere"
center = [0, 0, 0]
radius = {RADIUS}
material = {{ diffuse = {RHO}, refractive_index = 1 }}
[[point]]
position = [0, 0, 0]
intensity = {INTENSITY}
[radiosity]
element = 900
deviation = 60
rays = 256
"""
DIRECT = INTENSITY / (RADIUS / 1000) ** 2
REFLECTED = DIRECT * RHO / (1 - RHO)
POINTS = "2000,0,0,-1,0,0\n0,-2000,0,0,1,0\n0,0,0.5,0,0,1\n"


class Radiosity(KeikoTest):
    def solve(self, scene: str = SPHERE):
        run = self.keiko("radiosity", self.write("scene.toml", scene), "-o", "a.solution", "-q")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return run.stdout

    def lit(self, *arguments, scene: str = SPHERE, points: str = POINTS):
        return self.keiko("illuminance", self.write("scene.toml", scene), "-q", *arguments, input=points)

    def test_an_integrating_sphere_has_its_closed_form(self):
        self.solve()
        run = self.lit("--solution", "a.solution", points=POINTS.rsplit("\n", 2)[0] + "\n")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        rows = list(csv.DictReader(io.StringIO(run.stdout)))
        self.assertEqual(list(rows[0]), ["point.0", "reflected", "sum"])
        self.assertEqual(len(rows), 2)
        for row in rows:
            self.assertAlmostEqual(float(row["point.0"]), DIRECT, delta=1e-6 * DIRECT)
            self.assertAlmostEqual(float(row["reflected"]), REFLECTED, delta=1e-3 * REFLECTED)
            self.assertAlmostEqual(float(row["sum"]), float(row["point.0"]) + float(row["reflected"]), delta=1e-9)

    def test_a_point_in_the_air_gathers_from_all_elements(self):
        self.solve()
        run = self.lit("--solution", "a.solution", points="0,300,500,0,0.6,0.8\n")
        row, = csv.DictReader(io.StringIO(run.stdout))
        # Its hemisphere shows one radiosity, of direct and reflected light.
        self.assertAlmostEqual(float(row["reflected"]), RHO * (DIRECT + REFLECTED), delta=1e-3 * REFLECTED)

    def test_a_point_of_glass_has_the_light_of_the_air_before_it(self):
        scene = SPHERE.replace("[[point]]", """[[primitive]]
kind = "sphere"
center = [1000, 0, 0]
radius = 100
material = { glass = { absorption = 0 } }
[[point]]""")
        self.solve(scene)
        run = self.lit("--solution", "a.solution", scene=scene, points="1100,0,0,1,0,0\n1100.1,0,0,1,0,0\n")
        glass, air = (float(row["reflected"]) for row in csv.DictReader(io.StringIO(run.stdout)))
        self.assertAlmostEqual(glass, air, delta=1e-3 * air)
        self.assertAlmostEqual(air, RHO * (DIRECT + REFLECTED), delta=0.05 * REFLECTED)

    def test_a_thin_shell_is_lit_on_the_skin_that_faces_the_lamp(self):
        # Its elements leave the surface by more than its thickness: the other skin is nearer.
        part = """[[primitive]]
kind = "sphere"
center = [0, 0, 500]
radius = {radius}
material = {{ diffuse = 0.6, refractive_index = 1 }}
"""
        rest = """[[point]]
position = [0, 0, 3000]
intensity = 1000
[radiosity]
element = 500
smallest = 500
deviation = 20
rays = 64
error = 0.5
"""
        outer, inner = part.format(radius=500), part.format(radius=499)

        def first(parts: str) -> float:
            summary = self.solve(f'format = "keiko-scene/1"\n{parts}{rest}')
            return float(re.search(r"reflected first ([\d.e-]+) lm", summary)[1])

        solid, shell = first(outer), first(outer + inner)
        self.assertGreater(solid, 50)
        self.assertAlmostEqual(shell, solid, delta=1e-3 * solid)

    def test_the_balance_is_told(self):
        lines = self.solve().splitlines()
        self.assertRegex(lines[0], r"a\.solution: \d+ elements in \d+ triangles, \d+ rows of form factors$")
        first, absorbed, escaped, missing = map(float, re.findall(r"(-?[\d.e-]+) lm", lines[1]))
        flux = 4 * 3.14159265 * INTENSITY
        self.assertAlmostEqual(first, flux * RHO, delta=0.05 * flux)
        self.assertLess(abs(escaped), 1e-5 * first)  # rows of a closed scene sum to 1
        self.assertRegex(lines[2], r"not yet reflected: at most [\d.e-]+ % of the light$")
        remaining = float(lines[2].split()[-5]) / 100
        of_factors = 0.005 * first  # rows and columns of hemicubes differ
        self.assertLess(abs(missing), remaining * first / (1 - RHO) + of_factors)
        self.assertAlmostEqual(first, absorbed + escaped + missing, delta=1e-3 * first)

    def test_it_is_the_same_for_any_number_of_threads(self):
        self.write("scene.toml", SPHERE)
        for threads in "1", "2":
            self.keiko("radiosity", "scene.toml", "-o", f"{threads}.solution", "-q", "--threads", threads)
        one, other = ((self.folder / f"{threads}.solution").read_text() for threads in "12")
        self.assertEqual(one, other)

    def test_another_scene_is_refused_with_the_reason(self):
        self.solve()
        for change, reason in (
            (("radius = 2000", "radius = 2001"), "a.solution:geometry: is of other geometry than scene.toml"),
            (("position = [0, 0, 0]", "position = [0, 0, 1]"),
             "a.solution:lighting: is of other lamps, beside their levels, or other reflectances than scene.toml"),
            (("diffuse = 0.6", "diffuse = 0.5"),
             "a.solution:lighting: is of other lamps, beside their levels, or other reflectances than scene.toml"),
        ):
            run = self.lit("--solution", "a.solution", scene=SPHERE.replace(*change))
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn(reason, run.stderr)
            self.assertEqual(run.stderr.count("\n"), 1)

    def test_lamps_at_other_levels_need_no_new_factors(self):
        two = SPHERE.replace("[radiosity]", "[[point]]\nposition = [500, 0, 0]\nintensity = [10, 500, 20]\n[radiosity]")
        other = two.replace("intensity = 1000", "intensity = [0, 70, 3000]").replace("[10, 500, 20]", "[900, 0, 5]")
        self.solve(two)
        rows = []
        for of in two, other:
            run = self.lit("--solution", "a.solution", scene=of)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            rows.append(run.stdout)
        self.assertNotEqual(*rows)
        self.solve(other)
        again = self.lit("--solution", "a.solution", scene=other).stdout
        for one, new in zip(csv.DictReader(io.StringIO(rows[1])), csv.DictReader(io.StringIO(again)), strict=True):
            self.assertAlmostEqual(float(one["reflected"]), float(new["reflected"]),
                                   delta=5e-3 * float(new["reflected"]))

    def test_a_command_with_a_solution_tells_that_it_computes_no_factors(self):
        rows = self.solve().split(" rows of form factors")[0].split()[-1]
        for command, more in (("illuminance", ()), ("render", ("--shadows", "--size", "8x8", "-o", "a.png"))):
            run = self.keiko(command, "scene.toml", "--solution", "a.solution", "--verbose", *more, input=POINTS)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertRegex(run.stderr, rf"a\.solution: \d+ elements, {rows} rows of form factors, "
                                         "of which none is computed anew")

    def test_what_is_left_out_is_told(self):
        mapped = SPHERE.replace("refractive_index = 1 }", 'refractive_index = 1, map = '
                                '[{ drives = "diffuse", low = 0.5, texture = { kind = "checker", size = 100 } }] }')
        run = self.keiko("radiosity", self.write("scene.toml", mapped), "-o", "a.solution", "-q")
        self.assertEqual(run.returncode, 0)
        self.assertIn("radiosity: leaves out maps of reflectances: a face has that of its material", run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1)

    def test_what_is_no_solution_is_refused(self):
        run = self.lit("--solution", self.write("b.solution", "keiko-rig/1\n"))
        self.assertEqual(run.returncode, 2)
        self.assertIn('b.solution:line 1: expected "keiko-solution/1"', run.stderr)

    def test_a_scene_without_lamps_is_refused(self):
        dark = SPHERE.replace("[[point]]\nposition = [0, 0, 0]\nintensity = 1000\n", "")
        run = self.keiko("radiosity", self.write("scene.toml", dark), "-o", "a.solution", "-q")
        self.assertEqual(run.returncode, 2)
        self.assertIn("has no lamps, whose light could be reflected", run.stderr)

    def test_what_reflects_all_light_is_refused(self):
        white = SPHERE.replace(f"diffuse = {RHO}", "diffuse = 1")
        self.write("m.toml", """format = "keiko-materials/1"
[[material]]
name = "white"
diffuse = 1
refractive_index = 1
""")
        named = white.replace("{ diffuse = 1, refractive_index = 1 }", '"white"').replace(
            "[[primitive]]", 'materials = "m.toml"\n[[primitive]]')
        for scene, material in (white, "material of face 1"), (named, 'material "white"'):
            run = self.keiko("radiosity", self.write("scene.toml", scene), "-o", "a.solution", "-q")
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn(f"{material}: reflects all light: radiosity needs less than 1", run.stderr)
            self.assertFalse((self.folder / "a.solution").exists())

    def test_too_small_elements_are_refused(self):
        run = self.keiko("radiosity", self.write("scene.toml", SPHERE.replace("900", "5")), "-o", "a.solution", "-q")
        self.assertEqual(run.returncode, 2)
        self.assertIn("element: needs more than 100000 triangles; take a larger one", run.stderr)

    def test_lamps_of_bodies_glass_and_caustics_belong_to_the_light(self):
        """None of them is in the text of the rig."""
        inside = SPHERE + """[[primitive]]
kind = "sphere"
center = [700, 0, 0]
radius = 100
material = { refractive_index = 1.5, glass = { absorption = 0.001 } }
[[primitive]]
kind = "box"
origin = [-700, 0, 0]
u = [100, 0, 0]
v = [0, 100, 0]
w = [0, 0, 100]
material = { diffuse = 0.5, emits = 1000 }
"""
        inside = inside.replace("900", "1500")
        run = self.keiko("radiosity", self.write("scene.toml", inside), "-o", "a.solution", "-q")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.lit("--solution", "a.solution", scene=inside).returncode, 0)
        run = self.lit("--solution", "a.solution", scene=inside.replace("emits = 1000", "emits = 1001"))
        self.assertEqual(run.returncode, 0, run.stderr)
        for change in ((", emits = 1000", ""), ("0.001 }", "0.002 }"),
                       ("[radiosity]", "[caustics]\ndetail = 8\n[radiosity]")):
            self.assertIn(change[0], inside)
            run = self.lit("--solution", "a.solution", scene=inside.replace(*change))
            self.assertEqual((run.returncode, run.stdout), (2, ""), change)
            self.assertRegex(run.stderr, "a.solution:(lighting|geometry): is of other (lamps|geometry)")


if __name__ == "__main__":
    unittest.main()
