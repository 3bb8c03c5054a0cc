// The frame's colours as shares of red and green, over those of the loaded models.
const canvas = document.getElementById("plot"), pen = canvas.getContext("2d", {willReadFrequently: true});
const kBins = 140, kMargin = 34;
const counts = new Uint32Array(kBins * kBins);
let models = [], chosen, step = 8;

const side = () => canvas.width - 2 * kMargin;
const across = red => kMargin + red * side(), down = green => canvas.height - kMargin - green * side();

// The brightest colour of these shares.
function colour(red, green) {
  const blue = Math.max(0, 1 - red - green), most = Math.max(red, green, blue, 1e-6);
  return [red, green, blue].map(share => Math.round(255 * share / most));
}

export function useModels(list, chromaStep) {
  step = chromaStep;
  if (JSON.stringify(list) === JSON.stringify(models)) return;
  models = list;
  const rows = models.map(model => {
    const row = document.createElement("li"), name = document.createElement("b"),
          swatches = document.createElement("span");
    name.textContent = model.object;
    swatches.className = "swatches";
    for (const [red, green] of model.colours) {
      const swatch = document.createElement("i");
      swatch.style.background = "rgb(" + colour(red, green).join(" ") + ")";
      swatches.append(swatch);
    }
    row.append(name, swatches);
    row.addEventListener("mouseenter", () => { chosen = model; draw(); });
    row.addEventListener("mouseleave", () => { chosen = undefined; draw(); });
    return row;
  });
  document.getElementById("models").replaceChildren(...rows);
}

// Of the part of the picture that is looked at, without what is background.
export function count(view, region, intensityMin) {
  counts.fill(0);
  const bmp = view.bmp, data = new DataView(bmp.buffer, bmp.byteOffset, bmp.byteLength);
  const width = data.getInt32(18, true), height = -data.getInt32(22, true);
  const row = Math.ceil(width * 3 / 4) * 4, scale = width / view.width;
  const [x, y, wide, high] = (region ?? [0, 0, view.width, view.height]).map(n => Math.round(n * scale));
  let shown = 0;
  for (let v = Math.max(0, y); v < Math.min(height, y + high); v += 2)
    for (let u = Math.max(0, x); u < Math.min(width, x + wide); u += 2) {
      const at = 54 + v * row + 3 * u, sum = bmp[at] + bmp[at + 1] + bmp[at + 2];
      if (sum < intensityMin || sum === 0) continue;
      const red = Math.min(kBins - 1, Math.floor(bmp[at + 2] / sum * kBins));
      const green = Math.min(kBins - 1, Math.floor(bmp[at + 1] / sum * kBins));
      ++counts[green * kBins + red];
      ++shown;
    }
  return shown;
}

function drawFrameColours() {
  const most = Math.log1p(counts.reduce((a, b) => Math.max(a, b), 1)), cell = side() / kBins;
  for (let green = 0; green < kBins; ++green)
    for (let red = 0; red < kBins; ++red) {
      const number = counts[green * kBins + red];
      if (number === 0) continue;
      const tone = colour((red + 0.5) / kBins, (green + 0.5) / kBins).join(" ");
      pen.fillStyle = "rgb(" + tone + " / " + (0.3 + 0.7 * Math.log1p(number) / most) + ")";
      // Larger than it is: clean colours are a single cell.
      pen.fillRect(across(red / kBins) - 1, down((green + 1) / kBins) - 1, cell + 2, cell + 2);
    }
}

function drawModels(ink, ground) {
  for (const model of models) {
    pen.globalAlpha = chosen && chosen !== model ? 0.15 : 1;
    for (const [red, green] of model.colours)
      for (const [width, style] of [[9, ground], [6, ink], [3, "rgb(" + colour(red, green).join(" ") + ")"]]) {
        pen.beginPath();
        pen.arc(across(red), down(green), 11, 0, 2 * Math.PI);
        pen.lineWidth = width;
        pen.strokeStyle = style;
        pen.stroke();
      }
  }
  pen.globalAlpha = 1;
}

export function draw() {
  const style = getComputedStyle(document.body);
  const [ink, faint, line, ground] =
      ["--ink", "--faint", "--line", "--soft"].map(name => style.getPropertyValue(name));
  pen.clearRect(0, 0, canvas.width, canvas.height);
  pen.beginPath();
  pen.moveTo(across(0), down(0));
  pen.lineTo(across(1), down(0));
  pen.lineTo(across(0), down(1));
  pen.closePath();
  pen.lineWidth = 2;
  pen.strokeStyle = line;
  pen.stroke();
  // Grey is where all shares are alike.
  pen.setLineDash([4, 5]);
  for (const [red, green] of [[1, 0], [0, 1], [0, 0]]) {
    pen.beginPath();
    pen.moveTo(across(1 / 3), down(1 / 3));
    pen.lineTo(across(red), down(green));
    pen.stroke();
  }
  pen.setLineDash([]);
  drawFrameColours();
  drawModels(ink, ground);
  pen.font = "18px system-ui, sans-serif";
  pen.fillStyle = faint;
  pen.textAlign = "left";
  pen.fillText("blue", across(0), down(0) + 24);
  pen.textAlign = "right";
  pen.fillText("red", across(1), down(0) + 24);
  pen.textAlign = "left";
  pen.fillText("green", across(0), down(1) - 10);
  // How far two neighbouring pixels of a region may be apart.
  const wide = Math.min(step, 128) / 255 * side();
  pen.textAlign = "right";
  pen.fillText("chroma_step", across(1) - wide - 10, down(1) + 14);
  pen.strokeStyle = ink;
  pen.strokeRect(across(1) - wide, down(1), wide, wide);
}
