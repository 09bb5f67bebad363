// The colours of the views. Scales are perceptually uniform and do not rely on the difference of red and green.

export type Colour = [number, number, number];
/// Colours at positions from 0 to 1.
export type Ramp = [number, Colour][];

const hex = (text: string): Colour => [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16)) as Colour;
const even = (...colours: string[]): Ramp => colours.map((colour, k) => [k / (colours.length - 1), hex(colour)]);

/// For trajectories: matplotlib's plasma (CC0), without the end that has no contrast with the ground.
export const pathRamp = {
  light: even('#0d0887', '#4c02a1', '#7e03a8', '#a92395', '#cc4778', '#e56b5d', '#f89540'),
  dark: even('#7e03a8', '#a92395', '#cc4778', '#e56b5d', '#f89540', '#fdc527', '#f0f921'),
};

/// For elevations; muted, so that marks stand out.
export const elevationRamp = {
  light: even('#a9b79c', '#c4c9a4', '#ddd6b4', '#d9c6a3', '#cbb59b', '#d8cfc6', '#f1eeea'),
  dark: even('#4d5f55', '#616f57', '#7d7c5d', '#8c7c62', '#8a786a', '#9a9088', '#c2bdb8'),
};
/// For slopes from 0 to 70 degrees.
export const slopeRamp = {
  light: even('#f3f1e7', '#f4e0a6', '#f2b56b', '#e07b52', '#b2455a', '#6d2a63', '#351a4a'),
  dark: even('#5c605c', '#8f845c', '#b98850', '#c3684a', '#a04360', '#733a75', '#4a3480'),
};
export const groundColour: { light: Colour; dark: Colour } = { light: hex('#d3d4d3'), dark: hex('#838484') };

/// For the share of rocks from a release place that reach a line: blues, which no other scale of the views has.
export const shareRamp = {
  light: even('#eef5fb', '#c6dbef', '#8fc1e3', '#4a98c9', '#1d6cb1', '#08408a', '#04204d'),
  dark: even('#173247', '#1d5578', '#2b7bab', '#45a1d3', '#7cc4ec', '#b5e0f8', '#eef9ff'),
};

const materials = ['#c2a878', '#8fa8a0', '#b58a6c', '#9cb06a', '#8d93b3', '#c08a94', '#d2b95e', '#7fa9c4', '#a58fb0', '#a3a39a', '#6f9678', '#cf9d6a'];
/// The colour of a material by its index, the same everywhere.
export const materialColour = (k: number): string => materials[k % materials.length]!;

// After M. Okabe and K. Ito, "Color Universal Design" (2008), without yellow, which has no contrast on a light background.
const categories = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#7a4fa3', '#8c6d31', '#5b5f66', '#b0413e'];
/// For categories: end reasons, sources, seeders.
export const categoryColour = (k: number): string => categories[k % categories.length]!;

export const markColours = { barrier: '#d1495b', collector: '#2274a5', seeder: '#e07a00', tool: '#c2185b', stops: '#b0127b', marks: '#5b3bb0', asked: '#0b5fff', worst: '#d00000' };

export function colourAt(ramp: Ramp, place: number): Colour {
  const after = ramp.findIndex(([at]) => at >= place);
  if (after === 0 || Number.isNaN(place)) return ramp[0]![1];
  if (after < 0) return ramp.at(-1)![1];
  const [[a, from], [b, to]] = [ramp[after - 1]!, ramp[after]!];
  const share = (place - a) / (b - a);
  return from.map((value, k) => Math.round(value + share * (to[k]! - value))) as Colour;
}

export const cssOf = ([r, g, b]: Colour) => `rgb(${r}, ${g}, ${b})`;
export const colourOf = hex;
export const cssGradient = (ramp: Ramp) =>
  `linear-gradient(to right, ${ramp.map(([at, colour]) => `${cssOf(colour)} ${(100 * at).toFixed(1)}%`).join(', ')})`;

/// Whether white has more contrast with it than black.
export const isDark = ([r, g, b]: Colour) => 0.2126 * r + 0.7152 * g + 0.0722 * b < 110;
/// The colour of a rock at rest, if colours show speed, energy or height.
export const restColour = '#efe9dc';

/// 256 texels of a scale, RGBA.
export function rampBytes(ramp: Ramp): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(4 * 256);
  for (let k = 0; k < 256; ++k) bytes.set([...colourAt(ramp, k / 255), 255], 4 * k);
  return bytes;
}
/// One texel per colour, RGBA.
export function listBytes(colours: string[]): Uint8Array<ArrayBuffer> {
  return new Uint8Array(colours.flatMap((colour) => [...hex(colour), 255]));
}
