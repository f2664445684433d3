#!/usr/bin/env python3
"""A complete behaviour in its own process, Python 3.6 or newer, standard library only; charge.c is the same in C.

    foresight-sim match --home 'pipe:python3 sim/guest/examples/charge.py'

It answers each line with one line; sim/guest/wire.h documents them. Its output to stderr is shown.
Metres, seconds, radians; ticks are 1/30 s of game time.
"""
import json
import math
import sys

FORGOTTEN = 5 * 30  # [ticks] a ball that was not seen for so long is lost
SEARCH_TURN = 0.8  # [rad/s]
BEHIND = 0.3  # [m] from where it turns to the goal
STRAIGHT = 0.35  # [rad] a kick may go so far off the middle of the goal
AHEAD = 0.5  # [m] that a teammate must be nearer to the ball, to be left alone


class Player:
    def __init__(self, facts):
        self.facts = facts
        self.lost_since = None

    def decide(self, moment):
        number = moment["player"]
        if moment["entered"]:
            self.lost_since = None
        answer = {"role": "keeper" if number == 1 else "supporter", "time_to_ball": 1e6}
        # outside play and at the opponents' kick: the default
        if moment["phase"] != "playing" or moment["penalised"]:
            return answer
        ball = moment["ball"]
        if ball["seen"] is None or moment["now"] - ball["seen"] > FORGOTTEN:
            return self.search(moment, answer)
        self.lost_since = None
        distance = math.hypot(ball["x"], ball["y"])
        bearing = math.atan2(ball["y"], ball["x"])
        answer["time_to_ball"] = distance / self.facts["walk"]["forward"]
        if moment["set_play"] != "none" and not moment["own_kick"]:
            return answer

        if number == 1:
            x, y = self.to_robot(moment, -self.facts["field"]["length"] / 2 + 0.4, 0)
            return walk_to(answer, x, y, bearing)
        if self.is_left_to_a_mate(moment, distance):
            c, s = math.cos(moment["heading"]), math.sin(moment["heading"])
            return walk_to(answer, ball["x"] - 1.5 * c, ball["y"] + 1.5 * s, bearing)
        answer["role"] = "chaser"
        return self.attack(moment, ball, distance, answer)

    def to_robot(self, moment, x, y):
        """Returns a point of the field in the frame of the robot."""
        c, s = math.cos(moment["heading"]), math.sin(moment["heading"])
        dx, dy = x - moment["x"], y - moment["y"]
        return c * dx + s * dy, c * dy - s * dx

    def is_left_to_a_mate(self, moment, distance):
        """Returns whether another field player is nearer to the ball."""
        for mate in moment["mates"]:
            if mate["player"] == 1 or not mate["active"] or moment["now"] - mate["sent"] > 300:
                continue
            if mate["time_to_ball"] * self.facts["walk"]["forward"] < distance - AHEAD:
                return True
        return False

    def search(self, moment, answer):
        if self.lost_since is None:
            self.lost_since = moment["now"]
        turns = (moment["now"] - self.lost_since) // 240
        answer.update(body="walk_speed", turn=SEARCH_TURN if turns % 2 == 0 else -SEARCH_TURN)
        return answer

    def attack(self, moment, ball, distance, answer):
        goal_x, goal_y = self.to_robot(moment, self.facts["field"]["length"] / 2, 0)
        way = math.atan2(goal_y - ball["y"], goal_x - ball["x"])  # of the ball, seen from the robot
        c, s = math.cos(way), math.sin(way)
        if distance > 2 * BEHIND:
            return walk_to(answer, ball["x"] - BEHIND * c, ball["y"] - BEHIND * s, way)
        kick = self.facts["kicks"][0]
        left = ball["y"] > 0
        foot = kick["ball_y"] if left else -kick["ball_y"]
        in_gate = abs(ball["x"] - kick["ball_x"]) < kick["gate_x"] and abs(ball["y"] - foot) < kick["gate_y"]
        if in_gate and abs(way) < STRAIGHT:
            answer.update(body="kick", kick=kick["name"], kick_left=left)
            return answer
        # to where the ball lies before the foot, facing the goal
        x, y = kick["ball_x"], foot
        return walk_to(answer, ball["x"] - c * x + s * y, ball["y"] - s * x - c * y, way)


def walk_to(answer, x, y, turn):
    answer.update(body="walk_to", x=x, y=y, turn=turn)
    return answer


def main():
    facts = json.loads(sys.stdin.readline())
    print(json.dumps({"version": 1, "name": "charge"}), flush=True)
    players = {}
    for line in sys.stdin:
        moment = json.loads(line)
        number = moment["player"]
        if number not in players:
            players[number] = Player(facts)
        print(json.dumps(players[number].decide(moment)), flush=True)


if __name__ == "__main__":
    main()
