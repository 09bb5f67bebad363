// The ground under trajectories that are projected onto one section. Each ran over other ground, so at a distance along
// the section there is a range of it, from the lowest to the highest.

/// A place of a rock with the elevation of the ground below it; `u` is the distance along the section.
export interface Over {
  u: number;
  x: number;
  y: number;
  ground: number;
}
/// A stretch of the band: elevations at distances along the section.
export interface Edges {
  u: number[];
  low: number[];
  high: number[];
}
export interface Stations {
  from: number;
  step: number;
  count: number;
}
/// The ground at a place of a rock; null: none is known.
export type GroundAt = (x: number, y: number) => number | null;

/// A place on a rock's way, and how it goes on.
interface Step {
  state: string;
  time: number;
  x: number;
  y: number;
  z: number;
  vz: number;
}
type OnWay = Pick<Step, 'x' | 'y' | 'z'>;

const between = (a: number, b: number, part: number) => a + (b - a) * part;

/// Places along a rock's way, at most `spacing` apart on plan; in a flight on its parabola.
export function placesOn(rows: readonly Step[], spacing: number): OnWay[] {
  return rows.flatMap((row, k): OnWay[] => {
    const from = rows[k - 1];
    if (!from) return [row];
    const pieces = Math.max(1, Math.ceil(Math.hypot(row.x - from.x, row.y - from.y) / spacing));
    const rise = from.state === 'projectile' ? from.vz * (row.time - from.time) : row.z - from.z;
    return Array.from({ length: pieces }, (_, i) => {
      const part = (i + 1) / pieces;
      const z = from.z + rise * part + (row.z - from.z - rise) * part ** 2;
      return { x: between(from.x, row.x, part), y: between(from.y, row.y, part), z };
    });
  });
}

/// The ground below places of a rock. A relief is coarser than the terrain: where it lies above the rock, the ground is
/// taken to be at the rock.
export function groundBelow(places: readonly OnWay[], groundAt: GroundAt, along: (place: OnWay) => number): Over[] {
  return places.flatMap((place): Over[] => {
    const ground = groundAt(place.x, place.y);
    return ground === null ? [] : [{ u: along(place), x: place.x, y: place.y, ground: Math.min(ground, place.z) }];
  });
}

// What is known at a station: the range of the ground, and a place on its lower end.
interface Node {
  low: Over;
  high: number;
}
type Nodes = (Node | undefined)[];

function widen(nodes: Nodes, k: number, over: Over) {
  const node = nodes[k];
  if (!node) nodes[k] = { low: over, high: over.ground };
  else {
    if (over.ground < node.low.ground) node.low = over;
    node.high = Math.max(node.high, over.ground);
  }
}

// The ground where a way passes stations; its ends count for the station beyond them.
function passStations(nodes: Nodes, way: readonly Over[], at: (over: Over) => number) {
  way.forEach((b, i) => {
    const a = way[i - 1] ?? b;
    const [from, to] = at(a) <= at(b) ? [a, b] : [b, a];
    for (let k = Math.ceil(at(from)); k <= at(to); ++k) {
      const part = at(to) > at(from) ? (k - at(from)) / (at(to) - at(from)) : 0;
      const of = (key: keyof Over) => between(from[key], to[key], part);
      widen(nodes, k, { u: of('u'), x: of('x'), y: of('y'), ground: of('ground') });
    }
  });
  const byPlace = [...way].sort((a, b) => a.u - b.u);
  const [first, last] = [byPlace[0], byPlace.at(-1)];
  if (first && last) {
    widen(nodes, Math.floor(at(first)), first);
    widen(nodes, Math.ceil(at(last)), last);
  }
}

// Raises the upper edge so that it passes no lower than `ground` at `part` of the way from `a` to `b`: as little as
// possible, and no end above `ground`.
function raise(a: number, b: number, part: number, ground: number): [number, number] {
  const missing = ground - between(a, b, part);
  if (missing <= 0) return [a, b];
  const nearA = part < 0.5;
  const near = Math.max(nearA ? a : b, Math.min((nearA ? a : b) + missing / (nearA ? 1 - part : part), ground));
  const other = nearA ? b : a;
  const isEnough = (nearA ? between(near, other, part) : between(other, near, part)) >= ground - 1e-9;
  const far = isEnough ? other : Math.max(other, ground);
  return nearA ? [near, far] : [far, near];
}

// Both edges between two stations contain the ground of every place there; `at` counts stations.
function contain({ low, high }: Edges, { ground }: Over, at: number) {
  const k = Math.floor(at);
  const part = at - k;
  const next = part > 0 ? k + 1 : k;
  [high[k], high[next]] = raise(high[k]!, high[next]!, part, ground);
  const [first, second] = raise(-low[k]!, -low[next]!, part, -ground);
  [low[k], low[next]] = [-first, -second];
}

// Ground where no trajectory is: straight on plan from one to the next, and along the section beyond the last.
function bridge(nodes: Nodes, { from, step, count }: Stations, groundAt: GroundAt, direction: readonly [number, number]): (number | null)[] {
  const known = nodes.flatMap((node, k) => (node && k < count ? [k] : []));
  return Array.from({ length: count }, (_, k) => {
    const [left, right] = [known.filter((each) => each < k).at(-1), known.find((each) => each > k)];
    const [a, b] = [left === undefined ? undefined : nodes[left]?.low, right === undefined ? undefined : nodes[right]?.low];
    const u = from + k * step;
    if (a && b) {
      const part = (k - left!) / (right! - left!);
      return groundAt(between(a.x, b.x, part), between(a.y, b.y, part));
    }
    const end = a ?? b;
    return end ? groundAt(end.x + (u - end.u) * direction[0], end.y + (u - end.u) * direction[1]) : null;
  });
}

const nearStations = 8;
const stationsNear = (values: readonly number[], k: number) => values.slice(Math.max(0, k - nearStations), k + nearStations + 1);

// Joins the tips of an upper edge by straight lines, as far as the band is as wide nearby: a rock that lies alone would
// be on a spike of ground.
function joined(edge: readonly number[], widths: readonly number[]): number[] {
  return edge.map((own, k) => {
    let highest = own;
    for (let i = Math.max(0, k - nearStations); i < k; ++i) {
      for (let j = k + 1; j <= Math.min(k + nearStations, edge.length - 1); ++j)
        highest = Math.max(highest, between(edge[i]!, edge[j]!, (k - i) / (j - i)));
    }
    return Math.min(highest, own + Math.max(...stationsNear(widths, k)) - widths[k]!);
  });
}

function smooth({ u, low, high }: Edges): Edges {
  const widths = high.map((above, k) => above - low[k]!);
  return { u, low: joined(low.map((z) => -z), widths).map((z) => -z), high: joined(high, widths) };
}

/// The band of the ground under ways, in stretches without holes: it passes no higher than the lowest and no lower than
/// the highest ground under them. Between and beyond them it is the ground there, without width.
export function bandUnder(ways: readonly (readonly Over[])[], stations: Stations, groundAt: GroundAt, direction: readonly [number, number]): Edges[] {
  const { from, step, count } = stations;
  const at = ({ u }: Over) => Math.min(Math.max((u - from) / step, 0), count - 1);
  const nodes: Nodes = Array.from({ length: count });
  for (const way of ways) passStations(nodes, way, at);
  const stretches: { first: number; edges: Edges }[] = [];
  bridge(nodes, stations, groundAt, direction).forEach((bare, k) => {
    const [below, above] = [nodes[k]?.low.ground ?? bare, nodes[k]?.high ?? bare];
    if (below === null || above === null) return;
    let last = stretches.at(-1);
    if (!last || last.first + last.edges.u.length < k) stretches.push((last = { first: k, edges: { u: [], low: [], high: [] } }));
    last.edges.u.push(from + k * step);
    last.edges.low.push(below);
    last.edges.high.push(above);
  });
  for (const over of ways.flat()) {
    const own = stretches.find(({ first, edges }) => at(over) >= first && at(over) <= first + edges.u.length - 1);
    if (own) contain(own.edges, over, at(over) - own.first);
  }
  return stretches.map(({ edges }) => smooth(edges));
}
