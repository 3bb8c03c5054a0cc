
"use strict";
// Draws coloured triangles and lines from any side, in parallel projection: all that the object and
// its sphere need. A turn is a matrix of three rows, object coordinates: right, up, towards the eye.
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, factor) => a.map(value => value * factor);
const unit = a => scaled(a, 1 / (Math.hypot(...a) || 1));

// As the compiler's camera stands there: `up` upwards, or another axis where it looks along that.
function turnTowards(direction, up) {
  let right = cross(up, direction);
  if (Math.hypot(...right) < 1e-6) right = cross(Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], direction);
  right = unit(right);
  return [right, cross(direction, right), direction];
}

// Turned on by angles about the screen's axes.
function turnedBy(turn, across, down) {
  const mix = (a, b, angle) => a.map((value, k) => value * Math.cos(angle) + b[k] * Math.sin(angle));
  let [right, up, towards] = turn;
  [right, towards] = [mix(right, towards, across), mix(towards, right, -across)];
  [up, towards] = [mix(up, towards, -down), mix(towards, up, down)];
  towards = unit(towards);
  right = unit(cross(up, towards));
  return [right, cross(towards, right), towards];
}

const VERTEX = `
attribute vec3 place, normal, colour;
uniform mat3 turn;
uniform float scale, ambient;
varying vec3 shade;
void main() {
  vec3 at = turn * place;
  // Lit from above, left and before; what has no normal shines by itself.
  float light = abs(dot(turn * normal, normalize(vec3(-0.35, 0.5, 0.8))));
  shade = dot(normal, normal) < 0.1 ? colour : colour * (ambient + (1.0 - ambient) * light);
  gl_Position = vec4(at.xy * scale, -at.z * 0.25, 1.0);
}`;
const FRAGMENT = `
precision mediump float;
varying vec3 shade;
void main() { gl_FragColor = vec4(shade, 1.0); }`;

class Turntable {
  // Null where there is no WebGL. `ambient`: light where none falls on, 0 to 1.
  static on(canvas, scale, ambient) {
    const gl = canvas.getContext("webgl", {antialias: true});
    return gl && new Turntable(canvas, gl, scale, ambient);
  }

  constructor(canvas, gl, scale, ambient) {
    Object.assign(this, {canvas, gl, scale, ambient, layers: new Map()});
    canvas.addEventListener("webglcontextlost", event => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => this.restore());
    this.link();
  }

  link() {
    const {gl} = this, program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    gl.enable(gl.DEPTH_TEST);
    this.places = ["place", "normal", "colour"].map(name => gl.getAttribLocation(program, name));
    for (const place of this.places) gl.enableVertexAttribArray(place);
    this.turn = gl.getUniformLocation(program, "turn");
    gl.uniform1f(gl.getUniformLocation(program, "scale"), this.scale);
    gl.uniform1f(gl.getUniformLocation(program, "ambient"), this.ambient);
  }

  // After the graphics card was taken away and given back.
  restore() {
    this.link();
    const layers = [...this.layers];
    this.layers.clear();
    for (const [name, layer] of layers) this.set(name, layer.arrays, layer.lines);
    if (this.last) this.draw(this.last);
  }

  // Arrays of three numbers a corner: place, normal (0: none), colour (0 to 255). Three corners a
  // triangle, or two a line. No array: no layer. Of the same arrays as before only colours are new.
  set(name, arrays, lines = false) {
    const {gl} = this, old = this.layers.get(name);
    if (!arrays || !arrays.place.length) return void this.layers.delete(name);
    const buffers = old ? old.buffers : [gl.createBuffer(), gl.createBuffer(), gl.createBuffer()];
    [arrays.place, arrays.normal, arrays.colour].forEach((array, k) => {
      if (k < 2 && old?.arrays === arrays) return;
      gl.bindBuffer(gl.ARRAY_BUFFER, buffers[k]);
      gl.bufferData(gl.ARRAY_BUFFER, array, gl.STATIC_DRAW);
    });
    this.layers.set(name, {arrays, lines, buffers, count: arrays.place.length / 3});
  }

  draw(turn) {
    const {gl, canvas} = this;
    this.last = turn;
    const side = Math.round(canvas.clientWidth * (window.devicePixelRatio || 1)) || 1;
    if (canvas.width !== side) canvas.width = canvas.height = side;
    gl.viewport(0, 0, side, side);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix3fv(this.turn, false, [0, 1, 2].flatMap(k => turn.map(row => row[k])));
    for (const {buffers, lines, count} of this.layers.values()) {
      buffers.forEach((buffer, k) => {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        const bytes = k === 2;
        gl.vertexAttribPointer(this.places[k], 3, bytes ? gl.UNSIGNED_BYTE : gl.FLOAT, bytes, 0, 0);
      });
      gl.drawArrays(lines ? gl.LINES : gl.TRIANGLES, 0, count);
    }
  }

  // A point of the canvas in the drawing: 1 is the sphere's rim.
  at(event) {
    const box = this.canvas.getBoundingClientRect();
    return [((event.clientX - box.left) / box.width * 2 - 1) / this.scale,
            (1 - (event.clientY - box.top) / box.height * 2) / this.scale];
  }
}

// Corners one by one, for a layer.
class Corners {
  constructor(count) {
    this.place = new Float32Array(3 * count);
    this.normal = new Float32Array(3 * count);
    this.colour = new Uint8Array(3 * count);
    this.length = 0;
  }
  add(place, normal, colour) {
    const at = 3 * this.length++;
    for (let k = 0; k < 3; ++k) {
      this.place[at + k] = place[k];
      this.normal[at + k] = normal[k];
      this.colour[at + k] = colour[k];
    }
  }
  // A flat strip on the sphere, seen from outside.
  addStrip(from, to, width, colour) {
    const side = scaled(unit(cross(from, to)), width / 2), none = [0, 0, 0];
    const moved = (p, sign) => p.map((value, k) => value + sign * side[k]);
    const [a, b, c, d] = [moved(from, 1), moved(from, -1), moved(to, -1), moved(to, 1)];
    for (const corner of [a, b, c, a, c, d]) this.add(corner, none, colour);
  }
}
