// The page: reads its data, shows it, and tells when it is ready.

import { App } from "./app.js";
import { connect, help } from "./controls.js";
import { readTables } from "./data.js";

/** What tests and other scripts may ask of a page. */
function hook(app) {
  return {
    app,
    help,
    ready: performance.now(),
    setTime: (time) => app.setTime(time),
    node: (i) => Array.from(app.nodes.subarray(3 * i, 3 * i + 3)),
    value: (key, i) => app.values[key][i],
    elevation: (x, y, time) => app.sea.elevation(x, y, time),
    pixel: (x, y, z) => app.stage.pixel(x, y, z),
    script: () => {
      const sorted = [...app.spent].sort((a, b) => a - b);
      const mean = sorted.reduce((a, b) => a + b, 0) / sorted.length;
      return {
        frames: sorted.length,
        mean,
        p95: sorted[Math.floor(0.95 * (sorted.length - 1))],
        most: sorted[sorted.length - 1],
      };
    },
    clear: () => (app.spent = []),
  };
}

async function main() {
  try {
    const meta = JSON.parse(document.getElementById("meta").textContent);
    const app = new App(meta, await readTables(document.getElementById("data").textContent));
    connect(app);
    app.look("overview", 0);
    app.frame(performance.now());
    window.moorage = hook(app);
    document.documentElement.dataset.ready = window.moorage.ready.toFixed(0);
    document.getElementById("wait").remove();
  } catch (error) {
    document.getElementById("wait").textContent =
      `This page needs WebGL 2 and a browser of 2023 or later. (${error.message})`;
    throw error;
  }
}

main();
