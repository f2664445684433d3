"""The controls of scripts/walk-lab: keys in the terminal, and the parameters of the process `lab` in the viewer.

    python3 lab.py PIPE SERVOS SEED     with FORESIGHT_DOOR set

Writes motion_command through the door, and lines for lab_robot to the pipe."""

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
k    kick with a step             p  push from the front, behind, left or right, in turn
b    chest button                 h  hold the head: soft           x  end
View Parameters: push and put up with a click, change the robot and the ground."""

STEPS = {"w": (0.05, 0, 0), "s": (-0.05, 0, 0), "a": (0, 0.05, 0), "d": (0, -0.05, 0), "q": (0, 0, 0.2), "e": (0, 0, -0.2)}
LIMITS = (0.2, 0.1, 0.8)
PUSHES = {"push_from_front": 180, "push_from_behind": 0, "push_from_left": 270, "push_from_right": 90}  # [degrees] towards
ROBOT = {"servos", "seed", "friction", "turf"}  # a change of these puts the robot up again
SETTLED = 0.3  # [s] without another change: a slider sends many values


def walk(speed):
    inner = b"".join(foresight.float_field(i + 1, value) for i, value in enumerate(speed))
    return foresight.bytes_field(1, inner)


def kick():
    return foresight.bytes_field(3, foresight.bytes_field(1, b"walk_forward") + foresight.uint_field(3, 1))


def announced(servos, seed):
    """Returns the parameters that people see in the viewer."""
    lab = foresight.Parameters("lab")
    lab.number("impulse", 1.2, range=(0.1, 5), unit="N s", text="Strength of a push. It takes 50 ms.")
    for name in PUSHES:
        lab.button(name, "Pushes the torso.")
    lab.button("kick", "Kicks with the next step of the foot.")
    lab.button("put_up", "Puts the robot on its feet.")
    lab.choice("servos", servos, ["stiff", "soft"], "Servos as new, or worn.")
    lab.whole("seed", seed, range=(1, 9999), text="The robot: no two have the same play, friction, delay and sensors.")
    lab.number("friction", 0, range=(0, 1.5), text="Between soles and ground; 0: as drawn for the robot.")
    lab.number("turf", 0, range=(0, 8), unit="mm", text="Greatest height of the ground's bumps.")
    return lab


class Lab:
    def __init__(self, pipe, servos, seed):
        self.pipe = pipe
        self.writer = foresight.Writer("motion_command", "foresight.MotionCommand")
        self.parameters = announced(servos, seed)
        self.speed = [0.0, 0.0, 0.0]
        self.kick_until = 0
        self.pushes = 0
        self.put_up_at = math.inf

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

    def put_up(self):
        robot = self.parameters
        self.put_up_at = math.inf
        self.tell("friction %g" % robot["friction"])
        self.tell("turf %g" % robot["turf"])
        self.tell("again %s %d" % (robot["servos"], robot["seed"]))
        self.stand_up()

    def push(self, name):
        self.tell("push %g %d" % (self.parameters["impulse"], PUSHES[name]))

    def kick(self):
        self.kick_until = time.monotonic() + 1

    def obey_key(self, key):
        if key in STEPS:
            changed = [now + step for now, step in zip(self.speed, STEPS[key])]
            self.speed = [max(-most, min(most, round(value, 2))) for value, most in zip(changed, LIMITS)]
        elif key == " ":
            self.speed = [0.0, 0.0, 0.0]
        elif key == "k":
            self.kick()
        elif key == "p":
            self.push(list(PUSHES)[self.pushes % len(PUSHES)])
            self.pushes += 1
        elif key == "b":
            self.press("chest")
        elif key == "h":
            self.press("head")

    def obey_viewer(self):
        for name in self.parameters.poll():
            if name in PUSHES:
                self.push(name)
            elif name == "kick":
                self.kick()
            elif name == "put_up":
                self.put_up()
            elif name in ROBOT:
                self.put_up_at = time.monotonic() + SETTLED
        if time.monotonic() >= self.put_up_at:
            self.put_up()

    def command(self):
        message = kick() if time.monotonic() < self.kick_until else walk(self.speed)
        self.writer.write(foresight.now_ns(), message)


def main():
    pipe, servos, seed = sys.argv[1:]
    with open(pipe, "w") as lines:
        lab = Lab(lines, servos, int(seed))
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
                    lab.obey_key(key)
                    forward, left, turn = lab.speed
                    sys.stdout.write("\r%.2f m/s forward, %.2f left, %.0f deg/s   " % (forward, left, math.degrees(turn)))
                    sys.stdout.flush()
                lab.obey_viewer()
                lab.command()
        finally:
            if terminal:
                termios.tcsetattr(sys.stdin, termios.TCSADRAIN, terminal)
            lab.tell("end")


try:
    main()
except KeyboardInterrupt:
    pass
