// Draws triangle meshes by WebGL 2. strata_csg._notebook puts this script into a page of its own, with the elements
// #data (JSON), #stage (the picture), #bar (#reset, #lines and, where there is one, #slider with #label) and #message.
// `strata view` puts it into web/viewer/page.html, which has besides a #part-<n> for each part, which shows or hides it, and
// a section plane: #axis, #cut and #place. A page without #data calls `strataViewer` itself, and `show` of what that
// returns with the data of other parts; the camera stays.
// The picture is a parallel projection: the camera is two angles, a zoom and a shift.
function strataViewer(data) {
  "use strict";

  const element = (name) => document.getElementById(name);
  const stage = element("stage");

  // ---- geometry ------------------------------------------------------------------------------------------------

  // Arrays, or base64 of little-endian numbers, as they are in memory everywhere.
  function decoded(text, ArrayType) {
    if (text instanceof ArrayType) return text;
    const characters = atob(text);
    const bytes = new Uint8Array(characters.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
    return new ArrayType(bytes.buffer);
  }

  let positions, triangles, edges, colors, aways;

  // A value per part, repeated for each of its vertices. Parts lie one after the other in all arrays; a part lists the
  // ends of its vertices, triangles and edges.
  function spread(values, ArrayType) {
    const result = new ArrayType(positions.length);
    let vertex = 0;
    data.parts.forEach((part) => {
      for (; vertex < part.ends[0]; ++vertex) result.set(values(part), 3 * vertex);
    });
    return result;
  }

  function take(next) {
    data = next;
    positions = decoded(data.positions, Float32Array);
    triangles = decoded(data.triangles, Uint32Array);
    edges = decoded(data.edges, Uint32Array);
    colors = data.colors ? decoded(data.colors, Uint8Array) : spread((part) => part.color, Uint8Array);
    aways = spread((part) => part.away, Float32Array);
  }

  // While the picture of many triangles moves, few are drawn, so that it moves without a graphics device, too: the first
  // vertex of a part in a cell of a grid stands for all there. What remains of each part: the end of its triangles.
  const many = 150000, cells = 64;

  function coarseTriangles() {
    const first = new Uint32Array(cells ** 3), standing = new Uint32Array(positions.length / 3);  // first: a vertex + 1
    const place = (x) => Math.max(0, Math.min(cells - 1, Math.floor((x + 1) * cells / 2)));
    const cellOf = (v) => (place(positions[3 * v]) * cells + place(positions[3 * v + 1])) * cells + place(positions[3 * v + 2]);
    const kept = [], ends = [];
    let vertex = 0, triangle = 0;
    data.parts.forEach((part) => {
      const begin = vertex;
      for (; vertex < part.ends[0]; ++vertex) standing[vertex] = (first[cellOf(vertex)] ||= vertex + 1) - 1;
      for (let v = begin; v < vertex; ++v) first[cellOf(v)] = 0;
      for (; triangle < part.ends[1]; ++triangle) {
        const [a, b, c] = [0, 1, 2].map((k) => standing[triangles[3 * triangle + k]]);
        if (a !== b && b !== c && c !== a) kept.push(a, b, c);
      }
      ends.push(kept.length / 3);
    });
    return { triangles: Uint32Array.from(kept), ends };
  }

  // ---- camera --------------------------------------------------------------------------------------------------

  const home = { yaw: 0.5, pitch: -1.1, zoom: 1, x: 0, y: 0 };
  const camera = Object.assign({}, home);
  const limits = { least: 0.1, most: 2000 };

  // Rotation about the z axis, then about the horizontal axis of the picture; columns one after the other.
  function rotation() {
    const c = Math.cos(camera.yaw), s = Math.sin(camera.yaw);
    const d = Math.cos(camera.pitch), t = Math.sin(camera.pitch);
    return [c, s * d, s * t, -s, c * d, c * t, 0, -t, d];
  }

  function turn(yaw, pitch) {
    camera.yaw += yaw;
    camera.pitch = Math.max(-Math.PI, Math.min(0, camera.pitch + pitch));
  }

  // Shifts and places are in halves of the shorter side of the picture.
  function shift(x, y) {
    camera.x += x;
    camera.y += y;
  }

  // The point (x, y) of the picture stays where it is.
  function zoom(factor, x, y) {
    const next = Math.max(limits.least, Math.min(limits.most, camera.zoom * factor));
    const ratio = next / camera.zoom;
    camera.x = x - (x - camera.x) * ratio;
    camera.y = y - (y - camera.y) * ratio;
    camera.zoom = next;
  }

  // ---- picture -------------------------------------------------------------------------------------------------

  const vertexShader = `#version 300 es
    in vec3 position; in vec3 away; in vec3 color;
    uniform mat3 rotation; uniform vec3 scale; uniform vec2 shift; uniform float explosion; uniform float nearer; uniform vec4 cut;
    out vec3 place; out vec3 tint; out float beyond;
    void main() {
      place = rotation * (position + explosion * away);
      beyond = dot(position, cut.xyz) - cut.w;
      tint = color;
      gl_Position = vec4(place.xy * scale.xy + shift, -place.z * scale.z - nearer, 1.0);
    }`;

  // The normal of a face is that of the plane through neighbouring pixels, so that shading is flat.
  const fragmentShader = `#version 300 es
    precision highp float;
    in vec3 place; in vec3 tint; in float beyond;
    uniform float ink; uniform vec3 pen; uniform float evenness;
    out vec4 pixel;
    void main() {
      if (beyond > 0.0) discard;
      if (ink > 0.0) { pixel = vec4(pen, ink); return; }
      vec3 normal = cross(dFdx(place), dFdy(place));
      float light = abs(dot(normal, vec3(0.25, 0.45, 0.86))) / max(length(normal), 1e-30);
      // Behind a section plane the inside is seen.
      float shade = (0.4 + 0.6 * light) * (gl_FrontFacing ? 1.0 : 0.55);
      pixel = vec4(tint * mix(shade, 1.0, evenness), 1.0);
    }`;

  // Pages with a list of parts follow the colours that the reader's system has.
  const darkness = element("list") ? window.matchMedia("(prefers-color-scheme: dark)") : null;

  let gl = null, canvas = null, program = null, faceArrays = null, edgeArrays = null, buffers = [];
  let waiting = false, coarse = null, coarseArrays = null, isMoving = false, rest = 0;

  function shader(type, source) {
    const result = gl.createShader(type);
    gl.shaderSource(result, source);
    gl.compileShader(result);
    if (!gl.getShaderParameter(result, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(result));
    return result;
  }

  function linkedProgram() {
    const result = gl.createProgram();
    gl.attachShader(result, shader(gl.VERTEX_SHADER, vertexShader));
    gl.attachShader(result, shader(gl.FRAGMENT_SHADER, fragmentShader));
    gl.linkProgram(result);
    if (!gl.getProgramParameter(result, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(result));
    return result;
  }

  function filled(target, content) {
    const buffer = gl.createBuffer();
    gl.bindBuffer(target, buffer);
    gl.bufferData(target, content, gl.STATIC_DRAW);
    buffers.push(buffer);
    return buffer;
  }

  // The three attributes of vertices, with one list of indices.
  function vertexArrays(attributes, indices) {
    const result = gl.createVertexArray();
    gl.bindVertexArray(result);
    attributes.forEach(([name, buffer, type, normalized]) => {
      const place = gl.getAttribLocation(program, name);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, type, normalized, 0, 0);
    });
    filled(gl.ELEMENT_ARRAY_BUFFER, indices);
    return result;
  }

  // Makes a canvas and everything that lies in the memory of the graphics device.
  function open() {
    if (canvas) canvas.remove();
    canvas = document.createElement("canvas");
    stage.prepend(canvas);
    gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
    if (!gl) return say("No picture: this browser has no WebGL 2, or it is switched off.");
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      gl = null;
      say("The browser took this picture back to draw others. Click here to see it again.");
      element("message").onclick = open;
    });
    program = linkedProgram();
    gl.useProgram(program);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    buffers = [];
    faceArrays = edgeArrays = coarseArrays = null;
    upload();
    say("");
    resize();
  }

  // Puts the arrays into the memory of the graphics device, in place of those before.
  function upload() {
    if (!gl) return;
    buffers.forEach((buffer) => gl.deleteBuffer(buffer));
    buffers = [];
    gl.deleteVertexArray(faceArrays);
    gl.deleteVertexArray(edgeArrays);
    gl.deleteVertexArray(coarseArrays);
    const attributes = [
      ["position", filled(gl.ARRAY_BUFFER, positions), gl.FLOAT, false],
      ["away", filled(gl.ARRAY_BUFFER, aways), gl.FLOAT, false],
      ["color", filled(gl.ARRAY_BUFFER, colors), gl.UNSIGNED_BYTE, true],
    ];
    faceArrays = vertexArrays(attributes, triangles);
    edgeArrays = vertexArrays(attributes, edges);
    coarse = triangles.length > 3 * many ? coarseTriangles() : null;
    coarseArrays = coarse && vertexArrays(attributes, coarse.triangles);
  }

  function say(text) {
    element("message").textContent = text;
    element("message").hidden = text === "";
    element("bar").hidden = text !== "";
  }

  function resize() {
    if (!gl) return;
    const ratio = window.devicePixelRatio || 1;
    canvas.width = Math.max(1, Math.round(stage.clientWidth * ratio));
    canvas.height = Math.max(1, Math.round(stage.clientHeight * ratio));
    redraw();
  }

  // Draws once before the next frame, however much has changed.
  function redraw() {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      draw();
    });
  }

  // The same while something moves: everything is drawn a moment after it has come to rest.
  function redrawMoving() {
    clearTimeout(rest);
    isMoving = coarse !== null;
    if (isMoving) rest = setTimeout(() => { isMoving = false; redraw(); }, 300);
    redraw();
  }

  // Where the parts that are shown begin and end in all arrays: vertices, triangles, edges and coarse triangles.
  function shownRuns() {
    const isShown = (i) => data.slider === "layers" ? i < Number(element("slider").value) : !element("part-" + i) || element("part-" + i).checked;
    const ends = data.parts.map((part, i) => coarse ? [...part.ends, coarse.ends[i]] : part.ends);
    const runs = ends.map((end, i) => ({ from: i > 0 ? ends[i - 1] : [0, 0, 0, 0], to: end, isMark: data.parts[i].isMark === true }));
    return runs.filter((_, i) => isShown(i));
  }

  // Normal and offset of the plane in front of which nothing is drawn; without one all is behind it.
  function sectionPlane() {
    const axis = element("axis") ? element("axis").value : "";
    if (axis === "") return [0, 0, 0, 1];
    const at = Number(element("cut").value);
    return [axis === "0" ? 1 : 0, axis === "1" ? 1 : 0, axis === "2" ? 1 : 0, at];
  }

  function draw() {
    if (!gl) return;
    const explosion = data.slider === "explode" ? Number(element("slider").value) / 100 : 0;
    const shown = shownRuns();
    const side = Math.min(canvas.width, canvas.height);
    const wide = side / canvas.width, high = side / canvas.height, size = 0.85 * camera.zoom / (1 + 0.5 * explosion);
    const uniform = (name) => gl.getUniformLocation(program, name);
    const isDark = darkness !== null && darkness.matches;
    gl.clearColor(...(isDark ? [0.09, 0.102, 0.125, 1] : [0.965, 0.97, 0.98, 1]));
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix3fv(uniform("rotation"), false, rotation());
    // No point is farther than 1 from the centre, nor moves by more than 1.
    gl.uniform3f(uniform("scale"), size * wide, size * high, 0.98 / (1 + explosion));
    gl.uniform2f(uniform("shift"), camera.x * wide, camera.y * high);
    gl.uniform1f(uniform("explosion"), explosion);
    gl.uniform4f(uniform("cut"), ...sectionPlane());
    gl.uniform1f(uniform("ink"), 0);
    gl.bindVertexArray(isMoving ? coarseArrays : faceArrays);
    const list = isMoving ? 3 : 1, nearer = 0.002 / camera.zoom;
    for (const { from, to, isMark } of shown) {
      // Marks are seen on faces that they lie in, from all sides.
      gl.uniform1f(uniform("nearer"), isMark ? nearer : 0);
      gl.uniform1f(uniform("evenness"), isMark ? 0.8 : 0);
      gl.drawElements(gl.TRIANGLES, 3 * (to[list] - from[list]), gl.UNSIGNED_INT, 12 * from[list]);
    }
    if (isMoving || (data.triangles !== "" && !element("lines").checked)) return;
    // Many edges in a small picture are drawn in lighter ink, so that they do not cover the faces; edges of a pixel or two, not at all.
    const room = 0.03 * side * camera.zoom / Math.sqrt(1 + edges.length), least = 0.02;
    if (room < least && data.triangles !== "") return;
    const ink = Math.min(0.85, Math.max(0.1, room));
    gl.uniform1f(uniform("ink"), ink);
    gl.uniform3f(uniform("pen"), ...(isDark ? [0, 0, 0] : [0.06, 0.08, 0.12]));
    gl.uniform1f(uniform("nearer"), 1.5 * nearer);
    gl.enable(gl.BLEND);
    gl.bindVertexArray(edgeArrays);
    for (const { from, to } of shown) gl.drawElements(gl.LINES, 2 * (to[2] - from[2]), gl.UNSIGNED_INT, 8 * from[2]);
    gl.disable(gl.BLEND);
  }

  // ---- mouse, touch, keyboard ----------------------------------------------------------------------------------

  const pointers = new Map();

  // A place of the window, in halves of the shorter side from the middle of the picture.
  function placed(event) {
    const box = stage.getBoundingClientRect();
    const half = Math.max(1, Math.min(box.width, box.height) / 2);
    const x = event.clientX - box.left - box.width / 2, y = event.clientY - box.top - box.height / 2;
    return { x: x / half, y: -y / half };
  }

  function middle() {
    const [a, b] = [...pointers.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, span: Math.hypot(a.x - b.x, a.y - b.y) };
  }

  // One pointer turns, or shifts with the shift key; two shift and zoom.
  function moved(event) {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const now = placed(event);
    if (pointers.size === 2) {
      const old = middle();
      pointers.set(event.pointerId, now);
      const next = middle();
      shift(next.x - old.x, next.y - old.y);
      if (old.span > 0) zoom(next.span / old.span, next.x, next.y);
    } else {
      pointers.set(event.pointerId, now);
      const dx = now.x - before.x, dy = now.y - before.y;
      if (event.shiftKey || event.buttons === 4) shift(dx, dy);
      else turn(2 * dx, -2 * dy);
    }
    redrawMoving();
  }

  function pressed(event) {
    if (event.target !== canvas) return;
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, placed(event));
  }

  function wheeled(event) {
    event.preventDefault();
    const place = placed(event);
    zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)), place.x, place.y);
    redrawMoving();
  }

  function reset() {
    Object.assign(camera, home);
    redraw();
  }

  const keys = {
    ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
  };

  function typed(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const way = keys[event.key];
    if (way && event.shiftKey) shift(0.1 * way[0], 0.1 * way[1]);
    else if (way) turn(0.1 * way[0], -0.1 * way[1]);
    else if (event.key === "+" || event.key === "=") zoom(1.2, 0, 0);
    else if (event.key === "-") zoom(1 / 1.2, 0, 0);
    else if (event.key === "Home" || event.key === "r" || event.key === "0") reset();
    else return;
    event.preventDefault();
    redrawMoving();
  }

  function slid() {
    const slider = element("slider");
    element("label").textContent = data.slider === "layers" ? `layers ${slider.value} of ${slider.max}` : "explode";
    redrawMoving();
  }

  // The cut in coordinates of the model.
  function cut() {
    const axis = element("axis").value;
    element("cutting").hidden = axis === "";
    if (axis !== "") {
      const { middle, unit } = data.frame, at = middle[Number(axis)] + unit * Number(element("cut").value);
      element("place").textContent = "xyz"[Number(axis)] + " = " + Number(at.toPrecision(6));
    }
    redrawMoving();
  }

  stage.addEventListener("pointerdown", pressed);
  stage.addEventListener("pointermove", moved);
  stage.addEventListener("pointerup", (event) => pointers.delete(event.pointerId));
  stage.addEventListener("pointercancel", (event) => pointers.delete(event.pointerId));
  stage.addEventListener("wheel", wheeled, { passive: false });
  stage.addEventListener("keydown", typed);
  element("reset").addEventListener("click", reset);
  element("lines").addEventListener("change", redraw);
  if (darkness) darkness.addEventListener("change", redraw);
  if (element("axis")) {
    element("axis").addEventListener("change", cut);
    element("cut").addEventListener("input", cut);
  }
  if (element("slider")) element("slider").addEventListener("input", slid);
  new ResizeObserver(resize).observe(stage);

  // The picture of other parts, from here on.
  function show(next) {
    take(next);
    data.parts.forEach((_, i) => element("part-" + i) && element("part-" + i).addEventListener("change", redraw));
    upload();
    redraw();
  }

  show(data);
  open();
  return { show };
}
if (document.getElementById("data")) strataViewer(JSON.parse(document.getElementById("data").textContent));
