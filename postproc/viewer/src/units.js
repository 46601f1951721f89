// Numbers for people: SI prefixes and round ticks.

const PREFIXES = { '-12': 'p', '-9': 'n', '-6': 'µ', '-3': 'm', 0: '', 3: 'k', 6: 'M' };

/**
 * The factor and the name of the unit in which numbers up to `largest` are short: 0.012, "J/m²" gives 1000, "mJ/m²".
 * @param {number} largest SI
 * @param {string} unit SI; "1" of a ratio, which becomes per cent; "" of a plain number
 * @returns {{factor: number, unit: string}}
 */
export function scaleFor(largest, unit) {
  if (unit === '') return { factor: 1, unit: '' };
  if (unit === '1') return largest >= 1e-5 || !(largest > 0) ? { factor: 100, unit: '%' } : { factor: 1e6, unit: 'µm/m' };
  if (unit === '1/m') return largest >= 1000 ? { factor: 1e-3, unit: '1/mm' } : { factor: 1, unit };
  if (!(largest > 0) || !Number.isFinite(largest)) return { factor: 1, unit };
  const exponent = Math.min(6, Math.max(-12, 3 * Math.floor(Math.log10(largest) / 3 + 1e-9)));
  return { factor: 10 ** -exponent, unit: PREFIXES[exponent] + unit };
}

/** A number with so many significant digits, without an exponent where it can be; a true minus sign. */
export function digits(value, count = 3) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text = size >= 1e5 || size < 1e-4 ? value.toExponential(count - 1) : String(Number(value.toPrecision(count)));
  return text.replace(/-/g, '−');
}

/** A number with so many decimals; a true minus sign, none before zero. */
export function decimals(value, count) {
  const text = value.toFixed(count);
  return (Number(text) === 0 ? text.replace('-', '') : text).replace('-', '−');
}

/** Round numbers, 1, 2 or 5 times a power of ten apart, about `count` of them within [low, high]. */
export function ticks(low, high, count) {
  const span = high - low;
  if (!(span > 0)) return [low];
  const raw = span / Math.max(count, 1);
  const decade = 10 ** Math.floor(Math.log10(raw));
  const away = (step) => Math.abs(Math.log(step / raw));
  const step = [1, 2, 5, 10].map((m) => m * decade).reduce((best, other) => (away(other) < away(best) ? other : best));
  const found = [];
  for (let k = Math.ceil(low / step - 1e-6); k * step <= high + 1e-6 * step; k += 1) found.push(k * step);
  return found;
}

/** How many decimals tell these ticks apart. */
export function decimalsOf(marks) {
  const step = marks.length > 1 ? Math.abs(marks[1] - marks[0]) : Math.abs(marks[0]) || 1;
  return Math.min(8, Math.max(0, Math.ceil(-Math.log10(step) - 1e-6)));
}
