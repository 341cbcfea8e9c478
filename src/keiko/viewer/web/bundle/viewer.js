// source/colours.ts
function showInColours(scheme) {
  localStorage.setItem("colours", scheme);
  document.documentElement.style.colorScheme = scheme;
}

// source/panel.ts
function element(tag, content = "", properties = {}) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...typeof content === "string" ? [content] : content);
  return made;
}
var byId = (id) => document.getElementById(id);
function button(name, act2) {
  return element("button", name, { onclick: act2, type: "button" });
}
function download(name, bytes2) {
  const href = URL.createObjectURL(bytes2);
  element("a", "", { href, download: name }).click();
  URL.revokeObjectURL(href);
}
function pickedText(ending) {
  const input = element("input", "", { type: "file", accept: ending });
  return new Promise((use) => {
    input.onchange = () => {
      if (input.files?.[0]) use(input.files[0].text());
    };
    input.click();
  });
}
function longList(into, items, entry2, atOnce4, words2) {
  into.append(...items.slice(0, atOnce4).map(entry2));
  if (items.length <= atOnce4) return into;
  const more = button(words2(items.length - atOnce4), () => {
    into.append(...items.slice(atOnce4).map(entry2));
    more.remove();
  });
  return element("div", [into, more]);
}
function choice(into, names, pressed, choose) {
  into.replaceChildren(...names.map((name) => {
    const made = button(name, () => {
      choice(into, names, name, choose);
      choose(name);
    });
    made.setAttribute("aria-pressed", String(name === pressed));
    return made;
  }));
}
function selection(name, options, chosen, choose) {
  const list2 = element("select", options.map((option) => element("option", option, { selected: option === chosen })), { ariaLabel: name });
  list2.onchange = () => choose(list2.value);
  return element("label", [new Text(`${name} `), list2]);
}
function showPairs(list2, pairs) {
  list2.replaceChildren(...pairs.flatMap(([name, value]) => [element("dt", name), element("dd", value)]));
}
function showFacts(facts2) {
  const { lower, upper } = facts2.bounds;
  const size2 = upper.map((x, i) => (x - lower[i]).toFixed(0)).join(" × ");
  showPairs(byId("facts"), [
    ["file", facts2.inputs.join(", ")],
    ["view", facts2.view],
    ["faces", String(facts2.faces.length)],
    ["size", `${size2} mm`],
    ["materials", facts2.materials.map((m) => m.name).join(", ")],
    ["Keiko", facts2.tool.version],
    ...facts2.remarks.map(({ entity, message }) => ["note", `${entity} ${message}`])
  ]);
}
function showRows(planes, selected, select, change2) {
  const number = (row2, key, least) => {
    const input = element("input", "", {
      type: "number",
      min: least,
      value: String(Number(planes[row2][key].toFixed(2))),
      ariaLabel: key
    });
    input.onchange = () => {
      const value = Number(input.value);
      if (value >= least) change2(row2, { ...planes[row2], [key]: key === "lamps" ? Math.round(value) : value });
    };
    return input;
  };
  const lines2 = planes.map((_, row2) => element("tr", [
    element("td", [element("input", "", { type: "radio", name: "row", checked: row2 === selected, onchange: () => select(row2) })]),
    element("td", [number(row2, "lamps", 1)]),
    element("td", [number(row2, "pitch", 1)]),
    element("td", [number(row2, "diameter", 1)])
  ]));
  const head = element("tr", ["row", "lamps", "pitch mm", "Ø mm"].map((name) => element("th", name)));
  byId("rows").replaceChildren(element("table", [head, ...lines2]));
}

// source/progress.ts
var patience = 1e3;
var timer = 0;
function showProgress(stage, fraction) {
  const shown2 = byId("work"), clear = () => {
    shown2.textContent = "";
  };
  clearTimeout(timer);
  if (fraction >= 1) return clear();
  shown2.textContent = `${stage} ${Math.floor(100 * fraction)} %`;
  timer = window.setTimeout(clear, patience);
}

// source/server.ts
function tokenOf() {
  const fragment = new URLSearchParams(location.hash.slice(1)), given = fragment.get("token");
  if (given) {
    sessionStorage.setItem("token", given);
    fragment.delete("token");
    history.replaceState(null, "", `#${fragment}`);
  }
  return sessionStorage.getItem("token") ?? "";
}
var token = tokenOf();
var headers = { "X-Keiko-Token": token, "X-Keiko-Client": `page-${crypto.randomUUID()}` };
async function ask(method, path, body2, signal) {
  const reply = await fetch(path, { method, headers, body: method === "GET" ? void 0 : body2 ?? "", signal });
  if (reply.ok) return reply;
  const text2 = await reply.text();
  let reason = text2;
  try {
    reason = JSON.parse(text2).error;
  } catch {
  }
  throw new Error(`${path}: ${reason}`);
}
var facts = async () => (await ask("GET", "/scene")).json();
var newRig = async (toml) => (await ask("PUT", "/rig", toml)).json();
var vector = (v) => `[${v.join(", ")}]`;
function planeText(plane) {
  return [
    "[[c_plane]]",
    `origin = ${vector(plane.origin)}`,
    `u = ${vector(plane.u)}`,
    `v = ${vector(plane.v)}`,
    `lamps = ${plane.lamps}`,
    `pitch = ${plane.pitch}`,
    `diameter = ${plane.diameter}`,
    `luminance = ${vector(plane.luminance)}`,
    `caps = "${plane.caps}"`,
    `mirror = "${plane.mirror}"`
  ].join("\n");
}
function cameraText(camera) {
  const lens = camera.projection === "orthographic" ? `orthographic_height = ${camera.orthographic_height}` : `vertical_fov = ${camera.vertical_fov}`;
  return [
    `projection = "${camera.projection}"`,
    `eye = ${vector(camera.eye)}`,
    `target = ${vector(camera.target)}`,
    `up = ${vector(camera.up)}`,
    lens
  ].join("\n");
}
var viewText = (camera) => `format = "keiko-view/1"
${cameraText(camera)}
`;
var hiddenText = (faces) => faces.length > 0 ? `hidden = ${vector(faces)}` : "";
function requestText(camera, planes, more = "") {
  return [
    'format = "keiko-view-request/1"',
    more,
    planes?.length === 0 ? "c_plane = []" : "",
    "[camera]",
    cameraText(camera),
    `size = [${camera.width}, ${camera.height}]`,
    ...(planes ?? []).map(planeText),
    ""
  ].join("\n");
}
async function followProgress(tell) {
  const reader = (await ask("GET", "/events")).body.pipeThrough(new TextDecoderStream()).getReader();
  let text2 = "";
  for (; ; ) {
    const { value, done } = await reader.read();
    if (done) return;
    const lines2 = (text2 + value).split("\n");
    text2 = lines2.pop();
    for (const line of lines2)
      if (line.startsWith("data: ")) {
        const { stage, fraction } = JSON.parse(line.slice(6));
        tell(stage, fraction);
      }
  }
}

// source/vector.ts
var sum = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
var difference = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
var scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
var dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
var length = (a) => Math.hypot(...a);
var unit = (a) => scaled(a, 1 / length(a));
var cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
function turned(a, axis, angle) {
  const along = scaled(axis, dot(axis, a) * (1 - Math.cos(angle)));
  return sum(sum(scaled(a, Math.cos(angle)), scaled(cross(axis, a), Math.sin(angle))), along);
}

// source/camera.ts
function axesOf(camera) {
  const forward = unit(difference(camera.target, camera.eye));
  const right2 = unit(cross(forward, camera.up));
  return { right: right2, up: cross(right2, forward), forward };
}
function pixelSize(camera) {
  const height = camera.projection === "orthographic" ? camera.orthographic_height : 2 * Math.tan(camera.vertical_fov * Math.PI / 360);
  return height / camera.height;
}
var CameraFrame = class {
  constructor(camera) {
    this.camera = camera;
    this.axes = axesOf(camera);
    this.size = pixelSize(camera);
    this.isParallel = camera.projection === "orthographic";
  }
};
function rayOf(camera, x, y) {
  const { right: right2, up, forward } = axesOf(camera);
  const size2 = pixelSize(camera);
  const aside = sum(scaled(right2, (x - camera.width / 2) * size2), scaled(up, (camera.height / 2 - y) * size2));
  return camera.projection === "orthographic" ? { origin: sum(camera.eye, aside), direction: forward } : { origin: camera.eye, direction: unit(sum(forward, aside)) };
}
function orbited(camera, about, right2, up) {
  const vertical = unit(camera.up), axes2 = axesOf(camera);
  const steepest = 0.999;
  const level = dot(turned(axes2.forward, axes2.right, up), vertical);
  const raised = Math.abs(level) < steepest ? up : 0;
  const turn = (v) => turned(turned(v, axes2.right, raised), vertical, right2);
  return {
    ...camera,
    eye: sum(about, turn(difference(camera.eye, about))),
    target: sum(about, turn(difference(camera.target, about)))
  };
}
function panned(camera, x, y) {
  const { right: right2, up } = axesOf(camera);
  const far = camera.projection === "orthographic" ? 1 : length(difference(camera.target, camera.eye));
  const step3 = sum(scaled(right2, -x * pixelSize(camera) * far), scaled(up, y * pixelSize(camera) * far));
  return { ...camera, eye: sum(camera.eye, step3), target: sum(camera.target, step3) };
}
function dollied(camera, factor) {
  const away = scaled(difference(camera.eye, camera.target), factor);
  return {
    ...camera,
    eye: sum(camera.target, away),
    orthographic_height: camera.orthographic_height * factor
  };
}
function lookingAt(camera, place, distance) {
  const away = scaled(unit(difference(camera.eye, camera.target)), distance);
  return { ...camera, target: place, eye: sum(place, away) };
}
function sized(camera, width, height) {
  return { ...camera, width, height };
}

// source/fresnel.ts
function dielectric(c, n) {
  const g2 = n * n - 1 + c * c;
  if (!(g2 > 0)) return 1;
  const g = Math.sqrt(g2), a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return 0.5 * a * a * (1 + b * b);
}
function conductor(c, n, k) {
  const c2 = c * c, s2 = 1 - c2, m = n * n - k * k - s2, root = Math.sqrt(m * m + 4 * n * n * k * k);
  const a = Math.sqrt(Math.max(0.5 * (root + m), 0)), across = root + c2, along = 2 * a * c;
  const s = (across - along) / (across + along), level = c2 * root + s2 * s2, side = along * s2;
  return 0.5 * s * (1 + (level - side) / (level + side));
}
var Mirrors = class {
  // by `face` of a sample plus 1: the ground, nothing, the faces
  constructor(facts2) {
    this.materials = facts2.materials;
    this.ofFace = Uint16Array.from([facts2.ground?.material ?? 0, 0, ...facts2.faces.map((face) => face.material)]);
  }
  /** Number of a face's material. */
  material(face) {
    return this.ofFace[face + 1];
  }
  /** Multiplies a weight, red, green and blue, by what a face reflects at a cosine. */
  weigh(weight, face, cosine) {
    const m = this.materials[this.material(face)], c = Math.abs(cosine);
    if (!m.mirror) weight.fill(0);
    else if (!m.metal) {
      const share2 = dielectric(c, m.n[0]);
      for (let k = 0; k < 3; ++k) weight[k] *= share2;
    } else for (let k = 0; k < 3; ++k) weight[k] *= conductor(c, m.n[k], m.k[k]);
  }
};

// source/ray.ts
var rayNumbers = 18;
var originX = 6;
var originY = 9;
var directionX = 12;
var directionY = 15;
var direction = 3;
var CameraRays = class extends CameraFrame {
  /** Sets a ray to that through a pixel's centre. */
  set(ray, x, y) {
    const { right: right2, up, forward } = this.axes, { eye, width, height } = this.camera, { size: size2 } = this;
    const across = (x + 0.5 - 0.5 * width) * size2, down = (y + 0.5 - 0.5 * height) * size2;
    let square = 0, byX = 0, byY = 0;
    for (let k = 0; k < 3; ++k) {
      const aside = right2[k] * across - up[k] * down, dx = right2[k] * size2, dy = -up[k] * size2;
      ray[k] = eye[k] + (this.isParallel ? aside : 0);
      ray[originX + k] = this.isParallel ? dx : 0, ray[originY + k] = this.isParallel ? dy : 0;
      const d = ray[direction + k] = forward[k] + (this.isParallel ? 0 : aside);
      ray[directionX + k] = this.isParallel ? 0 : dx, ray[directionY + k] = this.isParallel ? 0 : dy;
      square += d * d, byX += d * dx, byY += d * dy;
    }
    if (!this.isParallel) normalize(ray, square, byX, byY);
  }
};
function normalize(ray, square, byX, byY) {
  const perLength = 1 / Math.sqrt(square);
  for (let k = 0; k < 3; ++k) {
    const d = ray[direction + k];
    ray[direction + k] = d * perLength;
    ray[directionX + k] = (ray[directionX + k] - d * byX / square) * perLength;
    ray[directionY + k] = (ray[directionY + k] - d * byY / square) * perLength;
  }
}
function cosineAt(ray, s) {
  return ray[3] * s.normal[0] + ray[4] * s.normal[1] + ray[5] * s.normal[2];
}
function reflect(ray, s) {
  const { normal: n, t } = s, along = cosineAt(ray, s);
  let towardsX = 0, towardsY = 0, turnedX = 0, turnedY = 0;
  for (let k = 0; k < 3; ++k) {
    const d = ray[direction + k];
    ray[k] += d * t;
    ray[originX + k] += ray[directionX + k] * t, ray[originY + k] += ray[directionY + k] * t;
    towardsX += ray[originX + k] * n[k], towardsY += ray[originY + k] * n[k];
    turnedX += ray[directionX + k] * n[k], turnedY += ray[directionY + k] * n[k];
  }
  for (let k = 0; k < 3; ++k) {
    const d = ray[direction + k];
    ray[originX + k] -= d * (towardsX / along), ray[originY + k] -= d * (towardsY / along);
  }
  reflectDirection(ray, s, along, turnedX, turnedY);
}
function reflectDirection(ray, s, along, turnedX, turnedY) {
  s.turn(ray, originX, turnX);
  s.turn(ray, originY, turnY);
  let byX = turnedX, byY = turnedY;
  for (let k = 0; k < 3; ++k) byX += ray[direction + k] * turnX[k], byY += ray[direction + k] * turnY[k];
  for (let k = 0; k < 3; ++k) {
    const n = s.normal[k];
    ray[directionX + k] -= 2 * (turnX[k] * along + n * byX);
    ray[directionY + k] -= 2 * (turnY[k] * along + n * byY);
    ray[direction + k] -= 2 * along * n;
  }
}
var turnX = new Float64Array(3);
var turnY = new Float64Array(3);
function narrow(ray) {
  ray.fill(0, originX);
}

// source/bent_pixel.ts
var coefficients = 10;
function setCubic(to, at, value, slope) {
  const x = slope(0, 0), y = slope(0, 1), leftX = slope(1, 0), rightX = slope(2, 0), aboveY = slope(3, 1), belowY = slope(4, 1);
  const leftY = slope(1, 1), rightY = slope(2, 1), aboveX = slope(3, 0), belowX = slope(4, 0);
  to[at] = value, to[at + 1] = x, to[at + 2] = y;
  to[at + 3] = 0.5 * (rightX - leftX), to[at + 5] = 0.5 * (belowY - aboveY);
  to[at + 4] = 0.25 * (belowX - aboveX + rightY - leftY);
  to[at + 6] = rightX - 2 * x + leftX, to[at + 7] = rightY - 2 * y + leftY;
  to[at + 8] = belowX - 2 * x + aboveX, to[at + 9] = belowY - 2 * y + aboveY;
}
function cubicAt(c, at, x, y) {
  const xx = 0.5 * x * x, yy = 0.5 * y * y;
  return c[at] + c[at + 1] * x + c[at + 2] * y + c[at + 3] * xx + c[at + 4] * x * y + c[at + 5] * yy + c[at + 6] * xx * x / 3 + c[at + 7] * xx * y + c[at + 8] * x * yy + c[at + 9] * yy * y / 3;
}
function cubicByX(c, at, x, y) {
  return c[at + 1] + c[at + 3] * x + c[at + 4] * y + 0.5 * c[at + 6] * x * x + c[at + 7] * x * y + 0.5 * c[at + 8] * y * y;
}
function cubicByY(c, at, x, y) {
  return c[at + 2] + c[at + 4] * x + c[at + 5] * y + 0.5 * c[at + 7] * x * x + c[at + 8] * x * y + 0.5 * c[at + 9] * y * y;
}
var corners = [[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]];
var slices = new Float64Array(4 * coefficients);
function setSlices(row2, axis, rays, around) {
  const along = (a, at) => a[0] * rays[at] + a[1] * rays[at + 1] + a[2] * rays[at + 2];
  const { origin, normal } = row2, base = along;
  [axis, normal].forEach((a, i) => {
    const offset = a[0] * origin[0] + a[1] * origin[1] + a[2] * origin[2];
    setCubic(slices, i * coefficients, base(a, around[0]) - offset, (ray, by) => along(a, around[ray] + 6 + 3 * by));
    setCubic(slices, (2 + i) * coefficients, base(a, around[0] + 3), (ray, by) => along(a, around[ray] + 12 + 3 * by));
  });
}
function cornerPlace(x, y) {
  const t = -cubicAt(slices, coefficients, x, y) / cubicAt(slices, 3 * coefficients, x, y);
  return t > 0 && Number.isFinite(t) ? cubicAt(slices, 0, x, y) + t * cubicAt(slices, 2 * coefficients, x, y) : NaN;
}
function bendAcross(row2, rays, around, image) {
  setSlices(row2, row2.v, rays, around);
  let bend = 0;
  for (const [x, y] of corners) {
    const off = Math.abs(cornerPlace(x, y) - image.centre[1] - x * image.dx[1] - y * image.dy[1]);
    if (!(off <= bend)) bend = off;
    if (Number.isNaN(off)) return NaN;
  }
  return bend;
}
function bendAlong(row2, rays, around, image) {
  const { dx, dy, descent, centre } = image, span = Math.abs(dx[0]) + Math.abs(dy[0]);
  if (!(1 - 0.5 * (Math.abs(descent[0]) + Math.abs(descent[1])) > 0)) return 1;
  setSlices(row2, row2.u, rays, around);
  let off = 0;
  for (const [x, y] of corners)
    off = Math.max(off, Math.abs(cornerPlace(x, y) - centre[0] - (x * dx[0] + y * dy[0]) / (1 + x * descent[0] + y * descent[1])));
  return Math.min(off / span, 1);
}
function partsOfBend(bend) {
  const straight = 0.01, most = 8;
  return bend > straight ? Math.min(Math.ceil(Math.sqrt(bend / straight)), most) : 1;
}
var CubicPixel = class {
  constructor() {
    this.cubics = new Float64Array(6 * coefficients);
    this.ray = new Float32Array(rayNumbers);
  }
  set(rays, around) {
    for (let k = 0; k < 6; ++k) {
      const slopes = k < 3 ? 6 + k : 9 + k;
      setCubic(this.cubics, k * coefficients, rays[around[0] + k], (ray, by) => rays[around[ray] + slopes + 3 * by]);
    }
  }
  /** Sets `ray` to that of a part around a place, whose sides are a share of the pixel's. */
  setPart(x, y, share2) {
    const { cubics, ray } = this;
    for (let k = 0; k < 6; ++k) {
      const slopes = k < 3 ? 6 + k : 9 + k, at = k * coefficients;
      ray[k] = cubicAt(cubics, at, x, y);
      ray[slopes] = cubicByX(cubics, at, x, y) * share2, ray[slopes + 3] = cubicByY(cubics, at, x, y) * share2;
    }
  }
};

// source/clipped_pixel.ts
var wholePixel = [-0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5];
var valueAt = (f, part, i) => f.amid + f.byX * part[i] + f.byY * part[i + 1];
function where(part, side) {
  const cut = [], count = part.length;
  for (let i = 0; i < count; i += 2) {
    const j = (i + 2) % count, from = valueAt(side, part, i), to = valueAt(side, part, j);
    if (from >= 0) cut.push(part[i], part[i + 1]);
    if (from >= 0 === to >= 0) continue;
    const along = from / (from - to);
    cut.push(part[i] + (part[j] - part[i]) * along, part[i + 1] + (part[j + 1] - part[i + 1]) * along);
  }
  return cut;
}
function isAllWhere(part, side) {
  for (let i = 0; i < part.length; i += 2) if (!(valueAt(side, part, i) >= 0)) return false;
  return true;
}
function isAnyWhere(part, side) {
  for (let i = 0; i < part.length; i += 2) if (valueAt(side, part, i) >= 0) return true;
  return false;
}
function area(part) {
  let twice = 0;
  for (let i = 4; i < part.length; i += 2)
    twice += (part[i - 2] - part[0]) * (part[i + 1] - part[1]) - (part[i - 1] - part[1]) * (part[i] - part[0]);
  return Math.abs(twice) / 2;
}

// source/footprint.ts
function footprintOf(row2, rays, at) {
  const along = (axis, k) => axis[0] * rays[at + k] + axis[1] * rays[at + k + 1] + axis[2] * rays[at + k + 2];
  const { u, v, normal, origin } = row2;
  const from = (axis) => along(axis, 0) - axis[0] * origin[0] - axis[1] * origin[1] - axis[2] * origin[2];
  const du = along(u, 3), dv = along(v, 3), dz = along(normal, 3), t = -from(normal) / dz;
  const step3 = (k) => {
    const down = along(normal, k) + t * along(normal, k + 6);
    return [along(u, k) + t * along(u, k + 6) - du / dz * down, along(v, k) + t * along(v, k + 6) - dv / dz * down];
  };
  return {
    t,
    centre: [from(u) + t * du, from(v) + t * dv],
    direction: [du, dv, dz],
    dx: step3(6),
    dy: step3(9),
    descent: [along(normal, 12) / dz, along(normal, 15) / dz]
  };
}
var dot2 = (a, b) => a[0] * b[0] + a[1] * b[1];
var cross2 = (a, b) => a[0] * b[1] - a[1] * b[0];
function beforeHorizon({ descent }) {
  const denominator = { amid: 1, byX: descent[0], byY: descent[1] };
  return isAllWhere(wholePixel, denominator) ? wholePixel : where(wholePixel, denominator);
}
function past({ centre, dx, dy, descent }, slope, from, least) {
  const off = dot2(slope, [centre[0] - from[0], centre[1] - from[1]]) - least;
  return { amid: off, byX: dot2(slope, dx) + off * descent[0], byY: dot2(slope, dy) + off * descent[1] };
}
function between(image, part, low, high3) {
  return where(where(part, past(image, [0, 1], [0, low], 0)), past(image, [0, -1], [0, high3], 0));
}
function acrossCorners({ centre, dx, dy, descent }, part) {
  const rounding = 1e-12 * (1 + Math.abs(descent[0]) + Math.abs(descent[1])), values = [];
  for (let i = 0; i < part.length; i += 2) {
    const before = 1 + descent[0] * part[i] + descent[1] * part[i + 1];
    values.push(before > rounding ? centre[1] + (dx[1] * part[i] + dy[1] * part[i + 1]) / before : NaN);
  }
  return values;
}
function leastArea({ dx, dy, descent }) {
  const most = 1 + (Math.abs(descent[0]) + Math.abs(descent[1])) / 2;
  return Math.abs(cross2(dx, dy)) / most ** 3;
}

// source/tube_end.ts
var straightEnds = (row2) => ({ begin: { at: 0, shear: 0, bulge: 0 }, end: { at: row2.length, shear: 0, bulge: 0 } });
function tubeEnds(row2, [du, dv, dz]) {
  const bulge = 0.5 * row2.diameter * du / Math.hypot(dv, dz), shear = bulge * dv / Math.abs(dz);
  const [first, last] = row2.hasLuminousCaps ? [-Math.abs(bulge), Math.abs(bulge)] : [bulge, bulge];
  return { begin: { at: 0, shear, bulge: first }, end: { at: row2.length, shear, bulge: last } };
}
var TubeEndClipper = class {
  constructor(half, image) {
    this.half = half;
    this.image = image;
  }
  /** Area of a part on the strip around an axis, on one side of an end. */
  area(part, axis, end, side) {
    const isConvex = side === "before" ? end.bulge >= 0 : end.bulge <= 0;
    if (isConvex) return area(this.cut(part, axis, end, side));
    const other = side === "before" ? "past" : "before";
    return Math.max(area(part) - area(this.cut(part, axis, end, other)), 0);
  }
  /** The part on one side of an end, that from which the curve bulges away. */
  cut(part, axis, end, side) {
    const { image, half } = this, sign = side === "before" ? 1 : -1, bulge = Math.abs(end.bulge);
    const from = [end.at, axis], inwards = [-sign, sign * end.shear / half];
    const chord = past(image, inwards, from, 0);
    if (isAllWhere(part, chord)) return part;
    if (bulge === 0) return where(part, chord);
    const tangent = past(image, inwards, from, -bulge);
    if (!isAnyWhere(part, tangent)) return where(part, tangent);
    const [begin, last] = this.arcOn(part, axis);
    const { halvings, halfChord } = this.halvingsOf(Math.hypot(last[0] - begin[0], last[1] - begin[1]) / 2, bulge);
    const level = meanLevel(halfChord);
    return cutAlong(part, begin, last, halvings, (piece, n) => where(piece, past(image, [inwards[0] * n[0], inwards[1] * n[0] - n[1] * bulge / half], from, -level * bulge)));
  }
  /** Begin and end of the arc on which a part lies, of the unit circle that a rim is across a strip. */
  arcOn(part, axis) {
    const steep = 0.99;
    let low = 1, high3 = -1;
    for (const v of acrossCorners(this.image, part)) {
      const q = (v - axis) / this.half;
      low = Number.isFinite(q) ? Math.min(low, q) : -1;
      high3 = Number.isFinite(q) ? Math.max(high3, q) : 1;
    }
    low = low < -steep ? -1 : Math.min(low, steep);
    high3 = high3 > steep ? 1 : Math.max(high3, low, -steep);
    return [[Math.sqrt(1 - low * low), low], [Math.sqrt(1 - high3 * high3), high3]];
  }
  /** Halvings of an arc until its chords are near enough, and half the length of these. */
  halvingsOf(halfChord, bulge) {
    const most = 4, scale = 8 * 0.02 * this.half * bulge, enough = 1e-3 * leastArea(this.image);
    let halvings = 0;
    for (; halvings < most && scale * halfChord ** 3 > enough; ++halvings)
      halfChord = Math.sqrt((1 - Math.sqrt(1 - halfChord * halfChord)) / 2);
    return { halvings, halfChord };
  }
};
function meanLevel(halfChord) {
  return halfChord > 1e-6 ? (Math.sqrt(1 - halfChord * halfChord) + Math.asin(halfChord) / halfChord) / 2 : 1;
}
function cutAlong(part, from, to, halvings, clip) {
  const chord = [to[0] - from[0], to[1] - from[1]], length2 = Math.hypot(...chord);
  const normal = length2 > 1e-6 ? [chord[1] / length2, -chord[0] / length2] : from;
  if (halvings === 0) return clip(part, normal);
  return cutAlong(cutAlong(part, from, normal, halvings - 1, clip), normal, to, halvings - 1, clip);
}

// source/end_coverage.ts
var clamp = (x, low, high3) => Math.min(Math.max(x, low), high3);
function endCoverage(row2, rays, at) {
  if (row2.lamps === 0) return 0;
  const image = footprintOf(row2, rays, at);
  const isPoint = image.dx.concat(image.dy).every((x) => x === 0);
  if (isPoint) image.dx = [1e-6, 0], image.dy = [0, 1e-6];
  const direction2 = row2.isRound ? directionTo(image, wayToRow(row2, image)) : image.direction;
  const ends = row2.isRound ? endsOfTubes(row2, image, direction2) : straightEnds(row2);
  const strips = new RowInPixel(row2, row2.isRound ? apparentDiameter(row2, direction2) : row2.diameter, ends, image);
  const isResolved = Math.max(Math.abs(image.dx[1]), Math.abs(image.dy[1])) <= 4 * row2.pitch;
  return strips.coverage(isResolved);
}
var apparentDiameter = (row2, [, dv, dz]) => row2.diameter * Math.hypot(dv, dz) / Math.abs(dz);
function wayToRow(row2, { centre: [u, v] }) {
  return [clamp(u, 0, row2.length) - u, clamp(v, row2.first, row2.last) - v];
}
function directionTo({ direction: direction2, dx, dy, descent }, way) {
  if (way[0] === 0 && way[1] === 0) return direction2;
  const x = [dx[0] - way[0] * descent[0], dx[1] - way[1] * descent[0]];
  const y = [dy[0] - way[0] * descent[1], dy[1] - way[1] * descent[1]];
  const down = cross2(dx, dy) / cross2(x, y), off = (Math.abs(descent[0]) + Math.abs(descent[1])) / 2;
  return [direction2[0], direction2[1], direction2[2] * (down > 0 ? clamp(down, 1 - off, 1 + off) : 1 + off)];
}
function endsOfTubes(row2, image, direction2) {
  const guess = tubeEnds(row2, direction2), [u, v] = image.centre;
  const axis = row2.first + clamp(Math.round((v - row2.first) / row2.pitch), 0, row2.lamps - 1) * row2.pitch;
  const q = clamp((v - axis) / (apparentDiameter(row2, direction2) / 2), -1, 1), across = wayToRow(row2, image)[1];
  const seen = (end) => tubeEnds(row2, directionTo(image, [end.at + end.shear * q + end.bulge * Math.sqrt(1 - q * q) - u, across]));
  return { begin: seen(guess.begin).begin, end: seen(guess.end).end };
}
var RowInPixel = class {
  constructor(row2, width, ends, image) {
    this.row = row2;
    this.ends = ends;
    this.image = image;
    this.half = width / 2;
    this.clipper = new TubeEndClipper(this.half, image);
    this.pixel = beforeHorizon(image);
    this.beginsWithCap = ends.begin.bulge > 0;
  }
  coverage(isResolved) {
    const isApart = 2 * this.half < this.row.pitch;
    if (isApart && !isResolved) return this.greyBand();
    const [low, high3] = this.lamps();
    let sum2 = 0;
    for (let lamp = low; lamp <= high3; ++lamp) {
      const axis = this.row.first + lamp * this.row.pitch;
      const part = this.cutConvex(between(this.image, this.pixel, axis - this.half, axis + this.half), axis);
      sum2 += this.seenOf(part, axis) - (isApart ? 0 : this.hiddenOf(part, axis));
    }
    return clamp(sum2, 0, 1);
  }
  /** Numbers of the first and the last lamp in the pixel. */
  lamps() {
    const { row: row2, half } = this;
    let low = row2.last, high3 = row2.first;
    for (const v of acrossCorners(this.image, this.pixel)) {
      low = Number.isFinite(v) ? Math.min(low, v) : row2.first;
      high3 = Number.isFinite(v) ? Math.max(high3, v) : row2.last;
    }
    return [
      Math.max(Math.ceil((low - half - row2.first) / row2.pitch), 0),
      Math.min(Math.floor((high3 + half - row2.first) / row2.pitch), row2.lamps - 1)
    ];
  }
  /** Coverage of strips too fine to be distinguished, as the mean over their possible positions. */
  greyBand() {
    const { row: row2, image, ends } = this, count = ends.begin.shear === 0 ? 1 : 8, beyond = row2.pitch / 2;
    let sum2 = 0;
    for (let i = 0; i < count; ++i) {
      const q = (i + 0.5) * 2 / count - 1, at = (end) => end.at + end.shear * q + Math.PI / 4 * end.bulge;
      const band = between(image, this.pixel, row2.first - beyond, row2.last + beyond);
      const straight = (edge) => ({ at: edge, shear: 0, bulge: 0 });
      sum2 += this.clipper.area(this.clipper.cut(band, 0, straight(at(ends.begin)), "past"), 0, straight(at(ends.end)), "before");
    }
    return 2 * this.half / row2.pitch * sum2 / count;
  }
  /** The part of a strip on the lamp's side of its end without a dark cap, or of its begin: it is convex. */
  cutConvex(strip, axis) {
    return this.beginsWithCap ? this.clipper.cut(strip, axis, this.ends.end, "before") : this.clipper.cut(strip, axis, this.ends.begin, "past");
  }
  /** The area of such a part that is on the lamp's side of its other end too. */
  seenOf(part, axis) {
    return this.beginsWithCap ? this.clipper.area(part, axis, this.ends.begin, "past") : this.clipper.area(part, axis, this.ends.end, "before");
  }
  /** The area of such a part behind the neighbour that rays meet before the lamp. */
  hiddenOf(part, axis) {
    const { row: row2, half, ends, clipper } = this, fromBegin = this.beginsWithCap;
    const before = fromBegin === ends.begin.shear > 0 ? axis - row2.pitch : axis + row2.pitch;
    if (before < row2.first - row2.pitch / 2 || before > row2.last + row2.pitch / 2) return 0;
    const both = between(this.image, part, before - half, before + half);
    const hidden = fromBegin ? clipper.cut(both, before, { ...ends.begin, bulge: -Math.abs(ends.begin.bulge) }, "past") : clipper.cut(both, before, { ...ends.end, bulge: Math.abs(ends.end.bulge) }, "before");
    return this.seenOf(hidden, axis);
  }
};

// source/path_set.ts
var PathSet = class {
  constructor() {
    this.count = 0;
    this.list = new Uint32Array(1);
    this.members = new Uint8Array(1);
  }
  /** Makes room for so many paths. */
  reserve(paths) {
    if (this.list.length >= paths) return;
    const list2 = new Uint32Array(2 * paths), members = new Uint8Array(2 * paths);
    list2.set(this.list), members.set(this.members);
    this.list = list2, this.members = members;
  }
  add(path) {
    if (this.members[path] === 1) return;
    this.members[path] = 1;
    this.list[this.count++] = path;
  }
  clear() {
    for (let i = 0; i < this.count; ++i) this.members[this.list[i]] = 0;
    this.count = 0;
  }
};

// source/ray_list.ts
function grown(array, needed) {
  if (array.length >= needed) return array;
  const larger = new array.constructor(Math.max(needed, 2 * array.length));
  larger.set(array);
  return larger;
}
var RayList = class {
  constructor() {
    this.count = 0;
    this.numbers = new Float32Array(rayNumbers);
    this.ways = new Float32Array(1);
    this.weights = new Float32Array(3);
  }
  /** Takes over the memory of a list that is not used any more. */
  takeOver(spent) {
    ({ numbers: this.numbers, ways: this.ways, weights: this.weights } = spent);
  }
  /** Makes room for so many rays. */
  reserve(count) {
    this.numbers = grown(this.numbers, count * rayNumbers);
    this.ways = grown(this.ways, count);
    this.weights = grown(this.weights, 3 * count);
  }
  /** Adds a ray; `weight` is what the reflections so far leave of its light, red, green and blue. */
  add(ray, way, weight) {
    const i = this.count++;
    if (this.ways.length <= i) this.reserve(2 * i + 1);
    const { numbers: numbers2, weights } = this;
    for (let k = 0; k < rayNumbers; ++k) numbers2[i * rayNumbers + k] = ray[k];
    for (let k = 0; k < 3; ++k) weights[3 * i + k] = weight[k];
    this.ways[i] = way;
  }
};

// source/stripe_coverage.ts
var leastWidth = 1e-6;
function below(wide2, narrow2, x) {
  const away = Math.abs(x), reach4 = 0.5 * (wide2 + narrow2);
  if (away >= reach4) return x < 0 ? -0.5 : 0.5;
  const rest3 = reach4 - away;
  const inside = away <= reach4 - narrow2 ? away / wide2 : 0.5 - 0.5 * rest3 * rest3 / (wide2 * narrow2);
  return x < 0 ? -inside : inside;
}
function share(wide2, narrow2, begin, end) {
  const w = Math.max(wide2, leastWidth), n = Math.max(narrow2, leastWidth);
  return Math.max(below(w, n, end) - below(w, n, begin), 0);
}
function offAxis({ first, pitch, lamps }, v) {
  const away = v - first;
  return away - pitch * Math.min(Math.max(Math.round(away / pitch), 0), lamps - 1);
}
function stripeCoverage(row2, width, v, wide2, narrow2) {
  const { pitch, lamps, first, last } = row2;
  if (lamps === 0) return 0;
  if (wide2 > 4 * pitch) {
    const beyond = 0.5 * Math.max(pitch, width);
    return Math.min(width / pitch, 1) * share(wide2, narrow2, first - beyond - v, last + beyond - v);
  }
  const half = 0.5 * width;
  if (!(width < pitch)) return share(wide2, narrow2, first - half - v, last + half - v);
  const spread = 0.5 * (wide2 + narrow2), reach4 = spread + half, away = v - first;
  const off = Math.abs(offAxis(row2, v));
  if (off >= reach4) return 0;
  if (off + spread <= half) return 1;
  const end = Math.min(Math.floor((away + reach4) / pitch), lamps - 1);
  let sum2 = 0;
  for (let lamp = Math.max(Math.ceil((away - reach4) / pitch), 0); lamp <= end; ++lamp) {
    const at = lamp * pitch - away;
    sum2 += share(wide2, narrow2, at - half, at + half);
  }
  return sum2;
}

// source/row_image.ts
var imageNumbers = 9;
function project(row2, rays, at, image, to) {
  const { u, v, normal: n, origin } = row2;
  const dz = n[0] * rays[at + 3] + n[1] * rays[at + 4] + n[2] * rays[at + 5];
  const ox = rays[at] - origin[0], oy = rays[at + 1] - origin[1], oz = rays[at + 2] - origin[2];
  const t = -(n[0] * ox + n[1] * oy + n[2] * oz) / dz;
  if (!(Math.abs(dz) > 1e-12 && t > 0)) {
    image[to] = 0;
    return;
  }
  const du = u[0] * rays[at + 3] + u[1] * rays[at + 4] + u[2] * rays[at + 5];
  const dv = v[0] * rays[at + 3] + v[1] * rays[at + 4] + v[2] * rays[at + 5];
  const ou = u[0] * ox + u[1] * oy + u[2] * oz, ov = v[0] * ox + v[1] * oy + v[2] * oz;
  const slopeU = du / dz, slopeV = dv / dz;
  const xx = rays[at + 6] + rays[at + 12] * t, xy = rays[at + 7] + rays[at + 13] * t, xz = rays[at + 8] + rays[at + 14] * t;
  const yx = rays[at + 9] + rays[at + 15] * t, yy = rays[at + 10] + rays[at + 16] * t, yz = rays[at + 11] + rays[at + 17] * t;
  const xn = n[0] * xx + n[1] * xy + n[2] * xz, yn = n[0] * yx + n[1] * yy + n[2] * yz;
  const xAlong = Math.abs(u[0] * xx + u[1] * xy + u[2] * xz - slopeU * xn);
  const yAlong = Math.abs(u[0] * yx + u[1] * yy + u[2] * yz - slopeU * yn);
  const xAcross = Math.abs(v[0] * xx + v[1] * xy + v[2] * xz - slopeV * xn);
  const yAcross = Math.abs(v[0] * yx + v[1] * yy + v[2] * yz - slopeV * yn);
  const descentX = (n[0] * rays[at + 12] + n[1] * rays[at + 13] + n[2] * rays[at + 14]) / dz;
  const descentY = (n[0] * rays[at + 15] + n[1] * rays[at + 16] + n[2] * rays[at + 17]) / dz;
  const least = 1 - 0.5 * (Math.abs(descentX) + Math.abs(descentY));
  image[to] = t, image[to + 1] = ou + t * du, image[to + 2] = ov + t * dv;
  image[to + 3] = row2.isRound ? Math.sqrt(dv * dv + dz * dz) / Math.abs(dz) : 1;
  image[to + 4] = 0.5 * (xAlong + yAlong);
  image[to + 5] = Math.max(xAcross, yAcross), image[to + 6] = Math.min(xAcross, yAcross);
  image[to + 7] = row2.isRound ? Math.abs(slopeU) : 0, image[to + 8] = least;
}
function coverage(row2, image, from, du, dv) {
  const u = image[from + 1] - du, v = image[from + 2] - dv, width = row2.diameter * image[from + 3];
  const reach4 = widened(image, from, image[from + 4]), room = widened(image, from, image[from + 7] * 0.5 * row2.diameter);
  if (u + reach4 <= -room || u - reach4 >= row2.length + room) return 0;
  const strips = stripeCoverage(row2, width, v, image[from + 5], image[from + 6]);
  if (u - reach4 >= 0 && u + reach4 <= row2.length || !(reach4 > 0 && reach4 < Infinity)) return strips;
  return strips * Math.max(Math.min(u + reach4, row2.length) - Math.max(u - reach4, 0), 0) / (2 * reach4);
}
function steadiness(row2, image, from, du, dv) {
  const u = image[from + 1] - du, half = 0.5 * row2.diameter * image[from + 3];
  const reach4 = widened(image, from, image[from + 4]), room = widened(image, from, image[from + 7] * 0.5 * row2.diameter);
  const beyond = Math.max(-room - u - reach4, u - reach4 - row2.length - room);
  if (beyond >= 0) return beyond;
  const wide2 = image[from + 5], { pitch, lamps } = row2;
  if (wide2 > 4 * pitch || 2 * half >= pitch || lamps === 0) return 0;
  const spread = 0.5 * (wide2 + image[from + 6]), off = Math.abs(offAxis(row2, image[from + 2] - dv));
  if (off - half >= spread) return off - half - spread;
  return Math.max(Math.min(half - off - spread, u - reach4, row2.length - u - reach4), 0);
}
function isAtEnd(row2, image, from, du, dv) {
  const u = image[from + 1] - du, v = image[from + 2] - dv;
  const reach4 = widened(image, from, image[from + 4]), room = widened(image, from, image[from + 7] * 0.5 * row2.diameter);
  if (u + reach4 <= -room || u - reach4 >= row2.length + room) return false;
  if (u - reach4 >= room && u + reach4 <= row2.length - room) return false;
  return !isInGap(row2, image, from, v, row2.diameter * image[from + 3]);
}
function widened(image, from, length2) {
  return image[from + 8] > 0 ? length2 / image[from + 8] : length2 > 0 ? Infinity : 0;
}
function isInGap(row2, image, from, v, width) {
  const least = image[from + 8], reach4 = 0.5 * (image[from + 5] + image[from + 6]);
  const isAway = least > 0 && least * Math.abs(offAxis(row2, v)) > 0.5 * width + reach4;
  return isAway && (v < row2.first || v > row2.last || reach4 < 0.5 * least * row2.pitch);
}
function mayHoldEnd(row2, image, from, du) {
  const u = image[from + 1] - du, reach4 = widened(image, from, image[from + 4] + image[from + 7] * 0.5 * row2.diameter);
  return Math.abs(u) < reach4 || Math.abs(row2.length - u) < reach4;
}
function mayHoldEdge(row2, image, from, [du, dv], off) {
  if (!(image[from] > 0)) return false;
  const u = image[from + 1] - du, along = widened(image, from, image[from + 4] + image[from + 7] * 0.5 * row2.diameter) + off;
  if (u + along <= 0 || u - along >= row2.length) return false;
  const away = image[from + 2] - dv - row2.first, half = 0.5 * row2.diameter * image[from + 3];
  const axis = Math.abs(offAxis(row2, image[from + 2] - dv));
  const spread = widened(image, from, 0.5 * (image[from + 5] + image[from + 6])) + off;
  const isBeside = axis - spread >= half && (away < 0 || away > row2.last - row2.first || axis + spread <= row2.pitch - half);
  if (isBeside) return false;
  return u < along || row2.length - u < along || axis + spread > half;
}

// source/row_coverage.ts
var RowCoverage = class {
  /** `pathOf`: paths by ray; null: a ray's number is that of its path. */
  constructor(rays, pathOf, row2) {
    this.rays = rays;
    this.pathOf = pathOf;
    this.row = row2;
    this.images = new Float32Array(imageNumbers);
    this.covered = new Float32Array(1);
    // 0 to 1, by ray
    this.met = new Uint32Array(1);
    // the rays that meet the plane before another surface
    this.metCount = 0;
    this.projected = 0;
    this.isCurrent = false;
    this.travel = 0;
    // mm that the row has moved in its plane
    this.until = new Float64Array(1);
    // on whose plane the images are
    this.du = 0;
    this.dv = 0;
    this.base = row2;
  }
  /** Takes other rays, of which nothing is known. */
  restart(rays) {
    this.rays = rays, this.base = this.row;
    this.projected = this.metCount = this.du = this.dv = 0;
    this.covered.fill(0);
  }
  /** Makes all images anew from where the row is: rounding no longer tells that it was dragged. False if it was not. */
  renew() {
    if (this.du === 0 && this.dv === 0) return false;
    this.base = this.row, this.projected = this.metCount = this.du = this.dv = 0;
    this.until.fill(0);
    this.isCurrent = false;
    return true;
  }
  /** Takes the row as it is now. One that moved in its plane, or has other lamps, needs no new images. */
  set(row2) {
    if (!row2.hasPlaneOf(this.base) || row2.isRound !== this.base.isRound) this.base = row2, this.projected = this.metCount = 0;
    if (row2.hasLampsOf(this.row)) this.travel += length(difference(row2.origin, this.row.origin));
    else this.until.fill(0);
    this.row = row2;
    this.isCurrent = false;
    const step3 = difference(row2.origin, this.base.origin);
    this.du = dot(row2.u, step3), this.dv = dot(row2.v, step3);
  }
  /** Offset of the row along its lamps and across them since the images were made, mm. */
  get moved() {
    return [this.du, this.dv];
  }
  /** Brings `images` and `covered` up to date; adds the paths that the row covers otherwise than before. */
  update(changed) {
    if (this.isCurrent && this.projected === this.rays.count) return;
    this.images = grown(this.images, imageNumbers * this.rays.count);
    this.covered = grown(this.covered, this.rays.count);
    this.met = grown(this.met, this.rays.count);
    this.until = grown(this.until, this.rays.count);
    const pathOf = this.pathOf?.() ?? null;
    this.projectAll(changed, pathOf);
    this.coverAll(changed, pathOf);
    this.isCurrent = true;
  }
  projectAll(changed, pathOf) {
    const { rays: { numbers: numbers2, ways: ways2, count }, row: row2, images, covered, met, until } = this;
    for (let i = this.projected; i < count; ++i) {
      project(row2, numbers2, rayNumbers * i, images, imageNumbers * i);
      until[i] = 0;
      const t = images[imageNumbers * i];
      if (t > 0 && t <= ways2[i]) met[this.metCount++] = i;
      else if (covered[i] > 0) covered[i] = 0, changed.add(pathOf ? pathOf[i] : i);
    }
    this.projected = count;
  }
  coverAll(changed, pathOf) {
    const { row: row2, images, covered, met, metCount, du, dv, until, travel } = this;
    for (let k = 0; k < metCount; ++k) {
      const i = met[k];
      if (travel < until[i]) continue;
      until[i] = travel + steadiness(row2, images, imageNumbers * i, du, dv);
      const c = Math.fround(coverage(row2, images, imageNumbers * i, du, dv));
      if (c !== covered[i]) covered[i] = c, changed.add(pathOf ? pathOf[i] : i);
    }
  }
  /** Makes `covered` exact at the ends of lamps. */
  finish(changed) {
    const { rays: { numbers: numbers2 }, row: row2, images, covered, met, metCount, du, dv, until } = this, pathOf = this.pathOf?.() ?? null;
    for (let k = 0; k < metCount; ++k) {
      const i = met[k];
      if (!isAtEnd(row2, images, imageNumbers * i, du, dv)) continue;
      const c = Math.fround(endCoverage(row2, numbers2, rayNumbers * i));
      until[i] = 0;
      if (c !== covered[i]) covered[i] = c, changed.add(pathOf ? pathOf[i] : i);
    }
  }
};

// source/row_frame.ts
var RowFrame = class {
  constructor(plane) {
    this.u = unit(plane.u);
    const across = difference(plane.v, scaled(this.u, dot(this.u, plane.v)));
    this.v = unit(across);
    this.normal = cross(this.u, this.v);
    this.origin = plane.origin;
    this.length = length(plane.u);
    this.first = (length(across) - (plane.lamps - 1) * plane.pitch) / 2;
    this.last = this.first + (plane.lamps - 1) * plane.pitch;
    this.pitch = plane.pitch, this.lamps = plane.lamps, this.diameter = plane.diameter;
    this.isRound = plane.mirror !== "flat";
    this.hasLuminousCaps = plane.caps === "luminous";
    this.luminance = plane.luminance;
  }
  /** The way of a ray to the row's plane, mm; negative or not a number if it does not come there. */
  distanceToPlane(origin, direction2) {
    return dot(this.normal, difference(this.origin, origin)) / dot(this.normal, direction2);
  }
  /** The way of a ray to the rectangle between the plane's corners, mm; Infinity if it misses it. */
  distanceTo(origin, direction2) {
    const away = this.distanceToPlane(origin, direction2);
    if (!(away > 0)) return Infinity;
    const at = difference(sum(origin, scaled(direction2, away)), this.origin), along = dot(at, this.u), across = dot(at, this.v);
    const room = this.diameter / 2;
    return along >= 0 && along <= this.length && across >= this.first - room && across <= this.last + room ? away : Infinity;
  }
  /** True if the other row has as many lamps, as thick and as far apart, of the same length. */
  hasLampsOf(other) {
    return this.lamps === other.lamps && this.pitch === other.pitch && this.diameter === other.diameter && this.length === other.length && this.first === other.first && this.isRound === other.isRound;
  }
  /** True if images of rays on the other's plane are those on this one but for an offset. */
  hasPlaneOf(other) {
    const rounding = 1e-12, height = dot(this.normal, difference(this.origin, other.origin));
    return length(difference(this.u, other.u)) < rounding && length(difference(this.v, other.v)) < rounding && Math.abs(height) < rounding * (1 + length(this.origin));
  }
};

// source/lamp_light.ts
var LampLight = class {
  constructor(facts2) {
    this.facts = facts2;
    this.luminance = new Float32Array(3);
    // cd/m2 by path: red, green, blue
    this.changed = new PathSet();
    // whose light the last update changed
    this.divided = new PathSet();
    // whose light is a mean over parts
    this.done = 0;
    // paths that have light
    this.refined = 0;
    // paths that have been looked at by refine()
    this.hasEnds = false;
    // of lamps, exactly
    this.buffer = null;
    this.planes = [];
    this.rows = [];
    this.seen = new Float64Array(4);
    // light, and the opacity of what it comes from
    this.cubic = new CubicPixel();
    this.image = new Float32Array(imageNumbers);
    this.partCoverage = new Float64Array(64);
    this.distances = new Float64Array(64);
    this.order = new Int32Array(64);
    this.ambient = facts2.rig.ambient.map((e) => e / Math.PI);
  }
  /** Takes a buffer and the rows that are lit in it. */
  set(buffer, planes) {
    const isNew = buffer !== this.buffer;
    if (!isNew && planes === this.planes) return;
    if (isNew || planes.length !== this.rows.length) this.done = 0;
    if (isNew) this.changed.clear(), this.divided.clear();
    this.buffer = buffer;
    this.refined = 0, this.hasEnds = false;
    this.rows = planes.slice(0, this.order.length).map((plane, i) => {
      const frame = new RowFrame(plane), known = this.rows[i];
      if (!known) return this.litRow(frame);
      if (isNew) known.first.restart(buffer.first), known.later.restart(buffer.later), known.bends = new Float32Array(0);
      if (plane === this.planes[i]) return known;
      if (!frame.hasPlaneOf(known.frame)) known.bends.fill(-1);
      known.first.set(frame), known.later.set(frame);
      return { ...known, frame };
    });
    this.planes = planes;
    this.rows.forEach((row2) => {
      row2.level = this.rows.findIndex((other) => isInOnePlane(other.frame, row2.frame));
    });
  }
  litRow(frame) {
    const buffer = this.buffer;
    return {
      frame,
      first: new RowCoverage(buffer.first, null, frame),
      later: new RowCoverage(buffer.later, () => this.buffer.pathOfLater, frame),
      bends: new Float32Array(0),
      level: 0
    };
  }
  /** Makes the images of rows that were dragged anew: the light is that of a new buffer, bit for bit. */
  renew() {
    for (const { first, later, bends } of this.rows) {
      const isFirst = first.renew(), isLater = later.renew();
      if (isFirst || isLater) bends.fill(-1), this.refined = 0, this.hasEnds = false;
    }
  }
  /** Brings the light of all paths up to date, without dividing pixels; `changed` has those whose light is another. */
  update() {
    const buffer = this.buffer, { changed, divided } = this;
    changed.clear();
    changed.reserve(buffer.paths), divided.reserve(buffer.paths);
    this.luminance = grown(this.luminance, 3 * buffer.paths);
    for (const row2 of this.rows) row2.first.update(changed), row2.later.update(changed);
    for (let i = 0; this.refined === 0 && i < divided.count; ++i) changed.add(divided.list[i]);
    if (this.refined === 0) divided.clear();
    for (let path = this.done; path < buffer.paths; ++path) changed.add(path);
    this.done = buffer.paths;
    for (let i = 0; i < changed.count; ++i) this.light(changed.list[i], false);
  }
  /** Makes the ends of lamps exact and divides pixels whose image is bent, for some milliseconds; false if there are more. */
  refine(milliseconds) {
    const buffer = this.buffer, { changed } = this, end = performance.now() + milliseconds, often = 256;
    changed.clear();
    if (!this.hasEnds) {
      this.hasEnds = true;
      for (const row2 of this.rows) row2.first.finish(changed), row2.later.finish(changed);
      for (let i = 0; i < changed.count; ++i) this.light(changed.list[i], false);
    }
    for (; this.refined < buffer.paths; ++this.refined) {
      if (this.refined % often === 0 && performance.now() > end) return false;
      this.light(this.refined, true);
    }
    return true;
  }
  light(path, isFine) {
    const { first, later, laterCounts, laterFirst } = this.buffer, { luminance, seen } = this, at = 3 * path;
    if (isFine) {
      if (!this.lookDivided(path)) return;
      this.divided.add(path), this.changed.add(path);
    } else this.look(false, path);
    let passed = 1 - seen[3], weights = first.weights, from = at, way = first.ways[path];
    for (let k = 0; k < 3; ++k) luminance[at + k] = weights[from + k] * seen[k];
    const end = laterFirst[path] + laterCounts[path];
    for (let i = laterFirst[path]; i < end; ++i) {
      weights = later.weights, from = 3 * i, way = later.ways[i];
      this.look(true, i);
      for (let k = 0; k < 3; ++k) luminance[at + k] += passed * weights[from + k] * seen[k];
      passed *= 1 - seen[3];
      if (passed * Math.max(weights[from], weights[from + 1], weights[from + 2]) < this.facts.min_weight) break;
    }
    if (way === Infinity) for (let k = 0; k < 3; ++k) luminance[at + k] += passed * weights[from + k] * this.ambient[k];
  }
  /** Sets `seen` to the light along a ray, from what its rows cover of it. */
  look(isLater, ray) {
    const { rows, seen, order: order3, partCoverage, distances } = this;
    let count = 0;
    seen[0] = seen[1] = seen[2] = seen[3] = 0;
    for (let i = 0; i < rows.length; ++i) {
      const covered = (isLater ? rows[i].later : rows[i].first).covered[ray];
      if (covered > 0) order3[count++] = i, partCoverage[i] = covered;
    }
    if (count === 0) return;
    if (count > 1)
      for (let h = 0; h < count; ++h) {
        const level = rows[rows[order3[h]].level];
        distances[order3[h]] = (isLater ? level.later : level.first).images[imageNumbers * ray];
      }
    this.addUp(count, 1);
  }
  /** Adds to `seen` the light of `order`'s rows, the nearest first, of which each dims those behind it. */
  addUp(count, share2) {
    const { rows, seen, order: order3, partCoverage, distances } = this;
    for (let h = 1; h < count; ++h)
      for (let g = h; g > 0 && distances[order3[g]] < distances[order3[g - 1]]; --g) {
        const nearer = order3[g];
        order3[g] = order3[g - 1], order3[g - 1] = nearer;
      }
    let passed = share2;
    for (let h = 0; h < count; ++h) {
      const covered = passed * partCoverage[order3[h]], { luminance } = rows[order3[h]].frame;
      for (let k = 0; k < 3; ++k) seen[k] += luminance[k] * covered;
      seen[3] += covered, passed -= covered;
    }
  }
  /** The same for a first reflection, as the mean over the parts of a pixel; false if it needs none. */
  lookDivided(path) {
    const buffer = this.buffer;
    if (!buffer.isAmid(path)) return false;
    const nearest = this.nearestRow(path);
    if (nearest < 0) return false;
    const around = this.around(path), parts = partsOfBend(this.bendOf(this.rows[nearest], path, around));
    if (parts === 1 || !this.isAtEdge(path, this.rows[nearest])) return false;
    this.cubic.set(buffer.first.numbers, around);
    this.seen.fill(0);
    for (let y = 0.5; y < parts; ++y)
      for (let x = 0.5; x < parts; ++x) {
        this.cubic.setPart(x / parts - 0.5, y / parts - 0.5, 1 / parts);
        this.addPart(buffer.first.ways[path], 1 / (parts * parts));
      }
    return true;
  }
  addPart(way, share2) {
    const { rows, image, order: order3, partCoverage, distances, cubic } = this;
    let count = 0;
    for (let i = 0; i < rows.length; ++i) {
      const { frame } = rows[i];
      project(frame, cubic.ray, 0, image, 0);
      const t = distances[i] = image[0];
      if (rows[i].level < i) distances[i] = distances[rows[i].level];
      const covered = !(t > 0 && t <= way) ? 0 : isAtEnd(frame, image, 0, 0, 0) ? endCoverage(frame, cubic.ray, 0) : coverage(frame, image, 0, 0, 0);
      if (covered > 0) order3[count++] = i, partCoverage[i] = covered;
    }
    this.addUp(count, share2);
  }
  /** True if a part of a bent pixel may be covered otherwise than its linear image on the nearest plane. */
  isAtEdge(path, nearest) {
    const off = 2 * nearest.bends[path];
    return this.rows.some(({ frame, first }) => mayHoldEdge(frame, first.images, imageNumbers * path, first.moved, off));
  }
  /** The row whose plane a path's first reflection meets first; -1: none. */
  nearestRow(path) {
    let nearest = -1, least = Infinity;
    for (let i = 0; i < this.rows.length; ++i) {
      const t = this.rows[i].first.images[imageNumbers * path];
      if (t > 0 && t < least) least = t, nearest = i;
    }
    return nearest;
  }
  around(path) {
    const { pathOf, pixels, camera: { width } } = this.buffer, pixel = pixels[path];
    return [path, pathOf[pixel - 1], pathOf[pixel + 1], pathOf[pixel - width], pathOf[pixel + width]].map((p) => p * rayNumbers);
  }
  /** Bend of a pixel's image on a row's plane: in pitches across the lamps, at their ends also as a share of its span. */
  bendOf(row2, path, around) {
    const buffer = this.buffer, { numbers: numbers2 } = buffer.first, { frame } = row2;
    if (row2.bends.length < buffer.paths) row2.bends = new Float32Array(buffer.paths).fill(-1);
    if (row2.bends[path] === -1)
      row2.bends[path] = bendAcross(frame, numbers2, around, footprintOf(frame, numbers2, rayNumbers * path));
    const across = row2.bends[path] / frame.pitch;
    if (!mayHoldEnd(frame, row2.first.images, imageNumbers * path, row2.first.moved[0])) return across;
    return Math.max(across, bendAlong(frame, numbers2, around, footprintOf(frame, numbers2, rayNumbers * path)));
  }
};
function isInOnePlane(a, b) {
  const off = a.normal[0] * (b.origin[0] - a.origin[0]) + a.normal[1] * (b.origin[1] - a.origin[1]) + a.normal[2] * (b.origin[2] - a.origin[2]);
  const turn = Math.hypot(
    a.normal[1] * b.normal[2] - a.normal[2] * b.normal[1],
    a.normal[2] * b.normal[0] - a.normal[0] * b.normal[2],
    a.normal[0] * b.normal[1] - a.normal[1] * b.normal[0]
  );
  return turn <= 1e-13 && Math.abs(off) <= 1e-14 * (Math.hypot(...a.origin) + Math.hypot(...b.origin) + a.length + b.length);
}

// source/look_colors.ts
var surfaceLooks = ["zebra", "isophotes", "highlight lines", "curvature", "radius", "draft", "faces"];
var degrees = 180 / Math.PI;
var draftLimit = 3;
var draftRange = 15;
var unknown = [0.07, 0.07, 0.07];
var ground = [0.5, 0.5, 0.5];
function lookColors(look, buffer, scale) {
  const color = colorOf(look, buffer, scale), colors2 = new Float32Array(3 * buffer.paths);
  const facing = facingOf(buffer);
  for (let path = 0; path < buffer.paths; ++path) {
    const own = color(path), shade = 0.55 + 0.45 * facing(path);
    for (let k = 0; k < 3; ++k) colors2[3 * path + k] = own[k] * shade;
  }
  return colors2;
}
function colorOf(look, buffer, scale) {
  switch (look) {
    case "zebra":
      return bands(buffer, zebraPhase(buffer));
    case "isophotes":
      return bands(buffer, (path) => 2 * angleToVertical(normalOf(buffer, path)) / 5);
    case "highlight lines":
      return bands(buffer, highlightPhase(buffer, scale.planes.map((plane) => new RowFrame(plane))));
    case "curvature":
      return curvatureColor(buffer, scale);
    case "radius":
      return radiusColor(buffer, scale);
    case "draft":
      return draftColor(buffer);
    case "faces":
      return (path) => faceColor(faceOf(buffer, path));
  }
}
var normalOf = ({ normals }, path) => [normals[3 * path], normals[3 * path + 1], normals[3 * path + 2]];
var faceOf = ({ samples, pixels }, path) => samples[8 * pixels[path] + 7];
var angleToVertical = (d) => degrees * Math.atan2(Math.hypot(d[0], d[1]), d[2]);
function placeOf({ first: { numbers: numbers2 } }, path) {
  return [numbers2[18 * path], numbers2[18 * path + 1], numbers2[18 * path + 2]];
}
function viewOf(buffer) {
  const { camera } = buffer, { forward } = axesOf(camera);
  return camera.projection === "orthographic" ? () => forward : (path) => unit(difference(placeOf(buffer, path), camera.eye));
}
function facingOf(buffer) {
  const view = viewOf(buffer);
  return (path) => -dot(view(path), normalOf(buffer, path));
}
function zebraPhase({ first: { numbers: numbers2 } }) {
  return (path) => 2 * angleToVertical([numbers2[18 * path + 3], numbers2[18 * path + 4], numbers2[18 * path + 5]]) / 10;
}
function highlightPhase(buffer, rows) {
  return (path) => {
    const place = placeOf(buffer, path), normal = normalOf(buffer, path);
    for (const row2 of rows) {
      const reach4 = dot(row2.normal, difference(row2.origin, place)) / dot(row2.normal, normal);
      if (!(reach4 > 0 && Number.isFinite(reach4) && row2.pitch > 0)) continue;
      const at = sum(place, scaled(normal, reach4));
      return 2 * (dot(row2.v, difference(at, row2.origin)) - row2.first) / row2.pitch + 0.5;
    }
    return NaN;
  };
}
function reachOf(buffer, values) {
  const { pathOf, pixels, camera: { width }, rowStep } = buffer;
  const slope = (path, step3) => {
    let least = Infinity;
    for (const other of [pathOf[pixels[path] - step3], pathOf[pixels[path] + step3]])
      if (other >= 0 && faceOf(buffer, other) === faceOf(buffer, path)) {
        const change2 = Math.abs(values[other] - values[path]);
        if (change2 < least) least = change2;
      }
    return least < Infinity ? least : 0;
  };
  return (path) => 0.5 * (slope(path, 1) + slope(path, width * rowStep) / rowStep);
}
function bands(buffer, phase) {
  const dark = 0.06, light = 0.94, values = Float64Array.from({ length: buffer.paths }, (_, path) => phase(path));
  const reach4 = reachOf(buffer, values);
  const lightUpTo = (x) => {
    const whole = Math.floor(x / 2);
    return whole + Math.min(Math.max(x - 2 * whole - 1, 0), 1);
  };
  return (path) => {
    const x = values[path], r = Math.max(1e-6, 1e-12 * Math.abs(x), reach4(path));
    const share2 = Number.isNaN(x) ? 0.5 : (lightUpTo(x + r) - lightUpTo(x - r)) / (2 * r), grey = dark + (light - dark) * share2;
    return [grey, grey, grey];
  };
}
var mixed = (a, b, share2) => {
  const t = Math.min(Math.max(share2, 0), 1);
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
};
var signedStops = [[0.02, 0.12, 0.55], [0.25, 0.55, 0.9], [0.87, 0.87, 0.87], [0.95, 0.5, 0.25], [0.6, 0.02, 0.05]];
function curvatureOf({ kind, across }, surface) {
  const [larger, smaller] = surface.principal;
  switch (kind) {
    case "mean":
      return surface.mean;
    case "gauss":
      return larger * smaller;
    case "k1":
      return larger;
    case "k2":
      return smaller;
    case "absolute":
      return Math.abs(larger) + Math.abs(smaller);
    case "section":
      return surface.along(unit(across));
  }
}
function sharpestOf({ principal: [larger, smaller] }) {
  return Math.max(Math.abs(larger), Math.abs(smaller));
}
var radiusColorAt = (share2) => rainbow(1 - share2);
var curvatureColorAt = (kind) => kind === "absolute" ? rainbow : signedColor;
function radiusColor(buffer, { radii: [low, high3] }) {
  return (path) => {
    const surface = buffer.surfaceOf(path), k = sharpestOf(surface);
    if (surface.face < 0) return ground;
    if (Number.isNaN(k)) return unknown;
    return radiusColorAt(k > 0 ? Math.log(1 / k / low) / Math.log(high3 / low) : 1);
  };
}
function curvatureColor(buffer, { kind, across, fullCurvature }) {
  const colorAt = curvatureColorAt(kind);
  return (path) => {
    const surface = buffer.surfaceOf(path);
    if (surface.face < 0 && kind === "absolute") return ground;
    const share2 = curvatureOf({ kind, across }, surface) / fullCurvature;
    return Number.isNaN(share2) ? unknown : colorAt(share2);
  };
}
function signedColor(share2) {
  const at = 2 * (Math.min(Math.max(share2, -1), 1) + 1), first = Math.min(3, Math.floor(at));
  return mixed(signedStops[first], signedStops[first + 1], at - first);
}
function rainbow(share2) {
  const x = 4 * Math.min(Math.max(share2, 0), 1), inside = (value) => Math.min(Math.max(value, 0), 1);
  return [inside(x - 2), inside(Math.min(x, 4 - x)), inside(2 - x)];
}
function draftColor(buffer) {
  const steps = 8, floatAngle = 1e-4;
  const angles = Float64Array.from({ length: buffer.paths }, (_, path) => 90 - angleToVertical(normalOf(buffer, path)));
  const reach4 = reachOf(buffer, angles);
  const at = (angle) => {
    if (angle < -floatAngle) return mixed([0.98, 0.45, 0.32], [0.68, 0.02, 0.05], -angle / draftRange);
    if (angle < draftLimit - floatAngle) return [0.99, 0.84, 0.2];
    return mixed([0.6, 0.8, 0.95], [0.08, 0.27, 0.75], (angle - draftLimit) / (draftRange - draftLimit));
  };
  return (path) => {
    if (faceOf(buffer, path) < 0) return ground;
    const mean = [0, 0, 0], r = reach4(path);
    for (let i = 0; i < steps; ++i) {
      const own = at(angles[path] + r * ((2 * i + 1) / steps - 1));
      for (let k = 0; k < 3; ++k) mean[k] += own[k] / steps;
    }
    return mean;
  };
}
function faceColor(face) {
  if (face < 0) return ground;
  const golden = 0.61803398875, hue = face * golden % 1, value = 0.75 + 0.25 * (face * 7 % 4) / 3;
  const channel = (shift) => value * (0.45 + 0.55 * Math.min(Math.max(Math.abs((hue + shift) % 1 * 6 - 3) - 1, 0), 1));
  return [channel(0), channel(2 / 3), channel(1 / 3)];
}

// source/surface.ts
var Surface = class {
  constructor() {
    this.t = 0;
    this.way = 0;
    this.face = 0;
    this.xx = 0;
    this.xy = 0;
    this.yy = 0;
    this.normal = new Float64Array(3);
    this.x = new Float64Array(3);
    // tangents [Duff2017]
    this.y = new Float64Array(3);
  }
  /** Reads the eight numbers from a place on. */
  read(samples, at) {
    this.t = samples[at], this.way = samples[at + 6], this.face = samples[at + 7];
    this.xx = samples[at + 3], this.xy = samples[at + 4], this.yy = samples[at + 5];
    const p = samples[at + 1], q = samples[at + 2], away = Math.abs(p) + Math.abs(q);
    const isLower = Math.fround(away) > 1;
    const a = isLower ? (1 - Math.abs(q)) * (p < 0 ? -1 : 1) : p, b = isLower ? (1 - Math.abs(p)) * (q < 0 ? -1 : 1) : q;
    const c = 1 - away, perLength = 1 / Math.sqrt(a * a + b * b + c * c);
    this.setNormal(a * perLength, b * perLength, c * perLength, isLower ? -1 : 1);
  }
  setNormal(nx, ny, nz, side) {
    const { normal, x, y } = this, c = -1 / (side + nz), d = nx * ny * c;
    normal[0] = nx, normal[1] = ny, normal[2] = nz;
    x[0] = 1 + side * nx * nx * c, x[1] = side * d, x[2] = -side * nx;
    y[0] = d, y[1] = side + ny * ny * c, y[2] = -ny;
  }
  /** True beside poles, where the shape is not known. */
  get isPoint() {
    return Number.isNaN(this.xx);
  }
  /** Mean curvature, 1/mm, positive where the surface bends towards the normal. */
  get mean() {
    return 0.5 * (this.xx + this.yy);
  }
  /** Both principal curvatures, 1/mm, the greater first. */
  get principal() {
    const spread = Math.hypot(0.5 * (this.xx - this.yy), this.xy);
    return [this.mean + spread, this.mean - spread];
  }
  /** Curvature, 1/mm, of the normal section along a plane with a unit normal; NaN where the plane touches the surface. */
  along(plane) {
    const { normal: n, x, y } = this, touching = 1e-6;
    const a = plane[1] * n[2] - plane[2] * n[1], b = plane[2] * n[0] - plane[0] * n[2], c = plane[0] * n[1] - plane[1] * n[0];
    const p = a * x[0] + b * x[1] + c * x[2], q = a * y[0] + b * y[1] + c * y[2], squared = p * p + q * q;
    return squared > touching * touching ? (this.xx * p * p + 2 * this.xy * p * q + this.yy * q * q) / squared : NaN;
  }
  /** Writes the change of the normal along a step, which is three numbers of a ray from a place on. */
  turn(ray, at, change2) {
    const { x, y } = this;
    const a = ray[at] * x[0] + ray[at + 1] * x[1] + ray[at + 2] * x[2];
    const b = ray[at] * y[0] + ray[at + 1] * y[1] + ray[at + 2] * y[2];
    const byX = -(this.xx * a + this.xy * b), byY = -(this.xy * a + this.yy * b);
    for (let k = 0; k < 3; ++k) change2[k] = x[k] * byX + y[k] * byY;
  }
};

// source/surface_buffer.ts
var numbersOfSample = 8;
var wordsOfBounce = 9;
var SurfaceBuffer = class {
  // by pixel: 1 right, 2 down
  /** `spent`: a buffer whose memory it may take over, since nobody uses that one any more. */
  constructor(camera, mirrors, spent = null) {
    this.camera = camera;
    this.mirrors = mirrors;
    // by pixel; -1: no surface
    this.first = new RayList();
    this.later = new RayList();
    this.pixels = new Uint32Array(1);
    // by path
    this.normals = new Float32Array(3);
    // by path
    this.laterCounts = new Uint32Array(1);
    // by path: reflections in `later`
    this.laterFirst = new Uint32Array(1);
    // by path: the first of them
    this.pathOfLater = new Uint32Array(1);
    this.ray = new Float64Array(rayNumbers);
    this.weight = new Float64Array(3);
    this.surface = new Surface();
    this.joins = null;
    const size2 = camera.width * camera.height, isSame = spent?.pathOf.length === size2;
    this.samples = isSame ? spent.samples : new Float32Array(numbersOfSample * size2);
    this.pathOf = (isSame ? spent.pathOf : new Int32Array(size2)).fill(-1);
    if (spent) this.takeOver(spent);
    this.rays = new CameraRays(camera);
    this.rowStep = camera.height;
  }
  takeOver(spent) {
    this.first.takeOver(spent.first), this.later.takeOver(spent.later);
    this.pixels = spent.pixels, this.normals = spent.normals, this.pathOfLater = spent.pathOfLater;
    this.laterCounts = spent.laterCounts, this.laterFirst = spent.laterFirst;
  }
  get paths() {
    return this.first.count;
  }
  /** Takes rows of the picture, which were not there before. */
  add(pass) {
    const { width } = this.camera, bounces = new Float32Array(pass.bounces.buffer, pass.bounces.byteOffset, pass.bounces.byteLength / 4);
    const owners = new Uint32Array(bounces.buffer, bounces.byteOffset, bounces.length);
    let next = 0;
    this.reserve(pass.samples);
    for (let row2 = 0; row2 * width * numbersOfSample < pass.samples.length; ++row2) {
      const y = pass.first + row2 * pass.step, at = row2 * width * numbersOfSample;
      this.samples.set(pass.samples.subarray(at, at + width * numbersOfSample), y * width * numbersOfSample);
      for (let x = 0; x < width; ++x) {
        const pixel = y * width + x;
        if (!Number.isFinite(this.samples[numbersOfSample * pixel])) continue;
        this.begin(x, y, pixel);
        for (; owners[next] === pixel && next < owners.length; next += wordsOfBounce) this.bounce(bounces, next + 1);
      }
    }
    this.rowStep = pass.first === 0 ? pass.step : Math.min(this.rowStep, pass.first);
    this.joins = null;
  }
  /** Makes room for the paths of samples. */
  reserve(samples) {
    let paths = this.paths;
    for (let at = 0; at < samples.length; at += numbersOfSample) if (Number.isFinite(samples[at])) ++paths;
    this.first.reserve(paths);
    this.pixels = grown(this.pixels, paths);
    this.normals = grown(this.normals, 3 * paths);
    this.laterCounts = grown(this.laterCounts, paths);
    this.laterFirst = grown(this.laterFirst, paths);
  }
  /** Begins the path of a pixel by its first reflection. */
  begin(x, y, pixel) {
    const { ray, weight, surface, mirrors } = this, path = this.paths;
    surface.read(this.samples, numbersOfSample * pixel);
    this.rays.set(ray, x, y);
    weight.fill(1);
    mirrors.weigh(weight, surface.face, cosineAt(ray, surface));
    reflect(ray, surface);
    if (surface.isPoint) narrow(ray);
    this.first.add(ray, surface.way, weight);
    this.pixels[path] = pixel, this.laterCounts[path] = 0, this.laterFirst[path] = this.later.count;
    for (let k = 0; k < 3; ++k) this.normals[3 * path + k] = surface.normal[k];
    this.pathOf[pixel] = path;
  }
  /** Goes on along the last path, to the surface of a bounce. */
  bounce(numbers2, at) {
    const { ray, weight, surface, mirrors } = this;
    surface.read(numbers2, at);
    mirrors.weigh(weight, surface.face, cosineAt(ray, surface));
    reflect(ray, surface);
    if (surface.isPoint) narrow(ray);
    this.pathOfLater = grown(this.pathOfLater, this.later.count + 1);
    this.pathOfLater[this.later.count] = this.paths - 1;
    this.later.add(ray, surface.way, weight);
    ++this.laterCounts[this.paths - 1];
  }
  /** The surface of a path, which the next call changes. */
  surfaceOf(path) {
    this.surface.read(this.samples, numbersOfSample * this.pixels[path]);
    return this.surface;
  }
  /** True if all four neighbours of a path's pixel show the same smooth surface. */
  isAmid(path) {
    this.joins ??= this.joined();
    const { width, height } = this.camera, pixel = this.pixels[path], x = pixel % width;
    if (x === 0 || x === width - 1 || pixel < width || pixel >= width * (height - 1)) return false;
    return (this.joins[pixel] & this.joins[pixel - 1] & 1) === 1 && (this.joins[pixel] & this.joins[pixel - width] & 2) === 2;
  }
  joined() {
    const { width } = this.camera, joins = new Uint8Array(this.pathOf.length);
    for (let path = 0; path < this.paths; ++path) {
      const pixel = this.pixels[path];
      if (this.continues(path, this.pathOf[pixel + 1])) joins[pixel] |= 1;
      if (pixel + width < joins.length && this.continues(path, this.pathOf[pixel + width])) joins[pixel] |= 2;
    }
    return joins;
  }
  /** True if two paths begin on one smooth surface; the rule of render/reflection/shading_point. */
  continues(a, b) {
    if (b === void 0 || b < 0) return false;
    const face = (path) => this.samples[numbersOfSample * this.pixels[path] + 7];
    const isPoint = (path) => Number.isNaN(this.samples[numbersOfSample * this.pixels[path] + 3]);
    if (isPoint(a) || isPoint(b) || this.mirrors.material(face(a)) !== this.mirrors.material(face(b))) return false;
    const { normals: n, first: { numbers: r } } = this, i = 3 * a, j = 3 * b, p = rayNumbers * a, q = rayNumbers * b;
    const along = n[i] * n[j] + n[i + 1] * n[j + 1] + n[i + 2] * n[j + 2];
    const cx = n[i + 1] * n[j + 2] - n[i + 2] * n[j + 1], cy = n[i + 2] * n[j] - n[i] * n[j + 2];
    const cz = n[i] * n[j + 1] - n[i + 1] * n[j], widest = 0.031091204;
    if (!(cx * cx + cy * cy + cz * cz <= widest * along * along)) return false;
    const sx = r[q] - r[p], sy = r[q + 1] - r[p + 1], sz = r[q + 2] - r[p + 2];
    const off = Math.min(Math.abs(sx * n[i] + sy * n[i + 1] + sz * n[i + 2]), Math.abs(sx * n[j] + sy * n[j + 1] + sz * n[j + 2]));
    return off * off <= 0.04 * (sx * sx + sy * sy + sz * sz);
  }
};

// source/projection.ts
var Projection = class extends CameraFrame {
  constructor() {
    super(...arguments);
    this.x = 0;
    // px
    this.y = 0;
    // px
    this.depth = 0;
  }
  // mm from the eye, or from its plane
  /** Takes the place that three numbers state; false for one beside or behind an eye. */
  set(numbers2, at = 0) {
    const { camera: { eye, width, height }, axes: { right: right2, up, forward } } = this;
    const a = numbers2[at] - eye[0], b = numbers2[at + 1] - eye[1], c = numbers2[at + 2] - eye[2];
    this.depth = a * forward[0] + b * forward[1] + c * forward[2];
    const scale = 1 / (this.size * (this.isParallel ? 1 : this.depth));
    this.x = 0.5 * width + (a * right2[0] + b * right2[1] + c * right2[2]) * scale;
    this.y = 0.5 * height - (a * up[0] + b * up[1] + c * up[2]) * scale;
    return scale > 0;
  }
};

// source/sight.ts
var slack = 2e-3;
var Sight = class extends Projection {
  constructor(buffer) {
    super(buffer.camera);
    this.buffer = buffer;
  }
  /** True if a place is as near as the surface at its pixel or one beside it: curves on silhouettes are seen. */
  sees(place) {
    if (!this.set(place)) return false;
    const away = this.isParallel ? this.depth : length(difference(place, this.camera.eye));
    return away <= this.farthest(Math.floor(this.x), Math.floor(this.y)) * (1 + slack);
  }
  /** The farthest surface at a pixel and around it, mm along the ray; 0 without any. */
  farthest(x, y) {
    const { buffer: { rowStep, pathOf, samples }, camera: { width, height } } = this, row2 = y - y % rowStep;
    let farthest = 0;
    for (let j = Math.max(row2 - rowStep, 0); j <= row2 + rowStep && j < height; j += rowStep)
      for (let i = Math.max(x - 1, 0); i <= x + 1 && i < width; ++i)
        if (pathOf[j * width + i] >= 0) farthest = Math.max(farthest, samples[8 * (j * width + i)]);
    return farthest;
  }
};

// source/picture.ts
var looks = ["lamps", ...surfaceLooks];
var srgb = (c) => c <= 31308e-7 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055;
var byteSteps = 1 << 16;
var bytes = Uint8Array.from({ length: byteSteps + 1 }, (_, i) => Math.round(255 * srgb(i / byteSteps)));
var byteOf = (share2) => bytes[share2 >= 1 ? byteSteps : share2 > 0 ? Math.round(byteSteps * share2) : 0];
var word = (r, g, b) => (4278190080 | b << 16 | g << 8 | r) >>> 0;
var Picture = class {
  // of the image, one a pixel
  constructor(canvas, facts2) {
    this.canvas = canvas;
    this.facts = facts2;
    this.buffer = null;
    this.shown = "";
    this.shownBuffer = null;
    this.image = new ImageData(1, 1);
    this.words = new Uint32Array(this.image.data.buffer);
    this.context = canvas.getContext("2d", { alpha: false, willReadFrequently: true });
    this.mirrors = new Mirrors(facts2);
    this.lamps = new LampLight(facts2);
  }
  /** An empty buffer for a camera's picture, in the memory of one that is not used any more. */
  bufferFor(camera, spent = null) {
    return new SurfaceBuffer(camera, this.mirrors, spent);
  }
  /** Takes the buffer that is shown from now on. */
  show(buffer) {
    this.buffer = buffer;
  }
  /** Draws the buffer in hand; false without one. */
  draw(display) {
    const { buffer } = this;
    if (!buffer) return false;
    this.size(buffer.camera);
    if (display.look === "lamps") this.drawLamps(display, buffer);
    else this.drawLook(display.look, display, buffer);
    this.repeatRows(buffer);
    this.context.putImageData(this.image, 0, 0);
    return true;
  }
  /** Forgets how rows of lamps were dragged: the next drawing is that of a new picture. */
  renew() {
    this.lamps.renew();
  }
  /** Divides pixels whose image of the lamps is bent, for some milliseconds; false if there are more. */
  refine(display, milliseconds) {
    if (!this.buffer || display.look !== "lamps" || this.buffer.rowStep > 1) return true;
    const isDone = this.lamps.refine(milliseconds);
    this.writeChanged(display.white);
    this.context.putImageData(this.image, 0, 0);
    return isDone;
  }
  /** Luminance, cd/m2, that 1 % of the body's picture exceeds as it was drawn: white in a still. */
  whiteOf() {
    const { buffer } = this;
    if (!buffer) return 1;
    const light = this.lamps.luminance, values = new Float64Array(buffer.paths);
    for (let path = 0; path < buffer.paths; ++path)
      values[path] = 0.2126 * light[3 * path] + 0.7152 * light[3 * path + 1] + 0.0722 * light[3 * path + 2];
    return quantile(values, 0.99) || 1;
  }
  /** The round curvature of a look that 2 % of the body's picture exceed. */
  usualCurvature(look) {
    const sizes = this.bodyValues((surface) => Math.abs(curvatureOf(look, surface)));
    return roundUp(quantile(Float64Array.from(sizes), 0.98) || 1e-3);
  }
  /** Round radii, mm, between which lie all but 2 % of the body's picture on either side; workflow/radius_picture. */
  usualRadii() {
    const flat2 = 1e6;
    const radii = Float64Array.from(this.bodyValues(sharpestOf).filter((k) => k * flat2 > 1), (k) => 1 / k);
    if (radii.length === 0) return [1, 1e3];
    const low = 1 / roundUp(1 / quantile(radii, 0.02));
    return [low, Math.max(roundUp(quantile(radii, 0.98)), 10 * low)];
  }
  /** A value of each path that sees the body, where it is known. */
  bodyValues(value) {
    const { buffer } = this, values = [];
    for (let path = 0; buffer && path < buffer.paths; ++path) {
      const surface = buffer.surfaceOf(path), known = surface.face > 0 ? value(surface) : NaN;
      if (!Number.isNaN(known)) values.push(known);
    }
    return values;
  }
  /** The path of a pixel, or of the nearest above that is there; -1 without one. */
  pathAt(x, y) {
    const { buffer } = this;
    return buffer?.pathOf[Math.floor(y / buffer.rowStep) * buffer.rowStep * buffer.camera.width + x] ?? -1;
  }
  /** What the buffer in hand sees; null without one. */
  sight() {
    return this.buffer && new Sight(this.buffer);
  }
  /** The nearest row of lamps whose plane the first reflection at a pixel meets; -1 without one. */
  rowAt(x, y, planes) {
    const ray = this.reflectionAt(x, y);
    if (!ray) return -1;
    const distances = planes.map((plane) => new RowFrame(plane).distanceTo(ray.origin, ray.direction));
    const nearest = Math.min(...distances);
    return nearest < Infinity ? distances.indexOf(nearest) : -1;
  }
  /** Where the first reflection at a pixel meets the plane of a row, even beyond its lamps; null if it does not. */
  mirroredOn(x, y, plane) {
    const ray = this.reflectionAt(x, y), away = ray ? new RowFrame(plane).distanceToPlane(ray.origin, ray.direction) : -1;
    return ray && away > 0 ? sum(ray.origin, scaled(ray.direction, away)) : null;
  }
  /** The first reflected ray at a pixel. */
  reflectionAt(x, y) {
    const path = this.pathAt(x, y), ray = this.buffer?.first.numbers, at = rayNumbers * path;
    if (!ray || path < 0) return null;
    return { origin: [ray[at], ray[at + 1], ray[at + 2]], direction: [ray[at + 3], ray[at + 4], ray[at + 5]] };
  }
  /** The surface at a pixel, if there is one. */
  pick(x, y) {
    const { buffer } = this, path = this.pathAt(x, y);
    if (!buffer || path < 0) return null;
    const { t, normal, face, principal: [k1, k2] } = buffer.surfaceOf(path);
    const pixel = [x + 0.5, y + 0.5], { origin, direction: direction2 } = rayOf(buffer.camera, ...pixel);
    return {
      camera: buffer.camera,
      pixel,
      place: sum(origin, scaled(direction2, t)),
      normal: [...normal],
      radii: [1 / k1, 1 / k2],
      face
    };
  }
  size({ width, height }) {
    if (this.canvas.width !== width || this.canvas.height !== height) this.canvas.width = width, this.canvas.height = height;
    if (this.image.width === width && this.image.height === height) return;
    this.image = new ImageData(width, height);
    this.words = new Uint32Array(this.image.data.buffer);
  }
  drawLamps({ planes, white }, buffer) {
    this.lamps.set(buffer, planes);
    this.lamps.update();
    const shown2 = `lamps ${white} ${buffer.rowStep}`;
    if (this.shown === shown2 && this.shownBuffer === buffer) return this.writeChanged(white);
    this.shown = shown2, this.shownBuffer = buffer;
    const { words: words2 } = this, [r, g, b] = this.facts.background.map((light) => byteOf(light / white));
    words2.fill(word(r, g, b));
    for (let path = 0; path < buffer.paths; ++path) this.write(path, 1 / white);
  }
  /** Writes the light of the paths that the last update of the lamps changed. */
  writeChanged(white) {
    const { list: list2, count } = this.lamps.changed;
    for (let i = 0; i < count; ++i) this.write(list2[i], 1 / white);
  }
  write(path, perWhite) {
    const light = this.lamps.luminance, at = 3 * path;
    this.words[this.buffer.pixels[path]] = word(byteOf(light[at] * perWhite), byteOf(light[at + 1] * perWhite), byteOf(light[at + 2] * perWhite));
  }
  drawLook(look, display, buffer) {
    const colors2 = lookColors(look, buffer, display), byte = (share2) => Math.round(255 * Math.min(share2, 1)), none = byte(0.07);
    this.shown = look;
    this.words.fill(word(none, none, none));
    for (let path = 0, at = 0; path < buffer.paths; ++path, at += 3)
      this.words[buffer.pixels[path]] = word(byte(colors2[at]), byte(colors2[at + 1]), byte(colors2[at + 2]));
  }
  /** Shows rows that are not there yet by the nearest above. */
  repeatRows({ rowStep, camera: { width, height } }) {
    for (let y = 0; y < height; ++y)
      if (y % rowStep !== 0) this.words.copyWithin(y * width, (y - y % rowStep) * width, (y - y % rowStep + 1) * width);
  }
};
function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return Number((power * ([1, 2, 5].find((step3) => value <= step3 * power * (1 + 1e-9)) ?? 10)).toPrecision(1));
}
function quantile(values, share2) {
  return values.sort()[Math.round(share2 * (values.length - 1))] ?? 0;
}

// source/look_words.ts
var curvatureKinds = ["mean", "gauss", "k1", "k2", "absolute", "section"];
var usual = { kind: "mean", across: [0, 1, 0] };
var firstLook = { look: "lamps", ...usual };
var words = { isophotes: "isophote", "highlight lines": "highlight" };
function wordOf({ look, kind }, fullCurvature) {
  if (look !== "curvature") return words[look] ?? look;
  return `curvature:${kind}${fullCurvature ? `=${fullCurvature}` : ""}`;
}
var hasSections = ({ look, kind }) => look === "curvature" && kind === "section";
var directionWord = (across) => across.map((x) => Number(x.toPrecision(9))).join(",");
function directionOf(word2) {
  const parts = word2.split(",").map((part) => part.trim() ? Number(part) : NaN);
  return parts.length === 3 && parts.every(Number.isFinite) && parts.some((part) => part !== 0) ? parts : null;
}
function lookOf(word2, across = usual.across) {
  const kind = curvatureKinds.find((name) => word2.split("=")[0] === `curvature:${name}`);
  if (kind) return { look: "curvature", kind, across };
  const look = looks.find((name) => name !== "curvature" && (words[name] ?? name) === word2);
  return look ? { ...usual, look } : null;
}

// source/analysis.ts
var keptView = (name, camera, display) => ({ name, look: wordOf(display, display.fullCurvature), ...hasSections(display) ? { across: display.across } : {}, camera });
function opened({ analysis, remarks, rig }) {
  if (!analysis) return null;
  return {
    views: analysis.views,
    sections: analysis.sections,
    rig,
    hidden: analysis.hidden.map(({ face }) => face),
    notes: analysis.notes.map(({ text: text2, place, face }) => ({ text: text2, place, face: face ?? 0 })),
    remarks: remarks.map(({ entity, message }) => `${entity} ${message}`)
  };
}
var fetchAnalysis = async () => opened(await (await ask("GET", "/analysis")).json());
var openAnalysis = async (text2) => opened(await (await ask("PUT", "/analysis", text2)).json());
var shownView = "shown";
var quoted = (text2) => JSON.stringify(text2.replace(/\u007f/g, ""));
function viewText2({ name, look, across, camera }) {
  const planes = across ? `across = [${across.join(", ")}]
` : "";
  return `[[view]]
name = ${quoted(name)}
look = ${quoted(look)}
${planes}[view.camera]
${cameraText(camera)}
size = [${camera.width}, ${camera.height}]`;
}
async function analysisFile({ camera, display, hidden, sections, views, notes }) {
  const first = keptView(shownView, camera, display);
  const more = [hiddenText(hidden), sections.length > 0 ? `sections = [${sections.map(quoted).join(", ")}]` : ""].join("\n");
  const tables = [
    ...[first, ...views].map(viewText2),
    ...notes.map(({ text: text2, place }) => `[[note]]
text = ${quoted(text2)}
place = [${place.join(", ")}]`)
  ].join("\n");
  return (await ask("POST", "/analysis", `${requestText(camera, display.planes, more)}${tables}
`)).blob();
}

// source/eye_overlay.ts
var EyeOverlay = class {
  /** `draw` draws for an eye on a canvas of its picture's size. */
  constructor(id, picture, camera, draw) {
    this.picture = picture;
    this.camera = camera;
    this.draw = draw;
    this.drawn = null;
    this.isFollowing = false;
    this.canvas = element("canvas", "", { id, className: "overlay" });
    picture.parentElement.append(this.canvas);
  }
  /** Draws what has changed, and goes on with the eye as long as there is something. */
  show(isThere) {
    this.drawn = null;
    const wasFollowing = this.isFollowing;
    this.isFollowing = isThere;
    if (isThere && !wasFollowing) this.follow();
    if (!isThere) this.canvas.width = 0;
  }
  follow() {
    if (!this.isFollowing) return;
    const camera = this.camera(), { width, height } = this.picture.style;
    Object.assign(this.canvas.style, { width, height });
    if (camera !== this.drawn) {
      Object.assign(this.canvas, { width: camera.width, height: camera.height });
      this.draw(this.canvas.getContext("2d"), camera);
      this.drawn = camera;
    }
    requestAnimationFrame(() => this.follow());
  }
};

// source/notes.ts
var Notes = class {
  /** `changed` is called after each change by the user. */
  constructor(into, host, picture, changed) {
    this.into = into;
    this.host = host;
    this.changed = changed;
    this.notes = [];
    this.marks = new EyeOverlay("note-marks", picture, () => host.camera(), (context, camera) => {
      const projection = new Projection(camera);
      this.notes.forEach((note, i) => {
        if (projection.set(note.place)) mark(context, projection.x, projection.y, String(i + 1));
      });
    });
  }
  get all() {
    return this.notes;
  }
  show(notes) {
    this.notes = notes;
    this.marks.show(notes.length > 0);
    this.into.replaceChildren(notes.length > 0 ? element("ol", notes.map((note) => this.entry(note))) : element("p", "Click on the body and write one beside it.", { className: "soft" }));
  }
  add(note) {
    this.show([...this.notes, note]);
    this.changed();
  }
  entry(note) {
    const remove = button("×", () => {
      this.show(this.notes.filter((other) => other !== note));
      this.changed();
    });
    remove.title = "remove the note";
    const lost = note.face > 0 ? [] : [element("div", "not on this part any more", { className: "soft" })];
    return element("li", [button(note.text, () => this.host.flyTo(note.place)), remove, ...lost]);
  }
};
function mark(context, x, y, text2) {
  const radius = 9;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = "#ffd23a", context.strokeStyle = "#222";
  context.fill(), context.stroke();
  context.fillStyle = "#222", context.font = "bold 12px sans-serif";
  context.textAlign = "center", context.textBaseline = "middle";
  context.fillText(text2, x, y + 0.5);
}

// source/analysis_panel.ts
var storedViews = "views";
var AnalysisPanel = class {
  constructor(into, host, picture) {
    this.host = host;
    this.views = JSON.parse(sessionStorage.getItem(storedViews) ?? "[]");
    this.list = element("p");
    this.remarks = element("div", "", { className: "soft" });
    const notes = element("div");
    this.notes = new Notes(notes, host, picture, () => host.keep());
    into.replaceChildren(
      element("p", [
        button("keep this view", () => this.keepView()),
        button("save analysis", () => void this.save()),
        button("open analysis", () => void this.open())
      ]),
      this.list,
      this.remarks,
      element("h3", "Notes"),
      notes
    );
    this.notes.show([]);
    this.showViews();
  }
  /** Shows what a file or the server has. */
  take(analysis) {
    this.setViews(analysis.views.filter(({ name }) => name !== shownView));
    this.notes.show(analysis.notes);
    this.remarks.replaceChildren(...analysis.remarks.map((remark) => element("div", remark)));
    this.host.take(analysis);
  }
  addNote(note) {
    this.notes.add(note);
  }
  keepView() {
    const taken = new Set(this.views.map(({ name }) => name));
    let number = 1;
    while (taken.has(`view-${number}`)) ++number;
    this.setViews([...this.views, keptView(`view-${number}`, this.host.camera(), this.host.display())]);
  }
  setViews(views) {
    this.views = views;
    sessionStorage.setItem(storedViews, JSON.stringify(views));
    this.showViews();
  }
  showViews() {
    this.list.replaceChildren(...this.views.flatMap((view) => {
      const remove = button("×", () => this.setViews(this.views.filter((other) => other !== view)));
      remove.title = "forget the view";
      return [button(view.name, () => this.show(view)), remove, new Text(" ")];
    }));
  }
  show({ camera, look, across }) {
    const stated = lookOf(look, across);
    if (stated) this.host.choose(stated);
    this.host.lookFrom(camera);
    if (!stated) this.host.tell(`this page does not draw ${look}`);
  }
  async save() {
    const { host } = this;
    try {
      download("analysis.json", await analysisFile({
        camera: host.camera(),
        display: host.display(),
        hidden: host.hidden(),
        sections: host.sections(),
        views: this.views,
        notes: this.notes.all
      }));
      host.tell("analysis.json is in your downloads; keiko view, inspect, render and compare take it with --analysis");
    } catch (error) {
      host.fail(error);
    }
  }
  async open() {
    const text2 = await pickedText(".json");
    try {
      this.take(await openAnalysis(text2));
    } catch (error) {
      this.host.fail(error);
    }
  }
};

// source/exact_picture.ts
var exposureOf = (white) => Math.log2(white / 1.2);
var rest = 300;
var ExactPicture = class {
  /** `path`: of the request; `tell` gets a line for the user, `fail` an error. */
  constructor(canvas, path, tell, fail) {
    this.canvas = canvas;
    this.path = path;
    this.tell = tell;
    this.fail = fail;
    this.running = new AbortController();
    this.timer = 0;
  }
  /** Something has changed: takes the picture off, and ends work on it. */
  outdate() {
    if (!this.canvas.hidden) this.tell("");
    this.canvas.hidden = true;
    this.running.abort();
    clearTimeout(this.timer);
  }
  /** Requests the picture after a while, unless something changes until then. */
  follow(pictured) {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.fetch(pictured), rest);
  }
  /** The bytes of the picture, PNG, for a file. They come even if the view goes on; the server has one such picture
   * at work for a page, so the one for the view ends, and this one serves it too. */
  async file(pictured) {
    clearTimeout(this.timer);
    this.running.abort();
    const own = this.running = new AbortController();
    const bytes2 = await this.bytesOf(pictured);
    if (!own.signal.aborted) await this.show(bytes2, own.signal);
    return bytes2;
  }
  async fetch(pictured) {
    const own = this.running = new AbortController();
    try {
      await this.show(await this.bytesOf(pictured, own.signal), own.signal);
    } catch (error) {
      if (!own.signal.aborted) this.fail(error);
    }
  }
  async bytesOf({ camera, planes, hidden, ev }, signal) {
    const more = [hiddenText(hidden), ev === null ? "" : `ev = ${ev}`].join("\n");
    return (await ask("POST", this.path, requestText(camera, planes, more), signal)).blob();
  }
  async show(bytes2, signal) {
    const image = await createImageBitmap(bytes2), { canvas } = this;
    if (signal.aborted) return;
    Object.assign(canvas, { width: image.width, height: image.height, hidden: false });
    canvas.getContext("2d").drawImage(image, 0, 0);
    this.tell("exact picture");
  }
};

// source/deep_buffer.ts
var header = 32;
var sampleBytes = 32;
var bounceBytes = 36;
var magic = "KEIKOD1\n";
function sizeOf(view) {
  return header + view.getUint32(24, true) * sampleBytes + view.getUint32(28, true) * bounceBytes;
}
function passOf(bytes2) {
  const view = new DataView(bytes2.buffer, bytes2.byteOffset, bytes2.byteLength);
  const samples = view.getUint32(24, true);
  const end = header + samples * sampleBytes;
  return {
    width: view.getUint32(8, true),
    height: view.getUint32(12, true),
    first: view.getUint32(16, true),
    step: view.getUint32(20, true),
    samples: new Float32Array(bytes2.buffer, bytes2.byteOffset + header, samples * 8),
    bounces: new DataView(bytes2.buffer, bytes2.byteOffset + end, bytes2.byteLength - end)
  };
}
var Reader = class {
  constructor(stream) {
    this.rest = new Uint8Array(0);
    this.reader = stream.getReader();
  }
  /** Writes into all of `to`; false at the end of the stream. */
  async fill(to) {
    let done = 0;
    while (done < to.length) {
      if (this.rest.length === 0) {
        const { value } = await this.reader.read();
        if (!value) {
          if (done > 0) throw new Error("the deep buffer was cut off");
          return false;
        }
        this.rest = value;
      }
      const count = Math.min(this.rest.length, to.length - done);
      to.set(this.rest.subarray(0, count), done);
      this.rest = this.rest.subarray(count);
      done += count;
    }
    return true;
  }
};
async function readPasses(reply, use) {
  const reader = new Reader(reply.body);
  for (; ; ) {
    const head = new Uint8Array(header);
    if (!await reader.fill(head)) return;
    if (new TextDecoder().decode(head.subarray(0, 8)) !== magic) throw new Error("this is no deep buffer");
    const bytes2 = new Uint8Array(sizeOf(new DataView(head.buffer)));
    bytes2.set(head);
    await reader.fill(bytes2.subarray(header));
    use(passOf(bytes2));
  }
}

// source/reprojection.ts
var numbersOfSample2 = 8;
var numbersOfRay = 18;
var Reprojection = class {
  constructor() {
    this.paths = new Int32Array(0);
    this.depths = new Float32Array(0);
    this.samples = new Float32Array(0);
  }
  pass(from, camera) {
    const { width, height } = camera, moved2 = new MovedSurface(from, camera);
    if (this.paths.length !== width * height) this.reserve(width * height);
    const { paths, depths, samples } = this;
    paths.fill(-1), depths.fill(Infinity);
    new NearestPaths(from, camera, paths, depths).addAll();
    for (let y = 0, pixel = 0; y < height; ++y)
      for (let x = 0; x < width; ++x, ++pixel) {
        if (paths[pixel] < 0) samples[numbersOfSample2 * pixel] = Infinity;
        else moved2.write(paths[pixel], x, y, samples, numbersOfSample2 * pixel);
      }
    return { width, height, first: 0, step: 1, samples, bounces: new DataView(new ArrayBuffer(0)) };
  }
  reserve(pixels) {
    this.paths = new Int32Array(pixels), this.depths = new Float32Array(pixels);
    this.samples = new Float32Array(numbersOfSample2 * pixels);
  }
};
function scaleOf(from, camera) {
  const far = (c) => c.projection === "orthographic" ? 1 : length(difference(c.eye, c.target));
  return pixelSize(from.camera) * far(from.camera) / (pixelSize(camera) * far(camera)) * Math.min(from.rowStep, 2);
}
var NearestPaths = class extends Projection {
  // from one path to the next that is drawn: pixels hold many small ones
  /** `paths`: by pixel, -1: none; `depths`: of the surface on the pixel's ray, mm along the eye's direction. */
  constructor(from, camera, paths, depths) {
    super(camera);
    this.from = from;
    this.paths = paths;
    this.depths = depths;
    const scale = scaleOf(from, camera);
    this.side = scale < 0.75 ? 1 : Math.min(8, Math.ceil(1.3 * scale));
    this.step = Math.max(1, Math.floor(0.5 / scale));
  }
  addAll() {
    for (let path = 0; path < this.from.paths; path += this.step) this.add(path);
  }
  add(path) {
    if (!this.set(this.from.first.numbers, numbersOfRay * path)) return;
    const { camera: { width, height }, side } = this;
    const left2 = Math.floor(this.x - 0.5 * (side - 1)), top2 = Math.floor(this.y - 0.5 * (side - 1));
    const right2 = Math.min(left2 + side, width), bottom = Math.min(top2 + side, height);
    if (left2 < right2 && top2 < bottom) this.fill(path, Math.max(left2, 0), Math.max(top2, 0), right2, bottom);
  }
  /** Puts a path into pixels where it is nearest: its tangent plane is met by each pixel's own ray. */
  fill(path, left2, top2, right2, bottom) {
    const { camera: { eye, width, height }, axes: { right: r, up: u, forward: f }, size: size2, isParallel, paths, depths } = this;
    const { normals, first: { numbers: numbers2 } } = this.from, n = 3 * path, p = numbersOfRay * path;
    const nx = normals[n], ny = normals[n + 1], nz = normals[n + 2];
    const ahead = nx * f[0] + ny * f[1] + nz * f[2];
    const aside = nx * r[0] + ny * r[1] + nz * r[2], upward = nx * u[0] + ny * u[1] + nz * u[2];
    const away = nx * (numbers2[p] - eye[0]) + ny * (numbers2[p + 1] - eye[1]) + nz * (numbers2[p + 2] - eye[2]);
    const sameSurface = 1 - 1e-3;
    for (let y = top2; y < bottom; ++y)
      for (let x = left2; x < right2; ++x) {
        const across = (x + 0.5 - 0.5 * width) * size2, rise = (0.5 * height - y - 0.5) * size2, sideways = aside * across + upward * rise;
        const towards = isParallel ? ahead : ahead + sideways, depth = (isParallel ? away - sideways : away) / towards;
        const lowest = -0.02 * (isParallel ? 1 : Math.sqrt(1 + across * across + rise * rise)), pixel = y * width + x;
        if (towards < lowest && depth > 0 && depth < sameSurface * depths[pixel]) depths[pixel] = depth, paths[pixel] = path;
      }
  }
};
var MovedSurface = class extends CameraFrame {
  constructor(from, camera) {
    super(camera);
    this.from = from;
    this.origin = new Float64Array(3);
    this.ray = new Float64Array(3);
  }
  /** Writes the sample where a pixel's ray meets the tangent plane of a path's surface. */
  write(path, x, y, samples, at) {
    const { from: { normals, samples: own, pixels, first: { numbers: numbers2 } }, origin: o, ray: d } = this;
    const n = 3 * path, p = numbersOfRay * path, source = numbersOfSample2 * pixels[path];
    this.setRay(x + 0.5, y + 0.5);
    let towards = 0, away = 0;
    for (let k = 0; k < 3; ++k) towards += normals[n + k] * d[k], away += normals[n + k] * (numbers2[p + k] - o[k]);
    const t = samples[at] = away / towards;
    for (let k = 1; k < numbersOfSample2; ++k) samples[at + k] = own[source + k];
    for (let k = 0; k < 3; ++k) step[k] = o[k] + t * d[k] - numbers2[p + k];
    this.turnNormal(path, samples, at);
  }
  setRay(x, y) {
    const { camera: { eye, width, height }, axes: { right: right2, up, forward }, origin, ray, size: size2, isParallel } = this;
    const across = (x - 0.5 * width) * size2, rise = (0.5 * height - y) * size2;
    const perLength = isParallel ? 1 : 1 / Math.sqrt(1 + across * across + rise * rise);
    for (let k = 0; k < 3; ++k) {
      const aside = right2[k] * across + up[k] * rise;
      origin[k] = eye[k] + (isParallel ? aside : 0);
      ray[k] = (forward[k] + (isParallel ? 0 : aside)) * perLength;
    }
  }
  /** Turns the normal of a sample by the surface's curvature over `step`. */
  turnNormal(path, samples, at) {
    const surface = this.from.surfaceOf(path), { normal } = surface;
    if (surface.isPoint) return;
    surface.turn(step, 0, change);
    const a = normal[0] + change[0], b = normal[1] + change[1], c = normal[2] + change[2];
    const isLower = c < 0, sum2 = Math.abs(a) + Math.abs(b) + Math.abs(c), q = a / sum2, r = b / sum2;
    if (isLower !== normal[2] < 0) return;
    samples[at + 1] = isLower ? (1 - Math.abs(r)) * (q < 0 ? -1 : 1) : q;
    samples[at + 2] = isLower ? (1 - Math.abs(q)) * (r < 0 ? -1 : 1) : r;
  }
};
var step = new Float64Array(3);
var change = new Float64Array(3);

// source/tracing.ts
var longest = 28;
var short = 20;
var Tracing = class {
  // pixels of the window to one of a preview
  /** `reflections`: most of them that are followed; `show` gets surfaces, which may become more. */
  constructor(reflections, bufferFor, show, traced = {}) {
    this.reflections = reflections;
    this.bufferFor = bufferFor;
    this.show = show;
    this.traced = traced;
    /** The last surfaces that came from the server. */
    this.source = null;
    this.own = new AbortController();
    this.isDrafting = false;
    this.wanted = null;
    // of a draft
    this.eye = null;
    // that moves
    this.reprojection = new Reprojection();
    this.previewed = null;
    this.coarseness = 2;
  }
  /** Fetches all surfaces, coarse rows first; false if a later call ended this one. */
  async rest(camera) {
    this.own.abort();
    this.wanted = null;
    const own = this.own = new AbortController(), buffer = this.bufferFor(camera), isFirst = !this.source, fineEnough = 2;
    await this.fetch(buffer, true, own.signal, () => {
      if (!isFirst && buffer.rowStep > fineEnough) return;
      this.source = buffer;
      this.show(buffer);
    });
    return !own.signal.aborted;
  }
  /** Shows the surfaces in hand from an eye that moves, and fetches a draft of what it sees. */
  async move(camera) {
    if (!this.isDrafting) this.own.abort();
    this.eye = camera;
    this.wanted = sized(camera, camera.width >> 1, camera.height >> 1);
    this.preview();
    if (this.isDrafting) return;
    this.isDrafting = true;
    try {
      while (this.wanted) await this.draft(this.wanted);
    } finally {
      this.isDrafting = false;
    }
  }
  async draft(camera) {
    const own = this.own = new AbortController(), buffer = this.bufferFor(camera);
    await this.fetch(buffer, false, own.signal, () => {
      this.source = buffer;
    });
    if (own.signal.aborted) return;
    if (this.wanted === camera) this.wanted = null, this.show(buffer);
  }
  preview() {
    if (!this.source || !this.eye) return;
    const { eye, coarseness } = this, camera = sized(eye, Math.ceil(eye.width / coarseness), Math.ceil(eye.height / coarseness));
    const buffer = this.previewed = this.bufferFor(camera, this.previewed);
    buffer.add(this.reprojection.pass(this.source, camera));
    this.show(buffer);
  }
  /** Takes the milliseconds of the last frame of a moving eye: the next previews are as fine as the time allows. */
  pace(milliseconds) {
    const finer = this.coarseness - 1;
    if (milliseconds > longest) this.coarseness = Math.min(this.coarseness + 1, 4);
    else if (finer >= 2 && milliseconds * (this.coarseness / finer) ** 2 < short) this.coarseness = finer;
  }
  async fetch(buffer, isInterlaced, signal, use) {
    const more = `interlaced = ${isInterlaced}
reflections = ${Math.min(8, Math.max(1, this.reflections))}
${hiddenText(this.traced.hidden?.() ?? [])}`;
    try {
      const reply = await ask("POST", this.traced.path ?? "/deep", requestText(buffer.camera, void 0, more), signal);
      await readPasses(reply, (pass) => {
        if (signal.aborted) return;
        buffer.add(pass);
        use();
      });
    } catch (error) {
      if (!signal.aborted) throw error;
    }
  }
};

// source/compare.ts
var ways = ["new", "both", "difference"];
var slice = 12;
var Earlier = class {
  constructor(host, over) {
    this.host = host;
    this.over = over;
    this.canvas = element("canvas", "", { id: "earlier", hidden: true });
    this.picture = null;
    this.traced = null;
    this.drawn = "";
    this.tracing = null;
    this.way = "new";
    const still = element("canvas", "", { id: "earlier-still", hidden: true });
    this.exact = new ExactPicture(still, "/against/still", (line) => host.tell(line), (error) => host.fail(error));
    byId("still").after(this.canvas, still);
  }
  async show(way) {
    const wasShown = this.way !== "new";
    this.way = way;
    this.canvas.hidden = way === "new";
    for (const shown2 of this.canvases) shown2.style.mixBlendMode = way === "difference" ? "difference" : "normal";
    this.over.parentElement.classList.toggle("comparing", way !== "new");
    if (way === "new") this.exact.outdate();
    if (wasShown || way === "new") return;
    const facts2 = await (await ask("GET", "/against/scene")).json();
    const picture = this.picture ??= new Picture(this.canvas, facts2);
    this.tracing ??= new Tracing(facts2.reflections, (camera, spent) => picture.bufferFor(camera, spent), (buffer) => {
      picture.show(buffer);
      this.draw(this.host.display());
    }, { path: "/against/deep" });
    this.traced = null;
    this.follow();
  }
  /** Share of the picture, from the left, that shows the new revision. */
  split(share2) {
    for (const { style } of this.canvases) style.clipPath = `inset(0 0 0 ${(100 * share2).toFixed(2)}%)`;
  }
  get canvases() {
    return [this.canvas, this.exact.canvas];
  }
  /** Follows eye, look and lamps as long as it is shown. */
  follow() {
    if (this.way === "new") return;
    const camera = this.host.camera(), { width, height } = this.over.style;
    for (const { style } of this.canvases) Object.assign(style, { width, height });
    const display = this.host.display(), now = JSON.stringify(display), isEye = camera !== this.traced;
    if (isEye) void this.trace(camera);
    if (now !== this.drawn) this.draw(display);
    if (isEye || now !== this.drawn) this.request(camera, display);
    this.drawn = now;
    this.over.parentElement.classList.toggle("both-exact", !byId("still").hidden && !this.exact.canvas.hidden);
    requestAnimationFrame(() => this.follow());
  }
  /** Takes the exact picture off; another one follows after a while. */
  request(camera, { look, planes, white }) {
    this.exact.outdate();
    if (look === "lamps") this.exact.follow({ camera, planes, hidden: [], ev: exposureOf(white) });
  }
  draw(display) {
    this.picture.draw(display);
  }
  async trace(camera) {
    this.traced = camera;
    try {
      if (!await this.tracing.rest(camera)) return;
      while (camera === this.traced && !this.picture.refine(this.host.display(), slice))
        await new Promise((resolve) => setTimeout(resolve));
      this.canvas.dataset.traced = "whole";
    } catch (error) {
      this.host.fail(error);
    }
  }
};
var Comparison = class {
  constructor(into, host, over) {
    this.earlier = null;
    into.parentElement.hidden = !host.facts.against;
    if (!host.facts.against) return;
    const earlier = this.earlier = new Earlier(host, over), buttons = element("p");
    const slider = element("input", "", { type: "range", min: "0", max: "1", step: "any", value: "0.5", ariaLabel: "border between the revisions" });
    const show = (way) => {
      const wasShown = this.isShown;
      slider.disabled = way !== "both";
      earlier.split(way === "both" ? Number(slider.value) : 0);
      earlier.show(way).catch((error) => host.fail(error));
      if (this.isShown !== wasShown) host.changed(false, true);
    };
    slider.oninput = () => earlier.split(Number(slider.value));
    choice(buttons, ways, "new", (name) => show(name));
    slider.disabled = true;
    into.replaceChildren(buttons, slider);
  }
  /** True while the earlier revision is shown. */
  get isShown() {
    return this.earlier !== null && this.earlier.way !== "new";
  }
};

// source/row_moves.ts
function rowAxes(plane) {
  const along = unit(plane.u), normal = unit(cross(plane.u, plane.v));
  return { along, across: cross(normal, along), normal };
}
var moved = (plane, step3) => ({ ...plane, origin: sum(plane.origin, step3) });
function turnedRow(plane, axis, angle) {
  const middle2 = sum(plane.origin, scaled(sum(plane.u, plane.v), 0.5)), turn = (a) => turned(a, axis, angle);
  return { ...plane, origin: sum(middle2, turn(difference(plane.origin, middle2))), u: turn(plane.u), v: turn(plane.v) };
}
function mmOfPixel(camera) {
  return pixelSize(camera) * (camera.projection === "orthographic" ? 1 : length(difference(camera.target, camera.eye)));
}
function movedWithin(plane, step3) {
  const { along, across } = rowAxes(plane);
  return moved(plane, sum(scaled(along, dot(step3, along)), scaled(across, dot(step3, across))));
}
function dragged(plane, camera, x, y) {
  const { right: right2, up } = axesOf(camera);
  return movedWithin(plane, scaled(sum(scaled(right2, x), scaled(up, -y)), mmOfPixel(camera)));
}
function afterMove(plane, move, amount) {
  const axes2 = rowAxes(plane), angle = amount * Math.PI / 180;
  if (move === "turn") return turnedRow(plane, axes2.normal, angle);
  if (move === "tilt") return turnedRow(plane, axes2.along, angle);
  return moved(plane, scaled(axes2[move], amount));
}
function withRoom(plane) {
  const needed = (plane.lamps - 1) * plane.pitch + plane.diameter, more = needed - length(plane.v);
  if (more <= 0) return plane;
  const across = unit(plane.v);
  return { ...plane, origin: sum(plane.origin, scaled(across, -more / 2)), v: scaled(across, needed) };
}

// source/gizmo.ts
var size = 130;
var reach = 44;
var handles = [
  { move: "along", color: "#e05050", title: "move the row along its lamps" },
  { move: "across", color: "#50c050", title: "move the row across its lamps" },
  { move: "normal", color: "#5090ff", title: "move the row along its normal" }
];
function shape(tag, attributes, title = "") {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  if (title) made.append(Object.assign(document.createElementNS("http://www.w3.org/2000/svg", "title"), { textContent: title }));
  return made;
}
var Gizmo = class {
  /** `act` gets moves in mm or degrees, and true at the end of a drag. */
  constructor(parent, act2) {
    this.act = act2;
    this.grabbed = null;
    this.root = shape("svg", { id: "gizmo", width: size, height: size, viewBox: `${-size / 2} ${-size / 2} ${size} ${size}` });
    parent.append(this.root);
  }
  /** Draws the axes of a row as a camera sees them; nothing without a row. */
  show(plane, camera) {
    if (this.grabbed) return;
    this.root.replaceChildren();
    if (!plane) return;
    const { right: right2, up } = axesOf(camera), axes2 = rowAxes(plane), pixel = 1 / mmOfPixel(camera);
    const least = 0.26;
    const project2 = (axis) => {
      const x = dot(axis, right2), y = -dot(axis, up), length2 = Math.hypot(x, y);
      return length2 > least ? [x, y] : length2 > 0 ? [x * least / length2, y * least / length2] : [0, -least];
    };
    this.handle(shape("circle", { r: reach + 14, fill: "none", stroke: "#c0a030", "stroke-width": 5 }, "turn the row about its normal"), "turn", [-1.5, 0]);
    for (const { move, color, title } of handles) {
      const [x, y] = project2(axes2[move]);
      this.handle(shape("line", { x2: reach * x, y2: reach * y, stroke: color, "stroke-width": 6, "stroke-linecap": "round" }, title), move, [x * pixel, y * pixel]);
      this.handle(shape("circle", { cx: reach * x, cy: reach * y, r: 7, fill: color }, title), move, [x * pixel, y * pixel]);
    }
    this.handle(shape("circle", { r: 8, fill: "#ddd" }, "tilt the row about its lamps"), "tilt", [0, 4]);
  }
  /** Lets a shape be dragged; `way`: pixels that a mm or a degree takes in the picture. */
  handle(element2, move, way) {
    element2.setAttribute("data-move", move);
    element2.onpointerdown = (event) => {
      element2.setPointerCapture(event.pointerId);
      this.grabbed = { move, way, x: event.clientX, y: event.clientY };
    };
    element2.onpointermove = (event) => {
      const { grabbed } = this;
      if (!grabbed) return;
      this.act(move, this.amount(event.clientX - grabbed.x, event.clientY - grabbed.y, grabbed.way), false);
      grabbed.x = event.clientX, grabbed.y = event.clientY;
    };
    element2.onpointerup = () => {
      this.grabbed = null;
      this.act(move, 0, true);
    };
    this.root.append(element2);
  }
  /** mm or degrees of a drag by pixels. */
  amount(x, y, [byX, byY]) {
    return (x * byX + y * byY) / (byX * byX + byY * byY);
  }
};

// source/help.ts
function showDialog(title, lines2) {
  const rows = lines2.map(([name, words2]) => element("tr", [element("th", name), element("td", words2)]));
  const close = element("button", "close", { type: "button", onclick: () => dialog.close() });
  const dialog = element("dialog", [element("h2", title), element("table", rows), close]);
  dialog.onclose = () => dialog.remove();
  document.body.append(dialog);
  dialog.showModal();
}

// source/mouse.ts
var mouseStyles = ["Keiko", "Alias", "CATIA", "SolidWorks", "Blender"];
var left = 1;
var right = 2;
var middle = 4;
function mouseAction(style, event) {
  const { buttons, shiftKey, ctrlKey, metaKey, altKey } = event, hasControl = ctrlKey || metaKey;
  if (buttons === left && hasControl) return shiftKey ? "section" : "lamps";
  switch (style) {
    case "Keiko":
      return buttons & (right | middle) || shiftKey ? "pan" : "orbit";
    case "Alias":
      return !altKey || !shiftKey ? "none" : buttons & left ? "orbit" : buttons & middle ? "pan" : "zoom";
    case "CATIA":
      if (!(buttons & middle)) return "none";
      return buttons & (left | right) || hasControl ? "orbit" : shiftKey ? "zoom" : "pan";
    case "SolidWorks":
    case "Blender": {
      if (!(buttons & middle)) return "none";
      const pans = style === "Blender" ? shiftKey : hasControl, zooms = style === "Blender" ? hasControl : shiftKey;
      return pans ? "pan" : zooms ? "zoom" : "orbit";
    }
  }
}
var mouseHelp = {
  Keiko: "drag turns, Shift or right button pans",
  Alias: "Shift + Alt: left turns, middle pans, right zooms",
  CATIA: "middle pans, middle with left, right or Ctrl turns, with Shift zooms",
  SolidWorks: "middle turns, with Ctrl pans, with Shift zooms",
  Blender: "middle turns, with Shift pans, with Ctrl zooms"
};

// source/pointer.ts
var rest2 = 300;
var threshold = 3;
function act(host, action, x, y) {
  const camera = host.camera();
  if (action === "lamps") host.lamps.drag(x, y);
  if (action === "section") return host.turnSection(x, y);
  if (action === "pan") host.setCamera(panned(camera, x, y));
  if (action === "zoom") host.setCamera(dollied(camera, Math.exp(y / 200)));
  if (action === "orbit") host.setCamera(orbited(camera, camera.target, -x / 200, -y / 200));
}
var Pointer = class {
  constructor(canvas, host) {
    this.canvas = canvas;
    this.host = host;
    this.drag = null;
    this.timer = 0;
    canvas.onpointerdown = (event) => this.press(event);
    canvas.onpointermove = (event) => this.move(event);
    canvas.onpointerup = (event) => this.release(event);
    canvas.oncontextmenu = (event) => event.preventDefault();
    canvas.onwheel = (event) => this.wheel(event);
  }
  /** The pixel of the picture under the mouse. */
  pixel(event) {
    const { width, height } = this.canvas, box = this.canvas.getBoundingClientRect();
    return [Math.floor((event.clientX - box.left) / box.width * width), Math.floor((event.clientY - box.top) / box.height * height)];
  }
  press(event) {
    const { canvas, host } = this, action = mouseAction(host.style(), event);
    canvas.setPointerCapture(event.pointerId);
    if (action === "lamps") host.lamps.grab(...this.pixel(event));
    this.drag = { x: event.clientX, y: event.clientY, pixel: this.pixel(event), action, moved: false };
  }
  move(event) {
    const { drag, host } = this;
    if (!drag) return;
    const x = event.clientX - drag.x, y = event.clientY - drag.y;
    if (!drag.moved && Math.hypot(x, y) < threshold) return;
    if (drag.action !== "lamps" && drag.action !== "section") drag.action = mouseAction(host.style(), event);
    if (drag.action === "none") return;
    const scale = host.camera().height / this.canvas.clientHeight, pixel = this.pixel(event);
    if (drag.action === "lamps") host.lamps.follow(drag.pixel, pixel);
    else act(host, drag.action, x * scale, y * scale);
    Object.assign(drag, { x: event.clientX, y: event.clientY, pixel, moved: true });
    if (drag.action !== "section") host.changed(drag.action !== "lamps", false);
  }
  release(event) {
    const { drag } = this;
    this.drag = null;
    if (drag?.moved && drag.action !== "section") return this.host.changed(drag.action !== "lamps", true);
    if (!drag?.moved && event.button === 0) this.host.pick(...this.pixel(event));
  }
  wheel(event) {
    const { host } = this;
    event.preventDefault();
    clearTimeout(this.timer);
    host.setCamera(dollied(host.camera(), Math.exp(event.deltaY / 1e3)));
    host.changed(true, false);
    this.timer = window.setTimeout(() => host.changed(true, true), rest2);
  }
};

// source/keys.ts
var lookKeys = {
  l: "lamps",
  z: "zebra",
  i: "isophotes",
  h: "highlight lines",
  c: "curvature",
  m: "radius",
  d: "draft",
  f: "faces"
};
var arrowStep = 10;
var arrows = {
  ArrowLeft: [-arrowStep, 0],
  ArrowRight: [arrowStep, 0],
  ArrowUp: [0, -arrowStep],
  ArrowDown: [0, arrowStep]
};
function keysOf(host) {
  const step3 = 50, angle = 2;
  return [
    ...Object.entries(lookKeys).map(([key, look]) => ({ key, words: look, act: () => host.chooseLook(look) })),
    ...host.views().map(({ name, show }, i) => ({ key: String(i), words: `view: ${name}`, act: show })),
    { key: "n", words: "the next row of lamps", act: () => host.lamps.next() },
    { key: "+", words: "row 50 mm along its normal", act: () => host.lamps.move("normal", step3) },
    { key: "-", words: "row 50 mm back", act: () => host.lamps.move("normal", -step3) },
    { key: "[", words: "turn the row by 2 degrees", act: () => host.lamps.move("turn", angle) },
    { key: "]", words: "turn the row back", act: () => host.lamps.move("turn", -angle) },
    { key: "s", words: "seams over the picture, by verdict", act: () => host.toggleSeams() },
    { key: "r", words: "reflection lines of the lamps over the picture", act: () => host.toggleLines() },
    { key: "p", words: "the picture as a file, with its command line", act: () => host.savePicture() },
    { key: "?", words: "this list", act: () => showKeys(host) }
  ];
}
function showKeys(host) {
  showDialog("Keys and mouse", [
    ["mouse", `${mouseHelp[host.style()]}; wheel zooms`],
    ["Ctrl + drag", "moves the chosen row of lamps in its plane"],
    ["Ctrl + Shift + drag", "turns the section plane"],
    ["click", "place, normal and radii; on a seam its verdict"],
    ["arrows", "turn; with Shift pan; with Ctrl move the row; with both turn the section"],
    ...keysOf(host).map(({ key, words: words2 }) => [key, words2])
  ]);
}
function listenToKeys(canvas, host) {
  const keys = new Map(keysOf(host).map((key) => [key.key, key.act]));
  canvas.onkeydown = (event) => {
    const way = arrows[event.key], does = keys.get(event.key);
    if (!way && !does || event.altKey) return;
    if (does && (event.ctrlKey || event.metaKey)) return;
    event.preventDefault();
    if (does) return does();
    const action = event.ctrlKey ? event.shiftKey ? "section" : "lamps" : event.shiftKey ? "pan" : "orbit";
    act(host, action, ...way);
    if (action !== "section") host.changed(action !== "lamps", true);
  };
}

// source/measured.ts
function measureLine(name, { value, limit, verdict }, unit2, shown2 = 1) {
  const digits = (size2) => `${Number((shown2 * size2).toPrecision(3))}${unit2}`;
  return { words: `${name} ${digits(value)}, ${limit === null ? "not judged" : `limit ${digits(limit)}`}`, verdict: verdict ?? "soft" };
}

// source/lamp_lines.ts
var quantities = [
  { name: "jump", words: "jumps sideways by", unit: " mm" },
  { name: "turn", words: "jumps as over an angle of", unit: "°" },
  { name: "kink", words: "kinks by", unit: "°" },
  { name: "bend", words: "changes its curvature by", unit: " /mm" }
];
function failingOf(crossing) {
  return quantities.find(({ name }) => crossing[name]?.verdict === "fail")?.name;
}
function measuresOf(crossing) {
  return quantities.flatMap(({ name, words: words2, unit: unit2 }) => {
    const measured = crossing[name];
    return measured ? [measureLine(words2, measured, unit2)] : [];
  });
}
var severity = ["pass", "undecided", "fail"];
function verdictsOf({ lines: lines2, crossings }) {
  const worst = lines2.map(() => -1);
  for (const { line, verdict } of crossings) if (verdict) worst[line] = Math.max(worst[line], severity.indexOf(verdict));
  return worst.map((at) => severity[at] ?? "none");
}

// source/polyline.ts
function stroke(context, points) {
  context.beginPath();
  follow(context, points);
  context.stroke();
}
function strokeAll(context, lines2, color, width) {
  Object.assign(context, { strokeStyle: color, lineWidth: width });
  context.beginPath();
  for (const line of lines2) follow(context, line);
  context.stroke();
}
function follow(context, points) {
  let isDown = false;
  for (const point of points) {
    if (point && isDown) context.lineTo(...point);
    else if (point) context.moveTo(...point);
    isDown = point !== null;
  }
}

// source/verdict_marks.ts
var verdictColors = { none: "#9aa4ad", pass: "#4cd964", undecided: "#ffb300", fail: "#ff4a4a" };
var apart = 16;
function drawLabels(context, labels, color) {
  const placed = [], high3 = 8;
  Object.assign(context, { font: "bold 12px sans-serif", textAlign: "center", textBaseline: "middle" });
  for (const { text: text2, at } of labels) {
    const [x, y] = at, half = context.measureText(text2).width / 2 + 3;
    if (placed.some((other) => Math.hypot(other[0] - x, other[1] - y) < apart)) continue;
    context.fillStyle = "#000c";
    context.fillRect(x - half, y - high3, 2 * half, 2 * high3);
    context.fillStyle = color;
    context.fillText(text2, x, y + 0.5);
    placed.push(at);
  }
}

// source/lamp_line_overlay.ts
var colors = { ...verdictColors, none: "#5cc8ff" };
var numbered = 20;
var reach2 = 8;
var LampLineOverlay = class {
  constructor(picture, host) {
    this.host = host;
    this.found = { lines: [], crossings: [] };
    this.verdicts = [];
    // by line
    this.marks = [];
    this.overlay = new EyeOverlay("lamp-lines", picture, () => host.camera(), (context, camera) => this.draw(context, camera));
  }
  /** Shows lines that were found for the eye that is shown; null: none. */
  show(found) {
    this.found = found ?? { lines: [], crossings: [] };
    this.verdicts = verdictsOf(this.found);
    this.marks = [];
    this.overlay.show(this.found.lines.length > 0);
  }
  /** The worst crossing at a pixel of the picture; null without one. */
  at(x, y) {
    return this.marks.find(({ at }) => Math.hypot(at[0] - x, at[1] - y) <= reach2)?.crossing ?? null;
  }
  draw(context, camera) {
    const projection = new Projection(camera), { width, height } = camera, hidden = new Set(this.host.hidden()), { lines: lines2, crossings } = this.found;
    const pixel = (place) => projection.set(place) ? [projection.x, projection.y] : null;
    for (const [verdict, color] of Object.entries(colors)) {
      const drawn = lines2.filter((_, i) => this.verdicts[i] === verdict).flatMap(({ pieces }) => pieces.filter(({ face }) => !hidden.has(face)).map(({ points }) => points.map(pixel)));
      strokeAll(context, drawn, "#000", 3);
      strokeAll(context, drawn, color, 1.5);
    }
    this.marks = crossings.flatMap((crossing) => {
      const at = crossing.verdict ? pixel(crossing.place) : null;
      return at && at[0] >= 0 && at[0] <= width && at[1] >= 0 && at[1] <= height ? [{ crossing, at }] : [];
    });
    for (const mark2 of [...this.marks].reverse()) drawMark(context, mark2.at, mark2.crossing.verdict);
    const labels = this.marks.map(({ crossing, at: [x, y] }) => ({ number: crossings.indexOf(crossing) + 1, crossing, at: [x, y - 14] }));
    drawLabels(context, labels.filter(({ number, crossing }) => crossing.verdict === "fail" && number <= numbered).map(({ number, at }) => ({ text: String(number), at })), colors.fail);
  }
};
function drawMark(context, [x, y], verdict) {
  context.beginPath();
  context.arc(x, y, verdict === "pass" ? 2 : 4, 0, 2 * Math.PI);
  Object.assign(context, { fillStyle: colors[verdict], strokeStyle: "#000", lineWidth: 1.5 });
  context.fill();
  context.stroke();
}

// source/lamp_lines_panel.ts
var atOnce = 20;
var LampLinesPanel = class {
  constructor(into, host, picture) {
    this.host = host;
    this.isOver = false;
    // they are drawn over the picture, or will be at rest
    this.asked = null;
    // null: not answered yet
    this.running = new AbortController();
    this.toggler = button("over the picture", () => this.toggle());
    this.detail = element("div", "", { id: "crossing" });
    this.list = element("div");
    this.buttons = /* @__PURE__ */ new Map();
    this.overlay = new LampLineOverlay(picture, host);
    into.replaceChildren(element("p", [this.toggler]), this.detail, this.list);
    this.toggler.title = "follows the lines that the lamps' axes make in this view, over seams";
  }
  /** True if they are drawn over the picture, or will be. */
  get shown() {
    return this.isOver;
  }
  toggle() {
    this.isOver = !this.isOver;
    this.host.keep();
    this.settle();
  }
  /** Draws them at rest, or takes them off. */
  show(isOver) {
    this.isOver = isOver;
    this.toggler.setAttribute("aria-pressed", String(isOver));
  }
  /** Eye, lamps or faces may be others: lines that are out of date go. */
  outdate() {
    if (this.isOver && !this.isCurrent()) this.clear();
  }
  /** Eye and lamps are at rest: the lines follow. */
  settle() {
    this.show(this.isOver);
    if (!this.isOver) this.clear();
    else if (!this.isCurrent()) void this.follow();
    else if (this.asked.lines) this.present(this.asked.lines);
  }
  /** Chooses the crossing at a pixel of the picture; false without one. */
  pick(x, y) {
    const crossing = this.isOver ? this.overlay.at(x, y) : null;
    if (crossing) this.choose(crossing);
    return crossing !== null;
  }
  isCurrent() {
    return this.asked?.camera === this.host.camera() && this.asked.planes === this.host.display().planes;
  }
  clear() {
    this.running.abort();
    if (!this.asked?.lines) this.asked = null;
    this.overlay.show(null);
    this.detail.replaceChildren();
    this.list.replaceChildren();
  }
  async follow() {
    this.clear();
    const own = this.running = new AbortController(), { host } = this, camera = host.camera(), { planes } = host.display();
    this.asked = { camera, planes, lines: null };
    try {
      host.tell("following the lines of the lamps");
      const lines2 = await (await ask("POST", "/lines", requestText(camera, planes), own.signal)).json();
      if (own.signal.aborted) return;
      this.asked = { camera, planes, lines: lines2 };
      this.present(lines2);
    } catch (error) {
      if (own.signal.aborted) return;
      this.asked = null;
      this.show(false);
      host.fail(error);
    }
  }
  present(found) {
    this.overlay.show(found);
    if (!this.list.hasChildNodes()) this.showList(found);
  }
  showList({ lines: lines2, crossings }) {
    const judged = crossings.filter(({ verdict }) => verdict !== null), faulty = judged.filter(({ verdict }) => verdict !== "pass");
    const words2 = `${lines2.length} lines, ${judged.length} crossings of seams, of which ${faulty.length} do not pass`;
    this.buttons.clear();
    this.list.replaceChildren(element("p", words2), longList(element("ol"), faulty, (crossing) => this.entry(crossing), atOnce, (left2) => `${left2} more`));
    this.host.tell(words2);
  }
  entry(crossing) {
    const named = button(crossing.faces, () => this.choose(crossing));
    this.buttons.set(crossing, named);
    return element("li", [named, new Text(failingOf(crossing) ?? crossing.verdict)], { className: crossing.verdict });
  }
  /** Marks a crossing with its line, and shows what is known of it above the list. */
  choose(crossing) {
    for (const [other, named] of this.buttons) named.setAttribute("aria-pressed", String(other === crossing));
    const line = this.asked.lines.lines[crossing.line].pieces.map(({ points }) => points);
    this.host.mark(crossing.place, line);
    this.detail.replaceChildren(
      element("p", crossing.faces),
      ...measuresOf(crossing).map(({ words: words2, verdict }) => element("div", words2, { className: verdict }))
    );
    this.detail.scrollIntoView({ block: "nearest" });
  }
};

// source/lamp_rows.ts
var LampRows = class {
  constructor(planes, host) {
    this.planes = planes;
    this.host = host;
    this.chosen = 0;
  }
  get all() {
    return this.planes;
  }
  get row() {
    return this.planes[this.chosen];
  }
  /** Takes other rows, without showing them. */
  take(planes) {
    this.planes = planes;
  }
  /** Shows other rows. */
  set(planes) {
    this.take(planes);
    this.choose(0);
    this.host.changed(false, true);
  }
  choose(row2) {
    this.chosen = row2;
    this.host.rowChosen();
  }
  next() {
    this.choose((this.chosen + 1) % Math.max(this.planes.length, 1));
  }
  /** Chooses the row that a pixel of the picture mirrors. */
  grab(x, y) {
    const row2 = this.host.rowAt(x, y);
    if (row2 >= 0 && row2 !== this.chosen) this.choose(row2);
  }
  /**
   * Moves the chosen row in its plane so that its image follows the mouse from one pixel of the picture to another; the
   * caller shows it. Where the reflection jumps, or is none, the row moves as far as the mouse at the target.
   */
  follow(from, to) {
    const { row: row2 } = this;
    if (!row2) return;
    const begin = this.host.mirroredOn(...from, row2), end = this.host.mirroredOn(...to, row2), step3 = begin && end && difference(end, begin);
    const farthest = 0.25 * Math.max(length(row2.u), length(row2.v));
    if (step3 && length(step3) <= farthest) this.edit(this.chosen, (plane) => movedWithin(plane, step3));
    else this.drag(to[0] - from[0], to[1] - from[1]);
  }
  /** Moves the chosen row in its plane, by pixels of the picture at the target; the caller shows it. */
  drag(x, y) {
    this.edit(this.chosen, (plane) => dragged(plane, this.host.camera(), x, y));
  }
  /** Moves the chosen row by mm, or degrees. */
  move(move, amount, isOver = true) {
    this.edit(this.chosen, (plane) => afterMove(plane, move, amount));
    this.host.changed(false, isOver);
  }
  /** Shows another row in place of one. */
  change(row2, plane) {
    this.edit(row2, () => plane);
    this.host.changed(false, true);
  }
  edit(row2, change2) {
    this.planes = this.planes.map((plane, i) => i === row2 ? change2(plane) : plane);
  }
};

// source/lamps_panel.ts
function showLamps(host) {
  const { lamps } = host;
  showRows(lamps.all, lamps.chosen, (row2) => lamps.choose(row2), (row2, plane) => lamps.change(row2, withRoom(plane)));
}
function lampButtons(host) {
  const run = async (work) => {
    try {
      await work();
      host.tell("");
    } catch (error) {
      host.fail(error);
    }
  };
  const request = () => requestText(host.camera(), host.lamps.all);
  const place = async () => host.lamps.set((await (await ask("POST", "/place", request())).json()).rig.planes);
  const save = async () => download("rig.toml", await (await ask("POST", "/rig", request())).blob());
  const open = async () => host.lamps.set((await newRig(await pickedText(".toml"))).planes);
  byId("lamp-buttons").replaceChildren(
    button("place for this view", () => void run(place)),
    button("save", () => void run(save)),
    button("open", () => void run(open))
  );
}

// source/link.ts
var text = (v) => v.map((x) => String(Number(x.toPrecision(9)))).join(",");
function numbersOf(given) {
  const numbers2 = given ? given.split(",").map(Number) : [];
  return numbers2.every(Number.isFinite) ? numbers2 : null;
}
function vectorOf(given) {
  const numbers2 = numbersOf(given);
  return numbers2?.length === 3 ? numbers2 : null;
}
var eyeTexts = (eye) => ({
  eye: text(eye.eye),
  target: text(eye.target),
  up: text(eye.up),
  lens: eye.projection === "orthographic" ? `height,${eye.orthographic_height}` : `fov,${eye.vertical_fov}`
});
function eyeOf(given) {
  const [eye, target, up] = ["eye", "target", "up"].map((name) => vectorOf(given.get(name)));
  const [lens, size2] = (given.get("lens") ?? "").split(","), wide2 = Number(size2), isParallel = lens === "height";
  if (!eye || !target || !up || !["height", "fov"].includes(lens) || !(wide2 > 0 && (isParallel || wide2 < 180))) return null;
  return {
    projection: isParallel ? "orthographic" : "perspective",
    eye,
    target,
    up,
    vertical_fov: isParallel ? 28 : wide2,
    orthographic_height: isParallel ? wide2 : 0
  };
}
var rowText = (p) => `${text([...p.origin, ...p.u, ...p.v, p.lamps, p.pitch, p.diameter, ...p.luminance])},${p.caps},${p.mirror}`;
function rowOf(given) {
  const parts = given.split(","), n = parts.slice(0, 15).map(Number), [caps, mirror] = parts.slice(15);
  const isRow = parts.length === 17 && n.every(Number.isFinite) && n[9] >= 0 && n[10] > 0 && n[11] > 0 && ["dark", "luminous"].includes(caps) && ["tube", "flat", "exact"].includes(mirror);
  if (!isRow) return null;
  const vector2 = (at) => [n[at], n[at + 1], n[at + 2]];
  return {
    origin: vector2(0),
    u: vector2(3),
    v: vector2(6),
    lamps: Math.round(n[9]),
    pitch: n[10],
    diameter: n[11],
    luminance: vector2(12),
    caps,
    mirror
  };
}
var noteText = ({ place, face, text: words2 }) => `${text([...place, face])},${words2}`;
function noteOf(given) {
  const parts = given.split(","), n = parts.slice(0, 4).map(Number), words2 = parts.slice(4).join(",");
  return n.every(Number.isFinite) && words2 ? { place: [n[0], n[1], n[2]], face: n[3], text: words2 } : null;
}
function keepInAddress(state) {
  history.replaceState(null, "", `#${fragmentOf(state)}`);
}
function fragmentOf({ camera, look, planes, hidden, section, seams, lines: lines2, notes }) {
  const fragment = new URLSearchParams({ ...eyeTexts(camera), look: wordOf(look) });
  if (hasSections(look)) fragment.set("across", directionWord(look.across));
  for (const plane of planes ?? []) fragment.append("row", rowText(plane));
  if (planes?.length === 0) fragment.append("rows", "none");
  if (hidden.length > 0) fragment.append("hidden", hidden.join(","));
  if (section) fragment.append("section", section);
  if (seams) fragment.set("seams", "shown");
  if (lines2) fragment.set("lines", "shown");
  for (const note of notes) fragment.append("note", noteText(note));
  return fragment;
}
function stateOfAddress() {
  const given = new URLSearchParams(location.hash.slice(1)), rows = given.getAll("row").map(rowOf);
  const camera = eyeOf(given), look = lookOf(given.get("look") ?? "", directionOf(given.get("across") ?? "") ?? void 0), hidden = numbersOf(given.get("hidden"));
  const notes = given.getAll("note").map(noteOf);
  if (!camera || !look || !hidden || rows.includes(null) || notes.includes(null)) return null;
  const isOwn = rows.length > 0 || given.get("rows") === "none";
  return {
    camera,
    look,
    planes: isOwn ? rows : null,
    hidden,
    section: given.get("section") ?? "",
    seams: given.get("seams") === "shown",
    lines: given.get("lines") === "shown",
    notes
  };
}
function linkOf(state) {
  const fragment = fragmentOf(state);
  fragment.set("token", token);
  return `${location.origin}${location.pathname}#${fragment}`;
}

// source/live_picture.ts
var slice2 = 12;
var LivePicture = class {
  // of the last eye that came to rest; false: a later eye ended them
  constructor(facts2, host) {
    this.host = host;
    this.canvas = byId("picture");
    this.white = 0;
    this.fullCurvature = 1e-3;
    this.radii = [1, 1e3];
    this.frame = 0;
    this.spent = 0;
    // ms of work since the last frame
    this.turn = 0;
    // of the changes: work for an earlier one is out of date
    this.isEyeMoving = false;
    this.surfaces = Promise.resolve(true);
    this.picture = new Picture(this.canvas, facts2);
    this.exact = new ExactPicture(byId("still"), "/still", (line) => host.tell(line), (error) => host.fail(error));
    this.tracing = new Tracing(facts2.reflections, (camera, spent) => this.picture.bufferFor(camera, spent), (buffer) => {
      this.picture.show(buffer);
      this.paint();
    }, { hidden: () => host.pictured().hidden });
  }
  display() {
    return { ...this.host.look(), planes: this.host.pictured().planes, white: this.white || 1, fullCurvature: this.fullCurvature, radii: this.radii };
  }
  /** The surface at a pixel, if there is one. */
  pick(x, y) {
    return this.picture.pick(x, y);
  }
  /** What the picture in hand sees; null without one. */
  sight() {
    return this.picture.sight();
  }
  /** The nearest of some rows that a pixel mirrors; -1 without one. */
  rowAt(x, y, planes) {
    return this.picture.rowAt(x, y, planes);
  }
  /** Where the reflection at a pixel meets the plane of a row; null if it does not. */
  mirroredOn(x, y, plane) {
    return this.picture.mirroredOn(x, y, plane);
  }
  /** Something has moved: the exact picture is out of date, and follows at rest. */
  changed(isEye, isOver) {
    this.exact.outdate();
    ++this.turn;
    this.isEyeMoving = isEye && !isOver;
    const began = performance.now();
    if (this.isEyeMoving) this.tracing.move(this.host.pictured().camera).catch((error) => this.host.fail(error));
    else this.paint();
    this.spent += performance.now() - began;
    if (isOver) void this.settle(isEye);
  }
  /** Completes the picture after a change: surfaces, bent pixels, white, and after a while the exact picture. */
  async settle(isEye) {
    const own = ++this.turn, began = performance.now(), { host } = this;
    if (isEye) this.surfaces = this.tracing.rest(host.pictured().camera);
    try {
      if (!await this.surfaces || own !== this.turn) return;
      const taken = performance.now() - began;
      if (!await this.refine(own)) return;
      this.measure();
      this.draw();
      if (isEye) host.tell(`surfaces in ${taken.toFixed(0)} ms`);
      host.settled();
      const ev = host.isCompared() ? exposureOf(this.white) : null;
      if (host.look().look === "lamps") this.exact.follow({ ...host.pictured(), ev });
    } catch (error) {
      this.surfaces = Promise.resolve(true);
      host.fail(error);
    }
  }
  /** Divides bent pixels in slices of time; false if something changed meanwhile. */
  async refine(own) {
    cancelAnimationFrame(this.frame);
    this.picture.renew();
    this.draw();
    while (own === this.turn) {
      if (this.picture.refine(this.display(), slice2)) return true;
      await new Promise((resolve) => setTimeout(resolve));
    }
    return false;
  }
  /** Takes white or the scale of curvatures or radii from the picture as it is drawn. */
  measure() {
    const stated = this.host.look(), { look } = stated;
    if (look === "curvature") this.fullCurvature = this.picture.usualCurvature(stated);
    if (look === "radius") this.radii = this.picture.usualRadii();
    if (look === "lamps") this.white = this.picture.whiteOf();
  }
  paint() {
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.drawFrame());
  }
  drawFrame() {
    const began = performance.now();
    this.draw();
    const taken = performance.now() - began + this.spent;
    this.canvas.dataset.frame = taken.toFixed(1);
    this.spent = 0;
    if (this.isEyeMoving) this.tracing.pace(taken);
    if (this.white === 0) {
      this.measure();
      this.draw();
    }
  }
  draw() {
    this.picture.draw(this.display());
    this.host.drawn();
  }
  /** Shows pictures as large as the window allows, in the shape of the camera's. */
  fit({ width, height }) {
    const room = this.canvas.parentElement, scale = Math.min(room.clientWidth / width, room.clientHeight / height);
    for (const shown2 of [this.canvas, this.exact.canvas])
      Object.assign(shown2.style, { width: `${width * scale}px`, height: `${height * scale}px` });
  }
  /** The exact picture, or that of another look, as the bytes of a file. */
  async file() {
    return this.host.look().look === "lamps" ? this.exact.file(this.host.pictured()) : new Promise((use) => this.canvas.toBlob((blob) => use(blob)));
  }
};

// source/look_legend.ts
var long = 220;
var high = 10;
function scaleOf2({ look, kind, fullCurvature, radii }) {
  if (look === "radius") return { ends: [`${radii[0]} mm`, `${radii[1]} mm`], colorAt: radiusColorAt };
  if (look !== "curvature") return null;
  const colorAt = curvatureColorAt(kind), unit2 = kind === "gauss" ? "/mm²" : "/mm";
  return kind === "absolute" ? { ends: [`0${unit2}`, `${fullCurvature} ${unit2}`], colorAt } : { ends: [`−${fullCurvature} ${unit2}`, `${fullCurvature} ${unit2}`], colorAt: (share2) => colorAt(2 * share2 - 1) };
}
var LookLegend = class {
  constructor(into) {
    this.into = into;
    this.bar = element("canvas", "", { width: long, height: high });
    this.shown = "";
  }
  /** Shows the scale of a display, if it has one. */
  show(display) {
    const scale = scaleOf2(display), shown2 = scale ? `${display.look} ${display.kind} ${scale.ends.join()}` : "";
    if (shown2 === this.shown) return;
    this.shown = shown2;
    this.into.replaceChildren(...scale ? [element("span", scale.ends[0]), this.bar, element("span", scale.ends[1])] : []);
    if (scale) this.draw(scale.colorAt);
  }
  draw(colorAt) {
    const context = this.bar.getContext("2d");
    for (let x = 0; x < long; ++x) {
      const [r, g, b] = colorAt((x + 0.5) / long).map((share2) => Math.round(255 * share2));
      context.fillStyle = `rgb(${r}, ${g}, ${b})`;
      context.fillRect(x, 0, 1, high);
    }
  }
};

// source/marks.ts
var arm = 7;
var gap = 2;
var Marks = class {
  constructor(picture, camera) {
    this.place = null;
    this.stretch = [];
    this.overlay = new EyeOverlay("marks", picture, camera, (context, eye) => this.draw(context, new Projection(eye)));
  }
  /** Shows a place, and a stretch of which none, one or several pieces are there. */
  show(place, stretch) {
    this.place = place;
    this.stretch = stretch;
    this.overlay.show(true);
  }
  /** Shows another place beside the stretch; null: nothing at all. */
  move(place) {
    if (place) return this.show(place, this.stretch);
    this.stretch = [];
    this.overlay.show(false);
  }
  draw(context, projection) {
    const pixel = (at) => projection.set(at) ? [projection.x, projection.y] : null;
    const lines2 = this.stretch.map((piece) => piece.map(pixel)), cross3 = this.place ? crossAt(pixel(this.place)) : [];
    for (const [color, width] of [["#000", 4], ["#ff4fd8", 2]]) {
      Object.assign(context, { strokeStyle: color, lineWidth: width });
      for (const line of [...lines2, ...cross3]) stroke(context, line);
    }
  }
};
function crossAt(pixel) {
  if (!pixel) return [];
  const [x, y] = pixel;
  return [[-arm, -gap], [gap, arm]].flatMap(([from, to]) => [
    [[x + from, y], [x + to, y]],
    [[x, y + from], [x, y + to]]
  ]);
}

// source/profile_plot.ts
function plotted(profile, mending) {
  if (mending === "position") return ["gap", profile.gap, (s) => s.gap];
  const { curvature } = profile;
  if (mending === "curvature" && curvature)
    return ["curvature mismatch", curvature, (s) => curvature.formula === "catia" ? s.catia : s.alias];
  return ["angle", profile.angle, (s) => s.angle];
}
var wide = 320;
var high2 = 90;
var top = 14;
function svg(tag, attributes, text2 = "") {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.textContent = text2;
  return made;
}
function lines(profile, value, scale) {
  const found = [];
  let piece = -1;
  for (const sample of profile.samples) {
    const v = value(sample);
    if (v === null || v === void 0) piece = -1;
    else {
      if (sample.piece !== piece) found.push([]);
      piece = sample.piece;
      found[found.length - 1].push(`${(sample.along / profile.length * wide).toFixed(1)},${scale(v).toFixed(1)}`);
    }
  }
  return found.map((points) => points.join(" "));
}
function profilePlot(profile, mending) {
  const [name, quantity, value] = plotted(profile, mending);
  const unit2 = quantity?.unit === "1" ? "" : ` ${quantity?.unit ?? ""}`, limit = quantity?.limit ?? null;
  const largest = Math.max(quantity?.largest ?? 0, limit ?? 0, 1e-12) * 1.05;
  const scale = (v) => top + (high2 - top) * (1 - v / largest);
  const title = `${name} up to ${quantity?.largest.toPrecision(3) ?? "?"}${unit2} on ${profile.length.toFixed(1)} mm` + (limit === null ? "" : `, limit ${limit}${unit2}`);
  const plot = svg("svg", { viewBox: `0 0 ${wide} ${high2 + 1}`, class: "plot", role: "img", "aria-label": title });
  plot.append(svg("text", { x: 0, y: 10 }, title));
  if (limit !== null) plot.append(svg("line", { class: "limit", x1: 0, x2: wide, y1: scale(limit), y2: scale(limit) }));
  for (const points of lines(profile, value, scale)) plot.append(svg("polyline", { points }));
  return plot;
}

// source/faults.ts
function stretchOf({ samples }) {
  const pieces = /* @__PURE__ */ new Map();
  for (const { piece, place } of samples) pieces.set(piece, [...pieces.get(piece) ?? [], place]);
  return [...pieces.values()];
}
var shown = 0.16;
function closeUp(host, fault) {
  const { upper, lower } = host.facts.bounds, height = shown * length(difference(upper, lower));
  const view = host.facts.views.find(({ name }) => name === fault.view);
  if (!view) return lookingAt(host.camera(), fault.place, 3 * height);
  const away = length(difference(fault.place, view.camera.eye));
  return {
    ...view.camera,
    target: fault.place,
    orthographic_height: height,
    vertical_fov: 2 * Math.atan(height / (2 * away)) * 180 / Math.PI
  };
}
function sightOf(fault) {
  const seen = fault.width >= 0.05 ? ` · breaks a reflection by ${fault.width.toFixed(1)}′` : "";
  const long2 = fault.length > 0 ? ` · ${fault.length.toFixed(1)} mm, ${(100 * fault.visible).toFixed(0)} % visible` : "";
  return fault.mending + seen + long2 + (fault.mirrored ? " · on both sides" : "");
}
function entry(host, fault) {
  const into = element("div");
  const go = () => {
    host.lookFrom(closeUp(host, fault));
    host.mark(fault.place, fault.profile ? stretchOf(fault.profile) : []);
    for (const other of document.querySelectorAll("#faults button")) other.removeAttribute("aria-pressed");
    named.setAttribute("aria-pressed", "true");
    if (fault.profile) into.replaceChildren(profilePlot(fault.profile, fault.mending));
  };
  const named = button(fault.faces, go);
  return element("li", [
    named,
    element("div", fault.message, { className: fault.verdict }),
    element("div", sightOf(fault), { className: "soft" }),
    into
  ]);
}
var atOnce2 = 20;
var list = (host, faults, start2) => longList(element("ol", "", { start: start2 }), faults, (fault) => entry(host, fault), atOnce2, (left2) => `${left2} more`);
function faultsPanel(into, host) {
  const found = element("div");
  const fetchAll = async (reply) => {
    try {
      host.tell("inspecting");
      const { items, hidden } = await (await reply).json();
      found.replaceChildren(items.length + hidden.length > 0 ? list(host, items, 1) : element("p", "no faults"));
      if (hidden.length > 0) found.append(element("p", "In hidden places:"), list(host, hidden, items.length + 1));
      host.tell(`${items.length + hidden.length} faults, in the order of mending`);
    } catch (error) {
      host.fail(error);
    }
  };
  const withLines = button(
    "with lines of these lamps",
    () => void fetchAll(ask("POST", "/inspect", requestText(host.camera(), host.display().planes)))
  );
  withLines.title = "judges the lamps' reflection lines in this view, too";
  into.replaceChildren(button("inspect", () => void fetchAll(ask("GET", "/inspect"))), withLines, found);
}

// source/page_panel.ts
var shownViews = ["front", "rear", "left", "right", "top", "three-quarter-front", "three-quarter-rear"];
function namedViews(facts2) {
  return [{ name: "opened", camera: facts2.camera }, ...facts2.own_views, ...facts2.views.filter(({ name }) => shownViews.includes(name))];
}
function showLooks(stated, row2, choose) {
  const { look, kind } = stated;
  choice(byId("look-buttons"), looks, look, (name) => choose({ ...stated, look: name }));
  byId("curvature-kind").replaceChildren(...look === "curvature" ? [
    selection("of", curvatureKinds, kind, (name) => choose({ ...stated, kind: name })),
    ...kind === "section" ? sectionDirection(stated, row2, choose) : []
  ] : []);
}
function sectionDirection(stated, row2, choose) {
  const known = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], ...row2 ? { lamps: unit(row2.u) } : {} };
  const named = Object.keys(known).find((name) => directionWord(known[name]) === directionWord(stated.across)) ?? "";
  const input = element("input", "", { ariaLabel: "normal of the planes", value: directionWord(stated.across), size: 14 });
  input.onchange = () => {
    const across = directionOf(input.value);
    if (across) choose({ ...stated, across });
    else input.value = directionWord(stated.across);
  };
  return [selection("across", ["", ...Object.keys(known)], named, (name) => {
    if (name) choose({ ...stated, across: known[name] });
  }), input];
}
function moreViews(host) {
  const views = host.facts.views.filter(({ name }) => !shownViews.includes(name));
  return selection("more", ["", ...views.map(({ name }) => name)], "", (chosen) => {
    const view = views.find(({ name }) => name === chosen);
    if (view) host.lookFrom(view.camera);
  });
}
function showPanel(host) {
  byId("views").replaceChildren(
    ...host.views().map(({ name, show }) => button(name, show)),
    moreViews(host),
    button("save view", () => download("view.toml", new Blob([viewText(host.camera())])))
  );
  showLamps(host);
  lampButtons(host);
  faultsPanel(byId("faults"), host);
  byId("page").replaceChildren(
    button("picture", () => host.savePicture()),
    button("copy link", () => host.copyLink()),
    button("keys", () => showKeys(host)),
    selection("mouse", mouseStyles, host.style(), (style) => host.setStyle(style)),
    selection("colours", ["light dark", "light", "dark"], localStorage.getItem("colours") ?? "light dark", showInColours)
  );
  showFacts(host.facts);
}

// source/pick_panel.ts
var PickPanel = class {
  constructor(host) {
    this.host = host;
    this.last = null;
    this.running = new AbortController();
  }
  /** Shows a place at once, and what is proved of it as soon as the server has traced it. */
  show(at) {
    const before = this.last, face = at && at.face > 0 ? this.host.facts.faces[at.face - 1] : null;
    this.running.abort();
    byId("note").replaceChildren();
    if (!at) return showPairs(byId("pick"), [["nothing", ""]]);
    this.last = at;
    const name = face ? `${face.id} ${face.name}` : "ground", show = (proof, proving) => showPairs(byId("pick"), [
      ["face", name],
      ["place", `${numbers(proof ? proof.place : at.place, 3)} mm`],
      ["proved to", proof ? boundText(proof) : proving],
      ["normal", numbers(at.normal, 4)],
      ["radii", at.radii.map((radius, i) => proof ? rangeText(proof.curvatures[i], radius) : radiusText(radius)).join(", ")],
      ...before ? [["from the last", apartText(before, at)]] : []
    ]);
    show(null, "…");
    if (face) byId("note").replaceChildren(noteField(at.place, face.id, (note) => this.host.addNote(note)));
    this.running = new AbortController();
    void this.prove(at, show, this.running.signal);
  }
  async prove({ camera, pixel }, show, signal) {
    const more = `pixel = [${pixel.join(", ")}]
${hiddenText(this.host.hidden())}`;
    try {
      const { picked } = await (await ask("POST", "/pick", requestText(camera, void 0, more), signal)).json();
      if (!signal.aborted) show(picked, "nothing");
    } catch (error) {
      if (signal.aborted) return;
      show(null, "nothing");
      this.host.fail(error);
    }
  }
};
var numbers = (v, digits) => v.map((n) => n.toFixed(digits)).join(", ");
function noteField(place, face, add) {
  const input = element("input", "", { ariaLabel: "note", placeholder: "a note on this place", maxLength: 300 });
  const keep = () => {
    if (input.value.trim()) add({ text: input.value.trim(), place, face });
    input.value = "";
  };
  input.onkeydown = (event) => {
    if (event.key === "Enter") keep();
  };
  return element("p", [input, button("note", keep)]);
}
var flat = 1e6;
var sideOf = (radius) => radius > 0 ? "hollow" : "crowned";
function radiusText(radius) {
  const size2 = Math.abs(radius);
  if (!(size2 < flat)) return "flat";
  return `${size2.toFixed(Math.max(0, 3 - Math.floor(Math.log10(size2))))} mm ${sideOf(radius)}`;
}
function rangeText(range, radius) {
  if (!range) return `${radiusText(radius)}, not proved`;
  const [low, high3] = range, least = 1 / Math.max(Math.abs(low), Math.abs(high3));
  if (low <= 0 && high3 >= 0 && least <= flat) return `more than ${least.toPrecision(3)} mm either way`;
  if (least > flat) return `flat: more than ${Math.min(least, 1e12).toPrecision(3)} mm`;
  const middle2 = (1 / low + 1 / high3) / 2, bound = Math.max(Math.abs(1 / low - 1 / high3) / 2, 1e-15 * Math.abs(middle2));
  const digits = Math.min(Math.max(-Math.floor(Math.log10(bound)), 0), 6);
  return `${Math.abs(middle2).toFixed(digits)} ± ${boundDigits(bound + 0.5 * 10 ** -digits)} mm ${sideOf(middle2)}`;
}
function boundDigits(bound) {
  if (!(bound > 0)) return "0";
  const unit2 = 10 ** Math.floor(Math.log10(bound));
  return (Math.ceil(bound / unit2) * unit2).toPrecision(1);
}
function boundText({ bound, unique }) {
  return `${boundDigits(bound)} mm${unique ? ", the only hit of its surface piece" : ""}`;
}
function apartText(a, b) {
  const angle = Math.atan2(length(cross(a.normal, b.normal)), dot(a.normal, b.normal)) * 180 / Math.PI;
  return `${length(difference(b.place, a.place)).toFixed(3)} mm, normals ${angle.toFixed(3)}° apart`;
}

// source/saving.ts
function savePicture(picture, facts2, display, { width, height }) {
  download("picture.png", picture);
  const command = `keiko render ${facts2.inputs.join(" ")} --view view.toml --rig rig.toml --size ${width}x${height}${lookOptions(display)} -o picture.png`;
  showDialog("Picture", [
    ["file", "picture.png, in your downloads"],
    ["made by", display.look === "faces" ? "this page alone" : command],
    ["", "save view and save write the view and the rig"]
  ]);
}
function lookOptions(display) {
  if (display.look === "lamps") return "";
  const section = hasSections(display) ? ` --section ${directionWord(display.across)}` : "";
  const scale = display.look === "radius" ? ` --scale ${display.radii.join(":")}` : "";
  return ` --look ${wordOf(display, display.fullCurvature)}${section}${scale}`;
}
async function copyLink(state, tell) {
  try {
    await navigator.clipboard.writeText(linkOf(state));
    tell("the link is copied; it opens this view as long as the server goes on");
  } catch {
    showDialog("Link", [["address", linkOf(state)]]);
  }
}

// source/seam.ts
var continuities = [
  { label: "G0", name: "gap", mending: "position", of: (seam) => seam.gap, unit: " mm", shown: 1 },
  { label: "G1", name: "angle", mending: "tangent", of: (seam) => seam.angle, unit: "°", shown: 1 },
  { label: "G2", name: "curvature mismatch", mending: "curvature", of: (seam) => seam.curvature, unit: " %", shown: 100 },
  { label: "G3", name: "slope of curvature", mending: "curvature", of: (seam) => seam.curvature_slope, unit: "°", shown: 1 },
  { label: "run-out", name: "step where the crease fades", mending: "tangent", of: (seam) => seam.fading, unit: "°/mm", shown: 1 }
];
function failing(seam) {
  return continuities.find(({ of }) => of(seam)?.verdict === "fail");
}
function worstPlace(seam) {
  return failing(seam)?.of(seam)?.place ?? seam.middle;
}
function measures(seam) {
  return continuities.flatMap(({ label, name, of, unit: unit2, shown: shown2 }) => {
    const measured = of(seam);
    return measured ? [measureLine(`${label} ${name}`, measured, unit2, shown2)] : [];
  });
}

// source/seam_lines.ts
var reach3 = 6;
var step2 = 4;
var order = Object.keys(verdictColors);
var styleOf = (seam) => seam.scrap ? "none" : seam.verdict;
var SeamLines = class {
  constructor(picture, host) {
    this.host = host;
    this.seams = [];
    this.drawn = [];
    this.overlay = new EyeOverlay("seam-lines", picture, () => host.camera(), (context, camera) => this.draw(context, camera));
  }
  /** Shows these seams, none or more. */
  show(seams) {
    this.seams = seams;
    this.drawn = [];
    this.overlay.show(seams.length > 0);
  }
  /** The picture sees other surfaces than when the seams were drawn. */
  update() {
    if (this.seams.length > 0) this.overlay.show(true);
  }
  /** The visible seam at a pixel of the picture, of several that which fails; null without one. */
  at(x, y) {
    const isNear = (point) => point !== null && Math.hypot(point[0] - x, point[1] - y) <= reach3;
    const near = this.drawn.filter(({ lines: lines2, label }) => isNear(label && label.at) || lines2.some((line) => line.some(isNear)));
    return near[near.length - 1]?.seam ?? null;
  }
  draw(context, camera) {
    const sight = this.host.sight(), hidden = new Set(this.host.hidden());
    if (!sight) return;
    const found = new VisibleCurves(camera, sight);
    this.drawn = this.seams.filter(({ face_ids: [a, b] }) => !hidden.has(a) || !hidden.has(b)).map((seam) => ({ seam, lines: seam.course.map((piece) => found.curve(piece)), label: labelOf(seam, found) })).sort((a, b) => order.indexOf(styleOf(a.seam)) - order.indexOf(styleOf(b.seam)));
    for (const style of order) {
      const lines2 = this.drawn.filter(({ seam }) => styleOf(seam) === style).flatMap((seam) => seam.lines);
      strokeAll(context, lines2, "#000", 3);
      strokeAll(context, lines2, verdictColors[style], 1.5);
    }
    drawLabels(context, this.drawn.flatMap(({ label }) => label ?? []), verdictColors.fail);
  }
};
function labelOf(seam, found) {
  const fails = failing(seam), place = fails && found.point(worstPlace(seam)), above = 14;
  return place ? { text: fails.label, at: [place[0], place[1] - above] } : null;
}
var VisibleCurves = class extends Projection {
  constructor(camera, sight) {
    super(camera);
    this.sight = sight;
  }
  point(place) {
    return this.set(place) && this.sight.sees(place) ? [this.x, this.y] : null;
  }
  curve(places) {
    const ends = places.map((place) => this.set(place) ? [this.x, this.y] : null);
    return places.flatMap((place, i) => i === 0 ? [this.point(place)] : this.chord(places[i - 1], place, ends[i - 1], ends[i]));
  }
  /** The places of a chord but for its first. */
  chord(a, b, from, to) {
    if (!from || !to || this.isBeside(from, to)) return [null];
    const steps = Math.min(Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / step2)), 1e3);
    return Array.from({ length: steps }, (_, k) => {
      const share2 = (k + 1) / steps;
      return this.point([a[0] + (b[0] - a[0]) * share2, a[1] + (b[1] - a[1]) * share2, a[2] + (b[2] - a[2]) * share2]);
    });
  }
  isBeside(a, b) {
    const { width, height } = this.camera;
    return Math.max(a[0], b[0]) < 0 || Math.min(a[0], b[0]) > width || Math.max(a[1], b[1]) < 0 || Math.min(a[1], b[1]) > height;
  }
};

// source/seams.ts
var order2 = ["fail", "undecided", "pass"];
var atOnce3 = 20;
var SeamsPanel = class {
  constructor(into, host, picture) {
    this.host = host;
    this.seams = null;
    // judged on request, once
    this.isOver = false;
    // they are drawn over the picture, or will be
    this.chosen = new AbortController();
    this.head = element("p");
    this.detail = element("div", "", { id: "seam" });
    this.found = element("div");
    this.buttons = /* @__PURE__ */ new Map();
    this.lines = new SeamLines(picture, host);
    into.replaceChildren(this.head, this.detail, this.found);
    this.head.append(button("judge", () => void this.show(true)));
  }
  /** True if they are drawn over the picture. */
  get shown() {
    return this.isOver;
  }
  /** Draws the seams over the picture, or takes them off; judges them before if nobody has. */
  async show(isOver) {
    this.isOver = isOver;
    this.host.keep();
    try {
      const seams = isOver ? await (this.seams ??= this.judged()) : [];
      if (isOver !== this.isOver) return;
      this.lines.show(seams);
      this.head.firstElementChild.setAttribute("aria-pressed", String(isOver));
    } catch (error) {
      this.seams = null;
      this.isOver = false;
      this.host.fail(error);
    }
  }
  toggle() {
    void this.show(!this.isOver);
  }
  /** The picture sees other surfaces than when the seams were drawn. */
  update() {
    this.lines.update();
  }
  /** Chooses the seam at a pixel of the picture; null without one. */
  pick(x, y) {
    const seam = this.isOver ? this.lines.at(x, y) : null;
    if (seam) this.choose(seam);
    return seam;
  }
  async judged() {
    this.host.tell("judging the seams");
    const { seams } = await (await ask("GET", "/seams")).json();
    if (seams.some((seam) => !seam.course)) throw new Error("the report is of an earlier version: its seams have no course");
    const sorted = [...seams].sort((a, b) => order2.indexOf(a.verdict) - order2.indexOf(b.verdict) || b.severity - a.severity || a.number - b.number);
    this.host.tell(`${seams.length} stretches of seams, the worst first`);
    this.head.replaceChildren(button("over the picture", () => this.toggle()));
    this.found.replaceChildren(seams.length > 0 ? this.list(sorted) : element("p", "no seams"));
    return sorted;
  }
  /** The seams in their order; many that pass on request. */
  list(seams) {
    const faulty = seams.filter((seam) => seam.verdict !== "pass").length, first = Math.max(faulty, atOnce3);
    return longList(element("table"), seams, (seam) => this.entry(seam), first, (left2) => `${left2} more, which pass`);
  }
  entry(seam) {
    const named = button(seam.faces, () => this.flyTo(seam));
    this.buttons.set(seam, named);
    return element("tr", [
      element("td", seam.verdict, { className: seam.verdict }),
      element("td", failing(seam)?.label ?? seam.kind),
      element("td", [named])
    ]);
  }
  flyTo(seam) {
    this.host.flyTo(worstPlace(seam), seam.length);
    this.host.mark(worstPlace(seam), seam.course);
    this.choose(seam);
  }
  /** Shows what is known of a seam above the list. */
  choose(seam) {
    for (const [other, named] of this.buttons) named.setAttribute("aria-pressed", String(other === seam));
    const plot = element("div");
    this.detail.replaceChildren(
      element("p", [button("fly there", () => this.flyTo(seam)), new Text(`${seam.faces}, ${seam.kind}, ${seam.length.toFixed(1)} mm`)]),
      ...measures(seam).map(({ words: words2, verdict }) => element("div", words2, { className: verdict })),
      plot
    );
    this.detail.scrollIntoView({ block: "nearest" });
    this.chosen.abort();
    this.chosen = new AbortController();
    void this.plot(seam, plot, this.chosen.signal);
  }
  async plot(seam, into, signal) {
    try {
      const { profiles: [profile] } = await (await ask("POST", "/profile", String(seam.number), signal)).json();
      into.replaceChildren(profilePlot(profile, failing(seam)?.mending ?? "tangent"));
      into.scrollIntoView({ block: "nearest" });
    } catch (error) {
      if (!signal.aborted) into.replaceChildren(element("p", error instanceof Error ? error.message : String(error), { className: "soft" }));
    }
  }
};

// source/section_plane.ts
var axes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
var planeWords = ({ facing, height }) => `${facing}=${height.toFixed(2)}`;
function planeOf(words2) {
  const [facing, at, ...more] = words2.split("="), normal = axes[facing] ?? directionOf(facing), height = at?.trim() ? Number(at) : NaN;
  return normal && Number.isFinite(height) && more.length === 0 ? { facing, normal: unit(normal), height } : null;
}
function middlePlane(axis, bounds) {
  const normal = axes[axis], [low, high3] = heightsOf(bounds, normal);
  return { facing: axis, normal, height: (low + high3) / 2 };
}
function heightsOf({ lower, upper }, normal) {
  const far = [0, 1, 2].map((k) => [lower[k] * normal[k], upper[k] * normal[k]]);
  return [far.reduce((all, ends) => all + Math.min(...ends), 0), far.reduce((all, ends) => all + Math.max(...ends), 0)];
}
function pivotOf({ normal, height }, { lower, upper }) {
  const middle2 = scaled(sum(lower, upper), 0.5);
  return sum(middle2, scaled(normal, height - dot(normal, middle2)));
}
function facingPlane(plane, facing, bounds) {
  const faced = planeOf(`${facing}=0`);
  return faced && { ...faced, height: dot(faced.normal, pivotOf(plane, bounds)) };
}
function turnedPlane(plane, camera, right2, down, bounds) {
  const seen = axesOf(camera), normal = turned(turned(plane.normal, seen.up, right2), seen.right, down);
  return facingPlane(plane, normal.map((x) => String(Number(x.toFixed(4)))).join(","), bounds);
}
function outlineOf({ normal, height }, { lower, upper }) {
  const corner = (i) => [0, 1, 2].map((k) => (i >> k & 1 ? upper : lower)[k]);
  const cuts = [];
  for (let i = 0; i < 8; ++i)
    for (const step3 of [1, 2, 4]) {
      if (i & step3) continue;
      const from = corner(i), to = corner(i | step3), a = dot(normal, from) - height, b = dot(normal, to) - height;
      if (a * b < 0) cuts.push(sum(scaled(from, b / (b - a)), scaled(to, a / (a - b))));
    }
  return inOrder(cuts, normal);
}
function inOrder(corners2, normal) {
  const middle2 = scaled(corners2.reduce((a, b) => sum(a, b), [0, 0, 0]), 1 / corners2.length);
  const aside = unit(Math.abs(normal[2]) < 0.9 ? [normal[1], -normal[0], 0] : [0, normal[2], -normal[1]]), across = cross(normal, aside);
  const angle = (corner) => {
    const out = difference(corner, middle2);
    return Math.atan2(dot(out, across), dot(out, aside));
  };
  return [...corners2].sort((a, b) => angle(a) - angle(b));
}

// source/section_curves.ts
var longestTooth = 0.06;
var SectionCurves = class {
  /** `size`: of the body, mm. */
  constructor(picture, camera, size2) {
    this.size = size2;
    this.curves = [];
    this.outline = [];
    this.overlay = new EyeOverlay("section-lines", picture, camera, (context, eye) => this.draw(context, new Projection(eye)));
  }
  /** Shows curves, none or more, on a plane with an outline of none or more corners. */
  show(curves, outline) {
    this.curves = curves;
    this.outline = outline;
    this.overlay.show(curves.length + outline.length > 0);
  }
  draw(context, projection) {
    const pixel = (at) => projection.set(at) ? [projection.x, projection.y] : null;
    const { outline: [first], outline } = this;
    context.strokeStyle = "#ffd23a", context.setLineDash([6, 5]);
    if (first) stroke(context, [...outline, first].map(pixel));
    context.setLineDash([]);
    this.drawCombs(context, pixel);
  }
  drawCombs(context, pixel) {
    const tooth = longestTooth * this.size / Math.max(largestCurvature(this.curves), 1e-12);
    for (const { samples } of this.curves.flatMap(({ pieces }) => pieces)) {
      const foot = samples.map((s) => pixel(s.place));
      const tip = samples.map((s) => pixel(sum(s.place, scaled(s.towards, -s.curvature * tooth))));
      context.strokeStyle = "#3ad0ff88";
      foot.forEach((from, i) => stroke(context, [from, tip[i]]));
      stroke(context, tip);
      context.strokeStyle = "#ffd23a";
      stroke(context, foot);
    }
  }
};
var largestCurvature = (curves) => Math.max(0, ...curves.map((curve) => Math.abs(curve.largest_curvature.value)));
function summaryOf(curves, plane) {
  if (curves.length === 0) return `${plane} misses the body`;
  const long2 = curves.reduce((all, curve) => all + curve.length, 0);
  return `${plane}: ${long2.toFixed(1)} mm, radii from ${(1 / Math.max(largestCurvature(curves), 1e-12)).toPrecision(4)} mm`;
}

// source/section.ts
var free = "free";
var perPixel = 1 / 200;
var SectionPanel = class {
  constructor(into, host, picture) {
    this.host = host;
    this.choice = element("select", "", { ariaLabel: "axis" });
    this.normal = element("input", "", { ariaLabel: "normal of the section", size: 22 });
    this.slider = element("input", "", { type: "range", ariaLabel: "position", step: "any" });
    this.height = element("input", "", { type: "number", ariaLabel: "position in mm", step: "any" });
    this.turning = element("p", [this.normal]);
    this.moving = element("p", [this.slider, this.height]);
    this.text = element("p");
    this.words = "";
    // of the plane
    this.shown = null;
    this.kept = [];
    // planes of an analysis
    this.isCutting = false;
    const { bounds: { lower, upper } } = host.facts;
    this.curves = new SectionCurves(picture, () => host.camera(), length(difference(upper, lower)));
    this.choice.onchange = () => this.choose(this.choice.value);
    this.normal.onchange = () => this.face(this.normal.value);
    this.slider.oninput = () => this.move(Number(this.slider.value));
    this.height.onchange = () => this.move(Number(this.height.value));
    into.replaceChildren(
      this.choice,
      this.turning,
      this.moving,
      this.text,
      element("p", "Ctrl + Shift + drag on the picture turns the plane", { className: "soft" })
    );
    this.offer([]);
    this.present("none");
  }
  /** The words of the plane that is shown, or "". */
  get plane() {
    return this.words;
  }
  /** The plane that is shown, and those of the analysis. */
  get planes() {
    return [.../* @__PURE__ */ new Set([this.plane, ...this.kept])].filter((plane) => plane !== "");
  }
  /** Offers the planes of an analysis, and shows the first. */
  take(planes) {
    this.offer(planes);
    this.show(planes[0] ?? "");
  }
  /** Shows a plane by its words; none for others. */
  show(words2) {
    const plane = planeOf(words2);
    this.set(plane, plane ? words2 : "");
  }
  /** Turns the plane about its middle on the body, as a drag by pixels on the picture; without one, a plane across y. */
  turn(x, y) {
    this.set(turnedPlane(this.shown ?? this.across("y"), this.host.camera(), x * perPixel, y * perPixel, this.host.facts.bounds));
  }
  offer(kept) {
    this.kept = kept;
    this.choice.replaceChildren(...["none", ...Object.keys(axes), free, ...kept].map((name) => element("option", name)));
  }
  choose(name) {
    if (name === free) this.set(this.shown ?? this.across("y"), void 0, free);
    else if (axes[name]) this.set(this.across(name));
    else this.show(name);
  }
  /** The plane across an axis through the middle of the body. */
  across(axis) {
    return middlePlane(axis, this.host.facts.bounds);
  }
  move(height) {
    if (this.shown && Number.isFinite(height)) this.set({ ...this.shown, height });
  }
  /** Turns the plane about its middle on the body to a direction. */
  face(facing) {
    const faced = this.shown && facingPlane(this.shown, facing.replace(/\s/g, ""), this.host.facts.bounds);
    this.set(faced ?? this.shown, void 0, free);
  }
  set(plane, words2 = plane ? planeWords(plane) : "", name = !plane ? "none" : axes[plane.facing] ? plane.facing : free) {
    this.shown = plane;
    this.words = words2;
    this.present(name);
    if (!this.isCutting) void this.cut();
  }
  /** Shows the plane's numbers, and what changes them. */
  present(name) {
    const { shown: shown2 } = this;
    this.choice.value = name;
    this.turning.hidden = name !== free;
    this.moving.hidden = shown2 === null;
    if (!shown2) return;
    const [min, max] = heightsOf(this.host.facts.bounds, shown2.normal);
    Object.assign(this.slider, { min: String(min), max: String(max) });
    this.slider.value = String(shown2.height);
    this.height.value = shown2.height.toFixed(2);
    this.normal.value = axes[shown2.facing]?.join(",") ?? shown2.facing;
  }
  /** Cuts the body by the plane; again and again while that moves on. */
  async cut() {
    this.isCutting = true;
    try {
      for (let cut = null; cut !== this.words; ) {
        cut = this.words;
        const curves = cut ? (await (await ask("POST", "/section", cut)).json()).curves : [];
        this.draw(curves, cut);
      }
      this.host.keep();
    } catch (error) {
      this.draw([], "");
      this.host.fail(error);
    }
    this.isCutting = false;
  }
  draw(curves, words2) {
    this.curves.show(curves, this.shown ? outlineOf(this.shown, this.host.facts.bounds) : []);
    this.text.textContent = words2 ? summaryOf(curves, words2) : "";
  }
};

// source/tree.ts
function row(name, faces, boxes, changed) {
  const own = new Set(faces);
  const box = element("input", "", { type: "checkbox", checked: true, ariaLabel: `show ${name}` });
  box.onchange = () => {
    for (const face of faces) for (const each of boxes.get(face)) each.checked = box.checked;
    changed();
  };
  const alone = button(name, () => {
    for (const [face, all] of boxes) for (const each of all) each.checked = own.has(face);
    changed();
  });
  alone.title = "show this alone";
  if (faces.length === 1) boxes.set(faces[0], [...boxes.get(faces[0]) ?? [], box]);
  return element("span", [box, alone]);
}
var openFaces = 50;
function body({ parts, faces }, part, boxes, changed) {
  const own = faces.filter((face) => face.part === part), name = parts[part] || `body ${part + 1}`;
  const leaves = own.map((face) => element("li", [row(`${face.id} ${face.name}`.trim(), [face.id], boxes, changed)]));
  return element("details", [
    element("summary", [row(`${name} (${own.length})`, own.map((face) => face.id), boxes, changed)]),
    element("ul", leaves)
  ], { open: parts.length === 1 && own.length <= openFaces });
}
var Tree = class {
  constructor(into, host) {
    this.into = into;
    this.host = host;
    this.boxes = /* @__PURE__ */ new Map();
    const hide = () => {
      host.hide([...this.boxes].filter(([, [box]]) => !box.checked).map(([face]) => face));
    };
    const find = element("input", "", { type: "search", placeholder: "find a face", ariaLabel: "find a face" });
    find.oninput = () => this.find(find.value.trim().toLowerCase());
    into.replaceChildren(
      button("show all", () => host.hide([])),
      find,
      ...host.facts.parts.map((_, part) => body(host.facts, part, this.boxes, hide))
    );
  }
  /** Takes over which faces are hidden. */
  update() {
    const hidden = new Set(this.host.hidden());
    for (const [face, boxes] of this.boxes) for (const box of boxes) box.checked = !hidden.has(face);
    for (const body2 of this.into.querySelectorAll("details")) {
      const [all, ...faces] = body2.querySelectorAll("input");
      all.checked = faces.some((box) => box.checked);
    }
  }
  /** Lists the faces that have a text in their number or name; all for an empty one. */
  find(text2) {
    for (const body2 of this.into.querySelectorAll("details")) {
      const leaves = [...body2.querySelectorAll("li")];
      for (const leaf of leaves) leaf.hidden = !leaf.textContent.toLowerCase().includes(text2);
      if (text2) body2.open = leaves.some((leaf) => !leaf.hidden);
    }
  }
};

// source/viewer.ts
var Viewer = class {
  constructor(facts2) {
    this.facts = facts2;
    this.left = [];
    // faces that are not shown
    this.stated = firstLook;
    this.legend = new LookLegend(byId("legend"));
    this.eye = facts2.camera;
    this.lamps = new LampRows(facts2.rig.planes, this);
    this.mouse = mouseStyles.find((style) => style === localStorage.getItem("mouse")) ?? "Keiko";
    this.picture = new LivePicture(facts2, this);
    const { canvas } = this.picture;
    this.gizmo = new Gizmo(canvas.parentElement, (move, amount, isOver) => this.lamps.move(move, amount, isOver));
    this.section = new SectionPanel(byId("section"), this, canvas);
    this.places = new PickPanel(this);
    this.comparison = new Comparison(byId("compare"), this, canvas);
    this.seams = new SeamsPanel(byId("seams"), this, canvas);
    this.lines = new LampLinesPanel(byId("lines"), this, canvas);
    this.tree = new Tree(byId("tree"), this);
    this.marks = new Marks(canvas, () => this.eye);
    this.analysis = new AnalysisPanel(byId("analysis"), this, canvas);
  }
  /** Shows what the address states, or else the analysis that the server was started with, or else its view. */
  async start() {
    const linked = stateOfAddress(), analysis = await fetchAnalysis(), { canvas } = this.picture;
    if (linked) this.restore(linked);
    else if (analysis) this.analysis.take(analysis);
    this.showLooks();
    showPanel(this);
    new Pointer(canvas, this);
    listenToKeys(canvas, this);
    window.onresize = () => this.picture.fit(this.eye);
    this.picture.fit(this.eye);
    this.changed(true, true);
  }
  camera() {
    return this.eye;
  }
  look() {
    return this.stated;
  }
  hidden() {
    return this.left;
  }
  sections() {
    return this.section.planes;
  }
  style() {
    return this.mouse;
  }
  display() {
    return this.picture.display();
  }
  sight() {
    return this.picture.sight();
  }
  pictured() {
    return { camera: this.eye, planes: this.lamps.all, hidden: this.left, ev: null };
  }
  isCompared() {
    return this.comparison.isShown;
  }
  rowAt(x, y) {
    return this.picture.rowAt(x, y, this.lamps.all);
  }
  mirroredOn(x, y, plane) {
    return this.picture.mirroredOn(x, y, plane);
  }
  restore({ camera, look, planes, hidden, section, seams, lines: lines2, notes }) {
    this.eye = { ...this.facts.camera, ...camera };
    this.lamps.take(planes ?? this.lamps.all);
    this.stated = look;
    this.left = hidden;
    this.analysis.notes.show(notes);
    if (section) this.section.show(section);
    if (seams) void this.seams.show(true);
    this.lines.show(lines2);
  }
  take({ views: [first], sections, hidden, rig }) {
    this.lamps.take(rig.planes);
    this.section.take(sections);
    if (first) this.eye = { ...this.eye, ...first.camera, width: this.eye.width, height: this.eye.height };
    this.choose(lookOf(first?.look ?? "lamps", first?.across) ?? this.stated);
    this.lamps.choose(0);
    this.hide(hidden);
  }
  state() {
    const { all } = this.lamps;
    return {
      camera: this.eye,
      look: this.stated,
      planes: all === this.facts.rig.planes ? null : all,
      hidden: this.left,
      section: this.section.plane,
      seams: this.seams.shown,
      lines: this.lines.shown,
      notes: this.analysis.notes.all
    };
  }
  keep() {
    keepInAddress(this.state());
  }
  settled() {
    this.seams.update();
    this.lines.settle();
    this.keep();
  }
  drawn() {
    this.gizmo.show(this.lamps.row, this.eye);
    this.legend.show(this.display());
  }
  rowChosen() {
    showLamps(this);
    this.drawn();
  }
  changed(isEye, isOver) {
    this.picture.changed(isEye, isOver);
    this.lines.outdate();
  }
  setCamera(camera) {
    this.eye = camera;
  }
  lookFrom(camera) {
    this.eye = sized(camera, this.eye.width, this.eye.height);
    this.changed(true, true);
  }
  flyTo(place, long2 = Infinity) {
    const size2 = length(difference(this.facts.bounds.upper, this.facts.bounds.lower));
    this.lookFrom(lookingAt(this.eye, place, Math.min(Math.max(3 * long2, size2 / 20), size2 / 2)));
    this.mark(place);
  }
  pick(x, y) {
    const picked = this.picture.pick(x, y);
    this.places.show(picked);
    if (this.lines.pick(x, y)) return;
    const seam = picked && this.seams.pick(x, y);
    if (seam) this.mark(picked.place, seam.course);
    else this.marks.move(picked && picked.place);
  }
  mark(place, stretch = []) {
    this.marks.show(place, stretch);
  }
  addNote(note) {
    this.analysis.addNote(note);
  }
  hide(faces) {
    this.left = faces;
    this.tree.update();
    this.changed(true, true);
  }
  choose(stated) {
    this.stated = stated;
    this.showLooks();
    if (stated.look === "curvature" || stated.look === "radius") this.picture.measure();
    this.changed(false, true);
  }
  chooseLook(look) {
    this.choose({ ...this.stated, look });
  }
  showLooks() {
    showLooks(this.stated, this.lamps.row, (look) => this.choose(look));
  }
  views() {
    return namedViews(this.facts).map(({ name, camera }) => ({ name, show: () => this.lookFrom(camera) }));
  }
  setStyle(style) {
    this.mouse = style;
    localStorage.setItem("mouse", style);
    this.tell(mouseHelp[style]);
  }
  toggleSeams() {
    this.seams.toggle();
  }
  turnSection(x, y) {
    this.section.turn(x, y);
  }
  toggleLines() {
    this.lines.toggle();
  }
  copyLink() {
    void copyLink(this.state(), (line) => this.tell(line));
  }
  savePicture() {
    const isLamps = this.stated.look === "lamps";
    this.tell("making the picture");
    this.picture.file().then((bytes2) => {
      savePicture(bytes2, this.facts, this.display(), this.eye);
      if (!isLamps) this.tell("");
    }).catch((error) => this.fail(error));
  }
  tell(line) {
    byId("state").textContent = line;
  }
  fail(error) {
    this.tell(error instanceof Error ? error.message : String(error));
  }
};

// source/main.ts
async function start() {
  try {
    showInColours(localStorage.getItem("colours") ?? "light dark");
    await new Viewer(await facts()).start();
    await followProgress(showProgress);
  } catch (error) {
    byId("state").textContent = error instanceof Error ? error.message : String(error);
  }
}
void start();
