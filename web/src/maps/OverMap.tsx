import { endsOverMap, pathsOverMap, showEndsOverMap, showPathsOverMap } from './over';

/// The choices whether trajectories and end points are drawn over the map.
export function OverMap() {
  return (
    <>
      <label class="choice">
        <input type="checkbox" checked={pathsOverMap.value} onChange={(event) => showPathsOverMap(event.currentTarget.checked)} />
        Trajectories over the map
      </label>
      <label class="choice">
        <input type="checkbox" checked={endsOverMap.value} onChange={(event) => showEndsOverMap(event.currentTarget.checked)} />
        End points over the map
      </label>
    </>
  );
}
