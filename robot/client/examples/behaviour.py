#!/usr/bin/env python3
"""A team's own behaviour in Python: reads ball and game state, decides, and writes the motion command and its reason.

    PYTHONPATH=.. python3 behaviour.py [SECONDS]
"""

import json
import math
import sys
import time

import foresight

PLAYING = 5

ball = foresight.Reader("ball")
game = foresight.Reader("game")
command = foresight.Writer("motion_command", "foresight.MotionCommand", delivery=foresight.FIFO)
parameters = foresight.Parameters("behaviour")  # people change them in the viewer
parameters.number("speed", 1.0, range=(0, 1), text="Speed of the walk to the ball as a part of the fastest walk.")
parameters.choice("side", "straight", ["left", "straight", "right"], text="Side on which the robot passes the ball.")
thoughts = foresight.Writer("thoughts", "team.Thoughts", encoding="json")  # a type that only this team knows

end = time.monotonic() + float(sys.argv[1] if len(sys.argv) > 1 else 10)
playing, decisions = False, 0
while time.monotonic() < end:
    ball.wait(0.1)
    parameters.poll()
    packet = game.newest()
    if packet:
        playing = dict(foresight.fields(packet.bytes)).get(7) == PLAYING
    seen = ball.newest()
    if not seen:
        continue

    # WalkTo: straight to the ball, facing it; an absent field means 0
    place = dict(foresight.fields(seen.bytes))
    x, y = (foresight.as_float(place[number]) if number in place else 0.0 for number in (2, 3))
    y += {"left": 0.1, "straight": 0.0, "right": -0.1}[parameters["side"]]
    bearing = math.atan2(y, x)
    walk_to = foresight.float_field(1, x) + foresight.float_field(2, y) + foresight.float_field(3, bearing)
    walk_to += foresight.float_field(4, parameters["speed"] if playing else 0.0)

    # a decision has the capture time of the ball that it was made from
    command.write(seen.capture_ns, foresight.bytes_field(2, walk_to))
    thoughts.write(seen.capture_ns, json.dumps({"playing": playing, "bearing": bearing}).encode())
    decisions += 1

print("%d decisions; lost: %d %s" % (decisions, command.lost, command.problem))
