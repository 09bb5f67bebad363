// Prints the sheet of an answer, by the browser's own dialog, which also saves it as PDF.

import { render } from 'preact';
import { asking, type AskedAnswer } from '../api/line';
import { results } from '../api/results';
import { attempt } from '../state/messages';
import { model } from '../project/model';
import { shown } from '../runs/runs';
import { sheetPng } from '../view/sheet';
import { AnswerSheet } from './AnswerSheet';
import { asked } from './asked';
import './answerSheet.css';

/// What the asked barrier would stop of the rocks that reach it, by its own height and capacity; null: no such barrier is
/// asked.
async function asItStands(run: string): Promise<string | null> {
  const now = asked.peek();
  const barrier = now?.kind === 'barrier' ? model.peek()?.barriers.find(({ name }) => name === now.name) : undefined;
  if (!barrier || barrier.kind === 'collector' || barrier.capacity_kJ === null) return null;
  const found = await asking.ask(run, { barrier: barrier.name, height_m: barrier.height_m, energy_kJ: barrier.capacity_kJ });
  return found.kind === 'polygon' ? null : (found.kit?.text ?? null);
}

let last: (() => void) | null = null;

export const printAnswer = (of: AskedAnswer) =>
  attempt('the sheet', async () => {
    last?.();
    const run = shown.peek()!.id;
    const [png, summary, own] = await Promise.all([sheetPng(), results.summary(run), asItStands(run)]);
    const picture = png && URL.createObjectURL(png);
    const host = Object.assign(document.createElement('div'), { className: 'answer-sheet' });
    const end = (last = () => {
      last = null;
      if (picture) URL.revokeObjectURL(picture);
      render(null, host);
      host.remove();
    });
    document.body.append(host);
    render(<AnswerSheet of={of} summary={summary} asItStands={own} picture={picture} />, host);
    await host.querySelector('img')?.decode();
    addEventListener('afterprint', end, { once: true });
    print();
  });
