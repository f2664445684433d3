"""The Python process of `scripts/bench door`: as bench_door_peer sensors SECONDS, under objects of its own."""

import json
import sys
import time

import foresight

joints = foresight.Writer("python_joints", "foresight.Joints", delivery=foresight.FIFO)
camera = foresight.Writer("python_camera", "foresight.Image")
positions = b"".join(foresight.floats_field(field, [float(field)] * 25) for field in range(1, 6))
seconds = float(sys.argv[1])


def timed(calls, write, *words):
    cpu, wall = time.clock_gettime(time.CLOCK_THREAD_CPUTIME_ID), time.monotonic()
    write(foresight.now_ns(), *words)
    calls["cpu_us"] += (time.clock_gettime(time.CLOCK_THREAD_CPUTIME_ID) - cpu) * 1e6
    calls["longest_ms"] = max(calls["longest_ms"], (time.monotonic() - wall) * 1e3)
    calls["calls"] += 1


small, large = ({"calls": 0, "cpu_us": 0.0, "longest_ms": 0.0} for _ in range(2))
start = time.monotonic()
due = {"joints": start, "image": start}
while min(due.values()) < start + seconds:
    what = min(due, key=due.get)
    time.sleep(max(0, due[what] - time.monotonic()))
    if what == "joints":
        timed(small, joints.write, positions)
        due[what] += 1 / 83
    else:
        timed(large, camera.write, *foresight.image(foresight.YUYV, 640, 480, bytes([large["calls"] % 256]) * 614400))
        due[what] += 1 / 30
for calls in (small, large):
    calls["cpu_us"] /= max(1, calls["calls"])
print(json.dumps({"lost": joints.lost + camera.lost, "joints": small, "images": large}))
