// A material for what is clicked: segments of a section, triangles of a mesh; or the triangles within a polygon on plan.

import { getArrays } from '../api/client';
import type { Model, Point3 } from '../api/types';
import { useTool } from '../scene/tool';
import { edit, valueAt } from '../state/document';
import { sayFailure } from '../state/messages';
import { model } from '../state/model';
import { shading } from '../view/settings';
import { draw } from './drawing';
import { segmentsWith, trianglesWith } from './groundWays';
import { nameOf, tableAt } from './place';
import { materialNames } from './form/references';

interface Facets {
  /// The number of each drawn triangle as the project counts them.
  sources: Uint32Array;
  /// Its middle on plan.
  middles: [number, number][];
  count: number;
}

async function facetsOf({ id }: Model): Promise<Facets> {
  const { header, arrays } = await getArrays<{ origin: Point3 }>(`/api/models/${id}/mesh`);
  const [positions, triangles] = [arrays.positions!, arrays.triangles!];
  const sources = arrays.sources as Uint32Array;
  const middle = (k: number, axis: number) =>
    [0, 1, 2].reduce((sum, corner) => sum + positions[3 * triangles[3 * k + corner]! + axis]! / 3, 0) +
    header.origin[axis]!;
  return {
    sources,
    middles: Array.from(sources, (_, k) => [middle(k, 0), middle(k, 1)]),
    count: sources.reduce((most, source) => Math.max(most, source), -1) + 1,
  };
}

const standardMaterial = () => {
  const { default: name } = tableAt(['ground']);
  return Math.max(0, materialNames().indexOf(String(name ?? '')));
};

function takeTriangles(facets: Facets, drawn: number[], material: number, what: string) {
  const numbers = drawn.map((k) => facets.sources[k]!);
  const list = trianglesWith(valueAt(['ground', 'triangles']), facets.count, numbers, material, standardMaterial());
  edit(what, [{ set: ['ground', 'triangles'], value: list }]);
}

/// Clicks give the material to segments or triangles, until the tool is left.
export async function assignByClicks(material: number) {
  const now = model.value;
  if (!now) return;
  const name = nameOf('material', material);
  const facets = now.dimension === 3 ? await facetsOf(now) : null;
  shading.value = 'material';
  useTool({
    name,
    hint: () => `Click ${facets ? 'triangles' : 'segments'} that are ${name}. Escape leaves.`,
    click({ facet }) {
      if (facet === undefined) return;
      if (facets) return takeTriangles(facets, [facet], material, `make triangle ${facets.sources[facet]} ${name}`);
      const { section } = tableAt(['terrain']);
      const count = Array.isArray(section) ? section.length - 1 : 0;
      const standard = nameOf('material', standardMaterial());
      edit(`make segment ${facet + 1} ${name}`, [
        {
          set: ['ground', 'segments'],
          value: segmentsWith(valueAt(['ground', 'segments']), count, facet, name, standard),
        },
      ]);
    },
  });
}

/// Whether a point lies within a closed line on plan: a ray to the east crosses it an odd number of times.
export function isWithin([x, y]: readonly [number, number], ring: readonly Point3[]): boolean {
  return ring.reduce((inside, [ax, ay], k) => {
    const [bx, by] = ring[(k + 1) % ring.length]!;
    return ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax) ? !inside : inside;
  }, false);
}

/// The triangles of a mesh whose middle is within a polygon that is drawn.
export function assignByPolygon(material: number) {
  const now = model.value;
  if (!now) return;
  const name = nameOf('material', material);
  shading.value = 'material';
  draw({
    name,
    kind: 'polygon',
    least: 3,
    hint: `Click round the ground that is ${name}.`,
    done: (ring) => {
      const take = async () => {
        const facets = await facetsOf(now);
        const drawn = facets.middles.flatMap((middle, k) => (isWithin(middle, ring) ? [k] : []));
        takeTriangles(facets, drawn, material, `make ${drawn.length} triangles ${name}`);
      };
      void take().catch(sayFailure);
    },
  });
}
