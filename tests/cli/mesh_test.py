"""keiko mesh: triangles whose corners lie on the exact surface, as other programs read them."""
import array
import base64
import json
import math
import struct
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from keiko_process import KeikoTest, surface

DTYPES = {"Float64": "d", "Int64": "q"}


class Vtp:
    """Arrays of a .vtp file by name, read without VTK."""

    def __init__(self, path):
        root = ElementTree.parse(path).getroot()
        assert root.get("header_type") == "UInt64"
        self.piece = root.find("PolyData/Piece")
        self.arrays = {one.get("Name"): self.numbers(one) for one in root.iter("DataArray")}
        self.names = ["".join(map(chr, map(int, word.split()))) for one in root.iter("Array")
                      for word in (one.text.strip() + " ").split(" 0 ")[:-1]]

    @staticmethod
    def numbers(element) -> list:
        data = base64.b64decode(element.text)
        size, = struct.unpack_from("<Q", data)
        assert size == len(data) - 8
        values = array.array(DTYPES[element.get("type")])
        values.frombytes(data[8:])
        count = int(element.get("NumberOfComponents"))
        return list(values) if count == 1 else [tuple(values[i:i + count]) for i in range(0, len(values), count)]

    def triangles(self) -> list:
        corners = self.arrays["connectivity"]
        assert self.arrays["offsets"] == list(range(3, len(corners) + 1, 3))
        return [tuple(corners[i:i + 3]) for i in range(0, len(corners), 3)]


def area_vector(a, b, c) -> tuple:
    p, q = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
    return tuple((p[i - 2] * q[i - 1] - p[i - 1] * q[i - 2]) / 2 for i in range(3))


class Mesh(KeikoTest):
    def made(self, model: str, *options: str) -> Vtp:
        self.said = self.succeed("mesh", "-q", surface(model), "-o", "a.vtp", *options)
        return Vtp(self.folder / "a.vtp")

    def area(self, mesh: Vtp) -> float:
        points = mesh.arrays["Points"]
        return sum(math.hypot(*area_vector(*(points[i] for i in triangle))) for triangle in mesh.triangles())

    def test_a_sphere_has_its_radius_and_curvature_at_every_corner(self):
        mesh = self.made("rational-sphere.step", "--deviation", "0.05", "--field", "mean", "--field", "gauss")
        for point, normal in zip(mesh.arrays["Points"], mesh.arrays["normal"]):
            self.assertAlmostEqual(math.hypot(*point), 100, delta=1e-9)
            self.assertAlmostEqual(sum(p * n for p, n in zip(point, normal)), 100, delta=1e-6)
        mean = [value for value in mesh.arrays["mean"] if not math.isnan(value)]
        self.assertGreater(len(mean), 0.9 * len(mesh.arrays["mean"]))
        for value in mean:
            self.assertAlmostEqual(value, -0.01, delta=1e-9)  # it bends away from its outward normal
        for value in mesh.arrays["gauss"]:
            self.assertTrue(math.isnan(value) or abs(value - 1e-4) < 1e-10)

    def test_triangles_are_within_the_deviation_and_face_outwards(self):
        for mesher, deviation in (("opencascade", 1.0), ("opencascade", 0.05), ("spans", 1.0), ("spans", 0.05)):
            mesh = self.made("rational-sphere.step", "--deviation", str(deviation), "--mesher", mesher)
            points, volume = mesh.arrays["Points"], 0.0
            for a, b, c in mesh.triangles():
                middle = [sum(points[i][k] for i in (a, b, c)) / 3 for k in range(3)]
                self.assertLess(100 - math.hypot(*middle), deviation * 1.001)
                outward = area_vector(points[a], points[b], points[c])
                volume += sum(m * o for m, o in zip(middle, outward)) / 3
            self.assertAlmostEqual(volume / (4 / 3 * math.pi * 1e6), 1, delta=0.05 * deviation)
            stated = mesh.arrays["deviation_mm"][0]
            self.assertTrue(0 < stated <= deviation, stated)
            self.assertIn(f"within {stated:g} mm of the exact surface", self.said)

    def test_trims_are_cut_out(self):
        for mesher in "opencascade", "spans":
            whole, holed, two = (self.area(self.made(name, "--deviation", "0.01", "--mesher", mesher))
                                 for name in ("trimmed-island.step", "trimmed-hole.step", "trimmed-two-holes.step"))
            for area in whole, holed, two:
                self.assertGreater(area, 0)
            holes = math.pi * (30**2 + 15**2 - 40**2), math.pi * (60**2 - 25**2 - 40**2)
            # The sheet is curved: its area is a little more than that in plan view.
            self.assertAlmostEqual((holed - two) / holes[0], 1, delta=0.05)
            self.assertAlmostEqual((holed - whole) / holes[1], 1, delta=0.05)

    def test_the_area_of_every_kind_of_model_settles(self):
        for model in "bored-block.step", "dome.bpt", "cage-panel.obj", "facade.bpt", "pole.step":
            coarse = self.area(self.made(model, "--deviation", "0.1"))
            fine = self.area(self.made(model, "--deviation", "0.01"))
            self.assertAlmostEqual(coarse / fine, 1, delta=2e-3, msg=model)

    def test_ply_and_glb_hold_the_same_body(self):
        self.succeed("mesh", "-q", surface("dome.bpt"), "--field", "k1", "-o", "a.vtp", "-o", "a.ply", "-o", "a.glb")
        mesh = Vtp(self.folder / "a.vtp")
        points, triangles = mesh.arrays["Points"], mesh.triangles()
        data = (self.folder / "a.ply").read_bytes()
        header, body = data.split(b"end_header\n", 1)
        self.assertIn(f"element vertex {len(points)}\n".encode(), header)
        self.assertIn(f"element face {len(triangles)}\n".encode(), header)
        row = struct.Struct("<3d3f3Bd")
        for i, point in enumerate(points):
            numbers = row.unpack_from(body, i * row.size)
            self.assertEqual(numbers[:3], point)
            self.assertTrue(numbers[9] == mesh.arrays["k1"][i] or math.isnan(numbers[9]))
        faces = struct.Struct("<B3ii")
        self.assertEqual(len(body), len(points) * row.size + len(triangles) * faces.size)
        self.assertEqual(faces.unpack_from(body, len(points) * row.size)[1:4], triangles[0])
        data = (self.folder / "a.glb").read_bytes()
        magic, version, length, size, kind = struct.unpack_from("<4sIII4s", data)
        self.assertEqual((magic, version, length, kind), (b"glTF", 2, len(data), b"JSON"))
        document = json.loads(data[20:20 + size])
        position, normal, color, index = document["accessors"]
        self.assertEqual([position["count"], index["count"]], [len(points), 3 * len(triangles)])
        self.assertEqual(document["buffers"][0]["byteLength"], 36 * len(points) + 12 * len(triangles))
        extent = [high - low for low, high in zip(position["min"], position["max"])]
        for found, exact in zip(extent, (0.2, 0.05, 0.2)):  # metres, y upwards
            self.assertAlmostEqual(found, exact, delta=1e-6)

    def test_the_deviation_from_another_body_is_a_field(self):
        raised = [line.split() for line in Path(surface("dome.bpt")).read_text(encoding="utf-8").splitlines()]
        text = "".join(" ".join(words[:2] + [repr(float(words[2]) + 0.25)] if len(words) == 3 else words) + "\n"
                       for words in raised)
        self.write("raised.bpt", text)
        self.succeed("mesh", "-q", "raised.bpt", "--field", "deviation", "--against", surface("dome.bpt"),
                     "-o", "a.vtp")
        mesh = Vtp(self.folder / "a.vtp")
        inner = [value for point, value in zip(mesh.arrays["Points"], mesh.arrays["deviation"])
                 if max(map(abs, point[:2])) < 1]
        self.assertGreater(len(inner), 0)
        for value in inner:  # at the top it is the whole shift
            self.assertAlmostEqual(value, 0.25, delta=1e-3)

    def test_curves_are_polylines_within_their_deviation(self):
        self.keiko("check", "-q", surface("dome.bpt"), "--section", "y=0", "--iso-curves", "1", "--curves", "a.vtp")
        curves = Vtp(self.folder / "a.vtp")
        self.assertTrue(curves.names[0].startswith("section y=0, within "), curves.names)
        self.assertEqual(set(curves.arrays["curve"]), set(range(len(curves.names))))
        points, begin, on_section = curves.arrays["Points"], 0, 0
        for end, number, deviation in zip(curves.arrays["offsets"], curves.arrays["curve"],
                                          curves.arrays["deviation_mm"]):
            for x, y, z in points[begin:end]:
                exact = 50 * (1 - x * x / 1e4) * (1 - y * y / 1e4)
                self.assertAlmostEqual(z, exact, delta=deviation)
                on_section += number == 0 and abs(y) < 1e-6
            begin = end
        self.assertGreater(on_section, 10)

    def test_vtk_reads_it(self):
        try:
            from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
        except ImportError:
            self.skipTest("python3-vtk9 is not installed")
        mesh = self.made("dome.bpt", "--field", "mean")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "a.vtp"))
        reader.Update()
        read = reader.GetOutput()
        self.assertEqual((read.GetNumberOfPoints(), read.GetNumberOfPolys()),
                         (len(mesh.arrays["Points"]), len(mesh.triangles())))
        for i, point in enumerate(mesh.arrays["Points"]):
            self.assertEqual(read.GetPoint(i), point)
        mean = read.GetPointData().GetArray("mean")
        for i, value in enumerate(mesh.arrays["mean"]):
            self.assertTrue(mean.GetValue(i) == value or math.isnan(value))

    def test_the_files_do_not_depend_on_threads(self):
        made = []
        for n in "1", "2":
            self.succeed("mesh", "-q", surface("dent.step"), "--threads", n, "--field", "mean", "-o", n + ".ply")
            made.append((self.folder / (n + ".ply")).read_bytes())
        self.assertEqual(*made)

    def test_wrong_options_give_one_line(self):
        for arguments, reason in ((("-o", "a.stl"), "ends in none of .vtp, .ply and .glb"),
                                  (("-o", "a.vtp", "--field", "twist"), '"twist" is none of k1, k2, mean'),
                                  (("-o", "a.vtp", "--field", "deviation"), "--against: is missing"),
                                  (("-o", "a.ply", "--field", "k1", "--field", "k1"), "--field: names a field twice"),
                                  (("-o", "a.vtp", "--deviation", "0"), "--deviation"),
                                  (("-o", "a.ply", "--field", "k1", "--scale", "1"), "--scale: '1' is not MIN:MAX"),
                                  (("-o", "a.ply", "--deviation", "0.000001", "--import-timeout", "0.3"),
                                   "the mesher did not finish within 0.3 s"),
                                  (("-o", "a.ply", "--deviation", "0.000001", "--mesher", "spans"),
                                   "its mesh within 1e-06 mm has more than 50000000 cells or triangles")):
            run = self.keiko("mesh", "-q", surface("dome.bpt"), *arguments)
            self.assertEqual((run.returncode, run.stdout), (2, ""), arguments)
            self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
            self.assertIn(reason, run.stderr)
        self.assertEqual(self.content(), [])


if __name__ == "__main__":
    unittest.main()
