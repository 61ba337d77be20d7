// Random input from a fixed seed, the same in every run. ASSUR_SEED changes the seed, ASSUR_SCALE multiplies the number of runs.

const SEED = Number(process.env.ASSUR_SEED ?? 0x5eeda550);
const SCALE = Number(process.env.ASSUR_SCALE ?? 1);

export class Dice {
  #state;

  /** @param {number} seed */
  constructor(seed) {
    this.#state = seed >>> 0;
  }

  /** @returns {number} from 0 to below 1 */
  share() {
    this.#state = (this.#state + 0x9e3779b9) >>> 0;
    let bits = this.#state;
    bits = Math.imul(bits ^ (bits >>> 16), 0x21f0aaad);
    bits = Math.imul(bits ^ (bits >>> 15), 0x735a2d97);
    return ((bits ^ (bits >>> 15)) >>> 0) / 2 ** 32;
  }

  /** @param {number} count */
  below(count) {
    return Math.floor(this.share() * count);
  }

  /**
   * @param {number} from
   * @param {number} to
   */
  between(from, to) {
    return from + this.share() * (to - from);
  }

  /**
   * @template T
   * @param {readonly T[]} list
   */
  one(list) {
    return list[this.below(list.length)];
  }

  /** @returns {number} of either sign, of up to 15 digits, from 1e-20 to 1e20 */
  number() {
    const size = this.between(1, 10) * 10 ** (this.below(40) - 20);
    return Number((this.below(2) ? size : -size).toPrecision(1 + this.below(15)));
  }
}

/**
 * Runs a test for many random inputs. The message of a failure names the seed that shows the failure again.
 * @param {number} times at scale 1
 * @param {(dice: Dice, run: number) => void} test
 */
export function often(times, test) {
  for (let run = 0; run < times * SCALE; run++) {
    const seed = SEED + run;
    try {
      test(new Dice(Math.imul(seed, 0x85ebca6b)), run);
    } catch (error) {
      error.message = `ASSUR_SEED=${seed}: ${error.message}`;
      throw error;
    }
  }
}
