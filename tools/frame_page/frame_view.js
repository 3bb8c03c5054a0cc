// One frame: what was seen in it, and why it was taken for that. The first classes beside it are
// the thesis's figure 4.23: the unknown pose on blue, the true one on green, suggestions on yellow.
let open = null;  // {frame, details, object: place, choice: place in its hypotheses}

const percent = share => (100 * share).toFixed(1) + " %";
const screenColour = share => {
  const most = Math.max(...share, 1e-6);
  return "rgb(" + share.map(part => Math.round(235 * part / most)).join(" ") + ")";
};

function swatch(share) {
  const made = element("span", "swatch");
  made.style.background = screenColour(share);
  made.title = "r g b " + share.map(part => part.toFixed(2)).join(" ");
  return made;
}

const hypothesesOf = () => open.details.objects[open.object]?.hypotheses ?? [];
const chosenHypothesis = () => hypothesesOf()[open.choice];

// --- pictures
function toggle(text, css) {
  const box = element("input"), label = element("label", "", box, " " + text);
  box.type = "checkbox";
  box.checked = true;
  box.onchange = () => {
    for (const part of place("explained").querySelectorAll(css))
      part.style.display = box.checked ? "" : "none";
  };
  return label;
}

function frameSection() {
  const { frame } = open, picture = pictureOf(frame, 2, false);
  const svg = picture.querySelector("svg");
  if (svg) {
    svg.append(...(open.details.contours?.shown ?? []).map(contour => svgElement("path", {
      d: contour.path, class: "outline", "data-contour": contour.n, "stroke-width": 3,
      stroke: "var(--mark)", visibility: "hidden" })));
  }
  const toggles = [];
  if (frame.objects.length) toggles.push(toggle("boxes", ".boxes"));
  if (frame.edges) toggles.push(toggle("model", ".edges"));
  return element("section", "picture-box", element("h2", "", "Frame", ...toggles), picture);
}

function labelShape(contour, size) {
  const label = svgElement("text", { x: contour.at[0], y: contour.at[1], "font-size": size,
    "text-anchor": "middle", "dominant-baseline": "central", fill: "#fff", stroke: "#000",
    "stroke-width": 3, "paint-order": "stroke", "font-weight": 600,
    "font-family": "system-ui, sans-serif" });
  label.textContent = nameOfContour(contour.n);
  return label;
}

const letterOf = number => chosenHypothesis()?.contours.find(([n]) => n === number)?.[1];
function nameOfContour(number) {
  const letter = letterOf(number);
  return letter === undefined ? String(number) : `${number} ${letter}`;
}

function contoursSection() {
  const { frame, details } = open, contours = details.contours;
  const picture = element("span", "picture");
  picture.style.aspectRatio = `${frame.w} / ${frame.h}`;
  const svg = svgElement("svg", { viewBox: `-0.5 -0.5 ${frame.w} ${frame.h}` });
  const size = Math.max(frame.w, frame.h) / 30;
  svg.append(...contours.shown.map(contour => svgElement("path", {
    d: contour.path, fill: contour.colour, "fill-rule": "evenodd", stroke: "#fff",
    "stroke-width": 0.8, "data-contour": contour.n })));
  const isMatched = contour => letterOf(contour.n) !== undefined;
  // Names go first to those that mean something, then to the largest, as long as there is room.
  const labelled = [];
  const isFree = contour => labelled.every(({ at: [x, y] }) =>
    Math.abs(x - contour.at[0]) > 2.2 * size || Math.abs(y - contour.at[1]) > 1.1 * size);
  for (const contour of contours.shown) if (isMatched(contour)) labelled.push(contour);
  for (const contour of contours.shown.slice(0, 40))
    if (!isMatched(contour) && isFree(contour)) labelled.push(contour);
  svg.append(...labelled.reverse().map(contour => labelShape(contour, size)));
  picture.append(svg);
  const left = contours.left_out ? `; ${contours.left_out} small ones left out` : "";
  return element("section", "picture-box", element("h2", "", "Contours as segmented",
    element("small", "faint", "number, and letter in the class chosen" + left)), picture);
}

// --- facts
function factsOf(frame, details) {
  const list = element("dl");
  const add = (name, value) => {
    if (value !== undefined) list.append(element("dt", "", name), element("dd", "", value));
  };
  add("size", frame.w ? `${frame.w} × ${frame.h} px` : undefined);
  add("sequence", String(frame.n));
  add("recognised in", frame.ms === undefined ? undefined : frame.ms.toFixed(2) + " ms");
  const stages = Object.entries(details.stages_ms ?? {}).sort((a, b) => b[1] - a[1]);
  if (stages.length) add("most of it", stages.slice(0, 2).map(([name, ms]) => `${name} ${ms}`).join(", "));
  if (details.left_undone)
    add("left undone", Object.entries(details.left_undone).map(([what, n]) => `${n} ${what}`).join(", "));
  if (details.objects_cut) add("objects cut off", String(details.objects_cut));
  for (const object of frame.truth ?? []) add(...truthRow(object));
  return list;
}

function truthRow(object) {
  if (object.truth === undefined)
    return ["named falsely", element("span", "bad", object.found)];
  const name = `true: ${object.truth}`;
  if (object.right) {
    const css = object.deg <= 5 ? "good" : object.deg <= 20 ? "fair" : "bad";
    return [name, element("span", css, `found, ${object.deg.toFixed(1)}° off`)];
  }
  const found = object.found === undefined ? "missed" : "taken for " + object.found;
  return [name, element("span", object.counts ? "bad" : "faint",
                        found + (object.counts ? "" : ", hardly visible"))];
}

function objectsSection() {
  const { frame, details } = open, list = element("div");
  list.id = "objects";
  // What most people look for first.
  const order = [...frame.objects.keys()].sort((a, b) =>
    isNamed(frame.objects[b]) - isNamed(frame.objects[a]) || a - b);
  list.append(...order.map(k => {
    const object = frame.objects[k];
    const button = element("button"), dot = element("i", "dot");
    dot.style.background = colourOfObject(object);
    const track = object.track === undefined ? "" : `#${object.track} `;
    const like = !isNamed(object) && object.object !== undefined ? `, like ${object.object}` : "";
    button.append(dot, element("span", "", track + nameOf(object) + like),
                  element("small", "", [isNamed(object) ? object.verdict : undefined, surely(object)]
                    .filter(Boolean).join(" · ")));
    button.ariaPressed = k === open.object;
    button.onclick = () => { open.object = k; open.choice = 0; explain(); };
    return button;
  }));
  const section = element("section", "", element("h2", "", "Seen"));
  if (frame.error !== undefined) section.append(element("p", "bad", frame.error));
  else if (frame.objects.length === 0) section.append(element("p", "faint", "nothing"));
  section.append(list, factsOf(frame, details));
  return section;
}

// --- the shortlist
function viewCard(css, object, seen, ...words) {
  const card = element(css.includes("guess") ? "button" : "div", "view " + css);
  const canvas = element("canvas");
  if (drawModel(canvas, object, seen)) card.append(canvas);
  card.append(...words);
  return card;
}

// A square of the frame about the object, in the canvas that models are drawn in.
function cutOut(canvas, box) {
  const [x, y, w, h] = box, side = 1.15 * Math.max(w, h);
  const image = place("explained").querySelector(".picture img");
  if (!image) return false;
  canvas.width = canvas.height = 288;
  const draw = () => {
    const scale = image.naturalWidth / open.frame.w, pen = canvas.getContext("2d");
    pen.drawImage(image, (x + w / 2 - side / 2) * scale, (y + h / 2 - side / 2) * scale,
                  side * scale, side * scale, 0, 0, 288, 288);
  };
  if (image.complete && image.naturalWidth) draw();
  else image.addEventListener("load", draw, { once: true });
  return true;
}

function askedCard(object) {
  const card = element("div", "view asked"), canvas = element("canvas");
  if (cutOut(canvas, object.box)) card.append(canvas);
  card.append(element("b", "", "seen"), element("span", "", count(object.regions, "region", "regions")));
  return card;
}

function trueCards(object) {
  return (open.frame.truth ?? []).filter(entry => entry.view && entry.truth === object.object)
    .slice(0, 1).map(entry => viewCard("true", entry.truth, { view: entry.view },
      element("b", "", entry.truth), element("span", "", "the true view")));
}

function guessCard(hypothesis, k, rivals) {
  const score = hypothesis.score <= 1 ? hypothesis.score.toFixed(4)
    : hypothesis.score.toLocaleString("en", { maximumFractionDigits: 0 });
  const card = viewCard("guess", hypothesis.object, hypothesis,
    element("b", "", `${k + 1}. ${hypothesis.object}`),
    element("span", "", `class ${hypothesis.class}`), element("span", "", `score ${score}`),
    element("span", "", `${hypothesis.matched}/${hypothesis.matched + hypothesis.unmatched} contours`));
  if (rivals.includes(k)) card.append(element("span", "fair", "explains it as well"));
  card.title = "seen from " + hypothesis.view.map(part => part.toFixed(2)).join(" ") +
    (hypothesis.pose ? ", posed" : ", no pose tried");
  card.ariaPressed = k === open.choice;
  card.onclick = () => { open.choice = k; explain(); };
  return card;
}

function shortlistSection() {
  const object = open.frame.objects[open.object], details = open.details.objects[open.object];
  const list = element("div");
  list.id = "shortlist";
  list.append(askedCard(object), ...trueCards(object),
    ...details.hypotheses.map((hypothesis, k) => guessCard(hypothesis, k, details.rivals ?? [])));
  const note = !models.size ? "no index was given, so that no model can be drawn"
    : "drawn as found where a pose was tried, otherwise as the key views show it";
  return element("section", "w12", element("h2", "", "Shortlist ", element("small", "", note)), list,
    details.hypotheses.length ? "" : element("p", "faint", "no class is like it"));
}

// --- why
function surfacesOf(object, surfaces) {
  const names = models.get(object)?.surfaces ?? {};
  return (surfaces ?? []).map(surface => names[surface] ?? surface).join(", ");
}

function tableOf(heads, rows, none, more) {
  if (!rows.length) return element("p", "faint", none);
  const table = element("table"), head = element("tr");
  head.append(...heads.map(text => element("th", "", text)));
  table.append(head, ...rows);
  return more ? element("div", "", table, element("p", "faint", `and ${more} smaller ones`)) : table;
}

function rowOf(contour, ...cells) {
  const row = element("tr");
  row.append(...cells.map(cell => element("td", "", ...[cell].flat())));
  if (contour !== undefined) {
    row.dataset.contour = contour;
    row.onmouseenter = () => light(contour, true);
    row.onmouseleave = () => light(contour, false);
  }
  return row;
}

function light(contour, on) {
  for (const part of place("explained").querySelectorAll(`[data-contour="${contour}"]`)) {
    part.classList.toggle("lit", on);
    if (part.matches(".outline")) part.setAttribute("visibility", on ? "visible" : "hidden");
    else if (part.matches("path")) part.setAttribute("stroke-width", on ? 4 : 0.8);
  }
}

const matchedTable = (object, seen) => tableOf(["contour", "of the class", "surfaces"],
  seen.contours.map(entry => rowOf(entry.contour, [swatch(entry.colour), String(entry.contour)],
    entry.name, surfacesOf(object, entry.surfaces))), "no contour is matched", seen.contours_more);

const missingTable = (object, seen) => tableOf(["surface", "area", "covered"],
  seen.missing.map(entry => rowOf(undefined,
    [swatch(entry.colour), [entry.name, surfacesOf(object, entry.surfaces)].filter(Boolean).join(" · ") || "–"],
    entry.area_px === undefined ? "–" : Math.round(entry.area_px).toLocaleString("en") + " px",
    entry.covered === undefined ? "–" : percent(entry.covered))),
  "nothing is missing", seen.missing_more);

const contradictsTable = seen => tableOf(["contour", "where the model shows", "area"],
  seen.contradicts.map(entry => rowOf(entry.contour, [swatch(entry.colour), String(entry.contour)],
    entry.drawn ? [swatch(entry.drawn), "another colour"] : "nothing",
    Math.round(entry.area_px ?? 0).toLocaleString("en") + " px")),
  "nothing contradicts", seen.contradicts_more);

// Of the others than the first one the line tells only which contour is which.
function pairsTable(hypothesis) {
  return tableOf(["contour", "of the class"], hypothesis.contours.map(([number, letter]) =>
    rowOf(number, String(number), letter)), "no contour is matched");
}

function whySections() {
  const hypothesis = chosenHypothesis(), seen = open.details.objects[open.object].explanation;
  if (!hypothesis) return [];
  const what = `${hypothesis.object} class ${hypothesis.class}`;
  const section = (title, content, css = "w4") =>
    element("section", css, element("h2", "", title), content);
  if (open.choice > 0 || !seen)
    return [section("Matched, " + what, pairsTable(hypothesis), "w12")];
  return [section("Matched, " + what, matchedTable(hypothesis.object, seen)),
          section("Missing", missingTable(hypothesis.object, seen)),
          section("Contradicts", contradictsTable(seen))];
}

function otherEntry(other) {
  const entry = element("div", "other"), canvas = element("canvas");
  const own = hypothesesOf().find(hypothesis => hypothesis.object === other.object);
  const model = models.get(other.object);
  if (own && drawModel(canvas, other.object, own)) entry.append(canvas);
  else if (model && drawModel(canvas, other.object, { view: [0.5, -0.6, 0.62] })) {
    canvas.style.opacity = 0.45;
    entry.append(canvas);
  } else entry.append(canvas);
  entry.append(element("b", "", other.object ?? "what was expected"),
    element("p", "", other.reason[0].toUpperCase() + other.reason.slice(1) + "."));
  const facts = [];
  if (other.needed) facts.push(`${count(other.matched, "contour", "contours")} matched, ${other.needed} needed`);
  if (other.least_cost !== undefined) facts.push(`each view costs ${other.least_cost} or more`);
  if (other.rank) facts.push(`rank ${other.rank}`);
  if (other.class !== undefined) facts.push(`class ${other.class}`);
  if (facts.length) entry.append(element("p", "faint", facts.join(" · ")));
  if (other.contours) {
    const more = element("details", "", element("summary", "", "what fits, what does not"));
    more.ontoggle = () => {
      if (more.open && more.children.length === 1)
        more.append(matchedTable(other.object, other), missingTable(other.object, other),
                    contradictsTable(other));
    };
    entry.append(more);
  }
  return entry;
}

function othersSection() {
  const explanation = open.details.objects[open.object].explanation;
  const others = [explanation?.expected, ...(explanation?.others ?? [])].filter(Boolean);
  if (!others.length) return [];
  const list = element("div", "others", ...others.map(otherEntry));
  return [element("section", "w12", element("h2", "", "Why not another"), list)];
}

// --- all of it
function explain() {
  const { frame, details } = open, parts = [];
  const file = fileName(frame);
  place("name").replaceChildren(
    element("span", "folder", frame.name.slice(0, frame.name.length - file.length)), file);
  const at = shown.indexOf(frame);
  place("place").textContent = at < 0 ? "" : `${at + 1} of ${shown.length}`;
  place("previous").disabled = at <= 0;
  place("next").disabled = at < 0 || at + 1 >= shown.length;
  if (frame.error === undefined) parts.push(frameSection());
  if (details.contours) parts.push(contoursSection());
  parts.push(objectsSection());
  const top = element("div", ["none", "one", ""][parts.length - 1], ...parts);
  top.id = "top";
  place("explained").replaceChildren(top);
  if (frame.objects.length) {
    place("explained").append(shortlistSection(), ...whySections(), ...othersSection());
    if (!details.contours && !details.objects[open.object].explanation)
      place("explained").append(element("p", "faint w12",
        "Of this frame only what was recognised is known: its contours and the reasons were not recorded."));
  }
}

let scrolled = 0;
function go() {
  const frame = /^#\d+$/.test(location.hash) ? frames[Number(location.hash.slice(1))] : undefined;
  const wasOpen = open !== null;
  if (frame && !wasOpen) scrolled = scrollY;
  place("list").hidden = frame !== undefined;
  place("frame").hidden = frame === undefined;
  if (!frame) {
    const last = open?.frame;
    open = null;
    place("explained").replaceChildren();
    if (wasOpen) scrollTo(0, scrolled);
    last?.card?.focus({ preventScroll: true });
    return;
  }
  const named = frame.objects.findIndex(isNamed);
  open = { frame, details: contentOf(detailBlocks[frame.k]), object: Math.max(0, named), choice: 0 };
  explain();
  scrollTo(0, 0);
}

function step(by) {
  if (open) {
    const next = shown[shown.indexOf(open.frame) + by];
    if (next && shown.includes(open.frame)) location.replace("#" + next.k);
    return;
  }
  const cards = [...place("cards").children], at = cards.indexOf(document.activeElement);
  cards[at < 0 ? 0 : Math.min(cards.length - 1, Math.max(0, at + by))]?.focus();
}

place("back").onclick = () => { location.hash = ""; };
place("previous").onclick = () => step(-1);
place("next").onclick = () => step(1);
addEventListener("hashchange", go);
addEventListener("keydown", event => {
  if (event.altKey || event.ctrlKey || event.metaKey || event.target.matches("input, select")) return;
  if (event.key === "ArrowLeft") step(-1);
  else if (event.key === "ArrowRight") step(1);
  else if (event.key === "Escape" && open) location.hash = "";
  else if (event.key === "/" && !open) place("search").focus();
  else return;
  event.preventDefault();
});
go();
