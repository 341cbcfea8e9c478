"""keiko view: what its server answers, and whom it refuses."""
import array
import http.client
import json
import math
import signal
import socket
import struct
import subprocess
import threading
import time
import tomllib
import unittest
import warnings
from pathlib import Path

from keiko_process import ASLANT, BINARY, SOURCE, KeikoTest, surface

try:
    import jsonschema
except ImportError:
    jsonschema = None

SCENE = surface("hood-scene.toml")
SCHEMA = SOURCE / "docs/schema/keiko-view.schema.json"
SIZE = (96, 54)
CAMERA = """[camera]
eye = [-2000, -1500, 1800]
target = [560, 0, 720]
vertical_fov = 28
size = [%d, %d]
"""
ROW = """[[c_plane]]
origin = [-3000, -2000, 3000]
u = [6000, 0, 0]
v = [0, 4000, 0]
lamps = 10
diameter = 60
luminance = 9000
"""
SAMPLE, BOUNCE, HEADER = 32, 36, 32


class Server:
    """A running `keiko view`."""

    def __init__(self, folder: Path, *arguments: str):
        self.process = subprocess.Popen(
            [BINARY, "view", *(arguments or (SCENE, "--size", "%dx%d" % SIZE)), "--no-browser"],
            cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.address = self.process.stdout.readline().strip()
        if not self.address:
            raise AssertionError(self.process.communicate()[1])
        place, _, self.token = self.address.partition("/#token=")
        self.port = int(place.rpartition(":")[2])

    def headers(self, **more: str) -> dict:
        named = {name.replace("_", "-"): value for name, value in more.items()}
        return {"X-Keiko-Token": self.token, **named}

    def connect(self) -> http.client.HTTPConnection:
        return http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)

    def ask(self, method: str, path: str, body: str = "", headers: dict | None = None):
        """Status, headers and bytes of an answer."""
        connection = self.connect()
        try:
            connection.request(method, path, None if method == "GET" else body.encode(),
                               self.headers() if headers is None else headers)
            reply = connection.getresponse()
            return reply.status, reply.headers, reply.read()
        finally:
            connection.close()

    def stop(self, by: int = signal.SIGINT) -> tuple:
        """Exit code, errors and the seconds until the end."""
        begin = time.monotonic()
        self.process.send_signal(by)
        _, errors = self.process.communicate(timeout=20)
        return self.process.returncode, errors, time.monotonic() - begin

    def close(self):
        if self.process.returncode is None:
            self.process.kill()
            self.process.communicate()


def require_faults(faults: dict):
    """Fails unless faults keep to their schema, which refers to that of profiles."""
    if not jsonschema:
        return
    path = SCHEMA.parent / "keiko-faults.schema.json"
    schema = json.loads(path.read_text())
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        resolver = jsonschema.RefResolver(path.as_uri(), schema)
        jsonschema.Draft202012Validator(schema, resolver=resolver).validate(faults)


def passes(message: bytes) -> list:
    """The messages of keiko-deep/1: sizes, samples and bounces of each."""
    found, at = [], 0
    while at < len(message):
        assert message[at:at + 8] == b"KEIKOD1\n"
        sizes = struct.unpack_from("<6I", message, at + 8)
        samples = at + HEADER
        bounces = samples + sizes[4] * SAMPLE
        at = bounces + sizes[5] * BOUNCE
        found.append((sizes, message[samples:bounces], message[bounces:at]))
    assert at == len(message)
    return found


class ViewTest(KeikoTest):
    def serve(self, *arguments: str) -> Server:
        server = Server(self.folder, *arguments)
        self.addCleanup(server.close)
        return server

    def error_of(self, answer: tuple, status: int) -> str:
        self.assertEqual(answer[0], status, answer[2][:300])
        return json.loads(answer[2])["error"]

    def view_file(self, camera: dict) -> str:
        return 'format = "keiko-view/1"\n' + "".join(
            f"{key} = {json.dumps(camera[key])}\n" for key in ("eye", "target", "up", "vertical_fov"))


class Refusals(ViewTest):
    """One server for all: none of these may harm it."""

    def setUp(self):
        super().setUp()
        self.server = self.serve()
        self.addCleanup(lambda: self.assertEqual(self.server.ask("GET", "/scene")[0], 200))

    def raw(self, text: str, then_close: bool = False) -> bytes:
        """What is answered to bytes, until the server or the client closes."""
        with socket.create_connection(("127.0.0.1", self.server.port), timeout=20) as line:
            line.sendall(text.encode())
            if then_close:
                line.shutdown(socket.SHUT_WR)
            answer = b""
            while piece := line.recv(65536):
                answer += piece
            return answer

    def head(self, line: str, **more: str) -> str:
        fields = {"Host": f"127.0.0.1:{self.server.port}", **self.server.headers(**more)}
        return line + " HTTP/1.1\r\n" + "".join(f"{k}: {v}\r\n" for k, v in fields.items()) + "\r\n"

    def test_without_a_token(self):
        for headers in {}, {"X-Keiko-Token": ""}, {"X-Keiko-Token": "0" * 32}:
            for method, path in ("GET", "/scene"), ("POST", "/deep"), ("PUT", "/rig"), ("GET", "/nothing"):
                self.assertIn("token", self.error_of(self.server.ask(method, path, "", headers), 401))

    def test_a_foreign_host(self):
        for host in "example.com", f"example.com:{self.server.port}", "127.0.0.1", "127.0.0.1:1", "":
            for path in "/scene", "/":
                answer = self.server.ask("GET", path, "", self.server.headers(Host=host))
                self.assertIn("host", self.error_of(answer, 403))

    def test_the_own_host_by_both_names(self):
        for name in "127.0.0.1", "localhost":
            headers = self.server.headers(Host=f"{name}:{self.server.port}")
            self.assertEqual(self.server.ask("GET", "/scene", "", headers)[0], 200)

    def test_a_foreign_origin(self):
        port = self.server.port
        for origin in "http://example.com", "null", f"https://127.0.0.1:{port}", f"http://127.0.0.1:{port}.example.com":
            answer = self.server.ask("POST", "/deep", "", self.server.headers(Origin=origin))
            self.assertIn("another server", self.error_of(answer, 403))
        own = self.server.headers(Origin=f"http://127.0.0.1:{port}")
        self.assertEqual(self.server.ask("POST", "/deep", "", own)[0], 200)

    def test_a_body_that_is_too_large_is_not_read(self):
        answer = self.raw(self.head("POST /deep", Content_Length=str(1 << 30)) + "x" * 1000)
        self.assertIn(b" 413 ", answer.split(b"\r\n")[0])
        self.assertEqual(answer.count(b"HTTP/1.1"), 1, "the body was taken for a request")

    def test_a_refused_body_is_no_second_request(self):
        inner = self.head("GET /scene")
        outer = self.head("POST /deep", Origin="http://example.com", Content_Length=str(len(inner)))
        answer = self.raw(outer + inner)
        self.assertIn(b" 403 ", answer.split(b"\r\n")[0])
        self.assertEqual(answer.count(b"HTTP/1.1"), 1)

    def test_bodies_without_a_plain_length(self):
        for fields in {"Transfer_Encoding": "chunked"}, {}, {"Content_Length": "-1"}, {"Content_Length": "ten"}:
            answer = self.raw(self.head("POST /deep", **fields) + "0\r\n\r\n")
            self.assertIn(b" 411 ", answer.split(b"\r\n")[0], fields)
        packed = self.head("POST /deep", Content_Length="4", Content_Encoding="gzip") + "abcd"
        self.assertIn(b" 415 ", self.raw(packed).split(b"\r\n")[0])

    def test_half_a_body(self):
        answer = self.raw(self.head("POST /deep", Content_Length="100") + "[camera]\n", then_close=True)
        self.assertNotIn(b" 200 ", answer.split(b"\r\n")[0])

    def test_other_methods_and_paths(self):
        self.error_of(self.server.ask("DELETE", "/rig"), 405)
        self.error_of(self.server.ask("GET", "/nothing"), 404)
        self.error_of(self.server.ask("GET", "/../../etc/passwd"), 404)

    def test_requests_that_say_nonsense(self):
        for body, word in (("camera = 3", "camera"), ("[camera]\neye = [0, 0, 0]\ntarget = [0, 0, 0]", "target"),
                           ("nonsense = 1", "nonsense"), ("not toml", "request"), ("reflections = 9", "reflections"),
                           (CAMERA % (60000, 60000), "pixels"), ("[[c_plane]]\nlamps = 0", "origin")):
            self.assertIn(word, self.error_of(self.server.ask("POST", "/deep", body), 400))

    def test_a_rig_may_name_no_file(self):
        secret = self.folder / "secret.ies"
        for rig in (f'[[luminaire]]\nposition = [0, 0, 1]\nfile = "{secret}"\n',
                    f'[fog]\nextinction = 1\ndensity = "{secret}"\n'):
            answer = self.server.ask("PUT", "/rig", 'format = "keiko-rig/1"\n' + rig + ROW)
            self.assertIn("may not name a file", self.error_of(answer, 400))

    def test_a_client_of_a_strange_name(self):
        answer = self.server.ask("GET", "/scene", "", self.server.headers(X_Keiko_Client="a b"))
        self.assertIn("X-Keiko-Client", self.error_of(answer, 400))


class Answers(ViewTest):
    def setUp(self):
        super().setUp()
        self.server = self.serve()

    def json_of(self, method: str, path: str, body: str = "") -> dict:
        status, headers, text = self.server.ask(method, path, body)
        self.assertEqual((status, headers["Content-Type"]), (200, "application/json"), text[:300])
        answer = json.loads(text)
        if jsonschema and answer["format"].startswith("keiko-view-"):
            jsonschema.validate(answer, json.loads(SCHEMA.read_text()))
        if answer["format"] == "keiko-faults/1":
            require_faults(answer)
        return answer

    def test_the_page_and_its_safety(self):
        for path, kind in ("/", "text/html"), ("/viewer.js", "text/javascript"), ("/viewer.css", "text/css"):
            status, headers, text = self.server.ask("GET", path, "", {})
            self.assertEqual(status, 200)
            self.assertTrue(headers["Content-Type"].startswith(kind))
            self.assertIn("default-src 'self'", headers["Content-Security-Policy"])
            self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
            self.assertNotIn(self.server.token.encode(), text)

    def test_the_deep_buffer_in_rows(self):
        body = "interlaced = false\n" + CAMERA % SIZE
        (sizes, samples, bounces), = passes(self.server.ask("POST", "/deep", body)[2])
        self.assertEqual(sizes[:5], (*SIZE, 0, 1, SIZE[0] * SIZE[1]))
        parts = passes(self.server.ask("POST", "/deep", CAMERA % SIZE)[2])
        self.assertEqual([part[0][2:4] for part in parts], [(0, 8), (4, 8), (2, 4), (1, 2)])
        row = SIZE[0] * SAMPLE
        whole = bytearray(len(samples))
        for (_, _, first, step, _, _), of_rows, _ in parts:
            for number in range(len(of_rows) // row):
                y = first + number * step
                whole[y * row:(y + 1) * row] = of_rows[number * row:(number + 1) * row]
        self.assertEqual(bytes(whole), samples)
        records = [b[i:i + BOUNCE] for _, _, b in parts for i in range(0, len(b), BOUNCE)]
        records.sort(key=lambda record: struct.unpack_from("<I", record))
        self.assertEqual(b"".join(records), bounces)

    def test_the_deep_buffer_holds_the_hits_of_its_rays(self):
        body = "interlaced = false\n" + CAMERA % (3, 3)
        (_, samples, _), = passes(self.server.ask("POST", "/deep", body)[2])
        numbers = array.array("f", samples)
        eye, target = (-2000, -1500, 1800), (560, 0, 720)
        way = [t - e for t, e in zip(target, eye)]
        ray = ",".join(map(str, (*eye, *way))) + "\n"
        run = self.keiko("trace", SCENE, "--out", "t,face", input=ray)
        t, face = run.stdout.splitlines()[1].split(",")
        middle = 8 * 4
        length = sum(x * x for x in way) ** 0.5
        self.assertAlmostEqual(numbers[middle], float(t) * length, delta=1e-3)
        self.assertEqual(int(numbers[middle + 7]) - 1, int(face) - 1)

    def test_the_still_is_the_picture_that_render_writes(self):
        self.succeed("render", SCENE, "-o", "file.png", "--size", "%dx%d" % SIZE)
        status, headers, png = self.server.ask("POST", "/still")
        self.assertEqual((status, headers["Content-Type"]), (200, "image/png"))
        self.assertEqual(png, (self.folder / "file.png").read_bytes())

    def test_the_still_of_another_view_and_other_lamps(self):
        rig = 'format = "keiko-rig/1"\n' + ROW
        self.write("rig.toml", rig)
        view = (CAMERA % SIZE).replace("[camera]\n", "")
        self.write("eye.toml", 'format = "keiko-view/1"\n' + view[:view.index("size")])
        self.succeed("render", surface("hood.step"), "-o", "file.png", "--size", "%dx%d" % SIZE,
                     "--rig", "rig.toml", "--view", "eye.toml")
        server = self.serve(surface("hood.step"), "--size", "%dx%d" % SIZE)
        expected = (self.folder / "file.png").read_bytes()
        asked = server.ask("POST", "/still", CAMERA % SIZE + ROW)[2]
        self.assertEqual(asked, expected)
        self.assertNotEqual(server.ask("POST", "/still", CAMERA % SIZE)[2], expected)
        self.assertEqual(server.ask("PUT", "/rig", rig)[0], 200)
        self.assertEqual(server.ask("POST", "/still", CAMERA % SIZE)[2], expected)

    def test_the_rig_as_a_file_and_in_numbers(self):
        before = tomllib.loads(self.server.ask("GET", "/rig")[2].decode())
        numbers = self.json_of("GET", "/scene")["rig"]["planes"]
        self.assertEqual([p["lamps"] for p in before["c_plane"]], [p["lamps"] for p in numbers])
        changed = tomllib.loads(self.server.ask("POST", "/rig", ROW)[2].decode())
        self.assertEqual(len(changed["c_plane"]), 1)
        self.assertEqual(changed["c_plane"][0]["lamps"], 10)
        self.assertEqual(tomllib.loads(self.server.ask("GET", "/rig")[2].decode()), before)
        new = self.json_of("PUT", "/rig", 'format = "keiko-rig/1"\n' + ROW)
        self.assertEqual([p["lamps"] for p in new["planes"]], [10])
        self.assertEqual(self.json_of("GET", "/scene")["rig"], new)

    def test_facts_seams_lines_and_placement(self):
        self.assertEqual(self.json_of("GET", "/facts")["format"], "keiko-model-facts/1")
        self.keiko("check", SCENE, "--json", "check.json")
        self.assertEqual(self.json_of("GET", "/seams"), json.loads((self.folder / "check.json").read_text()))
        lines = self.json_of("POST", "/lines")
        self.assertEqual(lines["format"], "keiko-lines/2")
        self.assertGreater(len(lines["lines"]), 0)
        placed = self.json_of("POST", "/place", CAMERA % SIZE)
        self.assertGreater(placed["coverage"], 0.5)
        self.assertGreater(len(placed["rig"]["planes"]), 0)

    def test_the_faults_are_those_of_the_check_with_places_and_profiles(self):
        model = surface("seam-g1-angle.step")
        self.server = self.serve(model)
        faults = self.json_of("GET", "/inspect")
        self.keiko("check", model, "--json", "check.json", "--profiles", "profiles.json")
        check = json.loads((self.folder / "check.json").read_text())
        profiles = json.loads((self.folder / "profiles.json").read_text())["profiles"]
        self.assertEqual((faults["format"], faults["verdict"]), ("keiko-faults/1", "fail"))
        covered = [number for item in faults["items"] + faults["hidden"] for number in item["findings"]]
        self.assertEqual(sorted(covered), list(range(1, len(check["findings"]) + 1)))
        fault = faults["items"][0]
        self.assertEqual(fault["mending"], "tangent")
        worst = check["findings"][fault["findings"][0] - 1]
        self.assertEqual((fault["message"], fault["faces"]), (worst["message"], worst["faces"]))
        self.assertEqual(fault["profile"], profiles[fault["seams"][0] - 1])
        ends = [sample["place"] for sample in fault["profile"]["samples"]]
        near = min(sum((a - b) ** 2 for a, b in zip(place, fault["place"])) ** 0.5 for place in ends)
        self.assertLess(near, fault["length"] / 10)

    def test_a_picked_place_is_that_of_a_ray(self):
        picked = self.json_of("POST", "/pick", "pixel = [48.5, 27.5]\n" + CAMERA % SIZE)["picked"]
        eye = (-2000, -1500, 1800)
        ray = ",".join(repr(x) for x in (*eye, *(p - e for p, e in zip(picked["place"], eye)))) + "\n"
        row = self.keiko("trace", SCENE, "--out", "t,face", input=ray).stdout.splitlines()[1].split(",")
        self.assertAlmostEqual(float(row[0]), 1, delta=1e-9)
        self.assertEqual(int(row[1]), picked["face"])
        for low, high in picked["curvatures"]:
            self.assertLess(high - low, 1e-5)
        self.assertIn("pixel", self.error_of(self.server.ask("POST", "/pick", CAMERA % SIZE), 400))

    def test_a_stretch_has_its_course_and_its_profile(self):
        model = surface("seam-g1-angle.step")
        self.server = self.serve(model)
        self.keiko("check", model, "--json", "check.json", "--profiles", "profiles.json")
        seams = json.loads((self.folder / "check.json").read_text())["seams"]
        profiles = json.loads((self.folder / "profiles.json").read_text())["profiles"]
        for seam, profile in zip(seams, profiles, strict=True):
            self.assertEqual(self.json_of("POST", "/profile", str(seam["number"]))["profiles"], [profile])
            ends = seam["course"][0][0], seam["course"][-1][-1]
            self.assertEqual(ends, (seam["from"], seam["to"]))
            chords = sum(math.dist(a, b) for piece in seam["course"] for a, b in zip(piece, piece[1:]))
            self.assertAlmostEqual(chords, seam["length"], delta=1e-3 * seam["length"])
        for number in "", "0", "1.5", "one", str(len(seams) + 1), "99999999999999999999":
            self.assertIn("number of a stretch", self.error_of(self.server.ask("POST", "/profile", number), 400))

    def test_lines_of_the_lamps_add_faults_of_the_view(self):
        self.write("aslant.toml", ASLANT)
        self.server = self.serve(surface("seam-g1-angle.step"), "--rig", "aslant.toml")
        geometry = self.json_of("GET", "/inspect")
        with_lines = self.json_of("POST", "/inspect")
        self.keiko("inspect", surface("seam-g1-angle.step"), "-o", "out", "--rig", "aslant.toml", "--view", "auto", "-q")
        self.assertEqual(with_lines, json.loads((self.folder / "out/faults.json").read_text()))
        self.assertGreater(sum(len(item["findings"]) for item in with_lines["items"]),
                           sum(len(item["findings"]) for item in geometry["items"]))
        self.assertIn("C-plane", self.error_of(self.server.ask("POST", "/inspect", "c_plane = []"), 400))

    def test_hidden_faces_show_what_they_hid(self):
        def faces(body: str) -> set:
            samples = passes(self.server.ask("POST", "/deep", "interlaced = false\n" + body + CAMERA % SIZE)[2])[0][1]
            return set(array.array("f", samples)[7::8])
        whole = faces("")
        listed = self.json_of("GET", "/facts")["face_list"]
        gone = int(max(whole))
        left = faces(f"hidden = [{listed[gone - 1]['id']}]\n")
        self.assertEqual(left - {0}, whole - {0, gone})
        self.assertEqual(faces("hidden = [%s]\n" % ", ".join(str(face["id"]) for face in listed)), {0})
        self.assertIn("no face 99999", self.error_of(self.server.ask("POST", "/deep", "hidden = [99999]"), 400))

    def test_a_section_is_that_of_the_check(self):
        self.keiko("check", SCENE, "--section", "y=120", "--combs", "combs.json")
        status, _, text = self.server.ask("POST", "/section", "y=120")
        self.assertEqual((status, text), (200, (self.folder / "combs.json").read_bytes()))
        self.assertIn("section", self.error_of(self.server.ask("POST", "/section", "y="), 400))

    def test_errors_of_long_answers_are_answers(self):
        self.error_of(self.server.ask("POST", "/lines", "c_plane = []"), 400)


class Reports(ViewTest):
    """A folder of keiko inspect, opened again."""

    def setUp(self):
        super().setUp()
        self.write("gap.step", Path(surface("seam-g1-angle.step")).read_text())
        self.keiko("inspect", "gap.step", "-o", "out", "--view", "high-front", "--view", "top", "--size", "96x54")

    def scene_of(self, server: Server) -> dict:
        return json.loads(server.ask("GET", "/scene")[2])

    def test_rig_views_and_findings_are_those_of_the_inspection(self):
        server = self.serve("out")
        scene = self.scene_of(server)
        report = json.loads((self.folder / "out/report.json").read_text())
        self.assertEqual(report["opened"], ["gap.step"])
        self.assertEqual((scene["view"], scene["own_views"], scene["remarks"]), ("high-front", report["views"], []))
        self.assertEqual(scene["camera"], report["views"][0]["camera"])
        self.write("eye.toml", self.view_file(scene["camera"]))
        self.succeed("render", "gap.step", "-o", "file.png", "--rig", "out/rig.toml", "--view", "eye.toml",
                     "--size", "96x54")
        self.assertEqual(server.ask("POST", "/still")[2], (self.folder / "file.png").read_bytes())
        self.assertEqual(server.ask("GET", "/inspect")[2], (self.folder / "out/faults.json").read_bytes())
        self.assertEqual(server.ask("GET", "/seams")[2], (self.folder / "out/report.json").read_bytes())
        self.keiko("check", "gap.step", "--profiles", "profiles.json")
        profiles = json.loads((self.folder / "profiles.json").read_text())["profiles"]
        for seam, profile in zip(report["seams"], profiles, strict=True):
            answer = server.ask("POST", "/profile", str(seam["number"]))
            self.assertEqual(json.loads(answer[2])["profiles"], [profile])
        self.assertIn("no stretch", self.error_of(server.ask("POST", "/profile", "99"), 400))

    def test_another_of_its_views_in_another_size(self):
        scene = self.scene_of(self.serve("out", "--view", "top", "--size", "48x27"))
        self.assertEqual((scene["view"], scene["camera"]["width"], scene["camera"]["height"]), ("top", 48, 27))

    def test_a_changed_model_is_told_and_its_findings_stay(self):
        self.write("gap.step", Path(surface("seam-g0-gap.step")).read_text())
        server = self.serve("out")
        remark, = self.scene_of(server)["remarks"]
        self.assertEqual(remark["entity"], "gap.step")
        self.assertIn("has changed since the inspection", remark["message"])
        self.assertEqual(server.ask("GET", "/inspect")[2], (self.folder / "out/faults.json").read_bytes())
        self.assertIn("gap.step: has changed since the inspection", server.stop()[1])

    def test_a_report_that_cannot_be_opened_says_why(self):
        good = (self.folder / "out/report.json").read_text()

        def error_of() -> str:
            run = self.keiko("view", "out", "--no-browser")
            self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)
            return run.stderr
        for wrong, reason in (("{", "no JSON at line 1, column 2"), ("{}", "is not of the format keiko-report/1"),
                              (good.replace('"opened"', '"closed"'), "a key is missing"),
                              (good.replace('"width": 96', '"width": 0'), "width: and height must be from 1 to 16384"),
                              (good.replace('"gap.step"\n ],\n "views"', '"none.step"\n ],\n "views"'), "none.step")):
            self.write("out/report.json", wrong)
            self.assertIn("out/report.json", error_of())
            self.assertIn(reason, error_of())
        self.write("out/report.json", good)
        self.write("out/faults.json", '{"format": "keiko-faults/1", "items": [{}], "hidden": []}')
        self.assertIn("out/faults.json:items: a key is missing", error_of())
        (self.folder / "out/faults.json").unlink()
        self.assertIn("out/faults.json", error_of())


class Against(ViewTest):
    """An earlier revision beside the scene."""

    def test_both_revisions_under_one_eye_and_the_same_lamps(self):
        models = surface("seam-g1-angle.step"), surface("seam-g1-only.step")
        server = self.serve(models[0], "--against", models[1], "--size", "%dx%d" % SIZE, "--view", "top")
        scene, earlier = (json.loads(server.ask("GET", path)[2]) for path in ("/scene", "/against/scene"))
        self.assertEqual((scene["against"], earlier["against"]), (True, False))
        self.assertEqual((scene["inputs"], earlier["inputs"]), ([Path(models[0]).name], [Path(models[1]).name]))
        self.assertEqual((scene["camera"], scene["rig"]), (earlier["camera"], earlier["rig"]))
        deep, before = (passes(server.ask("POST", path, "interlaced = false")[2])[0]
                        for path in ("/deep", "/against/deep"))
        self.assertEqual(deep[0][:5], before[0][:5])
        self.assertNotEqual(deep[1], before[1])
        alone = self.serve(models[1], "--size", "%dx%d" % SIZE)
        camera = "".join(f"{key} = {json.dumps(scene['camera'][key])}\n" for key in ("eye", "target", "up", "vertical_fov"))
        body = f"interlaced = false\n[camera]\n{camera}size = [{SIZE[0]}, {SIZE[1]}]\n"
        self.assertEqual(passes(alone.ask("POST", "/deep", body)[2])[0], before)

    def test_without_an_earlier_revision_there_is_none(self):
        self.error_of(self.serve(surface("saddle.bpt")).ask("POST", "/against/deep"), 404)

    def test_an_earlier_revision_that_is_missing(self):
        run = self.keiko("view", surface("saddle.bpt"), "--against", "none.step", "--no-browser")
        self.assertEqual((run.returncode, run.stderr.count("\n")), (2, 1), run.stderr)
        self.assertIn("none.step", run.stderr)


class Reflected(ViewTest):
    """Pictures with the light of a solution."""

    LIT = """format = "keiko-scene/1"
[[primitive]]
kind = "box"
origin = [-300, -200, 0]
u = [600, 0, 0]
v = [0, 400, 0]
w = [0, 0, 300]
material = { diffuse = 0.7, refractive_index = 1 }
[[primitive]]
kind = "plane"
origin = [-1500, -1500, 0]
u = [3000, 0, 0]
v = [0, 3000, 0]
material = { diffuse = 0.7, refractive_index = 1 }
[radiosity]
element = 800
rays = 64
""" + ROW + (CAMERA % SIZE).replace("560, 0, 720", "0, 0, 0")

    def setUp(self):
        super().setUp()
        self.write("scene.toml", self.LIT)
        self.succeed("radiosity", "scene.toml", "-o", "a.solution")

    def lit(self, *more: str) -> Server:
        return self.serve("scene.toml", "--shadows", *more)

    def rendered(self, scene: str, *more: str) -> bytes:
        self.write("other.toml", scene)
        self.succeed("render", "other.toml", "--shadows", "-o", "file.png", *more)
        return (self.folder / "file.png").read_bytes()

    def test_the_still_is_that_of_render(self):
        still = self.lit("--solution", "a.solution").ask("POST", "/still")[2]
        self.assertEqual(still, self.rendered(self.LIT, "--solution", "a.solution"))
        self.assertNotEqual(still, self.lit().ask("POST", "/still")[2])

    def test_lamps_at_other_levels_reflect_theirs(self):
        server = self.lit("--solution", "a.solution")
        brighter = ROW.replace("9000", "[9000, 2000, 500]")
        expected = self.rendered(self.LIT.replace(ROW, brighter), "--solution", "a.solution")
        self.assertEqual(server.ask("PUT", "/rig", 'format = "keiko-rig/1"\n' + brighter)[0], 200)
        for _ in range(2):  # the second is of the light that was kept
            self.assertEqual(server.ask("POST", "/still")[2], expected)

    def test_the_rows_as_the_page_knows_them_are_those_of_the_solution(self):
        server = self.lit("--solution", "a.solution")
        row, = json.loads(server.ask("GET", "/scene")[2])["rig"]["planes"]
        table = "[[c_plane]]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in row.items())
        status, _, still = server.ask("POST", "/still", table)
        self.assertEqual((status, still), (200, server.ask("POST", "/still")[2]))

    def test_moved_lamps_are_refused_with_the_reason(self):
        server = self.lit("--solution", "a.solution")
        error = self.error_of(server.ask("POST", "/still", ROW.replace("2000, 3000", "2000, 3001")), 400)
        self.assertEqual(error, "a.solution:lighting: is of other lamps, beside their levels, "
                                "or other reflectances than scene.toml")
        self.assertEqual(server.ask("POST", "/still")[0], 200)

    def test_what_has_no_such_light_is_refused_in_one_line(self):
        self.write("other.toml", self.LIT.replace("0.7", "0.6"))
        folder = self.folder / "out"
        folder.mkdir()
        (folder / "report.json").write_text("{}")
        for arguments, reason in (
            (("other.toml", "--shadows"), "a.solution:lighting: is of other lamps"),
            (("scene.toml",), "--solution requires --shadows"),
            (("scene.toml", "--shadows", "--rig", "auto"), "--solution excludes --rig"),
            (("scene.toml", "--shadows", "--against", "other.toml"), "excludes --"),
            (("out", "--shadows"), "out: is a report, whose pictures have no light of a --solution"),
        ):
            run = self.keiko("view", *arguments, "--solution", "a.solution", "--no-browser")
            self.assertEqual((run.returncode, run.stdout), (2, ""), arguments)
            self.assertIn(reason, run.stderr)
            self.assertEqual(run.stderr.count("\n"), 1, run.stderr)


class Clients(ViewTest):
    """Who leaves, who is in a hurry, and who is one of two."""

    def setUp(self):
        super().setUp()
        self.server = self.serve(surface("concept-car-scene.toml"), "--size", "1600x900")

    def begin_still(self, client: str) -> http.client.HTTPConnection:
        connection = self.connect()
        connection.request("POST", "/still", b"", self.server.headers(X_Keiko_Client=client))
        return connection

    def connect(self) -> http.client.HTTPConnection:
        connection = self.server.connect()
        self.addCleanup(connection.close)
        return connection

    def processor_seconds(self) -> float:
        fields = Path(f"/proc/{self.server.process.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / 100

    def rests(self) -> bool:
        """True once the server has done nothing for a fifth of a second."""
        for _ in range(40):
            before = self.processor_seconds()
            time.sleep(0.2)
            if self.processor_seconds() - before < 0.05:
                return True
        return False

    def test_a_client_that_goes_ends_its_still(self):
        connection = self.begin_still("a")
        time.sleep(0.4)
        self.assertFalse(connection.sock is None)
        busy = self.processor_seconds()
        time.sleep(0.2)
        self.assertGreater(self.processor_seconds(), busy, "the still was over before the client went")
        connection.close()
        begin = time.monotonic()
        self.assertTrue(self.rests())
        self.assertLess(time.monotonic() - begin, 2)

    def test_a_newer_still_ends_the_older_one_of_its_client_alone(self):
        first, other = self.begin_still("a"), self.begin_still("b")
        time.sleep(0.3)
        second = self.begin_still("a")
        with self.assertRaises((http.client.HTTPException, ConnectionError)):
            first.getresponse().read()
        pictures = {connection.getresponse().read() for connection in (second, other)}
        self.assertEqual(len(pictures), 1)
        self.assertTrue(pictures.pop().startswith(b"\x89PNG"))

    def test_progress_of_the_own_work(self):
        listener = self.connect()
        listener.request("GET", "/events", headers=self.server.headers(X_Keiko_Client="a"))
        events = listener.getresponse()
        self.assertEqual(events.headers["Content-Type"], "text/event-stream")
        self.begin_still("a")
        seen = []
        while len(seen) < 3 or seen[-1]["fraction"] < 1:
            line = events.readline().decode()
            if line.startswith("data: "):
                seen.append(json.loads(line[6:]))
        self.assertEqual({event["work"] for event in seen}, {"still"})
        self.assertEqual({event["stage"] for event in seen}, {"render"})
        fractions = [event["fraction"] for event in seen]
        self.assertEqual(fractions, sorted(fractions))

    def test_ctrl_c_while_all_kinds_of_work_are_under_way(self):
        open_lines = [self.begin_still("a"), self.connect(), self.connect()]
        open_lines[1].request("GET", "/events", headers=self.server.headers(X_Keiko_Client="a"))
        open_lines[2].request("GET", "/seams", headers=self.server.headers())
        time.sleep(0.5)
        code, errors, seconds = self.server.stop()
        self.assertEqual(code, 130)
        self.assertTrue(errors.endswith("keiko: interrupted\n"), errors)
        self.assertLess(seconds, 4)

    def test_two_pages_at_once(self):
        answers = {}

        def ask(client: str):
            body = "interlaced = false\n" + CAMERA % (480, 270)
            answers[client] = self.server.ask("POST", "/deep", body, self.server.headers(X_Keiko_Client=client))[2]
        pages = [threading.Thread(target=ask, args=(client,)) for client in "ab"]
        for page in pages:
            page.start()
        for page in pages:
            page.join()
        self.assertEqual(answers["a"], answers["b"])
        self.assertEqual(len(passes(answers["a"])), 1)


class Start(ViewTest):
    def test_the_address_and_a_port_of_choice(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        server = self.serve(surface("saddle.bpt"), "--port", str(port))
        self.assertRegex(server.address, rf"^http://127\.0\.0\.1:{port}/#token=[0-9a-f]{{32}}$")
        second = self.keiko("view", surface("saddle.bpt"), "--no-browser", "--port", str(port))
        self.assertEqual(second.returncode, 2)
        self.assertRegex(second.stderr, r"^keiko: --port: .*taken\n$")
        self.assertEqual(server.stop(signal.SIGTERM)[0], 130)

    def test_only_this_machine_can_connect(self):
        server = self.serve(surface("saddle.bpt"))
        listening = subprocess.run(["cat", "/proc/net/tcp"], capture_output=True, text=True, check=True).stdout
        own = [line.split()[1] for line in listening.splitlines()[1:] if line.split()[3] == "0A"]
        self.assertIn(f"0100007F:{server.port:04X}", own)

    def test_tokens_differ(self):
        tokens = {self.serve(surface("saddle.bpt")).token for _ in range(2)}
        self.assertEqual(len(tokens), 2)

    def test_a_missing_model(self):
        run = self.keiko("view", "none.step", "--no-browser")
        self.assertEqual(run.returncode, 2)
        self.assertEqual(run.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
