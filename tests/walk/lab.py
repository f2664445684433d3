"""The controls of scripts/walk-lab: keys in the terminal, and the parameters of the process `lab` in the viewer.

    python3 lab.py LINES STATES SERVOS SEED [--play]     with FORESIGHT_DOOR set

LINES and STATES are pipes: the input and the output of lab_robot. Through the door the lab writes what a team's own vision and
localisation would: pose and ball, which it knows. It also writes motion_command, or with --play the state of a game, in which
the behaviour of foresight-robot writes the commands."""

import json
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
HELP_OF_PLAY = """p    push from the front, behind, left or right, in turn
b    chest button                 h  hold the head: soft           x  end
View Parameters: push and put up with a click, put the ball down, change the robot and the ground."""

STEPS = {"w": (0.05, 0, 0), "s": (-0.05, 0, 0), "a": (0, 0.05, 0), "d": (0, -0.05, 0), "q": (0, 0, 0.2), "e": (0, 0, -0.2)}
LIMITS = (0.2, 0.1, 0.8)
PUSHES = {"push_from_front": 180, "push_from_behind": 0, "push_from_left": 270, "push_from_right": 90}  # [degrees] towards
ROBOT = {"servos", "seed", "friction", "turf"}  # a change of these puts the robot up again
SETTLED = 0.3  # [s] without another change: a slider sends many values
CYCLE = 1 / 30  # [s]
BALL_AHEAD, BALL_LEFT = 0.7, 0.15  # [m, robot] of a ball that is put down
FAR = 12  # [m] a ball farther away is on no field
SURE, SURE_HEADING = 0.02, 0.02  # [m], [rad] deviations of what the lab knows
PLAYERS, OWN = 5, 2


def message(*values):
    """Returns a message of (number, float) pairs."""
    return b"".join(foresight.float_field(number, value) for number, value in values)


def walk(speed):
    return foresight.bytes_field(1, message(*enumerate(speed, 1)))


def kick():
    return foresight.bytes_field(3, foresight.bytes_field(1, b"walk_forward") + foresight.uint_field(3, 1))


def pose_of(state):
    """The team's field is the world of the physics, so the robot starts in the middle and looks at the opponents' goal."""
    at = ((1, state["x"]), (2, state["y"]), (3, state["heading"]))
    return message(*at, (4, SURE), (5, SURE), (6, SURE_HEADING))


def ball_of(state, epoch_ns):
    """Returns the ball, seen at that time; None if nobody has put it down."""
    away, towards = state["ball_away"], state["ball_towards"]
    if away > FAR:
        return None
    speed, direction = state["ball_speed"], state["ball_direction"]
    seen = foresight.uint_field(1, epoch_ns) + foresight.uint_field(7, 1) + foresight.uint_field(19, 10)
    place = message((2, away * math.cos(towards)), (3, away * math.sin(towards)), (6, SURE))
    return seen + place + message((4, speed * math.cos(direction)), (5, speed * math.sin(direction)))


def game(epoch_ns, seconds):
    """Returns a game in which this robot plays alone."""
    def team(number, playing):
        players = b"".join(foresight.bytes_field(9, foresight.uint_field(1, player not in playing))
                           for player in range(1, PLAYERS + 1))
        return foresight.uint_field(1, number) + foresight.uint_field(4, 1) + players

    numbers = ((1, 1), (4, epoch_ns), (5, 14), (6, OWN), (7, 5), (9, 1), (10, 1), (14, PLAYERS), (15, 1))
    whole = b"".join(foresight.uint_field(number, value) for number, value in numbers)
    whole += foresight.float_field(11, 600 - seconds % 600)
    return whole + foresight.bytes_field(16, team(14, {OWN})) + foresight.bytes_field(17, team(15, set()))


def announced(servos, seed, play):
    """Returns the parameters that people see in the viewer."""
    lab = foresight.Parameters("lab")
    lab.number("impulse", 1.2, range=(0.1, 5), unit="N s", text="Strength of a push. It takes 50 ms.")
    for name in PUSHES:
        lab.button(name, "Pushes the torso.")
    if not play:
        lab.button("kick", "Kicks with the next step of the foot.")
    lab.button("put_ball", "Puts the ball 0.7 m ahead of the robot.")
    lab.button("put_up", "Puts the robot on its feet.")
    lab.choice("servos", servos, ["stiff", "soft"], "Servos as new, or worn.")
    lab.whole("seed", seed, range=(1, 9999), text="The robot: no two have the same play, friction, delay and sensors.")
    lab.number("friction", 0, range=(0, 1.5), text="Between soles and ground; 0: as drawn for the robot.")
    lab.number("turf", 0, range=(0, 8), unit="mm", text="Greatest height of the ground's bumps.")
    return lab


class Lab:
    def __init__(self, lines, states, servos, seed, play):
        self.pipe = lines
        self.states = states
        self.rest = ""  # of a line that has not ended
        self.pose = foresight.Writer("pose", "foresight.Pose")
        self.ball = foresight.Writer("ball", "foresight.Ball")
        self.game = foresight.Writer("game", "foresight.GameState") if play else None
        self.commands = None if play else foresight.Writer("motion_command", "foresight.MotionCommand")
        self.parameters = announced(servos, seed, play)
        self.speed = [0.0, 0.0, 0.0]
        self.kick_until = 0
        self.pushes = 0
        self.put_up_at = math.inf

    def tell(self, line):
        self.pipe.write(line + "\n")
        self.pipe.flush()

    def press(self, button, seconds=0.15):
        self.tell(button)
        time.sleep(seconds)
        self.tell("release")
        time.sleep(0.1)

    def stand_up(self):
        """From soft to playing."""
        for _ in range(3):
            self.press("chest")

    def put_up(self):
        robot = self.parameters
        self.put_up_at = math.inf
        self.press("head", 0.4)  # soft, so that it plays no getting up to its end on its feet
        self.tell("friction %g" % robot["friction"])
        self.tell("turf %g" % robot["turf"])
        self.tell("again %s %d" % (robot["servos"], robot["seed"]))
        self.put_ball()
        self.stand_up()

    def put_ball(self):
        self.tell("ball %g %g" % (BALL_AHEAD, BALL_LEFT))

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
            elif name == "put_ball":
                self.put_ball()
            elif name == "put_up":
                self.put_up()
            elif name in ROBOT:
                self.put_up_at = time.monotonic() + SETTLED
        if time.monotonic() >= self.put_up_at:
            self.put_up()

    def see(self):
        """Takes the states that lab_robot has printed, writes pose and ball, and asks for the next state."""
        now_ns = foresight.now_ns()
        while select.select([self.states], [], [], 0)[0]:
            text = os.read(self.states, 4096).decode()
            if not text:
                sys.exit("lab_robot has ended")
            *lines, self.rest = (self.rest + text).split("\n")
            for state in (json.loads(line) for line in lines if "ball_away" in line):
                self.pose.write(now_ns, pose_of(state))
                ball = ball_of(state, self.ball.epoch_ns(now_ns))
                if ball:
                    self.ball.write(now_ns, ball)
        self.tell("state")

    def command(self):
        now_ns = foresight.now_ns()
        if self.game:
            self.game.write(now_ns, game(self.game.epoch_ns(now_ns), time.monotonic()))
        if self.commands:
            self.commands.write(now_ns, kick() if time.monotonic() < self.kick_until else walk(self.speed))


def main():
    lines, states, servos, seed = sys.argv[1:5]
    play = sys.argv[5:] == ["--play"]
    with open(lines, "w") as pipe:
        lab = Lab(pipe, os.open(states, os.O_RDONLY), servos, int(seed), play)
        lab.put_ball()
        lab.stand_up()
        print(HELP_OF_PLAY if play else HELP, flush=True)
        terminal = termios.tcgetattr(sys.stdin) if sys.stdin.isatty() else None
        if terminal:
            tty.setcbreak(sys.stdin)
        try:
            while True:
                if select.select([sys.stdin], [], [], CYCLE)[0]:
                    key = os.read(sys.stdin.fileno(), 1).decode(errors="ignore")
                    if key in ("", "x"):
                        return
                    lab.obey_key(key)
                    if not play:
                        forward, left, turn = lab.speed
                        print("\r%.2f m/s forward, %.2f left, %.0f deg/s   " % (forward, left, math.degrees(turn)), end="",
                              flush=True)
                lab.obey_viewer()
                lab.see()
                lab.command()
        finally:
            if terminal:
                termios.tcsetattr(sys.stdin, termios.TCSADRAIN, terminal)
            try:
                lab.tell("end")
            except BrokenPipeError:
                pass  # lab_robot has ended first


try:
    main()
except KeyboardInterrupt:
    pass
