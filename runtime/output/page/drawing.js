// The three pictures: what the camera sees, its regions, and what was recognised.
const picture = document.getElementById("picture"), regions = document.getElementById("regions"),
      result = document.getElementById("result");
const palette = ["#4da3ff", "#ffb02e", "#3ddc97", "#ff6f91", "#b28dff", "#f4e04d", "#4dd8e6"];

// An object keeps its colour from frame to frame, whatever else there is.
export function colourOf(name) {
  let mixed = 0;
  for (const letter of name) mixed = (mixed * 31 + letter.codePointAt(0)) >>> 0;
  return palette[mixed % palette.length];
}

export const nameOf = object => object.hypotheses?.[0]?.object ?? "unknown";

// Bright enough for black, always the same for a number, far apart for numbers that follow each
// other: steps of the golden ratio round the colour circle. As aspect-replay --dump has them.
const regionColours = new Uint32Array(1 << 16).fill(0);
function regionColour(label) {
  if (regionColours[label]) return regionColours[label];
  const hue = 6 * ((0.07 + 0.618033988749895 * label) % 1), saturation = [0.85, 0.55, 0.7][label % 3];
  const channel = shift => {
    const distance = Math.abs((hue + shift) % 6 - 3);
    return Math.round(255 * (1 - saturation * (1 - Math.min(1, Math.max(0, distance - 1)))));
  };
  const [red, green, blue] = [channel(0), channel(4), channel(2)];
  return regionColours[label] = (255 << 24 | blue << 16 | green << 8 | red) >>> 0;
}

// An answer of the program taken apart: see runtime/workbench/view_drawing.h.
export function readView(bytes) {
  const length = new DataView(bytes).getUint32(0, true);
  const view = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length)));
  const start = 4 + length;
  view.bmp = new Uint8Array(bytes, start, view.picture);
  view.runs = new Uint16Array(bytes.slice(start + view.picture));
  return view;
}

export function drawRegions(view) {
  if (regions.width !== view.width || regions.height !== view.height) {
    regions.width = view.width;
    regions.height = view.height;
  }
  const image = new ImageData(view.width, view.height);
  const pixels = new Uint32Array(image.data.buffer).fill(0xff000000);
  const runs = view.runs;
  for (let k = 0; k + 3 < runs.length; k += 4)
    if (runs[k + 3] > 0)
      pixels.fill(regionColour(runs[k + 3]), runs[k] * view.width + runs[k + 1],
                  runs[k] * view.width + runs[k + 2]);
  regions.getContext("2d", {willReadFrequently: true}).putImageData(image, 0, 0);
}

// Of a BMP of 24 bits from the top down, whose rows are whole words.
export function drawPicture(view) {
  const data = new DataView(view.bmp.buffer, view.bmp.byteOffset);
  const width = data.getInt32(18, true), height = -data.getInt32(22, true);
  if (picture.width !== width || picture.height !== height) {
    picture.width = width;
    picture.height = height;
  }
  const image = new ImageData(width, height), to = image.data, from = view.bmp;
  const row = Math.ceil(width * 3 / 4) * 4;
  for (let y = 0, k = 0; y < height; ++y)
    for (let at = 54 + y * row, end = at + 3 * width; at < end; at += 3, k += 4) {
      to[k] = from[at + 2];
      to[k + 1] = from[at + 1];
      to[k + 2] = from[at];
      to[k + 3] = 255;
    }
  picture.getContext("2d", {willReadFrequently: true}).putImageData(image, 0, 0);
}

function drawEdges(pen, view, scale) {
  const path = new Path2D();
  for (const line of view.edges.flat())
    for (let k = 0; k + 1 < line.length; k += 2) {
      // A pixel's centre is at whole numbers.
      const x = (line[k] + 0.5) * scale, y = (line[k + 1] + 0.5) * scale;
      if (k === 0) path.moveTo(x, y); else path.lineTo(x, y);
    }
  pen.lineJoin = "round";
  pen.strokeStyle = "#141414";
  pen.lineWidth = 5;
  pen.stroke(path);
  pen.strokeStyle = "#fff";
  pen.lineWidth = 2.2;
  pen.stroke(path);
}

function drawBoxes(pen, line, scale) {
  pen.lineWidth = 3;
  pen.font = "600 20px system-ui, sans-serif";
  for (const object of line?.objects ?? []) {
    const [x, y, width, height] = object.box.map(number => number * scale), name = nameOf(object);
    pen.strokeStyle = pen.fillStyle = colourOf(name);
    pen.strokeRect(x, y, width, height);
    const wide = pen.measureText(name).width + 14;
    const left = Math.max(0, Math.min(x - 1.5, pen.canvas.width - wide));
    const top = y >= 28 ? y - 28 : y;
    pen.fillRect(left, top, wide, 28);
    pen.fillStyle = "#000";
    pen.fillText(name, left + 7, top + 21);
  }
}

// Over the picture that was drawn last.
export function drawResult(view, line) {
  const height = Math.round(result.width * view.height / view.width);
  if (result.height !== height) result.height = height;
  const pen = result.getContext("2d", {willReadFrequently: true}), scale = result.width / view.width;
  pen.drawImage(picture, 0, 0, result.width, result.height);
  drawEdges(pen, view, scale);
  drawBoxes(pen, line, scale);
}
