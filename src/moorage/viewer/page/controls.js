// What people do: the bar, the panel, the pointer and the keys.

import { short } from "./numbers.js";
import { pick } from "./pick.js";
import { VIEWS } from "./stage.js";
import { facts, lineWords, markerWords } from "./words.js";

const find = (id) => document.getElementById(id);

/** Connect the elements of the page to an app. */
export function connect(app) {
  const { meta } = app;
  const on = (id, event, act) => find(id).addEventListener(event, act);
  find("title").textContent = meta.title;
  find("facts").textContent = facts(app);
  find("notes").innerHTML = "";
  for (const note of meta.notes) find("notes").appendChild(document.createElement("li")).textContent = note;
  for (const q of meta.quantities) find("quantity").add(new Option(q.unit ? `${q.label} (${q.unit})` : q.label, q.key));
  document.body.classList.toggle("still", !meta.moving);
  find("colours").hidden = !meta.lines.length;
  Object.assign(find("slider"), { min: app.times[0], max: app.times[app.times.length - 1], value: app.times[0] });
  find("end").textContent = short(app.times[app.times.length - 1]);
  find("speed").value = app.state.speed = app.duration > 240 ? 5 : 1;
  on("slider", "input", (e) => app.setTime(Number(e.target.value)));
  on("play", "click", () => app.play(!app.state.playing));
  on("speed", "change", (e) => (app.state.speed = Number(e.target.value)));
  on("quantity", "change", (e) => app.setQuantity(e.target.value));
  on("stretch", "change", (e) => app.setStretch(Number(e.target.value)));
  on("save", "click", () => app.save());
  on("ask", "click", () => help(find("help").hidden));
  on("help", "click", () => help(false));
  document.querySelectorAll("[data-view]").forEach((b) => b.addEventListener("click", () => app.look(b.dataset.view)));
  app.panel.find("close").addEventListener("click", () => app.select(null));
  for (const part of ["over", "along"]) {
    app.panel.find(part).addEventListener("click", () => {
      app.panel.along = part === "along";
      app.panel.draw(app.state.time, app.state.quantity, app.values[app.state.quantity.key]);
      app.stale = true;
    });
  }
  app.panel.plot.canvas.addEventListener("click", (e) => {
    if (!app.panel.along) app.setTime(app.panel.plot.under(e.offsetX));
  });
  pointer(app);
  window.addEventListener("keydown", (e) => key(app, e));
  new ResizeObserver(() => app.stage.resize()).observe(app.stage.canvas);
}

/** Show what is under a pixel, and return it. */
function hover(app, x, y) {
  const found = pick(app.stage, x, y, app.markers.data, app.meta.lines, app.lines.data);
  const tip = find("tip");
  const other = found ? null : otherName(app, x, y);
  tip.hidden = !found && !other;
  app.stage.canvas.style.cursor = found?.line !== undefined ? "pointer" : "";
  if (tip.hidden) return null;
  if (other) tip.textContent = other;
  else tip.innerHTML = found.marker !== undefined ? markerWords(app, found.marker) : lineWords(app, found);
  const left = x + 16 + tip.offsetWidth > app.stage.size.width ? x - 16 - tip.offsetWidth : x + 16;
  const top = Math.min(y + 12, app.stage.size.height - tip.offsetHeight - 8);
  tip.style.transform = `translate(${left}px, ${top}px)`;
  return found;
}

/** The name of the rod or body under a pixel. */
function otherName(app, x, y) {
  const rods = app.meta.rods.map((_, k) => ({ first: 2 * k, last: 2 * k + 1 }));
  const places = app.meta.bodies.flatMap((_, k) => Array.from(app.bodies.data.subarray(6 * k, 6 * k + 3)));
  const found = pick(app.stage, x, y, places, rods, app.rods.data);
  if (!found) return null;
  return (found.marker !== undefined ? app.meta.bodies[found.marker] : app.meta.rods[found.line]).name;
}

function pointer(app) {
  const canvas = app.stage.canvas;
  let down = null;
  canvas.addEventListener("pointermove", (e) => {
    if (!e.buttons) hover(app, e.offsetX, e.offsetY);
    else find("tip").hidden = true;
  });
  canvas.addEventListener("pointerleave", () => (find("tip").hidden = true));
  canvas.addEventListener("pointerdown", (e) => (down = [e.offsetX, e.offsetY]));
  canvas.addEventListener("pointerup", (e) => {
    if (!down || Math.hypot(e.offsetX - down[0], e.offsetY - down[1]) > 4) return;
    const found = hover(app, e.offsetX, e.offsetY);
    if (found?.line !== undefined) app.select(found.line);
    else if (!found) app.select(null);
  });
}

function key(app, e) {
  const { meta } = app;
  if (e.ctrlKey || e.metaKey || e.altKey) return;
  const quantities = meta.quantities.map((q) => q.key);
  const stretches = Array.from(find("stretch").options, (option) => Number(option.value));
  const steps = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -10, ArrowUp: 10 };
  const act =
    e.key in steps
      ? () => app.setTime(app.state.time + steps[e.key] * (e.shiftKey ? 10 : 1) * app.nudge)
      : ({
          " ": () => app.play(!app.state.playing),
          Home: () => app.setTime(app.times[0]),
          End: () => app.setTime(app.times[app.times.length - 1]),
          "?": () => help(find("help").hidden),
          Escape: () => (find("help").hidden ? app.select(null) : help(false)),
          c: () => app.setQuantity(next(quantities, app.state.quantity.key)),
          l: () => app.select(next([...meta.lines.keys(), null], app.state.picked)),
          v: () => app.setStretch(next(stretches, app.stage.stretch)),
          p: () => app.save(),
        }[e.key] ??
        (VIEWS[Number(e.key) - 1] && (() => app.look(VIEWS[Number(e.key) - 1]))));
  if (!act || (e.target.tagName === "SELECT" && e.key in steps)) return;
  if (e.key === " " && e.target.tagName === "BUTTON" && e.target.id !== "play") return; // the button's own press
  e.preventDefault();
  act();
}

/** Open or close the help. */
export function help(open) {
  find("help").hidden = !open;
}

function next(values, value) {
  return values[(values.indexOf(value) + 1) % values.length];
}
