// Files that are to be kept under a name that another one has: what is to become of them.

import { signal } from '@preact/signals';

export type Replacing = 'replace' | 'take what is there' | 'neither';

export interface Question {
  /// Of this question: several may be about one name.
  id: number;
  name: string;
  answer: (what: Replacing) => void;
}

/// Those that wait for an answer; the first is asked first.
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
