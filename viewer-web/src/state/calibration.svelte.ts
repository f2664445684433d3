// The calibration of one sensor: clicks of a person, and the fit that the server makes of them at once.

import {
  calibratedOf,
  kCalibrate,
  kLandmarks,
  landmarksOf,
  type Calibrated,
  type Landmark,
  type Residual,
} from "../memory/calibration";
import { kNoClicks, type Clicking } from "./clicks";
import type { Server } from "./server.svelte";

export class Calibration {
  landmarks = $state.raw<Landmark[]>([]);
  clicking = $state.raw<Clicking>(kNoClicks);
  /** The fit of the clicks, or of those before while a new one is on its way. */
  answer = $state.raw<Calibrated>();
  /** One sentence about a question that failed; "" while all is well. */
  problem = $state("");
  /** The name of the file of calibrations. */
  file = $state("");
  /** Whether the clicks differ from the saved ones. */
  changed = $state(false);
  #asking = false;
  #asked: Clicking["clicks"] | undefined;

  readonly residuals: ReadonlyMap<string, Residual> = $derived(
    new Map((this.answer?.residuals ?? []).map((residual) => [residual.landmark, residual])),
  );

  constructor(
    readonly server: Server,
    readonly sensor: number,
  ) {}

  /**
   * Learns the landmarks, and the clicks of the saved calibration. After a lost connection, which makes the page ask again,
   * the clicks of a person stay.
   */
  async begin(): Promise<void> {
    if (this.landmarks.length > 0) return;
    await this.#ask(kLandmarks, { sensor: this.sensor }, (answer) => {
      const { landmarks, clicks, file } = landmarksOf(answer);
      this.landmarks = landmarks;
      this.file = file;
      this.clicking = { ...kNoClicks, clicks };
    });
    await this.#fit();
  }

  /** Takes over what a person did. Changed clicks are fitted at once. */
  change(next: Clicking): void {
    const isNew = next.clicks !== this.clicking.clicks;
    this.clicking = next;
    if (!isNew) return;
    this.changed = true;
    void this.#fit();
  }

  /** Saves the calibration of these clicks. A refusal is in the answer. */
  async save(): Promise<void> {
    const { clicks } = this.clicking;
    await this.#ask(kCalibrate, { sensor: this.sensor, clicks, save: true }, (answer) => {
      this.answer = calibratedOf(answer);
      if (this.answer.saved && this.clicking.clicks === clicks) this.changed = false;
    });
  }

  /** Asks for the fit of the newest clicks. Questions never wait in a row. */
  async #fit(): Promise<void> {
    if (this.#asking) return;
    this.#asking = true;
    while (this.#asked !== this.clicking.clicks) {
      const { clicks } = this.clicking;
      this.#asked = clicks;
      if (clicks.length === 0) this.answer = undefined;
      else
        await this.#ask(kCalibrate, { sensor: this.sensor, clicks, save: false }, (answer) => {
          this.answer = calibratedOf(answer);
        });
    }
    this.#asking = false;
  }

  async #ask(service: string, request: object, take: (answer: Record<string, unknown>) => void): Promise<void> {
    try {
      take(await this.server.client.call(service, request));
      this.problem = "";
    } catch (error) {
      this.problem = (error as Error).message.replace(`${service}: `, "");
    }
  }
}
