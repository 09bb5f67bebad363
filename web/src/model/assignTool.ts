// A material for what is clicked: segments of a section, triangles of a mesh; or for an area that is drawn on plan.

import { getArrays, getJson } from '../api/client';
import type { Model } from '../api/types';
import { useTool } from '../scene/tool';
import { edit, opening, valueAt } from '../state/document';
import { model } from '../state/model';
import { shading } from '../view/settings';
import { draw } from './drawing';
import { materialsWith } from './groundWays';
import { onPlan } from './geometryTools';
import { asNow, freshName, nameOf, tableAt } from './place';
import { materialNames } from './form/references';

interface Facets {
  /// The number of each drawn triangle or segment as the project counts them; of an extruded section, that of its segment.
  parts: Uint32Array;
  /// How many the project counts.
  count: number;
}

async function facetsOf({ id }: Model): Promise<Facets> {
  const { header, arrays } = await getArrays<{ parts: number }>(`/api/models/${id}/mesh`);
  return { parts: arrays.parts as Uint32Array, count: header.parts };
}

async function segmentsOf({ id }: Model): Promise<Facets> {
  const { segments } = await getJson<{ segments: number[] }>(`/api/models/${id}/profile`);
  return { parts: Uint32Array.from(segments), count: segments.length };
}

const standardMaterial = () => {
  const { default: name } = tableAt(['ground']);
  return Math.max(0, materialNames().indexOf(String(name ?? '')));
};

function takeTriangle(triangle: number, count: number, material: number, what: string) {
  const list = materialsWith(valueAt(['ground', 'triangles']), count, triangle, material, standardMaterial());
  edit(what, [{ set: ['ground', 'triangles'], value: list }]);
}

function takeSegment(segment: number, count: number, material: string) {
  const list = materialsWith(valueAt(['ground', 'segments']), count, segment, material, nameOf('material', standardMaterial()));
  edit(`make segment ${segment + 1} ${material}`, [{ set: ['ground', 'segments'], value: list }]);
}

/// Clicks give the material to segments or triangles, until the tool is left.
export async function assignByClicks(material: number) {
  const now = model.value;
  if (!now) return;
  const name = nameOf('material', material);
  const [asked, isPossible] = [opening.value, asNow('material')];
  const hasSegments = Array.isArray(tableAt(['terrain']).section);
  const facets = now.dimension === 3 ? await facetsOf(now) : await segmentsOf(now);
  if (opening.value !== asked || !isPossible()) return;
  shading.value = 'material';
  useTool({
    name,
    isPossible,
    hint: () => `Click ${hasSegments ? 'segments' : 'triangles'} that are ${name}. Escape leaves.`,
    click({ facet }) {
      if (facet === undefined) return;
      const part = facets.parts[facet]!;
      if (hasSegments) takeSegment(part, facets.count, name);
      else takeTriangle(part, facets.count, material, `make triangle ${part} ${name}`);
    },
  });
}

/// An area of the ground, drawn on plan, that is of the material.
export function paintArea(material: number) {
  const name = nameOf('material', material);
  shading.value = 'material';
  draw({
    name,
    kind: 'polygon',
    least: 3,
    hint: `Click round the ground that is ${name}.`,
    isPossible: asNow('material'),
    done: (ring) => {
      const value = { name: freshName(['area'], 'Area'), material: name, polygon: ring.map(onPlan) };
      edit(`make an area ${name}`, [{ append: ['area'], value }]);
    },
  });
}
