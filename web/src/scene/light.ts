// The light of the scene, for shaders.

/// A sun at azimuth 315 and 45 degrees up, weaker ones at 250 and 20, ambient light from the sky, and some light from the
/// south-east, so that steep faces away from the sun keep their colour. `n`: the unit normal of a surface.
export const lightGlsl = /* glsl */ `
float sunOn(vec3 n) { return max(dot(n, vec3(-0.5, 0.5, 0.7071)), 0.0); }
float lightOn(vec3 n) {
  float west = max(dot(n, vec3(-0.7713, -0.2807, 0.5713)), 0.0);
  float north = max(dot(n, vec3(0.2807, 0.7713, 0.5713)), 0.0);
  float fill = max(dot(n, vec3(0.6, -0.6, 0.53)), 0.0);
  float light = 0.46 * (0.55 + 0.45 * n.z) + 0.24 * fill + 0.54 * (0.66 * sunOn(n) / 0.7071 + 0.18 * west / 0.5713 + 0.16 * north / 0.5713);
  return light < 1.0 ? light : 1.0 + 0.55 * (light - 1.0);
}
vec3 tintOn(vec3 n) { return mix(vec3(0.90, 0.96, 1.08), vec3(1.02, 1.0, 0.97), clamp(1.4 * sunOn(n), 0.0, 1.0)); }`;
