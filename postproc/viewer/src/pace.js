// Fewer pixels while it plays on a machine that cannot keep up; all of them when it stands.

const SLOW = 0.045; // seconds between two pictures from which it stutters
const PATIENCE = 10; // pictures
const LEAST = 0.5; // of the pixels across

export class Pace {
  constructor() {
    this.share = 1; // of the pixels across that are drawn
    this.slow = 0;
  }

  /** @param {number} seconds since the picture before. @returns {boolean} whether the share has changed */
  note(seconds, playing) {
    if (!playing) {
      const changed = this.share !== 1;
      this.share = 1;
      this.slow = 0;
      return changed;
    }
    this.slow = seconds > SLOW ? this.slow + 1 : Math.max(0, this.slow - 1);
    if (this.slow < PATIENCE || this.share <= LEAST) return false;
    this.slow = 0;
    this.share = Math.max(LEAST, 0.7 * this.share);
    return true;
  }
}
