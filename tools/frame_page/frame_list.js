// All frames: what each shows, which are shown, and in what order. Pictures are not decoded before
// they are near the window.
const place = id => document.getElementById(id);
const batch = contentOf(blocks("batch")[0]), end = contentOf(blocks("end")[0]);
const detailBlocks = blocks("details"), pictureBlocks = blocks("picture");
const frames = blocks("frame").map((block, k) => ({ ...contentOf(block), k }));

function element(tag, css, ...content) {
  const made = document.createElement(tag);
  if (css) made.className = css;
  made.append(...content.filter(part => part !== undefined && part !== null));
  return made;
}

function svgElement(tag, attributes) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

// An object keeps its colour from frame to frame.
const palette = ["#4da3ff", "#ffb02e", "#3ddc97", "#ff6f91", "#b28dff", "#f4e04d", "#4dd8e6",
                 "#ff8f5c", "#a3d65c", "#e07be0"];
const objectNames = [...new Set([...models.keys(), ...frames.flatMap(frame =>
  frame.objects.map(object => object.object).filter(Boolean))])].sort();
const colourOf = name => palette[objectNames.indexOf(name) % palette.length];

// What is named: unknown things are not, whatever they are most like.
const isNamed = object => object.object !== undefined && object.verdict !== "unknown";
const nameOf = object => isNamed(object) ? object.object : "unknown";
const colourOfObject = object => isNamed(object) ? colourOf(object.object) : "#9aa3ad";
const surely = object => object.p !== undefined ? (100 * object.p).toFixed(1) + " %"
  : object.score !== undefined ? "score " + Number(object.score.toPrecision(4)) : "";
const count = (number, one, more) => `${number.toLocaleString("en")} ${number === 1 ? one : more}`;

// --- what a frame is to be found by
const kErrors = ["to 5°", "5 to 20°", "over 20°", "missed or wrong", "falsely named",
                 "nothing there", "no truth"];

function errorsOf(frame) {
  if (!batch.truth) return new Set();
  if (!frame.truth) return new Set(["no truth"]);
  const kinds = new Set();
  for (const object of frame.truth) {
    if (object.truth === undefined) kinds.add("falsely named");
    else if (!object.counts) continue;
    else if (!object.right) kinds.add("missed or wrong");
    else kinds.add(object.deg <= 5 ? "to 5°" : object.deg <= 20 ? "5 to 20°" : "over 20°");
  }
  return kinds.size ? kinds : new Set(["nothing there"]);
}

// The worst of a frame, the more the worse; a view is off by 180 degrees at most.
function badness(frame) {
  let worst = -1;
  for (const object of frame.truth ?? [])
    if (object.truth === undefined) worst = Math.max(worst, 500);
    else if (object.counts) worst = Math.max(worst, object.right ? object.deg : 1000);
  return worst;
}

function verdictsOf(frame) {
  if (frame.error !== undefined) return new Set(["unreadable"]);
  if (frame.objects.length === 0) return new Set(["nothing"]);
  return new Set(frame.objects.map(object => object.verdict ?? "no verdict"));
}

for (const frame of frames) {
  frame.found = new Set(frame.objects.filter(isNamed).map(nameOf));
  frame.verdicts = verdictsOf(frame);
  frame.errors = errorsOf(frame);
  frame.badness = badness(frame);
  frame.least = Math.min(...frame.objects.filter(isNamed).map(object => object.p ?? 1), 2);
}

// --- pictures
const watcher = new IntersectionObserver(entries => {
  for (const { target, isIntersecting } of entries) {
    if (!isIntersecting) continue;
    target.src = pictureBlocks[target.frame.k].textContent;
    watcher.unobserve(target);
  }
}, { rootMargin: "400px" });

function boxShape(object, width) {
  const [x, y, w, h] = object.box;
  return svgElement("rect", { x, y, width: w, height: h, stroke: colourOfObject(object),
                              "stroke-width": width });
}

// `parts`: which of boxes and edges; a class each, so that they can be hidden.
function overlayOf(frame, width) {
  const svg = svgElement("svg", { viewBox: `-0.5 -0.5 ${frame.w} ${frame.h}`, "aria-hidden": true });
  const boxes = svgElement("g", { class: "boxes" }), edges = svgElement("g", { class: "edges" });
  for (const object of frame.objects)
    if (isNamed(object) || frame.objects.length < 4) boxes.append(boxShape(object, width));
  if (frame.edges)
    edges.append(
      svgElement("path", { d: frame.edges, stroke: "#101317", "stroke-width": width + 1.6, opacity: .8 }),
      svgElement("path", { d: frame.edges, stroke: "#fff", "stroke-width": width * 0.8 }));
  svg.append(edges, boxes);
  return svg;
}

function pictureOf(frame, width, lazily) {
  const picture = element("span", "picture");
  picture.style.aspectRatio = frame.w && frame.h ? `${frame.w} / ${frame.h}` : "4 / 3";
  const why = frame.error !== undefined ? "cannot be read" : frame.note;
  if (why !== undefined) {
    picture.append(element("span", "gone", why));
  } else {
    const image = element("img");
    image.alt = "";
    image.frame = frame;
    image.decoding = "async";
    if (lazily) watcher.observe(image);
    else image.src = pictureBlocks[frame.k].textContent;
    picture.append(image);
  }
  if (frame.error === undefined) picture.append(overlayOf(frame, width));
  return picture;
}

// --- one card
const fileName = frame => frame.name.slice(frame.name.lastIndexOf("/") + 1);

function errorNote(frame) {
  if (frame.badness < 0) return element("span");
  if (frame.badness >= 1000) return element("span", "bad", "wrong");
  if (frame.badness >= 500) return element("span", "bad", "false");
  const css = frame.badness <= 5 ? "good" : frame.badness <= 20 ? "fair" : "bad";
  return element("span", css, frame.badness.toFixed(1) + "°");
}

function seenRow(object) {
  const row = element("span", "seen"), dot = element("i", "dot");
  dot.style.background = colourOfObject(object);
  const sure = object.verdict === "ambiguous" ? "ambiguous" : isNamed(object) ? surely(object) : "";
  row.append(dot, element("b", "", nameOf(object)), element("small", "", sure));
  return row;
}

function cardOf(frame) {
  const card = element("button", "card"), about = element("span", "about");
  const name = element("span", "", "\u200e" + fileName(frame));
  card.title = frame.name;
  about.append(element("span", "name", name, errorNote(frame)));
  const named = frame.objects.filter(isNamed), others = frame.objects.length - named.length;
  about.append(...named.slice(0, 3).map(seenRow));
  const more = [];
  if (named.length > 3) more.push(`${named.length - 3} more`);
  if (others) more.push(`${others} unknown`);
  if (frame.error !== undefined) more.push("unreadable");
  else if (frame.objects.length === 0) more.push("nothing seen");
  if (more.length) about.append(element("span", "seen faint", more.join(", ")));
  card.append(pictureOf(frame, 1.5, true), about);
  card.onclick = () => { location.hash = frame.k; };
  return card;
}

// --- filters
const chosen = { object: new Set(), verdict: new Set(), error: new Set() };
const sets = { object: "found", verdict: "verdicts", error: "errors" };
const orders = {
  "as replayed": (a, b) => a.k - b.k,
  "by name": (a, b) => a.name < b.name ? -1 : a.name > b.name ? 1 : a.k - b.k,
  "largest error first": (a, b) => b.badness - a.badness || a.k - b.k,
  "least sure first": (a, b) => a.least - b.least || a.k - b.k,
  "slowest first": (a, b) => (b.ms ?? -1) - (a.ms ?? -1) || a.k - b.k,
  "most objects first": (a, b) => b.objects.length - a.objects.length || a.k - b.k,
};
let shown = [];

function fits(frame, but) {
  const words = place("search").value.trim().toLowerCase().split(/\s+/);
  if (!words.every(word => frame.name.toLowerCase().includes(word))) return false;
  return Object.keys(chosen).every(kind => kind === but || chosen[kind].size === 0 ||
    [...chosen[kind]].some(value => frame[sets[kind]].has(value)));
}

// How many frames each choice would show beside those of the other kinds.
function countChips() {
  for (const kind of Object.keys(chosen)) {
    const open = frames.filter(frame => fits(frame, kind));
    for (const chip of place("by-" + kind).children) {
      const number = open.filter(frame => frame[sets[kind]].has(chip.value)).length;
      chip.lastChild.textContent = number.toLocaleString("en");
      chip.classList.toggle("none", number === 0);
      chip.ariaPressed = chosen[kind].has(chip.value);
    }
  }
}

function show() {
  shown = frames.filter(frame => fits(frame)).sort(orders[place("sort").value]);
  place("cards").replaceChildren(...shown.map(frame => frame.card ??= cardOf(frame)));
  place("nothing").hidden = shown.length > 0;
  countChips();
  const of = shown.length < frames.length ? `${shown.length.toLocaleString("en")} of ` : "";
  const notes = [of + count(frames.length, "frame", "frames")];
  const unreadable = frames.filter(frame => frame.error !== undefined).length;
  if (unreadable) notes.push(`${unreadable} unreadable`);
  const gone = frames.filter(frame => frame.note !== undefined).length;
  if (gone) notes.push(`${gone} without their picture`);
  // Frames without a line could not be read, or were left out.
  const gaps = frames.reduce((sum, frame, k) =>
    sum + (k && frame.n > frames[k - 1].n ? frame.n - frames[k - 1].n - 1 : 0), 0);
  if (gaps) notes.push(`${gaps.toLocaleString("en")} between them without a line`);
  if (end.missing) notes.push(`${end.missing} of the truth table not among them`);
  place("count").textContent = notes.join(" · ");
}

function makeChips(kind, values, colourFor) {
  place("by-" + kind).append(...values.map(value => {
    const chip = element("button"), dot = element("i", "dot");
    chip.value = value;
    chip.type = "button";
    if (colourFor) { dot.style.background = colourFor(value); chip.append(dot); }
    chip.append(value, element("small"));
    chip.onclick = () => {
      if (!chosen[kind].delete(value)) chosen[kind].add(value);
      show();
    };
    return chip;
  }));
}

function showAll() {
  for (const kind of Object.keys(chosen)) chosen[kind].clear();
  place("search").value = "";
  show();
}

const present = kind => new Set(frames.flatMap(frame => [...frame[sets[kind]]]));
document.title = place("title").textContent = batch.title || "Frames";
makeChips("object", [...present("object")].sort(), colourOf);
const verdicts = present("verdict"), errors = present("error");
makeChips("verdict", ["match", "ambiguous", "unknown", "no verdict", "nothing", "unreadable"]
  .filter(value => verdicts.has(value)));
makeChips("error", kErrors.filter(value => errors.has(value)));
place("sort").append(...Object.keys(orders)
  .filter(name => batch.truth || name !== "largest error first").map(name => new Option(name)));
place("search").oninput = place("sort").onchange = show;
place("all").onclick = showAll;
show();
