// What the page says of points, lines and the run.

import { short, withUnit, words } from "./numbers.js";

export function markerWords(app, k) {
  const { name, kind } = app.meta.markers[k];
  const place = Array.from(app.markers.data.subarray(3 * k, 3 * k + 3));
  const [x, y, z] = place.map((v, axis) => words(v + (app.meta.origin[axis] ?? 0), app.fine));
  const title = document.createElement("b");
  title.textContent = name;
  const how = kind.startsWith("coupled") ? "moved" : kind;
  return `${title.outerHTML} <span>${how}</span><br>x ${x} &nbsp; y ${y} &nbsp; z ${z} m`;
}

export function lineWords(app, { line, node, share }) {
  const { name, first, arc } = app.meta.lines[line];
  const s = arc[node - first] + share * (arc[node - first + 1] - arc[node - first]);
  const z = app.nodes[3 * node + 2] + share * (app.nodes[3 * node + 5] - app.nodes[3 * node + 2]);
  const title = document.createElement("b");
  title.textContent = name;
  const rows = app.meta.quantities.map((q) => {
    const v = app.values[q.key];
    const text = q.states.length
      ? q.states[Math.round(v[share < 0.5 ? node : node + 1])]
      : withUnit(v[node] + share * (v[node + 1] - v[node]), q.unit);
    return `<tr><td>${q.label}</td><td>${text}</td></tr>`;
  });
  const row = (name, value) => `<tr><td>${name}</td><td>${words(value, app.fine)} m</td></tr>`;
  return `${title.outerHTML}<table>${row("Arc length from end A", s)}${row("z", z)}${rows.join("")}</table>`;
}

export function facts(app) {
  const { meta } = app;
  const nodes = meta.lines.reduce((sum, { first, last }) => sum + last - first, 0);
  const n = meta.lines.length;
  const time = meta.moving
    ? `${short(app.duration)} s, one instant every ${short(app.interval)} s`
    : "static equilibrium";
  return [meta.source, `${n} line${n === 1 ? "" : "s"}, ${nodes} segment${nodes === 1 ? "" : "s"}`, time, meta.sea.asked]
    .filter(Boolean)
    .join(" · ");
}
