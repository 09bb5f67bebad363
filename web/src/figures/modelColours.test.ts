import { expect, test } from 'vitest';
import { modelColours } from './sideView';

type Triple = readonly [number, number, number];
type Matrix = readonly [Triple, Triple, Triple];

/// Without one kind of cone (Machado, Oliveira, Fernandes 2009, severity 1), of linear sRGB.
const visions: Record<string, Matrix> = {
  'all cones': [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
const times = (matrix: Matrix, [r, g, b]: Triple) => matrix.map(([x, y, z]) => x * r + y * g + z * b) as unknown as Triple;

/// CIELAB of a colour as it is seen.
function seen(colour: string, vision: Matrix): Triple {
  const linear = [1, 3, 5].map((k) => {
    const c = parseInt(colour.slice(k, k + 2), 16) / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  }) as unknown as Triple;
  const cut = times(vision, linear).map((part) => Math.min(1, Math.max(0, part))) as unknown as Triple;
  const xyz = times([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]], cut);
  const [x, y, z] = xyz.map((part, k) => {
    const share = part / [0.9505, 1, 1.089][k]!;
    return share > 216 / 24389 ? Math.cbrt(share) : ((24389 / 27) * share + 16) / 116;
  }) as unknown as Triple;
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

test('the colours of rock models are told apart with any colour vision', () => {
  const colours = Object.values(modelColours);
  for (const [name, vision] of Object.entries(visions)) {
    for (const one of colours) {
      for (const other of colours) {
        if (one === other) continue;
        const [a, b] = [seen(one, vision), seen(other, vision)];
        expect(Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), `${one} and ${other}, ${name}`).toBeGreaterThan(15);
      }
    }
  }
});
