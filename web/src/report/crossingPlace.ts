// Where trajectories cross a line on plan.

interface OnPlan {
  x: number;
  y: number;
}

// Where the way from a to b meets the line from p to q, as a share of that line; null: nowhere.
function shareAt(a: OnPlan, b: OnPlan, p: OnPlan, q: OnPlan): number | null {
  const [dx, dy, ex, ey] = [b.x - a.x, b.y - a.y, q.x - p.x, q.y - p.y];
  const area = dx * ey - dy * ex;
  if (area === 0) return null;
  const way = ((p.x - a.x) * ey - (p.y - a.y) * ex) / area;
  const share = ((p.x - a.x) * dy - (p.y - a.y) * dx) / area;
  return way >= 0 && way <= 1 && share >= 0 && share <= 1 ? share : null;
}

const along = (p: OnPlan, q: OnPlan, share: number): OnPlan => ({ x: p.x + share * (q.x - p.x), y: p.y + share * (q.y - p.y) });

/// The middle one, along the line, of the places where ways first cross it; the middle of the line if none does.
export function crossingPlace(line: readonly (readonly [number, number])[], ways: readonly (readonly OnPlan[])[]): OnPlan {
  const points = line.map(([x, y]) => ({ x, y }));
  const pieces = points.slice(1).map((q, k) => [points[k]!, q] as const);
  const first = (way: readonly OnPlan[]): number | null => {
    for (const [k, b] of way.entries()) {
      const a = way[k - 1];
      for (const [i, [p, q]] of a ? pieces.entries() : []) {
        const share = shareAt(a!, b, p, q);
        if (share !== null) return i + share;
      }
    }
    return null;
  };
  const crossed = ways.flatMap((way) => first(way) ?? []).sort((a, b) => a - b);
  const place = crossed[crossed.length >> 1] ?? pieces.length / 2;
  const piece = Math.max(0, Math.min(Math.floor(place), pieces.length - 1));
  const [p, q] = pieces[piece] ?? [points[0]!, points[0]!];
  return along(p, q, place - piece);
}
