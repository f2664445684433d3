#!/usr/bin/env python3
"""Lets foresight choose what a team's own behaviour plays: asks every second, the strategy that is played first.

    PYTHONPATH=.. python3 strategy.py [SECONDS]
"""

import sys
import time

import foresight

STRATEGIES = ["baseline", "passing", "kick_now"]  # as foresight-robot --strategies names what this team can play

adviser = foresight.Adviser()

played, answers = STRATEGIES[0], 0
end = time.monotonic() + float(sys.argv[1] if len(sys.argv) > 1 else 30)
while time.monotonic() < end:
    # what is played now goes first; the behaviour's own loop would use ask() and answer(), which never wait
    advice = adviser.what_if([played] + [name for name in STRATEGIES if name != played], horizon=20, budget_ms=300)
    if advice:
        answers += 1
        print(advice.reason, flush=True)
    if advice and advice.change:
        played = advice.choice
    time.sleep(1)

print("%d answers; plays %s" % (answers, played))
