#!/usr/bin/env python3
"""A ground-truth system of a lab's own in Python: a ball on a circle and two robots, 30 times a second.

    PYTHONPATH=.. python3 truth.py [SECONDS]

It writes to a ground-truth server, or to a robot's runtime (foresight-robot --body attached): to the one whose door is at
$FORESIGHT_DOOR or at the default path. The frame is the field: origin at its centre, +x towards the goal that the home team
attacks in the first half. A thing that is not seen is left out of the message.
"""

import math
import sys
import time

import foresight
from foresight import bytes_field, float_field, uint_field


# the numbers of the fields: proto/foresight/truth.proto
def ball(x, y):
    return bytes_field(1, float_field(1, x) + float_field(2, y))


def robot(team, player, x, y, heading):
    return bytes_field(2, uint_field(1, team) + uint_field(2, player) + float_field(3, x) + float_field(4, y)
                       + float_field(5, heading))


world = foresight.Writer("/truth/world", "foresight.GroundTruth")
seconds = float(sys.argv[1] if len(sys.argv) > 1 else 10)
start_ns, age, written = foresight.now_ns(), 0.0, 0
while age < seconds:
    image_ns = foresight.now_ns()  # the time when your camera took the image, not the time of its arrival
    age = (image_ns - start_ns) * 1e-9
    truth = ball(math.cos(age), math.sin(age)) + robot(14, 2, -2.0, 0.5, 0.0) + robot(5, 3, 2.0, -0.5, 3.0)
    written += world.write(image_ns, truth)
    time.sleep(1 / 30)

print("%d messages; lost: %d %s" % (written, world.lost, world.problem))
