"""`keiko accept`, and what accepted findings do to `keiko check` and `keiko inspect`."""
import json
import unittest
import xml.etree.ElementTree as ElementTree

from keiko_process import ASLANT, SMALL, SOURCE, KeikoTest, surface
from sarif_rules import faults_of_log

GAP = surface("seam-g0-gap.step")
SCHEMA = SOURCE / "docs/schema/keiko-accepted.schema.json"
DAY = ("--today", "2026-11-27")
UNJUDGED = r"\Akeiko: warning: the curvature was not judged where what comes before it fails and is accepted: seam 1 \(face 1.*\)\n\Z"


class Accept(KeikoTest):
    def accept(self, *arguments: str, why: str = "hidden by the trim", day: tuple = DAY):
        return self.keiko("accept", *arguments, "--why", why, "--who", "Ann", "-o", "ok.json", "-q", *day)

    def accept_gap(self, *arguments: str):
        """The gap of the fixture, accepted in ok.json."""
        self.keiko("check", GAP, "--json", "report.json", "-q")
        run = self.accept("report.json", "1", *arguments)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return run.stdout

    def check(self, *arguments: str, day: str = "2026-12-24"):
        return self.keiko("check", *arguments, "--accepted", "ok.json", "--today", day, "-q")

    def test_an_accepted_finding_has_no_part_in_the_verdict(self):
        text = self.accept_gap("--until", "2027-01-31")
        self.assertRegex(text, r"\Aaccepted G-SU-LG at .*: hidden by the trim \(Ann, 2026-11-27, until 2027-01-31\)\n"
                               r"1 finding accepted in ok.json\n\Z")
        run = self.check(GAP, "--json", "a.json", "--junit", "a.xml", "--sarif", "a.sarif")
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stderr, UNJUDGED)
        self.assertRegex(run.stdout, r"\Apass: stretches of seams 0 fail, 0 undecided, 0 pass, 0 creases, 1 accepted")
        self.assertIn("\n1 accepted, no part of the verdict:\naccepted  G-SU-LG  face 1", run.stdout)
        report = json.loads((self.folder / "a.json").read_text())
        self.assertEqual((report["verdict"], report["findings"], len(report["accepted"])), ("pass", [], 1))
        suite = ElementTree.parse(self.folder / "a.xml").getroot().find("testsuite")
        self.assertEqual((suite.get("failures"), suite.get("errors")), ("0", "0"))
        log = json.loads((self.folder / "a.sarif").read_text())
        self.assertEqual(faults_of_log(log), [])
        result, = log["runs"][0]["results"]
        self.assertEqual(result["suppressions"][0]["kind"], "external")

    def test_it_expires_aloud(self):
        self.accept_gap("--until", "2027-01-31")
        self.assertEqual(self.check(GAP, day="2027-01-31").returncode, 0)
        run = self.check(GAP, day="2027-02-01")
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, r"\Akeiko: warning: the acceptance of G-SU-LG at .* expired on 2027-01-31\n\Z")

    def test_what_covers_nothing_is_told(self):
        self.accept_gap()
        run = self.check(surface("seam-g2-only.step"))
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stderr, r"\Akeiko: warning: the acceptance of G-SU-LG at .* covers nothing any more: .*\n\Z")

    def test_a_worse_finding_is_not_covered(self):
        self.accept_gap()
        kept = json.loads((self.folder / "ok.json").read_text())
        kept["accepted"][0]["value"] /= 1.2
        self.write("ok.json", json.dumps(kept))
        run = self.check(GAP)
        self.assertEqual(run.returncode, 1)
        self.assertIn("does not cover the finding there, which is worse than what was accepted: 0.05 instead of 0.0417 mm", run.stderr)

    def test_a_closer_limit_is_not_covered(self):
        self.accept_gap()
        kept = json.loads((self.folder / "ok.json").read_text())
        kept["accepted"][0]["limit"] *= 1.01
        self.write("ok.json", json.dumps(kept))
        run = self.check(GAP)
        self.assertEqual(run.returncode, 1)
        self.assertIn("which is held to a closer limit: 0.01 instead of 0.0101 mm", run.stderr)

    def test_a_fault_of_a_report_is_accepted_with_all_of_its_findings(self):
        inspect = ("inspect", surface("seam-g1-angle.step"), "--view", "high-front", "-q", *SMALL)
        self.keiko(*inspect, "-o", "before")
        report = json.loads((self.folder / "before/report.json").read_text())
        fault, = report["triage"]["items"]
        self.assertGreater(len(fault["findings"]), 1)
        self.assertEqual(self.accept("before/report.json", "1", "--finding", str(fault["findings"][0])).returncode, 0)
        self.assertEqual(len(json.loads((self.folder / "ok.json").read_text())["accepted"]), len(fault["findings"]))
        self.assertEqual(self.keiko(*inspect, "-o", "after", "--accepted", "ok.json", *DAY).returncode, 0)
        hidden = dict(report, triage={"items": [], "hidden": [fault]})
        self.write("hidden.json", json.dumps(hidden))
        run = self.accept("hidden.json", "1", day=("--today", "2026-11-28"))
        self.assertEqual((run.returncode, run.stdout), (2, ""), "accepted already, so it was found")
        run = self.accept("before/report.json", "2")
        self.assertEqual((run.returncode, run.stderr), (2, "keiko: before/report.json:item 2: there is no such fault; there are 1\n"))

    def test_entries_are_kept_and_not_doubled(self):
        self.accept_gap()
        before = (self.folder / "ok.json").read_bytes()
        run = self.accept("report.json", "1")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertRegex(run.stderr, r"\Akeiko: ok\.json:entry 1: accepts G-SU-LG at .* already\n\Z")
        self.assertEqual((self.folder / "ok.json").read_bytes(), before)
        self.keiko("check", surface("seam-g1-angle.step"), "--json", "other.json", "-q")
        self.assertEqual(self.accept("other.json", "1").returncode, 0)
        entries = json.loads((self.folder / "ok.json").read_text())["accepted"]
        self.assertEqual(entries[0], json.loads(before)["accepted"][0])
        self.assertEqual([entry["code"] for entry in entries], ["G-SU-LG", "G-SU-NT"])

    def test_what_has_expired_is_accepted_anew(self):
        self.accept_gap("--until", "2026-11-30")
        run = self.accept("report.json", "1", why="still hidden", day=("--today", "2026-12-01"))
        self.assertEqual(run.returncode, 0)
        self.assertIn("in place of G-SU-LG", run.stdout)
        entry, = json.loads((self.folder / "ok.json").read_text())["accepted"]
        self.assertEqual((entry["why"], entry["when"]), ("still hidden", "2026-12-01"))
        self.assertNotIn("until", entry)

    def test_bad_input_is_one_line(self):
        self.accept_gap()
        self.write("model.json", '{"format": "keiko-model-facts/1"}')
        self.write("bad.json", '{"format": "keiko-accepted/1", "accepted": [{"code": "G-SU-LG"}]}')
        for run, reason in (
                (self.accept("report.json", "2"), "report.json:item 2: there is no such finding; there are 1"),
                (self.accept("report.json"), "ITEM: is missing: name a fault, or a --finding"),
                (self.accept("report.json", "--finding", "2"), "report.json:finding 2: there is no such finding; there are 1"),
                (self.accept("model.json", "1"), "model.json: is no report in JSON of keiko check or keiko inspect"),
                (self.accept("report.json", "1", "--until", "31.1.2027"), "--until: '31.1.2027' is no date as 2026-11-27"),
                (self.accept("report.json", "1", "--until", "2026-11-26"), "--until: '2026-11-26' is over already: it is 2026-11-27"),
                (self.check(GAP, day="soon"), "--today: 'soon' is no date as 2026-11-27"),
                (self.keiko("check", GAP, "--accepted", "bad.json", "-q"), "bad.json:entry 1, faces: is missing"),
                (self.keiko("check", GAP, "--accepted", "ok.json", "--json", "ok.json", "-q"), "ok.json: is an input as well")):
            self.assertEqual((run.returncode, run.stdout, run.stderr), (2, "", f"keiko: {reason}\n"))

    def test_the_file_keeps_to_its_schema(self):
        try:
            import jsonschema
        except ImportError:
            self.skipTest("no python3-jsonschema")
        self.accept_gap("--until", "2027-01-31")
        jsonschema.validate(json.loads((self.folder / "ok.json").read_text()), json.loads(SCHEMA.read_text()))

    def test_findings_of_lines_are_accepted_by_their_view(self):
        self.write("aslant.toml", ASLANT)
        inspect = ("inspect", surface("seam-g1-angle.step"), "--view", "high-front", "--rig", "aslant.toml", "-q", *SMALL)
        self.keiko(*inspect, "-o", "before")
        findings = json.loads((self.folder / "before/report.json").read_text())["findings"]
        numbers = [str(finding["number"]) for finding in findings if finding["severity"] == "judged"]
        self.assertTrue(any(finding.get("view") == "high-front" for finding in findings))
        self.assertEqual(self.accept("before/report.json", "--finding", *numbers).returncode, 0)
        run = self.keiko(*inspect, "-o", "after", "--accepted", "ok.json", *DAY)
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stderr, UNJUDGED)
        self.assertIn(f"{len(numbers)} findings accepted; ", run.stdout)
        report = json.loads((self.folder / "after/report.json").read_text())
        self.assertEqual((report["verdict"], report["lines"]["verdict"], len(report["accepted"])), ("pass", "pass", len(numbers)))
        html = (self.folder / "after/report.html").read_text()
        self.assertIn("<h2>Accepted</h2>", html)
        self.assertIn("hidden by the trim", html)


if __name__ == "__main__":
    unittest.main()
