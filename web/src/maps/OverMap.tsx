import { endsOverMap, pathsOverMap } from './over';

/// The choices whether trajectories and end points are drawn over the map.
export function OverMap() {
  return (
    <>
      <label class="choice">
        <input type="checkbox" checked={pathsOverMap.value} onChange={(event) => (pathsOverMap.value = event.currentTarget.checked)} />
        Trajectories over the map
      </label>
      <label class="choice">
        <input type="checkbox" checked={endsOverMap.value} onChange={(event) => (endsOverMap.value = event.currentTarget.checked)} />
        End points over the map
      </label>
    </>
  );
}
