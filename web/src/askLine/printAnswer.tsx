// Prints the sheet of an answer, by the browser's own dialog, which also saves it as PDF.

import { render } from 'preact';
import type { AskedAnswer } from '../api/line';
import { attempt } from '../state/messages';
import { sheetPng } from '../view/sheet';
import { AnswerSheet } from './AnswerSheet';
import './answerSheet.css';

let last: (() => void) | null = null;

export const printAnswer = (of: AskedAnswer) =>
  attempt('the sheet', async () => {
    last?.();
    const png = await sheetPng();
    const picture = png && URL.createObjectURL(png);
    const host = Object.assign(document.createElement('div'), { className: 'answer-sheet' });
    const end = (last = () => {
      last = null;
      if (picture) URL.revokeObjectURL(picture);
      render(null, host);
      host.remove();
    });
    document.body.append(host);
    render(<AnswerSheet of={of} picture={picture} />, host);
    await host.querySelector('img')?.decode();
    addEventListener('afterprint', end, { once: true });
    print();
  });
