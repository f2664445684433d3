#!/usr/bin/env python3
"""A behaviour that lets foresight choose its strategy: it asks every second.

    PYTHONPATH=.. python3 strategy.py [SECONDS]
"""

import sys
import time

import foresight

STRATEGIES = ["baseline", "passing", "kick_now"]  # the names of foresight-robot --strategies

adviser = foresight.Adviser()

played, answers = STRATEGIES[0], 0
end = time.monotonic() + float(sys.argv[1] if len(sys.argv) > 1 else 30)
while time.monotonic() < end:
    # the strategy that is played now goes first; a behaviour's own loop would use ask() and answer(), which never wait
    advice = adviser.what_if([played] + [name for name in STRATEGIES if name != played], horizon=20, budget_ms=300)
    if advice:
        answers += 1
        print(advice.reason, flush=True)
    if advice and advice.change:
        played = advice.choice
    time.sleep(1)

print("%d answers; plays %s" % (answers, played))
