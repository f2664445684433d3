#!/usr/bin/env python3
"""Learns a policy for a drill by an evolution strategy, with numpy alone, and writes it as a behaviour.

    scripts/build release foresight-sim foresight_env
    ./sim/environment/examples/train.py --drill empty_goal --seconds 100 striker.json
    foresight-sim drills run empty_goal striker.json --seed 1000000
    foresight-sim drills run empty_goal kick_now --seed 1000000

The policy is a net with one hidden layer. It chooses between the rules of `FRAME`, and begins without any knowledge: all
its weights are 0. In each generation all candidates play the same starts, and the next generation has new ones. The last
line is the score of the policy on starts that it never saw.
"""

import argparse
import os
import sys
import time

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import foresight_env  # noqa: E402

FRAME = {
    "based_on": "baseline",
    "name": "learner",
    "menu": [
        {"name": "shoot at once", "do": "kick", "with": {"aim": "goal", "tolerance": "60 deg", "range": "1 m"}},
        {"name": "shoot", "do": "kick", "with": {"aim": "opening", "tolerance": "25 deg", "range": "2 m"}},
        {"name": "shoot with care", "do": "kick", "with": {"aim": "opening", "tolerance": "8 deg", "range": "3 m"}},
        {"name": "any kick", "do": "kick", "with": {"aim": "goal", "tolerance": "20 deg", "kick": "any", "range": "1 m"}},
        {"name": "dribble", "do": "dribble", "with": {"aim": "goal"}},
        {"name": "walk", "do": "walk_to_ball"},
        {"name": "search", "do": "search_ball"},
    ],
    "inputs": ["ball_known", "ball_age", "ball_distance", "ball_bearing", "ball_ahead", "ball_left", "ball_speed",
               "ball_x", "ball_off_centre", "ball_goal_distance", "goal_bearing", "goal_opening", "line_error",
               "aligned", "kick_error", "opponent_ball_distance", "leaf_age"],
}
HIDDEN = 12
CANDIDATES = 32  # of a generation, half of them mirrored
STARTS = 32  # of each candidate in a generation
HELD_OUT = 1_000_000_000  # first seed of the last test
SPREAD = 0.2  # standard deviation of the candidates' weights


def layers_of(weights, inputs, outputs):
    """Splits rows of weights into the layers of their nets."""
    first, second = inputs * HIDDEN, HIDDEN * outputs
    parts = numpy.split(weights, [first, first + HIDDEN, first + HIDDEN + second], axis=1)
    return (parts[0].reshape(-1, inputs, HIDDEN), parts[1][:, None], parts[2].reshape(-1, HIDDEN, outputs), parts[3][:, None])


def play(games, weights, seed, outputs):
    """Plays each candidate on the same starts; returns its mean score and its share of successes."""
    candidates = len(weights)
    starts = games.games // candidates
    w1, b1, w2, b2 = layers_of(weights, games.columns, outputs)
    games.reset(numpy.tile(numpy.arange(seed, seed + starts), candidates))
    score = numpy.zeros(games.games)
    while not (games.terminated | games.truncated).all():
        seen = games.observations.reshape(candidates, starts, games.columns)
        choice = (numpy.tanh(seen @ w1 + b1) @ w2 + b2).argmax(axis=2)
        games.actions[:] = choice.reshape(games.games, 1, 1)
        games.step()
        score += games.rewards[:, 0]
    return score.reshape(candidates, starts).mean(axis=1), games.succeeded.reshape(candidates, starts).mean(axis=1)


def learn(options):
    games = foresight_env.Games(games=CANDIDATES * STARTS, drill=options.drill, frame=FRAME, restart="never")
    if len(games.agents) != 1:
        sys.exit("train.py: expected a drill with one agent, got " + ", ".join(games.agents))
    outputs = len(FRAME["menu"])
    size = games.columns * HIDDEN + HIDDEN + HIDDEN * outputs + outputs
    random = numpy.random.default_rng(options.seed)
    mean, momentum, squares = numpy.zeros(size), numpy.zeros(size), numpy.zeros(size)
    end, generation = time.monotonic() + options.seconds, 0
    while time.monotonic() < end if options.generations == 0 else generation < options.generations:
        noise = random.standard_normal((CANDIDATES // 2, size))
        noise = numpy.concatenate([noise, -noise])
        scores, successes = play(games, mean + SPREAD * noise, STARTS * generation, outputs)
        # ranks instead of scores: a lucky candidate must not decide alone
        ranks = scores.argsort().argsort() / (CANDIDATES - 1) - 0.5
        slope = ranks @ noise / (CANDIDATES * SPREAD)
        generation += 1
        momentum = 0.9 * momentum + 0.1 * slope
        squares = 0.99 * squares + 0.01 * slope ** 2
        step = momentum / (1 - 0.9 ** generation) / (numpy.sqrt(squares / (1 - 0.99 ** generation)) + 1e-8)
        mean = mean + options.rate * step
        if generation % 10 == 0:
            print("generation %3d: score %.3f, success %.1f %%" % (generation, scores.mean(), 100 * successes.mean()), flush=True)
    held_out = [play(games, mean[None], HELD_OUT + i * games.games, outputs) for i in range(2)]
    print("held out: score %.3f, success %.1f %% of %d attempts" %
          (numpy.mean([score for score, _ in held_out]), 100 * numpy.mean([success for _, success in held_out]), 2 * games.games))
    w1, b1, w2, b2 = layers_of(mean[None].astype(numpy.float32), games.columns, outputs)
    foresight_env.save_policy(options.out, FRAME, [(w1[0].T, b1[0, 0], "tanh"), (w2[0].T, b2[0, 0], "none")], name="learned",
                              about="learned in the drill " + options.drill)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", help="new file of the policy")
    parser.add_argument("--drill", default="empty_goal", help="a drill with one agent")
    parser.add_argument("--seconds", type=float, default=100, help="time of learning")
    parser.add_argument("--generations", type=int, default=0, help="number of generations, instead of --seconds")
    parser.add_argument("--rate", type=float, default=0.1, help="largest change of a weight in a generation")
    parser.add_argument("--seed", type=int, default=1)
    learn(parser.parse_args())


if __name__ == "__main__":
    main()
