#!/usr/bin/env python3
"""Times of `keiko view` as a page on this machine has them.

usage: tests/bench/view.py KEIKO [SCENE...] [--size WxH] [--rounds N]

start: from the command to the address, and to the first rows of the first view. deep: a whole answer to
POST /deep in one message, and the first of four interlaced ones and all of them. draft: half the size.
hide and show: until all rows have come without the first face, and with it again; isolate: with that face alone.
Each is the median of N requests on one connection, in ms; MB is the size of the whole answer. The last
number is the server's processor time a request, which other work on the machine leaves as it is: on two
free cores an answer takes little more than half of it.
"""
import http.client
import json
import os
import statistics
import subprocess
import time
from pathlib import Path

import view_arguments

HEADER, SAMPLE, BOUNCE = 32, 32, 36


def timed(connection, token: str, body: str):
    """Milliseconds to the first whole message and to the end, and the bytes."""
    begin = time.perf_counter()
    connection.request("POST", "/deep", body.encode(), {"X-Keiko-Token": token})
    reply = connection.getresponse()
    head = reply.read(HEADER)
    numbers = [int.from_bytes(head[8 + 4 * i:12 + 4 * i], "little") for i in range(6)]
    first = reply.read(numbers[4] * SAMPLE + numbers[5] * BOUNCE)
    at_first = time.perf_counter()
    rest = reply.read()
    end = time.perf_counter()
    return 1e3 * (at_first - begin), 1e3 * (end - begin), HEADER + len(first) + len(rest)


def processor_ms(process) -> float:
    fields = Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return 1e3 * (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def scene_of(connection, token: str) -> dict:
    connection.request("GET", "/scene", headers={"X-Keiko-Token": token})
    return json.loads(connection.getresponse().read())


def request(camera: dict, width: int, height: int, interlaced: bool) -> str:
    return (f"interlaced = {str(interlaced).lower()}\n[camera]\neye = {camera['eye']}\ntarget = {camera['target']}\n"
            f"up = {camera['up']}\nvertical_fov = {camera['vertical_fov']}\nsize = [{width}, {height}]\n")


def hiding(faces: list) -> str:
    return f"hidden = {faces}\n" if faces else ""


def bench(keiko: str, scene: Path, width: int, height: int, rounds: int):
    begin = time.perf_counter()
    process = subprocess.Popen([keiko, "view", scene, "--no-browser", "--size", f"{width}x{height}"], text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    try:
        place, _, token = process.stdout.readline().strip().partition("/#token=")
        address = time.perf_counter()
        connection = http.client.HTTPConnection("127.0.0.1", int(place.rpartition(":")[2]))
        shown = scene_of(connection, token)
        camera, ids = shown["camera"], [face["id"] for face in shown["faces"]]
        timed(connection, token, request(camera, width, height, True))
        rows = time.perf_counter()
        busy = processor_ms(process)
        print(f"{scene.name}: start {1e3 * (address - begin):.0f} ms to the address, "
              f"{1e3 * (rows - begin):.0f} ms to all rows of the first view, {busy:.0f} ms of processors")
        for name, w, h, interlaced, hidden in (("deep", width, height, False, []), ("interlaced", width, height, True, []),
                                               ("draft", width // 2, height // 2, False, []), ("hide", width, height, True, ids[:1]),
                                               ("show", width, height, True, []), ("isolate", width, height, True, ids[1:])):
            before = processor_ms(process)
            body = hiding(hidden) + request(camera, w, h, interlaced)
            times = [timed(connection, token, body) for _ in range(rounds)]
            busy = (processor_ms(process) - before) / rounds
            first, whole = (statistics.median(t[i] for t in times) for i in (0, 1))
            print(f"  {name:11} {w} x {h}: first message {first:6.1f} ms, all {whole:6.1f} ms, "
                  f"{times[0][2] / 1e6:.2f} MB, {busy:.0f} ms of processors")
    finally:
        process.terminate()
        process.wait()


def main():
    parser = view_arguments.parser()
    parser.add_argument("--rounds", type=int, default=15)
    arguments = parser.parse_args()
    width, height = map(int, arguments.size.split("x"))
    for scene in arguments.scenes:
        bench(arguments.keiko, scene, width, height, arguments.rounds)


if __name__ == "__main__":
    main()
