"""A helper for behaviours in Python: avoidance, roles, places in space and kick gates. soccer.h is the same in C.

Copy it beside your behaviour and change what you like. charge.py shows its use. The moments are those of
sim/guest/wire.h. Points are complex numbers: x + 1j * y, in metres. The robot's frame has +x forward and +y left; the
team's frame has +x towards the opponents' goal. Seconds, radians; ticks are 1/30 s. Python 3.6 or newer.

Each function that moves the robot writes the answer.
"""
import cmath
import math

# beliefs
OWN_EYES = 2 * 30  # [ticks] the own sight of the ball beats reports for this time
BALL_MEMORY = 12 * 30  # [ticks] a ball that nobody saw for longer is unknown
MATE_MEMORY = 12 * 30  # [ticks] a teammate silent for longer has no role
OPPONENT_MEMORY = 3 * 30  # [ticks]
DECELERATION = 0.3  # [m/s²] of a rolling ball
# walking
AVOID_RADIUS = 0.45  # [m] from a robot in the way
LOOK_AHEAD = 1.5  # [m] robots farther away are not in the way yet
THERE = 0.12  # [m] near enough to a place
FARTHEST = 20  # [m]
FACES = 0.35  # [rad] near enough to a heading
KEEP_CLEAR = 0.9  # [m] from the ball of the opponents' kick
# roles
LEAD = 1  # [s] that another robot needs to take over the ball
ORDER_KEEP = 0.6  # [m] farther back that another robot needs to become the defender
DEFENDERS = 0.34  # share of defenders among those without ball and goal
# kicks
GATE_SHARE = 0.7  # of the tolerance that the approach uses; noise needs the rest
STILL_BALL = 0.35  # [m/s] a faster ball is not kicked
FRESH_BALL = 21  # [ticks] a ball seen longer ago is not kicked


class Memory:
    """The memory of the helper, one per player."""

    def __init__(self):
        self.role = "supporter"
        self.left_foot = True  # kicks with the left foot
        self.searching = None  # [tick] begin of the search for the ball


class Sight:
    """The sight of a robot at one decision: the ball, teammates and opponents that count."""

    def __init__(self, facts, moment):
        self.facts, self.moment = facts, moment
        self.number, self.now, self.heading = moment["player"], moment["now"], moment["heading"]
        self.length, self.width = facts["field"]["length"], facts["field"]["width"]
        self.goal_width, self.walk = facts["field"]["goal_width"], facts["walk"]
        self.place = complex(moment["x"], moment["y"])
        self.goal, self.own_goal = complex(self.length / 2, 0), complex(-self.length / 2, 0)
        self.theirs = moment["set_play"] != "none" and not moment["own_kick"]
        self.mates = [m for m in moment["mates"] if m["active"] and self.now - m["sent"] < MATE_MEMORY]
        self.opponents = [
            complex(o["x"], o["y"]) for o in moment["opponents"] if self.now - o["seen"] < OPPONENT_MEMORY
        ]
        self.find_ball(moment["ball"])

    def find_ball(self, own):
        """The ball is that of the own eyes while fresh, then the newest report."""
        self.seen_itself, self.speed = own["seen"], complex(own["vx"], own["vy"])
        seen = own["seen"]
        self.ball = complex(own["x"], own["y"])
        self.ball_in_team = self.to_team(self.ball)
        if seen is None or self.now - seen >= OWN_EYES:
            for mate in self.mates:
                if mate["ball_age"] is None or mate["sent"] < mate["ball_age"]:
                    continue
                reported = mate["sent"] - mate["ball_age"]
                if seen is not None and reported <= seen:
                    continue
                seen = reported
                self.ball_in_team = complex(mate["ball_x"], mate["ball_y"])
                self.ball = self.to_robot(self.ball_in_team)
        self.ball_age = 0xFFFFFFFF if seen is None else self.now - seen  # [ticks]
        self.ball_known = self.ball_age < BALL_MEMORY
        self.ball_distance = abs(self.ball)

    def to_robot(self, in_team):
        return (in_team - self.place) * cmath.rect(1, -self.heading)

    def to_team(self, in_robot):
        return self.place + in_robot * cmath.rect(1, self.heading)

    def opponent_distance(self, place):
        """Returns the distance [m] from a place to the nearest opponent seen recently; 100 m if none was."""
        return min([100] + [abs(opponent - place) for opponent in self.opponents])


# ---- geometry


def angle_of(a):
    return cmath.phase(a)


def dot(a, b):
    return a.real * b.real + a.imag * b.imag


def cross(a, b):
    return a.real * b.imag - a.imag * b.real


def within(value, least, most):
    return min(max(value, least), most)


def unit(a):
    return a / abs(a) if abs(a) > 1e-6 else 1 + 0j


def wrapped(angle):
    return angle - 2 * math.pi if angle > math.pi else angle + 2 * math.pi if angle < -math.pi else angle


# ---- avoidance


def round_circle(centre, radius, target):
    """Returns the next point [robot] of a way to `target` that stays `radius` from `centre`."""
    along, off, far = dot(centre, target), cross(target, centre), abs(centre)
    if along <= 0 or along >= abs(target) ** 2 or abs(off) >= radius * abs(target):
        return target
    # along the tangent on the nearer side; from inside the circle also outwards
    side = -1 if off > 0 else 1
    sine = radius / far if radius < far else 1
    cosine = math.sqrt(1 - sine * sine)
    step = max(far * cosine, 0.25) * unit(centre) * complex(cosine, side * sine)
    return step - (radius - far) * unit(centre) if radius > far else step


def round_robots(sight, target):
    """Returns the next point [robot] of a way to `target` round the nearest robot in the way."""
    nearest, way = min(abs(target) + AVOID_RADIUS, LOOK_AHEAD), target
    for place in sight.opponents + [complex(mate["x"], mate["y"]) for mate in sight.mates]:
        other = sight.to_robot(place)
        step = round_circle(other, AVOID_RADIUS, target)
        if abs(other) < nearest and step != target:
            nearest, way = abs(other), step
    return way


def walk(place, heading, answer):
    """Walks to a place [robot] with that heading on arrival, FARTHEST at a time: a false ball may lie anywhere."""
    if abs(place) > FARTHEST:
        place = FARTHEST * unit(place)
    answer.update(body="walk_to", x=place.real, y=place.imag, turn=wrapped(heading))


def hold(sight, place, answer):
    """Goes to a place [team], round robots, and faces the ball there."""
    x = within(place.real, sight.own_goal.real, sight.goal.real - 0.2)
    target = sight.to_robot(complex(x, within(place.imag, -sight.width / 2, sight.width / 2)))
    bearing = angle_of(sight.ball)
    answer["body"] = "stand"
    if abs(target) > THERE:
        walk(round_robots(sight, target), bearing, answer)
    elif abs(bearing) > FACES:
        walk(0j, bearing, answer)


def watch_ball(sight, answer):
    """Keeps the head on the ball. Without it the head looks for marks now and then."""
    answer.update(head="look_to", look=[sight.ball.real, sight.ball.imag, 0.05])


def keep_clear(sight, answer):
    """Keeps away from the ball of the opponents' kick and, but for the goalkeeper, from the own goal area."""
    ball, walks = sight.ball_in_team, answer.get("body") == "walk_to"
    wanted = sight.to_team(complex(answer["x"], answer["y"])) if walks else sight.place
    place = wanted
    if sight.theirs and sight.ball_distance < KEEP_CLEAR - 0.05:
        place = ball + KEEP_CLEAR * unit(sight.place - ball)
    elif sight.theirs and abs(wanted - ball) < KEEP_CLEAR:
        place = ball + KEEP_CLEAR * unit(wanted - ball)
    if sight.theirs and sight.moment["set_play"] == "kick_off":
        place = complex(min(place.real, -0.2), place.imag)
    edge = sight.own_goal.real + 0.8  # 0.6 m of the area, and room
    if sight.number != 1 and place.real < edge and abs(place.imag) < 1.3:
        place = complex(edge, place.imag)
    if place == wanted:
        return
    target = sight.to_robot(place)
    if sight.theirs:
        target = round_circle(sight.ball, KEEP_CLEAR - 0.05, target)
    walk(target, answer["turn"] if walks else 0, answer)


# ---- roles


def time_to_ball(sight):
    """Returns the time [s] until the robot stands behind the ball: the way, the turn, and the walk round the ball."""
    if not sight.ball_known:
        return 1e6
    to_ball = unit(sight.ball)
    wrong_side = 1 - dot(to_ball * cmath.rect(1, sight.heading), unit(sight.goal - sight.ball_in_team))
    turning = 0.5 * math.pi / sight.walk["turn"] * (1 - to_ball.real)
    return sight.ball_distance / sight.walk["forward"] + turning + 0.4 / sight.walk["sideward"] * wrong_side


def mates_time(sight, mate):
    """Returns the time to the ball [s] of a teammate. A chaser has come nearer since its message."""
    since = (sight.now - mate["sent"]) / 30
    nearer = mate["role"] == "chaser" and mate["time_to_ball"] > since
    return mate["time_to_ball"] - since if nearer else mate["time_to_ball"]


def settle_role(sight, memory, answer):
    """Settles the own role and sends it to the teammates.

    Player 1 keeps the goal. The quickest of the others chases the ball; the one that chases it already keeps it unless
    another is quicker by LEAD. Those farthest back defend, the rest supports.
    """
    answer["time_to_ball"] = time_to_ball(sight)
    players = [(sight.number, memory.role, answer["time_to_ball"], sight.place.real)]
    players += [(m["player"], m["role"], mates_time(sight, m), m["x"]) for m in sight.mates]
    players = [player for player in players if player[0] != 1]
    by_time = sorted((time - (LEAD if role == "chaser" else 0), number) for number, role, time, x in players)
    by_x = sorted((x - (ORDER_KEEP if role == "defender" else 0), number) for number, role, time, x in players)
    chaser = by_time[0][1] if by_time else None
    others = [number for x, number in by_x if number != chaser]
    defenders = others[: int(DEFENDERS * len(others) + 0.5)]
    if sight.number == 1:
        memory.role = "keeper"
    elif sight.number == chaser:
        memory.role = "chaser"
    else:
        memory.role = "defender" if sight.number in defenders else "supporter"
    answer["role"] = memory.role
    return memory.role


# ---- places


def place_in_space(sight):
    """Returns the place [team] of a supporter: level with the ball or behind it, where nobody is.

    It prefers a near place, so that it does not walk to and fro.
    """
    x = within(sight.ball_in_team.real - 0.3, sight.own_goal.real + 1.5, sight.goal.real - 1)
    others = [sight.ball_in_team] + sight.opponents + [complex(mate["x"], mate["y"]) for mate in sight.mates]

    def worth(place):
        return min(2, min(abs(other - place) for other in others)) - 0.4 * abs(place - sight.place)

    return max((complex(x, 0.32 * i * sight.width) for i in range(-2, 3)), key=worth)


def place_between(sight):
    """Returns the place [team] of a defender: on the way from the ball to the own goal."""
    way = sight.ball_in_team - sight.own_goal
    far = abs(way)
    return sight.own_goal + min(0.4 * far, max(far - 1, 0.5 * far)) * unit(way)


# ---- the ball


def opening(sight):
    """Returns the middle of the widest gap in the opponents' goal and about half its width [m]."""
    parts = 20
    inner = sight.goal_width / 2 - 0.1
    ball, goal = sight.ball_in_team, sight.goal.real
    before = [o for o in sight.opponents if ball.real + 0.05 <= o.real <= goal + 0.1]
    first = longest = run = 0
    for i in range(parts + 1):
        y = inner * (2 * i / parts - 1)

        def hides(other, y=y):
            share = (other.real - ball.real) / (goal - ball.real)
            return abs(ball.imag + share * (y - ball.imag) - other.imag) < 0.25

        run = 0 if any(hides(other) for other in before) else run + 1
        if run > longest:
            longest, first = run, i - run + 1
    half = 0 if longest < 2 else 0.7 * inner * (longest - 1) / parts
    middle = 0 if longest == 0 else inner * ((2 * first + longest - 1) / parts - 1)
    return complex(goal, middle), half


def way_of_ball(sight, straight, tolerance):
    """Returns the direction [rad, robot] for the ball.

    It is within the tolerance of the target, and as near as possible to the direction from which the robot comes.
    """
    coming = angle_of(sight.ball) if sight.ball_distance > 0.35 else 0
    use = GATE_SHARE * tolerance
    return wrapped(straight + within(wrapped(coming - straight), -use, use))


def go_behind(sight, way, ahead, beside, answer):
    """Walks to where the ball lies `ahead` and `beside` [m] of a robot that faces `way`, round the ball."""
    target = sight.ball - complex(ahead, beside) * cmath.rect(1, way)
    step = round_circle(sight.ball, min(ahead + 0.07, 0.3), target)
    # near the ball the robot fights for it
    walk(round_robots(sight, step) if sight.ball_distance > 0.6 else step, way, answer)
    if sight.ball_distance < 0.7:
        watch_ball(sight, answer)


def choose_kick(sight, distance):
    """Returns the quickest kick to the front that carries `distance` [m], or the longest."""
    ahead = [kick for kick in sight.facts["kicks"] if abs(kick["direction"]) <= 0.2]
    reach = [kick for kick in ahead if kick["range"] >= distance]
    if reach:
        return min(reach, key=lambda kick: kick["delay"])
    return max(ahead, key=lambda kick: kick["range"]) if ahead else sight.facts["kicks"][0]


def in_gate(kick, ball, left):
    """Returns whether the ball lies in the gate of the kick: its place before the foot, give or take."""
    foot = kick["ball_y"] if left else -kick["ball_y"]
    return abs(ball.real - kick["ball_x"]) < kick["gate_x"] and abs(ball.imag - foot) < kick["gate_y"]


def kick_to(sight, memory, target, slack, tolerance, distance, answer):
    """Kicks the ball to `target` [team], `slack` [m] to each side allowed, but at least `tolerance` [rad].

    Goes to the place behind the ball until the ball lies in the gate of the kick.
    """
    to_target = target - sight.ball_in_team
    far = max(abs(to_target), 0.1)
    allowed = max(tolerance, min(slack * abs(to_target.real) / (far * far), 1.2))
    straight = wrapped(angle_of(to_target) - sight.heading)
    way = way_of_ball(sight, straight, allowed)
    side = cross(cmath.rect(1, way), sight.ball)
    if abs(side) > 0.03:
        memory.left_foot = side > 0

    kick = choose_kick(sight, distance)
    fresh = sight.seen_itself is not None and sight.now - sight.seen_itself < FRESH_BALL
    good = in_gate(kick, sight.ball, memory.left_foot) and abs(straight) <= allowed
    go_behind(sight, way, kick["ball_x"], kick["ball_y"] if memory.left_foot else -kick["ball_y"], answer)
    if good and fresh and abs(sight.speed) < STILL_BALL:
        answer.update(body="kick", kick=kick["name"], kick_left=memory.left_foot)


def dribble_to(sight, target, tolerance, answer):
    """Pushes the ball along while walking."""
    straight = wrapped(angle_of(target - sight.ball_in_team) - sight.heading)
    way = way_of_ball(sight, straight, tolerance)
    ahead = cmath.rect(1, way)
    go_behind(sight, way, 0.2, 0, answer)
    if dot(ahead, sight.ball) > 0 and abs(cross(ahead, sight.ball)) < 0.08 and sight.ball_distance <= 0.45:
        walk(sight.ball + 0.4 * ahead, way, answer)


def guard_goal(sight, answer):
    """Guards the goal: on an arc between ball and goal; sideways or in a squat to a ball that rolls in."""
    speed, ball = sight.speed, sight.ball_in_team  # [robot], [team]
    rolls = speed * cmath.rect(1, sight.heading)  # [team]
    if sight.ball_distance < 3:
        watch_ball(sight, answer)

    # does it roll into the goal?
    to_line = ball.real - sight.own_goal.real
    crosses = ball.imag - rolls.imag / rolls.real * to_line if rolls.real < -0.05 else 100
    way = to_line * abs(rolls) / -rolls.real if rolls.real < -0.05 else 100
    fast = abs(rolls) ** 2 > 2 * DECELERATION * 0.3 * way and sight.ball_age < FRESH_BALL
    enters = abs(crosses) < sight.goal_width / 2 + 0.4 and fast
    if enters and speed.real < -0.05 and sight.ball.real > 0:
        # the line of the ball passes the robot at `left`, after `time`
        left, time = sight.ball.imag - speed.imag / speed.real * sight.ball.real, sight.ball.real / -speed.real
        if time < 0.8 and abs(left) < 0.32:
            answer["body"] = "squat"
            return
        if abs(left) < 1.5:
            sideward = sight.walk["sideward"]
            body = "walk_speed" if abs(left) > 0.05 else "stand"
            answer.update(body=body, x=0, y=sideward if left > 0 else -sideward, turn=0)
            return
    to_ball = unit(ball - sight.own_goal)
    widest = sight.goal_width / 2 - 0.15
    y = within(0.7 * to_ball.imag, -widest, widest)
    hold(sight, complex(sight.own_goal.real + within(0.7 * to_ball.real, 0.2, 0.7), y), answer)


def search_ball(sight, memory, stays, answer):
    """Searches the ball: looks round with the head, then turns, then walks towards the middle, and so on.

    With `stays` it uses the head only, as a goalkeeper does.
    """
    if memory.searching is None or memory.searching > sight.now:
        memory.searching = sight.now
    time = (sight.now - memory.searching) % 456
    swing = time % 66 / 66
    yaw = 1.3 * (4 * swing if swing < 0.25 else 2 - 4 * swing if swing < 0.75 else 4 * swing - 4)
    answer.update(body="stand", head="angles", look=[yaw, 0.3, 0])
    if time < 66 or stays:
        return
    if time < 216:
        answer.update(body="walk_speed", x=0, y=0, turn=0.8 * sight.walk["turn"])
        return
    target = sight.to_robot(complex(0.9 * sight.own_goal.real / 2 if memory.role == "defender" else 0, 0))
    if abs(target) > 0.3:
        walk(round_robots(sight, target), -sight.heading, answer)
