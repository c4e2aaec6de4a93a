
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const at = (id) => document.getElementById(id);
  const view = at("view"), names = at("names"), tip = at("tip"), said = at("said");
  const boxes = data.objects.map((o) => ({
    ...o,
    min: o.center.map((c, k) => c - o.size[k] / 2),
    max: o.center.map((c, k) => c + o.size[k] / 2),
  }));

  // --- Vectors and matrices (columns one after the other, as the graphics card reads them) ---
  const sub = (a, b) => a.map((v, k) => v - b[k]);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const unit = (a) => { const l = Math.hypot(...a) || 1; return a.map((v) => v / l); };
  const times = (a, b) => {
    const out = new Float32Array(16);
    for (let c = 0; c < 4; c++) for (let r = 0; r < 4; r++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[4 * k + r] * b[4 * c + k];
      out[4 * c + r] = sum;
    }
    return out;
  };

  // --- What there is to see: bounds of it all ---
  const size = data.size;
  const room = size ? { min: [-size[0] / 2, -size[1] / 2, 0], max: [size[0] / 2, size[1] / 2, size[2]] } : null;
  const around = (list) => {
    const min = [0, 1, 2].map((k) => list.reduce((m, b) => Math.min(m, b.min[k]), Infinity));
    const max = [0, 1, 2].map((k) => list.reduce((m, b) => Math.max(m, b.max[k]), -Infinity));
    return list.length ? { min, max } : { min: [-1, -1, 0], max: [1, 1, 1] };
  };
  const whole = room || around(boxes);
  const middle = (b) => b.min.map((v, k) => (v + b.max[k]) / 2);
  const radius = (b) => Math.max(Math.hypot(...sub(b.max, b.min)) / 2, 1e-6);

  // --- Camera ---
  const camera = { target: [0, 0, 0], yaw: 0, pitch: 0, distance: 1, top: false };
  const reset = (top = camera.top) => {
    const flat = { min: [...whole.min], max: [...whole.max] };
    if (!top) flat.max[2] = Math.min(flat.max[2], flat.min[2] + Math.max(...boxes.map((b) => b.max[2] - flat.min[2]).slice(0, 2000), 1));
    Object.assign(camera, { target: middle(flat), yaw: 0.45, pitch: 0.75, distance: radius(flat) * 2.8, top });
    if (top) Object.assign(camera, { yaw: 0, distance: radius({ min: [...whole.min.slice(0, 2), 0], max: [...whole.max.slice(0, 2), 0] }) * 2.2 });
  };
  let width = 1, height = 1, matrix = new Float32Array(16), eye = [0, 0, 1], axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const aim = () => {
    const pitch = camera.top ? Math.PI / 2 : camera.pitch;
    const back = [Math.sin(camera.yaw) * Math.cos(pitch), -Math.cos(camera.yaw) * Math.cos(pitch), Math.sin(pitch)];
    const right = [Math.cos(camera.yaw), Math.sin(camera.yaw), 0], up = cross(back, right);
    axes = [right, up, back];
    eye = camera.target.map((v, k) => v + back[k] * camera.distance);
    const look = new Float32Array([0, 1, 2].flatMap((k) => [right[k], up[k], back[k], 0]).concat([-dot(right, eye), -dot(up, eye), -dot(back, eye), 1]));
    const reach = camera.distance + radius(whole) * 4, near = camera.top ? -reach : Math.max(camera.distance / 500, reach / 20000), far = reach * 2;
    const lens = new Float32Array(16), s = camera.top ? 1 / (camera.distance * 0.36) : 1 / Math.tan(0.36);
    const fit = Math.min(1, width / height);
    lens[0] = s * fit * height / width; lens[5] = s * fit;
    if (camera.top) { lens[10] = -2 / (far - near); lens[14] = -(far + near) / (far - near); lens[15] = 1; }
    else { lens[10] = -(far + near) / (far - near); lens[11] = -1; lens[14] = -2 * far * near / (far - near); }
    matrix = times(lens, look);
  };
  const project = ([x, y, z]) => {
    const m = matrix, w = m[3] * x + m[7] * y + m[11] * z + m[15];
    if (w <= 0) return null;
    return [(1 + (m[0] * x + m[4] * y + m[8] * z + m[12]) / w) * width / 2, (1 - (m[1] * x + m[5] * y + m[9] * z + m[13]) / w) * height / 2, (m[2] * x + m[6] * y + m[10] * z + m[14]) / w];
  };
  // The ray through a point of the canvas: where it begins, and its direction.
  const ray = (px, py) => {
    const fit = Math.min(1, width / height), u = (2 * px / width - 1) * width / height / fit, v = (1 - 2 * py / height) / fit, [right, up, back] = axes;
    const s = camera.top ? camera.distance * 0.36 : Math.tan(0.36);
    const side = [0, 1, 2].map((k) => (right[k] * u + up[k] * v) * s);
    return camera.top ? [eye.map((e, k) => e + side[k] + back[k] * radius(whole) * 4), back.map((b) => -b)] : [eye, side.map((d, k) => d - back[k])];
  };
  const pick = (px, py) => {
    const [from, way] = ray(px, py);
    let best = -1, nearest = Infinity;
    boxes.forEach((b, i) => {
      let enter = 0, leave = Infinity;
      for (let k = 0; k < 3; k++) {
        const a = (b.min[k] - from[k]) / way[k], c = (b.max[k] - from[k]) / way[k];
        enter = Math.max(enter, Math.min(a, c)); leave = Math.min(leave, Math.max(a, c));
      }
      if (enter <= leave && enter < nearest) { nearest = enter; best = i; }
    });
    return best;
  };

  // --- Drawing ---
  const gl = view.getContext("webgl", { antialias: true });
  const rgb = (text) => [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16) / 255);
  const FACES = [[[1, 3, 7, 5], [1, 0, 0]], [[0, 4, 6, 2], [-1, 0, 0]], [[2, 6, 7, 3], [0, 1, 0]], [[0, 1, 5, 4], [0, -1, 0]], [[4, 5, 7, 6], [0, 0, 1]], [[0, 2, 3, 1], [0, 0, -1]]];
  const EDGES = [0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7];
  const corner = (b, i) => [i & 1 ? b.max[0] : b.min[0], i & 2 ? b.max[1] : b.min[1], i & 4 ? b.max[2] : b.min[2]];
  const face = (out, points, normal, colour) => [0, 1, 2, 0, 2, 3].forEach((i) => out.push(...points[i], ...normal, ...colour));
  const solid = (out, b, colour) => FACES.forEach(([ids, normal]) => face(out, ids.map((i) => corner(b, i)), normal, colour));
  const edges = (out, b, colour) => EDGES.forEach((i) => out.push(...corner(b, i), 0, 0, 0, ...colour));
  const WAYS = [[1, 0], [0, 1], [-1, 0], [0, -1]];
  const arrow = (out, b, colour) => {
    const [fx, fy] = WAYS[b.facing], [cx, cy] = middle(b), z = b.max[2] + 0.002, l = Math.min(b.size[0], b.size[1]) * 0.3;
    const dark = dot(colour, [0.3, 0.6, 0.1]) > 0.45 ? [0.1, 0.1, 0.1] : [0.95, 0.95, 0.95];
    [[1, 0], [-0.6, 0.5], [-0.6, -0.5]].forEach(([u, v]) => out.push(cx + (fx * u - fy * v) * l, cy + (fy * u + fx * v) * l, z, 0, 0, 0, ...dark));
  };
  let program, places, parts;
  const shader = (kind, text) => { const s = gl.createShader(kind); gl.shaderSource(s, text); gl.compileShader(s); gl.attachShader(program, s); };
  const upload = (mode, numbers) => {
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
    return { mode, buffer, count: numbers.length / 9 };
  };
  // Large scenes go to the card in pieces, so that no list of numbers grows beyond what a script may hold.
  const inChunks = (mode, list, add) => {
    const chunks = [];
    for (let i = 0; i < list.length; i += 2000) { const out = []; list.slice(i, i + 2000).forEach((b) => add(out, b)); chunks.push(upload(mode, out)); }
    return chunks;
  };
  const build = () => {
    program = gl.createProgram();
    shader(gl.VERTEX_SHADER, "attribute vec3 p,n,c;uniform mat4 m;varying vec3 k;void main(){gl_Position=m*vec4(p,1.);float l=dot(n,n)<.5?1.:.72+.16*n.z+.10*n.x-.14*n.y;k=c*l;}");
    shader(gl.FRAGMENT_SHADER, "precision mediump float;varying vec3 k;uniform float a;void main(){gl_FragColor=vec4(k,a);}");
    gl.linkProgram(program); gl.useProgram(program);
    places = { m: gl.getUniformLocation(program, "m"), a: gl.getUniformLocation(program, "a") };
    "pnc".split("").forEach((name) => { places[name] = gl.getAttribLocation(program, name); gl.enableVertexAttribArray(places[name]); });
    const surfaces = [], grid = [];
    if (room) {
      const [x, y, z] = room.max, floor = rgb(data.floor), wall = data.wall && rgb(data.wall);
      face(surfaces, [[-x, -y, 0], [x, -y, 0], [x, y, 0], [-x, y, 0]], [0, 0, 1], floor);
      if (data.interior) [[[x, y], [x, -y], [-1, 0, 0]], [[-x, y], [x, y], [0, -1, 0]], [[-x, -y], [-x, y], [1, 0, 0]], [[x, -y], [-x, -y], [0, 1, 0]]].forEach(([a, b, n]) => face(surfaces, [[...a, 0], [...b, 0], [...b, z], [...a, z]], n, wall));
      const shade = floor.map((c) => c * (dot(floor, [0.3, 0.6, 0.1]) > 0.2 ? 0.82 : 1.6)), step = Math.pow(10, Math.max(0, Math.floor(Math.log10(Math.max(x, y) / 3))));
      for (let g = Math.ceil(-x / step) * step; g <= x; g += step) grid.push(g, -y, 0.001, 0, 0, 0, ...shade, g, y, 0.001, 0, 0, 0, ...shade);
      for (let g = Math.ceil(-y / step) * step; g <= y; g += step) grid.push(-x, g, 0.001, 0, 0, 0, ...shade, x, g, 0.001, 0, 0, 0, ...shade);
    }
    parts = {
      surfaces: [upload(gl.TRIANGLES, surfaces)],
      solids: inChunks(gl.TRIANGLES, boxes, (out, b) => solid(out, b, rgb(b.colour))),
      lines: [upload(gl.LINES, grid), ...inChunks(gl.LINES, boxes, (out, b) => edges(out, b, rgb(b.colour).map((c) => c * 0.55)))],
      arrows: inChunks(gl.TRIANGLES, boxes, (out, b) => arrow(out, b, rgb(b.colour))),
      marks: [],
    };
  };
  const paint = (list, alpha = 1) => {
    gl.uniform1f(places.a, alpha);
    list.forEach(({ mode, buffer, count }) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      ["p", "n", "c"].forEach((name, i) => gl.vertexAttribPointer(places[name], 3, gl.FLOAT, false, 36, 12 * i));
      gl.drawArrays(mode, 0, count);
    });
  };
  let due = false;
  const draw = () => { if (!due) { due = true; requestAnimationFrame(() => { due = false; render(); }); } };
  const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const render = () => {
    aim();
    drawNames();
    if (!gl || gl.isContextLost()) return;
    gl.viewport(0, 0, view.width, view.height);
    const back = rgb(style("--back"));
    gl.clearColor(...back, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST); gl.depthFunc(gl.LEQUAL);
    gl.uniformMatrix4fv(places.m, false, matrix);
    gl.enable(gl.CULL_FACE); gl.enable(gl.POLYGON_OFFSET_FILL); gl.polygonOffset(1, 1);
    paint(parts.surfaces); paint(parts.solids);
    gl.disable(gl.POLYGON_OFFSET_FILL);
    paint(parts.lines); paint(parts.arrows);
    if (parts.marks.length) {
      gl.disable(gl.DEPTH_TEST); gl.disable(gl.CULL_FACE);
      gl.enable(gl.BLEND); gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
      paint(parts.marks.filter((m) => m.mode === gl.TRIANGLES), 0.5); paint(parts.marks.filter((m) => m.mode === gl.LINES));
      gl.disable(gl.BLEND);
    }
  };

  // --- Names: nearest first, none over another; the chosen ones always ---
  let labels = false, chosen = [], shared = null, hovered = -1;
  const pen = names.getContext("2d");
  const drawNames = () => {
    const scale = names.width / width;
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    pen.clearRect(0, 0, width, height);
    const first = new Set(chosen);
    const seen = (labels ? boxes.map((_, i) => i) : chosen).map((i) => [project([boxes[i].center[0], boxes[i].center[1], boxes[i].max[2]]), i]).filter(([p]) => p && p[0] > 0 && p[0] < width && p[1] > 0 && p[1] < height);
    seen.sort((a, b) => first.has(b[1]) - first.has(a[1]) || a[0][2] - b[0][2]);
    pen.font = "12px system-ui, sans-serif"; pen.textAlign = "center"; pen.textBaseline = "middle";
    const taken = [];
    for (const [[x, y], i] of seen.slice(0, 1500)) {
      const name = boxes[i].name.trim() || boxes[i].path, text = name.length > 28 ? [...name.slice(0, 60)].slice(0, 27).join("") + "…" : name, w = pen.measureText(text).width + 8;
      const r = [x - w / 2, y - 24, x + w / 2, y - 6];
      if (taken.some((t) => r[0] < t[2] && t[0] < r[2] && r[1] < t[3] && t[1] < r[3])) continue;
      taken.push(r);
      pen.globalAlpha = 0.85; pen.fillStyle = style("--panel"); pen.fillRect(r[0], r[1], w, 18);
      pen.globalAlpha = 1; pen.fillStyle = first.has(i) ? style("--mark") : style("--text"); pen.fillText(text, x, y - 15);
    }
  };

  // --- Choosing ---
  const mark = () => {
    if (gl && parts) {
      parts.marks.forEach((m) => gl.deleteBuffer(m.buffer));
      const lines = [], solids = [], colour = rgb(style("--mark"));
      chosen.forEach((i) => edges(lines, boxes[i], colour));
      if (hovered >= 0) edges(lines, boxes[hovered], colour);
      if (shared) { solid(solids, { min: shared[0], max: shared[1] }, rgb(style("--error"))); }
      parts.marks = [upload(gl.TRIANGLES, solids), upload(gl.LINES, lines)].filter((m) => m.count);
    }
    draw();
  };
  const about = (b) => `${b.type === "OBJECT" ? "" : b.type.toLowerCase() + ", "}${b.support.toLowerCase()}, ${b.size.map((v) => +v.toFixed(2)).join(" × ")} m${b.line ? ", line " + b.line : ""}`;
  const hover = (i, x = 0, y = 0) => {
    tip.hidden = i < 0;
    if (i >= 0) {
      const b = boxes[i], rows = [["b", b.name], ["span", b.path.slice(0, 300)], ["span", about(b)]];
      tip.replaceChildren(...rows.map(([tag, text]) => { const row = document.createElement(tag); row.textContent = text.slice(0, 300); return row; }));
      tip.style.left = `${Math.max(4, Math.min(x + 14, width - tip.offsetWidth - 4))}px`;
      tip.style.top = `${Math.max(4, Math.min(y + 14, height - tip.offsetHeight - 4))}px`;
    }
    if (i !== hovered) { hovered = i; mark(); }
  };
  const focus = () => {
    if (!chosen.length) return;
    const b = around(chosen.map((i) => boxes[i]));
    camera.target = middle(b);
    camera.distance = Math.min(Math.max(radius(b) * 5, radius(whole) * 0.35), radius(whole) * 3);
  };
  const buttons = [];
  const choose = (objects, volume, button) => {
    chosen = objects; shared = volume;
    buttons.forEach((b) => b.setAttribute("aria-pressed", String(b === button)));
    focus(); mark();
  };
  let step = -1;
  const next = (by) => {
    if (!boxes.length) return;
    step = (step + by + boxes.length) % boxes.length;
    choose([step], null, null);
    said.textContent = `${boxes[step].name.slice(0, 200)} (${boxes[step].path.slice(0, 200)}): ${about(boxes[step])}`;
  };

  // --- The panel ---
  at("title").textContent = data.title || "Scene";
  at("facts").textContent = `${boxes.length} object${boxes.length === 1 ? "" : "s"}${size ? `, ${size.map((v) => +v.toFixed(2)).join(" × ")} m` : ""}`;
  const errors = data.findings.filter((f) => f.severity !== "info").length;
  at("count").textContent = errors ? `${errors} finding${errors === 1 ? "" : "s"}` : "No errors";
  data.findings.forEach((finding) => {
    const row = document.createElement("li"), button = document.createElement("button"), head = document.createElement("small"), text = document.createElement("span");
    row.className = finding.severity;
    button.type = "button"; button.setAttribute("aria-pressed", "false");
    head.textContent = finding.code + (finding.line ? ` · line ${finding.line}` : "");
    text.textContent = finding.message.slice(0, 2000);
    button.append(head, text);
    button.addEventListener("click", () => {
      const off = button.getAttribute("aria-pressed") === "true";
      off ? choose([], null, null) : choose(finding.objects, finding.shared, button);
      said.textContent = off ? "" : finding.message.slice(0, 300);
    });
    buttons.push(button); row.append(button); at("findings").append(row);
  });
  at("hidden").hidden = !data.leftOut.length;
  data.leftOut.slice(0, 1000).forEach(({ path, reason }) => { const row = document.createElement("li"); row.textContent = `${path.slice(0, 200)}: ${reason}`; at("left").append(row); });

  // --- Hands and keys ---
  const look = (top) => { reset(top); at("top").setAttribute("aria-pressed", String(top)); at("perspective").setAttribute("aria-pressed", String(!top)); draw(); };
  const turn = (dx, dy) => { camera.yaw -= dx; camera.pitch = Math.max(0.05, Math.min(1.55, camera.pitch + dy)); draw(); };
  const move = (dx, dy) => {
    const s = camera.distance * 0.75 / height, [right, up] = axes;
    camera.target = camera.target.map((v, k) => v - right[k] * dx * s + up[k] * dy * s);
    draw();
  };
  const zoom = (by) => { camera.distance = Math.max(radius(whole) * 0.01, Math.min(radius(whole) * 20, camera.distance * by)); draw(); };
  const toggle = () => { labels = !labels; at("labels").setAttribute("aria-pressed", String(labels)); draw(); };
  at("top").addEventListener("click", () => look(true));
  at("perspective").addEventListener("click", () => look(false));
  at("reset").addEventListener("click", () => { choose([], null, null); said.textContent = ""; look(camera.top); });
  at("labels").addEventListener("click", toggle);
  const fingers = new Map();
  view.addEventListener("pointerdown", (e) => { fingers.set(e.pointerId, [e.offsetX, e.offsetY]); view.setPointerCapture(e.pointerId); hover(-1); });
  view.addEventListener("pointermove", (e) => {
    const now = [e.offsetX, e.offsetY], last = fingers.get(e.pointerId);
    if (!last) return hover(pick(...now), ...now);
    const dx = now[0] - last[0], dy = now[1] - last[1];
    if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== e.pointerId)[1];
      zoom(Math.hypot(last[0] - other[0], last[1] - other[1]) / Math.max(1, Math.hypot(now[0] - other[0], now[1] - other[1])));
      move(dx / 2, dy / 2);
    } else if (camera.top || e.shiftKey || e.buttons > 1) move(dx, dy);
    else turn(dx * 0.008, dy * 0.008);
    fingers.set(e.pointerId, now);
  });
  ["pointerup", "pointercancel"].forEach((kind) => view.addEventListener(kind, (e) => fingers.delete(e.pointerId)));
  view.addEventListener("pointerleave", () => hover(-1));
  view.addEventListener("contextmenu", (e) => e.preventDefault());
  view.addEventListener("wheel", (e) => { e.preventDefault(); zoom(Math.exp(Math.max(-100, Math.min(100, e.deltaY)) * 0.002)); }, { passive: false });
  document.addEventListener("keydown", (e) => {
    if (e.ctrlKey || e.altKey || e.metaKey) return;
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
    if (arrows && document.activeElement === view) {
      e.preventDefault();
      return e.shiftKey || camera.top ? move(arrows[0] * -40, arrows[1] * -40) : turn(arrows[0] * -0.1, arrows[1] * -0.1);
    }
    const act = { "+": () => zoom(0.85), "=": () => zoom(0.85), "-": () => zoom(1.18), t: () => look(true), p: () => look(false), r: () => at("reset").click(), n: () => next(1), b: () => next(-1), l: toggle, Escape: () => { choose([], null, null); said.textContent = ""; } }[e.key.length === 1 ? e.key.toLowerCase() : e.key];
    if (act) { e.preventDefault(); act(); }
  });
  view.addEventListener("webglcontextlost", (e) => e.preventDefault());
  view.addEventListener("webglcontextrestored", () => { build(); mark(); });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", mark);
  new ResizeObserver(() => {
    width = Math.max(1, view.clientWidth); height = Math.max(1, view.clientHeight);
    const scale = Math.min(devicePixelRatio || 1, 2);
    [view, names].forEach((c) => { c.width = Math.round(width * scale); c.height = Math.round(height * scale); });
    draw();
  }).observe(view);
  reset(false);
  if (gl) build(); else said.textContent = "This browser draws no WebGL; the findings are listed all the same.";
  draw();
})();
