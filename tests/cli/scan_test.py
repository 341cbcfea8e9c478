"""keiko compare NOMINAL SCAN: deviations that were planted, and its exit codes."""
import json
import math
import random
import struct
import unittest

from keiko_process import SOURCE, KeikoTest

SCHEMA = json.loads((SOURCE / "docs" / "schema" / "keiko-scan.schema.json").read_text())
# 200 x 200 mm at height 0, its outside upwards: 4 degree-1 points.
PLATE = "1\n1 1\n0 0 0\n0 200 0\n200 0 0\n200 200 0\n"
RADIUS, DEPTH, TOLERANCE = 40, 0.4, 0.1


def height(x: float, y: float) -> float:
    """A dent in the middle that is deeper than the tolerance within RADIUS sqrt(1 - TOLERANCE / DEPTH)."""
    square = ((x - 100) ** 2 + (y - 100) ** 2) / RADIUS**2
    return -DEPTH * (1 - square) if square < 1 else 0.0


POINTS = [(x, y, height(x, y)) for x in (i + 0.5 for i in range(200)) for y in (j + 0.5 for j in range(200))]
OUT = sum(z < -TOLERANCE for _, _, z in POINTS) / len(POINTS)


def xyz(points=POINTS) -> bytes:
    return "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in points).encode()


def ply(points=POINTS) -> bytes:
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty double x\n"
              "property double y\nproperty double z\nend_header\n")
    return header.encode() + b"".join(struct.pack("<3d", *point) for point in points)


def stl(points=POINTS) -> bytes:
    """A triangle of every three points."""
    triangles = [points[i:i + 3] for i in range(0, len(points) - 2, 3)]
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *(number for point in triangle for number in point), 0)
                    for triangle in triangles)
    return bytes(80) + struct.pack("<I", len(triangles)) + body


class Scan(KeikoTest):
    def setUp(self):
        super().setUp()
        self.write("plate.bpt", PLATE)

    def scan(self, name: str, content: bytes) -> str:
        (self.folder / name).write_bytes(content)
        return name

    def compare(self, scan: str, *options: str, code: int = 0) -> dict:
        run = self.keiko("compare", "-q", "plate.bpt", scan, "--json", "a.json", *options)
        self.assertEqual((run.returncode, run.stderr), (code, ""), run.stdout)
        found = json.loads((self.folder / "a.json").read_text())
        try:
            import jsonschema
            jsonschema.validate(found, SCHEMA)
        except ImportError:
            pass
        return found

    def test_a_planted_dent_is_found_in_every_format(self):
        for name, content in ("a.xyz", xyz()), ("a.asc", xyz()), ("a.ply", ply()), ("a.stl", stl()):
            found = self.compare(self.scan(name, content), "--no-align", "--tolerance", str(TOLERANCE), code=1)
            self.assertEqual(found["verdict"], "fail")
            self.assertIsNone(found["alignment"])
            self.assertAlmostEqual(found["within"], 1 - OUT, delta=1e-4)
            # The area of a circle, and the volume of a paraboloid: half that of the cylinder around it.
            area = math.pi * RADIUS**2 * (1 - TOLERANCE / DEPTH) / 200**2
            self.assertAlmostEqual(found["within"], 1 - area, delta=1e-3)
            self.assertAlmostEqual(found["deviation"]["mean"], -DEPTH * math.pi * RADIUS**2 / 2 / 200**2, delta=1e-5)
            lowest = found["deviation"]["lowest"]
            self.assertAlmostEqual(lowest["value"], -DEPTH, delta=1e-3)
            self.assertAlmostEqual(lowest["place"][0], 100, delta=1)
            self.assertEqual(sum(found["deviation"]["histogram"]["counts"]), found["points"]["measured"])

    def test_limits_give_the_verdict(self):
        scan = self.scan("a.ply", ply())
        share = str(100 * (1 - OUT) - 0.01)
        judged = self.compare(scan, "--no-align", "--tolerance", str(TOLERANCE), "--least-share", share)
        self.assertEqual(judged["verdict"], "pass")
        self.assertEqual(self.compare(scan, "--no-align", "--tolerance", "0.41")["verdict"], "pass")
        self.assertEqual(self.compare(scan, "--no-align")["verdict"], "not judged")

    def test_a_share_that_is_just_reached_passes(self):
        scan = self.scan("a.xyz", xyz([(100.5, 100.5, 0)] * 999 + [(100.5, 100.5, 5)]))
        judged = self.compare(scan, "--no-align", "--tolerance", "1", "--least-share", "99.9")
        self.assertEqual(judged["verdict"], "pass")

    def test_a_byte_order_mark_is_no_heading(self):
        scan = self.scan("a.xyz", b"\xef\xbb\xbf" + xyz(POINTS[:3]))
        self.assertEqual(self.compare(scan, "--no-align")["points"]["all"], 3)

    def test_a_scan_that_was_moved_is_aligned(self):
        self.write("dome.bpt", (SOURCE / "surfaces" / "dome.bpt").read_text())
        self.succeed("info", "dome.bpt")
        random.seed(1)
        rays = "ox,oy,oz,dx,dy,dz\n" + "".join(
            f"{random.uniform(-60, 60)!r},{random.uniform(-60, 60)!r},500,0,0,-1\n" for _ in range(3000))
        run = self.keiko("trace", "dome.bpt", "--out", "x,y,z", input=rays)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        on_dome = [tuple(map(float, row.split(","))) for row in run.stdout.splitlines()[1:] if "nan" not in row]
        self.assertGreater(len(on_dome), 1000)
        turn, moved = math.radians(1.5), []
        for x, y, z in on_dome:
            moved.append((math.cos(turn) * x - math.sin(turn) * z + 2, y - 1, math.sin(turn) * x + math.cos(turn) * z))
        run = self.keiko("compare", "-q", "dome.bpt", self.scan("a.ply", ply(moved)), "--tolerance", "1e-4",
                         "--json", "a.json")
        self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)
        found = json.loads((self.folder / "a.json").read_text())
        self.assertTrue(found["alignment"]["converged"])
        self.assertLess(found["alignment"]["residual"], 1e-4)
        self.assertIn("aligned: turned by ", run.stdout)

    def test_a_plane_is_not_shifted_in_itself(self):
        tilted = [(x + 3, y + 2, 0.01 * x + 1) for x, y, _ in POINTS[::50]]
        run = self.keiko("compare", "-q", "plate.bpt", self.scan("a.xyz", xyz(tilted)), "--json", "a.json")
        self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)
        alignment = json.loads((self.folder / "a.json").read_text())["alignment"]
        free = {kind: [[round(x, 9) for x in way] for way in ways] for kind, ways in alignment["free"].items()}
        self.assertEqual(free, {"shifts": [[1, 0, 0], [0, 1, 0]], "turns": [[0, 0, 1]]})
        self.assertLess(max(map(abs, alignment["shift"][:2])), 1e-6)
        self.assertGreater(alignment["used"], 0.9)
        self.assertIn(" % of the points used; left free and not moved: shifts along (1, 0, 0) and (0, 1, 0), "
                      "turns about (0, 0, 1)\n", run.stdout)

    def test_units_of_scans(self):
        scan = self.scan("a.xyz", xyz([(x / 25.4, y / 25.4, z / 25.4) for x, y, z in POINTS[::50]]))
        found = self.compare(scan, "--no-align", "--scan-unit", "in", "--tolerance", "0.4")
        self.assertEqual(found["points"]["measured"], len(POINTS[::50]))

    def test_the_report_has_maps_and_a_histogram(self):
        scan = self.scan("a.ply", ply())
        run = self.keiko("compare", "-q", "plate.bpt", scan, "--no-align", "--tolerance", "0.1", "--size", "96x54",
                         "--view", "high-left", "-o", "out")
        self.assertEqual((run.returncode, run.stderr), (1, ""), run.stdout)
        page = (self.folder / "out" / "compare.html").read_text()
        for part in ("<div class=\"verdict\">fail</div>", "data:image/png;base64,", "<svg class=\"histogram\"",
                     "measured on plate.bpt"):
            self.assertIn(part, page)
        found = json.loads((self.folder / "out" / "compare.json").read_text())
        self.assertEqual([view["map"] for view in found["views"]], ["high-left-deviation.png"])
        self.assertTrue((self.folder / "out" / "high-left-deviation.png").is_file())

    def test_the_text_does_not_depend_on_threads(self):
        scan = self.scan("a.ply", ply())
        texts = {self.keiko("compare", "plate.bpt", scan, "--json", f"{n}.json", "--threads", n).stdout
                 for n in ("1", "2")}
        self.assertEqual(len(texts), 1)
        self.assertEqual((self.folder / "1.json").read_bytes(), (self.folder / "2.json").read_bytes())

    def test_bad_files_and_options_give_one_line(self):
        good = self.scan("good.xyz", xyz(POINTS[:100]))
        for arguments, reason in (
                ((self.scan("a.stl", stl()[:-1]),), "a.stl: is no STL file, or cut short"),
                ((self.scan("b.ply", ply()[:-1]),), "b.ply: is cut short: it ends before its last vertex"),
                ((self.scan("c.xyz", b"1 2 3\n1 2 x\n"),), 'c.xyz:2: not a number: "x"'),
                ((self.scan("d.asc", b"\n"),), "d.asc: holds no points"),
                ((self.scan("e.asc", b"1,5;2,5;3,5\n"),), "e.asc:1: has ';' and ','"),
                ((self.scan("f.stl", stl([(float("nan"),) * 3] * 60000)),), "f.stl:point 1: a coordinate must be"),
                (("missing.ply",), "missing.ply: "),
                ((self.scan("g.xyz", xyz(POINTS[:11])),), "g.xyz:points: 11 are too few to align: 12 are needed"),
                ((good, "--rig", "auto"), "--rig: is not for scans"),
                ((good, "--analysis", "a.json"), "--analysis: is not for scans"),
                ((good, "--view", "top", "--json", "j.json"), "--view: needs -o"),
                ((good, "--least-share", "90"), "--least-share: needs a --tolerance"),
                ((good, "--scan-unit", "ell"), '--scan-unit: "ell" is no length unit'),
                (("plate.bpt", "--no-align"), "--no-align: is for scans"),
                ((good, "--json", "good.xyz"), "good.xyz")):
            run = self.keiko("compare", "-q", "plate.bpt", *arguments)
            self.assertEqual((run.returncode, run.stdout), (2, ""), arguments)
            self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
            self.assertIn(reason, run.stderr)


if __name__ == "__main__":
    unittest.main()
