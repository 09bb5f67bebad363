// The triangles that the engine makes of closed polylines, on plan, and its report of the merge.

import { useEffect, useState } from 'preact/hooks';
import { api } from '../../api/client';
import type { PolygonsAnswer } from '../../api/types';
import type { TomlValue } from '../../toml/format';
import { jsonText } from '../../toml/json';
import { valueAt } from '../../project/document';
import { counted } from '../../units/numbers';
import { tableAt } from '../../project/place';

const size = 200;

export function PolygonPreview({ polylines }: { polylines: TomlValue[] }) {
  const [answer, setAnswer] = useState<PolygonsAnswer | null>(null);
  const tolerance = valueAt(['terrain', 'merge_tolerance_m']);
  const asked = jsonText({ polylines, tolerance_m: typeof tolerance === 'number' ? tolerance : 0.001 });
  useEffect(() => {
    const own = new AbortController();
    const timer = setTimeout(() => {
      void api
        .polygons(JSON.parse(asked) as { polylines: unknown; tolerance_m: number }, own.signal)
        .then(setAnswer)
        // Problems are reported at the field.
        .catch(() => !own.signal.aborted && setAnswer(null));
    }, 300);
    return () => {
      clearTimeout(timer);
      own.abort();
    };
  }, [asked]);
  if (!answer || answer.triangles.length === 0) return null;
  const { vertices, triangles, report } = answer;
  const xs = vertices.map(([x]) => x);
  const ys = vertices.map(([, y]) => y);
  const [left, top] = [Math.min(...xs), Math.max(...ys)];
  const scale = (size - 10) / Math.max(Math.max(...xs) - left, top - Math.min(...ys), 1e-9);
  const at = (k: number) =>
    `${(5 + (vertices[k]![0] - left) * scale).toFixed(1)},${(5 + (top - vertices[k]![1]) * scale).toFixed(1)}`;
  const height = 10 + (top - Math.min(...ys)) * scale;
  const isRotated = tableAt(['terrain']).rotate_deg !== undefined;
  return (
    <figure class="preview">
      <svg
        viewBox={`0 0 ${size} ${Math.max(height, 20)}`}
        role="img"
        aria-label={`Plan of ${counted(triangles.length, 'triangle')}`}
      >
        {triangles.slice(0, 2000).map((corners, k) => (
          <polygon key={k} points={corners.map(at).join(' ')} />
        ))}
      </svg>
      <figcaption>
        {counted(triangles.length, 'triangle')} of {counted(vertices.length, 'vertex', 'vertices')}, on plan
        {isRotated ? ' before rotation' : ''}. {report}
      </figcaption>
    </figure>
  );
}
