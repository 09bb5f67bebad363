import { Vector3, type Mesh } from 'three';
import { expect, test } from 'vitest';
import { walls } from './marks';

const wall = (posts: number, y: number) => ({
  foot: Array.from({ length: posts }, (_, k) => new Vector3(k, y, 0)),
  top: Array.from({ length: posts }, (_, k) => new Vector3(k, y, 3)),
});

test('any number of walls of any length makes three objects', () => {
  const one = walls([wall(1801, 0)], '#2274a5');
  expect(one.children).toHaveLength(3);
  const several = walls([wall(1801, 0), wall(2, 5), wall(30, 9)], '#2274a5');
  expect(several.children).toHaveLength(3);
  // Two triangles between two posts, and none between walls.
  const faces = several.children[0] as Mesh;
  expect(faces.geometry.index!.count).toBe(6 * (1800 + 1 + 29));
  const [positions, index] = [faces.geometry.getAttribute('position'), faces.geometry.index!];
  for (let k = 0; k < index.count; k += 3) {
    const ys = [0, 1, 2].map((c) => positions.getY(index.getX(k + c)));
    expect(new Set(ys).size).toBe(1);
  }
  // Along the top; along the foot, with a post at each point.
  const segments = several.children.slice(1).map((child) => (child as Mesh).geometry.getAttribute('instanceStart').count);
  expect(segments).toEqual([1830, 1830 + 1833]);
});

test('a wall without length is not drawn', () => expect(walls([wall(1, 0)], '#2274a5').children).toHaveLength(0));
