#!/usr/bin/env python3
"""A complete behaviour in its own process, Python 3.6 or newer, standard library only: the starting point of your own.

    foresight-sim match --home 'pipe:python3 sim/guest/examples/charge.py'

It plays about as well as `baseline`. The skills are in soccer.py; the decisions are here. charge.c is the same in C.
It answers each line with one line; sim/guest/wire.h documents them. Its output to stderr is shown.
"""
import json
import sys

from soccer import (
    Memory,
    Sight,
    dribble_to,
    guard_goal,
    hold,
    keep_clear,
    kick_to,
    opening,
    place_between,
    place_in_space,
    search_ball,
    settle_role,
)

TOLERANCE = 0.26  # [rad] allowed error of a kick
ANY_WAY = 1.05  # [rad] where the direction matters little


def keep(sight, memory, answer):
    """The goalkeeper comes out and clears a near ball."""
    out = sight.ball_in_team - sight.own_goal
    if abs(out) < 1.3 and sight.ball_distance < 1.4 and sight.ball_age < 30:
        kick_to(sight, memory, sight.ball_in_team + out, 0, ANY_WAY, 5, answer)
    else:
        guard_goal(sight, answer)


def chase(sight, memory, answer):
    ball = sight.ball_in_team
    to_goal = abs(sight.goal - ball)
    target, slack = opening(sight)
    if sight.moment["set_play"] == "kick_off" and sight.moment["own_kick"]:
        kick_to(sight, memory, ball + 1, 0, ANY_WAY, 1, answer)
    elif to_goal < 0.6:
        dribble_to(sight, target, 2 * TOLERANCE, answer)
    else:
        pressed = sight.opponent_distance(ball) < 0.6 or to_goal < 1.5
        kick_to(sight, memory, target, slack, TOLERANCE, 1.8 if pressed else 5, answer)


def decide(facts, memory, moment):
    answer = {}
    sight = Sight(facts, moment)
    role = settle_role(sight, memory, answer)
    # outside play: the default
    if moment["phase"] != "playing" or moment["penalised"]:
        return answer
    if not sight.ball_known or (role == "chaser" and sight.ball_age > 3 * 30):
        search_ball(sight, memory, role == "keeper", answer)
        return answer
    memory.searching = None
    if role == "keeper":
        guard_goal(sight, answer) if sight.theirs else keep(sight, memory, answer)
    elif role == "chaser" and not sight.theirs:
        chase(sight, memory, answer)
    else:
        hold(sight, place_in_space(sight) if role == "supporter" else place_between(sight), answer)
    keep_clear(sight, answer)
    return answer


def main():
    facts = json.loads(sys.stdin.readline())
    print(json.dumps({"version": 1, "name": "charge"}), flush=True)
    memories = {}
    for line in sys.stdin:
        moment = json.loads(line)
        number = moment["player"]
        if number not in memories or moment["entered"]:
            memories[number] = Memory()
        print(json.dumps(decide(facts, memories[number], moment)), flush=True)


if __name__ == "__main__":
    main()
