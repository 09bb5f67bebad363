// Assigns a material to clicked segments or triangles, or to an area drawn on plan.

import { getArrays, getJson } from '../api/client';
import type { Model } from '../api/types';
import { useTool } from './tool';
import { edit, opening, valueAt } from '../project/document';
import { model } from '../project/model';
import { setShading } from '../view/settings';
import { draw } from './drawing';
import { materialsWith } from '../settings/groundWays';
import { onPlan } from './geometryTools';
import { entriesUnchanged, freshName, nameOf, tableAt, materialNames } from '../project/place';

interface Facets {
  /// For each drawn triangle or segment its index in the project; for an extruded section the index of its segment.
  parts: Uint32Array;
  /// The number of triangles or segments in the project.
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
  edit(`assign ${material} to segment ${segment + 1}`, [{ set: ['ground', 'segments'], value: list }]);
}

/// Assigns the material to each clicked segment or triangle, until the tool is closed.
export async function assignByClicks(material: number) {
  const now = model.value;
  if (!now) return;
  const name = nameOf('material', material);
  const [asked, isPossible] = [opening.value, entriesUnchanged('material')];
  const hasSegments = Array.isArray(tableAt(['terrain']).section);
  const facets = now.dimension === 3 ? await facetsOf(now) : await segmentsOf(now);
  if (opening.value !== asked || !isPossible()) return;
  setShading('material');
  useTool({
    name,
    isPossible,
    hint: () => `Click the ${hasSegments ? 'segments' : 'triangles'} of ${name}. Escape ends.`,
    click({ facet }) {
      if (facet === undefined) return;
      const part = facets.parts[facet]!;
      if (hasSegments) takeSegment(part, facets.count, name);
      else takeTriangle(part, facets.count, material, `assign ${name} to triangle ${part}`);
    },
  });
}

/// Draws an area of the material on plan.
export function paintArea(material: number) {
  const name = nameOf('material', material);
  setShading('material');
  draw({
    name,
    kind: 'polygon',
    least: 3,
    hint: `Click around the area of ${name}.`,
    isPossible: entriesUnchanged('material'),
    done: (ring) => {
      const value = { name: freshName(['area'], 'Area'), material: name, polygon: ring.map(onPlan) };
      edit(`draw an area of ${name}`, [{ append: ['area'], value }]);
    },
  });
}
