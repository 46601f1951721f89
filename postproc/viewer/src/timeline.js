// Where the player stands and how it moves on. Knows nothing of pictures.

export class Timeline {
  /**
   * @param {number[]} values of the axis, one a frame, ascending
   * @param {number} perSecond how far they go in a second at speed 1
   */
  constructor(values, perSecond) {
    this.values = values;
    this.perSecond = perSecond;
    this.speed = 1;
    this.loop = true;
    this.playing = false;
    this.now = values[0];
  }

  get first() { return this.values[0]; }
  get last() { return this.values[this.values.length - 1]; }

  /** The frame at or before now, and how far on the way to the next one, 0 to 1. */
  get place() {
    const { values, now } = this;
    let low = 0;
    let high = values.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (values[middle] <= now) low = middle;
      else high = middle;
    }
    if (values.length === 1) return { frame: 0, fraction: 0 };
    const fraction = (now - values[low]) / (values[high] - values[low]);
    return fraction >= 1 ? { frame: high, fraction: 0 } : { frame: low, fraction: Math.max(0, fraction) };
  }

  /** The frame nearest to now. */
  get nearest() {
    const { frame, fraction } = this.place;
    return fraction > 0.5 ? frame + 1 : frame;
  }

  set(now) { this.now = Math.min(this.last, Math.max(this.first, now)); }
  setFrame(frame) { this.now = this.values[Math.min(this.values.length - 1, Math.max(0, Math.round(frame)))]; }

  play() {
    if (this.values.length < 2) return;
    if (this.now >= this.last) this.now = this.first;
    this.playing = true;
  }

  /** Stops on a frame of the result: what stands still is data, not interpolation. */
  pause() {
    this.playing = false;
    this.setFrame(this.nearest);
  }

  /** @param {number} seconds that have passed */
  advance(seconds) {
    const next = this.now + seconds * this.speed * this.perSecond;
    if (next < this.last) this.now = next;
    else if (this.loop) this.now = this.first + ((next - this.first) % (this.last - this.first));
    else {
      this.now = this.last;
      this.playing = false;
    }
  }
}
