#!/usr/bin/env python3
"""Holds the ray rates of one build of the benchmarks against those of another.

Both trace the same rays in turn, base, head, head, base, ..., so that what else the machine does falls
on both. A rate has got slower where the median of the ratios head / base is below 1 - LIMIT and
three quarters of the ratios are below 1, and where both hold again for as many pairs that are run
anew: among dozens of rates one may look slower by chance, but hardly the same one twice.
Exit codes: 0 nothing got slower, 1 something did, 2 error.
"""
import argparse
import functools
import json
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path


def rates(results: dict) -> dict:
    """Keiko's rays per second by scene, class of rays, kind and mode."""
    return {(scene["scene"], rays["class"], m["kind"], m["mode"]): m["rays_per_second"]
            for scene in results["scenes"] for rays in scene["classes"]
            for m in rays["measurements"] if m["kind"].startswith("keiko")}


@functools.cache
def knows_alone(bench: Path) -> bool:
    told = subprocess.run([str(bench), "trace", "--help"], check=True, capture_output=True, text=True)
    return "--alone" in told.stdout


def run(bench: Path, arguments: list) -> dict:
    with tempfile.TemporaryDirectory(prefix="keiko-bench-") as folder:
        file = Path(folder) / "results.json"
        alone = ["--alone"] if knows_alone(bench) else []
        command = [str(bench), "trace", "--rounds", "3", "--json", str(file), *alone, *arguments]
        subprocess.run(command, check=True, capture_output=True, text=True)
        return rates(json.loads(file.read_text()))


def ratios_of(base: Path, head: Path, pairs: int, arguments: list) -> dict:
    """Of every rate that both builds tell: head / base, pair by pair."""
    ratios = {}
    for pair in range(pairs):
        print(f"pair {pair + 1} of {pairs}", file=sys.stderr)
        order = (base, head) if pair % 2 == 0 else (head, base)
        found = {bench: run(bench, arguments) for bench in order}
        for key in found[base].keys() & found[head].keys():
            ratios.setdefault(key, []).append(found[head][key] / found[base][key])
    return ratios


def got_slower(ratios: list, limit: float) -> bool:
    below = sum(ratio < 1 for ratio in ratios)
    return statistics.median(ratios) < 1 - limit and 4 * below >= 3 * len(ratios)


def slower_twice(options, arguments: list, ratios: dict) -> set:
    """The rates that got slower; what looks so is measured again."""
    suspects = {key for key in ratios if got_slower(ratios[key], options.limit)}
    if not suspects:
        return suspects
    print(f"{len(suspects)} of {len(ratios)} rates look slower: once more", file=sys.stderr)
    again = ratios_of(options.base, options.head, options.pairs, arguments)
    slower = {key for key in suspects if got_slower(again.get(key, [1]), options.limit)}
    for key, found in again.items():
        ratios[key] += found
    return slower


def print_table(ratios: dict, slower: set):
    print("| scene | rays | | head / base | least | most | |\n|---|---|---|---|---|---|---|")
    for key in sorted(ratios):
        print(f"| {key[0]} | {key[1]} | {key[2]}, {key[3]} | {statistics.median(ratios[key]):.3f} "
              f"| {min(ratios[key]):.3f} | {max(ratios[key]):.3f} | {'slower' if key in slower else ''} |")


def pair_count(text: str) -> int:
    count = int(text)
    if count < 1:
        raise argparse.ArgumentTypeError("at least 1")
    return count


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("base", type=Path, help="keiko_bench of the base")
    parser.add_argument("head", type=Path, help="keiko_bench of the head")
    parser.add_argument("--pairs", type=pair_count, default=9, help="runs of each (9)")
    parser.add_argument("--limit", type=float, default=0.05, help="share of the rate that may be lost (0.05)")
    options, arguments = parser.parse_known_args()
    try:
        ratios = ratios_of(options.base, options.head, options.pairs, arguments)
        slower = slower_twice(options, arguments, ratios)
    except (OSError, subprocess.CalledProcessError, ValueError, KeyError) as error:
        print(getattr(error, "stderr", None) or "", end="", file=sys.stderr)
        print(f"against: {error}", file=sys.stderr)
        return 2
    if not ratios:
        print("against: the two builds have no rate in common", file=sys.stderr)
        return 2
    print_table(ratios, slower)
    return 1 if slower else 0


if __name__ == "__main__":
    sys.exit(main())
