// Numbers for people: round ticks, digits that matter.

/** Round values that cut a range into about `count` parts. */
export function ticks(low, high, count) {
  const step = roundStep((high - low) / count);
  const out = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) out.push(k * step);
  return out;
}

/** The round number (1, 2 or 5 times a power of ten) that is no smaller than `size`. */
export function roundStep(size) {
  const power = 10 ** Math.floor(Math.log10(Math.max(size, 1e-12)));
  return power * ([1, 2, 5].find((v) => v * power >= size * (1 - 1e-9)) ?? 10);
}

/** Text of a value with as many digits as ticks of that step need, or three figures. */
export function words(value, step = 0) {
  const size = Math.abs(value);
  if (size > 0 && ((size >= 1e6 && !step) || (size < 1e-3 && !(step >= 1e-3))))
    return value.toExponential(step ? 0 : 2).replace("-", "−");
  const digits = step
    ? Math.max(0, -Math.floor(Math.log10(step) + 1e-9))
    : Math.max(0, 2 - Math.floor(Math.log10(size || 1)));
  return value.toFixed(Math.min(digits, 6)).replace("-", "−");
}

/** Text of a value without the zeros that say nothing. */
export function short(value) {
  return String(Number(value.toPrecision(4))).replace("-", "−");
}

export function withUnit(value, unit) {
  return unit ? `${words(value)} ${unit}` : words(value);
}
