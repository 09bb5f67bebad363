// Questions about uploaded files whose names exist already.

import { signal } from '@preact/signals';

export type Replacing = 'replace' | 'use the existing file' | 'cancel';

export interface Question {
  /// Unique: several questions may be about one name.
  id: number;
  name: string;
  answer: (what: Replacing) => void;
}

/// Open questions; the first is asked first.
export const questions = signal<Question[]>([]);

let asked = 0;

export function askToReplace(name: string): Promise<Replacing> {
  return new Promise((resolve) => {
    const question: Question = {
      id: ++asked,
      name,
      answer: (what) => {
        questions.value = questions.value.filter((other) => other !== question);
        resolve(what);
      },
    };
    questions.value = [...questions.value, question];
  });
}
