"""Keys of scripts/walk-lab: writes motion_command through the door, and lines for lab_robot to a pipe.

    python3 keys.py PIPE     with FORESIGHT_DOOR set
"""

import math
import os
import select
import sys
import termios
import time
import tty

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "robot", "client"))
import foresight  # noqa: E402

HELP = """w s  faster forward, backward     a d  to the side     q e  turn     space  stop
k    kick with a step             p  push from the front, behind, left or right, in turn (1.2 N s)
1 2  another robot: stiff, soft   f  slippery or rough ground      g  bumps of 0, 4 or 8 mm
b    chest button                 h  hold the head: soft           x  end"""

STEPS = {"w": (0.05, 0, 0), "s": (-0.05, 0, 0), "a": (0, 0.05, 0), "d": (0, -0.05, 0), "q": (0, 0, 0.2), "e": (0, 0, -0.2)}
LIMITS = (0.2, 0.1, 0.8)


def walk(speed):
    inner = b"".join(foresight.float_field(i + 1, value) for i, value in enumerate(speed))
    return foresight.bytes_field(1, inner)


def kick():
    return foresight.bytes_field(3, foresight.bytes_field(1, b"walk_forward") + foresight.uint_field(3, 1))


class Lab:
    def __init__(self, pipe):
        self.pipe = pipe
        self.writer = foresight.Writer("motion_command", "foresight.MotionCommand")
        self.speed = [0.0, 0.0, 0.0]
        self.kick_until = 0
        self.pushes = self.friction = self.turf = 0
        self.seed = 1

    def tell(self, line):
        self.pipe.write(line + "\n")
        self.pipe.flush()

    def press(self, button):
        self.tell(button)
        time.sleep(0.15)
        self.tell("release")
        time.sleep(0.1)

    def stand_up(self):
        """From soft to playing."""
        for _ in range(3):
            self.press("chest")

    def obey(self, key):
        if key in STEPS:
            changed = [now + step for now, step in zip(self.speed, STEPS[key])]
            self.speed = [max(-most, min(most, round(value, 2))) for value, most in zip(changed, LIMITS)]
        elif key == " ":
            self.speed = [0.0, 0.0, 0.0]
        elif key == "k":
            self.kick_until = time.monotonic() + 1
        elif key == "p":
            self.tell("push 1.2 %d" % (180, 0, 270, 90)[self.pushes % 4])
            self.pushes += 1
        elif key in "12":
            self.seed += 1
            self.tell("again %s %d" % ("stiff" if key == "1" else "soft", self.seed))
            self.stand_up()
        elif key == "f":
            self.friction += 1
            self.tell("friction %s" % (1.0, 0.4, 0.7)[self.friction % 3])
            self.stand_up()
        elif key == "g":
            self.turf += 1
            self.tell("turf %d" % (0, 4, 8)[self.turf % 3])
            self.stand_up()
        elif key == "b":
            self.press("chest")
        elif key == "h":
            self.press("head")

    def command(self):
        message = kick() if time.monotonic() < self.kick_until else walk(self.speed)
        self.writer.write(foresight.now_ns(), message)


def main():
    with open(sys.argv[1], "w") as pipe:
        lab = Lab(pipe)
        lab.stand_up()
        print(HELP, flush=True)
        terminal = termios.tcgetattr(sys.stdin) if sys.stdin.isatty() else None
        if terminal:
            tty.setcbreak(sys.stdin)
        try:
            while True:
                if select.select([sys.stdin], [], [], 1 / 30)[0]:
                    key = os.read(sys.stdin.fileno(), 1).decode(errors="ignore")
                    if key in ("", "x"):
                        return
                    lab.obey(key)
                    forward, left, turn = lab.speed
                    sys.stdout.write("\r%.2f m/s forward, %.2f left, %.0f deg/s   " % (forward, left, math.degrees(turn)))
                    sys.stdout.flush()
                lab.command()
        finally:
            if terminal:
                termios.tcsetattr(sys.stdin, termios.TCSADRAIN, terminal)
            lab.tell("end")


try:
    main()
except KeyboardInterrupt:
    pass
