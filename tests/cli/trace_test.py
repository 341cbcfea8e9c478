"""`keiko trace`: rays from standard input, hits to standard output."""
import csv
import io
import itertools
import json
import math
import signal
import subprocess
import time
import unittest

from keiko_process import BINARY, KeikoTest, surface
from step_text import StepText

SADDLE = surface("saddle.bpt")  # z = (x^2 - y^2) / 400 over +-100 mm
SPHERE = surface("rational-sphere.step")  # radius 100 mm about the origin
HEADER = "ox,oy,oz,dx,dy,dz\n"
DOWN = "3,7,200,0,0,-1\n"
MISS = "500,0,200,0,0,-1\n"


def rays_down(count: int) -> str:
    """Rays down onto the saddle and beside it."""
    lines = (f"{-110 + 220 * (i % 97) / 97!r},{-110 + 220 * (i % 89) / 89!r},200,0,0,-1\n"
             for i in range(count))
    return "".join(lines)


def mapped(operator, place, vector=False) -> tuple:
    """A place, or a direction, that an operator (axes, scale, origin) maps."""
    axes, scale, origin = operator
    turned = (scale * sum(axis[k] * c for axis, c in zip(axes, place)) for k in range(3))
    return tuple(c + (0 if vector else o) for c, o in zip(turned, origin))


def mapped_normal(operator, normal) -> tuple:
    """That of the mapped tangents' cross product."""
    axes, _, _ = operator
    (a, b, c), (d, e, f), (g, h, i) = axes
    sign = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return tuple(sign * sum(axis[k] * n for axis, n in zip(axes, normal)) for k in range(3))


class Trace(KeikoTest):
    def trace(self, rays: str, *arguments: str) -> str:
        run = self.keiko("trace", *arguments, "-q", input=rays)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return run.stdout

    def rows(self, rays: str, *arguments: str) -> list:
        return list(csv.DictReader(io.StringIO(self.trace(rays, *arguments))))

    def fails(self, reason: str, rays: str, *arguments: str) -> str:
        run = self.keiko("trace", *arguments, "-q", input=rays)
        self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)
        self.assertIn(reason, run.stderr)
        return run.stdout

    def start(self, *arguments: str, **options) -> subprocess.Popen:
        process = subprocess.Popen([BINARY, "trace", *arguments, "-q"], text=True,
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, **options)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def test_a_body_whose_file_has_y_up(self):
        as_it_lies, turned = "300,3000,-200,0,-1,0\n", "300,200,3000,0,0,-1\n"
        model = self.write("y-up.bpt", "1\n1 1\n0 9 -500\n0 9 0\n999 9 -500\n999 99 0\n")
        lying = self.rows(as_it_lies, model)[0]
        upright = self.rows(turned, model, "--axes", "x,-z,y")[0]
        self.assertNotEqual(lying["t"], "")
        for column in "t", "face", "u", "v":
            self.assertEqual(upright[column], lying[column])
        for here, there, sign in ("x", "x", 1), ("y", "z", -1), ("z", "y", 1):
            self.assertEqual(float(upright[here]), sign * float(lying[there]))
            self.assertEqual(float(upright["n" + here]), sign * float(lying["n" + there]))

    def check_images(self, chains, rays, hits):
        """Rays that go through operators, the outermost of each chain first, meet what they met, moved likewise."""
        placed = ""
        for chain in chains:
            for ray in rays:
                start, direction = ray[:3], ray[3:]
                for operator in reversed(chain):
                    start, direction = mapped(operator, start), mapped(operator, direction, vector=True)
                placed += ",".join(map(repr, start + direction)) + "\n"
        images = iter(self.rows(placed, "placed.step"))
        for chain in chains:
            for hit, image in zip(hits, images):
                self.assertEqual(image["face"], hit["face"])
                place, normal = ([float(hit[n + c]) for c in "xyz"] for n in ("", "n"))
                for operator in reversed(chain):
                    place, normal = mapped(operator, place), mapped_normal(operator, normal)
                for k, c in enumerate("xyz"):
                    self.assertAlmostEqual(float(image[c]), place[k], delta=1e-8)
                    self.assertAlmostEqual(float(image["n" + c]), normal[k], delta=1e-9)

    def test_mirrored_and_scaled_placements_of_one_part(self):
        x, y, z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
        upside_down = (x, y, (0.0, 0.0, -1.0)), 1.0, (200.0, 0.0, 0.0)
        twice = (x, y, z), 2.0, (0.0, 300.0, 0.0)
        swapped = (y, x, z), 1.0, (10.0, 20.0, 30.0)
        moved = (x, y, z), 1.0, (0.0, 0.0, 1000.0)
        left = ((x, (0.0, -1.0, 0.0), z), 1.0, (0.0, 0.0, 0.0))
        block = surface("bored-block.step")
        rays = [(-29.0 + 4.1 * i, -17.0 + 2.3 * i, 60.0, 0.02 * i, -0.1, -1.0) for i in range(15)]
        hits = self.rows("".join(",".join(map(repr, r)) + "\n" for r in rays), block)
        rays, hits = zip(*((ray, hit) for ray, hit in zip(rays, hits) if hit["face"]))
        self.assertGreater(len(hits), 10)
        for levels, mirrored in (([[upside_down, twice]], 1), ([[left]], 1), ([[swapped], [moved]], 1),
                                 ([[swapped], [upside_down]], 0), ([[upside_down, twice], [moved]], 1),
                                 ([[swapped, moved], [twice, upside_down]], 2)):
            step = StepText(block)
            step.place(*levels)
            step.write(self.folder / "placed.step")
            facts = json.loads(self.succeed("info", "placed.step", "--json", "-q"))
            part, = facts["part_list"]
            instances = math.prod(len(level) for level in levels)
            self.assertEqual((part["faces"], part["instances"], part["mirrored_instances"]), (27, instances, mirrored))
            self.assertEqual(facts["diagnostics"], [])
            self.check_images(list(itertools.product(*reversed(levels))), rays, hits)

    def test_a_row_for_each_ray_in_order(self):
        for header in "", HEADER:
            text = self.trace(header + DOWN + MISS + DOWN.strip(), SADDLE)
            lines = text.split("\n")
            self.assertEqual(lines[0], "t,face,u,v,x,y,z,nx,ny,nz")
            self.assertEqual(lines[2], ",,,,,,,,,")
            self.assertEqual((lines[1], lines[4]), (lines[3], ""))
        row = self.rows(DOWN, SADDLE)[0]
        self.assertAlmostEqual(float(row["t"]), 200.1, delta=1e-10)
        self.assertAlmostEqual(float(row["z"]), -0.1, delta=1e-10)

    def test_every_column_of_a_sphere(self):
        columns = "t,instance,face,patch,u,v,x,y,z,nx,ny,nz,k1,k2,bound,flags"
        row = self.rows("20,30,500,0,0,-2\n", SPHERE, "--out", columns)[0]
        self.assertEqual(",".join(row), columns)
        height = math.sqrt(100**2 - 20**2 - 30**2)
        self.assertAlmostEqual(float(row["t"]), (500 - height) / 2, delta=1e-9)
        position = [float(row[c]) for c in "xyz"]
        outwards = math.copysign(1, float(row["nz"]))
        for component, normal in zip(position, ("nx", "ny", "nz")):
            self.assertAlmostEqual(float(row[normal]), outwards * component / 100, delta=1e-9)
        for curvature in "k1", "k2":
            self.assertAlmostEqual(float(row[curvature]), -outwards / 100, delta=1e-9)
        self.assertLess(float(row["bound"]), 1e-6)
        self.assertIn(row["flags"].split("|")[0], ("unique", "clipped", "tangential"))

    def test_all_hits_are_led_by_the_number_of_their_ray(self):
        text = self.trace(HEADER + MISS + "20,30,500,0,0,-1\n" + MISS, SPHERE, "--all", "--out",
                          "instance,z")
        lines = text.splitlines()
        self.assertEqual((lines[0], lines[1], lines[4]), ("ray,instance,z", "0,,", "2,,"))
        first, second = (line.split(",") for line in lines[2:4])
        self.assertEqual((len(lines), first[0], second[0]), (5, "1", "1"))
        self.assertAlmostEqual(float(first[2]), -float(second[2]), delta=1e-9)

    def test_indices_are_those_of_info(self):
        hood = surface("hood.step")
        facts = json.loads(self.succeed("info", hood, "--json", "-q"))
        row = self.rows("600,0,3000,0,0,-1\n", hood, "--out", "face,instance")[0]
        face = next(f for f in facts["face_list"] if f["id"] == int(row["face"]))
        self.assertEqual(face["part"], int(row["instance"]))
        self.assertEqual(face["name"], "dome")

    def test_the_luminance_of_a_scene_with_a_rig(self):
        scene = surface("hood-scene.toml")
        row = self.rows("600,0,3000,0,0,-1\n", scene, "--out", "luminance,r,g,b")[0]
        red, green, blue = (float(row[c]) for c in "rgb")
        self.assertGreater(float(row["luminance"]), 0)
        self.assertAlmostEqual(float(row["luminance"]),
                               0.2126 * red + 0.7152 * green + 0.0722 * blue, delta=1e-9)

    def test_luminance_is_refused_without_a_rig(self):
        self.fails('--out: the column "luminance" needs a scene file with a rig', DOWN, SADDLE,
                   "--out", "t,luminance")
        self.fails('--out: the column "r" is that of the first hit', DOWN,
                   surface("hood-scene.toml"), "--out", "r", "--all")

    def test_the_clipping_intersector_agrees(self):
        rays = rays_down(2000)
        plain = self.rows(rays, SADDLE, "--out", "x,y,z,bound,flags")
        clipped = self.rows(rays, SADDLE, "--out", "x,y,z,bound,flags", "--intersector", "clipping")
        for a, b in zip(plain, clipped):
            self.assertEqual(a["x"] == "", b["x"] == "")
            if not a["x"]:
                continue
            self.assertTrue(b["flags"].startswith("clipped"))
            bound = float(a["bound"]) + float(b["bound"])
            self.assertLessEqual(math.dist([float(a[c]) for c in "xyz"],
                                           [float(b[c]) for c in "xyz"]), bound)

    def test_the_same_bytes_for_any_thread_count(self):
        rays = rays_down(20000)
        expected = self.trace(rays, SADDLE, "--threads", "1")
        self.assertEqual(expected.count("\n"), 20001)
        for threads in "0", "2", "7":
            self.assertEqual(self.trace(rays, SADDLE, "--threads", threads), expected)

    def test_a_malformed_line_is_named_after_the_rows_before_it(self):
        rows = self.fails("standard input:4: dy is not a number: \"a\"",
                          HEADER + DOWN + MISS + "1,2,3,4,a,6\n" + DOWN, SADDLE, "--out", "face")
        self.assertEqual(rows.count("\n"), 3)
        for line, reason in (("1,2,3,4,5", "got 5 fields"), ("\n" + DOWN, "got an empty line"),
                             ("1,2,3,4,5,inf", "dz is not finite"), ("1,2,3,0,0,0", "no direction"),
                             ("1e300,2,3,4,5,6", "beyond 1e15 mm"),
                             ("0,0,1e12,0,0,-1", "ox,oy,oz is over 1e8 times the body's size away"), (HEADER[:-1], "ox is not a")):
            self.fails("standard input:2: ", DOWN + line + "\n", SADDLE)
            self.fails(reason, DOWN + line + "\n", SADDLE)

    def test_rays_from_as_far_as_is_let_pass_are_answered(self):
        _, row = self.trace("0.5,0.25,1e10,0,0,-1\n", SADDLE, "--out", "x,y,bound").splitlines()
        x, y, bound = map(float, row.split(","))
        self.assertLess(abs(x - 0.5) + abs(y - 0.25), 2 * bound)

    def test_what_editors_and_spreadsheets_add_is_let_pass(self):
        plain = self.trace(HEADER + DOWN + MISS, SADDLE)
        for text in ("\ufeff" + HEADER + DOWN + MISS, "\ufeff" + DOWN + MISS,
                     "ox, oy, oz, dx, dy, dz\n" + DOWN + MISS, HEADER + DOWN + MISS + "\n \r\n\n"):
            self.assertEqual(self.trace(text, SADDLE), plain)

    def test_unknown_columns_and_intersectors(self):
        self.fails('--out: no column is called "hue"', DOWN, SADDLE, "--out", "t,hue")
        self.fails("--intersector: ", DOWN, SADDLE, "--intersector", "newton")

    def test_verbose_tells_how_hits_were_found(self):
        run = self.keiko("trace", SADDLE, "--verbose", "--out", "t", input=DOWN + MISS)
        self.assertRegex(run.stderr,
                         r"(?m)^keiko: 2 rays, 1 hits: [\d.]+ % unique, [\d.]+ % clipped, "
                         r"[\d.]+ % tangential$")
        self.assertEqual(run.stdout.count("\n"), 3)

    def test_who_sends_a_ray_and_waits_is_answered(self):
        process = self.start(SADDLE, "--out", "instance")
        self.assertEqual(process.stdout.readline(), "instance\n")
        for ray, answer in (DOWN, "0\n"), (MISS, "\n"), (DOWN, "0\n"):
            process.stdin.write(ray)
            process.stdin.flush()
            self.assertEqual(process.stdout.readline(), answer)

    def test_ends_quietly_when_nobody_reads(self):
        process = self.start(SADDLE)
        process.stdout.close()
        try:
            for _ in range(1000):
                process.stdin.write(DOWN * 100)
                process.stdin.flush()
        except BrokenPipeError:
            pass
        process.wait(timeout=30)
        self.assertEqual((process.returncode, process.stderr.read()), (0, ""))

    def interrupt(self, process: subprocess.Popen):
        start = time.monotonic()
        process.send_signal(signal.SIGINT)
        process.wait(timeout=30)
        self.assertEqual((process.returncode, process.stderr.read()), (130, "keiko: interrupted\n"))
        self.assertLess(time.monotonic() - start, 5)

    def test_interrupted_while_it_waits_for_rays(self):
        process = self.start(SADDLE)
        process.stdout.readline()
        self.interrupt(process)

    def test_interrupted_while_nobody_takes_its_rows(self):
        rays = self.write("rays.csv", rays_down(50000))
        with open(self.folder / rays) as file:
            process = subprocess.Popen([BINARY, "trace", SADDLE, "-q"], text=True, stdin=file,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        process.stdout.readline()
        time.sleep(0.5)
        self.interrupt(process)

    def test_memory_does_not_grow_with_the_rays(self):
        def peak(count: int) -> int:
            rays = self.write("rays.csv", rays_down(1000) * (count // 1000))
            script = f"import resource, subprocess, sys\nfile = open({rays!r})\n" \
                     f"subprocess.run([{BINARY!r}, 'trace', {SADDLE!r}, '-q'], stdin=file, " \
                     "stdout=subprocess.DEVNULL, check=True)\n" \
                     "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)"
            run = subprocess.run(["python3", "-c", script], cwd=self.folder, text=True,
                                 capture_output=True, check=True)
            return int(run.stdout)
        few, many = peak(50_000), peak(400_000)
        self.assertLess(many - few, 8192, (few, many))  # KiB


if __name__ == "__main__":
    unittest.main()
