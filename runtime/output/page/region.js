// The region of interest: drawn over the picture, dragged with the mouse or typed in.
import {Latest, ask, mayChange} from "./connection.js";

const svg = document.getElementById("region"), inside = document.getElementById("inside"),
      outside = document.getElementById("outside"), fault = document.getElementById("region_fault");
const handles = [...document.querySelectorAll("#handles rect")];
const inputs = ["x", "y", "width", "height"].map(name => document.getElementById("region_" + name));
const kLeast_px = 4;
let frame = {width: 640, height: 480};
let box = null;  // [x, y, width, height]; null: the whole picture
let drag = null;

const sender = new Latest(async region => {
  try {
    await ask("settings", {region_of_interest: region});
    fault.hidden = true;
  } catch (error) {
    fault.textContent = error.message;
    fault.hidden = false;
  }
});

function set(element, values) {
  for (const [name, value] of Object.entries(values)) element.setAttribute(name, value);
}

function show() {
  svg.setAttribute("viewBox", `0 0 ${frame.width} ${frame.height}`);
  const [x, y, width, height] = box ?? [0, 0, frame.width, frame.height];
  const all = `M0 0H${frame.width}V${frame.height}H0Z`;
  outside.setAttribute("d", box ? all + `M${x} ${y}v${height}h${width}v${-height}Z` : "");
  set(inside, {x, y, width, height, visibility: box ? "visible" : "hidden"});
  // Of the same size on the screen, however large the frame is.
  const across = 12 * frame.width / Math.max(1, svg.clientWidth);
  for (const handle of handles) {
    const edges = handle.dataset.edges;
    const u = edges.includes("w") ? 0 : edges.includes("e") ? 1 : 0.5;
    const v = edges.includes("n") ? 0 : edges.includes("s") ? 1 : 0.5;
    set(handle, {x: x + u * width - across / 2, y: y + v * height - across / 2, width: across,
                 height: across, visibility: box ? "visible" : "hidden"});
  }
  inputs.forEach((input, k) => {
    if (document.activeElement !== input) input.value = [x, y, width, height][k];
  });
}

function place(event) {
  const seen = svg.getBoundingClientRect();
  const clamp = (value, most) => Math.round(Math.min(most, Math.max(0, value)));
  return [clamp((event.clientX - seen.left) / seen.width * frame.width, frame.width),
          clamp((event.clientY - seen.top) / seen.height * frame.height, frame.height)];
}

const between = (a, b) => [Math.min(a, b), Math.abs(a - b)];

function dragged([x, y]) {
  const {start, edges, from} = drag;
  if (edges === "move") {
    const [left, top, width, height] = from;
    return [Math.min(frame.width - width, Math.max(0, left + x - start[0])),
            Math.min(frame.height - height, Math.max(0, top + y - start[1])), width, height];
  }
  let [left, top, width, height] = from;
  if (edges.includes("w")) [left, width] = between(x, left + width);
  else if (edges.includes("e")) [left, width] = between(left, x);
  if (edges.includes("n")) [top, height] = between(y, top + height);
  else if (edges.includes("s")) [top, height] = between(top, y);
  return [left, top, width, height];
}

svg.addEventListener("pointerdown", event => {
  if (!mayChange() || event.button !== 0) return;
  const start = place(event), edges = event.target.dataset.edges;
  const kind = edges ?? (event.target === inside ? "move" : "se");
  drag = {start, edges: kind, from: edges || kind === "move" ? box : [...start, 0, 0], before: box};
  svg.setPointerCapture(event.pointerId);
  event.preventDefault();
});
svg.addEventListener("pointermove", event => {
  if (!drag) return;
  const next = dragged(place(event));
  if (next[2] < kLeast_px || next[3] < kLeast_px) return;
  box = next;
  show();
  sender.give(box);
});
for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => { drag = null; });

for (const input of inputs)
  input.addEventListener("change", () => sender.give(inputs.map(each => Number(each.value))));
document.getElementById("whole").addEventListener("click", () => {
  box = null;
  show();
  sender.give(null);
});
new ResizeObserver(show).observe(svg);

export const region = () => box;

export function useRegion(state) {
  svg.classList.toggle("live", mayChange());
  document.getElementById("region_words").textContent =
    state.region_words + (mayChange() ? " Drag in the picture, or type it in." : "");
  for (const input of inputs) input.disabled = !mayChange();
  document.getElementById("whole").disabled = !mayChange();
  if (drag || sender.busy) return;
  box = state.region;
  show();
}

export function useFrame(width, height) {
  if (frame.width === width && frame.height === height) return;
  frame = {width, height};
  show();
}
