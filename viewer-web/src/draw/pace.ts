// The share of a point cloud's points that a machine can draw in time. Without a graphics card that is not all.

const kAimed = 0.033; // [s] of one drawing, for 30 a second
const kSlow = 0.045; // [s] longer drawings make the page stutter
const kStall = 0.15; // [s] one such drawing is enough to draw fewer points
const kQuick = 0.02; // [s] shorter ones leave room for more
const kInRow = 3; // slow drawings before fewer points are drawn
const kPatience = 60; // quick drawings before more points are tried
const kMostPatience = 4000;
const kCoarsest = 8;

export class Pace {
  /** Every n-th column and row is drawn. */
  stride = 1;
  #slow: number[] = []; // [s] durations in a row
  #quick = 0;
  #patience = kPatience;

  /** Notes the duration [s] of one drawing. */
  drew(duration: number): void {
    this.#quick = duration < kQuick ? this.#quick + 1 : 0;
    this.#slow = duration > kSlow ? [...this.#slow, duration] : [];
    if (this.#slow.length >= kInRow || duration > kStall) this.#thin(Math.min(...this.#slow));
    else if (this.#quick >= this.#patience && this.stride > 1) this.#change(this.stride - 1);
  }

  /** Draws fewer points, by how much a drawing was too slow. More are tried again ever more rarely. */
  #thin(duration: number): void {
    const stride = Math.max(this.stride + 1, Math.round(this.stride * Math.sqrt(duration / kAimed)));
    this.#change(Math.min(kCoarsest, stride));
    this.#patience = Math.min(kMostPatience, 2 * this.#patience);
  }

  #change(stride: number): void {
    this.stride = stride;
    this.#slow = [];
    this.#quick = 0;
  }
}
