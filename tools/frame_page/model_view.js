// Models of objects, drawn from anywhere: a depth buffer in plain JavaScript. Camera coordinates are
// x right, y down, z forward.
const blocks = name => [...document.querySelectorAll("script.data-" + name)];
const contentOf = block => JSON.parse(block.textContent);
const models = new Map(blocks("model").map(contentOf).map(model => [model.object, model]));

const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = a => { const length = Math.hypot(...a); return a.map(part => part / length); };
const times = (rows, v) => rows.map(row => dot(row, v));

function rowsOfQuaternion([w, x, y, z]) {
  return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
          [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
          [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]];
}

// A camera without roll that looks at the object from there.
function rowsOfView(view, up) {
  const z = unit(view).map(part => -part);
  let x = cross(z, up);
  if (Math.hypot(...x) < 1e-6) x = cross(z, Math.abs(z[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]);
  x = unit(x);
  return [x, cross(z, x), z];
}

// The same, with the picture turned clockwise.
function rolled([x, y, z], roll) {
  const cos = Math.cos(roll), sin = Math.sin(roll);
  return [x.map((part, k) => cos * part - sin * y[k]), x.map((part, k) => sin * part + cos * y[k]), z];
}

// Where the object stands before the camera: as found, or as seen from a direction.
function standing(model, seen) {
  if (seen.pose) {
    const rows = rowsOfQuaternion(seen.pose.quaternion);
    return { rows, centre: times(rows, model.centre).map((part, k) => part + seen.pose.translation[k]) };
  }
  const far = model.radius / Math.sin(Math.min(60, Math.max(5, model.fov)) * Math.PI / 360);
  return { rows: rolled(rowsOfView(seen.view, model.up), seen.roll ?? 0), centre: [0, 0, far] };
}

// Vertices in pixels of a square of that side, with 1/z and their place before the camera; filled
// to a margin. Nothing where a part of it is behind the camera.
function projected(model, { rows, centre }, side) {
  const points = [], v = model.vertices;
  let left = Infinity, top = Infinity, right = -Infinity, bottom = -Infinity;
  for (let k = 0; k < v.length; k += 3) {
    const at = times(rows, [v[k] * model.unit, v[k + 1] * model.unit, v[k + 2] * model.unit])
      .map((part, axis) => part + centre[axis]);
    if (!(at[2] > 1e-9)) return null;
    const x = at[0] / at[2], y = at[1] / at[2];
    points.push({ x, y, near: 1 / at[2], at });
    left = Math.min(left, x); right = Math.max(right, x);
    top = Math.min(top, y); bottom = Math.max(bottom, y);
  }
  const scale = 0.88 * side / Math.max(right - left, bottom - top, 1e-9);
  for (const p of points) {
    p.x = side / 2 + (p.x - (left + right) / 2) * scale;
    p.y = side / 2 + (p.y - (top + bottom) / 2) * scale;
  }
  return points;
}

function fillTriangle(a, b, c, rgb, side, nearest, pixels) {
  const area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (Math.abs(area) < 1e-9) return;
  const firstX = Math.max(0, Math.ceil(Math.min(a.x, b.x, c.x) - 0.5));
  const lastX = Math.min(side - 1, Math.floor(Math.max(a.x, b.x, c.x) - 0.5));
  const firstY = Math.max(0, Math.ceil(Math.min(a.y, b.y, c.y) - 0.5));
  const lastY = Math.min(side - 1, Math.floor(Math.max(a.y, b.y, c.y) - 0.5));
  for (let y = firstY; y <= lastY; ++y)
    for (let x = firstX; x <= lastX; ++x) {
      const dx = x + 0.5 - a.x, dy = y + 0.5 - a.y;
      const u = (dx * (c.y - a.y) - dy * (c.x - a.x)) / area;
      const w = (dy * (b.x - a.x) - dx * (b.y - a.y)) / area;
      if (u < 0 || w < 0 || u + w > 1) continue;
      const near = a.near + u * (b.near - a.near) + w * (c.near - a.near), place = y * side + x;
      if (near <= nearest[place]) continue;
      nearest[place] = near;
      pixels[4 * place] = rgb[0];
      pixels[4 * place + 1] = rgb[1];
      pixels[4 * place + 2] = rgb[2];
      pixels[4 * place + 3] = 255;
    }
}

const rgbOf = colour => [1, 3, 5].map(k => parseInt(colour.slice(k, k + 2), 16));

// Faces that turn away are darker, so that two of one colour are told apart.
function drawFaces(pen, model, points, side) {
  const picture = pen.createImageData(side, side), nearest = new Float32Array(side * side);
  const colours = model.colours.map(rgbOf), t = model.triangles;
  for (let k = 0; k < t.length; k += 4) {
    const [a, b, c] = [points[t[k]], points[t[k + 1]], points[t[k + 2]]];
    const normal = cross(b.at.map((part, axis) => part - a.at[axis]),
                         c.at.map((part, axis) => part - a.at[axis]));
    const facing = Math.abs(dot(normal, a.at)) / (Math.hypot(...normal) * Math.hypot(...a.at) || 1);
    const rgb = colours[t[k + 3]].map(level => level * (0.62 + 0.38 * facing));
    fillTriangle(a, b, c, rgb, side, nearest, picture.data);
  }
  pen.putImageData(picture, 0, 0);
  return nearest;
}

function drawEdges(pen, model, points, nearest, side) {
  const slack = 0.012 * model.radius;
  const isSeen = (x, y, near) => {
    let farthest = Infinity;
    for (let j = -1; j <= 1; ++j)
      for (let i = -1; i <= 1; ++i) {
        const column = Math.floor(x) + i, row = Math.floor(y) + j;
        const inside = column >= 0 && row >= 0 && column < side && row < side;
        farthest = Math.min(farthest, inside ? nearest[row * side + column] : 0);
      }
    return farthest <= near * (1 + slack * near);
  };
  const minus = (p, q) => p.at.map((part, axis) => part - q.at[axis]);
  const isOutline = (a, b, first, second) =>
    (dot(cross(minus(b, a), minus(first, a)), a.at) < 0) !==
    (dot(cross(minus(second, a), minus(b, a)), a.at) < 0);
  pen.beginPath();
  for (let k = 0; k < model.edges.length; k += 5) {
    const [a, b, first, second] = model.edges.slice(k, k + 4).map(place => points[place]);
    if (model.edges[k + 4] && !isOutline(a, b, first, second)) continue;
    const steps = Math.max(1, Math.ceil(Math.hypot(b.x - a.x, b.y - a.y) / 2));
    let drawing = false;
    for (let step = 0; step <= steps; ++step) {
      const share = step / steps;
      const x = a.x + share * (b.x - a.x), y = a.y + share * (b.y - a.y);
      if (!isSeen(x, y, a.near + share * (b.near - a.near))) { drawing = false; continue; }
      if (drawing) pen.lineTo(x, y); else pen.moveTo(x, y);
      drawing = true;
    }
  }
  pen.strokeStyle = "rgba(16, 19, 23, .85)";
  pen.lineWidth = side / 160;
  pen.lineCap = "round";
  pen.stroke();
}

// `seen`: {pose} or {view, roll}, of an object; false where there is no model of it or none to be seen.
function drawModel(canvas, object, seen) {
  const model = models.get(object);
  if (!model?.vertices || !(seen.pose || Math.hypot(...(seen.view ?? [0])) > 0.5)) return false;
  const side = canvas.width = canvas.height = 288;
  const points = projected(model, standing(model, seen), side);
  if (!points) return false;
  const pen = canvas.getContext("2d");
  const nearest = drawFaces(pen, model, points, side);
  drawEdges(pen, model, points, nearest, side);
  return true;
}
