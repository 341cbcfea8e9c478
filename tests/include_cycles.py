"""Cycles between source files: A includes B, which includes A, over however many files between.

A header and the .cpp of its name are one file here, since neither is read without the other.
"""
import re
from pathlib import Path

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
SOURCES = {".h", ".cpp"}


def sources(root: Path) -> list:
    return sorted(path for path in root.rglob("*") if path.suffix in SOURCES)


def include_graph(root: Path) -> dict:
    """For each file without its ending, relative to root: the files of root that it includes."""
    graph = {}
    for path in sources(root):
        graph.setdefault(path.relative_to(root).with_suffix(""), set()).update(
            Path(target).relative_to(root.name).with_suffix("")
            for target in INCLUDE.findall(path.read_text(encoding="utf-8"))
            if target.startswith(root.name + "/"))
    return {file: {other for other in others if other in graph and other != file}
            for file, others in graph.items()}


def cycles(graph: dict) -> list:
    """The strongly connected parts of more than one file [Tarjan 1972], each sorted."""
    index, lowest, stack, found = {}, {}, [], []

    def visit(file):
        index[file] = lowest[file] = len(index)
        stack.append(file)
        for other in sorted(graph[file]):
            if other not in index:
                visit(other)
                lowest[file] = min(lowest[file], lowest[other])
            elif other in stack:
                lowest[file] = min(lowest[file], index[other])
        if lowest[file] == index[file]:
            part = stack[stack.index(file):]
            del stack[stack.index(file):]
            if len(part) > 1:
                found.append(sorted(part))

    for file in sorted(graph):
        if file not in index:
            visit(file)
    return sorted(found)


def cycle_faults(root: Path, known: list):
    """What differs between the cycles under root and `known`, one string of file names a cycle.

    A cycle that is gone or has fewer files must leave `known` or shrink there, so that it cannot
    come back.
    """
    listed = [frozenset(names.split()) for names in known]
    present = {frozenset(file.name for file in part): part for part in cycles(include_graph(root))}
    for names, part in present.items():
        if names in listed:
            continue
        wider = next((old for old in listed if names < old), None)
        if wider:
            yield f"known cycle '{' '.join(sorted(wider))}' is smaller now: '{' '.join(sorted(names))}'"
        else:
            yield f"{part[0]}: files include each other: {', '.join(map(str, part))}"
    for names in listed:
        if names not in present and not any(part < names for part in present):
            yield f"known cycle '{' '.join(sorted(names))}' is gone: remove it from the list"
