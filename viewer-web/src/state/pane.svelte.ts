// One pane: the viewer as a view in it sees it, with the pane's own robot and settings.

import { knownField, type KnownField } from "../draw/known_field";
import type { Told } from "../draw/scene";
import { curvesOf, partsOf } from "../memory/curves";
import type { Memory } from "../memory/memory";
import type { MemoryObject, RobotName } from "../memory/memory_object";
import { leafOf, leavesOf, settingOf } from "./panes";
import type { View } from "./route";
import type { Server } from "./server.svelte";
import type { Source, Viewer } from "./viewer.svelte";

export class Pane {
  /** The pane's own robot while that is available, else the page's. */
  source: Source | undefined = $derived.by(() => this.viewer.sourceOf(this.get("robot")) ?? this.viewer.source);
  /** The robot's server, or the page's own without a robot. */
  server: Server = $derived.by(() => this.source?.server ?? this.viewer.servers[0]!);
  robot: RobotName = $derived(this.source?.robot ?? "");
  robotKey: string = $derived(this.source?.key ?? "");
  objects: MemoryObject[] = $derived(this.server.objectsOf(this.robot));
  /** All servers with their robots; the world of the pane's robot comes first. */
  told: Told[] = $derived.by(() => this.viewer.toldBy(this.server));
  view: View = $derived.by(() => leafOf(this.viewer.panes.tree, this.number)?.view ?? "field");

  constructor(
    readonly viewer: Viewer,
    readonly number: number,
  ) {}

  get time() {
    return this.viewer.time;
  }
  get past() {
    return this.viewer.past;
  }
  get servers(): Server[] {
    return this.viewer.servers;
  }
  get sources(): Source[] {
    return this.viewer.sources;
  }
  get memory(): Memory {
    return this.server.memory;
  }

  get hasOwnRobot(): boolean {
    return this.get("robot") !== "";
  }

  /** Whether the page's keys are for this pane. */
  get hasKeys(): boolean {
    return this.viewer.focused === this;
  }

  /** All servers with their robots, `first` before the others. */
  toldBy(first: Server): Told[] {
    return this.viewer.toldBy(first);
  }

  /** The field of the game that `first` shows, and who says so. */
  knownField(first: Server = this.server): KnownField {
    return knownField(first === this.server ? this.told : this.toldBy(first), this.get("field"));
  }

  /** A setting of this pane, or of the whole page. */
  get(name: string): string {
    return this.viewer.get(settingOf(this.number, name));
  }
  set(name: string, value: string): void {
    this.viewer.set(settingOf(this.number, name), value);
  }

  /** Chooses a view or robot. Without an own robot, the whole page changes. */
  go(to: { view?: View; robot?: string }): void {
    this.viewer.go(to, this);
  }

  /** Adds a number to the plot: that of another pane, or this pane becomes one. */
  plot(path: string): void {
    const { tree } = this.viewer.panes;
    const shown = leavesOf(tree).find(({ view }) => view === "plot");
    const pane = shown ? this.viewer.pane(shown.number) : this;
    this.addCurve(path, pane);
    if (!shown) this.go({ view: "plot" });
  }

  /** Adds a curve of this pane's server to the plot of a pane. */
  addCurve(path: string, to: Pane = this): void {
    const isComplete = partsOf(path).host !== undefined || this.server === this.servers[0];
    const curve = isComplete ? path : `${path}@${this.server.target.host}`;
    const others = curvesOf(to.get("plot"));
    if (!others.includes(curve)) to.set("plot", [...others, curve].join(" "));
  }
}
