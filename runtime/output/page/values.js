// A knob for every value of the segmentation and every control of the camera.
import {Latest, ask, mayChange} from "./connection.js";

const kPositions = 1000;
const knobs = new Map();

function element(tag, text, css) {
  const made = document.createElement(tag);
  if (text !== undefined) made.textContent = text;
  if (css) made.className = css;
  return made;
}

// Where a range spans orders of magnitude, equal ways of the slider are equal factors.
function scaleOf({least, most, whole}) {
  if (whole && most - least <= kPositions)
    return {least, most, step: 1, place: value => value, value: place => place};
  if (least > 0 && most / least > 1e4) {
    const ratio = Math.log(most / least);
    return {least: 0, most: kPositions, step: 1,
            place: value => kPositions * Math.log(Math.max(value, least) / least) / ratio,
            value: place => least * Math.exp(place / kPositions * ratio)};
  }
  const span = Math.log1p(most - least);
  return {least: 0, most: kPositions, step: 1,
          place: value => kPositions * Math.log1p(Math.max(0, value - least)) / span,
          value: place => least + Math.expm1(place / kPositions * span)};
}

// As short as it can be said.
function rounded(value, whole) {
  return whole ? Math.round(value) : Number(value.toPrecision(3));
}

class Knob {
  constructor(about, send) {
    this.about = about;
    this.row = element("div", undefined, "value");
    this.label = element("label", about.name);
    if (about.unit) this.label.append(element("small", about.unit));
    this.fault = element("p", "", "fault");
    this.fault.hidden = true;
    this.latest = new Latest(async value => {
      try {
        const answer = await send(value);
        const warning = (answer?.warnings ?? []).join("; ");
        this.fault.textContent = warning;
        this.fault.hidden = !warning;
      } catch (error) {
        this.fault.textContent = error.message;
        this.fault.hidden = false;
      }
      this.row.dispatchEvent(new CustomEvent("sent", {bubbles: true}));
    });
    this.row.dataset.key = about.name;
    this.build();
    this.row.append(element("p", about.words, "words"), this.fault);
    this.inputs.forEach((input, k) => {
      input.id = about.name + (k === 0 ? "" : "_slider");
      input.disabled = !mayChange();
      if (k > 0) input.setAttribute("aria-label", about.name);
    });
    this.label.htmlFor = about.name;
  }

  build() {
    const kind = this.about.kind;
    if (kind === "truth") this.buildTruth();
    else if (kind === "menu") this.buildMenu();
    else if (kind === "button") this.buildButton();
    else this.buildNumber();
  }
  buildTruth() {
    const box = element("input");
    box.type = "checkbox";
    box.addEventListener("change", () => this.latest.give(this.about.control ? Number(box.checked)
                                                                             : box.checked));
    this.put = value => { box.checked = Boolean(value); };
    this.inputs = [box];
    this.row.append(this.label, box);
  }
  buildMenu() {
    const list = element("select");
    for (const item of this.about.items) {
      const option = element("option", item.name);
      option.value = item.value;
      list.append(option);
    }
    list.addEventListener("change", () => this.latest.give(Number(list.value)));
    this.put = value => { list.value = value; };
    this.inputs = [list];
    this.row.append(this.label, list);
  }
  buildButton() {
    const button = element("button", "Press");
    button.type = "button";
    button.addEventListener("click", () => this.latest.give(1));
    this.put = () => {};
    this.inputs = [button];
    this.row.append(this.label, button);
  }
  buildNumber() {
    const {least, most, whole} = this.about, scale = scaleOf(this.about);
    const number = element("input"), slider = element("input"), ends = element("div", undefined, "ends");
    number.type = "number";
    number.step = whole ? this.about.step ?? 1 : "any";
    slider.type = "range";
    slider.min = scale.least;
    slider.max = scale.most;
    slider.step = scale.step;
    slider.addEventListener("input", () => {
      const value = rounded(scale.value(Number(slider.value)), whole);
      number.value = value;
      this.latest.give(value);
    });
    // Nothing is held back that is no good: the program says what is wrong with it.
    number.addEventListener("change", () => {
      if (number.value === "") return;
      slider.value = scale.place(Number(number.value));
      this.latest.give(Number(number.value));
    });
    ends.append(element("span", least.toLocaleString()), element("span", most.toLocaleString()));
    this.put = value => {
      number.value = value;
      slider.value = scale.place(Number(value));
    };
    this.inputs = [number, slider];
    this.row.append(this.label, number, slider, ends);
  }

  // What somebody is just turning stays as it is.
  use({value, changed, off}) {
    this.row.classList.toggle("changed", Boolean(changed));
    this.row.classList.toggle("off", Boolean(off));
    for (const input of this.inputs) input.disabled = !mayChange() || Boolean(off);
    if (this.latest.busy || this.row.contains(document.activeElement) &&
        document.activeElement.type === "number" && !this.fault.hidden) return;
    this.put(value);
  }
}

function useAll(list, parent, make) {
  const names = list.map(each => each.name).join();
  if (parent.dataset.names !== names) {
    parent.dataset.names = names;
    for (const each of list) knobs.set(parent.id + each.name, make(each));
    parent.replaceChildren(...list.map(each => knobs.get(parent.id + each.name).row));
  }
  for (const each of list) knobs.get(parent.id + each.name).use(each);
}

export function useValues(state) {
  const isRange = state.sensor === "range";
  const all = state.values.map(value => ({
    ...value, name: value.key, whole: value.kind === "whole", off: value.of_range !== isRange &&
    value.of_range}));
  const make = about => new Knob(about, value => ask("settings", {[about.name]: value}));
  useAll(all.filter(value => !value.of_range), document.getElementById("values"), make);
  useAll(all.filter(value => value.of_range), document.getElementById("range_values"), make);
  if (isRange) document.getElementById("range").open = true;
}

export function useControls(state) {
  document.getElementById("camera").hidden = !state.camera;
  const note = !state.streaming ? "The camera does not stream now."
      : state.controls.length === 0 ? "The camera has no controls."
      : "Names and limits are the camera's. What is set here holds at once.";
  document.getElementById("camera_note").textContent = note;
  const all = state.controls.map(control => ({
    ...control, whole: true, control: true, off: control.inactive || control.fixed,
    words: control.words + (control.inactive ? " An automatic decides now." : "")}));
  useAll(all, document.getElementById("controls"),
         about => new Knob(about, value => ask("control", {name: about.name, value})));
}

// What cannot be used as it is, where it is.
export function showFault(fault) {
  for (const knob of knobs.values()) {
    if (knob.about.control) continue;
    const own = fault?.includes(" " + knob.about.name + " ");
    knob.fault.textContent = own ? fault : "";
    knob.fault.hidden = !own;
  }
}
