// The share of a point cloud's points that a machine can draw in time. Without a graphics card that is not all.

const kSlow = 0.04; // [s] longer drawings make the page stutter
const kQuick = 0.02; // [s] shorter ones leave room for more
const kInRow = 3; // slow drawings before fewer points are drawn
const kPatience = 60; // quick drawings before more points are tried
const kMostPatience = 4000;
const kCoarsest = 6;

export class Pace {
  /** Every n-th column and row is drawn. */
  stride = 1;
  #slow = 0;
  #quick = 0;
  #patience = kPatience;

  /** Notes the duration [s] of one drawing. */
  drew(duration: number): void {
    this.#slow = duration > kSlow ? this.#slow + 1 : 0;
    this.#quick = duration < kQuick ? this.#quick + 1 : 0;
    if (this.#slow >= kInRow && this.stride < kCoarsest) {
      this.#change(this.stride + 1);
      // more points were too many: they are tried again ever more rarely
      this.#patience = Math.min(kMostPatience, 2 * this.#patience);
    } else if (this.#quick >= this.#patience && this.stride > 1) this.#change(this.stride - 1);
  }

  #change(stride: number): void {
    this.stride = stride;
    this.#slow = this.#quick = 0;
  }
}
