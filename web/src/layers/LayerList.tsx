// The reference layers in the menu Layers of the view: on and off, opacity, order, and what is wrong with their files.

import { edit, rowsOf } from '../project/document';
import { openForm } from '../project/chosen';
import { showPanel } from '../state/panels';
import { add } from '../project/things';
import { mostDraped } from './draped';
import { changeLayer, isDrawn, projectLayers, type Layer } from './layers';
import './layers.css';

/// Later entries are drawn over earlier ones.
function bringToTop({ index, name }: Layer) {
  const row = rowsOf('layer')[index];
  if (row) edit(`draw ${name} on top`, [{ remove: ['layer', index] }, { append: ['layer'], value: row }]);
}

const open = (index: number) => openForm(['layer', index]);

function LayerItem({ layer, isTop }: { layer: Layer; isTop: boolean }) {
  const { name, visible, opacity, found, problems, index } = layer;
  return (
    <li>
      <label>
        <input type="checkbox" checked={visible} onChange={(event) => changeLayer(name, { visible: event.currentTarget.checked })} />
        <span class="name">{name}</span>
      </label>
      <input
        type="range"
        aria-label={`Opacity of ${name}`}
        title="Opacity"
        min={0}
        max={1}
        step={0.05}
        value={opacity}
        disabled={!visible}
        onInput={(event) => changeLayer(name, { opacity: Number(event.currentTarget.value) })}
      />
      <button class="button plain icon" aria-label={`Draw ${name} on top`} title="Draw on top of the others" disabled={isTop} onClick={() => bringToTop(layer)}>
        ↑
      </button>
      <button class="button plain icon" aria-label={`Settings of ${name}`} title="Settings" onClick={() => open(index)}>
        ✎
      </button>
      {!found && problems.length === 0 && <p class="faint">Reading…</p>}
      {problems.map(({ text, severity }) => (
        <p key={text} class={`problem ${severity}`}>
          {text}
        </p>
      ))}
    </li>
  );
}

export function LayerList() {
  const list = projectLayers.value;
  return (
    <fieldset class="layer-list">
      <legend>Reference layers</legend>
      {list.length === 0 && <p class="faint">An orthophoto, roads, buildings: drop a file on the view, or add it here.</p>}
      <ul>
        {list.toReversed().map((layer) => (
          <LayerItem key={layer.name} layer={layer} isTop={layer.index === list.length - 1} />
        ))}
      </ul>
      {list.filter((layer) => isDrawn(layer) && layer.found?.kind === 'raster').length > mostDraped && <p class="faint">Only the upper {mostDraped} pictures are drawn.</p>}
      <button
        class="button plain"
        onClick={() => {
          add('layer');
          showPanel('model');
        }}
      >
        + Add a layer
      </button>
    </fieldset>
  );
}
