import { BufferAttribute, BufferGeometry, DataTexture, Group, Mesh, MeshBasicMaterial, ShaderMaterial, Texture } from 'three';
import { expect, test } from 'vitest';
import { memoryOf } from './memory';

const geometryOf = (position: BufferAttribute) => new BufferGeometry().setAttribute('position', position).setIndex([0, 1, 2]); // 16-bit
function part(name: string, ...children: Mesh[]) {
  const made = Object.assign(new Group(), { name });
  for (const child of children) made.add(child);
  return made;
}

test('geometry and pictures are counted once, by part', () => {
  const shared = new BufferAttribute(new Float32Array(30), 3); // 120 bytes
  const photo = new Texture({ width: 10, height: 5 }); // 200 bytes
  const points = new DataTexture(new Uint8Array(64), 4, 4);
  const ground = new ShaderMaterial({ uniforms: { pictures: { value: [photo, null] }, points: { value: points }, scale: { value: 3 } } });
  const layers = part('Layers');
  layers.userData.textures = [photo];
  const world = new Group().add(
    part('Terrain', new Mesh(geometryOf(shared), ground), new Mesh(geometryOf(shared), ground)),
    layers,
    new Mesh(geometryOf(new BufferAttribute(new Float32Array(9), 3)), new MeshBasicMaterial()),
  );
  expect(memoryOf(world)).toEqual({ Terrain: 120 + 2 * 6 + 64, Layers: 200, Marks: 36 + 6 });
});

test('an empty scene takes nothing', () => expect(memoryOf(new Group())).toEqual({}));
