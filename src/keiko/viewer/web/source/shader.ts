// The light of a pixel by its deep samples. The formulas are those of the renderer, by file:
// reflected rays and their differentials in intersect/hit/reflect_ray, footprint, apparent width and
// coverage of lamps in light/tubes, layers of rows in light/rig/rig_planes, bent pixels in
// render/reflection.
//
// Renderers without a graphics card compute both sides of a branch and skip loops alone. So each look is
// a program of its own, and what few pixels need is in loops that the others leave at once.
export const mostPlanes = 16;
export const bouncesARow = 1024;
export const facesARow = 1024;

export const vertexShader = `#version 300 es
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
  gl_Position = vec4(corner, 0, 1);
}`;

const declarations = `precision highp float;
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

const surfaces = `
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

const lamps = `
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

const bends = `
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

const pixels = `
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

const looks = `
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

// What asks each plane is written out for their number: dynamic indices cost as much as all the rest.
const numbersTo = (count: number): number[] => Array.from({ length: count }, (_, i) => i);

/** GLSL that adds up the light of a number of rows. */
function rowsFunction(count: number): string {
  const all = numbersTo(count);
  const covered = all.map((i) => `
  float t${i} = meeting(planes[${i}], ray), c${i} = 0.0;
  for (int todo = t${i} > 0.0 && t${i} <= t_max ? 1 : 0; todo > 0; --todo) c${i} = coverage(planes[${i}], ray, t${i}, is_point);`);
  // A row dims those behind it; of rows at one distance the first is in front.
  const before = (i: number): string => all.filter((j) => j !== i)
    .map((j) => ` * (t${j} ${j < i ? "<=" : "<"} t${i} ? 1.0 - c${j} : 1.0)`).join("");
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

/** GLSL for the bend of a pixel's image on the nearest of a number of planes. */
function bendFunction(count: number): string {
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

/** The program of a look, by its number; in a hurry pixels whose image is bent are not divided. */
export function fragmentShader(look: number, isHurried: boolean, planes: number): string {
  const chosen = `#version 300 es\n#define LOOK ${look}\n#define PLANES ${planes}\n${isHurried ? "#define HURRIED\n" : ""}`;
  return chosen + declarations + surfaces + lamps + rowsFunction(planes) + bends + bendFunction(planes) + pixels + looks;
}
