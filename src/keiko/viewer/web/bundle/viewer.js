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
  const right = unit(cross(forward, camera.up));
  return { right, up: cross(right, forward), forward };
}
function pixelSize(camera) {
  const height = camera.projection === "orthographic" ? camera.orthographic_height : 2 * Math.tan(camera.vertical_fov * Math.PI / 360);
  return height / camera.height;
}
function rayOf(camera, x, y) {
  const { right, up, forward } = axesOf(camera);
  const size = pixelSize(camera);
  const aside = sum(scaled(right, (x - camera.width / 2) * size), scaled(up, (camera.height / 2 - y) * size));
  return camera.projection === "orthographic" ? { origin: sum(camera.eye, aside), direction: forward } : { origin: camera.eye, direction: unit(sum(forward, aside)) };
}
function orbited(camera, about, right, up) {
  const vertical = unit(camera.up), axes = axesOf(camera);
  const steepest = 0.999;
  const level = dot(turned(axes.forward, axes.right, up), vertical);
  const raised = Math.abs(level) < steepest ? up : 0;
  const turn = (v) => turned(turned(v, axes.right, raised), vertical, right);
  return {
    ...camera,
    eye: sum(about, turn(difference(camera.eye, about))),
    target: sum(about, turn(difference(camera.target, about)))
  };
}
function panned(camera, x, y) {
  const { right, up } = axesOf(camera);
  const far = camera.projection === "orthographic" ? 1 : length(difference(camera.target, camera.eye));
  const step = sum(scaled(right, -x * pixelSize(camera) * far), scaled(up, y * pixelSize(camera) * far));
  return { ...camera, eye: sum(camera.eye, step), target: sum(camera.target, step) };
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

// source/deep_buffer.ts
var header = 32;
var sampleBytes = 32;
var bounceBytes = 36;
var magic = "KEIKOD1\n";
function sizeOf(view) {
  return header + view.getUint32(24, true) * sampleBytes + view.getUint32(28, true) * bounceBytes;
}
function passOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const samples = view.getUint32(24, true);
  const end = header + samples * sampleBytes;
  return {
    width: view.getUint32(8, true),
    height: view.getUint32(12, true),
    first: view.getUint32(16, true),
    step: view.getUint32(20, true),
    samples: new Float32Array(bytes.buffer, bytes.byteOffset + header, samples * 8),
    bounces: new DataView(bytes.buffer, bytes.byteOffset + end, bytes.byteLength - end)
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
    const bytes = new Uint8Array(sizeOf(new DataView(head.buffer)));
    bytes.set(head);
    await reader.fill(bytes.subarray(header));
    use(passOf(bytes));
  }
}

// source/panel.ts
function element(tag, content = "", properties = {}) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...typeof content === "string" ? [content] : content);
  return made;
}
var byId = (id) => document.getElementById(id);
function button(name, act) {
  return element("button", name, { onclick: act, type: "button" });
}
function download(name, bytes) {
  const href = URL.createObjectURL(bytes);
  element("a", "", { href, download: name }).click();
  URL.revokeObjectURL(href);
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
function showPairs(list2, pairs) {
  list2.replaceChildren(...pairs.flatMap(([name, value]) => [element("dt", name), element("dd", value)]));
}
function showFacts(facts2) {
  const { lower, upper } = facts2.bounds;
  const size = upper.map((x, i) => (x - lower[i]).toFixed(0)).join(" × ");
  showPairs(byId("facts"), [
    ["file", facts2.inputs.join(", ")],
    ["view", facts2.view],
    ["faces", String(facts2.faces.length)],
    ["size", `${size} mm`],
    ["materials", facts2.materials.map((m) => m.name).join(", ")],
    ["Keiko", facts2.tool.version],
    ...facts2.remarks.map(({ entity, message }) => ["note", `${entity} ${message}`])
  ]);
}
function showRows(planes, selected, select, change) {
  const number = (row2, key, least) => {
    const input = element("input", "", {
      type: "number",
      min: least,
      value: String(Number(planes[row2][key].toFixed(2))),
      ariaLabel: key
    });
    input.onchange = () => {
      const value = Number(input.value);
      if (value >= least) change(row2, { ...planes[row2], [key]: key === "lamps" ? Math.round(value) : value });
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
function showSeams(seams, fly) {
  const order = ["fail", "undecided", "pass"];
  const sorted = [...seams].sort((a, b) => order.indexOf(a.verdict) - order.indexOf(b.verdict) || a.number - b.number);
  const lines2 = sorted.map((seam) => element("tr", [
    element("td", seam.verdict, { className: seam.verdict }),
    element("td", seam.kind),
    element("td", [button(seam.faces, () => fly(seam))])
  ]));
  byId("seams").replaceChildren(seams.length > 0 ? element("table", lines2) : element("p", "no seams"));
}

// source/shader.ts
var mostPlanes = 16;
var bouncesARow = 1024;
var facesARow = 1024;
var vertexShader = `#version 300 es
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
  gl_Position = vec4(corner, 0, 1);
}`;
var declarations = `precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
struct Plane {
  vec3 origin, u, v, normal, luminance;
  float length, first, pitch, diameter;
  int lamps;
  bool round;
};
uniform Plane planes[PLANES + 1];
uniform vec3 eye, right, up, forward;
uniform bool is_parallel;
uniform float pixel_size;
uniform ivec2 size;
uniform int row_step, stride;
uniform float white, full_curvature, min_weight;
uniform vec3 background, ambient;
uniform sampler2D samples, bounces, materials;
uniform usampler2D first_bounce, material_of_face;
uniform int ground_material;
out vec4 color;

/// A ray and its change by a pixel to the right and down.
struct Ray { vec3 origin, direction, origin_dx, origin_dy, direction_dx, direction_dy; };
/// The first surface on a ray.
struct Surface { float t; vec3 normal, x, y; vec3 shape; float way, face; };
`;
var surfaces = `
Surface surface_of(vec4 a, vec4 b) {
  Surface s;
  s.t = a.x, s.shape = vec3(a.w, b.xy), s.way = b.z, s.face = b.w;
  vec2 p = a.yz, q = abs(p);
  bool is_lower = q.x + q.y > 1.0;
  vec2 place = is_lower ? (1.0 - q.yx) * vec2(p.x < 0.0 ? -1 : 1, p.y < 0.0 ? -1 : 1) : p;
  vec3 n = normalize(vec3(place, 1.0 - q.x - q.y));
  float side = is_lower ? -1.0 : 1.0, c = -1.0 / (side + n.z), d = n.x * n.y * c;
  s.normal = n;
  s.x = vec3(1.0 + side * n.x * n.x * c, side * d, -side * n.x);
  s.y = vec3(d, side + n.y * n.y * c, -n.y);
  return s;
}

int material_number(float face) {
  int index = int(face) - 1;
  return face < 0.0 ? ground_material
    : int(texelFetch(material_of_face, ivec2(index % ${facesARow}, index / ${facesARow}), 0).r);
}

Ray camera_ray(vec2 pixel) {
  vec2 at = (pixel - 0.5 * vec2(size)) * pixel_size;
  vec3 aside = right * at.x - up * at.y, dx = right * pixel_size, dy = -up * pixel_size;
  if (is_parallel) return Ray(eye + aside, forward, dx, dy, vec3(0), vec3(0));
  vec3 through = forward + aside;
  float per_length = inversesqrt(dot(through, through));
  vec3 d = through * per_length;
  return Ray(eye, d, vec3(0), vec3(0), (dx - d * dot(d, dx)) * per_length, (dy - d * dot(d, dy)) * per_length);
}

vec3 turn_of(Surface s, vec3 step) {
  float a = dot(step, s.x), b = dot(step, s.y);
  return -(s.x * (s.shape.x * a + s.shape.y * b) + s.y * (s.shape.y * a + s.shape.z * b));
}

Ray reflected(Ray ray, Surface s) {
  Ray r;
  vec3 d = ray.direction, n = s.normal;
  float along = dot(d, n);
  r.origin = ray.origin + d * s.t;
  r.direction = d - n * (2.0 * along);
  vec3 moved_x = ray.origin_dx + ray.direction_dx * s.t, moved_y = ray.origin_dy + ray.direction_dy * s.t;
  r.origin_dx = moved_x - d * (dot(moved_x, n) / along);
  r.origin_dy = moved_y - d * (dot(moved_y, n) / along);
  vec3 turn_x = turn_of(s, r.origin_dx), turn_y = turn_of(s, r.origin_dy);
  r.direction_dx = ray.direction_dx - 2.0 * (turn_x * along + n * (dot(ray.direction_dx, n) + dot(d, turn_x)));
  r.direction_dy = ray.direction_dy - 2.0 * (turn_y * along + n * (dot(ray.direction_dy, n) + dot(d, turn_y)));
  return r;
}
`;
var lamps = `
/// A pixel's image along one axis: the convolution of two boxes, a trapezoid of unit area.
struct Filter { float wide, narrow, reach, per_wide, per_both; };

Filter filter_of(float by_x, float by_y) {
  const float least = 1e-6; // mm: nearly a point
  float wide = max(max(abs(by_x), abs(by_y)), least), narrow = max(min(abs(by_x), abs(by_y)), least);
  return Filter(wide, narrow, 0.5 * (wide + narrow), 1.0 / wide, 0.5 / (wide * narrow));
}
/// Integral from the centre to x.
float below(Filter f, float x) {
  float away = abs(x), rest = f.reach - away;
  float inside = away <= f.reach - f.narrow ? away * f.per_wide : 0.5 - rest * rest * f.per_both;
  return sign(x) * (away >= f.reach ? 0.5 : inside);
}
float share(Filter f, float begin, float end) {
  return max(below(f, end) - below(f, begin), 0.0);
}

/// Share of a pixel's image around v that falls on the row's strips of a width.
float strips(Plane p, float width, float v, Filter f) {
  float last = p.first + float(p.lamps - 1) * p.pitch, half_width = 0.5 * width, away = v - p.first, sum = 0.0;
  bool is_resolved = f.wide <= 4.0 * p.pitch, is_apart = is_resolved && width < p.pitch;
  // Stripes that are too fine are a grey band; tubes that overlap are one strip.
  float beyond = is_resolved ? half_width : 0.5 * max(p.pitch, width);
  float band = share(f, p.first - beyond - v, last + beyond - v) * (is_resolved ? 1.0 : min(width / p.pitch, 1.0));
  float reach = f.reach + half_width, begin = max(ceil((away - reach) / p.pitch), 0.0);
  float end = is_apart ? min(floor((away + reach) / p.pitch), float(p.lamps - 1)) : -1.0;
  for (float lamp = begin; lamp <= end; lamp += 1.0) {
    float at = lamp * p.pitch - away;
    sum += share(f, at - half_width, at + half_width);
  }
  return is_apart ? sum : band;
}

/// t where a ray meets a plane; 0 or less if it does not.
float meeting(Plane p, Ray ray) {
  float down = dot(p.normal, ray.direction);
  return abs(down) > 1e-9 ? -dot(p.normal, ray.origin - p.origin) / down : -1.0;
}

float coverage(Plane p, Ray ray, float t, bool is_point) {
  vec3 at = ray.origin - p.origin + ray.direction * t;
  vec3 d = vec3(dot(p.u, ray.direction), dot(p.v, ray.direction), dot(p.normal, ray.direction));
  float u = dot(p.u, at), v = dot(p.v, at);
  float width = p.diameter * (p.round ? length(d.yz) / abs(d.z) : 1.0);
  vec3 dx = ray.origin_dx + ray.direction_dx * t, dy = ray.origin_dy + ray.direction_dy * t;
  vec2 slope = d.xy / d.z;
  vec2 x = vec2(dot(p.u, dx), dot(p.v, dx)) - slope * dot(p.normal, dx);
  vec2 y = vec2(dot(p.u, dy), dot(p.v, dy)) - slope * dot(p.normal, dy);
  if (is_point) x = y = vec2(0);
  // At the ends of lamps the filter is taken for a product of both directions.
  float along = share(filter_of(x.x, y.x), -u, p.length - u);
  return along * strips(p, width, v, filter_of(x.y, y.y));
}
`;
var bends = `
/// A pixel's reflected rays, origin and direction, as a cubic in the place in the picture.
struct Cubic { mat2x3 value, x, y, xx, xy, yy, xxx, xxy, xyy, yyy; };

mat2x3 by_x(Ray r) { return mat2x3(r.origin_dx, r.direction_dx); }
mat2x3 by_y(Ray r) { return mat2x3(r.origin_dy, r.direction_dy); }

Cubic cubic_of(Ray own, Ray before, Ray after, Ray above, Ray beneath) {
  Cubic q;
  q.value = mat2x3(own.origin, own.direction), q.x = by_x(own), q.y = by_y(own);
  q.xx = 0.5 * (by_x(after) - by_x(before)), q.yy = 0.5 * (by_y(beneath) - by_y(above));
  q.xy = 0.25 * (by_x(beneath) - by_x(above) + by_y(after) - by_y(before));
  q.xxx = by_x(after) - 2.0 * q.x + by_x(before), q.xxy = by_y(after) - 2.0 * q.y + by_y(before);
  q.xyy = by_x(beneath) - 2.0 * q.x + by_x(above), q.yyy = by_y(beneath) - 2.0 * q.y + by_y(above);
  return q;
}

/// The ray of a part of the pixel, of a share of its sides.
Ray part_of(Cubic q, vec2 at, float share_of_side) {
  float x = at.x, y = at.y, xx = 0.5 * x * x, xy = x * y, yy = 0.5 * y * y;
  mat2x3 r = q.value + q.x * x + q.y * y + q.xx * xx + q.xy * xy + q.yy * yy + q.xxx * (xx * x / 3.0) +
    q.xxy * (xx * y) + q.xyy * (x * yy) + q.yyy * (yy * y / 3.0);
  mat2x3 dx = (q.x + q.xx * x + q.xy * y + q.xxx * xx + q.xxy * xy + q.xyy * yy) * share_of_side;
  mat2x3 dy = (q.y + q.xy * x + q.yy * y + q.xxy * xx + q.xyy * xy + q.yyy * yy) * share_of_side;
  return Ray(r[0], r[1], dx[0], dy[0], dx[1], dy[1]);
}

/// Deviation of the pixel's corners on a plane from a linear image, across the lamps, in pitches.
float bend_of(Plane p, Cubic q, Ray ray, float t) {
  vec3 dx = ray.origin_dx + ray.direction_dx * t, dy = ray.origin_dy + ray.direction_dy * t;
  float slope = dot(p.v, ray.direction) / dot(p.normal, ray.direction), bend = 0.0;
  float v = dot(p.v, ray.origin - p.origin + ray.direction * t);
  vec2 by = vec2(dot(p.v, dx) - slope * dot(p.normal, dx), dot(p.v, dy) - slope * dot(p.normal, dy));
  for (int i = 0; i < 4; ++i) {
    vec2 corner = vec2(i % 2, i / 2) - 0.5;
    Ray r = part_of(q, corner, 1.0);
    float own = meeting(p, r);
    if (own <= 0.0) return 0.0;
    bend = max(bend, abs(dot(p.v, r.origin - p.origin + r.direction * own) - v - dot(by, corner)));
  }
  return bend / p.pitch;
}

`;
var pixels = `
Surface surface_at(ivec2 pixel) {
  return surface_of(texelFetch(samples, ivec2(2 * pixel.x, pixel.y), 0),
                    texelFetch(samples, ivec2(2 * pixel.x + 1, pixel.y), 0));
}

/// The reflected ray of a neighbour; false if it shows another surface than s, which is at a place.
bool neighbours(ivec2 pixel, Surface s, vec3 place, out Ray mirrored) {
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size))) return false;
  Surface o = surface_at(pixel);
  if (isinf(o.t) || isnan(o.shape.x) || material_number(o.face) != material_number(s.face)) return false;
  Ray ray = camera_ray(vec2(pixel) + 0.5);
  mirrored = reflected(ray, o);
  vec3 step = mirrored.origin - place, turn = cross(s.normal, o.normal);
  float along = dot(s.normal, o.normal), off = min(abs(dot(step, s.normal)), abs(dot(step, o.normal)));
  return dot(turn, turn) <= 0.031091 * along * along && off * off <= 0.04 * dot(step, step);
}

/// Light of all rows in a pixel: of one whose image is bent, the mean over its parts.
vec4 first_rows(ivec2 pixel, Surface s, Ray ray, bool is_point) {
  Ray before, after, above, beneath;
  bool is_amid = row_step == 1 && !is_point && neighbours(pixel - ivec2(1, 0), s, ray.origin, before) &&
    neighbours(pixel + ivec2(1, 0), s, ray.origin, after) && neighbours(pixel - ivec2(0, 1), s, ray.origin, above) &&
    neighbours(pixel + ivec2(0, 1), s, ray.origin, beneath);
  float straight = 0.01, parts = 1.0;
  Cubic q = cubic_of(ray, before, after, above, beneath);
  for (int todo = is_amid ? 1 : 0; todo > 0; --todo)
    parts = clamp(ceil(sqrt(nearest_bend(q, ray) / straight)), 1.0, 8.0);
  vec4 sum = vec4(0);
  for (float y = 0.5; y < parts; y += 1.0)
    for (float x = 0.5; x < parts; x += 1.0) {
      Ray part = ray;
      if (parts > 1.0) part = part_of(q, vec2(x, y) / parts - 0.5, 1.0 / parts);
      sum += rows(part, s.way, is_point);
    }
  return sum / (parts * parts);
}
`;
var looks = `
float fresnel_dielectric(float c, float n) {
  float g2 = n * n - 1.0 + c * c;
  if (g2 <= 0.0) return 1.0;
  float g = sqrt(g2), a = (g - c) / (g + c), b = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
  return 0.5 * a * a * (1.0 + b * b);
}
float fresnel_conductor(float c, float n, float k) {
  float c2 = c * c, s2 = 1.0 - c2, m = n * n - k * k - s2, a2b2 = sqrt(m * m + 4.0 * n * n * k * k);
  float a = sqrt(max(0.5 * (a2b2 + m), 0.0)), across = a2b2 + c2, along = 2.0 * a * c;
  float s = (across - along) / (across + along);
  float up_ = c2 * a2b2 + s2 * s2, side = along * s2;
  return 0.5 * s * (1.0 + (up_ - side) / (up_ + side));
}
vec3 mirrored(float face, float c) {
  int number = material_number(face);
  vec4 n = texelFetch(materials, ivec2(0, number), 0);
  vec3 k = texelFetch(materials, ivec2(1, number), 0).rgb;
  if (n.a == 0.0) return vec3(0);
  if (n.a == 1.0) return vec3(fresnel_dielectric(c, n.r));
  return vec3(fresnel_conductor(c, n.r, k.r), fresnel_conductor(c, n.g, k.g), fresnel_conductor(c, n.b, k.b));
}

/// Luminance of the reflections along a pixel's path, cd/m2.
vec3 reflections_of(ivec2 pixel, Ray ray, Surface s) {
  uint chain = texelFetch(first_bounce, pixel, 0).r;
  int next = int(chain & 0xfffffffu), left = int(chain >> 28);
  vec3 weight = mirrored(s.face, abs(dot(ray.direction, s.normal)));
  bool is_point = isnan(s.shape.x);
  ray = reflected(ray, s);
#ifdef HURRIED
  vec4 seen = rows(ray, s.way, is_point);
#else
  vec4 seen = first_rows(pixel, s, ray, is_point);
#endif
  vec3 sum = weight * seen.rgb;
  weight *= 1.0 - seen.a;
  for (; left > 0; --left, ++next) {
    ivec2 at = ivec2(2 * (next % ${bouncesARow}), next / ${bouncesARow});
    s = surface_of(texelFetch(bounces, at, 0), texelFetch(bounces, at + ivec2(1, 0), 0));
    weight *= mirrored(s.face, abs(dot(ray.direction, s.normal)));
    ray = reflected(ray, s);
    seen = rows(ray, s.way, isnan(s.shape.x));
    sum += weight * seen.rgb;
    weight *= 1.0 - seen.a;
    if (max(weight.r, max(weight.g, weight.b)) < min_weight) break;
  }
  return sum + (isinf(s.way) ? weight * ambient : vec3(0));
}

float light_up_to(float phase) {
  float whole = floor(0.5 * phase);
  return whole + clamp(phase - 2.0 * whole - 1.0, 0.0, 1.0);
}
float zebra(Ray ray, Surface s) {
  Ray r = reflected(ray, s);
  vec3 d = r.direction;
  float level = max(length(d.xy), 1e-6), bands = 2.0 * degrees(1.0) / 10.0, phase = bands * atan(level, d.z);
  // The slope of atan(level, z) with the direction.
  vec3 slope = vec3(d.xy * (d.z / level), -level) / dot(d, d) * bands;
  float reach = max(0.5 * (abs(dot(slope, r.direction_dx)) + abs(dot(slope, r.direction_dy))), 1e-5);
  return 0.06 + 0.88 * (light_up_to(phase + reach) - light_up_to(phase - reach)) / (2.0 * reach);
}

vec3 signed_color(float s) {
  vec3 stops[5] = vec3[5](vec3(0.02, 0.12, 0.55), vec3(0.25, 0.55, 0.9), vec3(0.87), vec3(0.95, 0.5, 0.25),
                          vec3(0.6, 0.02, 0.05));
  float at = 2.0 * (clamp(s, -1.0, 1.0) + 1.0);
  int first = min(3, int(at));
  return mix(stops[first], stops[first + 1], at - float(first));
}

vec3 srgb(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

#if LOOK == 0
vec4 pixel_color(ivec2 pixel, Surface s) {
  vec3 light = reflections_of(pixel, camera_ray(vec2(pixel) + 0.5), s);
  return vec4(white > 0.0 ? srgb(light / white) : light, 1);
}
#else
vec4 pixel_color(ivec2 pixel, Surface s) {
  Ray ray = camera_ray(vec2(pixel) + 0.5);
  float shade = 0.55 - 0.45 * dot(ray.direction, s.normal), mean = 0.5 * (s.shape.x + s.shape.z);
#if LOOK == 1
  vec3 own = vec3(zebra(ray, s));
#else
  vec3 own = isnan(mean) ? vec3(0.07) : signed_color(mean / full_curvature);
#endif
  return vec4(own * shade, 1);
}
#endif

void main() {
  // With a stride, every stride-th pixel of the picture.
  ivec2 pixel = ivec2(gl_FragCoord.xy) * stride;
  pixel.y = size.y - 1 - pixel.y;
  // Rows that are not there yet are shown by the nearest above.
  pixel.y = pixel.y / row_step * row_step;
  Surface s = surface_at(pixel);
#if LOOK == 0
  color = white > 0.0 ? vec4(srgb(background / white), 1) : vec4(background, 0);
#else
  color = vec4(vec3(0.07), 1);
#endif
  for (int todo = isinf(s.t) ? 0 : 1; todo > 0; --todo) color = pixel_color(pixel, s);
}`;
var numbersTo = (count) => Array.from({ length: count }, (_, i) => i);
function rowsFunction(count) {
  const all = numbersTo(count);
  const covered = all.map((i) => `
  float t${i} = meeting(planes[${i}], ray), c${i} = 0.0;
  for (int todo = t${i} > 0.0 && t${i} <= t_max ? 1 : 0; todo > 0; --todo) c${i} = coverage(planes[${i}], ray, t${i}, is_point);`);
  const before = (i) => all.filter((j) => j !== i).map((j) => ` * (t${j} ${j < i ? "<=" : "<"} t${i} ? 1.0 - c${j} : 1.0)`).join("");
  const seen = all.map((i) => `
  seen += vec4(planes[${i}].luminance, 1) * (c${i}${before(i)});`);
  return `
/// Light of all rows along a ray up to t_max, and their opacity.
vec4 rows(Ray ray, float t_max, bool is_point) {
  vec4 seen = vec4(0);${covered.join("")}${seen.join("")}
  return seen;
}
`;
}
function bendFunction(count) {
  const bent = numbersTo(count).map((i) => `
  t = meeting(planes[${i}], ray);
  for (int todo = t > 0.0 && t < nearest ? 1 : 0; todo > 0; --todo) nearest = t, bend = bend_of(planes[${i}], q, ray, t);`);
  return `
/// Bend of the image on the nearest plane that the ray meets.
float nearest_bend(Cubic q, Ray ray) {
  float nearest = 1e30, bend = 0.0, t = 0.0;${bent.join("")}
  return bend;
}
`;
}
function fragmentShader(look, isHurried, planes) {
  const chosen = `#version 300 es
#define LOOK ${look}
#define PLANES ${planes}
${isHurried ? "#define HURRIED\n" : ""}`;
  return chosen + declarations + surfaces + lamps + rowsFunction(planes) + bends + bendFunction(planes) + pixels + looks;
}

// source/picture.ts
var looks2 = ["lamps", "zebra", "curvature"];
var textureNames = ["samples", "bounces", "materials", "first_bounce", "material_of_face"];
var Picture = class {
  constructor(canvas, facts2) {
    this.canvas = canvas;
    this.facts = facts2;
    this.programs = /* @__PURE__ */ new Map();
    this.textures = {};
    this.samples = new Float32Array(0);
    this.chains = new Uint32Array(0);
    this.bounces = new Float32Array(8 * bouncesARow);
    this.bounceCount = 0;
    this.rowStep = 1;
    this.camera = null;
    const gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
    if (!gl) throw new Error("this browser has no WebGL 2");
    this.gl = gl;
    gl.getExtension("EXT_color_buffer_float");
    textureNames.forEach((name, unit2) => {
      this.textures[name] = gl.createTexture();
      gl.activeTexture(gl.TEXTURE0 + unit2);
      gl.bindTexture(gl.TEXTURE_2D, this.textures[name]);
      for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
    });
    this.setMaterials(facts2);
    this.program = this.use("lamps", false, 0);
  }
  /** Takes the first pass of a camera's picture, or one that refines it. */
  add(pass, camera, isFirst) {
    if (isFirst) this.begin(camera);
    const { gl } = this, numbers = 8 * pass.width;
    this.bind("samples");
    for (let row2 = 0; row2 * numbers < pass.samples.length; ++row2) {
      const y = pass.first + row2 * pass.step, part = pass.samples.subarray(row2 * numbers, (row2 + 1) * numbers);
      this.samples.set(part, y * numbers);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, y, 2 * pass.width, 1, gl.RGBA, gl.FLOAT, part);
    }
    this.addBounces(pass);
    this.rowStep = pass.first === 0 ? pass.step : Math.min(this.rowStep, pass.first);
  }
  /** Draws the buffer in hand, or every stride-th pixel of it; false without one. */
  draw(display, stride = 1) {
    const { gl, camera } = this;
    if (!camera) return false;
    gl.viewport(0, 0, Math.ceil(camera.width / stride), Math.ceil(camera.height / stride));
    this.program = this.use(display.look, display.isHurried, display.planes.length);
    gl.uniform1i(this.place("stride"), stride);
    this.setCamera(camera);
    this.setDisplay(display);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    return true;
  }
  /** Draws every stride-th pixel of the buffer, each as a square: for machines that are slow. */
  drawCoarsely(display, stride) {
    const { gl, camera } = this;
    if (!camera) return;
    const width = Math.ceil(camera.width / stride), height = Math.ceil(camera.height / stride);
    this.onTexture(gl.RGBA8, width, height, () => {
      this.draw(display, stride);
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
      gl.blitFramebuffer(0, 0, width, height, 0, 0, width * stride, height * stride, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    });
  }
  /** Compiles what a display needs before it is in a hurry. */
  prepare(display) {
    this.onTexture(this.gl.RGBA8, 1, 1, () => this.draw(display, this.camera?.width ?? 1));
  }
  /** Waits until the canvas is drawn. */
  finish() {
    const { gl } = this;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }
  /** Luminance, cd/m2, that 1 % of the body's picture exceeds, by every stride-th pixel: white in a still. */
  whiteOf(display, stride) {
    const { gl, camera } = this;
    if (!camera) return 1;
    const width = Math.ceil(camera.width / stride), height = Math.ceil(camera.height / stride);
    const pixels2 = new Float32Array(4 * width * height);
    this.onTexture(gl.RGBA32F, width, height, () => {
      this.draw({ ...display, look: "lamps", white: 0 }, stride);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, pixels2);
    });
    const seen = [];
    for (let i = 0; i < pixels2.length; i += 4)
      if (pixels2[i + 3] > 0) seen.push(0.2126 * pixels2[i] + 0.7152 * pixels2[i + 1] + 0.0722 * pixels2[i + 2]);
    return quantile(seen, 0.99) || 1;
  }
  /** The round curvature, 1/mm, that 2 % of the body's picture exceed. */
  usualCurvature() {
    const sizes = [];
    for (let i = 0; i < this.samples.length; i += 8) {
      const mean = (this.samples[i + 3] + this.samples[i + 5]) / 2;
      if (this.samples[i + 7] > 0 && !Number.isNaN(mean)) sizes.push(Math.abs(mean));
    }
    const value = quantile(sizes, 0.98) || 1e-3, power = 10 ** Math.floor(Math.log10(value));
    return power * ([1, 2, 5].find((step) => value <= step * power * (1 + 1e-9)) ?? 10);
  }
  /** The surface at a pixel, if there is one. */
  pick(x, y) {
    if (!this.camera) return null;
    const at = 8 * (Math.floor(y / this.rowStep) * this.rowStep * this.camera.width + x);
    const [t, p, q, xx, xy, yy, , face] = this.samples.subarray(at, at + 8);
    if (!Number.isFinite(t)) return null;
    const isLower = Math.fround(Math.abs(p) + Math.abs(q)) > 1;
    const fold = (a, b) => (1 - Math.abs(b)) * (a < 0 ? -1 : 1);
    const normal = unit([isLower ? fold(p, q) : p, isLower ? fold(q, p) : q, 1 - Math.abs(p) - Math.abs(q)]);
    const mean = (xx + yy) / 2, spread = Math.hypot((xx - yy) / 2, xy);
    return { t, normal, radii: [1 / (mean + spread), 1 / (mean - spread)], face };
  }
  /** Lets work be done on a texture in place of the canvas. */
  onTexture(format, width, height, work) {
    const { gl } = this, target = gl.createFramebuffer(), texture = gl.createTexture();
    gl.activeTexture(gl.TEXTURE8);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    work();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(target);
    gl.deleteTexture(texture);
  }
  begin(camera) {
    const { gl } = this, { width, height } = camera;
    const isNew = this.camera?.width !== width || this.camera.height !== height;
    this.camera = camera;
    this.bounceCount = 0;
    if (isNew) {
      this.samples = new Float32Array(8 * width * height);
      this.chains = new Uint32Array(width * height);
      this.canvas.width = width, this.canvas.height = height;
      this.bind("samples");
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 2 * width, height, 0, gl.RGBA, gl.FLOAT, null);
    }
    this.samples.fill(0);
    this.chains.fill(0);
  }
  addBounces(pass) {
    const { gl } = this, count = pass.bounces.byteLength / bounceBytes;
    this.reserve(this.bounceCount + count);
    for (let i = 0; i < count; ++i) {
      const at = i * bounceBytes, pixel = pass.bounces.getUint32(at, true), number = this.bounceCount++;
      const chain = this.chains[pixel];
      this.chains[pixel] = chain === 0 ? (1 << 28 | number) >>> 0 : chain + (1 << 28);
      for (let k = 0; k < 8; ++k) this.bounces[8 * number + k] = pass.bounces.getFloat32(at + 4 + 4 * k, true);
    }
    this.bind("bounces");
    gl.texImage2D(
      gl.TEXTURE_2D,
      0,
      gl.RGBA32F,
      2 * bouncesARow,
      this.bounces.length / (8 * bouncesARow),
      0,
      gl.RGBA,
      gl.FLOAT,
      this.bounces
    );
    this.bind("first_bounce");
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32UI, pass.width, pass.height, 0, gl.RED_INTEGER, gl.UNSIGNED_INT, this.chains);
  }
  reserve(count) {
    const rows = Math.ceil(count / bouncesARow);
    if (rows * 8 * bouncesARow <= this.bounces.length) return;
    const larger = new Float32Array(rows * 8 * bouncesARow);
    larger.set(this.bounces);
    this.bounces = larger;
  }
  setMaterials(facts2) {
    const { gl } = this;
    const kind = (m) => !m.mirror ? 0 : m.metal ? 2 : 1;
    const table = new Float32Array(facts2.materials.flatMap((m) => [...m.n, kind(m), ...m.k, 0]));
    this.bind("materials");
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 2, facts2.materials.length, 0, gl.RGBA, gl.FLOAT, table);
    const rows = Math.ceil(Math.max(1, facts2.faces.length) / facesARow);
    const numbers = new Uint32Array(rows * facesARow);
    facts2.faces.forEach((face, i) => {
      numbers[i] = face.material;
    });
    this.bind("material_of_face");
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32UI, facesARow, rows, 0, gl.RED_INTEGER, gl.UNSIGNED_INT, numbers);
  }
  /** Numbers of the scene, which a program needs once. */
  setScene(facts2) {
    const { gl } = this;
    textureNames.forEach((name, unit2) => gl.uniform1i(this.place(name), unit2));
    gl.uniform1i(this.place("ground_material"), facts2.ground?.material ?? 0);
    gl.uniform1f(this.place("min_weight"), facts2.min_weight);
    gl.uniform3fv(this.place("background"), facts2.background);
    gl.uniform3fv(this.place("ambient"), scaled(facts2.rig.ambient, 1 / Math.PI));
  }
  setCamera(camera) {
    const { gl } = this, axes = axesOf(camera);
    gl.uniform3fv(this.place("eye"), camera.eye);
    for (const axis of ["right", "up", "forward"]) gl.uniform3fv(this.place(axis), axes[axis]);
    gl.uniform1i(this.place("is_parallel"), Number(camera.projection === "orthographic"));
    gl.uniform1f(this.place("pixel_size"), pixelSize(camera));
    gl.uniform2i(this.place("size"), camera.width, camera.height);
    gl.uniform1i(this.place("row_step"), this.rowStep);
  }
  setDisplay(display) {
    const { gl } = this, planes = display.planes.slice(0, mostPlanes);
    gl.uniform1f(this.place("white"), display.white);
    gl.uniform1f(this.place("full_curvature"), display.fullCurvature);
    planes.forEach((plane, i) => this.setPlane(`planes[${i}]`, plane));
  }
  setPlane(name, plane) {
    const { gl } = this, u = unit(plane.u);
    const across = difference(plane.v, scaled(u, dot(u, plane.v))), v = unit(across);
    const vectors = { origin: plane.origin, u, v, normal: cross(u, v), luminance: plane.luminance };
    for (const [field, value] of Object.entries(vectors)) gl.uniform3fv(this.place(`${name}.${field}`), value);
    const numbers = {
      length: length(plane.u),
      first: (length(across) - (plane.lamps - 1) * plane.pitch) / 2,
      pitch: plane.pitch,
      diameter: plane.diameter
    };
    for (const [field, value] of Object.entries(numbers)) gl.uniform1f(this.place(`${name}.${field}`), value);
    gl.uniform1i(this.place(`${name}.lamps`), plane.lamps);
    gl.uniform1i(this.place(`${name}.round`), Number(plane.mirror !== "flat"));
  }
  bind(texture) {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0 + textureNames.indexOf(texture));
    gl.bindTexture(gl.TEXTURE_2D, this.textures[texture]);
  }
  place(uniform) {
    const { linked: linked2, places } = this.program;
    if (!places.has(uniform)) places.set(uniform, this.gl.getUniformLocation(linked2, uniform));
    return places.get(uniform);
  }
  /** The program of a look, ready to be set; only lamps know of a hurry. */
  use(look, isHurried, planes) {
    const number = looks2.indexOf(look), lamps2 = number === 0 ? Math.min(planes, mostPlanes) : 0;
    const hurries = number === 0 && isHurried, key = `${look} ${hurries} ${lamps2}`;
    const known = this.programs.get(key);
    const program = known ?? { linked: linked(this.gl, fragmentShader(number, hurries, lamps2)), places: /* @__PURE__ */ new Map() };
    this.programs.set(key, program);
    this.program = program;
    this.gl.useProgram(program.linked);
    if (!known) this.setScene(this.facts);
    return program;
  }
};
function linked(gl, fragment) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) ?? "");
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? "");
  return program;
}
function quantile(values, share) {
  const sorted = Float64Array.from(values).sort();
  return sorted[Math.round(share * (sorted.length - 1))] ?? 0;
}

// source/server.ts
function tokenOf() {
  const given = new URLSearchParams(location.hash.slice(1)).get("token");
  if (given) {
    sessionStorage.setItem("token", given);
    history.replaceState(null, "", location.pathname);
  }
  return sessionStorage.getItem("token") ?? "";
}
var headers = { "X-Keiko-Token": tokenOf(), "X-Keiko-Client": `page-${crypto.randomUUID()}` };
async function ask(method, path, body2, signal) {
  const reply = await fetch(path, { method, headers, body: method === "GET" ? void 0 : body2 ?? "", signal });
  if (reply.ok) return reply;
  const text = await reply.text();
  let reason = text;
  try {
    reason = JSON.parse(text).error;
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
  let text = "";
  for (; ; ) {
    const { value, done } = await reader.read();
    if (done) return;
    const lines2 = (text + value).split("\n");
    text = lines2.pop();
    for (const line of lines2)
      if (line.startsWith("data: ")) {
        const { stage, fraction } = JSON.parse(line.slice(6));
        tell(stage, fraction);
      }
  }
}

// source/compare.ts
var ways = ["new", "both", "difference"];
var Earlier = class {
  constructor(host, over) {
    this.host = host;
    this.over = over;
    this.canvas = element("canvas", "", { id: "earlier", hidden: true });
    this.picture = null;
    this.traced = null;
    this.drawn = "";
    this.way = "new";
    this.running = new AbortController();
    byId("still").after(this.canvas);
  }
  async show(way) {
    const wasShown = this.way !== "new";
    this.way = way;
    this.canvas.hidden = way === "new";
    this.canvas.style.mixBlendMode = way === "difference" ? "difference" : "normal";
    this.over.parentElement.classList.toggle("comparing", way !== "new");
    if (wasShown || way === "new") return;
    const facts2 = await (await ask("GET", "/against/scene")).json();
    this.picture ??= new Picture(this.canvas, facts2);
    this.follow();
  }
  /** Share of the picture, from the left, that shows the new revision. */
  split(share) {
    this.canvas.style.clipPath = `inset(0 0 0 ${(100 * share).toFixed(2)}%)`;
  }
  /** Follows eye, look and lamps as long as it is shown. */
  follow() {
    if (this.way === "new") return;
    const camera = this.host.camera(), { width, height } = this.over.style;
    Object.assign(this.canvas.style, { width, height });
    if (camera !== this.traced) void this.trace(camera);
    const display = this.host.display(), now = JSON.stringify(display);
    if (now !== this.drawn) this.draw(display);
    this.drawn = now;
    requestAnimationFrame(() => this.follow());
  }
  draw(display) {
    this.picture.draw(display);
  }
  async trace(camera) {
    this.traced = camera;
    this.running.abort();
    const own = this.running = new AbortController();
    let isFirst = true;
    try {
      const reply = await ask("POST", "/against/deep", requestText(camera), own.signal);
      await readPasses(reply, (pass) => {
        if (own.signal.aborted) return;
        this.picture.add(pass, camera, isFirst);
        isFirst = false;
        this.draw(this.host.display());
      });
      this.canvas.dataset.traced = "whole";
    } catch (error) {
      if (!own.signal.aborted) this.host.fail(error);
    }
  }
};
function comparePanel(into, host, over) {
  const section = into.parentElement;
  section.hidden = !host.facts.against;
  if (section.hidden) return;
  const earlier = new Earlier(host, over), buttons = element("p");
  const slider = element("input", "", { type: "range", min: "0", max: "1", step: "any", value: "0.5", ariaLabel: "border between the revisions" });
  const show = (way) => {
    slider.disabled = way !== "both";
    earlier.split(way === "both" ? Number(slider.value) : 0);
    earlier.show(way).catch((error) => host.fail(error));
  };
  slider.oninput = () => earlier.split(Number(slider.value));
  choice(buttons, ways, "new", (name) => show(name));
  slider.disabled = true;
  into.replaceChildren(buttons, slider);
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
var high = 90;
var top = 14;
function svg(tag, attributes, text = "") {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.textContent = text;
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
  const scale = (v) => top + (high - top) * (1 - v / largest);
  const title = `${name} up to ${quantity?.largest.toPrecision(3) ?? "?"}${unit2} on ${profile.length.toFixed(1)} mm` + (limit === null ? "" : `, limit ${limit}${unit2}`);
  const plot = svg("svg", { viewBox: `0 0 ${wide} ${high + 1}`, class: "plot", role: "img", "aria-label": title });
  plot.append(svg("text", { x: 0, y: 10 }, title));
  if (limit !== null) plot.append(svg("line", { class: "limit", x1: 0, x2: wide, y1: scale(limit), y2: scale(limit) }));
  for (const points of lines(profile, value, scale)) plot.append(svg("polyline", { points }));
  return plot;
}

// source/faults.ts
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
  const long = fault.length > 0 ? ` · ${fault.length.toFixed(1)} mm, ${(100 * fault.visible).toFixed(0)} % visible` : "";
  return fault.mending + seen + long + (fault.mirrored ? " · on both sides" : "");
}
function entry(host, fault) {
  const into = element("div");
  const go = () => {
    host.lookFrom(closeUp(host, fault));
    if (fault.profile) into.replaceChildren(profilePlot(fault.profile, fault.mending));
  };
  return element("li", [
    button(fault.faces, go),
    element("div", fault.message, { className: fault.verdict }),
    element("div", sightOf(fault), { className: "soft" }),
    into
  ]);
}
function list(host, faults, start2) {
  return element("ol", faults.map((fault) => entry(host, fault)), { start: start2 });
}
function faultsPanel(into, host) {
  const fetchAll = async () => {
    try {
      const { items, hidden } = await (await ask("GET", "/inspect")).json();
      into.replaceChildren(items.length + hidden.length > 0 ? list(host, items, 1) : element("p", "no faults"));
      if (hidden.length > 0) into.append(element("p", "In hidden places:"), list(host, hidden, items.length + 1));
    } catch (error) {
      host.fail(error);
    }
  };
  into.replaceChildren(button("inspect", () => void fetchAll()));
}

// source/section.ts
function projection(camera) {
  const { right, up, forward } = axesOf(camera), size = pixelSize(camera);
  return (place) => {
    const way = difference(place, camera.eye), deep = dot(way, forward);
    const scale = camera.projection === "orthographic" ? size : size * deep;
    if (!(scale > 0)) return null;
    return [camera.width / 2 + dot(way, right) / scale, camera.height / 2 - dot(way, up) / scale];
  };
}
var longestTooth = 0.06;
var Overlay = class {
  constructor(host, picture) {
    this.host = host;
    this.picture = picture;
    this.curves = [];
    this.drawn = null;
    this.canvas = element("canvas", "", { id: "section-lines" });
    picture.after(this.canvas);
  }
  show(curves) {
    const isFirst = this.curves.length === 0;
    this.curves = curves;
    this.drawn = null;
    if (isFirst && curves.length > 0) this.follow();
  }
  /** Draws anew whenever the eye has moved, as long as there are curves. */
  follow() {
    const camera = this.host.camera(), { width, height } = this.picture.style;
    Object.assign(this.canvas.style, { width, height });
    if (camera !== this.drawn) this.draw(camera);
    if (this.curves.length > 0) requestAnimationFrame(() => this.follow());
  }
  draw(camera) {
    this.drawn = camera;
    Object.assign(this.canvas, { width: camera.width, height: camera.height });
    const context = this.canvas.getContext("2d"), place = projection(camera);
    const { upper, lower } = this.host.facts.bounds;
    const bent = Math.max(...this.curves.map((curve) => Math.abs(curve.largest_curvature.value)), 1e-12);
    const tooth = longestTooth * length(difference(upper, lower)) / bent;
    for (const { pieces } of this.curves)
      for (const { samples } of pieces) {
        const foot = samples.map((s) => place(s.place));
        const tip = samples.map((s) => place(sum(s.place, scaled(s.towards, -s.curvature * tooth))));
        context.strokeStyle = "#3ad0ff88";
        foot.forEach((from, i) => stroke(context, [from, tip[i]]));
        stroke(context, tip);
        context.strokeStyle = "#ffd23a";
        stroke(context, foot);
      }
  }
};
function stroke(context, points) {
  context.beginPath();
  let isDown = false;
  for (const point of points) {
    if (point && isDown) context.lineTo(...point);
    else if (point) context.moveTo(...point);
    isDown = point !== null;
  }
  context.stroke();
}
function summary(curves, plane) {
  if (curves.length === 0) return `${plane} misses the body`;
  const long = curves.reduce((all, curve) => all + curve.length, 0);
  const bent = Math.max(...curves.map((curve) => Math.abs(curve.largest_curvature.value)));
  return `${plane}: ${long.toFixed(1)} mm, radii from ${(1 / bent).toPrecision(4)} mm`;
}
function sectionPanel(into, host, picture) {
  const overlay = new Overlay(host, picture), { lower, upper } = host.facts.bounds;
  const axis = element("select", ["none", "x", "y", "z"].map((name) => element("option", name)), { ariaLabel: "axis" });
  const slider = element("input", "", { type: "range", ariaLabel: "position", step: "any", disabled: true });
  const text = element("p");
  let running = new AbortController();
  const cut = async () => {
    running.abort();
    const own = running = new AbortController(), plane = `${axis.value}=${Number(slider.value).toFixed(2)}`;
    try {
      const { curves } = await (await ask("POST", "/section", plane, own.signal)).json();
      if (own.signal.aborted) return;
      overlay.show(curves);
      text.textContent = summary(curves, plane);
    } catch (error) {
      if (!own.signal.aborted) host.fail(error);
    }
  };
  axis.onchange = () => {
    const at = ["x", "y", "z"].indexOf(axis.value);
    slider.disabled = at < 0;
    running.abort();
    overlay.show([]);
    text.textContent = "";
    if (at < 0) return;
    Object.assign(slider, { min: String(lower[at]), max: String(upper[at]) });
    slider.value = String((lower[at] + upper[at]) / 2);
    void cut();
  };
  slider.oninput = () => void cut();
  into.replaceChildren(axis, slider, text);
}

// source/tree.ts
function row(name, faces, boxes, changed) {
  const box = element("input", "", { type: "checkbox", checked: true, ariaLabel: `show ${name}` });
  box.onchange = () => {
    for (const face of faces) for (const each of boxes.get(face)) each.checked = box.checked;
    changed();
  };
  const alone = button(name, () => {
    for (const [face, all] of boxes) for (const each of all) each.checked = faces.includes(face);
    changed();
  });
  alone.title = "show this alone";
  if (faces.length === 1) boxes.set(faces[0], [...boxes.get(faces[0]) ?? [], box]);
  return element("span", [box, alone]);
}
function body(facts2, part, boxes, changed) {
  const faces = facts2.face_list.filter((face) => face.part === part);
  const leaves = faces.map((face) => element("li", [row(`${face.id} ${face.name}`, [face.id], boxes, changed)]));
  const name = facts2.part_list[part].name || `body ${part + 1}`;
  return element("details", [
    element("summary", [row(`${name} (${faces.length})`, faces.map((face) => face.id), boxes, changed)]),
    element("ul", leaves)
  ], { open: facts2.part_list.length === 1 });
}
function treePanel(into, host) {
  const show = (facts2) => {
    const boxes = /* @__PURE__ */ new Map();
    const changed = () => host.hide([...boxes].filter(([, [box]]) => !box.checked).map(([face]) => face));
    const all = () => {
      for (const box of into.querySelectorAll("input")) box.checked = true;
      changed();
    };
    const parts = facts2.part_list.map((_, part) => body(facts2, part, boxes, changed));
    into.replaceChildren(button("show all", all), ...parts);
  };
  const fetchAll = async () => {
    try {
      show(await (await ask("GET", "/facts")).json());
    } catch (error) {
      host.fail(error);
    }
  };
  into.replaceChildren(button("list", () => void fetchAll()));
}

// source/main.ts
var shownViews = ["front", "rear", "left", "right", "top", "three-quarter-front", "three-quarter-rear"];
var rest = 300;
var Viewer = class {
  constructor(facts2) {
    this.facts = facts2;
    this.hidden = [];
    this.look = "lamps";
    this.row = 0;
    this.white = 0;
    this.fullCurvature = 1e-3;
    this.canvas = byId("picture");
    this.still = byId("still");
    this.deep = new AbortController();
    this.exact = new AbortController();
    this.timer = 0;
    this.frame = 0;
    this.stride = 1;
    // of the frames of a drag
    this.drag = null;
    this.camera = facts2.camera;
    this.planes = facts2.rig.planes;
    this.picture = new Picture(this.canvas, facts2);
    this.showPanel();
    this.listen();
    window.onresize = () => this.fit();
    this.fit();
    void this.trace(false);
  }
  /** Fetches the surfaces of the view, coarse rows first, or a small draft of it. */
  async trace(isDraft) {
    this.deep.abort();
    const own = this.deep = new AbortController();
    const camera = isDraft ? sized(this.camera, this.camera.width >> 1, this.camera.height >> 1) : this.camera;
    const began = performance.now();
    let isFirst = true;
    try {
      const more = `interlaced = ${!isDraft}
reflections = ${Math.min(8, Math.max(1, this.facts.reflections))}
${hiddenText(this.hidden)}`;
      const reply = await ask("POST", "/deep", requestText(camera, void 0, more), own.signal);
      await readPasses(reply, (pass) => {
        if (own.signal.aborted) return;
        this.picture.add(pass, camera, isFirst);
        if (isFirst && this.white === 0) this.measure(8);
        isFirst = false;
        this.paint();
      });
      if (!isDraft) this.measure(1);
      this.paint();
      if (!isDraft && this.look === "lamps") this.picture.prepare({ ...this.display(), isHurried: true });
      this.tell(`${isDraft ? "draft" : "surfaces"} in ${(performance.now() - began).toFixed(0)} ms`);
    } catch (error) {
      if (!own.signal.aborted) this.fail(error);
    }
  }
  /** White or the scale of curvature, by every stride-th pixel. */
  measure(stride) {
    if (this.look === "curvature") this.fullCurvature = this.picture.usualCurvature();
    if (this.look === "lamps") this.white = this.picture.whiteOf(this.display(), stride);
  }
  display() {
    return {
      look: this.look,
      planes: this.planes,
      white: this.white || 1,
      fullCurvature: this.fullCurvature,
      isHurried: this.drag !== null
    };
  }
  paint() {
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.drawFrame());
  }
  /** Draws a frame; of a drag every second or fourth pixel where frames take long. */
  drawFrame() {
    const slow = 60, fast = 12, coarsest = 4;
    const display = this.display(), began = performance.now();
    if (!display.isHurried || this.stride === 1) this.picture.draw(display);
    else this.picture.drawCoarsely(display, this.stride);
    if (!display.isHurried) return;
    this.picture.finish();
    const taken = performance.now() - began;
    if (taken > slow) this.stride = Math.min(coarsest, 2 * this.stride);
    if (taken < fast) this.stride = Math.max(1, this.stride / 2);
  }
  /** Something has moved: the exact picture is out of date, and follows at rest. */
  changed(isEye, isOver) {
    this.still.hidden = true;
    this.exact.abort();
    clearTimeout(this.timer);
    if (isEye) void this.trace(!isOver);
    else this.paint();
    if (!isOver) return;
    if (!isEye) this.measure(1);
    if (this.look === "lamps") this.timer = window.setTimeout(() => void this.fetchStill(), rest);
  }
  async fetchStill() {
    const own = this.exact = new AbortController();
    try {
      const reply = await ask("POST", "/still", requestText(this.camera, this.planes, hiddenText(this.hidden)), own.signal);
      const image = await createImageBitmap(await reply.blob());
      if (own.signal.aborted) return;
      Object.assign(this.still, { width: image.width, height: image.height, hidden: false });
      this.still.getContext("2d").drawImage(image, 0, 0);
      this.tell("exact picture");
    } catch (error) {
      if (!own.signal.aborted) this.fail(error);
    }
  }
  /** Shows picture and still as large as the window allows, in the shape of the camera's. */
  fit() {
    const room = this.canvas.parentElement, { width, height } = this.camera;
    const scale = Math.min(room.clientWidth / width, room.clientHeight / height);
    for (const shown2 of [this.canvas, this.still])
      Object.assign(shown2.style, { width: `${width * scale}px`, height: `${height * scale}px` });
  }
  listen() {
    this.canvas.onpointerdown = (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      const movesLamps = event.ctrlKey || event.metaKey;
      this.drag = { x: event.clientX, y: event.clientY, movesLamps, pans: event.shiftKey || event.button > 0, moved: false };
    };
    this.canvas.onpointermove = (event) => this.move(event);
    this.canvas.onpointerup = (event) => {
      const { drag } = this;
      this.drag = null;
      if (drag?.moved) this.changed(!drag.movesLamps, true);
      else this.pick(event);
    };
    this.canvas.oncontextmenu = (event) => event.preventDefault();
    this.canvas.onwheel = (event) => {
      event.preventDefault();
      this.camera = dollied(this.camera, Math.exp(event.deltaY / 1e3));
      this.changed(true, false);
      this.timer = window.setTimeout(() => this.changed(true, true), rest);
    };
    this.canvas.onkeydown = (event) => this.key(event);
  }
  move(event) {
    const { drag } = this;
    if (!drag) return;
    const x = event.clientX - drag.x, y = event.clientY - drag.y;
    if (!drag.moved && Math.hypot(x, y) < 3) return;
    Object.assign(drag, { x: event.clientX, y: event.clientY, moved: true });
    if (drag.movesLamps) this.moveRow(x, y);
    else if (drag.pans) this.camera = panned(this.camera, x, y);
    else this.camera = orbited(this.camera, this.camera.target, -x / 200, -y / 200);
    this.changed(!drag.movesLamps, false);
  }
  /** Moves the chosen row within its plane, as far as the pointer at the body. */
  moveRow(x, y) {
    const plane = this.planes[this.row];
    if (!plane) return;
    const { right, up } = axesOf(this.camera), far = length(difference(this.camera.target, this.camera.eye));
    const way = scaled(sum(scaled(right, x), scaled(up, -y)), far * 2 * Math.tan(this.camera.vertical_fov * Math.PI / 360) / this.camera.height);
    const u = unit(plane.u), v = unit(plane.v);
    const step = sum(scaled(u, dot(way, u)), scaled(v, dot(way, v)));
    this.planes = this.planes.map((p, i) => i === this.row ? { ...p, origin: sum(p.origin, step) } : p);
  }
  key(event) {
    const step = 10, arrows = {
      ArrowLeft: [-step, 0],
      ArrowRight: [step, 0],
      ArrowUp: [0, -step],
      ArrowDown: [0, step]
    };
    const way = arrows[event.key];
    const look = looks2["lzc".indexOf(event.key)];
    if (look) this.choose(look);
    if (!way) return;
    event.preventDefault();
    if (event.ctrlKey) this.moveRow(...way);
    else this.camera = orbited(this.camera, this.camera.target, -way[0] / 200, -way[1] / 200);
    this.changed(!event.ctrlKey, true);
  }
  pick(event) {
    const box = this.canvas.getBoundingClientRect();
    const x = Math.floor((event.clientX - box.left) / box.width * this.canvas.width);
    const y = Math.floor((event.clientY - box.top) / box.height * this.canvas.height);
    const at = this.picture.pick(x, y);
    if (!at) return showPairs(byId("pick"), [["nothing", ""]]);
    const { origin, direction } = rayOf(sized(this.camera, this.canvas.width, this.canvas.height), x + 0.5, y + 0.5);
    const face = at.face > 0 ? this.facts.faces[at.face - 1] : null;
    const numbers = (v, digits) => v.map((n) => n.toFixed(digits)).join(", ");
    showPairs(byId("pick"), [
      ["face", face ? `${face.id} ${face.name}` : "ground"],
      ["place", `${numbers(sum(origin, scaled(direction, at.t)), 2)} mm`],
      ["normal", numbers(at.normal, 4)],
      ["radii", at.radii.map((r) => Math.abs(r) < 1e6 ? `${r.toPrecision(4)} mm` : "flat").join(", ")]
    ]);
  }
  choose(look) {
    this.look = look;
    choice(byId("looks"), looks2, look, (name) => this.choose(name));
    this.changed(false, true);
  }
  setRig(rig) {
    this.planes = rig.planes;
    this.row = 0;
    this.showLamps();
    this.changed(false, true);
  }
  showLamps() {
    showRows(this.planes, this.row, (row2) => {
      this.row = row2;
    }, (row2, plane) => {
      this.planes = this.planes.map((p, i) => i === row2 ? withRoom(plane) : p);
      this.changed(false, true);
    });
  }
  showPanel() {
    choice(byId("looks"), looks2, this.look, (name) => this.choose(name));
    const views = [
      { name: "opened", camera: this.facts.camera },
      ...this.facts.own_views,
      ...this.facts.views.filter(({ name }) => shownViews.includes(name))
    ];
    byId("views").replaceChildren(
      ...views.map(({ name, camera }) => button(name, () => this.lookFrom(camera))),
      button("save view", () => download("view.toml", new Blob([viewText(this.camera)])))
    );
    this.showLamps();
    byId("lamp-buttons").replaceChildren(
      button("place for this view", () => void this.run("/place", async (reply) => this.setRig((await reply.json()).rig))),
      button("save", () => void this.save()),
      button("open", () => this.open())
    );
    faultsPanel(byId("faults"), this.host());
    comparePanel(byId("compare"), this.host(), this.canvas);
    treePanel(byId("tree"), this.host());
    sectionPanel(byId("section"), this.host(), this.canvas);
    byId("seams").replaceChildren(button("judge", () => void this.judge()));
    showFacts(this.facts);
  }
  host() {
    return {
      facts: this.facts,
      camera: () => this.camera,
      display: () => this.display(),
      lookFrom: (camera) => this.lookFrom(camera),
      fail: (error) => this.fail(error),
      hide: (faces) => {
        this.hidden = faces;
        this.changed(true, true);
      }
    };
  }
  lookFrom(camera) {
    this.camera = sized(camera, this.camera.width, this.camera.height);
    this.changed(true, true);
  }
  /** Asks for work on the view and the lamps that are shown. */
  async run(path, use) {
    try {
      await use(await ask("POST", path, requestText(this.camera, this.planes)));
      this.tell("");
    } catch (error) {
      this.fail(error);
    }
  }
  async save() {
    await this.run("/rig", async (reply) => download("rig.toml", await reply.blob()));
  }
  open() {
    const input = Object.assign(document.createElement("input"), { type: "file", accept: ".toml" });
    input.onchange = async () => {
      try {
        if (input.files?.[0]) this.setRig(await newRig(await input.files[0].text()));
      } catch (error) {
        this.fail(error);
      }
    };
    input.click();
  }
  async judge() {
    try {
      const { seams } = await (await ask("GET", "/seams")).json();
      showSeams(seams, (seam) => this.fly(seam.middle));
    } catch (error) {
      this.fail(error);
    }
  }
  fly(place) {
    const near = length(difference(this.facts.bounds.upper, this.facts.bounds.lower)) / 2;
    this.lookFrom(lookingAt(this.camera, place, near));
  }
  tell(line) {
    byId("state").textContent = line;
  }
  fail(error) {
    this.tell(error instanceof Error ? error.message : String(error));
  }
};
function withRoom(plane) {
  const needed = (plane.lamps - 1) * plane.pitch + plane.diameter, more = needed - length(plane.v);
  if (more <= 0) return plane;
  const across = unit(plane.v);
  return { ...plane, origin: sum(plane.origin, scaled(across, -more / 2)), v: scaled(across, needed) };
}
async function start() {
  try {
    new Viewer(await facts());
    await followProgress((stage, fraction) => {
      byId("state").textContent = `${stage} ${Math.round(100 * fraction)} %`;
    });
  } catch (error) {
    byId("state").textContent = error instanceof Error ? error.message : String(error);
  }
}
void start();
