// Prints the sheet of the answers, by the browser's own dialog, which also saves it as PDF.

import { render } from 'preact';
import { asking } from '../api/line';
import type { Asked } from '../askLine/shape';
import { attempt } from '../state/messages';
import { withWhole } from '../paths/playback';
import { model } from '../project/model';
import { shown } from '../runs/runs';
import { sheetPng } from '../view/sheet';
import { AnswerSheet } from './AnswerSheet';
import { doubts } from './doubtsNow';
import { ranges } from './job';
import { lineAnswer } from './lineAnswer';
import { place, summary } from './place';
import './answerSheet.css';

/// What the asked barrier would stop of the rocks that reach it, by its own height and capacity; null: no such barrier is
/// asked.
async function asItStands(run: string, now: Asked): Promise<string | null> {
  const barrier = now.kind === 'barrier' ? model.peek()?.barriers.find(({ name }) => name === now.name) : undefined;
  if (!barrier || barrier.kind === 'collector' || barrier.capacity_kJ === null) return null;
  const found = await asking.ask(run, { barrier: barrier.name, height_m: barrier.height_m, energy_kJ: barrier.capacity_kJ });
  return found.kind === 'polygon' ? null : (found.kit?.text ?? null);
}

let last: (() => void) | null = null;

/// The answers as they are shown now.
export const printAnswer = () =>
  attempt('the sheet', async () => {
    last?.();
    const [run, now, of, summed, moved] = [shown.peek(), place.peek(), lineAnswer.peek().value, summary.peek(), ranges.peek()];
    if (!run || !now || !of || !summed || !moved) return;
    const [png, own] = await Promise.all([withWhole(() => sheetPng(true)), asItStands(run.id, now)]);
    const picture = png && URL.createObjectURL(png);
    const host = Object.assign(document.createElement('div'), { className: 'answer-sheet' });
    const end = (last = () => {
      last = null;
      if (picture) URL.revokeObjectURL(picture);
      render(null, host);
      host.remove();
    });
    document.body.append(host);
    render(<AnswerSheet of={of} now={now} summary={summed} ranges={moved} doubts={doubts.peek()} asItStands={own} picture={picture} />, host);
    await host.querySelector('img')?.decode();
    addEventListener('afterprint', end, { once: true });
    print();
  });
