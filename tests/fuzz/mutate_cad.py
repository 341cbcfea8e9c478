#!/usr/bin/env python3
"""Damages CAD files at random and lets keiko read them.

Whatever comes out must be a result, or exit code 2 with one line on stderr and nothing written:
never a crash of keiko itself, a hang, silence or a partial file. The worker that reads CAD files may
crash; keiko may not. Stops with exit code 1 at the end when a file broke this; it is then kept.
"""
import argparse
import json
import random
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
FOLDERS = (ROOT / "surfaces", ROOT.parent / "shared" / "models")
KINDS = {".step", ".igs", ".brep"}
LARGEST = 120_000  # bytes; larger files only make the run slow

IMPORT_SECONDS = 10
RUN_SECONDS = 120  # import, then tracing on a busy machine
NUMBERS = (b"0", b"-1", b"1", b"2", b"25", b"26", b"1000000", b"2147483648", b"-9223372036854775809",
           b"0.", b"-0.", b"1.E-320", b"1.E308", b"1.E400", b"1.E15", b"NAN", b"INF", b"$", b"*")
NUMBER = re.compile(rb"(?<![A-Za-z_#0-9.])[-+]?\d+\.?\d*(?:[EeDd][-+]?\d+)?")
REFERENCE = re.compile(rb"#\d+")

RAYS = "".join(f"{x},{y},5000,{dx},0.01,-1\n" for x in (-300, -1, 0, 40) for y in (-200, 0, 7)
               for dx in (0, 0.02))
COMMANDS = {
    "info": ["info", "--json"],
    "trace": ["trace", "--all", "--out", "t,face,u,v,x,y,z,nx,k1,k2,bound,flags"],
    "render": ["render", "-o", "out.png", "--size", "48x27"],
    "place": ["place", "-o", "out.toml"],
    "inspect": ["inspect", "-o", "out", "--size", "48x27"],
}
SHARES = ["info"] * 8 + ["trace"] * 6 + ["render"] * 4 + ["place", "inspect"]


def change_bytes(data, chance):
    at = chance.randrange(len(data))
    length = chance.choice((0, 1, 1, 2, 16))
    new = bytes(chance.randrange(256) for _ in range(chance.choice((0, 1, 1, 4))))
    return data[:at] + new + data[at + length:]


def change_lines(data, chance):
    lines = data.split(b"\n")
    a, b = sorted(chance.randrange(len(lines)) for _ in range(2))
    what = chance.choice(("drop", "copy", "swap", "drop many"))
    if what == "drop":
        del lines[a]
    elif what == "copy":
        lines.insert(b, lines[a])
    elif what == "swap":
        lines[a], lines[b] = lines[b], lines[a]
    else:
        del lines[a:min(b, a + 40)]
    return b"\n".join(lines)


def change_match(data, chance, pattern, replacements):
    matches = list(pattern.finditer(data))
    if not matches:
        return data
    match = chance.choice(matches)
    return data[:match.start()] + replacements(chance, matches, match) + data[match.end():]


def other_number(chance, _, match):
    if chance.random() < 0.5:
        return chance.choice(NUMBERS)
    digits = bytearray(match[0])
    digits[chance.randrange(len(digits))] = chance.choice(b"0123456789.-E")
    return bytes(digits)


def change_number(data, chance):
    return change_match(data, chance, NUMBER, other_number)


def change_reference(data, chance):
    return change_match(data, chance, REFERENCE, lambda c, matches, _: c.choice(matches)[0])


def cut(data, chance):
    """Keeps the end, by which keiko tells a file that is cut short."""
    at = chance.randrange(len(data))
    return data[:at] + data[chance.randrange(at, len(data)):]


MUTATIONS = (change_number,) * 4 + (change_reference,) * 3 + (change_lines,) * 2 + (change_bytes, cut)


def mutated(data, chance):
    for _ in range(chance.choice((1, 1, 2, 3, 8))):
        data = chance.choice(MUTATIONS)(data, chance) or b"\n"
    return data


def complete_outputs(command, run, folder):
    """What is wrong with the results of a run that reports none of its own making."""
    if command == "info":
        json.loads(run.stdout)
    if command == "trace" and len(run.stdout.splitlines()) < 1:
        return "no header line"
    if command == "render" and not (folder / "out.png").read_bytes().endswith(b"IEND\xaeB`\x82"):
        return "the picture is not complete"
    if command == "place" and "format" not in (folder / "out.toml").read_text():
        return "the rig is not complete"
    if command == "inspect" and not any((folder / "out").glob("*.json")):
        return "there is no report"
    return None


def fault_of(command, run, folder, before):
    """What a run does that it must not do, or None."""
    if run.returncode in ((0, 1) if command == "inspect" else (0,)):
        try:
            return complete_outputs(command, run, folder)
        except (OSError, ValueError) as error:
            return f"exit code {run.returncode}, but {error}"
    if run.returncode != 2:
        return f"exit code {run.returncode}"
    errors = [line for line in run.stderr.splitlines() if "warning" not in line]
    if len(errors) != 1 or len(errors[0]) > 1000:
        return f"{len(errors)} lines of error"
    if run.stdout:
        return "an error after results"
    left = {p for p in folder.rglob("*")} - before
    return f"left behind: {sorted(map(str, left))}" if left else None


def read_one(keiko, data, suffix, command, folder):
    """(fault or None, exit code, last line of stderr) of keiko on a damaged file."""
    file = folder / f"damaged{suffix}"
    file.write_bytes(data)
    words = COMMANDS[command]
    arguments = [keiko, words[0], file.name, *words[1:], "--quiet",
                 "--import-timeout", str(IMPORT_SECONDS), "--import-memory", "4"]
    try:
        run = subprocess.run(arguments, cwd=folder, input=RAYS if command == "trace" else "",
                             capture_output=True, encoding="utf-8", errors="replace", check=False,
                             timeout=RUN_SECONDS)
    except subprocess.TimeoutExpired:
        return f"no end within {RUN_SECONDS} s", None, ""
    last = (run.stderr.splitlines() or [""])[-1]
    return fault_of(command, run, folder, {file}), run.returncode, last


def models():
    found = [p for folder in FOLDERS if folder.is_dir() for p in sorted(folder.iterdir())
             if p.suffix in KINDS and 0 < p.stat().st_size < LARGEST]
    return [(p.name, p.suffix, p.read_bytes()) for p in found]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("keiko", type=Path, help="the program; keiko-import lies beside it")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first damaged file")
    parser.add_argument("--keep", type=Path, default=ROOT / "build" / "fuzz" / "findings",
                        help="folder for the files that break keiko")
    options = parser.parse_args()
    keiko, originals = str(options.keiko.resolve()), models()
    counts = {"read": 0, "refused": 0, "broken": 0}
    end, number = time.monotonic() + options.seconds, options.first
    while time.monotonic() < end:
        chance = random.Random(f"{options.seed} {number}")
        name, suffix, original = chance.choice(originals)
        command, data = chance.choice(SHARES), mutated(original, chance)
        with tempfile.TemporaryDirectory(prefix="keiko-cad-") as folder:
            fault, code, last = read_one(keiko, data, suffix, command, Path(folder))
        counts["broken" if fault else "refused" if code == 2 else "read"] += 1
        if fault:
            options.keep.mkdir(parents=True, exist_ok=True)
            kept = options.keep / f"cad-{options.seed}-{number}-{command}{suffix}"
            kept.write_bytes(data)
            print(f"{kept}: of {name}: {command}: {fault}; {last}", flush=True)
        number += 1
    print(f"{number - options.first} damaged files of {len(originals)}, seed {options.seed}: " +
          ", ".join(f"{count} {what}" for what, count in counts.items()))
    sys.exit(1 if counts["broken"] else 0)


main()
