// The state of the page: watched servers, chosen robot and view, shown time. Values of memory objects are plain and
// read while drawing; only rarely changing values are reactive.

import { topicsOf, type Told } from "../draw/scene";
import type { RobotName } from "../memory/memory_object";
import { capsFor, Past } from "../memory/past";
import { addressOf, targetOfHost, type Target } from "../source/target";
import type { Level } from "../source/texts";
import { Dismissed, withAlert, withoutAlerts, type Alert } from "./alerts";
import { keep, kept } from "./browser";
import { now } from "./frame.svelte";
import type { Left } from "./left";
import { linkOf } from "./link";
import { Moments } from "./moments.svelte";
import { Pane } from "./pane.svelte";
import {
  close,
  inherited,
  isOfPane,
  kMostPanes,
  kPresets,
  leafOf,
  leavesOf,
  maximise,
  neighbour,
  nextView,
  onePane,
  panesOf,
  resize,
  seenOn,
  settingOf,
  showing,
  split,
  textOfPanes,
  tidied,
  type Border,
  type Panes,
  type Preset,
  type Way,
} from "./panes";
import { isWide, Screen } from "./room.svelte";
import { hashOf, routeOf, type Route, type View } from "./route";
import { Server, type Speaker } from "./server.svelte";
import { Time } from "./time.svelte";

/** One robot of one server. */
export interface Source {
  server: Server;
  robot: RobotName;
  /** In addresses and lists: "14/2" on the page's own server, "14/2@10.0.14.2:8765" on another. */
  key: string;
}

/** An arrangement that nobody chose. */
interface First {
  panes: Panes;
  settings: ReadonlyMap<string, string>;
}

/** Settings that belong to a session, and not to the arrangement. */
const kOfMoments = ["at", "marks", "loop"];
/** Settings that another arrangement keeps. */
const kOfTime = [...kOfMoments, "follow"];
const tokenKey = (host: string): string => `token ${host}`;

export class Viewer implements Speaker {
  readonly past = new Past(capsFor(matchMedia("(pointer: coarse)").matches));
  /** The first is the page's own. */
  servers = $state.raw<Server[]>([]);
  alerts = $state.raw<Alert[]>([]);
  route = $state.raw<Route>(routeOf(location.hash));
  readonly time: Time;
  readonly moments: Moments;

  /** All robots of all servers. */
  sources: Source[] = $derived(
    this.servers.flatMap((server) =>
      server.robots.map((robot) => ({ server, robot, key: this.#keyOf(server, robot) })),
    ),
  );
  /**
   * The page's robot while it is available. Otherwise, once all are known, the server's own robot, else the first one.
   * A pane may have another.
   */
  source: Source | undefined = $derived.by(() => {
    const own = this.servers[0];
    return (
      this.sourceOf(this.route.robot) ??
      (own?.toldAll ? (this.sourceOf(own.info?.metadata["robots"] ?? "") ?? this.sources[0]) : undefined)
    );
  });
  /** That robot's server, or the page's own without a robot. */
  server: Server = $derived(this.source?.server ?? this.servers[0]!);
  robot: RobotName = $derived(this.source?.robot ?? "");

  readonly #all: readonly Pane[] = Array.from({ length: kMostPanes }, (_, i) => new Pane(this, i + 1));
  readonly #screen = new Screen();
  #first = $state.raw<First>(); // without a choice
  readonly #named: string = $derived(this.route.settings.get("panes") ?? "");
  readonly #namedView: View | "" = $derived(this.route.view);
  /** Whether the address names no arrangement. */
  readonly #isUsual: boolean = $derived(this.#namedView === "" && this.#named === "");
  /** The arrangement: that of the address, else of its one view, else the first one that has data. */
  panes: Panes = $derived(
    panesOf(this.#named) ?? (this.#namedView ? onePane(this.#namedView) : (this.#first?.panes ?? onePane("camera"))),
  );
  #focus = $state(1);
  /** The pane that gets the keys. */
  focused: Pane = $derived.by(() => {
    const { tree, full } = this.panes;
    return this.pane(full ?? (leafOf(tree, this.#focus) ?? leavesOf(tree)[0]!).number);
  });
  /** The panes that this screen shows. */
  seen: Panes = $derived(seenOn(this.#screen.room, this.panes, this.focused.number));
  /** Whether the page knows its arrangement; for a moment it may wait for the robot's objects. */
  settled: boolean = $derived(!this.#isUsual || this.#first !== undefined);

  /** The session that a person asked for last. */
  wanted = $state("");

  #dismissed = new Dismissed();

  constructor(readonly target: Target) {
    this.servers = [new Server(target, this.past, this)];
    this.time = new Time(this);
    this.moments = new Moments(this);
    this.#followRoute();
    window.addEventListener("pagehide", () => this.servers.forEach((server) => server.keepPlayhead()));
    window.addEventListener("hashchange", () => {
      this.route = routeOf(location.hash);
      this.#followRoute();
    });
  }

  get several(): boolean {
    return this.servers.length > 1;
  }

  get memory() {
    return this.server.memory;
  }

  sourceOf(key: string): Source | undefined {
    return this.sources.find((source) => source.key === key);
  }

  /** All servers with their robots, `first` before the others. */
  toldBy(first: Server): Told[] {
    return [first, ...this.servers.filter((server) => server !== first)].map((server) => ({
      memory: server.memory,
      robots: server.robots,
      rules: server.info?.metadata["rules"] ?? "",
      keyOf: (robot) => this.#keyOf(server, robot),
    }));
  }

  #keyOf(server: Server, robot: RobotName): string {
    return server === this.servers[0] ? robot : `${robot}@${server.target.host}`;
  }

  // the first view

  /** Called before each drawing. */
  frame(): void {
    this.time.frame();
    if (!this.settled) this.#first = this.#firstPanes();
  }

  /** The arrangement of a page whose address names none: one that has data. Undefined while that is not known. */
  #firstPanes(): First | undefined {
    const { server, source } = this;
    if (!server.toldAll) return undefined;
    if (!source && server.sensors.length > 0) return { panes: onePane("ground-truth"), settings: new Map() };
    if (!source) return undefined;
    const objects = server.objectsOf(source.robot);
    const pictures = objects.filter(({ isImage }) => isImage).map(({ channel }) => server.hasWritten(channel.topic));
    if (pictures.includes("unknown")) return undefined;
    const seesField = topicsOf(server.memory, server.robots).length > 0;
    if (isWide() && this.#screen.room === "all" && seesField) {
      const decides = server.memory.of(source.robot, "decision") !== undefined;
      const preset = kPresets.find(
        ({ name }) => name === (decides ? "Why" : pictures.includes("yes") ? "Seeing" : "Match"),
      )!;
      return { panes: panesOf(preset.panes)!, settings: new Map(Object.entries(preset.settings)) };
    }
    const view = pictures.includes("yes") ? "camera" : seesField ? "field" : objects.length > 0 ? "objects" : "camera";
    return { panes: onePane(view), settings: new Map() };
  }

  // robots, views and panes; all of them are in the page's address

  pane(number: number): Pane {
    return this.#all[number - 1]!;
  }

  /** The focused pane's view. */
  get view(): View {
    return this.focused.view;
  }
  /** The focused pane's robot. */
  get robotKey(): string {
    return this.focused.robotKey;
  }

  /** The address' parts. The requested robot stays chosen while it is not available. */
  get arrangement(): Route {
    return this.#complete({ ...this.route, robot: this.route.robot || (this.source?.key ?? "") });
  }

  /** Names the arrangement in a route that names none. */
  #complete(route: Route): Route {
    if (route.view || route.settings.has("panes")) return route;
    return withPanes(
      { ...route, settings: new Map([...(this.#first?.settings ?? []), ...route.settings]) },
      this.panes,
    );
  }

  linkTo(to: { view?: View; robot?: string }, { number, hasOwnRobot }: Pane = this.focused): string {
    let route = this.arrangement;
    if (to.view) route = withPanes(route, showing(this.panes, number, to.view));
    if (to.robot && !hasOwnRobot) route = { ...route, robot: to.robot };
    if (to.robot && hasOwnRobot) route = withSettings(route, [[settingOf(number, "robot"), to.robot]]);
    return hashOf(route);
  }

  /** Chooses a view or robot of a pane. The robot is that of all panes without an own one. */
  go(to: { view?: View; robot?: string }, pane: Pane = this.focused): void {
    this.#goTo(this.linkTo(to, pane));
  }
  #goTo(hash: string): void {
    location.hash = hash;
    this.route = routeOf(hash);
  }

  /**
   * Stores a setting in the address, so that a link shows the same. "" removes it. Makes no entry in the browser's
   * history.
   */
  set(name: string, value: string): void {
    if (this.get(name) === value && (value || !this.route.settings.has(name))) return;
    const route = routeOf(location.hash); // may be newer than this.route: the event of a link that was followed comes later
    this.#replace(withSettings(this.settled ? this.#complete(route) : route, [[name, value]]));
  }
  #replace(route: Route): void {
    this.route = route;
    history.replaceState(null, "", hashOf(route));
  }

  /** Gives a pane the keys. */
  focus(number: number): void {
    this.#focus = number;
  }
  focusNeighbour(by: 1 | -1): void {
    const next = neighbour(this.panes, this.focused.number, by);
    if (this.panes.full !== undefined) this.#replace(withPanes(this.arrangement, { ...this.panes, full: next }));
    this.#focus = next;
  }

  /** Splits a pane. The new one shows something else, and gets the keys. */
  split(way: Way, { number }: Pane = this.focused): void {
    const view = nextView(this.panes);
    const made = split(this.panes, number, way, view);
    if (!made) return this.say("info", `A page has ${kMostPanes} panes at most: close one first.`, "most panes");
    const route = this.arrangement;
    const own = inherited(this.panes, number, view, route.settings);
    const clean = tidied(this.panes, route.settings).settings; // settings of a closed pane do not return
    const settings = own.map(([name, value]): [string, string] => [settingOf(made.number, name), value]);
    this.#goTo(hashOf(withPanes(withSettings({ ...route, settings: clean }, settings), made.panes)));
    this.#focus = made.number;
  }
  close({ number }: Pane = this.focused): void {
    const next = neighbour(this.panes, number, 1);
    const route = this.arrangement;
    const { panes, settings } = tidied(close(this.panes, number), route.settings);
    this.#focus = leafOf(panes.tree, next) ? next : 1;
    this.#goTo(hashOf(withPanes({ ...route, settings }, panes)));
  }
  maximise({ number }: Pane = this.focused): void {
    this.#focus = number;
    this.#replace(withPanes(this.arrangement, maximise(this.panes, number)));
  }
  resize(border: Pick<Border, "path" | "index">, share: number): void {
    this.#replace(withPanes(this.arrangement, resize(this.panes, border, share)));
  }

  /** Arranges the panes anew. They keep the settings of the views that were shown before. */
  arrangeAs({ panes: text, settings, other }: Preset): void {
    const panes = panesOf(text)!;
    const route = this.arrangement;
    const ofPage = [...route.settings].filter(([name]) => !isOfPane(name.replace(/^\d\./, "")));
    const kept = leavesOf(panes.tree).flatMap(({ number, view }) =>
      inherited(this.panes, this.focused.number, view, route.settings).map(([name, value]): [string, string] => [
        settingOf(number, name),
        value,
      ]),
    );
    const rival =
      other && this.sources[(this.sources.findIndex(({ key }) => key === this.source?.key) + 1) % this.sources.length];
    const own: [string, string][] = rival ? [[settingOf(other, "robot"), rival.key]] : [];
    this.#focus = 1;
    this.#goTo(
      hashOf(
        withPanes({ ...route, settings: new Map([...ofPage, ...Object.entries(settings), ...kept, ...own]) }, panes),
      ),
    );
  }

  /** Applies another arrangement at the shown moment. */
  arrange(layout: Route): void {
    const settings = new Map([...this.route.settings].filter(([name]) => kOfTime.includes(name)));
    this.#focus = 1;
    location.hash = hashOf({ ...layout, settings: new Map([...layout.settings, ...settings]) });
  }

  get(name: string): string {
    return this.route.settings.get(name) ?? (this.#isUsual ? (this.#first?.settings.get(name) ?? "") : "");
  }

  /** The link to the page as it is, with its session and moment. */
  get link(): string {
    const { time } = this;
    const at_ns = time.range() ? time.at_ns : undefined;
    return linkOf(location.href, this.arrangement, { session: this.server.session, at_ns });
  }

  /** Watches a session of the page's own server from its begin. */
  async watch(session: string): Promise<void> {
    if (!(await this.servers[0]!.watch(session))) return;
    this.wanted = session;
    const settings = new Map([...this.route.settings].filter(([name]) => !kOfMoments.includes(name)));
    location.hash = hashOf({ robot: "", view: "", settings: settings.set("session", session) });
  }

  /** Watches the session of the link that opened this page. */
  async watchLinked(): Promise<void> {
    const session = this.get("session");
    if (await this.server.watch(session)) this.wanted = session;
  }

  /** Chooses the next or previous robot of all. */
  chooseNeighbour(step: 1 | -1): void {
    const { sources } = this;
    if (sources.length === 0) return;
    const at = sources.findIndex(({ key }) => key === this.robotKey);
    this.go({ robot: sources[(at + step + sources.length) % sources.length]!.key });
  }

  // servers

  /** Watches another server, "10.0.14.2" or "10.0.14.2:8765". Returns a sentence if the address is invalid. */
  add(typed: string): string {
    const address = addressOf(typed);
    if ("error" in address) return address.error;
    if (address.token) keep("sessionStorage", tokenKey(address.host), address.token);
    if (this.servers.some(({ target }) => target.host === address.host)) return `${address.host} is watched already.`;
    this.set("with", [...this.#others(), address.host].join(","));
    this.#followRoute();
    return "";
  }

  /** Keeps a token for the server in this tab, and loads the page again with it. */
  useToken(server: Server, token: string): void {
    keep("sessionStorage", tokenKey(server.target.host), token);
    if (!server.target.ownHost) return location.reload();
    const page = new URL(location.href);
    page.searchParams.set("token", token); // the server answers with its cookie, and the page then hides the token
    location.assign(page.href);
  }

  remove(server: Server): void {
    this.set(
      "with",
      this.#others()
        .filter((host) => host !== server.target.host)
        .join(","),
    );
    this.#followRoute();
  }

  #others(): string[] {
    return this.get("with").split(",").filter(Boolean);
  }

  /** Connects to the page's own server and those in the address. */
  #followRoute(): void {
    const hosts = [...new Set(this.#others())].filter((host) => host !== this.target.host);
    const [own, ...others] = this.servers;
    const gone = others.filter(({ target }) => !hosts.includes(target.host));
    gone.forEach((server) => server.stop());
    const come = hosts
      .filter((host) => !others.some(({ target }) => target.host === host))
      .flatMap((host) => {
        const target = targetOfHost(host, kept("sessionStorage", tokenKey(host)));
        return target ? [new Server(target, this.past, this)] : [];
      });
    if (gone.length > 0 || come.length > 0)
      this.servers = [own!, ...others.filter((server) => !gone.includes(server)), ...come];
    this.#choosePlayhead();
  }

  // sentences

  say(level: Level, text: string, key: string = text): void {
    if (this.#dismissed.hides(level, key, now())) return;
    this.alerts = withAlert(this.alerts, level, text, key);
  }

  follow(server: Server): void {
    this.time?.follow(server);
  }
  opened(server: Server, left: Left | undefined): void {
    this.time?.opened(server, left);
  }

  /** Whether the page follows the shared playback of a recording. Otherwise it has a playhead of its own. */
  get follows(): boolean {
    return this.route.settings.has("follow");
  }
  get asked_ns(): bigint | undefined {
    const at = this.get("at");
    return /^\d{1,19}$/.test(at) ? BigInt(at) : undefined;
  }
  /** Follows the shared playback of a recording, or goes on with a playhead of the page's own. */
  setFollows(follows: boolean): void {
    this.set("follow", follows ? "yes" : "");
    this.#choosePlayhead();
  }
  #choosePlayhead(): void {
    for (const server of this.servers) server.choose(!this.follows);
  }

  /** Dismisses a sentence for a person. A warning that comes again and again then stays away for a while. */
  mute(key: string): void {
    this.#dismissed.add(key, now());
    this.dismiss([key]);
  }

  dismiss(keys: string[]): void {
    this.alerts = withoutAlerts(this.alerts, keys);
  }
}

function withSettings(route: Route, changed: [string, string][]): Route {
  const settings = new Map(route.settings);
  for (const [name, value] of changed)
    if (value) settings.set(name, value);
    else settings.delete(name);
  return { ...route, settings };
}

/** One pane is a page's view, as in the links of always; several have their text. */
function withPanes(route: Route, panes: Panes): Route {
  const leaves = leavesOf(panes.tree);
  const text = leaves.length > 1 ? textOfPanes(panes) : "";
  return { ...withSettings(route, [["panes", text]]), view: leaves[0]!.view };
}
