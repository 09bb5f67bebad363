// Whether the rocks of an answer are enough, in words.

import type { AskedAnswer } from '../api/line';
import { counted } from '../units/numbers';

/// Empty: they are. An answer has the rocks whose trajectories are stored: a run of more rocks may store no more of them.
export function enoughText({ enough, run: { stored, rocks } }: Pick<AskedAnswer, 'enough' | 'run'>): string {
  if (enough.text === '' || stored >= rocks) return enough.text;
  return `${enough.text}. Only ${stored.toLocaleString('en')} of ${counted(rocks, 'rock')} have stored trajectories; trajectories = "all" of [output] stores all`;
}
