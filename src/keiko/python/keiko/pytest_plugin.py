"""Fixtures of Keiko as tests of pytest: `pytest -p keiko.pytest_plugin FOLDER`.

Each file of format keiko-fixture/1 is run once and held against its baseline. Its checks, its
pictures and its state are one item each. With --keiko-update TEXT, what the fixtures show now is accepted, and TEXT
is the reason in their manifests.
"""
import getpass
import tomllib

import pytest

from . import accept_baselines, regress

PARTS = ("shape", "seams", "lines", "pictures", "state")


def pytest_addoption(parser):
    group = parser.getgroup("keiko", "fixtures of surfaces")
    group.addoption("--keiko-output", default="keiko-regress", metavar="FOLDER",
                    help="folder of candidates and reports (default: %(default)s)")
    group.addoption("--keiko-update", default="", metavar="TEXT",
                    help="accept what the fixtures show now as their baselines, for this reason")


def pytest_collect_file(file_path, parent):
    if file_path.suffix == ".toml" and is_fixture(file_path):
        return FixtureFile.from_parent(parent, path=file_path)
    return None


def is_fixture(path) -> bool:
    """Whether a file states the format of fixtures; one that cannot be read is none."""
    try:
        with open(path, "rb") as file:
            return tomllib.load(file).get("format") == "keiko-fixture/1"
    except (OSError, tomllib.TOMLDecodeError):
        return False


class FixtureFile(pytest.File):
    """A fixture, run when the first of its items is."""

    _outcome = None

    def collect(self):
        for part in PARTS:
            yield FixtureItem.from_parent(self, name=part)

    def outcome(self) -> dict:
        """Its part of regression.json."""
        if self._outcome is None:
            suite, name = self.path.parent, self.path.stem
            output = f"{self.config.getoption('--keiko-output')}/{name}"
            reason = self.config.getoption("--keiko-update")
            if reason:
                accept_baselines(suite, [name], by=getpass.getuser(), reason=reason, output=output)
            self._outcome = regress(suite, output, only=[name]).to_dict()["fixtures"][0]
        return self._outcome


class FixtureItem(pytest.Item):
    """One check of a fixture, or its pictures."""

    def runtest(self):
        outcome = self.parent.outcome()
        if outcome["state"] == "error":
            raise FixtureFailure(outcome["error"])
        if outcome["state"] == "missing":
            raise FixtureFailure(f"{outcome['name']} has no baseline: look at the candidate, then accept it "
                                 "with --keiko-update TEXT")
        faults = {"pictures": self.pictures, "state": self.state}.get(self.name, self.metrics)(outcome)
        if faults:
            raise FixtureFailure("\n".join(faults))

    @staticmethod
    def state(outcome) -> list:
        """The state, unless all is the same."""
        return [] if outcome["state"] == "same" else [f"the fixture is {outcome['state']}"]

    def metrics(self, outcome) -> list:
        """Metrics of the check that are beyond their tolerance."""
        if self.name not in outcome["checks"]:
            pytest.skip(f"the fixture asks for no check of {self.name}")
        return [f"{m['name']}: {said(m['before'])} before, {said(m['after'])} now; {m['allowed']:.3g} allowed"
                for m in outcome["metrics"] if m["check"] == self.name]

    @staticmethod
    def pictures(outcome) -> list:
        """Views that differ, each with its layers."""
        if not outcome["pictures"]:
            pytest.skip("the fixture asks for no pictures")
        faults = []
        for picture in outcome["pictures"]:
            layers = [layer["layer"] for layer in picture["layers"] if not layer["within"]]
            if not picture["flips_within"]:
                layers.insert(0, "silhouette")
            if picture["problem"] or layers:
                faults.append(f"{picture['view']}: {picture['problem'] or ', '.join(layers)}")
        return faults

    def repr_failure(self, excinfo, style=None):
        if isinstance(excinfo.value, FixtureFailure):
            return str(excinfo.value)
        return super().repr_failure(excinfo)

    def reportinfo(self):
        return self.path, None, f"{self.path.stem}: {self.name}"


def said(value) -> str:
    """A metric's value; "nothing" where a revision lacks it."""
    return "nothing" if value is None else str(value.get("word", value.get("number")))


class FixtureFailure(Exception):
    """What a fixture shows is not what was accepted."""
