// The view of a 3D model with its controls.

import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { model } from '../project/model';
import { reportFailure } from '../state/messages';
import type { OpenScene } from './open';
import * as picture from './picture';
import { Compass } from './Compass';
import { SceneBar } from './SceneBar';
import { SceneLegend } from './SceneLegend';
import { StatusLine } from './StatusLine';
import './scene.css';

export function SceneView() {
  const host = useRef<HTMLDivElement>(null);
  const open = useSignal<OpenScene | null>(null);
  useEffect(() => {
    let gone = false;
    picture.setFailure(null);
    import('./open').then(({ openScene }) => {
      if (gone) return;
      try {
        open.value = openScene(host.current!);
      } catch {
        picture.setFailure('This browser does not provide 3D graphics (WebGL 2). Turn on hardware acceleration in its settings, or use another browser. Everything else works without it.');
      }
    }, reportFailure);
    return () => {
      gone = true;
      open.value?.dispose();
      open.value = null;
    };
  }, []);
  return (
    <div class="scene">
      <div class="canvas" ref={host} />
      {picture.failure.value !== null && (
        <div class="empty cover" role="alert">
          {picture.failure.value}
        </div>
      )}
      {!model.value && picture.failure.value === null && <div class="empty cover">There is no model to show yet.</div>}
      {picture.isLoading.value && <div class="loading" role="status">Loading the terrain…</div>}
      {open.value && model.value && picture.failure.value === null && (
        <>
          <SceneBar open={open.value} />
          <Compass open={open.value} />
          <SceneLegend />
          <StatusLine />
        </>
      )}
    </div>
  );
}
