// Follows the frames, and keeps what is set up to date.
import {ask, fetchLine, fetchState, fetchView, mayChange} from "./connection.js";
import {colourOf, drawPicture, drawRegions, drawResult, nameOf, readView} from "./drawing.js";
import {count, draw as drawPlot, useModels} from "./plot.js";
import {region, useFrame, useRegion} from "./region.js";
import {showFault, useControls, useValues} from "./values.js";

const place = id => document.getElementById(id);
const pause = ms => new Promise(done => setTimeout(done, ms));
let shown;       // number of the view that is seen
let state;       // what can be set
let pace = [];   // [time, lines] of the last seconds
let told = 0;    // when words and colours were shown last
let untold;      // shows those of the frame that is seen

function element(tag, text, css) {
  const made = document.createElement(tag);
  if (text !== undefined) made.textContent = text;
  if (css) made.className = css;
  return made;
}

const nameIn = path => path.split("/").pop();

// ---- what was recognised
function surely(object) {
  if (typeof object.probability === "number") return (object.probability * 100).toFixed(1) + " %";
  const score = object.hypotheses?.[0]?.score;
  return typeof score === "number" ? "score " + Number(score.toPrecision(4)) : "";
}

function listObjects(line) {
  const rows = (line?.objects ?? []).map(object => {
    const row = element("li"), mark = element("i"), middle = element("div");
    mark.style.background = colourOf(nameOf(object));
    const best = object.hypotheses?.[0];
    middle.append(element("b", nameOf(object)));
    const notes = [object.verdict, best && "class " + best.class, surely(object)];
    middle.append(element("small", notes.filter(Boolean).join(" · ")));
    row.append(mark, middle, element("small", object.regions + " regions"));
    return row;
  });
  place("objects").replaceChildren(...(rows.length ? rows : [element("li", "nothing", "none")]));
}

function listCounts(answer) {
  const now = performance.now();
  pace.push([now, answer.lines]);
  pace = pace.filter(([time]) => now - time < 3000);
  const seconds = (now - pace[0][0]) / 1000;
  const rate = seconds > 0.5 ? ((answer.lines - pace[0][1]) / seconds).toFixed(1) : "";
  const rows = [
    ["lines a second", rate],
    ["recognised in", answer.line?.elapsed_ms === undefined ? ""
      : answer.line.elapsed_ms.toFixed(1) + " ms"],
    ["lines", answer.lines], ["readers", answer.readers],
    ["readers too slow", answer.readers_dropped, answer.readers_dropped > 0],
    ["lines lost", answer.lines_lost, answer.lines_lost > 0]];
  place("counts").replaceChildren(...rows.flatMap(([name, value, bad]) =>
    [element("dt", name), element("dd", value === "" ? "–" : value.toLocaleString(), bad && "bad")]));
}

function showState(text, good) {
  place("state").textContent = text;
  place("state").className = good ? "good" : "bad";
}

function showLine(answer) {
  listCounts(answer);
  if (!answer.line) return;
  listObjects(answer.line);
  const told = answer.line.state, paused = state?.paused;
  showState(paused ? "paused" : typeof told === "string" ? told : "streaming",
            !told || told === "streaming");
  place("line").textContent = JSON.stringify(answer.line);
  place("picture_note").textContent = nameIn(answer.line.frame ?? "");
  const found = (answer.line.objects ?? []).filter(object => object.verdict === "match").length;
  place("result_note").textContent = found + (found === 1 ? " match" : " matches");
}

// ---- frames
async function showView(view) {
  shown = view.view;
  useFrame(view.width, view.height);
  drawPicture(view);
  drawRegions(view);
  place("regions").dataset.settings = view.settings;
  place("regions_note").textContent = `${view.regions} regions · cut in ${view.cut_ms.toFixed(1)} ms`;
  // Its line is published once the frame has been recognised.
  let answer = await fetchLine(view.line);
  for (let tries = 0; tries < 10 && !answer.line; ++tries) {
    await pause(10);
    answer = await fetchLine(view.line);
  }
  drawResult(view, answer.line);
  untold = () => {
    showLine(answer);
    showColours(view);
  };
  // Words cannot be read faster.
  if (performance.now() - told >= 200) tell();
}

function tell() {
  untold?.();
  untold = undefined;
  told = performance.now();
}

function showColours(view) {
  if (!state) return;
  const valueOf = key => state.values.find(value => value.key === key).value;
  useModels(state.models, valueOf("chroma_step"));
  const shown = count(view, region(), valueOf("intensity_min"));
  place("plot_note").textContent = state.sensor !== "colour"
    ? "Frames of this sensor have no colours."
    : "Shares of red and green of " + (shown === 0 ? "no pixel: all is background."
      : "the frame's pixels, and of the models' colours as rings.");
  drawPlot();
}

async function follow() {
  let quiet = 0;
  while (true) {
    // Nobody looks: nothing is drawn.
    if (document.hidden) {
      await pause(200);
      continue;
    }
    try {
      const bytes = await fetchView(shown);
      if (bytes) {
        await showView(readView(bytes));
        quiet = 0;
      } else if (untold) {
        tell();
      } else if (++quiet > 2) {
        // No frames: lines still tell why.
        showLine(await fetchLine());
        await pause(100);
      }
    } catch {
      showState("not reachable", false);
      shown = undefined;
      await pause(1000);
    }
  }
}

// ---- what can be set
function notice(text, kind = "") {
  place("notice").textContent = text;
  place("notice").className = kind;
  place("notice").hidden = !text;
}

async function refresh() {
  try {
    state = await fetchState();
  } catch {
    return;
  }
  useValues(state);
  useControls(state);
  useRegion(state);
  showFault(state.fault);
  place("playing").hidden = state.camera;
  place("pause").textContent = state.paused ? "Play" : "Pause";
  place("save").textContent = state.file ? "Write " + state.file : "Write configuration";
  for (const button of document.querySelectorAll("#actions button")) button.disabled = !mayChange();
  place("forget").disabled ||= !state.changed && !state.fault;
}

async function doIt(action, body, tell) {
  try {
    const answer = await ask(action, body);
    if (tell) notice(tell(answer), "good");
  } catch (error) {
    notice(error.message, "bad");
  }
  await refresh();
}

const actions = {
  save: () => doIt("save", {}, answer => `${answer.file} is written; what it was is kept as ` +
    `${nameIn(answer.kept)}.`),
  forget: () => doIt("forget", {}, () => "Values are as in the configuration again."),
  record: () => {
    notice("Recording …");
    return doIt("record", {}, answer =>
      `${answer.frames} frames are in ${answer.folder}: ${answer.first} to ${answer.last}.`);
  },
  pause: () => doIt("play", {paused: !state.paused}),
  step: () => doIt("play", {steps: 1})};
for (const [name, act] of Object.entries(actions)) place(name).addEventListener("click", act);
document.addEventListener("sent", refresh);
if (!mayChange())
  notice("To change something, open the address that the program printed when it started: it has " +
         "a token behind it.");

async function keepUpToDate() {
  while (true) {
    if (!document.hidden) await refresh();
    await pause(2000);
  }
}
keepUpToDate();
follow();
