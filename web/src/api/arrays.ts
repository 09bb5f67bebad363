// Large responses: a JSON header and typed arrays ("Arrays" in docs/workbench-api.md).

const types = {
  f32: Float32Array,
  f64: Float64Array,
  u8: Uint8Array,
  u16: Uint16Array,
  u32: Uint32Array,
} as const;
type TypeName = keyof typeof types;
export type NumberArray = Float32Array | Float64Array | Uint8Array | Uint16Array | Uint32Array;

export interface Arrays<Header> {
  header: Header;
  arrays: Record<string, NumberArray>;
}

export function readArrays<Header>(bytes: ArrayBuffer): Arrays<Header> {
  const view = new DataView(bytes);
  if (bytes.byteLength < 8 || view.getUint32(0, false) !== 0x54414c41) throw new Error('the response contains no arrays');
  const length = view.getUint32(4, true);
  const text = new TextDecoder().decode(new Uint8Array(bytes, 8, length));
  const header = JSON.parse(text) as Header & { arrays: { name: string; type: TypeName; count: number }[] };
  const arrays: Record<string, NumberArray> = {};
  let offset = 8 + length;
  for (const { name, type, count } of header.arrays) {
    const array = new types[type](bytes, offset, count);
    arrays[name] = array;
    offset += Math.ceil(array.byteLength / 8) * 8;
  }
  return { header, arrays };
}
