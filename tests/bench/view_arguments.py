"""The command line that the benchmarks of keiko view have in common."""
import argparse
from pathlib import Path

SURFACES = Path(__file__).resolve().parent.parent.parent / "surfaces"


def parser() -> argparse.ArgumentParser:
    """KEIKO [SCENE...] [--size WxH]; without scenes the concept car and the hood."""
    made = argparse.ArgumentParser()
    made.add_argument("keiko")
    made.add_argument("scenes", nargs="*", type=Path,
                      default=[SURFACES / "concept-car-scene.toml", SURFACES / "hood-scene.toml"])
    made.add_argument("--size", default="960x540")
    return made
