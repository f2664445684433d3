"""The door with real processes: the runtime, the Python module, the C examples, and kill -9 on both sides.

    python3 door_test.py FOLDER_OF_PROGRAMS
"""

import itertools
import json
import math
import os
import re
import resource
import signal
import socket
import struct
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


class Page:
    """A page on this machine that sets parameters: the part of WebSocket and of the Foxglove protocol that this needs."""

    def __init__(self, runtime):
        port = until(lambda: re.search(r"http://localhost:(\d+)/", runtime.said()), "the address").group(1)
        self.socket = socket.create_connection(("127.0.0.1", int(port)), PATIENCE)
        self.socket.sendall(("GET / HTTP/1.1\r\nHost: localhost:%s\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                             "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
                             "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n" % port).encode())
        self.bytes = b""
        head = b""
        while not head.endswith(b"\r\n\r\n"):
            head += self.take(1)
        assert b" 101 " in head, head

    def take(self, size):
        while len(self.bytes) < size:
            block = self.socket.recv(1 << 16)
            assert block, "the runtime has closed the connection"
            self.bytes += block
        taken, self.bytes = self.bytes[:size], self.bytes[size:]
        return taken

    def say(self, message):
        text = json.dumps(message).encode().ljust(126)  # a shorter text has another form
        assert len(text) < 1 << 16
        self.socket.sendall(struct.pack(">BBH4x", 0x81, 0xFE, len(text)) + text)  # the mask is 0

    def hear(self):
        """Returns the next text of the runtime."""
        while True:
            kind, size = self.take(2)
            size = {126: lambda: struct.unpack(">H", self.take(2))[0],
                    127: lambda: struct.unpack(">Q", self.take(8))[0]}.get(size, lambda: size)()
            body = self.take(size)
            if kind == 0x81:
                return json.loads(body.decode())

    def set(self, **values):
        """Sets parameters, and returns the values afterwards and the complaints."""
        names = {name.replace("__", "."): value for name, value in values.items()}
        self.say({"op": "setParameters", "id": "set",
                  "parameters": [{"name": name, "value": value} for name, value in names.items()]})
        complaints = []
        while True:
            heard = self.hear()
            if heard["op"] == "status":
                complaints.append(heard["message"])
            if heard["op"] == "parameterValues" and heard.get("id") == "set":
                return {one["name"]: one.get("value") for one in heard["parameters"]}, complaints

    def close(self):
        self.socket.close()


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

    def page(self, runtime):
        page = Page(runtime)
        self.addCleanup(page.close)
        return page

    def parameters(self):
        """Returns the parameters of a process "walk" with the values of its file."""
        walk = foresight.Parameters("walk")
        self.addCleanup(walk.close)
        walk.number("height", 0.02, range=(0, 0.05), unit="m", text="Height of a foot over the ground.")
        walk.whole("steps", 3, range=(1, 10))
        walk.yes_no("arms", True)
        walk.text("name", "Läufer")
        walk.choice("gait", "slow", ["slow", "fast"])
        return walk

    def told(self, walk=None):
        """Returns the parameters that the runtime shows, as {name: (value, gone)}; `walk` is polled meanwhile."""
        if not hasattr(self, "heard"):
            self.heard, self.last = self.reader("live_parameters"), {}
        if walk:
            walk.poll()
        message = self.heard.newest()
        if message:
            self.last = {}
            for number, one in foresight.fields(message.bytes):
                if number == 1:
                    fields = dict(foresight.fields(one))
                    value = fields[4].decode() if 4 in fields else foresight.as_double(fields.get(3, bytes(8)))
                    self.last[fields[1].decode()] = (value, fields.get(12, 0) == 1)
        return self.last

    def test_people_set_live_parameters(self):
        runtime = self.start()
        walk = self.parameters()
        self.assertEqual(walk["height"], 0.02)
        until(lambda: len(self.told(walk)) == 5, "the announcement")
        self.assertEqual(walk.problem, "")
        self.assertEqual(self.told()["walk.name"], ("Läufer", False))
        page = self.page(runtime)
        values, complaints = page.set(walk__height=0.03, walk__steps=4, walk__arms=False, walk__name="a \"b\" ü",
                                      walk__gait="fast")
        self.assertEqual(complaints, [])
        self.assertEqual(values["walk.height"], 0.03)
        changed = until(walk.poll, "the values")
        self.assertTrue(set(changed) <= {"height", "steps", "arms", "name", "gait"})
        until(lambda: walk.poll() or walk["gait"] == "fast", "the last value")
        self.assertEqual({name: walk[name] for name in walk},
                         {"height": 0.03, "steps": 4, "arms": False, "name": "a \"b\" ü", "gait": "fast"})
        values, complaints = page.set(walk__height=0.06, walk__steps=1.5, walk__arms="yes", walk__gait="faster",
                                      walk__speed=1, other__name=1)
        self.assertEqual(complaints, ["parameter 'walk.height': expected 0 .. 0.05, got 0.06",
                                      "parameter 'walk.steps': expected a whole number, got a number",
                                      "parameter 'walk.arms': expected true or false, got a text",
                                      "parameter 'walk.gait': expected one of slow, fast, got 'faster'",
                                      "parameter 'walk.speed': there is no parameter of this name",
                                      "parameter 'other.name': there is no parameter of this name"])
        self.assertEqual(values["walk.height"], 0.03)

    def test_values_that_were_set_outlive_the_process_and_the_runtime(self):
        runtime = self.start()
        walk = self.parameters()
        until(lambda: len(self.told(walk)) == 5, "the announcement")
        self.page(runtime).set(walk__height=0.03)
        until(lambda: walk.poll(), "the value")

        walk.close()  # the process dies
        until(lambda: self.told()["walk.height"] == (0.03, True), "that it has gone")
        complaints = self.page(runtime).set(walk__steps=4)[1]
        self.assertEqual(complaints, ["parameter 'walk.steps': expected a process that runs, but 'walk' has disconnected"])
        walk = self.parameters()  # and starts again with the values of its file
        until(lambda: self.told(walk)["walk.height"] == (0.03, False), "that it is back")
        until(lambda: walk.poll() or walk["height"] == 0.03, "the value that was set")
        self.assertEqual(walk["steps"], 3)

        runtime.end(signal.SIGKILL)
        for _ in range(50):
            walk.poll()
        self.assertEqual(walk["height"], 0.03)
        until(lambda: self.told() and self.heard.problem, "the end of the old runtime")
        self.last = {}
        runtime = self.start()
        until(lambda: self.told(walk).get("walk.height") == (0.03, False) and not walk.problem, "the new runtime")
        self.assertEqual(self.page(runtime).set(walk__height=0.02)[1], [])
        until(lambda: walk.poll() or walk["height"] == 0.02, "the value of the file again")

    def test_a_button_counts_the_presses_of_its_process(self):
        runtime = self.start()
        for presses in range(2):  # the second process follows a first whose button was pressed
            with foresight.Parameters("lab") as lab:
                lab.button("push", "Pushes the robot.")
                until(lambda: not lab.poll() and self.told(lab).get("lab.push") == (2.0 * presses, False), "the button")
                page = self.page(runtime)
                for more in (1, 2):
                    self.assertEqual(page.set(lab__push=2 * presses + more)[1], [])
                    self.assertEqual(until(lab.poll, "the press"), ["push"])
                    self.assertEqual(lab["push"], more)
                self.assertEqual(page.set(lab__push=-1)[1], ["parameter 'lab.push': expected at least 0, got -1"])
            until(lambda: self.told()["lab.push"] == (2.0 * presses + 2, True), "that it has gone")

    def test_a_killed_process_gets_its_values_again(self):
        runtime = self.start()
        program = ("import sys, time; sys.path.insert(0, sys.argv[1]); import foresight\n"
                   "p = foresight.Parameters('p'); p.whole('n', 1)\n"
                   "while True: p.poll(); print(p['n'], flush=True); time.sleep(0.01)")
        child = self.run_beside(sys.executable, "-c", program, CLIENT)
        until(lambda: self.told().get("p.n") == (1, False), "the announcement")
        self.page(runtime).set(p__n=2)
        until(lambda: child.stdout.readline() == "2\n", "the value")
        child.kill()
        child.wait()
        until(lambda: self.told()["p.n"] == (2, True), "that it has gone")
        child = self.run_beside(sys.executable, "-c", program, CLIENT)
        until(lambda: child.stdout.readline() == "2\n", "the value again")

    def test_a_refused_parameter_is_named_and_the_others_are_taken(self):
        self.start()
        walk = self.parameters()
        walk.number("too high", 1)
        until(lambda: walk.poll() or len(self.told()) == 5, "the announcement")
        until(lambda: walk.poll() or walk.problem, "the problem")
        self.assertEqual(walk.problem, "the runtime refuses: parameter 'too high': expected a name of 1 to 48 letters, "
                                       "digits, '_', '-' and '.'")

    def test_a_poll_does_not_wait_for_a_stopped_runtime(self):
        runtime = self.start()
        walk = self.parameters()
        until(lambda: len(self.told(walk)) == 5, "the announcement")
        runtime.process.send_signal(signal.SIGSTOP)
        before = waits()
        for i in range(1000):
            walk.number("n%d" % (i % 3), i)  # announces anew
            walk.poll()
        self.assertLess(waits() - before, 100, "a poll waits")
        runtime.process.send_signal(signal.SIGCONT)

    def test_the_framework_in_c_obeys_its_live_parameters(self):
        runtime = self.start()
        self.run_beside(os.path.join(PROGRAMS, "example_team_framework"), "60")
        until(lambda: self.told().get("path.radius") == (1, False), "the announcement")
        self.assertEqual(self.page(runtime).set(path__radius=2.5)[1], [])
        pose = self.reader("pose")

        def radius():
            """Returns the distance of the newest pose from the centre."""
            message = pose.newest()
            return message and math.hypot(*(foresight.as_float(dict(foresight.fields(message.bytes))[n]) for n in (1, 2)))

        until(lambda: abs((radius() or 0) - 2.5) < 1e-3, "the new circle")

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

    def test_a_process_that_is_no_robot_reports_the_truth(self):
        self.start()
        by_c = [os.path.join(PROGRAMS, "example_truth")]
        by_python = [sys.executable, os.path.join(CLIENT, "examples", "truth.py")]
        for program in (by_c, by_python):
            reader = self.reader("/truth/world")
            until(lambda: reader.read() is None and not reader.problem, "a runtime")
            before = foresight.now_ns()
            child = self.run_beside(*program, "1", environment={"PYTHONPATH": CLIENT})
            output = child.communicate()[0]
            self.assertTrue(re.match(r"^\d+ messages; lost: 0 \n$", output), output)
            worlds = [message for message in reader if message.capture_ns >= before]
            self.assertGreater(len(worlds), 5)
            self.assertEqual(reader.object["topic"], "/truth/world")
            self.assertEqual(reader.object["type"], "foresight.GroundTruth")
            for message in worlds:
                ball, *robots = [dict(foresight.fields(one)) for _, one in foresight.fields(message.bytes)]
                self.assertAlmostEqual(math.hypot(foresight.as_float(ball[1]), foresight.as_float(ball[2])), 1, 5)
                self.assertEqual([(robot[1], robot[2]) + tuple(foresight.as_float(robot[n]) for n in (3, 4, 5))
                                  for robot in robots], [(14, 2, -2, 0.5, 0), (5, 3, 2, -0.5, 3)])

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
