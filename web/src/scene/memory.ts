// How much memory the data of a scene take: geometry and pictures as the graphics hold them.

import { BufferGeometry, Material, ShaderMaterial, Texture, type Object3D } from 'three';

/// Bytes by the name of a part; a part without a name is one of the marks.
export type SceneMemory = Record<string, number>;

type Data = ArrayBufferLike | object;

/// Adds what was not counted before.
class Count {
  private readonly seen = new Set<Data>();
  bytes = 0;

  private add(data: Data, bytes: number) {
    if (this.seen.has(data)) return;
    this.seen.add(data);
    this.bytes += bytes;
  }

  geometry(of: BufferGeometry) {
    for (const attribute of [...Object.values(of.attributes), of.index]) {
      const array = attribute && ('data' in attribute ? attribute.data.array : attribute.array);
      if (array) this.add(array, array.byteLength);
    }
  }

  texture({ image }: Texture) {
    const { data, width = 0, height = 0 } = (image ?? {}) as { data?: ArrayBufferView | null; width?: number; height?: number };
    if (image) this.add(image as object, data ? data.byteLength : 4 * width * height);
  }

  material(of: Material) {
    const values = of instanceof ShaderMaterial ? Object.values(of.uniforms).map(({ value }) => value as unknown) : Object.values(of);
    for (const value of values.flat()) if (value instanceof Texture) this.texture(value);
  }
}

/// Of the parts of a scene, the children of `world`. A part may name textures that another draws, in userData.textures.
export function memoryOf(world: Object3D): SceneMemory {
  const memory: SceneMemory = {};
  const count = new Count();
  const add = (part: Object3D, what: () => void) => {
    const before = count.bytes;
    what();
    const name = part.name || 'Marks';
    memory[name] = (memory[name] ?? 0) + count.bytes - before;
  };
  // Textures first, so that they belong to the part that names them.
  for (const part of world.children) add(part, () => part.traverse(({ userData }) => ((userData.textures ?? []) as Texture[]).forEach((each) => count.texture(each))));
  for (const part of world.children)
    add(part, () =>
      part.traverse((object) => {
        const { geometry, material = [] } = object as Object3D & { geometry?: BufferGeometry; material?: Material | Material[] };
        if (geometry instanceof BufferGeometry) count.geometry(geometry);
        for (const each of [material].flat()) count.material(each);
      }),
    );
  return memory;
}
