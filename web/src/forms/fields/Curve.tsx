// The probability density of a random property, computed by the engine.

import { useEffect, useState } from 'preact/hooks';
import { api } from '../../api/client';
import type { Path } from '../../settings/names';
import type { TomlTable } from '../../toml/format';
import { jsonText } from '../../toml/json';
import { numberText } from '../../units/numbers';

interface Props {
  distribution: TomlTable;
  path: Path;
  unit: string;
  title: string;
}

const width = 300;
const height = 64;

export function Curve({ distribution, path, unit, title }: Props) {
  const [density, setDensity] = useState<[number, number][]>([]);
  const key = String(path.at(-1));
  const asked = jsonText(distribution);
  useEffect(() => {
    // Parts that are not numbers are reported at their fields.
    if (
      Object.entries(JSON.parse(asked) as TomlTable).some(
        ([part, value]) => part !== 'distribution' && typeof value !== 'number',
      )
    )
      return setDensity([]);
    const own = new AbortController();
    const timer = setTimeout(() => {
      void api
        .distribution(key, JSON.parse(asked) as TomlTable, own.signal)
        .then((answer) => setDensity(answer.density))
        // Problems are reported at the fields.
        .catch(() => !own.signal.aborted && setDensity([]));
    }, 150);
    return () => {
      clearTimeout(timer);
      own.abort();
    };
  }, [asked, key]);
  if (density.length < 2) return null;
  const [from, to] = [density[0]![0], density.at(-1)![0]];
  const top = Math.max(...density.map(([, y]) => y));
  if (!(to > from) || !(top > 0)) return null;
  const points = density.map(
    ([x, y]) => `${(((x - from) / (to - from)) * width).toFixed(1)},${(height - (y / top) * (height - 4)).toFixed(1)}`,
  );
  return (
    <figure class="curve">
      <svg
        viewBox={`0 0 ${width} ${height}`}
        role="img"
        aria-label={`Density of ${title.toLowerCase()} from ${numberText(from)} to ${numberText(to)} ${unit}`}
        preserveAspectRatio="none"
      >
        <polygon points={`0,${height} ${points.join(' ')} ${width},${height}`} />
        <polyline points={points.join(' ')} />
      </svg>
      <figcaption class="faint">
        <span>{numberText(from)}</span>
        <span>
          {numberText(to)} {unit}
        </span>
      </figcaption>
    </figure>
  );
}
