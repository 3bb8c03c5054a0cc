const numbers = JSON.parse(document.getElementById("numbers").textContent);
const {aspects} = numbers;
const $ = id => document.getElementById(id);
const home = turnTowards(unit(numbers.model.front), numbers.model.up);
let turn = home, picked = -1, objectTable, sphereTable, sphere;

function element(tag, text, css) {
  const made = document.createElement(tag);
  if (text !== undefined) made.textContent = text;
  if (css) made.className = css;
  return made;
}
const coloured = colour => { const chip = element("i"); chip.style.background = colour; return chip; };
const percent = value => (value >= 0.1 ? value.toFixed(2) : value.toPrecision(2)) + " %";
const direction = v => "(" + v.map(value => (value < 0 ? "−" : "+") + Math.abs(value).toFixed(2)).join(" ") + ")";
const rgb = text => [1, 3, 5].map(k => parseInt(text.slice(k, k + 2), 16));
const styled = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

function unpacked(text, Type) {
  const letters = atob(text), bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; ++k) bytes[k] = letters.charCodeAt(k);
  return new Type(bytes.buffer);
}

// ---- the sphere's mesh
function readSphere() {
  const points = Float32Array.from(unpacked(numbers.sphere.points, Int16Array), value => value / 32767);
  const corners = unpacked(numbers.sphere.corners, Uint32Array);
  const point = k => points.subarray(3 * k, 3 * k + 3);
  // No corner of a piece is farther from any of its points than its longest side.
  let reach = 1;
  for (let k = 0; k < corners.length; k += 3)
    for (let i = 0; i < 3; ++i)
      reach = Math.min(reach, dot(point(corners[k + i]), point(corners[k + (i + 1) % 3])));
  return {points, corners, point, reach: reach - 0.001, of: unpacked(numbers.sphere.aspects, Int16Array),
          borders: unpacked(numbers.sphere.borders, Uint32Array),
          sides: unpacked(numbers.sphere.sides, Uint32Array)};
}

// The aspect seen from a direction, -1: none.
function aspectAt(d) {
  const {points, corners, of, reach} = sphere;
  const side = (a, b) => d[0] * (points[a + 1] * points[b + 2] - points[a + 2] * points[b + 1]) +
                         d[1] * (points[a + 2] * points[b] - points[a] * points[b + 2]) +
                         d[2] * (points[a] * points[b + 1] - points[a + 1] * points[b]);
  for (let k = 0; k < of.length; ++k) {
    const a = 3 * corners[3 * k];
    if (d[0] * points[a] + d[1] * points[a + 1] + d[2] * points[a + 2] < reach) continue;
    const b = 3 * corners[3 * k + 1], c = 3 * corners[3 * k + 2];
    if (side(a, b) >= -1e-6 && side(b, c) >= -1e-6 && side(c, a) >= -1e-6) return of[k];
  }
  return -1;
}

// ---- what is drawn
function colourOfAspect(k) {
  const card = rgb(styled("--card")), mixed = (colour, share) =>
    colour.map((value, c) => Math.round(value * share + card[c] * (1 - share)));
  if (k < 0) return rgb(styled("--none"));
  if (k === picked) return [11, 99, 206];
  return mixed(rgb(aspects[k].colour), aspects[k].in_index ? 1 : 0.35);
}

// Places stay as they are from aspect to aspect: only colours are made and sent anew.
function drawSphereSurface() {
  const {corners, of, point} = sphere;
  if (!sphere.surface) {
    sphere.surface = new Corners(corners.length);
    for (const corner of corners) {
      const p = point(corner);
      sphere.surface.add(p, p, [0, 0, 0]);
    }
  }
  const colours = new Map(), {colour} = sphere.surface;
  for (let k = 0; k < of.length; ++k) {
    if (!colours.has(of[k])) colours.set(of[k], colourOfAspect(of[k]));
    for (let i = 0; i < 3; ++i) colour.set(colours.get(of[k]), 9 * k + 3 * i);
  }
  sphereTable.set("surface", sphere.surface);
}

function drawBorders() {
  const {borders, point} = sphere, made = new Corners(3 * borders.length), colour = [66, 73, 84];
  for (let k = 0; k < borders.length; k += 2)
    made.addStrip(scaled([...point(borders[k])], 1.0015), scaled([...point(borders[k + 1])], 1.0015), 0.006, colour);
  sphereTable.set("borders", made);
}

function drawPatches() {
  if (!$("show_patches").checked) return sphereTable.set("patches");
  const {sides, point} = sphere, made = new Corners(sides.length), none = [0, 0, 0];
  for (const end of sides) made.add(scaled([...point(end)], 1.001), none, [120, 60, 60]);
  sphereTable.set("patches", made, true);
}

function drawMarks() {
  const kinds = {right: [27, 94, 156], near: [185, 119, 14], wrong: [192, 57, 43]};
  const tried = $("show_tried").checked ? numbers.tried_views : [];
  const dots = new Corners(6 * tried.length);
  for (const view of tried) {
    const size = view.kind === "wrong" ? 0.05 : 0.03, [right] = turnTowards(view.from, [0.3, 0.5, 0.8]);
    const at = sign => scaled(unit(view.from.map((value, k) => value + sign * size / 2 * right[k])), 1.006);
    dots.addStrip(at(-1), at(1), size, kinds[view.kind]);
  }
  sphereTable.set("tried", dots);
  const spots = $("show_blind").checked ? numbers.blind_spots : [], steps = 72;
  const circles = new Corners(6 * steps * spots.length);
  for (const spot of spots) {
    const [x, y, z] = turnTowards(spot.from, [0.3, 0.5, 0.8]), radius = Math.max(spot.radius_deg, 1) * Math.PI / 180;
    const at = step => [0, 1, 2].map(k => 1.004 * (Math.cos(radius) * z[k] + Math.sin(radius) *
      (Math.cos(2 * Math.PI * step / steps) * x[k] + Math.sin(2 * Math.PI * step / steps) * y[k])));
    for (let step = 0; step < steps; ++step) circles.addStrip(at(step), at(step + 1), 0.014, [27, 31, 36]);
  }
  sphereTable.set("blind", circles);
}

// Flat facets, round where neighbours of one colour bend by less than 35 degrees.
function drawObject() {
  const {vertices, triangles, paints} = numbers.model, count = triangles.length / 4;
  const corner = k => vertices.slice(3 * k, 3 * k + 3), normals = [], around = new Map();
  for (let t = 0; t < count; ++t) {
    const [a, b, c] = [0, 1, 2].map(k => corner(triangles[4 * t + k]));
    const less = (p, q) => p.map((value, k) => value - q[k]);
    normals.push(unit(cross(less(b, a), less(c, a))));
    for (let k = 0; k < 3; ++k) {
      const key = triangles[4 * t + k] + " " + triangles[4 * t + 3];
      around.has(key) ? around.get(key).push(t) : around.set(key, [t]);
    }
  }
  const made = new Corners(3 * count);
  for (let t = 0; t < count; ++t) {
    const paint = triangles[4 * t + 3], colour = paints.slice(3 * paint, 3 * paint + 3);
    for (let k = 0; k < 3; ++k) {
      const sum = [0, 0, 0];
      for (const other of around.get(triangles[4 * t + k] + " " + paint)) {
        const bend = dot(normals[t], normals[other]);
        if (Math.abs(bend) > 0.82) for (let i = 0; i < 3; ++i) sum[i] += Math.sign(bend) * normals[other][i];
      }
      made.add(corner(triangles[4 * t + k]), unit(sum), colour);
    }
  }
  objectTable.set("object", made);
}

// Axes face the eye, so they are made anew for every turn.
function drawAxes() {
  const labels = document.querySelector(".labels");
  const axes = $("show_axes").checked ? numbers.axes : [];
  labels.replaceChildren();
  const made = new Corners(6 * axes.length), none = [0, 0, 0], colour = rgb(styled("--bad"));
  for (const axis of axes) {
    const side = cross(turn[2], axis.direction);
    const thick = Math.hypot(...side) > 1e-3 ? scaled(unit(side), 0.008) : scaled(turn[0], 0.008);
    const at = (along, sign) => axis.direction.map((value, k) => along * value + sign * thick[k]);
    for (const [along, sign] of [[-1.25, 1], [-1.25, -1], [1.25, -1], [-1.25, 1], [1.25, -1], [1.25, 1]])
      made.add(at(along, sign), none, colour);
    const end = scaled(axis.direction, dot(axis.direction, turn[2]) < -0.2 ? -1.33 : 1.33);
    const label = element("span", axis.fold ? axis.fold + "-fold" : "any angle");
    label.style.left = 50 + 50 * objectTable.scale * dot(end, turn[0]) + "%";
    label.style.top = 50 - 50 * objectTable.scale * dot(end, turn[1]) + "%";
    labels.append(label);
  }
  objectTable.set("axes", made);
}

let isDue = false;
function draw() {
  if (!sphereTable || isDue) return;
  isDue = true;
  requestAnimationFrame(() => {
    isDue = false;
    drawAxes();
    objectTable.draw(turn);
    sphereTable.draw(turn);
    const ready = document.documentElement.dataset;
    ready.readyMs ??= performance.now();
    const seen = aspectAt(turn[2]);
    $("looking").textContent = "seen from " + direction(turn[2]) + ": " +
      (seen < 0 ? "no aspect" : "aspect " + seen + (aspects[seen].in_index ? "" : ", not in the index"));
  });
}

// ---- turning
let moving = 0;
function turnTo(goal) {
  cancelAnimationFrame(moving);
  const start = turn, begin = performance.now();
  const wait = matchMedia("(prefers-reduced-motion: reduce)").matches ? 1 : 300;
  const step = () => {
    const share = Math.min((performance.now() - begin) / wait, 1), eased = share * share * (3 - 2 * share);
    const mix = k => start[k].map((value, i) => value * (1 - eased) + goal[k][i] * eased);
    let towards = mix(2), up = mix(1);
    if (Math.hypot(...towards) < 1e-3) towards = goal[2];
    towards = unit(towards);
    let right = cross(up, towards);
    right = unit(Math.hypot(...right) < 1e-3 ? goal[0] : right);
    turn = share < 1 ? [right, cross(towards, right), towards] : goal;
    draw();
    if (share < 1) moving = requestAnimationFrame(step);
  };
  if (sphereTable) step(); else turn = goal;
}
const lookFrom = from => turnTo(turnTowards(unit(from), numbers.model.up));

function takeHold(table, clicked) {
  const {canvas} = table;
  let last = null, moved = 0;
  canvas.addEventListener("pointerdown", event => {
    cancelAnimationFrame(moving);
    canvas.setPointerCapture(event.pointerId);
    last = [event.clientX, event.clientY];
    moved = 0;
  });
  canvas.addEventListener("pointermove", event => {
    if (!last) return;
    const across = event.clientX - last[0], down = event.clientY - last[1];
    moved += Math.abs(across) + Math.abs(down);
    last = [event.clientX, event.clientY];
    const speed = 2 / (canvas.clientWidth * table.scale);
    turn = turnedBy(turn, across * speed, down * speed);
    draw();
  });
  const release = event => {
    if (last && moved < 4 && event.type === "pointerup" && clicked) clicked(table.at(event));
    last = null;
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("keydown", event => {
    const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
    if (!step) return;
    event.preventDefault();
    turn = turnedBy(turn, step[0] * 0.12, step[1] * 0.12);
    draw();
  });
}

function pickOnSphere([x, y]) {
  const rest = 1 - x * x - y * y;
  if (rest < 0) return;
  const z = Math.sqrt(rest), seen = aspectAt([0, 1, 2].map(k => x * turn[0][k] + y * turn[1][k] + z * turn[2][k]));
  if (seen >= 0) pick(seen);
}

// ---- one aspect
function showFacts(aspect) {
  const touching = aspect.neighbours.filter(([, , gap]) => gap === 0).length;
  const facts = [["area", percent(aspect.percent) + " of the sphere"],
    ["in uniform patches", percent(aspect.uniform_percent)],
    ["views", aspect.views_seen.toLocaleString("en").replaceAll(",", "\u202f")],
    ["typical view", aspect.from ? direction(aspect.from) : "–"],
    ["contours", aspect.contours.length],
    ["neighbours", touching + " touching, " + (aspect.neighbours.length - touching) + " across a strip"],
    ["in the index", aspect.in_index ? "yes" : "left out by the budget"]];
  $("aspect_facts").replaceChildren(...facts.map(([name, value]) => {
    const box = element("div");
    box.append(element("dt", name), element("dd", value));
    return box;
  }));
}

function showViews(aspect) {
  $("views").replaceChildren(...aspect.views.map((view, k) => {
    const figure = element("figure"), frame = element("div", undefined, "frame");
    const caption = element("figcaption"), look = element("button", direction(view.from), "link");
    frame.innerHTML = view.svg;
    look.onclick = () => lookFrom(view.from);
    caption.append(look, (k === 0 ? " typical" : "") + (view.in_index ? " · key view of the index" : ""));
    figure.append(frame, caption);
    return figure;
  }));
}

function showContours(aspect) {
  const head = element("tr");
  for (const [name, meaning] of [["contour", "its name in all views of the aspect"],
      ["area", "of the outline's, in the typical view"],
      ["x", "to the right of the outline's middle, in square roots of its area"], ["y", "down, as x"],
      ["shape", "by its affine moment invariant"], ["types", "contour types that it was seen as"],
      ["surfaces", "of the scene, that it shows"]]) {
    const cell = element("th", name);
    cell.title = meaning;
    head.append(cell);
  }
  const rows = aspect.contours.map(contour => {
    const row = element("tr"), name = element("td");
    const chip = coloured(contour.colour);
    chip.className = "chip";
    name.append(chip, contour.name);
    row.dataset.contour = contour.name;
    row.append(name);
    const value = (number, digits) => number === undefined ? "–" : number.toFixed(digits);
    for (const text of [value(contour.area_percent, 1) + " %", value(contour.x, 2), value(contour.y, 2),
                        contour.shape ?? "–", contour.types,
                        (contour.surface_names ?? contour.surfaces).join(", ")]) row.append(element("td", text));
    return row;
  });
  $("contours").replaceChildren(head, ...rows);
}

function showNeighbours(aspect) {
  const buttons = aspect.neighbours.map(([other, length, gap]) => {
    const button = element("button");
    button.dataset.aspect = other;
    button.append(coloured(aspects[other].colour), "aspect " + other + " ",
      element("small", length.toFixed(0) + "°" + (gap ? ", " + gap + (gap === 1 ? " patch" : " patches") + " between" : "")));
    return button;
  });
  $("neighbours").replaceChildren(...(buttons.length ? buttons : [element("span", "none", "faint")]));
}

function pick(k) {
  picked = k;
  const aspect = aspects[k];
  $("aspect_title").replaceChildren(coloured(aspect.colour), "Aspect " + k + " of " + aspects.length);
  $("aspect_title").firstChild.className = "chip";
  showFacts(aspect);
  showViews(aspect);
  $("graph").innerHTML = aspect.graph;
  showContours(aspect);
  showNeighbours(aspect);
  $("previous").disabled = k === 0;
  $("next").disabled = k === aspects.length - 1;
  for (const path of document.querySelectorAll("#halves .aspect"))
    path.classList.toggle("picked", Number(path.dataset.aspect) === k);
  for (const button of $("aspects").children) {
    const isPicked = Number(button.dataset.aspect) === k;
    button.setAttribute("aria-selected", isPicked);
    if (!isPicked) continue;
    const list = $("aspects"), top = button.offsetTop - list.offsetTop;
    if (top < list.scrollTop || top + button.offsetHeight > list.scrollTop + list.clientHeight)
      list.scrollTop = top - list.clientHeight / 2;
  }
  history.replaceState(null, "", "#aspect-" + k);
  if (sphereTable) drawSphereSurface();
  draw();
}

// A contour is marked wherever it is seen.
function markContour(name) {
  for (const node of document.querySelectorAll("#aspect [data-contour], #graph [data-between]"))
    node.classList.toggle("marked", name !== undefined && (node.dataset.contour === name ||
      (node.dataset.between ?? "").split(" ").includes(name)));
}

// ---- beginning
function listAspects() {
  $("aspects").replaceChildren(...aspects.map((aspect, k) => {
    const button = element("button", undefined, aspect.in_index ? "" : "out");
    button.dataset.aspect = k;
    button.setAttribute("role", "option");
    button.append(coloured(aspect.colour), "aspect " + k,
      element("small", percent(aspect.percent)));
    return button;
  }));
}

function filterAspects() {
  const wanted = $("filter").value.trim().toLowerCase();
  for (const button of $("aspects").children) {
    const k = Number(button.dataset.aspect);
    const surfaces = aspects[k].contours.flatMap(contour => contour.surface_names ?? []);
    button.hidden = wanted !== "" && !String(k).startsWith(wanted) &&
      !surfaces.some(name => name.toLowerCase().includes(wanted));
  }
}

function startTables() {
  objectTable = Turntable.on($("object"), numbers.axes.length ? 0.7 : 0.92, 0.6);
  sphereTable = objectTable && Turntable.on($("sphere"), 0.92, 0.7);
  if (!sphereTable) {
    document.body.classList.add("without_webgl");
    $("no_webgl").hidden = false;
    return;
  }
  sphere = readSphere();
  drawObject();
  $("too_fine").hidden = numbers.model.triangles.length > 0;
  drawBorders();
  takeHold(objectTable);
  takeHold(sphereTable, pickOnSphere);
  new ResizeObserver(draw).observe($("stage"));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    drawSphereSurface();
    draw();
  });
}

function showSwitches() {
  document.body.classList.toggle("hide_tried", !$("show_tried").checked);
  document.body.classList.toggle("hide_blind", !$("show_blind").checked);
  if (sphereTable) { drawPatches(); drawMarks(); }
  draw();
}

document.addEventListener("click", event => {
  const target = event.target.closest("[data-aspect], [data-from]");
  if (!target) return;
  if (target.dataset.from) {
    lookFrom(target.dataset.from.split(" ").map(Number));
    return $("stage").scrollIntoView({behavior: "smooth", block: "nearest"});
  }
  pick(Number(target.dataset.aspect));
  if (target.matches("button.link, .cell")) $("aspect").scrollIntoView({behavior: "smooth", block: "nearest"});
});
document.addEventListener("pointerover", event =>
  markContour(event.target.closest?.("#aspect [data-contour]")?.dataset.contour));
$("previous").onclick = () => pick(picked - 1);
$("next").onclick = () => pick(picked + 1);
$("turn").onclick = () => aspects[picked].from && lookFrom(aspects[picked].from);
$("home").onclick = () => turnTo(home);
$("filter").oninput = filterAspects;
for (const id of ["show_patches", "show_axes", "show_tried", "show_blind"]) $(id).onchange = showSwitches;

listAspects();
startTables();
showSwitches();
const wanted = Number(location.hash.replace("#aspect-", ""));
pick(Number.isInteger(wanted) && wanted >= 0 && wanted < aspects.length ? wanted : 0);
