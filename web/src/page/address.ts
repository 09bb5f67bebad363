// Places in the workbench as text after the # of the page's address: "#/tutorial-1/slope.toml?panel=runs&tab=rock&rock=12".

import { pathOf, type Path } from '../settings/names';
import { resultsTabs, sidePanels, type ResultsTab, type SidePanel } from '../state/panels';

export interface Place {
  /// The open project; null: the start page.
  file: string | null;
  verifying: boolean;
  chosen: Path | null;
  sidePanel: SidePanel;
  resultsTab: ResultsTab;
  /// The shown run, and the one compared with it.
  run: string | null;
  compared: string | null;
  rock: number | null;
  /// The map that is draped over the terrain.
  map: string | null;
  /// What is asked (askLine/shape.ts), empty if that is nothing yet; null: the card is closed.
  asked: string | null;
  /// What the view shows (view/camera.ts); null: all of the model.
  camera: string | null;
}

const verification = '#verification';
const nothing = 'nothing'; // an open card without a line

/// Without the escapes that the part of an address after # does not need.
const readable = (text: string) => encodeURIComponent(text).replace(/%2F/g, '/').replace(/%2C/g, ',');

/// The address, which is empty for the start page.
export function addressOf(place: Place): string {
  if (place.file === null) return place.verifying ? verification : '';
  const parts: [string, string | number | null][] = [
    ['panel', place.sidePanel],
    ['form', place.chosen?.join('.') ?? null],
    ['tab', place.resultsTab],
    ['run', place.run],
    ['with', place.compared],
    ['rock', place.rock],
    ['map', place.map],
    ['ask', place.asked === '' ? nothing : place.asked],
    ['view', place.camera],
  ];
  const given = parts.flatMap(([key, value]) => (value === null ? [] : [`${key}=${readable(String(value))}`]));
  return `#/${readable(place.file)}?${given.join('&')}`;
}

function decoded(text: string): string | null {
  try {
    return decodeURIComponent(text);
  } catch {
    return null; // typed by hand, with a % that escapes nothing
  }
}

/// The place of an address. Parts that cannot be read are left out; without a panel or tab, `now` has them.
export function placeOf(address: string, now: Pick<Place, 'sidePanel' | 'resultsTab'>): Place {
  const start: Place = { ...now, file: null, verifying: address === verification, chosen: null, run: null, compared: null, rock: null, map: null, asked: null, camera: null };
  const [, name = '', query = ''] = /^#\/([^?]*)\??(.*)$/.exec(address) ?? [];
  const file = decoded(name);
  if (!file) return start;
  const given = new Map(
    query.split('&').flatMap((part): [string, string][] => {
      const [key = '', value = ''] = part.split('=');
      const text = decoded(value);
      return text ? [[key, text]] : [];
    }),
  );
  const oneOf = <T extends string>(list: readonly T[], key: string) => list.find((each) => each === given.get(key));
  const form = given.get('form');
  const rock = given.get('rock');
  return {
    ...start,
    file,
    sidePanel: oneOf(sidePanels, 'panel') ?? now.sidePanel,
    resultsTab: oneOf(resultsTabs, 'tab') ?? now.resultsTab,
    chosen: form ? pathOf(form) : null,
    run: given.get('run') ?? null,
    compared: given.get('with') ?? null,
    rock: rock && /^\d{1,15}$/.test(rock) ? Number(rock) : null,
    map: given.get('map') ?? null,
    asked: given.get('ask') === nothing ? '' : (given.get('ask') ?? null),
    camera: given.get('view') ?? null,
  };
}

const differ = <T>(a: T | null, b: T | null) => a !== null && b !== null && a !== b;

/// Whether going from one place to another is a step of the browser's history. The first run, rock or map to be shown is
/// no step of its own, nor is a movement of the view.
export function isStep(from: Place, to: Place): boolean {
  if (from.file !== to.file) return true;
  if (to.file === null) return from.verifying !== to.verifying;
  return (
    from.chosen?.join('.') !== to.chosen?.join('.') ||
    from.sidePanel !== to.sidePanel ||
    from.resultsTab !== to.resultsTab ||
    (from.asked === null) !== (to.asked === null) ||
    differ(from.run, to.run) ||
    differ(from.compared, to.compared) ||
    differ(from.rock, to.rock) ||
    differ(from.map, to.map)
  );
}
