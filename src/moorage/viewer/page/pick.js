// What is under the pointer: signs first, then lines.

const REACH = 11; // pixels

/** The nearest sign or place on a line: {marker} or {line, node, share}, or null. */
export function pick(stage, x, y, markers, lines, nodes) {
  const m = stage.matrix();
  let best = null;
  let reach = REACH;
  for (let i = 0; i < markers.length / 3; i++) {
    const p = stage.pixel(markers[3 * i], markers[3 * i + 1], markers[3 * i + 2], m);
    const away = p ? Math.hypot(p[0] - x, p[1] - y) : Infinity;
    if (away < reach) [best, reach] = [{ marker: i }, away];
  }
  if (best) return best;
  lines.forEach(({ first, last }, line) => {
    let before = null;
    for (let node = first; node <= last; node++) {
      const p = stage.pixel(nodes[4 * node], nodes[4 * node + 1], nodes[4 * node + 2], m);
      if (p && before) {
        const [dx, dy] = [p[0] - before[0], p[1] - before[1]];
        const size = dx * dx + dy * dy;
        const share = size ? Math.min(Math.max(((x - before[0]) * dx + (y - before[1]) * dy) / size, 0), 1) : 0;
        const away = Math.hypot(before[0] + share * dx - x, before[1] + share * dy - y);
        if (away < reach) [best, reach] = [{ line, node: node - 1, share }, away];
      }
      before = p;
    }
  });
  return best;
}
