// The state of the page: watched servers, chosen robot and view, shown time. Values of memory objects are plain and
// read while drawing; only rarely changing values are reactive.

import { knownField, type KnownField } from "../draw/known_field";
import { kTruth, type Told } from "../draw/scene";
import type { MemoryObject, RobotName } from "../memory/memory_object";
import { capsFor, Past } from "../memory/past";
import { addressOf, targetOfHost, type Target } from "../source/target";
import type { Level } from "../source/texts";
import { Dismissed, withAlert, withoutAlerts, type Alert } from "./alerts";
import { keep, kept } from "./browser";
import { now } from "./frame.svelte";
import { linkOf } from "./link";
import { Moments } from "./moments.svelte";
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
   * The chosen robot while it is available. Otherwise, once all are known, the server's own robot, else the first one.
   */
  source: Source | undefined = $derived.by(() => {
    const named = (key: string | undefined) => this.sources.find((source) => source.key === key);
    const own = this.servers[0];
    return (
      named(this.route.robot) ?? (own?.toldAll ? (named(own.info?.metadata["robots"]) ?? this.sources[0]) : undefined)
    );
  });
  /** The chosen robot's server, or the page's own without a robot. */
  server: Server = $derived(this.source?.server ?? this.servers[0]!);
  robot: RobotName = $derived(this.source?.robot ?? "");
  robotKey: string = $derived(this.source?.key ?? "");
  objects: MemoryObject[] = $derived(this.server.objectsOf(this.robot));
  /** All servers with their robots; the chosen robot's world comes first. */
  told: Told[] = $derived(
    [this.server, ...this.servers.filter((server) => server !== this.server)].map((server) => ({
      memory: server.memory,
      robots: server.robots,
      rules: server.info?.metadata["rules"] ?? "",
      keyOf: (robot) => this.#keyOf(server, robot),
    })),
  );
  /** The chosen view. Without a choice: camera, or field for a game without a camera. */
  view: View = $derived(this.route.view || (this.#playsBlind() ? "field" : "camera"));

  /** The session that a person asked for last. */
  wanted = $state("");

  #dismissed = new Dismissed();

  /** The field of the game, and who says so. */
  knownField(): KnownField {
    return knownField(this.told, this.get("field"));
  }

  constructor(readonly target: Target) {
    this.servers = [new Server(target, this.past, this)];
    this.time = new Time(this);
    this.moments = new Moments(this);
    this.#followRoute();
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

  #keyOf(server: Server, robot: RobotName): string {
    return server === this.servers[0] ? robot : `${robot}@${server.target.host}`;
  }

  #playsBlind(): boolean {
    return this.objects.some(({ channel }) => channel.topic === kTruth) && !this.objects.some(({ isImage }) => isImage);
  }

  // robots and views; all of them are in the page's address

  go(to: Partial<Route>): void {
    location.hash = this.linkTo(to);
  }

  /** The address' parts. The requested robot stays chosen while it is not available. */
  get arrangement(): Route {
    return { ...this.route, robot: this.route.robot || this.robotKey, view: this.view };
  }

  linkTo(to: Partial<Route>): string {
    return hashOf({ ...this.arrangement, ...to });
  }

  /**
   * Stores a view's setting in the address, so that a link shows the same. "" removes it. Makes no entry in the
   * browser's history.
   */
  set(name: string, value: string): void {
    if (this.get(name) === value) return;
    const route = routeOf(location.hash); // may be newer than this.route: the event of a link that was followed comes later
    const settings = new Map(route.settings);
    if (value) settings.set(name, value);
    else settings.delete(name);
    this.route = { ...route, settings };
    history.replaceState(
      null,
      "",
      hashOf({ ...this.route, robot: this.route.robot, view: this.route.view || this.view }),
    );
  }

  /** Applies another arrangement at the shown moment. */
  arrange(layout: Route): void {
    const settings = new Map([...this.route.settings].filter(([name]) => ["at", "marks", "loop"].includes(name)));
    location.hash = hashOf({ ...layout, settings: new Map([...layout.settings, ...settings]) });
  }

  get(name: string): string {
    return this.route.settings.get(name) ?? "";
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
    const settings = new Map([...this.route.settings].filter(([name]) => !["at", "marks", "loop"].includes(name)));
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
  }

  // sentences

  say(level: Level, text: string, key: string = text): void {
    if (this.#dismissed.hides(level, key, now())) return;
    this.alerts = withAlert(this.alerts, level, text, key);
  }

  follow(server: Server): void {
    this.time?.follow(server);
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
