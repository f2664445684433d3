"""Games of simulated robot soccer for learners, many side by side. Python 3.8 or newer, standard library only; numpy,
Gymnasium and PettingZoo are used where they are installed.

    env = foresight_env.parallel_env(drill="two_against_one")        # the parallel API of PettingZoo: one game
    observations, infos = env.reset(seed=7)
    while env.agents:
        actions = {agent: env.action_space(agent).sample() for agent in env.agents}
        observations, rewards, terminations, truncations, infos = env.step(actions)

    envs = foresight_env.vector_env(1024, drill="empty_goal")         # the vector API of Gymnasium: many games
    observations, infos = envs.reset(seed=7)
    observations, rewards, terminations, truncations, infos = envs.step(actions)

    games = foresight_env.Games(games=1024, drill="empty_goal")       # the arrays themselves, without copies
    games.reset(range(1024))
    games.actions[:] = choose(games.observations)
    games.step()

Options are those of sim/environment/options.h, as keywords. Observations, rewards and actions are numpy arrays where numpy
is installed, otherwise memoryviews. They show the library's own memory, so the next step overwrites them: copy() keeps
them.

The library libforesight_env.so is looked for at $FORESIGHT_ENV_LIBRARY, beside this file, and in the build folders of the
repository. `scripts/build release foresight_env` builds it.
"""

import ctypes
import json
import math
import os
import random
from types import SimpleNamespace

try:
    import numpy
except ImportError:
    numpy = None
try:
    from gymnasium import spaces as _gymnasium
except ImportError:
    _gymnasium = None

__all__ = ["parallel_env", "vector_env", "Games", "ParallelEnv", "VectorEnv", "Box", "Discrete", "Error", "save_policy"]

VERSION = 1  # of the interface in foresight_env.h


class Error(Exception):
    """A failure of the library, as one sentence."""


class Box:
    """A space of float32 rows between `low` and `high`, for programs without Gymnasium."""

    def __init__(self, low, high, shape, seed=None):
        self.low, self.high, self.shape, self.dtype = low, high, tuple(shape), "float32"
        self._random = random.Random(seed)

    def seed(self, seed=None):
        self._random = random.Random(seed)

    def sample(self):
        row = [self._random.uniform(low, high) for low, high in zip(_row(self.low, self.shape), _row(self.high, self.shape))]
        return numpy.array(row, numpy.float32) if numpy else row

    def contains(self, row):
        values = list(row)
        bounds = zip(values, _row(self.low, self.shape), _row(self.high, self.shape))
        return len(values) == self.shape[0] and all(low <= value <= high for value, low, high in bounds)

    def __contains__(self, row):
        return self.contains(row)


class Discrete:
    """A space of the whole numbers 0 .. n - 1, for programs without Gymnasium."""

    def __init__(self, n, seed=None):
        self.n, self.shape, self.dtype = n, (), "int64"
        self._random = random.Random(seed)

    def seed(self, seed=None):
        self._random = random.Random(seed)

    def sample(self):
        return self._random.randrange(self.n)

    def contains(self, number):
        return int(number) == number and 0 <= number < self.n

    def __contains__(self, number):
        return self.contains(number)


def _row(bound, shape):
    return [bound] * shape[0] if isinstance(bound, (int, float)) else bound


def _box(low, high, shape):
    if _gymnasium is None:
        return Box(low, high, shape)
    low = numpy.array(_row(low, shape), numpy.float32)
    high = numpy.array(_row(high, shape), numpy.float32)
    return _gymnasium.Box(low, high, tuple(shape), numpy.float32)


def _discrete(n):
    return Discrete(n) if _gymnasium is None else _gymnasium.Discrete(n)


class _Shape(ctypes.Structure):
    _fields_ = [(name, ctypes.c_int32) for name in ("games", "agents", "columns", "width")]


class _Arrays(ctypes.Structure):
    _fields_ = [(name, ctypes.c_void_p) for name in (
        "observations", "actions", "rewards", "terminated", "truncated", "active", "succeeded", "seeds")]


def _find_library():
    here = os.path.dirname(os.path.abspath(__file__))
    builds = [os.path.join(here, "..", "..", "build", preset, "bin") for preset in ("release", "dev")]
    places = [os.path.join(folder, "libforesight_env.so") for folder in [here] + builds]
    if os.environ.get("FORESIGHT_ENV_LIBRARY"):
        places = [os.environ["FORESIGHT_ENV_LIBRARY"]]
    for place in places:
        if os.path.exists(place):
            return place
    raise Error("libforesight_env.so is missing: expected it at " + ", ".join(map(os.path.normpath, places)) +
                "; scripts/build release foresight_env builds it")


_library = None


def _load():
    global _library
    if _library is not None:
        return _library
    library = ctypes.CDLL(_find_library())
    pointer, text = ctypes.c_void_p, ctypes.c_char_p
    for name, result, arguments in (
            ("version", ctypes.c_int32, []),
            ("open", pointer, [ctypes.c_int32, text, text, ctypes.c_size_t]),
            ("close", None, [pointer]),
            ("shape_of", _Shape, [pointer]),
            ("arrays_of", _Arrays, [pointer]),
            ("about", text, [pointer]),
            ("reset", ctypes.c_int32, [pointer, pointer, pointer]),
            ("step", ctypes.c_int32, [pointer]),
            ("check", ctypes.c_int32, [pointer]),
            ("hash", ctypes.c_uint64, [pointer, ctypes.c_int32]),
            ("error", text, [pointer])):
        function = getattr(library, "foresight_env_" + name)
        function.restype, function.argtypes = result, arguments
    if library.foresight_env_version() != VERSION:
        raise Error("libforesight_env.so has version %d of the interface, expected %d" %
                    (library.foresight_env_version(), VERSION))
    _library = library
    return library


_LETTERS = {ctypes.c_float: "f", ctypes.c_uint8: "B", ctypes.c_uint64: "Q"}


class _View:
    """A part of the library's memory with the buffer protocol; it keeps the games open."""

    @staticmethod
    def of(games, address, kind, shape):
        count = math.prod(shape)
        memory = (kind * count).from_address(address)
        memory.games = games
        if numpy is not None:
            return numpy.ctypeslib.as_array(memory).reshape(shape)
        return memoryview(memory).cast("B").cast(_LETTERS[kind], shape)


class Games:
    """Many games side by side, and their arrays. Rows are by game, and in a game by agent.

    observations (games, agents, columns), actions (games, agents, width), rewards, terminated, truncated and active (games,
    agents), succeeded and seeds (games). `about` describes agents, columns and actions. Different threads may use different
    Games; a step releases the interpreter's lock.
    """

    def __init__(self, **options):
        self._handle = None
        self._library = _load()
        problem = ctypes.create_string_buffer(2000)
        self._handle = self._library.foresight_env_open(VERSION, json.dumps(options).encode(), problem, len(problem))
        if not self._handle:
            raise Error(problem.value.decode(errors="replace"))
        self.about = SimpleNamespace(**json.loads(self._library.foresight_env_about(self._handle)))
        self.agents = list(self.about.agents)
        shape = self._library.foresight_env_shape_of(self._handle)
        self.games, self.columns, self.width = shape.games, shape.columns, shape.width
        arrays = self._library.foresight_env_arrays_of(self._handle)
        rows = (self.games, shape.agents)
        view = lambda name, kind, size: _View.of(self, getattr(arrays, name), kind, size)
        self.observations = view("observations", ctypes.c_float, rows + (self.columns,))
        self.actions = view("actions", ctypes.c_float, rows + (self.width,))
        self.rewards = view("rewards", ctypes.c_float, rows)
        self.terminated = view("terminated", ctypes.c_uint8, rows)
        self.truncated = view("truncated", ctypes.c_uint8, rows)
        self.active = view("active", ctypes.c_uint8, rows)
        self.succeeded = view("succeeded", ctypes.c_uint8, (self.games,))
        self.seeds = view("seeds", ctypes.c_uint64, (self.games,))

    def __del__(self):
        if getattr(self, "_handle", None):
            self._library.foresight_env_close(self._handle)

    def reset(self, seeds, which=None):
        """Begins new episodes: one seed per game; `which` selects the games."""
        given = (ctypes.c_uint64 * self.games)(*(int(seed) for seed in seeds))
        chosen = None if which is None else (ctypes.c_uint8 * self.games)(*(bool(one) for one in which))
        self._done(self._library.foresight_env_reset(self._handle, given, chosen))

    def step(self):
        """Plays on by `actions`."""
        self._done(self._library.foresight_env_step(self._handle))

    def check(self):
        """Raises an Error if the state of a game is invalid."""
        self._done(self._library.foresight_env_check(self._handle))

    def hash(self, game):
        """Returns a hash of the state of a game."""
        return self._library.foresight_env_hash(self._handle, game)

    def _done(self, status):
        if status != 0:
            raise Error(self._library.foresight_env_error(self._handle).decode(errors="replace"))

    def observation_space(self):
        return _box(-1.0, 1.0, (self.columns,))

    def action_space(self):
        """Discrete for menus, otherwise a Box. In a Box of skills the number of the skill is rounded down."""
        if self.about.kind == "menu":
            return _discrete(len(self.about.actions))
        if self.about.kind == "motion":
            return _box(-1.0, 1.0, (self.width,))
        return _box([0.0] + [-1.0] * (self.width - 1), [len(self.about.actions) - 0.001] + [1.0] * (self.width - 1),
                    (self.width,))

    def write_action(self, game, agent, action):
        """Writes one action of the action space to the row of an agent. Arguments of skills are from -1 to 1, the ends of
        their ranges; NaN is the default."""
        row = self.actions[game, agent] if numpy is not None else None
        values = [action] if self.about.kind == "menu" else list(action)
        if self.about.kind == "skills":
            values = self._skill_row(values)
        for i, value in enumerate(values):
            if row is not None:
                row[i] = value
            else:
                self.actions[game, agent, i] = value

    def _skill_row(self, values):
        skill = min(max(int(values[0]), 0), len(self.about.actions) - 1)
        row = [math.nan] * self.width
        row[0] = skill
        for i, info in enumerate(self.about.actions[skill]["parameters"]):
            share = 0.5 + 0.5 * min(max(float(values[1 + i]), -1.0), 1.0)
            if math.isnan(values[1 + i]):
                continue
            value = info["least"] + share * (info["most"] - info["least"])
            row[1 + i] = round(value) if info["whole"] else value
        return row


class ParallelEnv:
    """One game with the parallel API of PettingZoo.

    All agents of a game end together. `infos[agent]["active"]` is False while a robot is penalised or out of play: its
    action then has no effect. `infos[agent]["success"]` says at the end whether the drill succeeded.
    """

    metadata = {"name": "foresight_v1", "render_modes": []}
    render_mode = None

    def __init__(self, **options):
        options.setdefault("restart", "never")
        self.games = Games(games=1, **options)
        self.possible_agents = list(self.games.agents)
        self.agents = []
        self._index = {agent: i for i, agent in enumerate(self.possible_agents)}
        self.observation_spaces = {agent: self.games.observation_space() for agent in self.possible_agents}
        self.action_spaces = {agent: self.games.action_space() for agent in self.possible_agents}
        self._seed = random.SystemRandom().getrandbits(48)

    @property
    def unwrapped(self):
        return self

    @property
    def num_agents(self):
        return len(self.agents)

    @property
    def max_num_agents(self):
        return len(self.possible_agents)

    def observation_space(self, agent):
        return self.observation_spaces[agent]

    def action_space(self, agent):
        return self.action_spaces[agent]

    def reset(self, seed=None, options=None):
        """Begins an episode. Without a seed it takes the one after the last."""
        self._seed = self._seed + 1 if seed is None else int(seed)
        self.games.reset([self._seed])
        self.agents = list(self.possible_agents)
        return self._observations(), self._infos()

    def step(self, actions):
        """Plays on by the actions of all agents. An agent without an action goes on as before."""
        if not self.agents:
            return {}, {}, {}, {}, {}
        for agent, action in actions.items():
            self.games.write_action(0, self._index[agent], action)
        self.games.step()
        games, index = self.games, self._index
        rewards = {agent: float(games.rewards[0, index[agent]]) for agent in self.agents}
        terminations = {agent: bool(games.terminated[0, index[agent]]) for agent in self.agents}
        truncations = {agent: bool(games.truncated[0, index[agent]]) for agent in self.agents}
        result = self._observations(), rewards, terminations, truncations, self._infos()
        self.agents = [agent for agent in self.agents if not terminations[agent] and not truncations[agent]]
        return result

    def render(self):
        return None

    def close(self):
        self.agents = []

    def _observations(self):
        rows = self.games.observations
        if numpy is not None:
            return {agent: rows[0, self._index[agent]].copy() for agent in self.agents}
        return {agent: [rows[0, self._index[agent], i] for i in range(self.games.columns)] for agent in self.agents}

    def _infos(self):
        return {agent: {"active": bool(self.games.active[0, self._index[agent]]),
                        "success": bool(self.games.succeeded[0])} for agent in self.agents}


class VectorEnv:
    """Many games with the vector API of Gymnasium; needs numpy. Each agent of each game is one environment, so that one
    policy may move all agents: environment i is agent i % agents of game i // agents.

    A game that has ended begins anew in the next step, whose action is ignored and whose reward is 0 (Gymnasium's
    AutoresetMode.NEXT_STEP). The returned arrays are the library's own: copy what you keep.
    """

    metadata = {"name": "foresight_v1", "render_modes": [], "autoreset_mode": "NextStep"}
    render_mode = None
    spec = None

    def __init__(self, games=1, **options):
        if numpy is None:
            raise Error("vector_env needs numpy; Games works without it")
        self.games = Games(games=games, **options)
        self.num_envs = games * len(self.games.agents)
        self.single_observation_space = self.games.observation_space()
        self.single_action_space = self.games.action_space()
        self.observation_space = self._batched(self.single_observation_space)
        self.action_space = self._batched(self.single_action_space)
        self.observations = self.games.observations.reshape(self.num_envs, self.games.columns)
        self.rewards = self.games.rewards.reshape(self.num_envs)
        self.terminations = self.games.terminated.reshape(self.num_envs).view(bool)
        self.truncations = self.games.truncated.reshape(self.num_envs).view(bool)
        self.active = self.games.active.reshape(self.num_envs).view(bool)
        self._actions = self.games.actions.reshape(self.num_envs, self.games.width)
        self._seed = random.SystemRandom().getrandbits(48)

    @property
    def unwrapped(self):
        return self

    def _batched(self, space):
        if _gymnasium is not None:
            from gymnasium.vector.utils import batch_space
            return batch_space(space, self.num_envs)
        return SimpleNamespace(shape=(self.num_envs,) + tuple(space.shape), dtype=space.dtype,
                               sample=lambda: numpy.stack([space.sample() for _ in range(self.num_envs)]))

    def reset(self, seed=None, options=None):
        """Begins all games: game i with seed + i, or with seed[i]. options={"reset_mask": mask} selects games by their
        environments."""
        games = self.games.games
        if seed is None:
            self._seed += games
            seed = self._seed
        seeds = range(int(seed), int(seed) + games) if numpy.ndim(seed) == 0 else list(seed)[::len(self.games.agents)]
        mask = (options or {}).get("reset_mask")
        self.games.reset(seeds, None if mask is None else numpy.asarray(mask)[::len(self.games.agents)])
        return self.observations, self._infos()

    def step(self, actions):
        actions = numpy.asarray(actions)
        if self.games.about.kind == "skills":
            for i in range(self.num_envs):
                self._actions[i] = self.games._skill_row(list(actions[i]))
        else:
            self._actions[:] = actions.reshape(self.num_envs, self.games.width)
        self.games.step()
        return self.observations, self.rewards, self.terminations, self.truncations, self._infos()

    def _infos(self):
        every = numpy.ones(self.num_envs, bool)
        success = self.games.succeeded.view(bool).repeat(len(self.games.agents))
        return {"active": self.active, "_active": every, "success": success, "_success": every}

    def render(self):
        return None

    def close(self, **kwargs):
        pass


def parallel_env(**options):
    """Opens one game with the parallel API of PettingZoo."""
    return ParallelEnv(**options)


def vector_env(games=1, **options):
    """Opens many games with the vector API of Gymnasium."""
    return VectorEnv(games, **options)


def save_policy(path, frame, layers, name="policy", about=""):
    """Writes a behaviour that foresight-sim, compare and the robot play by the name of its file.

    `frame` is the option of that name: menu, inputs and settings. `layers` is a list of (weights, bias, activation), with
    a row of weights per output.
    """
    rows = lambda weights: [[float("%.7g" % value) for value in row] for row in weights]
    policy = dict(frame, name=name, about=about)
    policy["net"] = {"layers": [{"weights": rows(weights), "bias": rows([bias])[0], "activation": activation}
                                for weights, bias, activation in layers]}
    with open(path, "w") as file:
        json.dump(policy, file)
        file.write("\n")
