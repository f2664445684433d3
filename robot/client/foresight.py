"""The client of a team's own process: it writes objects into the robot's memory and reads objects from it, through the
runtime's door (foresight-robot --body attached). Python 3.6 or newer, standard library only.

    ball = foresight.Writer("ball", "foresight.Ball")
    ball.write(foresight.now_ns(), message)          # for each new value

    for message in foresight.Reader("motion_command"):
        obey(message.bytes)                          # each message so far; the loop ends when there are no more

No call waits for the runtime, except Reader.wait, even while the runtime is stopped or dead. Each writer and each reader
has its own connection. It connects at its first use, and connects again after a restart of the runtime. Large messages,
such as images, go through shared memory. One thread at a time may use a writer or reader. Messages that are written
without a runtime are lost and counted.

All times are of this machine's monotonic clock [ns], like those of V4L2 and time.monotonic(). Messages are protobuf,
defined in proto/foresight/*.proto, unless announced otherwise. Without protobuf, use the functions uint_field … and fields
to fill and read them.

robot/logging/streams/stream_format.h documents the protocol; foresight.h is the same client for C.
"""

import array
import collections
import os
import select
import socket
import struct
import tempfile
import time

__all__ = [
    "Writer", "Reader", "Message", "Adviser", "Advice", "Parameters", "now_ns", "read_forecast", "image", "YUYV", "JPEG",
    "LATEST", "FIFO", "RELIABLE", "uint_field", "float_field", "double_field", "bytes_field", "floats_field", "fields",
    "as_float", "as_double",
]

LATEST, FIFO, RELIABLE = 0, 1, 2  # messages that a viewer needs over a slow network: the newest, a short history, all
YUYV, JPEG = 1, 2  # encodings of foresight.Image

_CHANNEL, _MESSAGE, _WELCOME, _WANTED, _MEMORY, _SHARED, _TAKEN, _REFUSED = range(1, 9)
_VERSION = 1
_MAX_FRAME_BYTES = 8 << 20
_MAX_INLINE_BYTES = 16 << 10  # the kernel takes up to this size whole or not at all
_MIN_PLACE_BYTES = 64 << 10
_PLACES = 16  # half a second of images at 30 Hz may wait; a place costs nothing before its first use
_RETRY_NS = 100 * 1000 * 1000  # between attempts to connect
_REFUSED_RETRY_NS = 1000 * 1000 * 1000  # after the runtime refused us

_FLAGS = socket.MSG_DONTWAIT | socket.MSG_NOSIGNAL

#: One message that was read: number, times [ns, monotonic] and bytes. A gap in the numbers: this reader was too slow for
#: some messages.
Message = collections.namedtuple("Message", "sequence capture_ns publish_ns bytes")


def now_ns():
    """Returns the present time of the monotonic clock [ns]."""
    return int(time.clock_gettime(time.CLOCK_MONOTONIC) * 1e9)


def _frame(kind, *pieces):
    return struct.pack("<BI", kind, sum(map(len, pieces))) + b"".join(pieces)


def _text(text):
    raw = text.encode() if isinstance(text, str) else text
    return struct.pack("<I", len(raw)) + raw


class _Gone(Exception):
    """The connection has ended."""


class _Connection:
    """The common part of writers and readers."""

    def __init__(self, door, hello):
        default = "/dev/shm/foresight-%d.door" % os.geteuid()
        self._door = os.fspath(door or os.environ.get("FORESIGHT_DOOR") or default)
        self._hello = hello
        self._socket = None
        self._retry_at_ns = 0
        self._in = bytearray()
        self._out = b""  # the rest of what the kernel took in part
        self._epoch_offset_ns = int(time.time() * 1e9) - now_ns()

        #: The reason why the last attempt failed, in one sentence, or "" if it did not fail.
        self.problem = ""

    def epoch_ns(self, monotonic_ns):
        """Converts a time to that of the time fields in messages [ns since the epoch, capture time]. The offset is the
        runtime's; before the first connection it is that of the system clock."""
        return monotonic_ns + self._epoch_offset_ns

    def close(self):
        """Closes the connection. Messages that were sent still arrive."""
        self._disconnect(0)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        if getattr(self, "_socket", None):
            self._socket.close()

    def _disconnect(self, retry_after_ns):
        if self._socket:
            self._socket.close()
        self._socket = None
        self._retry_at_ns = now_ns() + retry_after_ns if retry_after_ns else 0
        self._in.clear()
        self._out = b""

    def _lose(self, sentence, retry_after_ns=0):
        self.problem = sentence
        self._disconnect(retry_after_ns)
        raise _Gone

    def _connected(self):
        """Connects if there is no connection and the retry time has passed. Never waits."""
        if self._socket:
            return True
        if now_ns() < self._retry_at_ns:
            return False
        self._retry_at_ns = now_ns() + _RETRY_NS
        made = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM | socket.SOCK_NONBLOCK | socket.SOCK_CLOEXEC)
        try:
            made.connect(self._door)
            owner = struct.unpack("3i", made.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, 12))[1]
            if owner not in (os.geteuid(), 0):
                raise OSError("expected a runtime of this user, it belongs to another user")
            made.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 1 << 20)  # the kernel may give less
        except OSError as error:
            made.close()
            self.problem = "cannot connect to %s: %s" % (self._door, error.strerror or error)
            return False
        self._socket = made
        self.problem = ""
        self._send(self._hello)
        return True

    def _flush(self):
        """Sends the unsent rest. Returns True if nothing is left."""
        while self._out:
            try:
                self._out = self._out[self._socket.send(self._out, _FLAGS):]
            except BlockingIOError:
                self.problem = "cannot write to %s: the runtime does not read" % self._door
                return False
            except OSError as error:
                self._last_words(error)
        return True

    def _send(self, *pieces, file=None):
        """Sends the pieces, with a file descriptor if given. If the kernel takes a part, the rest is sent later."""
        extra = [] if file is None else [(socket.SOL_SOCKET, socket.SCM_RIGHTS, array.array("i", [file]))]
        try:
            sent = self._socket.sendmsg(pieces, extra, _FLAGS)
        except BlockingIOError:
            self.problem = "cannot write to %s: the runtime does not read" % self._door
            return False
        except OSError as error:
            self._last_words(error)
        if sent < sum(map(len, pieces)):
            self._out = b"".join(pieces)[sent:]
        return True

    def _last_words(self, error):
        """Handles a failed write. If the runtime has ended the connection, its last message gives the reason."""
        self.problem = "cannot write to %s: %s" % (self._door, error.strerror)
        self._receive(4096)
        for _ in self._frames():
            pass
        self._lose(self.problem)

    def _receive(self, size):
        """Receives the bytes that have come, and returns their number."""
        try:
            block = self._socket.recv(size, socket.MSG_DONTWAIT)
        except BlockingIOError:
            return 0
        except OSError as error:
            self._lose(self.problem or "cannot read from %s: %s" % (self._door, error.strerror))
        if not block:
            self._lose(self.problem or "cannot read from %s: the runtime has gone" % self._door)
        self._in += block
        return len(block)

    def _frames(self):
        """Yields the kind and body of each complete frame. Handles the frames that readers and writers have in common."""
        while len(self._in) >= 5:
            kind, size = struct.unpack_from("<BI", self._in)
            if not _CHANNEL <= kind <= _REFUSED or size > _MAX_FRAME_BYTES:
                self._lose("cannot read from %s: expected a frame, got something else" % self._door, _REFUSED_RETRY_NS)
            if len(self._in) < 5 + size:
                return
            body = bytes(memoryview(self._in)[5:5 + size])
            del self._in[:5 + size]
            if kind == _REFUSED:
                self._lose("the runtime refuses: " + body.decode(errors="replace"), _REFUSED_RETRY_NS)
            if kind == _WELCOME and size == 12:
                version, self._epoch_offset_ns = struct.unpack("<IQ", body)
                if version != _VERSION:
                    self._lose("expected to speak version 1 at %s, the runtime speaks %d" % (self._door, version),
                               _REFUSED_RETRY_NS)
            yield kind, body


class Writer(_Connection):
    """A writer of one object: "ball" is an object of this robot, "/debug/vortex" a whole topic. The runtime knows the
    schemas of Foresight's messages. The door is at $FORESIGHT_DOOR, or at the default path of this user's runtime."""

    def __init__(self, topic, type="", encoding="protobuf", schema=b"", schema_encoding=None, delivery=LATEST, door=None):
        texts = (topic, encoding, type, encoding if schema_encoding is None else schema_encoding, schema)
        super().__init__(door, _frame(_CHANNEL, *map(_text, texts), bytes([delivery])))
        self._sequence = 0
        self._memory = None
        self._place_bytes = 0
        self._taken = [0] * _PLACES  # by the message of that number

        #: The number of lost messages so far: the runtime was not running or did not keep up.
        self.lost = 0

    def write(self, capture_ns, *pieces):
        """Writes one message of at most 8 MiB that was sensed at `capture_ns`; the pieces are joined. Returns False if it
        is lost; `problem` gives the reason."""
        pieces = [memoryview(piece).cast("B") for piece in pieces]
        size = sum(map(len, pieces))
        self._sequence += 1
        # only a write shows that the runtime has ended; the next one may be running already
        sent = False
        if size > _MAX_FRAME_BYTES:
            self.problem = "cannot write to %s: a message has at most 8 MiB" % self._door
        else:
            sent = self._hand_over(capture_ns, pieces, size)
            if not sent and self._socket is None:
                sent = self._hand_over(capture_ns, pieces, size)
        if sent:
            self.problem = ""
        else:
            self.lost += 1
        return sent

    def _disconnect(self, retry_after_ns):
        super()._disconnect(retry_after_ns)
        self._forget_memory()  # the previous runtime may still read it

    def _forget_memory(self):
        if getattr(self, "_memory", None) is not None:
            os.close(self._memory)
        self._memory = None
        self._place_bytes = 0
        self._taken = [0] * _PLACES

    def __del__(self):
        super().__del__()
        self._forget_memory()

    def _hand_over(self, capture_ns, pieces, size):
        try:
            if not self._connected():
                return False
            self._receive(4096)
            for kind, body in self._frames():
                if kind == _TAKEN and len(body) == 8:
                    taken = struct.unpack("<Q", body)[0]
                    self._taken = [0 if number == taken else number for number in self._taken]
            if not self._flush():
                return False
            if size > _MAX_INLINE_BYTES:
                return self._share(capture_ns, pieces, size)
            head = struct.pack("<BIQQQ", _MESSAGE, 24 + size, self._sequence, capture_ns, now_ns())
            return self._send(head, *pieces)
        except _Gone:
            return False

    def _share(self, capture_ns, pieces, size):
        """Writes a large message into shared memory and sends its place to the runtime."""
        is_new = self._memory is None or size > self._place_bytes
        try:
            if is_new:
                self._forget_memory()
                self._memory, name = tempfile.mkstemp(prefix="foresight-", dir="/dev/shm")
                os.unlink(name)
                self._place_bytes = max(_MIN_PLACE_BYTES, 1 << (size - 1).bit_length())
            if 0 not in self._taken:
                self.problem = "cannot write to %s: the runtime does not free shared memory" % self._door
                return False
            place = self._taken.index(0)
            offset = at = place * self._place_bytes
            for piece in pieces:
                while len(piece) > 0:
                    n = os.pwrite(self._memory, piece, at)
                    piece, at = piece[n:], at + n
        except OSError as error:
            self.problem = "cannot write to shared memory in /dev/shm: %s" % error.strerror
            if is_new:
                self._forget_memory()
            return False
        shared = struct.pack("<BIQQQQQ", _SHARED, 40, self._sequence, capture_ns, now_ns(), offset, size)
        if not self._send((_frame(_MEMORY) if is_new else b"") + shared, file=self._memory if is_new else None):
            if is_new:
                self._forget_memory()
            return False
        self._taken[place] = self._sequence
        return True


class Reader(_Connection):
    """A reader of one object, named as for a Writer; it need not exist yet. Iteration yields the messages so far."""

    def __init__(self, topic, door=None):
        super().__init__(door, _frame(_WANTED, topic.encode()))

        #: The runtime's description: topic, type, encoding, schema encoding, schema, delivery; None before the first message.
        self.object = None

    def read(self):
        """Returns the next message, beginning with the newest one at the time of connecting; None if there is none now."""
        try:
            if not self._connected() or not self._flush():
                return None
            while True:
                for kind, body in self._frames():
                    if kind == _CHANNEL:
                        self._learn(body)
                    elif kind == _MESSAGE and len(body) >= 24:
                        return Message(*struct.unpack_from("<QQQ", body), body[24:])
                if not self._receive(1 << 20):
                    return None
        except _Gone:
            return None

    def __iter__(self):
        return iter(self.read, None)

    def newest(self):
        """Returns the newest message and skips all before it; None if there is none now."""
        newest = None
        for newest in self:
            pass
        return newest

    def wait(self, timeout):
        """Waits until there may be a message to read, at most `timeout` [s]. Returns at once if that is 0 or less."""
        timeout = max(0.0, timeout)
        try:
            there = self._connected()
        except _Gone:
            there = False
        # without a connection it waits for the next attempt only
        select.select([self._socket] if there else [], [], [], timeout if there else min(timeout, _RETRY_NS / 1e9))

    def _learn(self, body):
        try:
            texts, at = [], 0
            for _ in range(5):
                size = struct.unpack_from("<I", body, at)[0]
                texts.append(body[at + 4:at + 4 + size])
                at += 4 + size
            topic, encoding, kind, schema_encoding = (text.decode() for text in texts[:4])
            self.object = dict(topic=topic, encoding=encoding, type=kind, schema_encoding=schema_encoding,
                               schema=texts[4], delivery=body[at])
        except (struct.error, IndexError, UnicodeDecodeError):
            self._lose("cannot read from %s: expected a channel frame, got something else" % self._door, _REFUSED_RETRY_NS)


# The part of protobuf that Foresight's messages need, for programs without protobuf. Fields joined with + are a message:
# float_field(2, 1.5) + bytes_field(3, inner). A value of 0 or False may be left out.


def _varint(value):
    value &= (1 << 64) - 1
    out = bytearray()
    while value >= 0x80:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value)
    return bytes(out)


def uint_field(number, value):
    """Returns a field of type uint32, uint64, int32, int64, bool or enum."""
    return _varint(number << 3) + _varint(int(value))


def float_field(number, value):
    return _varint(number << 3 | 5) + struct.pack("<f", value)


def double_field(number, value):
    return _varint(number << 3 | 1) + struct.pack("<d", value)


def bytes_field(number, value):
    """Returns a field with a text, bytes or a message."""
    raw = value.encode() if isinstance(value, str) else value
    return _varint(number << 3 | 2) + _varint(len(raw)) + raw


def floats_field(number, values):
    """Returns a field with a list of floats, such as those of 25 joints."""
    return bytes_field(number, struct.pack("<%df" % len(values), *values))


def image(encoding, width, height, pixels):
    """Returns a foresight.Image as two pieces for Writer.write; the pixels are not copied."""
    head = uint_field(1, encoding) + uint_field(2, width) + uint_field(3, height)
    return head + _varint(4 << 3 | 2) + _varint(memoryview(pixels).nbytes), pixels


def _take_varint(message, at):
    value = shift = 0
    while True:
        byte = message[at]
        at += 1
        value |= (byte & 0x7F) << shift
        shift += 7
        if byte < 0x80:
            return value & (1 << 64) - 1, at


def fields(message):
    """Yields the fields of a message as pairs of number and value. The value is an int for numbers, bool and enum, 4 or 8
    bytes for float and double, and bytes for all other types. Ends at the first byte that is not protobuf."""
    at = 0
    try:
        while at < len(message):
            tag, at = _take_varint(message, at)
            if tag & 7 == 0:
                value, at = _take_varint(message, at)
            else:
                size = {1: 8, 5: 4}.get(tag & 7)
                if tag & 7 == 2:
                    size, at = _take_varint(message, at)
                if size is None or at + size > len(message):
                    return
                value, at = message[at:at + size], at + size
            yield tag >> 3, value
    except IndexError:
        return


def as_float(value):
    """Returns the value of a float field."""
    return struct.unpack("<f", value)[0]


def as_double(value):
    """Returns the value of a double field."""
    return struct.unpack("<d", value)[0]


class Advice(collections.namedtuple("Advice", "known change choice reason")):
    """The advice of a forecast. `known`: False if there is none, see `reason`. `change`: another strategy than the first
    is better, with the required certainty. `choice`: the strategy to play. `reason`: one sentence."""


def read_forecast(message):
    """Returns the number of the question that a forecast answers, and its Advice. `message` is one of Reader("forecast"),
    which also gives the answers to other processes' questions."""
    forecast = dict(fields(message.bytes))
    kind = forecast.get(3, 0)
    texts = (forecast.get(number, b"").decode(errors="replace") for number in (4, 5))
    return dict(fields(forecast.get(1, b""))).get(1, 0), Advice(kind != 0, kind == 2, *texts)


class Adviser:
    """A connection for questions to foresight: which strategy is best from now on? The runtime needs the objects pose,
    ball and game of the robot, and the names of the strategies (--strategies)."""

    def __init__(self, door=None):
        self._questions = Writer("what_if", "foresight.WhatIf", delivery=RELIABLE, door=door)
        self._forecasts = Reader("forecast", door=door)
        self._asked = None

    def ask(self, strategies, horizon=30.0, budget_ms=500):
        """Asks; the first strategy is the one that is played now. Foresight looks `horizon` [s] ahead. Returns True if
        the question was sent."""
        self._asked = now_ns()
        names = b"".join(bytes_field(2, name) for name in strategies)
        question = uint_field(1, self._asked) + names + float_field(6, horizon) + uint_field(7, budget_ms)
        return self._questions.write(self._asked, question)

    def answer(self):
        """Returns the Advice for the last question, or None while there is none. Never waits."""
        for message in self._forecasts:
            asked, advice = read_forecast(message)
            if self._asked and asked == self._asked:
                return advice
        return None

    def what_if(self, strategies, horizon=30.0, budget_ms=500):
        """Asks and waits for the Advice, at most 100 ms longer than the budget. Returns None if none came."""
        self.answer()  # discards earlier answers, and connects
        late_ns = now_ns() + (budget_ms + 100) * 1000000
        if not self.ask(strategies, horizon, budget_ms):
            return None
        while True:
            # the clock is read once: between two reads this thread may wait long for the processor
            left_ns = late_ns - now_ns()
            advice = self.answer()
            if advice or left_ns <= 0:
                return advice
            self._forecasts.wait(left_ns / 1e9)


_Parameter = collections.namedtuple("_Parameter", "type initial fields")
_NUMBER, _WHOLE, _YES_NO, _TEXT, _CHOICE, _BUTTON = range(1, 7)  # foresight.LiveParameter.Type


class Parameters:
    """Live parameters: people change them in the viewer while this process runs.

        walk = foresight.Parameters("walk")
        walk.number("step_height", 0.02, range=(0, 0.05), unit="m", text="Height of a foot over the ground.")

        walk.poll()                    # in every cycle
        lift(walk["step_height"])

    A poll never waits. The runtime checks type, range and choices, so walk[name] is always an allowed value. A value that
    was set is kept while this process or the runtime lives. The runtime hands it to a process that starts again, and this
    process hands it to a runtime that starts again. If both end, the values of your own file count again.

    foresight_parameters.h gives the limits. A parameter beyond a limit is refused, the others are taken; `problem` gives
    the reason."""

    _LOST_NS = 100 * 1000 * 1000  # until the next attempt after a failed announcement
    _UNHEARD_NS = 1000 * 1000 * 1000  # and after one that the runtime has not answered

    def __init__(self, process, door=None):
        self._process = process
        self._announcement = Writer("live_parameters/" + process, "foresight.LiveParameters", door=door)
        self._heard = Reader("live_parameters", door=door)
        self._all = {}
        self._values = {}
        self._presses = {}  # of each button, as the runtime counts them; it may know those of a former process
        self._announced = self._known = False
        self._announce_at_ns = 0
        self._refusal = ""

    def number(self, name, value, range=None, unit="", text=""):
        """Adds a number; `value` comes from your file. A range includes both ends."""
        self._add(_NUMBER, name, float(value), range, unit, text)

    def whole(self, name, value, range=None, unit="", text=""):
        """Adds a whole number."""
        self._add(_WHOLE, name, int(value), range, unit, text)

    def yes_no(self, name, value, text=""):
        """Adds a parameter that is True or False."""
        self._add(_YES_NO, name, bool(value), None, "", text)

    def text(self, name, value, text=""):
        """Adds a text of at most 200 bytes."""
        self._add(_TEXT, name, value, None, "", text)

    def choice(self, name, value, choices, text=""):
        """Adds a text that is one of `choices`."""
        self._add(_CHOICE, name, value, None, "", text, choices)

    def button(self, name, text=""):
        """Adds a button. Its value is how often it was pressed since it was added, and poll() names it after each press."""
        self._add(_BUTTON, name, 0, None, "", text)

    def __getitem__(self, name):
        return self._values[name]

    def __iter__(self):
        return iter(self._values)

    def poll(self):
        """Takes the values that people set, and announces the parameters where needed. Never waits. Returns the names of
        the parameters that changed."""
        message = self._heard.newest()
        changed = self._hear(message.bytes) if message else []
        now = now_ns()
        # the runtime may still know a former process of this name, so the first announcement does not depend on it
        if self._all and not (self._known and self._announced) and now >= self._announce_at_ns:
            self._announced = self._announcement.write(now, b"".join(map(self._encoded, self._all)))
            self._announce_at_ns = now + (self._UNHEARD_NS if self._announced else self._LOST_NS)
        return changed

    @property
    def problem(self):
        """The reason why the runtime refused a parameter or cannot be reached, in one sentence; "" if all is well."""
        return self._refusal or self._announcement.problem or self._heard.problem

    def close(self):
        """Closes the connections. Viewers then show the parameters as gone."""
        self._announcement.close()
        self._heard.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _add(self, type, name, value, range, unit, text, choices=()):
        low, high = range or (0, 0)
        whole = bytes_field(1, name) + uint_field(2, type) + self._value(5, 6, value)
        whole += double_field(7, low) + double_field(8, high) + bytes_field(9, unit) + bytes_field(10, text)
        whole += b"".join(bytes_field(11, choice) for choice in choices)
        self._all[name] = _Parameter(type, value, whole)
        self._values[name] = value
        self._announced = False
        self._announce_at_ns = 0

    @staticmethod
    def _value(number, text, value):
        return bytes_field(text, value) if isinstance(value, str) else double_field(number, value)

    def _encoded(self, name):
        value = self._presses.get(name, 0) if self._all[name].type == _BUTTON else self._values[name]
        return bytes_field(1, self._all[name].fields + self._value(3, 4, value))

    def _hear(self, message):
        """Takes the runtime's message, and returns the names of the parameters that changed."""
        was_known, self._known, self._refusal = self._known, False, ""
        changed = []
        for number, value in fields(message):
            if number == 1 and isinstance(value, bytes):
                changed += self._take(collections.ChainMap(dict(fields(value)), _ABSENT))
            elif number == 2 and isinstance(value, bytes):
                process, _, sentence = value.decode(errors="replace").partition(":")
                if process == self._process:
                    self._known, self._refusal = True, "the runtime refuses:" + sentence
        if was_known and not self._known:
            self._announce_at_ns = 0
        return changed

    def _take(self, heard):
        """Takes one parameter of the runtime's message, and returns its name if it changed."""
        process, _, name = heard[1].decode(errors="replace").partition(".")
        if process != self._process or heard[12]:
            return []
        self._known = True
        ours = self._all.get(name)
        if not ours:
            return []
        read = _READ.get(ours.type, bytes.decode)
        is_text = ours.type in (_TEXT, _CHOICE)
        # another initial value: this is the answer to a former process's announcement
        if heard[2] != ours.type or read(heard[6 if is_text else 5]) != ours.initial:
            return []
        value = read(heard[4 if is_text else 3])
        if ours.type == _BUTTON:
            before, self._presses[name] = self._presses.get(name, value), value
            value = self._values[name] + max(value - before, 0)
        if value == self._values[name]:
            return []
        self._values[name] = value
        return [name]


_READ = {
    _NUMBER: as_double,
    _WHOLE: lambda raw: int(as_double(raw)),
    _YES_NO: lambda raw: as_double(raw) == 1,
    _BUTTON: lambda raw: int(as_double(raw)),
}
_ABSENT = {1: b"", 2: 0, 3: bytes(8), 4: b"", 5: bytes(8), 6: b"", 12: 0}  # values of absent fields
