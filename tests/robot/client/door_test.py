"""The door with real processes: the runtime, the Python module, the C examples, and kill -9 on both sides.

    python3 door_test.py FOLDER_OF_PROGRAMS
"""

import itertools
import json
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock

HERE = os.path.dirname(os.path.abspath(__file__))
CLIENT = os.path.join(HERE, "..", "..", "..", "robot", "client")
sys.path.insert(0, CLIENT)

import foresight  # noqa: E402

PROGRAMS = sys.argv.pop(1)
PATIENCE = 60  # [s] far above every normal time; only a failure waits this long

# writes one object until it is killed; all bytes of a message are equal
PULSE = """
import sys
sys.path.insert(0, sys.argv[1])
import foresight
pulse = foresight.Writer("pulse", "test.Pulse", encoding="json")
n = 0
while True:
    n += 1
    size = 50000 if n % 4 == 0 else 300
    pulse.write(foresight.now_ns(), bytes([n % 256]) * size)
"""


def until(condition, what):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.005)
    raise AssertionError("waited %d s without success: %s" % (PATIENCE, what))


def waits():
    """Returns how often this thread gave up the processor in order to wait; the load of the machine does not matter."""
    return resource.getrusage(resource.RUSAGE_THREAD).ru_nvcsw


class Client(unittest.TestCase):
    """Tests without a runtime."""

    def test_a_wait_of_no_time_or_less_returns_at_once(self):
        with foresight.Reader("forecast", door="/nowhere") as reader:
            for timeout in (0, -1, -0.001):
                reader.wait(timeout)

    def test_a_passed_deadline_ends_the_wait(self):
        adviser = foresight.Adviser(door="/nowhere")
        adviser.ask = lambda *_: True  # the question counts as sent, and no answer comes
        waited = []
        adviser._forecasts.wait = waited.append
        # a clock that jumps at each read, as for a thread that waits long for the processor
        for step_ns in range(1000000, 200000000, 1000000):
            clock = itertools.count(10 ** 12, step_ns)
            with unittest.mock.patch.object(foresight, "now_ns", lambda: next(clock)):
                self.assertIsNone(adviser.what_if(["baseline"], budget_ms=10))
        self.assertTrue(waited)
        self.assertTrue(all(0 < timeout <= 0.11 for timeout in waited), waited)

    def test_a_forecast_is_read_as_it_was_written(self):
        question = foresight.uint_field(1, 77) + foresight.bytes_field(2, "passing")
        forecast = (foresight.bytes_field(1, question) + foresight.uint_field(3, 2) + foresight.bytes_field(4, "passing")
                    + foresight.bytes_field(5, "changes to passing"))
        message = foresight.Message(1, 2, 3, forecast)
        self.assertEqual(foresight.read_forecast(message), (77, (True, True, "passing", "changes to passing")))
        empty = foresight.Message(1, 2, 3, b"")
        self.assertEqual(foresight.read_forecast(empty), (0, (False, False, "", "")))


class Runtime:
    """foresight-robot with an open door."""

    def __init__(self, folder, *words):
        self.folder = folder
        self.output = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen(
            [os.path.join(PROGRAMS, "foresight-robot"), "--body", "attached", "--port", "0",
             "--state-dir", os.path.join(folder, "state"), "--log-dir", os.path.join(folder, "logs"), *words],
            stdout=self.output, stderr=subprocess.STDOUT)

    def said(self):
        self.output.seek(0)
        return self.output.read()

    def end(self, how=signal.SIGTERM):
        self.process.send_signal(signal.SIGCONT)
        self.process.send_signal(how)
        self.process.wait(PATIENCE)

    def close(self):
        if self.process.poll() is None:
            self.end()
        self.output.close()


class Door(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        os.environ["FORESIGHT_DOOR"] = os.path.join(self.folder.name, "door")

    def start(self, *words):
        runtime = Runtime(self.folder.name, *words)
        self.addCleanup(runtime.close)
        return runtime

    def reader(self, topic):
        reader = foresight.Reader(topic)
        self.addCleanup(reader.close)
        return reader

    def writer(self, *words, **options):
        writer = foresight.Writer(*words, **options)
        self.addCleanup(writer.close)
        return writer

    def run_beside(self, *command, environment=None):
        child = subprocess.Popen(command, stdout=subprocess.PIPE, universal_newlines=True,
                                 env=dict(os.environ, **(environment or {})))
        self.addCleanup(child.stdout.close)
        self.addCleanup(lambda: child.poll() is None and (child.kill(), child.wait()))
        return child

    def test_a_process_reads_the_messages_of_another(self):
        self.start()
        ball, reader = self.writer("ball", "foresight.Ball"), self.reader("ball")
        message = foresight.float_field(2, 1.5) + foresight.uint_field(7, True)
        captured = foresight.now_ns()
        until(lambda: ball.write(captured, message), "a runtime")
        seen = until(reader.read, "the ball")
        self.assertEqual(seen.bytes, message)
        self.assertEqual(seen.capture_ns, captured)
        self.assertEqual(reader.object["topic"], "/14/2/ball")
        self.assertEqual(reader.object["type"], "foresight.Ball")
        self.assertEqual([(n, v if n == 7 else foresight.as_float(v)) for n, v in foresight.fields(seen.bytes)],
                         [(2, 1.5), (7, 1)])

    def test_parameters_can_be_read_but_not_written(self):
        self.start()
        seen = until(self.reader("parameters").read, "the parameters")
        self.assertEqual(json.loads(seen.bytes.decode())["recording"], False)
        writer = self.writer("parameters", encoding="json")
        until(lambda: not writer.write(1, b"{}") and "refuses" in writer.problem, "a refusal")
        self.assertEqual(writer.problem, "the runtime refuses: /14/2/parameters: expected an object of the team's, "
                                         "got one that only the runtime writes")

    def test_the_runtime_alone_writes_the_game_when_it_listens_to_the_game_controller(self):
        runtime = self.start("--game-controller", "--game-port", "0")
        writer = self.writer("game", "foresight.GameState")
        until(lambda: not writer.write(1, b"") and "refuses" in writer.problem, "a refusal")
        self.assertEqual(writer.problem, "the runtime refuses: /14/2/game: expected an object of the team's, "
                                         "got one that only the runtime writes")
        # team messages are off, so the team's own code may write this object
        team = self.writer("team", "foresight.Team")
        until(lambda: team.write(foresight.now_ns(), b""), "a runtime")
        self.assertEqual(team.problem, "")
        time.sleep(0.3)  # the runtime checks the game ten times a second
        runtime.end()
        self.assertEqual(runtime.process.returncode, 0)

    def test_images_arrive_complete(self):
        self.start()
        camera, reader = self.writer("camera_top", "foresight.Image"), self.reader("camera_top")
        until(lambda: reader.read() is None and not reader.problem, "a runtime")
        for i in range(40):
            pixels = bytearray([i]) * (2 * 640 * 480)
            until(lambda: camera.write(i + 1, *foresight.image(foresight.YUYV, 640, 480, pixels)), "a place")
            seen = until(reader.read, "the image")
            self.assertEqual(seen.capture_ns, i + 1)
            self.assertEqual(dict(foresight.fields(seen.bytes)), {1: 1, 2: 640, 3: 480, 4: bytes(pixels)})

    def test_a_field_of_another_type_is_refused_with_a_sentence(self):
        runtime = self.start()
        # a FileDescriptorSet whose foresight.Ball has a double where ours has a float
        field = (foresight.bytes_field(1, "x") + foresight.uint_field(3, 2) + foresight.uint_field(4, 1)
                 + foresight.uint_field(5, 1))
        ball = foresight.bytes_field(1, "Ball") + foresight.bytes_field(2, field)
        file = (foresight.bytes_field(1, "ball.proto") + foresight.bytes_field(2, "foresight")
                + foresight.bytes_field(4, ball) + foresight.bytes_field(12, "proto3"))
        writer = self.writer("ball", "foresight.Ball", schema=foresight.bytes_field(1, file))
        until(lambda: not writer.write(1, b"") and "refuses" in writer.problem, "a refusal")
        sentence = "/14/2/ball: field x of foresight.Ball: expected type float, got type double"
        self.assertEqual(writer.problem, "the runtime refuses: " + sentence)
        self.assertIn("door: " + sentence, runtime.said())

    def test_the_team_framework_and_the_behaviour_run(self):
        self.start("--record", "--profile", "full")
        python = [sys.executable, os.path.join(CLIENT, "examples", "behaviour.py"), "4"]
        behaviour = self.run_beside(*python, environment={"PYTHONPATH": CLIENT})
        vortex = self.run_beside(os.path.join(PROGRAMS, "example_vortex"), "4")
        pose = self.reader("pose")
        until(lambda: pose.read() is None and not pose.problem, "a runtime")
        framework = self.run_beside(os.path.join(PROGRAMS, "example_team_framework"), "3")
        for topic in ("camera_top", "joints", "pose", "ball", "team", "game", "motion_command", "thoughts", "vortex"):
            reader = self.reader(topic)
            until(reader.read, topic)
        self.assertEqual(json.loads(until(self.reader("vortex").read, "a vortex").bytes.decode()), {"distance": 1.0})
        for child, said in ((framework, r"^\d+ commands; lost: 0 joints, 0 images \n$"),
                            (behaviour, r"^\d+ decisions; lost: 0 \n$"), (vortex, r"^\d+ balls; lost: 0 \n$")):
            output = child.communicate()[0]
            self.assertTrue(re.match(said, output), output)
            self.assertGreater(int(output.split()[0]), 0, output)
            self.assertEqual(child.returncode, 0)

    def test_a_behaviour_lets_foresight_choose(self):
        self.start("--rules", "spl2025", "--team", "14", "--player", "2")
        pose = self.reader("pose")
        until(lambda: pose.read() is None and not pose.problem, "a runtime")
        self.run_beside(os.path.join(PROGRAMS, "example_team_framework"), "12")
        game = self.reader("game")
        until(game.read, "a game")
        python = [sys.executable, os.path.join(CLIENT, "examples", "strategy.py"), "5"]
        by_python = self.run_beside(*python, environment={"PYTHONPATH": CLIENT})
        by_c = self.run_beside(os.path.join(PROGRAMS, "example_strategy"), "5")
        adviser = foresight.Adviser()

        def advice():
            """Asks until an answer has advice: a busy machine may play no futures within the budget."""
            until(lambda: adviser.ask(["passing", "baseline"], horizon=5, budget_ms=20), "that the question is on its way")
            answer = until(adviser.answer, "an answer")
            return answer if answer.choice else None

        advised = until(advice, "an answer with advice")
        self.assertIn(advised.choice, ("passing", "baseline"))
        self.assertTrue(advised.reason)
        forecasts = self.reader("forecast")

        def latest_choice():
            """Returns the choice of the latest forecast with advice; the question may be another process's."""
            advice()  # so that there is always a newer one
            latest = forecasts.newest()
            return foresight.read_forecast(latest)[1].choice if latest else None

        self.assertIn(until(latest_choice, "the latest forecast"), ("baseline", "passing", "kick_now"))
        for child in (by_python, by_c):
            lines = child.communicate()[0].splitlines()
            self.assertTrue(re.match(r"^\d+ answers; plays (baseline|passing|kick_now)$", lines[-1]), lines)
            for line in lines[:-1]:
                self.assertTrue(re.match(r"^(keeps|changes|no advice|cannot tell|foresight is busy)", line), line)

    def test_no_call_waits_for_a_stopped_runtime(self):
        runtime = self.start()
        joints = self.writer("joints", "foresight.Joints")
        camera = self.writer("camera_top", "foresight.Image")
        reader = self.reader("joints")
        until(lambda: joints.write(1, b"") and reader.read(), "a runtime")
        runtime.process.send_signal(signal.SIGSTOP)
        pixels = bytes(2 * 640 * 480)
        before = waits()
        for _ in range(1000):
            joints.write(foresight.now_ns(), bytes(400))
            camera.write(foresight.now_ns(), *foresight.image(foresight.YUYV, 640, 480, pixels))
            reader.read()
        self.assertLess(waits() - before, 100, "a call waits")
        self.assertGreater(camera.lost, 900)
        runtime.process.send_signal(signal.SIGCONT)
        until(lambda: camera.write(foresight.now_ns(), *foresight.image(foresight.YUYV, 640, 480, pixels)),
              "a runtime that goes on")

    def test_clients_connect_again_after_the_runtime_was_killed(self):
        pulse, reader = self.writer("pulse", "test.Pulse", encoding="json"), self.reader("pulse")
        number, rounds = 0, 5

        def beat():
            nonlocal number
            number += 1
            written = pulse.write(foresight.now_ns(), bytes([number % 256]) * (50000 if number % 3 else 300))
            message = reader.read()
            if message:
                self.assertEqual(len(set(message.bytes)), 1, "a torn message")
            return written and message

        for i in range(rounds):
            runtime = self.start()
            until(beat, "the runtime of round %d" % i)
            for _ in range(20 * i):
                beat()
            runtime.end(signal.SIGKILL)
            before = waits()
            for _ in range(200):
                beat()
            self.assertLess(waits() - before, 20, "a call waits for a runtime that is gone")

    def test_a_killed_process_leaves_no_torn_message(self):
        self.start()
        reader = self.reader("pulse")
        for i in range(10):
            child = self.run_beside(sys.executable, "-c", PULSE, CLIENT)
            end = time.monotonic() + 0.05 * i
            first = True
            while first or time.monotonic() < end:
                message = until(reader.read, "a pulse") if first else reader.read()
                first = False
                if message:
                    self.assertEqual(len(set(message.bytes)), 1, "a torn message")
            child.kill()
            child.wait()
            for message in reader:
                self.assertEqual(len(set(message.bytes)), 1, "a torn message")

    def test_a_second_runtime_reports_that_the_door_is_taken(self):
        self.start()
        until(lambda: os.path.exists(os.environ["FORESIGHT_DOOR"]), "the door")
        second = self.start()
        self.assertEqual(second.process.wait(PATIENCE), 2)
        self.assertIn("another runtime does; end it, or choose another --door", second.said())


if __name__ == "__main__":
    unittest.main(verbosity=2)
