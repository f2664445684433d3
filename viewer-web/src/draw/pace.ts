// The share of a point cloud's points that a machine can draw in time. Without a graphics card that is not all.

const kAimed = 0.028; // [s] of one drawing, for 30 a second
const kSlow = 0.034; // [s] longer drawings are too slow for that
const kMany = 10; // drawings whose mean counts
const kStall = 0.15; // [s] one such drawing is enough to draw fewer points
const kQuick = 0.02; // [s] shorter ones leave room for more
const kPatience = 60; // quick drawings before more points are tried
const kMostPatience = 4000;
const kCoarsest = 8;

export class Pace {
  /** Every n-th column and row is drawn. */
  stride = 1;
  #last: number[] = []; // [s] durations with this stride
  #quick = 0;
  #patience = kPatience;

  /** Notes the duration [s] of one drawing. */
  drew(duration: number): void {
    this.#quick = duration < kQuick ? this.#quick + 1 : 0;
    this.#last = [...this.#last, duration].slice(-kMany);
    const mean = this.#last.reduce((sum, value) => sum + value, 0) / this.#last.length;
    if (duration > kStall) this.#thin(duration);
    else if (this.#last.length === kMany && mean > kSlow) this.#thin(mean);
    else if (this.#quick >= this.#patience && this.stride > 1) this.#change(this.stride - 1);
  }

  /** Draws fewer points, by how much drawings were too slow. More are tried again ever more rarely. */
  #thin(duration: number): void {
    const stride = Math.max(this.stride + 1, Math.round(this.stride * Math.sqrt(duration / kAimed)));
    this.#change(Math.min(kCoarsest, stride));
    this.#patience = Math.min(kMostPatience, 2 * this.#patience);
  }

  #change(stride: number): void {
    this.stride = stride;
    this.#last = [];
    this.#quick = 0;
  }
}
