// Numbers in the reader's notation: reading and writing.
import { degrees } from "assur/core/angles.js";

const NUMBER = /^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i;

/** The letter before an exponent, as browsers write it in Ukrainian. */
const CYRILLIC_E = /[еЕ]/g;

/** An exponent as browsers write it. */
const EXPONENT = /[EЕ]([\u2212\d]+)$/;

/** `HUGE`, `TINY`: limits of the absolute values that `short`, `brief` and `exact` write without a power of ten. */
const HUGE = 1e9;
const TINY = 1e-6;

/**
 * Reads a number. The number may have a decimal point or comma, spaces between digits, a typographic minus, a degree
 * sign, and an exponent after a Latin or Cyrillic E.
 * @param {string} text
 * @returns {number | null} null if the text is not one finite number
 */
export function parseNumber(text) {
  const plain = text.replace(/[\s°]/g, "").replace(/\u2212/g, "-").replace(CYRILLIC_E, "e");
  if (!NUMBER.test(plain)) return null;
  const value = Number(plain.replace(",", "."));
  return Number.isFinite(value) ? value : null;
}

/**
 * @param {number} decimals decimals of a number at rest
 * @param {boolean} playing
 * @returns {number} decimals that can be read: in motion half of them, rounded down
 */
export function readable(decimals, playing) {
  return playing ? Math.floor(decimals / 2) : decimals;
}

/**
 * @param {number} exponent
 * @returns {string} the power of ten, such as 10⁻³
 */
export function powerOfTen(exponent) {
  return `10${String(exponent).replace("-", "⁻").replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(digit)])}`;
}

/** Languages in which browsers cannot write numbers, each with a language that has the same notation. */
const ALIKE = Object.freeze(new Map([["kk", "ru"]]));

/** Numbers written in the notation of one language. */
export class Numbers {
  #locale;
  /** @type {Map<string, Intl.NumberFormat>} */
  #formats = new Map();
  #plurals;

  /** @param {string} lang */
  constructor(lang) {
    this.#locale = ALIKE.get(lang) ?? lang;
    this.#plurals = new Intl.PluralRules(lang);
  }

  /** Whether the decimal sign is a comma. */
  get comma() {
    return this.fixed(0.5, 1).includes(",");
  }

  /**
   * Plural form of a noun beside a number by the rules of the language, such as one, few, many, other.
   * @param {number} count
   */
  form(count) {
    return this.#plurals.select(count);
  }

  /**
   * A number with exactly the given number of decimals.
   * @param {number} value
   * @param {number} decimals
   */
  fixed(value, decimals) {
    return this.#write(value, `f${decimals}`, { minimumFractionDigits: decimals, maximumFractionDigits: decimals });
  }

  /**
   * A number with at most the given number of decimals.
   * @param {number} value
   * @param {number} decimals
   */
  upTo(value, decimals) {
    return this.#write(value, `u${decimals}`, { maximumFractionDigits: decimals });
  }

  /**
   * An angle in degrees, with the degree sign.
   * @param {number} radians
   * @param {number} decimals at most
   */
  angle(radians, decimals) {
    return `${this.upTo(degrees(radians), decimals)}°`;
  }

  /**
   * A number with at most four significant digits, for sentences.
   * @param {number} value
   */
  short(value) {
    const text = this.#write(value, "s", { maximumSignificantDigits: 4 });
    return text.replace(EXPONENT, (_, exponent) => `·${powerOfTen(Number(exponent.replace("\u2212", "-")))}`);
  }

  /**
   * A number with at most six significant digits, for a field.
   * @param {number} value
   */
  brief(value) {
    return this.#write(value, "b", { maximumSignificantDigits: 6 });
  }

  /**
   * A number with all the digits that a person may have typed into a field.
   * @param {number} value
   */
  exact(value) {
    return this.#write(value, "x", { maximumSignificantDigits: 15 });
  }

  /**
   * @param {number} value
   * @param {string} key
   * @param {Intl.NumberFormatOptions} options
   */
  #write(value, key, options) {
    const size = Math.abs(value);
    if ("maximumSignificantDigits" in options && size !== 0 && (size >= HUGE || size < TINY)) {
      return this.#format(value, `${key}e`, { ...options, notation: "scientific" });
    }
    return this.#format(value, key, options);
  }

  /**
   * @param {number} value
   * @param {string} key
   * @param {Intl.NumberFormatOptions} options
   */
  #format(value, key, options) {
    let format = this.#formats.get(key);
    if (!format) {
      format = new Intl.NumberFormat(this.#locale, { useGrouping: false, signDisplay: "negative", ...options });
      this.#formats.set(key, format);
    }
    return format.format(value).replaceAll("-", "\u2212");
  }
}
