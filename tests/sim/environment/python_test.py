"""The Python module foresight_env: the semantics of PettingZoo's parallel API and of Gymnasium's vector API, and the arrays.

    python_test.py FOLDER [--without-numpy]

FOLDER has libforesight_env.so and foresight-sim. With --without-numpy the module must do without it.
"""

import os
import subprocess
import sys
import tempfile
import unittest

kFolder = os.path.abspath(sys.argv.pop(1))
kWithout = "--without-numpy" in sys.argv
kSource = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "sim", "environment")
os.environ["FORESIGHT_ENV_LIBRARY"] = os.path.join(kFolder, "libforesight_env.so")
if kWithout:
    sys.argv.remove("--without-numpy")
    sys.modules["numpy"] = None
sys.path.insert(0, kSource)
import foresight_env  # noqa: E402

numpy = foresight_env.numpy


def bytes_of(rows):
    return bytes(rows.tobytes())


class Parallel(unittest.TestCase):
    """The demands of PettingZoo's parallel_api_test."""

    def play(self, env, seed):
        """Plays an episode with the first agent's actions by the seed; returns all that it showed."""
        shown = []
        observations, infos = env.reset(seed=seed)
        self.assertEqual(env.agents, env.possible_agents)
        for agent in env.possible_agents:
            env.action_space(agent).seed(seed)
        alive = set(env.agents)
        while env.agents:
            self.assertEqual(set(observations), set(env.agents))
            actions = {agent: env.action_space(agent).sample() for agent in env.agents}
            before = set(env.agents)
            result = env.step(actions)
            self.assertEqual(len(result), 5)
            for part in result:
                self.assertIsInstance(part, dict)
                self.assertEqual(set(part), before)
            observations, rewards, terminations, truncations, infos = result
            for agent in before:
                self.assertTrue(env.observation_space(agent).contains(observations[agent]))
                self.assertIsInstance(rewards[agent], float)
                self.assertIsInstance(terminations[agent], bool)
                self.assertIsInstance(truncations[agent], bool)
                self.assertIsInstance(infos[agent], dict)
                ended = terminations[agent] or truncations[agent]
                self.assertEqual(agent in env.agents, not ended)
            self.assertTrue(set(env.agents) <= alive, "an agent came back")
            alive = set(env.agents)
            shown.append((rewards, {agent: list(row) for agent, row in observations.items()}))
            observations = {agent: observations[agent] for agent in env.agents}
        return shown

    def test_the_semantics_of_the_parallel_api(self):
        for kind in ("menu", "skills", "motion"):
            with self.subTest(kind):
                env = foresight_env.parallel_env(drill="two_against_one", actions=kind, seconds=6)
                self.assertEqual(env.possible_agents, ["home_2", "home_3"])
                self.assertEqual(env.max_num_agents, 2)
                self.play(env, 4)
                self.assertEqual(env.num_agents, 0)

    def test_the_same_seed_and_actions_are_the_same_episode(self):
        env = foresight_env.parallel_env(drill="two_against_one", seconds=6)
        first, other, again = self.play(env, 4), self.play(env, 5), self.play(env, 4)
        self.assertEqual(first, again)
        self.assertNotEqual(first, other)

    def test_spaces_stay_the_same_objects(self):
        env = foresight_env.parallel_env(drill="empty_goal")
        agent = env.possible_agents[0]
        self.assertIs(env.observation_space(agent), env.observation_space(agent))
        self.assertIs(env.action_space(agent), env.action_space(agent))
        self.assertEqual(env.action_space(agent).n, 12)

    def test_a_step_after_the_end_is_empty(self):
        env = foresight_env.parallel_env(drill="empty_goal", seconds=0.1)
        self.play(env, 1)
        self.assertEqual(env.step({}), ({}, {}, {}, {}, {}))

    def test_time_over_is_a_truncation_and_success_a_termination(self):
        late = foresight_env.parallel_env(drill="empty_goal", seconds=0.1)
        late.reset(seed=1)
        _, _, terminations, truncations, _ = late.step({"home_2": 0})
        self.assertEqual((terminations, truncations), ({"home_2": False}, {"home_2": True}))
        chaser = {"name": "x", "based_on": "baseline", "menu": [{"use": "chaser"}]}
        env = foresight_env.parallel_env(drill="empty_goal", frame=chaser)
        ends = set()
        for seed in range(12):
            env.reset(seed=seed)
            while env.agents:
                _, rewards, terminations, truncations, infos = env.step({"home_2": 0})
            ends.add((terminations["home_2"], infos["home_2"]["success"], rewards["home_2"] > 0.9))
        self.assertIn((True, True, True), ends)


class Arrays(unittest.TestCase):
    def test_arrays_are_the_memory_of_the_library(self):
        games = foresight_env.Games(games=5, drill="two_against_one")
        observations = games.observations
        before = bytes_of(observations)
        games.reset(range(100, 105))
        self.assertNotEqual(bytes_of(observations), before, "the same array shows the new episodes")
        shape = (5, 2, games.columns)
        self.assertEqual(memoryview(observations).shape, shape)
        self.assertEqual(memoryview(games.actions).shape, (5, 2, 1))
        self.assertIn(memoryview(games.actions).format, ("f", "<f"))
        self.assertEqual(list(games.seeds), [100, 101, 102, 103, 104])

    def test_arrays_outlive_the_games(self):
        observations = foresight_env.Games(games=2).observations
        copy = bytes_of(observations)
        foresight_env.Games(games=200)
        self.assertEqual(bytes_of(observations), copy)

    def test_games_side_by_side_are_those_of_single_games(self):
        many, one = (foresight_env.Games(games=n, drill="empty_goal") for n in (7, 1))
        many.reset(range(7)), one.reset([4])
        for step in range(60):
            for game in range(7):
                many.actions[game, 0, 0] = step // 5 % 12
            one.actions[0, 0, 0] = step // 5 % 12
            many.step(), one.step()
            self.assertEqual(many.hash(4), one.hash(0))
        many.check()

    def test_about_describes_columns_and_actions(self):
        games = foresight_env.Games(drill="empty_goal", actions="skills")
        self.assertEqual(len(games.about.columns), games.columns)
        distance = [column for column in games.about.columns if column["name"] == "ball_distance"][0]
        self.assertEqual((distance["unit"], distance["formula"]), ("m", "value / (1 m + |value|)"))
        self.assertIn("kick", [action["skill"] for action in games.about.actions])

    def test_a_failure_is_a_sentence(self):
        with self.assertRaisesRegex(foresight_env.Error, "no drill 'emty_goal'; did you mean 'empty_goal'"):
            foresight_env.Games(drill="emty_goal")
        games = foresight_env.Games()
        games.actions[0, 2, 0] = 99
        with self.assertRaisesRegex(foresight_env.Error, "home_3 in game 0 must be a whole number 0 .. 11, got 99"):
            games.step()

    def test_a_saved_policy_is_a_behaviour(self):
        frame = {"based_on": "baseline", "menu": [{"do": "stand"}, {"use": "chaser"}], "inputs": ["ball_known"]}
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mine.json")
            foresight_env.save_policy(path, frame, [([[-1], [1]], [0, 0.5], "none")], name="mine")
            command = [os.path.join(kFolder, "foresight-sim"), "drills", "run", "empty_goal", path, "--trials", "40"]
            played = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(played.returncode, 0, played.stderr)
        self.assertNotIn("success     0.0", played.stdout)


@unittest.skipIf(numpy is None, "needs numpy")
class Vector(unittest.TestCase):
    """The semantics of gymnasium.vector.VectorEnv with AutoresetMode.NEXT_STEP."""

    def test_shapes_and_types(self):
        envs = foresight_env.vector_env(6, drill="two_against_one")
        self.assertEqual(envs.num_envs, 12)
        observations, infos = envs.reset(seed=3)
        self.assertEqual(observations.shape, (12,) + envs.single_observation_space.shape)
        self.assertEqual(observations.dtype, numpy.float32)
        self.assertIsInstance(infos, dict)
        observations, rewards, terminations, truncations, infos = envs.step(envs.action_space.sample())
        self.assertEqual((rewards.shape, terminations.shape, truncations.shape), ((12,), (12,), (12,)))
        self.assertEqual((terminations.dtype, truncations.dtype), (bool, bool))
        self.assertTrue(numpy.shares_memory(observations, envs.games.observations))

    def test_a_seed_is_the_first_of_consecutive_ones(self):
        envs = foresight_env.vector_env(4, drill="empty_goal")
        first = envs.reset(seed=7)[0].copy()
        second = envs.reset(seed=[7, 8, 9, 10])[0].copy()
        self.assertTrue((first == second).all())
        self.assertFalse((first[0] == first[1]).all())

    def test_the_step_after_an_end_resets_without_reward(self):
        envs = foresight_env.vector_env(3, drill="empty_goal", seconds=1, ticks=30)
        envs.reset(seed=1)
        _, _, terminations, truncations, _ = envs.step(numpy.zeros(3, int))
        self.assertTrue(truncations.all() and not terminations.any())
        seeds = envs.games.seeds.copy()
        _, rewards, terminations, truncations, infos = envs.step(numpy.zeros(3, int))
        self.assertFalse(truncations.any() or terminations.any() or rewards.any())
        self.assertTrue(infos["active"].all() and (envs.games.seeds != seeds).all())

    def test_a_mask_resets_some(self):
        envs = foresight_env.vector_env(3, drill="empty_goal")
        envs.reset(seed=1)
        for _ in range(20):
            envs.step(numpy.zeros(3, int))
        before = [envs.games.hash(game) for game in range(3)]
        envs.reset(seed=1, options={"reset_mask": numpy.array([False, True, False])})
        self.assertEqual([envs.games.hash(game) == before[game] for game in range(3)], [True, False, True])

    def test_the_example_learns_and_its_policy_plays(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "striker.json")
            example = os.path.join(kSource, "examples", "train.py")
            learned = subprocess.run([sys.executable, example, "--generations", "2", path], capture_output=True, text=True)
            self.assertEqual(learned.returncode, 0, learned.stderr)
            command = [os.path.join(kFolder, "foresight-sim"), "match", "--home", path, "--rules", "spl2012,half_duration=30"]
            played = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(played.returncode, 0, played.stderr)


if __name__ == "__main__":
    unittest.main()
