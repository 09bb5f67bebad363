// The maps of a run as the page lists them: those of one quantity and source together.

import type { RunMap } from '../api/types';

export interface MapGroup {
  /// Of the quantity, or "Counts".
  title: string;
  unit: string;
  source: string | null;
  /// `part`: what of the quantity, or which count.
  maps: { map: RunMap; part: string }[];
}

export const capital = (text: string) => `${text.charAt(0).toUpperCase()}${text.slice(1)}`;

/// The quantities that a design needs come first, then the others in the order of their first maps.
const first = ['bounce height', 'total kinetic energy', 'translational kinetic energy', 'velocity'];
const rankOf = ({ title }: MapGroup) => {
  const rank = first.findIndex((each) => title.toLowerCase().startsWith(each));
  return rank < 0 ? first.length : rank;
};

/// A meaning is "quantity: part", or a count.
export function mapGroups(maps: readonly RunMap[]): MapGroup[] {
  const groups: MapGroup[] = [];
  for (const map of maps) {
    const [, quantity, ofQuantity] = /^(.*?): (.*)$/.exec(map.meaning) ?? [];
    const title = quantity === undefined ? 'Counts' : capital(quantity);
    let group = groups.find((each) => each.title === title && each.source === map.source);
    if (!group) groups.push((group = { title, unit: quantity === undefined ? '' : map.unit, source: map.source, maps: [] }));
    group.maps.push({ map, part: ofQuantity ?? map.meaning });
  }
  return groups.sort((one, other) => rankOf(one) - rankOf(other));
}
