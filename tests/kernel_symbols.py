#!/usr/bin/env python3
"""Fails when the objects of kernels share a symbol with code that is compiled for another instruction set.

usage: tests/kernel_symbols.py NM OBJECT...
A kernel file is compiled once for each instruction set (src/cmake/kernels.cmake). An inline function that
the compiler did not inline stands in its object as a weak symbol. The linker may choose that one for the
whole program, which then fails on a processor without the set. Names within the namespace of the set are safe, and so are pointers to a library's function (DW.ref).
"""
import re
import subprocess
import sys


def shared_symbols(nm: str, path: str) -> list:
    """Names of the weak and unique symbols of an object that another one may have too."""
    listing = subprocess.run([nm, "-C", "--defined-only", path], check=True, capture_output=True, text=True).stdout
    symbols = [line.split(None, 2) for line in listing.splitlines() if line.count(" ") >= 2]
    return [name for _, kind, name in symbols if kind in "VvWwu" and not re.search(r"\blevel_\w+::|^DW\.ref\.", name)]


def main() -> int:
    nm, *objects = sys.argv[1:]
    faults = [f"{path}: {name}" for path in objects for name in shared_symbols(nm, path)]
    print("\n".join(faults) or f"{len(objects)} objects of kernels share no symbol")
    return 1 if faults or not objects else 0


if __name__ == "__main__":
    sys.exit(main())
