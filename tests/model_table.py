#!/usr/bin/env python3
"""Writes the table of the model collection into docs/file-formats.md, between its markers: what
each file of ../shared/models becomes, how long it takes and how much memory.

usage: tests/model_table.py KEIKO [TRIMS]

TRIMS is what the trim agreement test printed in a long run (lines that begin with "trims").
"""
import csv
import json
import subprocess
import sys
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MODELS = ROOT.parent / "shared" / "models"
PAGE = ROOT / "docs" / "file-formats.md"
BEGIN, END = "<!-- begin models -->\n", "<!-- end models -->\n"
KINDS = {".step", ".igs", ".brep", ".bpt", ".obj", ".txt"}


def measured(keiko: str, model: Path):
    """What `keiko info` says, its seconds, and the peak MiB of it and its worker."""
    script = ("import json, resource, subprocess, sys, time\n"
              "start = time.monotonic()\n"
              "run = subprocess.run(sys.argv[1:], capture_output=True, text=True)\n"
              "usage = resource.getrusage(resource.RUSAGE_CHILDREN)\n"
              "print(json.dumps([run.returncode, run.stdout, run.stderr,\n"
              "                  time.monotonic() - start, usage.ru_maxrss / 1024]))")
    run = subprocess.run([sys.executable, "-c", script, keiko, "info", str(model), "--json", "-q"],
                         capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def reason(stderr: str, model: Path) -> str:
    return stderr.strip().removeprefix("keiko: ").removeprefix(f"{model}: ")


def outcome(facts: dict) -> str:
    """Repairs by kind, lost faces by reason."""
    parts = [f"{total['count']} {kind}" for kind, total in facts["repair_totals"].items()]
    lost = Counter(face["reason"] for face in facts["lost_faces"])
    parts += [f"**{count} lost: {why}**" for why, count in lost.items()]
    parts += [d["message"] for d in facts["diagnostics"] if d["severity"] == "warning"]
    return ", ".join(parts)


def trim_columns(path) -> dict:
    """By file: places compared, within tolerance, OpenCASCADE wrong, open curves."""
    if path is None:
        return {}
    rows = [line.rstrip("\n").split("\t") for line in open(path) if line.startswith("trims\t")]
    return {row[1]: row[2:] for row in rows}


def trims_text(columns) -> str:
    if not columns:
        return "–"
    samples, tolerance, ours, theirs, open_curves = map(int, columns)
    text = f"{ours} of {samples:,}".replace(",", " ")
    notes = [f"{n} {what}" for n, what in ((tolerance, "in tolerance"), (theirs, "OpenCASCADE's"),
                                           (open_curves, "open")) if n]
    return text + (f" ({', '.join(notes)})" if notes else "")


def row(keiko: str, entry: dict, trims: dict) -> str:
    model = MODELS / entry["file"]
    code, stdout, stderr, seconds, memory = measured(keiko, model)
    if code < 0 or (code and stderr.count("\n") != 1):
        sys.exit(f"{model}: exit code {code}, {stderr!r}")
    cells = [f"`{entry['file']}`", entry["faces"]]
    if code:
        cells += ["–", "–", f"**{reason(stderr, model)}**"]
    else:
        facts = json.loads(stdout)
        cells += [str(facts["placed_faces"]), trims_text(trims.get(entry["file"])), outcome(facts)]
    cells += [f"{seconds:.2f}", f"{memory:.0f}"]
    return "| " + " | ".join(cells) + " |\n"


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    trims = trim_columns(sys.argv[2] if len(sys.argv) == 3 else None)
    with open(MODELS / "MANIFEST.tsv", newline="") as file:
        entries = [e for e in csv.DictReader(file, delimiter="\t")
                   if Path(e["file"]).suffix in KINDS]
    table = ("| file | faces | loaded | trims unlike OpenCASCADE's | repairs, losses, error | s | MiB |\n"
             "|---|--:|--:|---|---|--:|--:|\n")
    for entry in entries:
        table += row(sys.argv[1], entry, trims)
        print(entry["file"], file=sys.stderr)
    page = PAGE.read_text(encoding="utf-8")
    head, rest = page.split(BEGIN)
    PAGE.write_text(head + BEGIN + table + END + rest.split(END)[1], encoding="utf-8")


main()
