// Tables of numbers from the page, as packing.py wrote them.

const STEPS_IN_BYTE = 256;

/** A table (rows, columns): 16-bit numbers in the range of each column. */
class Table {
  constructor(entry, body, at) {
    this.rows = entry.rows;
    this.columns = entry.columns;
    const n = this.columns;
    const ranges = new Float32Array(body.slice(at, at + 8 * n).buffer);
    this.low = ranges.subarray(0, n);
    this.step = ranges.subarray(n, 2 * n);
    const size = this.rows * n;
    const high = at + 8 * n;
    this.numbers = new Uint16Array(size);
    for (let i = 0; i < size; i++) {
      const change = STEPS_IN_BYTE * body[high + i] + body[high + size + i];
      this.numbers[i] = (i < n ? 0 : this.numbers[i - n]) + change; // modulo 65536, as it was written
    }
  }

  at(row, column) {
    return this.low[column] + this.step[column] * this.numbers[row * this.columns + column];
  }

  /** Write the row between `row` and the next one (share from 0 to 1) into `out`. */
  mix(row, share, out) {
    const a = row * this.columns;
    const b = Math.min(row + 1, this.rows - 1) * this.columns;
    for (let i = 0; i < this.columns; i++) {
      const from = this.numbers[a + i];
      out[i] = this.low[i] + this.step[i] * (from + share * (this.numbers[b + i] - from));
    }
    return out;
  }
}

function fromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  return Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
}

export async function readTables(text) {
  const packed = new Blob([fromBase64(text)]).stream().pipeThrough(new DecompressionStream("deflate"));
  const body = new Uint8Array(await new Response(packed).arrayBuffer());
  const start = 4 + new DataView(body.buffer).getUint32(0, true);
  const directory = JSON.parse(new TextDecoder().decode(body.subarray(4, start)));
  const tables = {};
  for (const [name, entry] of Object.entries(directory)) tables[name] = new Table(entry, body, start + entry.offset);
  return tables;
}

/** Where a time lies among increasing times: [row, share on the way to the next]. */
export function placeOf(time, times) {
  let low = 0;
  let high = times.length - 1;
  if (high < 1 || time <= times[0]) return [0, 0];
  if (time >= times[high]) return [high, 0];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return [low, (time - times[low]) / (times[high] - times[low])];
}
