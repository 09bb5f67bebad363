import { LayerList } from './LayerList';
import { dimension } from '../project/place';
import { MemoryNote } from '../view/MemoryNote';
import { Popover } from '../ui/Popover';
import { layerNames, layers, showLayer, type LayerName } from '../view/settings';

/// The layers of the model and of the run that a view shows. `memory`: of its parts.
export function LayerChoices({ memory }: { memory: () => Record<string, number> }) {
  return (
    <Popover title="Layers">
      {(Object.keys(layers) as LayerName[]).map((name) => (
        <label key={name}>
          <input type="checkbox" checked={layers[name].value} onChange={(event) => showLayer(name, event.currentTarget.checked)} />
          {layerNames[name]}
        </label>
      ))}
      {dimension.value === 3 && <LayerList />}
      <MemoryNote parts={memory} />
    </Popover>
  );
}
