// The programs of the WebGL picture.  Colours go to the screen as they are; a lamp stands beside the camera.

const camera = /* glsl */ `
precision highp float;
uniform mat4 view, projection;
`;

/** Instances of a mold: where (centre, w = 0 hides), turned, stretched, coloured. */
const instance = /* glsl */ `
${camera}
uniform float grow;      // part by which a ghost is larger than a body: equal poses must not fight for depth
uniform float smallest;  // least half extent, as a part of the distance: small bodies stay in sight
in vec3 position;
in float lift;
in vec4 center;
in vec4 turn;
in vec4 size;
in vec3 color;
vec3 rotated(vec3 v) { return v + 2.0 * cross(turn.yzw, cross(turn.yzw, v) + turn.x * v); }
vec4 placed() {
  float depth = max(-(view * vec4(center.xyz, 1.0)).z, 0.0);
  float half_extent = max(max(size.x, size.z), size.y + max(size.w, 0.0));
  float least = size.w < 0.0 ? 2.5 * smallest : smallest;  // crosses are thin
  float k = max(1.0 + grow, least * depth / max(half_extent, 1e-30));
  vec3 local = position * size.xyz + vec3(0.0, lift * size.w, 0.0);
  return center.w > 0.0 ? view * vec4(center.xyz + rotated(k * local), 1.0) : vec4(0.0, 0.0, 1e30, 1.0);
}
`;

export const solidVertex = /* glsl */ `
${instance}
in vec3 normal;
in float tone;
out vec3 shade;
out float rim;
void main() {
  vec4 p = placed();
  gl_Position = projection * p;
  vec3 n = normalize(mat3(view) * rotated(normalize(normal / max(size.xyz, vec3(1e-30)))));
  float light = 0.62 + 0.38 * dot(n, normalize(vec3(-0.35, 0.65, 0.7)));
  shade = color * tone * light;
  rim = 1.0 - abs(dot(n, normalize(p.xyz)));
}
`;

export const solidFragment = /* glsl */ `
precision highp float;
in vec3 shade;
in float rim;
out vec4 pixel;
void main() { pixel = vec4(shade, 1.0); }
`;

/** The ghost: stripes across the screen, denser towards the rim. */
export const ghostFragment = /* glsl */ `
precision highp float;
uniform vec3 ink;
uniform float ratio;
in vec3 shade;
in float rim;
out vec4 pixel;
void main() {
  float stripe = step(0.5, fract((gl_FragCoord.x - gl_FragCoord.y) / (7.0 * ratio)));
  pixel = vec4(mix(shade, ink, 0.55), 0.08 + 0.2 * stripe + 0.45 * smoothstep(0.6, 0.95, rim));
}
`;

export const edgeVertex = /* glsl */ `
${instance}
void main() { gl_Position = projection * placed(); }
`;

export const edgeFragment = /* glsl */ `
precision highp float;
uniform vec3 ink;
uniform float ratio;
out vec4 pixel;
void main() {
  if (fract((gl_FragCoord.x + gl_FragCoord.y) / (8.0 * ratio)) > 0.6) discard;
  pixel = vec4(ink, 0.9);
}
`;

/** A line as a strip that faces the screen, from a to b, widths in css pixels. */
const strip = /* glsl */ `
uniform vec2 pixels;  // of the drawing buffer
uniform float ratio, near, bias;
out vec3 shade;
flat out float broken;
out vec2 spot;  // within a dot: -1 … 1 each way
void draw(vec3 a, vec3 b, vec2 widths, vec2 corner) {
  vec4 from = view * vec4(a, 1.0), to = view * vec4(b, 1.0);
  // What lies behind the camera is cut off at the near plane.
  if (from.z > -near && to.z > -near) { gl_Position = vec4(0.0, 0.0, 2.0, 1.0); return; }
  if (from.z > -near) from = mix(to, from, (-near - to.z) / (from.z - to.z));
  if (to.z > -near) to = mix(from, to, (-near - from.z) / (to.z - from.z));
  vec4 p = projection * from, q = projection * to;
  vec2 along = (q.xy / q.w - p.xy / p.w) * pixels;
  float l = length(along);
  along = l > 1e-3 ? along / l : vec2(1.0, 0.0);
  float width = mix(widths.x, widths.y, corner.x) * ratio;
  if (corner.x < 0.5) width = max(width, 1.0);
  float cap = 0.5 * min(widths.x, widths.y) * ratio;
  vec2 shift = 0.5 * width * corner.y * vec2(-along.y, along.x) + (2.0 * corner.x - 1.0) * cap * along;
  spot = vec2(2.0 * corner.x - 1.0, corner.y);
  vec4 c = corner.x < 0.5 ? p : q;
  gl_Position = vec4(c.xy + 2.0 * shift / pixels * c.w, c.z - bias * c.w, c.w);
}
`;

export const lineVertex = /* glsl */ `
${camera}
${strip}
in vec3 position;  // which end, which side
in vec3 from, to, color;
in vec2 widths;
in float pattern;
void main() {
  shade = color;
  broken = pattern;
  draw(from, to, widths, position.xy);
}
`;

/** Trails: ends are two frames of one buffer, colours stand in a table by body. */
export const trailVertex = /* glsl */ `
${camera}
${strip}
in vec3 position;  // which end, which side
in vec3 from, to;
uniform int bodies;
uniform float dashes;
uniform sampler2D colors;
void main() {
  int body = gl_InstanceID % bodies;
  shade = texelFetch(colors, ivec2(body % 1024, body / 1024), 0).rgb;
  broken = dashes;
  draw(from, to, vec2(1.5), position.xy);
}
`;

export const lineFragment = /* glsl */ `
precision highp float;
uniform float ratio;
in vec3 shade;
flat in float broken;
in vec2 spot;
out vec4 pixel;
void main() {
  if (broken > 1.5 && dot(spot, spot) > 1.0) discard;
  float dash = fract((gl_FragCoord.x + gl_FragCoord.y) / (9.0 * ratio));
  if (broken > 0.5 && broken < 1.5 && dash > 0.55) discard;
  pixel = vec4(shade, 1.0);
}
`;

/** A sheet of water; cells of a table (step) or a wave that runs along x (volume). */
export const waterVertex = /* glsl */ `
${camera}
uniform float level, wave, speed, time;
uniform bool cells;
in vec4 place;  // x, z, and the indices i, j of the cell
out float height;
void main() {
  float y = cells ? 0.5 * wave * (sin(speed * time + place.z) + sin(0.5 * place.z * place.w))
                  : wave * sin(place.x - speed * time);
  height = wave > 0.0 ? y / wave : 0.0;
  gl_Position = projection * view * vec4(place.x, level + y, place.y, 1.0);
}
`;

export const waterFragment = /* glsl */ `
precision highp float;
uniform float alpha;
in float height;
out vec4 pixel;
void main() { pixel = vec4(0.08, 0.32 + 0.1 * height, 0.68 + 0.2 * height, alpha); }
`;
